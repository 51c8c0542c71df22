//! Wrong modules: the mistakes that are made in each part. The kit of the part must catch every one, by the law that names the mistake.
//!
//! Which mistakes these are stands in the page of each kit, in a table that is held against the modules here.

mod aabb;
mod accelerator;
mod bucket_order;
mod camera;
mod constant;
mod ellipsoid;
mod falloff;
mod glass;
mod lit;
mod mirror;
mod naive_octree;
mod normals;
mod parser;
mod phong;
mod plane;
mod ray_origin;
mod renderer;
mod sampler;
mod soft_shadows;
mod sphere;
mod spoilt;
mod texture;
mod triangle;
mod uv;

use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

use geometry::conformance::{Law, Trial};

/// Any seed must do; these are tried.
const SEEDS: [u64; 3] = [0, 1, 2];

/// So long may a kit take to find a mistake.
const LONGEST: Duration = Duration::from_secs(10);

/// A kit, and the file of its page.
pub(crate) struct Kit<Part: 'static> {
    pub(crate) page: &'static str,
    pub(crate) laws: &'static [Law<Part>],
}

/// A mistake in a few words, a part that makes it, and the law that must name it.
pub(crate) type Wrong<Part> = (&'static str, Part, &'static str);

impl<Part> Kit<Part> {
    /// The kit's page lists these mistakes and no others, and its laws catch each.
    #[track_caller]
    pub(crate) fn catches(&self, wrong: impl IntoIterator<Item = Wrong<Part>>) {
        let mut listed = rows(self.page);
        for (mistake, module, law) in wrong {
            let row = format!("//! | {mistake} | [`{law}`] |");
            let known = listed.iter().position(|listed| *listed == row);
            listed.remove(known.unwrap_or_else(|| panic!("not in the table of {}:\n{row}", self.page)));
            caught(law, self.laws, &module, mistake);
        }
        assert!(listed.is_empty(), "no wrong module makes these mistakes of {}: {listed:#?}", self.page);
    }
}

/// The law fails on the module, in time, and the easier laws before it pass: so it is the one that names the mistake.
#[track_caller]
pub(crate) fn caught<Part>(law_name: &str, laws: &[Law<Part>], module: &Part, mistake: &str) {
    for seed in SEEDS {
        let trial = Trial { cases: 256, seed };
        let mut start = Instant::now();
        let broken = laws.iter().find_map(|law| {
            start = Instant::now();
            law.check(module, &trial).err()
        });
        let broken = broken.unwrap_or_else(|| panic!("{mistake}: no law is broken (seed {seed})"));
        assert_eq!(broken.law, law_name, "{mistake} (seed {seed}):\n{broken}");
        assert!(start.elapsed() < LONGEST, "{mistake} (seed {seed}): found after {:?}", start.elapsed());
    }
}

/// The rows of the table of mistakes in a page, below its heading.
fn rows(page: &str) -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace is around this package");
    let text = fs::read_to_string(root.join(page)).expect(page);
    let table = text.lines().skip_while(|line| !line.starts_with("//! |---")).skip(1);
    table.take_while(|line| line.starts_with("//! |")).map(str::to_owned).collect()
}
