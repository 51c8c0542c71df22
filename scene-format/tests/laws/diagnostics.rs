//! What the reader says about each kind of mistake, word for word.

use insta::assert_snapshot;

use crate::{messages, read};

fn say(source: &str) -> String {
    messages(&read(source))
}

#[test]
fn a_misspelt_statement() {
    assert_snapshot!(say("shadr { name a }"), @"scene.sc:1:1: error[SC101]: unknown statement `shadr` [expected a statement] (did you mean `shader`?)");
}

#[test]
fn an_unknown_statement() {
    assert_snapshot!(say("scene { width 3 }\nbucket 8 row"), @"scene.sc:1:1: warning[SC101]: unknown statement `scene` [skipped, with all that belongs to it]");
}

#[test]
fn a_misspelt_field() {
    assert_snapshot!(say("camera { type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fvo 60 aspect 1 }"), @"scene.sc:1:55: error[SC107]: unknown word `fvo` in this camera [not known here] {scene.sc:1:1: the block begins here} (did you mean `fov`?)");
}

#[test]
fn a_field_that_is_spelt_out() {
    assert_snapshot!(say("shader { name a type phong diffuse 1 1 1 spec 1 1 1 9 }"), @"scene.sc:1:28: error[SC107]: unknown word `diffuse` in this shader [not known here] {scene.sc:1:1: the block begins here} (did you mean `diff`?)");
}

#[test]
fn an_unknown_field() {
    assert_snapshot!(say("shader { name a type mirror refl 1 1 1 glow 3 4 }"), @"scene.sc:1:40: warning[SC107]: unknown word `glow` in this shader [skipped, up to the next word that is known] {scene.sc:1:1: the block begins here}");
}

#[test]
fn a_field_of_another_type() {
    assert_snapshot!(say("shader { name a type mirror refl 1 1 1 eta 1.5 }"), @"scene.sc:1:40: warning[SC108]: `eta` means nothing in a shader of this type [skipped] {scene.sc:1:1: the block begins here}");
}

