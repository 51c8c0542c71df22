//! This crate's own parts keep the laws of their kits.

mod mirror {
    shading::mirror_conformance!(|reflection| Box::new(shading::Mirror { reflection }));
}
