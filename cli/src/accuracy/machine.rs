//! What the times were measured on.

use std::fs;

/// Names and facts about this machine and this program, for people and for the JSON.
pub(crate) fn machine() -> Vec<(String, String)> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let build = if cfg!(debug_assertions) { "with debug assertions: times say little" } else { "optimised" };
    [
        ("girasol", format!("{} ({build})", env!("CARGO_PKG_VERSION"))),
        ("Processor", processor().unwrap_or_else(|| "unknown".to_owned())),
        ("Threads", threads.to_string()),
        ("System", system()),
        ("Instructions used", target_features()),
    ]
    .map(|(name, fact)| (name.to_owned(), fact))
    .into()
}

/// The processor's name, where the system tells it in a file.
fn processor() -> Option<String> {
    let info = fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = info.lines().find(|line| line.starts_with("model name") || line.starts_with("Model"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

fn system() -> String {
    let name = fs::read_to_string("/etc/os-release").ok().and_then(|text| {
        let line = text.lines().find_map(|line| line.strip_prefix("PRETTY_NAME="))?;
        Some(line.trim_matches('"').to_owned())
    });
    let name = name.unwrap_or_else(|| std::env::consts::OS.to_owned());
    format!("{name}, {}", std::env::consts::ARCH)
}

/// The vector instructions that the compiler was allowed to use.
fn target_features() -> String {
    let features = [
        (cfg!(target_feature = "sse2"), "SSE2"),
        (cfg!(target_feature = "avx"), "AVX"),
        (cfg!(target_feature = "avx2"), "AVX2"),
        (cfg!(target_feature = "fma"), "FMA"),
        (cfg!(target_feature = "avx512f"), "AVX-512"),
        (cfg!(target_feature = "neon"), "NEON"),
    ];
    let used: Vec<&str> = features.into_iter().filter_map(|(used, name)| used.then_some(name)).collect();
    if used.is_empty() { "scalar".to_owned() } else { format!("{} (as compiled)", used.join(", ")) }
}
