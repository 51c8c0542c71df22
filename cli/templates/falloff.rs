//! How does light fall off with the distance?

/// The share of a light's colour that arrives, from the distance (0 or greater) and the light's power.
///
/// A stub: nothing arrives.
pub fn falloff(_distance: f32, _power: f32) -> f32 {
    0.0
}
