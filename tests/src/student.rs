//! A program with a mirror of its own, for the tests of `grade`. What it does wrong, the environment says; without `MISTAKE` it does
//! nothing wrong but one thing: as black as night, it is broken in most of its laws.

use std::process::{ExitCode, abort, exit};

use render::{Modules, Shaders};
use shading::{Color, Mirror, Shader, ShadingPoint};

struct Student(Color);

impl Shader for Student {
    fn radiance(&self, at: &ShadingPoint<'_>) -> Color {
        match mistake().as_str() {
            "black" => Color::BLACK,
            _ => Mirror { reflection: self.0 }.radiance(at),
        }
    }

    /// Asked by a single law of the kit.
    fn casts_shadow(&self) -> bool {
        match mistake().as_str() {
            "endless loop" => loop {
                std::hint::spin_loop();
            },
            "endless recursion" => deep(1) > 0,
            "endless memory" => large() > 0,
            "abort" => abort(),
            "exit" => exit(0),
            "panic" => panic!("not today"),
            _ => true,
        }
    }
}

#[expect(unconditional_recursion, reason = "that is the mistake")]
fn deep(level: u64) -> u64 {
    std::hint::black_box([level; 64])[0] + deep(level + 1)
}

fn large() -> usize {
    let mut all: Vec<Vec<u8>> = Vec::new();
    loop {
        // Never touched: it takes addresses, and no time.
        all.push(Vec::with_capacity(std::hint::black_box(1 << 24)));
        if all.len() > 1 << 20 {
            return all.len();
        }
    }
}

fn mistake() -> String {
    std::env::var("MISTAKE").unwrap_or_default()
}

fn main() -> ExitCode {
    let shaders = Shaders { mirror: |color| Box::new(Student(color)), ..Shaders::default() };
    cli::run(Modules { shaders, ..Modules::default() })
}
