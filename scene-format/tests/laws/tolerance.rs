//! What real files do and Sunflow does not accept, and how it is read all the same.

use scene_format::scene_file::*;
use scene_format::{NoFiles, Spanned, parse};

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
fn a_brace_between_two_words_cuts_them_apart() {
    assert_same("image { aa 0 1 }\nbucket 8 row", "image{aa 0 1}bucket 8 row");
    assert_same("object { shader a type box }", "object{shader a type box}");
    // A name in braces is one word all the same.
    assert_eq!(shader("shader { name a{b} type mirror refl 1 1 1 }").name.value, "a{b}");
}

#[test]
fn the_quotes_around_a_colour_space_may_be_missing() {
    assert_same("background { color { \"sRGB linear\" 1 2 3 } }", "background { color { sRGB linear 1 2 3 } }");
    assert_same("background { color { \"sRGB linear\" 1 2 3 } }", "background { color { \" sRGB\tlinear \" 1 2 3 } }");
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
        (mesh.normals.value, mesh.uvs.value),
        (PerVertex::None, PerVertex::Vertex(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]))
    );
}

#[test]
fn the_old_form_of_a_mesh_is_read_into_the_same_lists() {
    let line = |x: u8| format!("v {x} 0 0 0 0 1 0.5 {x}\n");
    let text = format!("object {{ shader a type mesh name m 3 1\n{}{}{}t 2 1 0 }}", line(0), line(1), line(2));
    let Shape::Mesh(mesh) = object(&text).shape.value else { panic!("not a mesh") };
    assert_eq!(mesh.form, MeshForm::Lines);
    assert_eq!(*mesh.points, [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    assert_eq!(*mesh.triangles, [[2, 1, 0]]);
    assert_eq!(*mesh.normals, PerVertex::Vertex(vec![[0.0, 0.0, 1.0]; 3]));
    assert_eq!(*mesh.uvs, PerVertex::Vertex(vec![[0.5, 0.0], [0.5, 1.0], [0.5, 2.0]]));
}

#[test]
fn a_box_and_single_axis_scales_are_known() {
    let object = object("object { type box shader a transform { scalex 1 scaley 2 scalez 3 } }");
    assert_eq!(object.shape.value, Shape::Box);
    let steps = [TransformStep::ScaleX(1.0), TransformStep::ScaleY(2.0), TransformStep::ScaleZ(3.0)];
    let steps = steps.map(Spanned::from).to_vec();
    assert_eq!(object.transform.unwrap().value, Transform::Steps(steps));
}

#[test]
fn the_colour_of_a_constant_shader_needs_no_keyword() {
    assert_same("shader { name a type constant color 1 2 3 }", "shader { name a type constant 1 2 3 }");
}

#[test]
fn a_point_light_may_have_its_old_form() {
    let light = |power: &str| statements(&format!("light {{ type point power {power} p 1 2 3 }}"));
    let point = |color: Color| {
        [Statement::Light(Light::Point { color: color.into(), power: None, position: [1.0, 2.0, 3.0].into() })]
    };
    assert_eq!(light("4 5 6"), point(Color::Bare([4.0, 5.0, 6.0])));
    assert_eq!(light("{ XYZ 4 5 6 }"), point(Color::Xyz([4.0, 5.0, 6.0])));
}

#[test]
fn a_stray_number_is_skipped() {
    let glass =
        shader("shader { name a type glass eta 1.3 color 1 1 1 absorbtion.distance 3 absorbtion.color 1 1 1 50 }");
    let white = Spanned::from(Color::Bare([1.0; 3]));
    let absorption = Absorption { distance: Some(3.0.into()), color: Some(white.clone()) };
    assert_eq!(glass.kind, ShaderKind::Glass { eta: 1.3.into(), color: white, absorption });
}

fn paint(text: &str) -> Option<Paint> {
    shader(&format!("shader {{ name a type {text} }}")).kind.own_paint()
}

#[test]
fn an_unknown_shader_keeps_its_words_and_its_own_paint() {
    let words = |text: &str| match shader(&format!("shader {{ name a type marble {text} rough .1 .2 }}")).kind {
        ShaderKind::Unknown { block, .. } => block.words.iter().map(|word| word.as_str()).collect::<Vec<_>>().join(" "),
        kind => panic!("{kind:?}"),
    };
    assert_eq!(words("diff { \"sRGB linear\" 1 0 0 }"), "diff { sRGB linear 1 0 0 } rough .1 .2");
    let color = |color: Color| Some(Paint::Color(color.into()));
    for kind in ["marble", "ward"] {
        assert_eq!(
            paint(&format!("{kind} diff {{ \"sRGB linear\" 1 0 0 }}")),
            color(Color::SrgbLinear([1.0, 0.0, 0.0]))
        );
        assert_eq!(paint(&format!("{kind} diff 1 2 3 rough 1 2")), color(Color::Bare([1.0, 2.0, 3.0])));
        assert_eq!(paint(&format!("{kind} texture \"a b.png\"")), Some(Paint::Texture("a b.png".to_owned().into())));
        assert_eq!(paint(kind), None);
    }
    assert_eq!(paint("marble diff 1"), None);
    // As Sunflow's `uber` has it: a texture covers the colour.
    assert_eq!(
        paint("uber diff 1 2 3 diff.texture t.png diff.blend .5"),
        Some(Paint::Texture("t.png".to_owned().into()))
    );
}

#[test]
fn what_moves_keeps_all_its_places() {
    let object = object(
        "object { shader a transform steps 2 times 0 1 { scaleu 1 } row 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 type sphere }",
    );
    let Some(Spanned { value: Transform::Moving { times, steps }, .. }) = object.transform else { panic!("still") };
    assert_eq!(times.value, [0.0, 1.0]);
    assert_eq!(*steps[0], Transform::Steps(vec![TransformStep::ScaleUniform(1.0).into()]));
    assert!(matches!(*steps[1], Transform::Row(_)));
    let camera =
        "camera { type pinhole steps 2 times 0 1 { eye 1 1 1 target 0 0 0 up 0 0 1 } transform { } fov 45 aspect 1 }";
    match statements(camera).as_slice() {
        [Statement::Camera(Camera { placement: CameraPlacement::Moving { steps, .. }, .. })] => {
            assert!(matches!(steps[0], CameraPlacement::LookAt { eye, .. } if *eye == [1.0; 3]));
            assert!(matches!(steps[1], CameraPlacement::Transform(_)));
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn colours_may_be_spectra() {
    let color = |text: &str| match statements(&format!("background {{ color {{ {text} }} }}")).as_slice() {
        [Statement::Background(color)] => color.value.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!(color("blackbody 6500"), Color::Blackbody(6500.0));
    let spectrum = Color::Spectrum { range: [400.0, 700.0], values: vec![0.25, 0.5, 1.0] };
    assert_eq!(color("\"spectrum 400 700\" 3 .25 .5 1"), spectrum);
    assert_eq!(color("spectrum 400 700 3 .25 .5 1"), spectrum);
}

#[test]
fn types_that_are_not_rendered_are_read_with_their_values() {
    let photons = "photons { emit 10 global kd 100 0.5 caustics 7 none 0 0 }";
    let [Statement::Photons(photons)] = &statements(photons)[..] else { panic!("no photons") };
    let fields: Vec<_> = photons.fields.iter().map(|field| (field.name.as_str(), field.values.len())).collect();
    assert_eq!(fields, [("emit", 1), ("global", 3), ("caustics", 4)]);
    assert_eq!(photons.fields[1].values[0].value, Value::Word("kd".to_owned()));
    assert_eq!(photons.fields[1].values[2].value, Value::Number(0.5));
    let sky = "light { type sunsky up 0 0 1 east 0 1 0 sundir 1 1 1 turbidity 4 ground.color { XYZ 1 1 1 } }";
    let [Statement::Light(Light::Unrendered(sky))] = &statements(sky)[..] else { panic!("no sky") };
    assert_eq!(sky.fields[4].values[0].value, Value::Color(Color::Xyz([1.0; 3])));
    assert_eq!(&sky.fields[3].name.span, &scene_format::Span { file: 0, start: 53, end: 62 });
}

#[test]
fn what_nobody_knows_keeps_its_words() {
    let text =
        "gi { type fake sky { XYZ 1 2 3 } } accel bih filter box 1 1 override a true xyzzy { camera { } } bucket 8 row";
    match &statements(text)[..] {
        [
            Statement::Gi(_),
            Statement::Accelerator(_),
            Statement::Filter { .. },
            Statement::Override { .. },
            Statement::Unknown(unknown),
            Statement::Bucket(_),
        ] => {
            let words: Vec<&str> = unknown.words.iter().map(|word| word.as_str()).collect();
            assert_eq!((unknown.keyword.as_str(), words), ("xyzzy", vec!["{", "camera", "{", "}", "}"]));
        }
        other => panic!("{other:#?}"),
    }
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

#[test]
fn a_number_in_a_list_ends_with_its_word() {
    let mesh = |last: &str| format!("object {{ shader a type generic-mesh points 1 0 0 {last} triangles 0 }}");
    assert_eq!(messages(&read(&mesh("2"))), "");
    for last in ["1.2.3", "1x", "1,5", "0x1p1x"] {
        assert!(messages(&read(&mesh(last))).contains("error[SC301]"), "{last}");
    }
}
