//! What real files do and Sunflow does not accept, and how it is read all the same.

use scene_format::scene_file::*;
use scene_format::{NoFiles, parse};

use crate::{messages, object, read, shader, statements};

/// Two texts that must mean the same, without any message.
fn assert_same(text: &str, other: &str) {
    assert_eq!(messages(&read(text)), "");
    assert_eq!(messages(&read(other)), "");
    assert_eq!(read(text).scene, read(other).scene);
}

#[test]
fn fields_may_stand_in_any_order() {
    assert_same(
        "object { shader a transform { scaleu 2 } type sphere name b c 1 2 3 r 4 }",
        "object { r 4 c 1 2 3 name b type sphere transform { scaleu 2 } shader a }",
    );
    assert_same("shader { name a type mirror refl 1 1 1 }", "shader { type mirror refl 1 1 1 name a }");
}

#[test]
fn line_ends_of_windows_and_a_byte_order_mark_change_nothing() {
    assert_same("image {\n  aa 0 2\n}\nbucket 32 row", "\u{feff}image {\r\n  aa 0 2\r\n}\r\nbucket 32 row\r\n");
}

#[test]
fn braces_may_be_glued_to_words() {
    assert_same(
        "background { color { \"sRGB nonlinear\" 1 0 0.5 } }",
        "background{ color {\"sRGB nonlinear\" 1 0 0.5}}",
    );
}

#[test]
fn the_quotes_around_a_colour_space_may_be_missing() {
    assert_same("background { color { \"sRGB linear\" 1 2 3 } }", "background { color { sRGB linear 1 2 3 } }");
}

#[test]
fn numbers_take_all_forms_that_java_reads() {
    assert_same(
        "object { shader a type sphere c 1 0.5 -2 r 100 }",
        "object { shader a type sphere c +1.0 .5f -002 r 1e2 }",
    );
}

#[test]
fn a_keyword_may_be_a_name() {
    let shader = shader("shader { name type type mirror refl 1 1 1 }");
    assert_eq!(shader.name.value, "type");
    assert_eq!(crate::shader("shader { name bucket type mirror refl 1 1 1 }").name.value, "bucket");
}

#[test]
fn a_generic_mesh_needs_neither_normals_nor_uvs() {
    let points = "points 3 0 0 0 1 0 0 0 1 0 triangles 1 0 1 2";
    assert_same(
        &format!("object {{ shader a type generic-mesh {points} }}"),
        &format!("object {{ shader a type generic-mesh {points} normals none uvs none }}"),
    );
    let Shape::Mesh(mesh) =
        object(&format!("object {{ shader a type generic-mesh {points} uvs vertex 0 0 1 0 0 1 }}")).shape.value
    else {
        panic!("not a mesh");
    };
    assert_eq!(
        (mesh.normals, mesh.uvs),
        (PerVertex::None, PerVertex::Vertex(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]))
    );
}

