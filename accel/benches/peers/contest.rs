//! Contestants take turns.

use std::hint::black_box;

use accel::Accelerator;
use cpu_time::ThreadTime;
use geometry::{Interval, Ray};

use crate::embree::{Embree, Packet};
use crate::tracer::Tracer;

/// What is asked of each ray.
#[derive(Clone, Copy)]
pub enum Ask {
    Closest,
    Any(Interval),
}

/// Traces rays; what it returns depends on all of them.
pub type Contestant<'a> = Box<dyn Fn(&[Ray]) -> f32 + 'a>;

/// One ray at a time.
pub fn single<'a>(tracer: &'a impl Tracer, ask: Ask) -> Contestant<'a> {
    match ask {
        Ask::Closest => Box::new(|rays| rays.iter().map(|ray| tracer.closest(ray).map_or(0.0, |hit| hit.1)).sum()),
        Ask::Any(within) => Box::new(move |rays| rays.iter().map(|ray| f32::from(tracer.any(ray, within))).sum()),
    }
}

/// A renderer's batches.
pub fn many(accelerator: &dyn Accelerator, ask: Ask) -> Contestant<'_> {
    const BATCH: usize = 256;
    match ask {
        Ask::Closest => Box::new(|rays| {
            let mut hits = [None; BATCH];
            let batch = |rays: &[Ray]| -> f32 {
                accelerator.closest_many(rays, &mut hits[..rays.len()]);
                hits[..rays.len()].iter().flatten().map(|hit| hit.t).sum()
            };
            rays.chunks(BATCH).map(batch).sum()
        }),
        Ask::Any(within) => Box::new(move |rays| {
            let mut found = [false; BATCH];
            let batch = |rays: &[Ray]| -> f32 {
                accelerator.any_many(rays, within, &mut found[..rays.len()]);
                found[..rays.len()].iter().map(|&found| f32::from(found)).sum()
            };
            rays.chunks(BATCH).map(batch).sum()
        }),
    }
}

/// Embree's packets of 16.
pub fn packets<'a>(embree: &'a Embree, ask: Ask) -> Contestant<'a> {
    match ask {
        Ask::Closest => Box::new(|rays| {
            let (mut packet, mut found) = (Packet::default(), [None; 16]);
            let mut sum = 0.0;
            for rays in rays.as_chunks().0 {
                embree.closest_16(&mut packet, rays, &mut found);
                sum += found.iter().flatten().map(|hit| hit.1).sum::<f32>();
            }
            sum
        }),
        Ask::Any(within) => Box::new(move |rays| {
            let (mut packet, mut found) = (Packet::default(), [false; 16]);
            let mut sum = 0.0;
            for rays in rays.as_chunks().0 {
                embree.any_16(&mut packet, rays, within, &mut found);
                sum += found.iter().map(|&found| f32::from(found)).sum::<f32>();
            }
            sum
        }),
    }
}

/// Rays for which two name different triangles, or do not agree on whether there is one.
pub fn differences(rays: &[Ray], ask: Ask, one: &dyn Tracer, other: &dyn Tracer) -> usize {
    let differ = |ray: &&Ray| match ask {
        Ask::Closest => one.closest(ray).map(|hit| hit.0) != other.closest(ray).map(|hit| hit.0),
        Ask::Any(within) => one.any(ray, within) != other.any(ray, within),
    };
    rays.iter().filter(differ).count()
}

const ROUNDS: usize = 21;

/// The seconds of each contestant on the processor: the median of some rounds, in each of which everyone traces all rays. Time that
/// other programs take is not counted; on a busy machine it doubled single ratios.
pub fn times(rays: &[Ray], contestants: &[Contestant]) -> Vec<f64> {
    let mut times = vec![Vec::new(); contestants.len()];
    for _ in 0..ROUNDS {
        for (contestant, times) in contestants.iter().zip(&mut times) {
            let start = ThreadTime::now();
            black_box(contestant(rays));
            times.push(start.elapsed().as_secs_f64());
        }
    }
    let median = |times: &mut Vec<f64>| {
        times.sort_by(f64::total_cmp);
        times[ROUNDS / 2]
    };
    times.iter_mut().map(median).collect()
}
