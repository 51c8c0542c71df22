//! Sections 4.2 and 4.3: buckets, threads and progress.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::{Condvar, Mutex};
use std::time::Duration;

use render::{Buckets, Crop, Modules, Settings, Shaders};
use shading::{Color, Shader, ShadingPoint};
use tests::Rendering;

use super::WHITE;

fn wall() -> Rendering {
    Rendering::flat(format!(
        "{WHITE} image {{ resolution 70 50 }} camera {{ type pinhole eye 0 0 0 target 0 1 0 up 0 0 1 fov 60 aspect 1.4 }}
         object {{ shader white type plane p 0 5 0 n 0 1 0 }}"
    ))
}

/// A shader that waits for company: its colour is white when two threads are in it at once, and black when nobody came.
struct Meeting;

static PRESENT: Mutex<u32> = Mutex::new(0);
static ARRIVAL: Condvar = Condvar::new();

impl Shader for Meeting {
    fn radiance(&self, _at: &ShadingPoint<'_>) -> Color {
        let mut present = PRESENT.lock().unwrap();
        *present += 1;
        ARRIVAL.notify_all();
        let (_present, waited) =
            ARRIVAL.wait_timeout_while(present, Duration::from_secs(20), |present| *present < 2).unwrap();
        if waited.timed_out() { Color::BLACK } else { Color::WHITE }
    }
}

#[test]
fn two_threads_work_on_two_buckets_at_once() {
    let shaders = Shaders { constant: |_| Box::new(Meeting), ..Shaders::default() };
    let meeting = Rendering { modules: Modules { shaders, ..Modules::default() }, ..wall() };
    // Two pixels, each a bucket of its own.
    let film = meeting.film_with(|settings| Settings {
        size: [2, 1],
        threads: NonZeroUsize::new(2),
        buckets: Buckets { size: 1, ..settings.buckets },
        ..settings
    });
    assert_eq!(film.pixels, [Color::WHITE; 2]);
}

/// The areas of the finished buckets, and what was told of the progress.
fn progress(settings: &Settings) -> Vec<(Crop, usize, usize)> {
    let assembled = wall().assemble();
    let told = Mutex::new(Vec::new());
    let film = render::render(&assembled.scene, settings, &|bucket| {
        assert_eq!(bucket.pixels.len(), (bucket.area.width * bucket.area.height) as usize);
        told.lock().unwrap().push((bucket.area, bucket.finished, bucket.total));
        ControlFlow::Continue(())
    });
    assert!(film.is_some());
    told.into_inner().unwrap()
}

#[test]
fn progress_counts_the_finished_buckets() {
    // 70 x 50 pixels in buckets of 16: 5 x 4.
    let settings = Settings { buckets: Buckets { size: 16, ..Buckets::default() }, ..wall().assemble().settings };
    let told = progress(&settings);
    let counts: Vec<_> = told.iter().map(|&(_, finished, total)| (finished, total)).collect();
    assert_eq!(counts, (1..=20).map(|finished| (finished, 20)).collect::<Vec<_>>());
}

#[test]
fn buckets_of_the_size_asked_for_cover_the_picture_once() {
    let settings = Settings { buckets: Buckets { size: 16, ..Buckets::default() }, ..wall().assemble().settings };
    let mut covered = vec![0; 70 * 50];
    for (area, ..) in progress(&settings) {
        assert!(area.width == 16 || area.x + area.width == 70, "{area:?}");
        assert!(area.height == 16 || area.y + area.height == 50, "{area:?}");
        for (x, y) in (area.y..area.y + area.height).flat_map(|y| (area.x..area.x + area.width).map(move |x| (x, y))) {
            covered[(y * 70 + x) as usize] += 1;
        }
    }
    assert!(covered.iter().all(|&times| times == 1));
}

#[test]
fn a_scene_says_its_bucket_size_and_order() {
    let text = wall().text + "bucket 48 \"reverse spiral\"";
    let buckets = Rendering::flat(text).assemble().settings.buckets;
    let order = scene_format::scene_file::BucketOrder::Spiral;
    assert_eq!(buckets, Buckets { size: 48, order, reversed: true });
}

#[test]
fn breaking_off_leaves_no_picture() {
    let assembled = wall().assemble();
    assert_eq!(render::render(&assembled.scene, &assembled.settings, &|_| ControlFlow::Break(())), None);
}

#[test]
fn what_a_scene_does_not_use_costs_no_rays() {
    let rays = wall().film().rays;
    assert_eq!((rays.camera, rays.secondary, rays.shadow), (70 * 50, 0, 0));
}
