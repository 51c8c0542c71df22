use super::implicit;
use glam::DVec3;

/// The edge of the cubes that the surface is found in: it makes some 70,000 triangles.
const CELL: f64 = 0.0595;

/// A sitting rabbit of smoothly joined blobs: about as many triangles as the famous bunny.
pub(super) fn scene() -> String {
    let low = DVec3::new(-1.45, -1.75, -0.15);
    let high = DVec3::new(1.45, 1.75, 4.45);
    let mesh = implicit::mesh(&rabbit, low, high, CELL);
    [include_str!("../../scenes/organic.sc"), &mesh.object("rabbit", "fur")].concat()
}

/// About the distance to the rabbit's surface, negative inside. It sits on z = 0 and looks along -y.
fn rabbit(at: DVec3) -> f64 {
    let mut distance = ellipsoid(at, [0.0, 0.22, 1.0], [0.92, 1.02, 1.0], 0.25);
    let mut join = |other: f64, softness: f64| distance = smooth_minimum(distance, other, softness);
    join(ellipsoid(at, [0.0, -0.3, 1.35], [0.66, 0.62, 0.85], 0.2), 0.35);
    join(ellipsoid(at, [0.0, -0.62, 2.38], [0.62, 0.66, 0.58], 0.15), 0.22);
    join(ellipsoid(at, [0.0, -1.12, 2.2], [0.3, 0.26, 0.24], 0.0), 0.2);
    join(ellipsoid(at, [0.0, 1.28, 0.62], [0.34, 0.34, 0.34], 0.0), 0.08);
    for side in [-1.0, 1.0] {
        let at = DVec3::new(at.x * side, at.y, at.z);
        join(ellipsoid(at, [0.74, 0.42, 0.68], [0.4, 0.72, 0.68], 0.0), 0.16);
        join(limb(at, [0.72, 0.2, 0.17], [0.78, -0.85, 0.15], [0.24, 0.2]), 0.14);
        join(limb(at, [0.42, -0.62, 1.25], [0.36, -0.98, 0.15], [0.24, 0.17]), 0.22);
        join(limb(at, [0.36, -0.98, 0.14], [0.37, -1.15, 0.13], [0.17, 0.17]), 0.1);
        join(ellipsoid(at, [0.24, -1.0, 2.14], [0.27, 0.26, 0.22], 0.0), 0.14);
        // One ear stands, the other one leans; both are hollow in front.
        let root = DVec3::new(0.27, -0.42, 2.75);
        let tip = if side > 0.0 { DVec3::new(0.5, -0.2, 4.1) } else { DVec3::new(0.86, -0.28, 3.92) };
        let ear = limb(at, root, tip, [0.15, 0.21]);
        let in_front = |share: f64, away: f64| root + (tip - root) * share - DVec3::Y * away;
        let hollow = limb(at, in_front(0.3, 0.22), in_front(0.85, 0.26), [0.1, 0.13]);
        join(-smooth_minimum(-ear, hollow, 0.08), 0.14);
    }
    distance
}

/// An ellipsoid whose upper end leans forward by `lean` for each unit of height. Close to its distance near its surface (Quilez,
/// "Ellipsoid SDF", 2008).
fn ellipsoid(at: DVec3, center: [f64; 3], radii: [f64; 3], lean: f64) -> f64 {
    let mut local = at - DVec3::from(center);
    local.y += lean * local.z;
    let radii = DVec3::from(radii);
    let (once, twice) = ((local / radii).length(), (local / (radii * radii)).length());
    if twice > 0.0 { once * (once - 1.0) / twice } else { -radii.min_element() }
}

/// A rod with round ends, whose radius changes evenly from one end to the other.
fn limb(at: DVec3, from: impl Into<DVec3>, to: impl Into<DVec3>, radii: [f64; 2]) -> f64 {
    let from = from.into();
    let along = to.into() - from;
    let share = ((at - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    (at - from - along * share).length() - (radii[0] + (radii[1] - radii[0]) * share)
}

/// The smaller of two distances, rounded off where they differ by less than `softness` (Quilez, "Smooth minimum", 2013).
fn smooth_minimum(a: f64, b: f64, softness: f64) -> f64 {
    let near = (softness - (a - b).abs()).max(0.0) / softness;
    a.min(b) - near * near * softness * 0.25
}
