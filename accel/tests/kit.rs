//! Our own accelerators keep the laws of the kit: asking every primitive, the octree, and the wide one in each of its forms.

use accel::{Accelerator, Hits, Instructions, Step, wide_up_to, wide_with};
use geometry::Primitives;

mod none {
    accel::conformance!(accel::none);
}

mod octree {
    accel::conformance!(accel::octree);
}

mod wide {
    accel::conformance!(accel::wide);
}

mod wide_for_any_processor {
    use super::*;

    accel::conformance!(|all: Primitives| with(Instructions::Portable, all));
}

mod wide_with_avx2 {
    use super::*;

    accel::conformance!(|all: Primitives| with(Instructions::Avx2, all));
}

mod wide_with_avx512 {
    use super::*;

    accel::conformance!(|all: Primitives| with(Instructions::Avx512, all));
}

mod wide_with_one_level_a_node {
    use super::*;

    accel::conformance!(|all: Primitives| wide_up_to(all, Step::OneLevel));
}

/// With these instructions if this processor has them, otherwise with those that any has.
fn with(instructions: Instructions, all: Primitives) -> Box<dyn Accelerator> {
    let built = wide_with(all.clone(), Hits::Exact, instructions);
    built.unwrap_or_else(|| accel::wide(all))
}

/// Of the many rays that a law asks about, a report shows the one that is answered wrongly.
#[test]
fn a_broken_law_shows_a_single_ray() {
    use accel::conformance::accelerator::{LAWS, Part};
    // An accelerator that has lost everything.
    let part: Part = |_| accel::none(Primitives::default());
    for name in ["the_nearest_of_several_is_found", "every_ray_finds_what_asking_every_primitive_finds"] {
        let law = LAWS.iter().find(|law| law.name == name).expect("a law of the kit");
        let broken = law.check(&part, &geometry::conformance::Trial { cases: 16, seed: 1 }).expect_err(name);
        assert_eq!(broken.counterexample.case.matches("Ray {").count(), 1, "{broken}");
    }
}

#[cfg(target_arch = "x86_64")]
#[test]
fn instructions_are_found_where_the_processor_has_them() {
    let has_bits = is_x86_feature_detected!("bmi1")
        && is_x86_feature_detected!("bmi2")
        && is_x86_feature_detected!("lzcnt")
        && is_x86_feature_detected!("popcnt")
        && is_x86_feature_detected!("fma");
    let has_avx2 = has_bits && is_x86_feature_detected!("avx2");
    let has_avx512 = has_bits
        && is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512vl")
        && is_x86_feature_detected!("avx512dq");
    for (instructions, has) in
        [(Instructions::Portable, true), (Instructions::Avx2, has_avx2), (Instructions::Avx512, has_avx512)]
    {
        let built = wide_with(Primitives::default(), Hits::Exact, instructions);
        assert_eq!(built.is_some(), has, "{instructions:?}");
    }
}
