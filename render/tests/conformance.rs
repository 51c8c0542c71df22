//! This crate's own parts keep the laws of their kits.

mod random {
    render::sampler_conformance!(render::random);
}

mod sobol {
    render::sampler_conformance!(render::sobol);
}

/// Its rays have no place by chance in their zones, and so fail what is about chance.
#[test]
fn the_middles_of_zones_keep_the_laws_that_are_not_about_places_in_a_zone() {
    use render::conformance::sampler::LAWS;
    let about_places = ["points_fill_the_square_evenly", "pixel_and_lens_are_independent"];
    for law in LAWS.iter().filter(|law| !about_places.contains(&law.name)) {
        law.assert(render::centred);
    }
}
