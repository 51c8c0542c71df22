//! Our FLIP against what its authors' program, as the crate nv-flip 0.1.2 carries it, says of small pictures. `nv_flip.rs` runs that program itself.

mod pairs;

use cli::metrics::{MetricError, PIXELS_PER_DEGREE, flip};
use pairs::{Pair, generated};

/// What the program gave at 67 pixels a degree: the pair's name, the mean, the pixel in the middle.
const AUTHORS: [(&str, f64, f64); 9] = [
    ("white, black", 0.967391849, 0.9673918),
    ("green, blue", 1.000000000, 1.0000000),
    ("two greys", 0.029868808, 0.0298688),
    ("a shifted edge", 0.101894376, 0.4523952),
    ("a firefly", 0.051550344, 0.7561018),
    ("stripes", 0.454016639, 0.2360810),
    ("other colours", 0.748179793, 0.8390581),
    ("noise on colours", 0.476627545, 0.4429460),
    ("noise, other noise", 0.459106021, 0.2939971),
];

#[test]
fn flip_is_what_its_authors_found() {
    let pairs = generated();
    assert_eq!(pairs.len(), AUTHORS.len());
    for (Pair { name, reference, test, tolerance }, (of, mean, middle)) in pairs.iter().zip(AUTHORS) {
        assert_eq!(name, of);
        let map = flip(&reference.film(), &test.film(), PIXELS_PER_DEGREE).unwrap();
        let in_middle = map.errors[map.errors.len() / 2];
        assert!((map.mean() - mean).abs() <= tolerance.mean, "{name}: mean {}, not {mean}", map.mean());
        assert!((in_middle - middle).abs() <= tolerance.pixel, "{name}: middle {in_middle}, not {middle}");
    }
}

#[test]
fn which_picture_is_the_reference_makes_no_difference() {
    for Pair { name, reference, test, .. } in generated() {
        let [one, other] = [reference.film(), test.film()];
        assert_eq!(flip(&one, &other, PIXELS_PER_DEGREE), flip(&other, &one, PIXELS_PER_DEGREE), "{name}");
    }
}

#[test]
fn equal_pictures_do_not_differ_and_no_error_leaves_its_range() {
    for Pair { name, reference, test, .. } in generated() {
        let [one, other] = [reference.film(), test.film()];
        assert_eq!(flip(&one, &one, PIXELS_PER_DEGREE).unwrap().mean(), 0.0, "{name}");
        let errors = flip(&one, &other, PIXELS_PER_DEGREE).unwrap().errors;
        assert!(errors.iter().all(|error| (0.0..=1.0).contains(error)), "{name}");
    }
}

/// A difference in one pixel is the less visible, the finer the screen: its blur is spread over more of them.
#[test]
fn a_firefly_is_less_seen_on_a_finer_screen() {
    let pair = generated().into_iter().find(|pair| pair.name == "a firefly").unwrap();
    let at = |ppd| {
        let errors = flip(&pair.reference.film(), &pair.test.film(), ppd).unwrap().errors;
        errors[errors.len() / 2]
    };
    assert!(at(20.0) > at(67.0) && at(67.0) > at(300.0));
}

#[test]
fn what_cannot_be_compared_is_told() {
    let [one, other] = [&generated()[0], &generated()[1]].map(|pair| pair.reference.film());
    let sizes = MetricError::DifferentSizes { one: [1, 1], other: [3, 2] };
    assert_eq!(flip(&one, &other, PIXELS_PER_DEGREE), Err(sizes));
    for nonsense in [0.0, -67.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(flip(&one, &one, nonsense), Err(MetricError::PixelsPerDegree(_))), "{nonsense}");
    }
}
