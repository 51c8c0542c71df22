use std::f64::consts::PI;

/// The share of a light's colour that arrives: `P / (4 pi d^2)`, its flux P spread over the sphere of radius d. Infinite at the light; right to 0.51 ulp.
pub fn inverse_square_falloff(distance: f32, power: f32) -> f32 {
    let distance = f64::from(distance);
    // f64::max turns a NaN, also that of 0 / 0, into 0.
    (f64::from(power) / (4.0 * PI * distance * distance)).max(0.0) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_twice_the_distance_a_quarter_arrives() {
        // 1000 / (4 pi 25) = 10 / pi
        assert!((inverse_square_falloff(5.0, 1000.0) - 3.183_099).abs() < 1e-6);
        assert_eq!(inverse_square_falloff(10.0, 1000.0) * 4.0, inverse_square_falloff(5.0, 1000.0));
    }
}
