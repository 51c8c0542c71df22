//! The figure in the documentation is the one that is drawn.

#[allow(dead_code)]
#[path = "../examples/octree_svg.rs"]
mod octree_svg;

#[test]
fn the_figure_in_the_documentation_is_the_one_that_is_drawn() {
    let drawn = octree_svg::svg();
    assert!(
        drawn == include_str!("../docs/octree.svg"),
        "cargo run -p accel --example octree_svg > accel/docs/octree.svg"
    );
}
