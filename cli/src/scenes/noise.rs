use glam::DVec3;

/// Smooth noise in space, -1..1: random values at the points of the integer lattice, blended by a quintic curve (Perlin,
/// "Improving Noise", 2002).
pub(super) fn noise(at: DVec3) -> f64 {
    let cell = at.floor();
    let blend = (at - cell).to_array().map(|t| t * t * t * (t * (t * 6.0 - 15.0) + 10.0));
    let mut sum = 0.0;
    for corner in 0..8_u32 {
        let offset = [corner & 1, corner >> 1 & 1, corner >> 2 & 1];
        let weight: f64 = (0..3).map(|axis| if offset[axis] == 1 { blend[axis] } else { 1.0 - blend[axis] }).product();
        let [x, y, z] = (cell + DVec3::from(offset.map(f64::from))).to_array().map(|c| c as i32 as u32);
        sum += weight * (f64::from(hash(x, y, z)) / f64::from(u32::MAX) * 2.0 - 1.0);
    }
    sum
}

/// Several octaves of noise, each half as strong and twice as fine as the one before; about -1..1.
pub(super) fn fractal(at: DVec3, octaves: u32) -> f64 {
    let (mut sum, mut strength, mut at) = (0.0, 0.5, at);
    for _ in 0..octaves {
        sum += strength * noise(at);
        strength *= 0.5;
        at = at * 2.03 + DVec3::splat(17.3);
    }
    sum
}

/// Scrambles three integers into one, the same on every machine.
pub(super) fn hash(x: u32, y: u32, z: u32) -> u32 {
    let mut h = x.wrapping_mul(0x8da6_b343) ^ y.wrapping_mul(0xd816_3841) ^ z.wrapping_mul(0xcb1a_b31f);
    h = (h ^ h >> 16).wrapping_mul(0x7feb_352d);
    h = (h ^ h >> 15).wrapping_mul(0x846c_a68b);
    h ^ h >> 16
}