#[test]
fn a_missing_field() {
    assert_snapshot!(say("camera {\n  type pinhole\n  eye 0 0 0\n  up 0 0 1\n  aspect 1\n}"), @"
        scene.sc:6:1: error[SC111]: the camera has no `target` [expected `target x y z` before this] {scene.sc:1:1: the block begins here}
        scene.sc:6:1: error[SC111]: the camera has no `fov` [expected `fov <degrees>` before this] {scene.sc:1:1: the block begins here}
    ");
}

#[test]
fn a_missing_type() {
    assert_snapshot!(say("shader { name a }"), @"scene.sc:1:1: error[SC112]: the shader has no `type` [expected `type <type>` in this block] (types that are rendered: constant, diffuse, phong, mirror, glass, shiny)");
}

#[test]
fn an_unknown_type() {
    assert_snapshot!(say("object { shader a type sphre }"), @"scene.sc:1:24: warning[SC113]: unknown object type `sphre` [left out of the picture] (did you mean `sphere`?)");
}

#[test]
fn a_type_that_is_not_rendered() {
    assert_snapshot!(say("light { type sunsky turbidity 2 }"), @"scene.sc:1:14: warning[SC602]: lights of type `sunsky` are not rendered [gives no light] (types that are rendered: point)");
}

#[test]
fn not_a_number() {
    assert_snapshot!(say("object { shader a type sphere c 0 zero 0 r 1 }"), @"scene.sc:1:35: error[SC201]: `c` needs a number [expected a number, found `zero`]");
}

#[test]
fn a_number_with_a_comma() {
    assert_snapshot!(say("object { shader a type sphere c 1, 2, 3 r 1,5 }"), @"
        scene.sc:1:33: error[SC201]: `c` needs a number [expected a number, found `1,`] (numbers are separated by white space alone, and have a point, not a comma)
        scene.sc:1:43: error[SC201]: `r` needs a number [expected a number, found `1,5`] (numbers are separated by white space alone, and have a point, not a comma)
    ");
}

#[test]
fn not_a_finite_number() {
    assert_snapshot!(say("object { shader a type sphere c 0 NaN 1e99 r 1 }"), @"scene.sc:1:35: error[SC202]: `NaN` is not a finite number [expected a number, found `NaN`] (numbers go up to 3.4e38 in size)");
}

#[test]
fn not_a_whole_number() {
    assert_snapshot!(say("image { samples 4.0 aa 0 x }"), @"
        scene.sc:1:17: error[SC201]: `samples` needs a whole number [expected a whole number, found `4.0`] (write it without a point or exponent)
        scene.sc:1:26: error[SC201]: `aa` needs a whole number [expected a whole number, found `x`]
    ");
}

#[test]
fn an_impossible_picture_size() {
    assert_snapshot!(say("image { resolution 5 99999 }"), @"scene.sc:1:22: error[SC701]: `resolution` must be from 1 to 16384 [found `99999`]");
}

#[test]
fn an_impossible_radius() {
    assert_snapshot!(say("object { shader a type torus r -1 2 }"), @"scene.sc:1:32: error[SC203]: `r` must be greater than 0 [found `-1`]");
}

#[test]
fn an_impossible_view() {
    assert_snapshot!(say("camera { type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov 180 aspect 0 }"), @"
        scene.sc:1:59: warning[SC209]: a plane shows more than 0 and less than 180 degrees [the picture is as wide as twice the tangent of half of this, as Sunflow's is] (60 is usual)
        scene.sc:1:70: error[SC203]: `aspect` must be other than 0 [found `0`]
    ");
    assert_snapshot!(say("camera { type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov -30 aspect -1 }"), @"
        scene.sc:1:59: warning[SC209]: a plane shows more than 0 and less than 180 degrees [the picture is as wide as twice the tangent of half of this, as Sunflow's is] (60 is usual)
        scene.sc:1:70: warning[SC209]: the width of a plane over its height is more than 0 [the picture is upside down, as Sunflow's is] (write the picture's width over its height)
    ");
}

#[test]
fn a_missing_closing_brace() {
    assert_snapshot!(say("shader {\n  name a type mirror refl 1 1 1\n\nobject { shader a type box }"), @"scene.sc:4:1: error[SC104]: the shader has no closing brace [expected `}`, found `object`] {scene.sc:1:1: the block begins here} (put a `}` at the end of the block)");
}

#[test]
fn a_brace_missing_at_the_end() {
    assert_snapshot!(say("image { aa 0 1"), @"scene.sc:1:15: error[SC104]: the image has no closing brace [expected `}`, found the end of the file] {scene.sc:1:1: the block begins here} (put a `}` at the end of the block)");
}

#[test]
fn a_missing_opening_brace() {
    assert_snapshot!(say("shader name a type mirror refl 1 1 1 }\nimage { aa 0 }"), @"
        scene.sc:1:8: error[SC103]: `shader` needs a block after it [expected `{`, found `name`]
        scene.sc:2:14: error[SC201]: `aa` needs a whole number [expected a whole number, found `}`]
    ");
}

#[test]
fn a_colour_that_is_not_closed() {
    assert_snapshot!(say(r#"shader { name a type phong diff { "sRGB linear" 1 0 0 spec 1 1 1 50 }"#), @"scene.sc:1:55: error[SC105]: the colour is not closed [expected `}`, found `spec`] {scene.sc:1:33: opened here} (put a `}` before this)");
}

#[test]
fn an_unknown_colour_space() {
    assert_snapshot!(say(r#"background { color { "sRGB non-linear" 1 0 0 } }"#), @r#"scene.sc:1:22: error[SC205]: unknown colour space `sRGB non-linear` [expected "sRGB nonlinear", "sRGB linear", XYZ, blackbody or "spectrum MIN MAX"] (did you mean "sRGB nonlinear"?)"#);
}

#[test]
fn a_colour_that_is_not_rendered() {
    assert_snapshot!(say("background { color { blackbody 6500 } }"), @"");
}

#[test]
fn a_brace_too_many() {
    assert_snapshot!(say("image { aa 0 1 } }\nbucket 8 row"), @"scene.sc:1:18: warning[SC102]: `}` stands between statements [no block is open here] (remove it, or look for a brace too many or too few before it)");
}

#[test]
fn a_corner_that_is_no_point() {
    assert_snapshot!(say("object { shader a type generic-mesh points 3 0 0 0 1 0 0 0 1 0 triangles 2 0 1 2 0 1 3 }"), @"scene.sc:1:86: error[SC304]: a triangle has a corner that is no point of the mesh [in triangle number 1, counted from 0] (points are counted from 0, and there are 3: the last one is 2)");
}

#[test]
fn a_corner_that_is_no_point_in_the_old_form() {
    assert_snapshot!(say("object { shader a type mesh 1 1 v 0 0 0 0 0 1 0 0 t 0 7 0 }"), @"scene.sc:1:55: error[SC304]: a triangle has a corner that is no point of the mesh [in triangle number 0, counted from 0] (points are counted from 0, and there are 1: the last one is 0)");
}

#[test]
fn a_corner_below_zero() {
    assert_snapshot!(say("object { shader a type generic-mesh points 1 0 0 0 triangles 1 0 0 -2 }"), @"scene.sc:1:68: error[SC203]: `-2` is out of range among the triangles [expected a whole number from 0 on, found `-2`] {scene.sc:1:62: announced as 1 here}");
}

#[test]
fn a_list_that_ends_early() {
    assert_snapshot!(say("object {\n  shader a\n  type generic-mesh\n  points 3\n    0 0 0\n    1 0\n  triangles 100000000\n}"), @"
        scene.sc:7:3: error[SC301]: the points end after 1 of 3 [expected a number, found `triangles`] {scene.sc:4:10: announced as 3 here} (correct the count, or write what is missing)
        scene.sc:8:1: error[SC301]: the triangles end after 0 of 100000000 [expected a whole number from 0 on, found `}`] {scene.sc:7:13: announced as 100000000 here} (correct the count, or write what is missing)
    ");
}

#[test]
fn a_list_that_is_too_long() {
    assert_snapshot!(say("object { shader a type generic-mesh points 1 0 0 0 1 0 0 triangles 0 }"), @"scene.sc:1:52: error[SC302]: there are more points than announced [expected the next field, found `1`] {scene.sc:1:44: announced as 1 here} (correct the count, or remove what is too much)");
}

#[test]
fn values_before_what_they_belong_to() {
    assert_snapshot!(say("object { shader a type generic-mesh normals vertex 0 0 1 points 1 0 0 0 triangles 0 }"), @"scene.sc:1:37: error[SC303]: `normals` stands before `points` [how many points there are is not known yet] (move `normals` behind `points`)");
}

#[test]
fn a_matrix_with_a_wrong_last_row() {
    assert_snapshot!(say("object { shader a transform row 1 0 0 0 0 1 0 0 0 0 1 0 5 6 7 1 type sphere }"), @"scene.sc:1:29: error[SC207]: the last row of a transform must be 0 0 0 1 [found 5 6 7 1] (`row` takes the matrix row by row, `col` column by column: exchange them if it is the other way)");
}

#[test]
fn a_misspelt_step() {
    assert_snapshot!(say("object { shader a transform { roatex 30 shear 1 2 scaleu 2 } type sphere }"), @"scene.sc:1:31: error[SC206]: unknown step `roatex` in a transform (did you mean `rotatex`?)");
}

#[test]
fn a_plane_that_is_not_determined() {
    assert_snapshot!(say("object { shader a type plane p 0 0 0 }"), @"scene.sc:1:1: error[SC305]: the plane is not determined [found 1 times `p` and 0 times `n`] (write `p x y z n x y z`, or three times `p x y z`)");
}

#[test]
fn two_places_for_a_camera() {
    assert_snapshot!(say("camera { type pinhole eye 0 0 0 transform { } fov 45 aspect 1 }"), @"scene.sc:1:27: error[SC115]: the camera has two places {scene.sc:1:43: this already says where it stands} (write either `eye`, `target` and `up`, or `transform`)");
}

#[test]
fn a_name_that_is_taken() {
    assert_snapshot!(say("shader { name a type mirror refl 1 1 1 }\nobject { shader a type box name a }"), @"scene.sc:2:33: warning[SC401]: the name `a` is given twice [left out, as Sunflow does] {scene.sc:1:15: first given here} (give each shader, object, instance and modifier a name of its own)");
}

#[test]
fn a_field_given_twice() {
    assert_snapshot!(say("image { aa 0 1 aa 0 2 }"), @"scene.sc:1:16: warning[SC110]: `aa` is given twice [the last one holds] {scene.sc:1:9: first given here}");
}

#[test]
fn an_object_without_shader() {
    assert_snapshot!(say("object { type box }"), @"scene.sc:1:1: warning[SC402]: the object names no shader (write `shader <name>` in the block)");
}

#[test]
fn a_sphere_without_place() {
    assert_snapshot!(say("object { shader a type sphere }\nobject { noinstance type sphere }"), @"scene.sc:1:24: warning[SC311]: the sphere has neither `c` and `r` nor a transform [drawn with radius 1 around the origin]");
}

#[test]
fn a_stray_number() {
    assert_snapshot!(say(r#"shader { name a type glass eta 1.3 color 1 1 1 absorbtion.color { "sRGB nonlinear" 1 1 1 } 50 }"#), @"scene.sc:1:92: warning[SC109]: the number `50` belongs to no field [skipped] {scene.sc:1:1: the block begins here} (remove it, or write the word before it that says what it is)");
}

#[test]
fn movement() {
    assert_snapshot!(say("object { shader a transform steps 1 times 0 1 { } type sphere }"), @"scene.sc:1:29: warning[SC603]: movement is not rendered [everything stands where the first step puts it]");
}

#[test]
fn statements_that_are_ignored() {
    assert_snapshot!(say("gi { type path } photons { } lightserver { } modifier { name m } accel bih filter box override a true"), @"
        scene.sc:1:1: warning[SC601]: `gi` is ignored [surfaces get light from the lights alone]
        scene.sc:1:18: warning[SC601]: `photons` is ignored [there are no caustics]
        scene.sc:1:30: warning[SC601]: `lightserver` is ignored [an old form of `trace-depths`, `gi` and `photons`]
        scene.sc:1:46: warning[SC601]: `modifier` is ignored [surfaces that name it stay smooth]
        scene.sc:1:46: error[SC112]: the modifier has no `type` [expected `type <type>` in this block] (types that are rendered: bump, normalmap, perlin)
        scene.sc:1:66: warning[SC601]: `accel` is ignored [the picture does not depend on it]
        scene.sc:1:76: warning[SC601]: `filter` is ignored [outside the `image` block it does nothing]
        scene.sc:1:87: warning[SC601]: `override` is ignored [objects keep their own shaders]
    ");
}

#[test]
fn no_global_illumination_is_what_there_is() {
    assert_eq!(say("gi { type none } gi { type null }"), "");
}

#[test]
fn an_unknown_bucket_order() {
    assert_snapshot!(say("bucket 32 zigzag"), @"scene.sc:1:11: warning[SC208]: unknown bucket order `zigzag` [taken as `hilbert`] (the orders are hilbert, spiral, column, row, diagonal, random)");
}

#[test]
fn a_comment_without_end() {
    assert_snapshot!(say("bucket 8 row /* and so on"), @"scene.sc:1:14: warning[SC106]: this comment is never closed [takes the rest of the file] (end it with `*/`, with white space on both sides)");
}

#[test]
fn a_quote_without_end() {
    assert_snapshot!(say("object { shader \"white type box\n}\nshader { name \"a\n type mirror refl 1 1 1 }"), @r#"
        scene.sc:1:1: error[SC112]: the object has no `type` [expected `type <type>` in this block] (types that are rendered: sphere, plane, box, generic-mesh, mesh, flat-mesh, file-mesh, bezier-mesh, cylinder, torus, sphereflake, teapot, gumbo, particles)
        scene.sc:1:17: warning[SC117]: this quote is not closed in its line [one name, up to the end of the line] (put a `"` behind the name, or remove the first one: only names with spaces need any)
        scene.sc:3:15: warning[SC117]: this quote is not closed in its line [one name, up to the end of the line] (put a `"` behind the name, or remove the first one: only names with spaces need any)
    "#);
}

#[test]
fn a_comment_as_in_c() {
    assert_snapshot!(say("// the sky\nbackground { color 1 1 1 // white\n}"), @"
        scene.sc:1:1: warning[SC101]: unknown statement `//` [skipped, with all that belongs to it] (a comment begins with `%` or `#`)
        scene.sc:2:26: warning[SC107]: unknown word `//` in this background [skipped, up to the next word that is known] {scene.sc:2:1: the block begins here} (a comment begins with `%` or `#`)
    ");
}

#[test]
fn an_impossible_bucket_and_picture() {
    assert_snapshot!(say("bucket 0 row image { resolution -4 480 }"), @"
        scene.sc:1:8: warning[SC203]: `bucket` must be 1 or greater [found `0`, taken as 1]
        scene.sc:1:33: warning[SC203]: `resolution` must be 1 or greater [found `-4`, taken as 1]
    ");
}

#[test]
fn a_flag_that_is_neither() {
    assert_snapshot!(say("image { jitter yes }"), @"scene.sc:1:16: warning[SC204]: `jitter` needs `true` or `false` [read as `false`]");
}

#[test]
fn an_empty_file() {
    assert_snapshot!(say(" % nothing here\n"), @"scene.sc:2:1: error[SC116]: the file has no statement");
}

#[test]
fn several_errors_in_one_run() {
    assert_snapshot!(say("image { resolution 0.5 1 aa x }\nshader { type mirror }\nobject { shader a type sphere c 1 2 r 1 }"), @"
        scene.sc:1:20: error[SC201]: `resolution` needs a whole number [expected a whole number, found `0.5`] (write it without a point or exponent)
        scene.sc:1:29: error[SC201]: `aa` needs a whole number [expected a whole number, found `x`]
        scene.sc:2:22: error[SC111]: the shader has no `name` [expected `name <name>` before this] {scene.sc:2:1: the block begins here}
        scene.sc:2:22: error[SC111]: the shader has no `refl` [expected `refl r g b` before this] {scene.sc:2:1: the block begins here}
        scene.sc:3:37: error[SC201]: `c` needs a number [expected a number, found `r`]
    ");
}
