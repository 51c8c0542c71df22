use glam::DVec2;

/// Where a pixel lies in what the camera sees.
///
/// ```text
///   0     1     2     3     4   pixels from the left, of a picture 4 wide
///   +-----+-----+-----+-----+
///   0          0.5          1   between edges
///   0           |     1         Sunflow's: a pixel's width beyond the view, and off its middle by half a pixel
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Raster {
    /// The picture's edges are those of the view.
    #[default]
    BetweenEdges,
    /// Counted from the lower left corner, the view ends a pixel before the picture's right and upper edge: Sunflow divides by W - 1 and
    /// H - 1, yet takes pixels at their centres. A picture to be compared with its pictures must do the same.
    Sunflow,
}

impl Raster {
    /// The camera's x and y, both 0 to 1, from the lower left, of a place in pixels, from the upper left.
    pub(crate) fn film(self, place: DVec2, size: [u32; 2]) -> DVec2 {
        let size = DVec2::new(f64::from(size[0]), f64::from(size[1]));
        match self {
            Self::BetweenEdges => {
                let place = place / size;
                DVec2::new(place.x, 1.0 - place.y)
            }
            // A picture of one pixel has no last one to divide by.
            Self::Sunflow => DVec2::new(place.x, size.y - place.y) / (size - DVec2::ONE).max(DVec2::ONE),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pictures_edges_are_those_of_the_view() {
        let film = |x, y| Raster::BetweenEdges.film(DVec2::new(x, y), [4, 2]);
        assert_eq!([film(0.0, 0.0), film(4.0, 2.0)], [DVec2::Y, DVec2::X]);
    }

    /// A number for every place, and NaN for what is none: the camera makes a ray of it that meets nothing.
    #[test]
    fn every_picture_size_has_its_places() {
        for size in [[1, 1], [1, u32::MAX], [u32::MAX, u32::MAX]] {
            for raster in [Raster::BetweenEdges, Raster::Sunflow] {
                assert!(raster.film(DVec2::splat(0.5), size).is_finite());
                assert!(raster.film(DVec2::NAN, size).is_nan());
            }
        }
    }

    #[test]
    fn sunflow_counts_pixel_centres_from_the_lower_left_over_one_pixel_less() {
        // The pixel at the upper left of 5 x 3 is x + 0.5 = 0.5 from the left and y + 0.5 = 2.5 from the bottom.
        assert_eq!(Raster::Sunflow.film(DVec2::splat(0.5), [5, 3]), DVec2::new(0.5 / 4.0, 2.5 / 2.0));
        assert_eq!(Raster::Sunflow.film(DVec2::splat(0.5), [1, 1]), DVec2::splat(0.5));
    }
}
