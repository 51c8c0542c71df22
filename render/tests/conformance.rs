//! This crate's own parts keep the laws of their kits.

mod random {
    render::sampler_conformance!(render::random);
}

mod sobol {
    render::sampler_conformance!(render::sobol);
}

mod bucket_order {
    render::bucket_order_conformance!(render::bucket_order);
}

mod camera {
    render::camera_conformance!(render::camera);
}

mod in_buckets {
    render::renderer_conformance!(render::render);
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

/// It knows one bucket alone: the whole picture.
#[test]
fn pixels_one_by_one_keep_the_laws_that_are_not_about_buckets() {
    use render::conformance::renderer::LAWS;
    for law in LAWS.iter().filter(|law| law.name != "one_thread_takes_the_buckets_in_their_order") {
        law.assert(render::one_by_one);
    }
}