#[test]
fn the_old_form_of_a_mesh_is_read_into_the_same_lists() {
    let line = |x: u8| format!("v {x} 0 0 0 0 1 0.5 {x}\n");
    let text = format!("object {{ shader a type mesh name m 3 1\n{}{}{}t 2 1 0 }}", line(0), line(1), line(2));
    let Shape::Mesh(mesh) = object(&text).shape.value else { panic!("not a mesh") };
    assert_eq!(mesh.form, MeshForm::Lines);
    assert_eq!(mesh.points, [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    assert_eq!(mesh.triangles, [[2, 1, 0]]);
    assert_eq!(mesh.normals, PerVertex::Vertex(vec![[0.0, 0.0, 1.0]; 3]));
    assert_eq!(mesh.uvs, PerVertex::Vertex(vec![[0.5, 0.0], [0.5, 1.0], [0.5, 2.0]]));
}

#[test]
fn a_box_and_single_axis_scales_are_known() {
    let object = object("object { type box shader a transform { scalex 1 scaley 2 scalez 3 } }");
    assert_eq!(object.shape.value, Shape::Box);
    let steps = vec![TransformStep::ScaleX(1.0), TransformStep::ScaleY(2.0), TransformStep::ScaleZ(3.0)];
    assert_eq!(object.transform.unwrap().value, Transform::Steps(steps));
}

#[test]
fn the_colour_of_a_constant_shader_needs_no_keyword() {
    assert_same("shader { name a type constant color 1 2 3 }", "shader { name a type constant 1 2 3 }");
}

#[test]
fn a_point_light_may_have_its_old_form() {
    let light = |power: &str| statements(&format!("light {{ type point power {power} p 1 2 3 }}"));
    let point = LightKind::Point { color: Color::Bare([4.0, 5.0, 6.0]), power: None, position: [1.0, 2.0, 3.0] };
    assert_eq!(light("4 5 6"), [Statement::Light(Light { kind: point })]);
    let point = LightKind::Point { color: Color::Xyz([4.0, 5.0, 6.0]), power: None, position: [1.0, 2.0, 3.0] };
    assert_eq!(light("{ XYZ 4 5 6 }"), [Statement::Light(Light { kind: point })]);
}

#[test]
fn a_stray_number_is_skipped() {
    let glass =
        shader("shader { name a type glass eta 1.3 color 1 1 1 absorbtion.distance 3 absorbtion.color 1 1 1 50 }");
    let absorption = Absorption { distance: Some(3.0), color: Some(Color::Bare([1.0; 3])) };
    assert_eq!(glass.kind, ShaderKind::Glass { eta: 1.3, color: Color::Bare([1.0; 3]), absorption });
}

#[test]
fn an_unknown_shader_keeps_its_words_and_its_own_paint() {
    let paint = |text: &str| match shader(&format!("shader {{ name a type ward {text} rough .1 .2 }}")).kind {
        ShaderKind::Other { block, diffuse } => (block.words.join(" "), diffuse),
        kind => panic!("{kind:?}"),
    };
    let red = Some(Paint::Color(Color::SrgbLinear([1.0, 0.0, 0.0])));
    assert_eq!(paint("diff { \"sRGB linear\" 1 0 0 }"), ("diff { sRGB linear 1 0 0 } rough .1 .2".to_owned(), red));
    assert_eq!(paint("diff 1 2 3").1, Some(Paint::Color(Color::Bare([1.0, 2.0, 3.0]))));
    assert_eq!(paint("texture \"a b.png\"").1, Some(Paint::Texture("a b.png".to_owned().into())));
    assert_eq!(paint("diff 1").1, None);
}

#[test]
fn of_a_moving_object_the_first_place_is_taken() {
    let object = object("object { shader a transform steps 2 times 0 1 { scaleu 1 } { scaleu 2 } type sphere }");
    assert_eq!(object.transform.unwrap().value, Transform::Steps(vec![TransformStep::ScaleUniform(1.0)]));
    let camera =
        "camera { type pinhole steps 2 times 0 1 { eye 1 1 1 target 0 0 0 up 0 0 1 } transform { } fov 45 aspect 1 }";
    match statements(camera).as_slice() {
        [Statement::Camera(Camera { placement: CameraPlacement::LookAt { eye, .. }, .. })] => {
            assert_eq!(*eye, [1.0; 3]);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn statements_that_are_read_over_keep_their_words() {
    let text =
        "gi { type fake sky { XYZ 1 2 3 } } accel bih filter box 1 1 override a true xyzzy { camera { } } bucket 8 row";
    let words: Vec<String> = statements(text)
        .iter()
        .filter_map(|statement| match statement {
            Statement::Other(other) => Some(format!("{}: {}", other.keyword.value, other.words.join(" "))),
            _ => None,
        })
        .collect();
    assert_eq!(
        words,
        [
            "gi: { type fake sky { XYZ 1 2 3 } }",
            "accel: bih",
            "filter: box 1 1",
            "override: a true",
            "xyzzy: { camera { } }",
        ]
    );
}

#[test]
fn after_an_error_the_next_block_is_read() {
    let scene =
        read("shader { name a type mirror refl 1 1 object { shader a type sphere } image { aa x } bucket 8 row").scene;
    let kinds: Vec<bool> = scene.statements.iter().map(|it| matches!(it.value, Statement::Object(_))).collect();
    // The object, then the bucket.
    assert_eq!(kinds, [true, false]);
}

#[test]
fn a_block_that_is_given_up_ends_before_the_next_statement() {
    // It has no type, so none of its fields is read; and its brace is missing.
    let scene = read("shader { name a object { shader a type box }").scene;
    assert!(matches!(scene.statements.as_slice(), [it] if matches!(it.value, Statement::Object(_))));
}

#[test]
fn a_span_covers_its_whole_statement() {
    let source = "bucket 32 row image { aa 0 1 } % end";
    let parsed = parse("scene.sc", source, &NoFiles);
    let texts: Vec<&str> =
        parsed.scene.statements.iter().map(|it| &source[it.span.start as usize..it.span.end as usize]).collect();
    assert_eq!(texts, ["bucket 32 row", "image { aa 0 1 }"]);
}
