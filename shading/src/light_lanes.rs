use geometry::Ray;
use glam::Vec3;

use crate::{
    Facing, Incident, LightFormula, PointLight,
    light_formula::{Aim, arriving},
};

/// Points turned to their viewers, one in each lane: a row of numbers for each coordinate.
#[derive(Clone, Copy, Debug)]
pub struct FacingLanes<const N: usize> {
    position: [[f32; N]; 3],
    start: [[f32; N]; 3],
    normal: [[f32; N]; 3],
    outward: [[f32; N]; 3],
}

impl<const N: usize> FacingLanes<N> {
    /// No points yet.
    pub const NONE: Self =
        Self { position: [[0.0; N]; 3], start: [[0.0; N]; 3], normal: [[0.0; N]; 3], outward: [[0.0; N]; 3] };

    /// Puts a point into a lane.
    #[inline]
    pub fn put(&mut self, lane: usize, point: &Facing) {
        let rows = [&mut self.position, &mut self.start, &mut self.normal, &mut self.outward];
        for (rows, vector) in rows.into_iter().zip([point.position, point.start, point.normal, point.outward]) {
            [rows[0][lane], rows[1][lane], rows[2][lane]] = vector.to_array();
        }
    }

    /// The point in a lane.
    #[inline(always)]
    fn lane(&self, lane: usize) -> Facing {
        let at = |rows: &[[f32; N]; 3]| Vec3::new(rows[0][lane], rows[1][lane], rows[2][lane]);
        Facing {
            position: at(&self.position),
            start: at(&self.start),
            normal: at(&self.normal),
            outward: at(&self.outward),
        }
    }
}

impl LightFormula {
    /// As [`Self::arriving`], bit for bit, at the points in the first `count` of the lanes (all of them at most), each from a light of its own:
    /// `arrives` is told the lane and what arrives there.
    #[inline]
    pub fn arriving_lanes<'a, const N: usize>(
        self,
        at: &FacingLanes<N>,
        count: usize,
        light: impl Fn(usize) -> &'a PointLight,
        mut arrives: impl FnMut(usize, Incident, Ray),
    ) {
        let (mut distances, mut cosines, mut directions) = ([0.0; N], [0.0; N], [[0.0; N]; 3]);
        let mut are_in_front = [0; N];
        // A loop that the compiler makes vectors of.
        for lane in 0..N {
            let aim = self.aim(&at.lane(lane), light(lane).position);
            (distances[lane], cosines[lane]) = (aim.distance, aim.cosine);
            [directions[0][lane], directions[1][lane], directions[2][lane]] = aim.direction.to_array();
            are_in_front[lane] = u32::from(aim.is_in_front);
        }
        for lane in 0..count {
            let aim = Aim {
                distance: distances[lane],
                direction: Vec3::new(directions[0][lane], directions[1][lane], directions[2][lane]),
                cosine: cosines[lane],
                is_in_front: are_in_front[lane] != 0,
            };
            if let Some((incident, segment)) = arriving(at.lane(lane).start, light(lane), aim) {
                arrives(lane, incident, segment);
            }
        }
    }
}
