mod accelerators;

use std::fmt::Write;

use accel::Statistics;
use geometry::PrimitiveCount;
use render::{Allotment, Inventory, Modules, Settings, ShadingNeeds};

use crate::args::InspectArguments;
use crate::input::{ReadyScene, SceneSource};
use crate::output::print;
use crate::report::{Failure, Show};

pub(crate) fn run(arguments: &InspectArguments, modules: Modules) -> Result<(), Failure> {
    let source = SceneSource::find(&arguments.scene.scene)?;
    let parsed = source.parse(&modules);
    let ready = source.assemble(&parsed, &arguments.options, modules, Show::BeforeRendering)?;
    let chosen = arguments.options.modules(modules).accelerator;
    print(&format!("{}\n{}", describe(source.label(), &ready), accelerators::table(&ready, chosen)))
}

fn describe(label: &str, ready: &ReadyScene) -> String {
    let ReadyScene { assembled, settings } = ready;
    let inventory = assembled.scene.inventory(settings);
    let mut text = format!("{label}\n");
    let mut row = |name: &str, value: String| {
        let _ = writeln!(text, "  {name:<14} {value}");
    };
    row("picture", picture(settings));
    row("rays", rays(&inventory, settings));
    row("primitives", primitives(&inventory));
    row("memory", format!("{} for the primitives", bytes(inventory.primitive_bytes)));
    if let Some(blockers) = &inventory.blockers {
        row("for shadows", format!("a second accelerator, of what is not glass: {}", tree(blockers)));
    }
    row("lights", inventory.lights.to_string());
    row("shaders", format!("{}: {}", inventory.shaders, or_none(&assembled.shading.types)));
    row("textures", textures(&assembled.shading));
    row(
        "camera",
        if inventory.lens { "with a lens: depth of field" } else { "a pinhole: everything is sharp" }.to_owned(),
    );
    for line in left_out(&inventory, settings, &assembled.shading) {
        row("not needed", line);
    }
    text
}

fn picture(settings: &Settings) -> String {
    let window = settings.window();
    let buckets = settings.buckets;
    format!(
        "{} x {} pixels in buckets of {}, order {}{}",
        window.width,
        window.height,
        buckets.size,
        if buckets.reversed { "reverse-" } else { "" },
        buckets.order.name()
    )
}

fn rays(inventory: &Inventory, settings: &Settings) -> String {
    let most = settings.rays_per_pixel();
    let zones = 1 << settings.aa;
    let camera = match settings.allotment {
        Allotment::Adaptive => format!(
            "up to {} from the camera: {} to {most} a pixel, more where its neighbours differ by {}",
            thousands(inventory.camera_rays),
            settings.least_rays().min(most),
            settings.contrast
        ),
        Allotment::Even => format!(
            "{} from the camera: {most} a pixel ({zones} x {zones} zones, {} in each)",
            thousands(inventory.camera_rays),
            settings.samples
        ),
    };
    match inventory.lights_asked {
        0 => camera,
        asked => format!("{camera}; up to {asked} to lights from each point seen"),
    }
}

fn tree(statistics: &Statistics) -> String {
    format!(
        "{} nodes and {} leaves with {} references, {}",
        thousands(statistics.branches as u64),
        thousands(statistics.leaves as u64),
        thousands(statistics.references as u64),
        bytes(statistics.bytes),
    )
}

fn primitives(inventory: &Inventory) -> String {
    let PrimitiveCount { spheres, ellipsoids, triangles } = inventory.bounded;
    let counted = |count: usize, name: &str| match count {
        0 => None,
        1 => Some(format!("1 {name}")),
        _ => Some(format!("{} {name}s", thousands(count as u64))),
    };
    let kinds = [
        counted(spheres, "sphere"),
        counted(ellipsoids, "ellipsoid"),
        counted(triangles, "triangle"),
        counted(inventory.planes, "plane"),
    ];
    or_none(&kinds.into_iter().flatten().collect::<Vec<_>>())
}

fn textures(shading: &ShadingNeeds) -> String {
    match shading.textures.len() {
        0 => "none".to_owned(),
        _ => format!("{}, {}", shading.textures.join(", "), bytes(shading.texture_bytes)),
    }
}

fn or_none(names: &[String]) -> String {
    if names.is_empty() { "none".to_owned() } else { names.join(", ") }
}

/// What other scenes cost and this one does not.
fn left_out(inventory: &Inventory, settings: &Settings, shading: &ShadingNeeds) -> Vec<String> {
    let mut lines = Vec::new();
    if inventory.lights == 0 {
        lines.push("shadow rays: there are no lights, so the ambient light shows the scene".to_owned());
    } else if inventory.blockers.is_none() {
        let why = if inventory.glass { "nothing in the first is of glass" } else { "everything casts a shadow" };
        lines.push(format!("a second accelerator for shadows: {why}"));
    }
    if !inventory.lens {
        lines.push("samples on a lens: the camera is a pinhole".to_owned());
    }
    if settings.rays_per_pixel() == 1 {
        lines.push("random numbers in the pixel: its one ray goes through the centre".to_owned());
    }
    if shading.textures.is_empty() {
        lines.push("texture coordinates: nothing has a texture".to_owned());
    }
    if !shading.unused.is_empty() {
        lines.push(format!("shaders that no object uses: {}", shading.unused.join(", ")));
    }
    lines
}

/// 1234567 as 1,234,567.
fn thousands(number: u64) -> String {
    let digits = number.to_string();
    let mut grouped = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    grouped
}

fn bytes(count: usize) -> String {
    match count {
        0..10_000 => format!("{count} bytes"),
        10_000..10_000_000 => format!("{:.1} KiB", count as f64 / 1024.0),
        _ => format!("{:.1} MiB", count as f64 / (1024.0 * 1024.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_grouped_by_thousands() {
        assert_eq!([0, 999, 1000, 1_234_567].map(thousands), ["0", "999", "1,000", "1,234,567"]);
    }
}
