//! This crate's own parts keep the laws of their kits.

use std::sync::Arc;

use shading::{Constant, Glass, Mirror, Phong, conformance::falloff, linear_falloff, logarithmic_falloff, sunflow};

mod constant {
    shading::constant_conformance!(|color| Box::new(super::Constant { color }));
}

mod phong {
    shading::phong_conformance!(|diffuse, specular, exponent| Box::new(super::Phong { diffuse, specular, exponent }));
}

mod mirror {
    shading::mirror_conformance!(|reflection| Box::new(super::Mirror { reflection }));
}

mod glass {
    shading::glass_conformance!(|eta, color, absorption| Box::new(super::Glass { eta, color, absorption }));
}

mod texture {
    shading::texture_conformance!(|picture| super::Arc::new(picture));
}

mod soft_shadows {
    shading::soft_shadows_conformance!(shading::light_cluster);
}

mod linear {
    shading::falloff_conformance!(super::linear_falloff);
}

#[test]
fn every_falloff_gives_0_or_more_and_0_for_nan() {
    let law = falloff::LAWS.iter().find(|law| law.name == "no_share_is_below_0_or_nan").expect("a law of the kit");
    law.assert(logarithmic_falloff);
    law.assert(sunflow::inverse_square_falloff);
}
