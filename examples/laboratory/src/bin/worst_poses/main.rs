//! Searches every group for the pose at which its answer is worst against what the data allow:
//! random poses first, then uphill from the worst of them.
//!
//! `cargo run --release -p laboratory --bin worst_poses [poses] [seed] [motion, forces]`, ten million poses a group by
//! default. The same seed gives the same poses and the same climb; the two widths are searched side
//! by side.

use std::thread;
use std::time::Instant;

use linkage_tests::measured::poses::{self, Source};
use linkage_tests::measured::{Measured, Pose, Width, compensated_rrr, prp, rpp, rpr, rrp, rrr};
use linkage_tests::measured::{prp_forces, rpp_forces, rpr_forces, rrp_forces, rrr_forces};

/// The number of the worst random poses from which the search climbs, and the number of steps from each.
const STARTS: usize = 16;
const STEPS: usize = 20_000;

const ORDERS: [&str; 3] = ["position", "velocity", "acceleration"];
const FORCES: [&str; 3] = ["statics", "", "forces"];

/// A pose and the ratio of error to achievable error there.
type Found<const I: usize, const P: usize> = (f64, Pose<I, P>);

fn main() {
    let mut arguments = std::env::args().skip(1);
    let count =
        arguments.next().map_or(10_000_000, |text| text.parse().expect("a number of poses"));
    let seed = arguments.next().map_or(1, |text| text.parse().expect("a seed"));
    let only = arguments.next();
    let is_asked = |part: &str| only.as_deref().is_none_or(|only| only == part);
    let (motion, forces) = (is_asked("motion"), is_asked("forces"));
    println!("{count} poses a group and width, seed {seed}; error over achievable error\n");
    println!("group    width   order         random  climbed  at");
    let start = Instant::now();
    thread::scope(|scope| {
        for width in [Width::Double, Width::Single] {
            scope.spawn(move || {
                if motion {
                    search_motion(width, count, seed);
                }
                if forces {
                    search_forces(width, count, seed);
                }
            });
        }
    });
    println!("\n{:.0} s", start.elapsed().as_secs_f64());
}

macro_rules! every {
    ($orders:ident, $width:ident, $count:ident, $seed:ident: $($group:literal $draw:ident $measure:ident)*) => {
        $(search(($group, $orders), $width, $count, $seed, poses::$draw, |pose| {
            $measure::measure(pose, $width).map(ratios)
        });)*
    };
}

/// Every group in one width, and the bars once more with numbers carried to twice the width.
fn search_motion(width: Width, count: usize, seed: u64) {
    every! {
        ORDERS, width, count, seed:
        "rrr" rrr rrr "carried" rrr compensated_rrr "rrp" rrp rrp "rpr" rpr rpr "prp" prp prp "rpp" rpp rpp
    }
}

/// The reactions of every group in one width, at rest and in motion.
fn search_forces(width: Width, count: usize, seed: u64) {
    every! {
        FORCES, width, count, seed:
        "rrr" rrr rrr_forces "rrp" rrp rrp_forces "rpr" rpr rpr_forces "prp" prp prp_forces "rpp" rpp rpp_forces
    }
}

/// The worst ratio of each order. A number that is not finite has left the range and is no error:
/// a single-precision acceleration at 1e-15 from a toggle is beyond its largest number.
fn ratios<const ROWS: usize>(orders: [[Measured; ROWS]; 3]) -> [f64; 3] {
    orders.map(|rows| {
        let ratios = rows.iter().map(|row| row.ratio()).filter(|ratio| ratio.is_finite());
        ratios.fold(0.0, f64::max)
    })
}

fn search<const I: usize, const P: usize>(
    (group, orders): (&str, [&str; 3]),
    width: Width,
    count: usize,
    seed: u64,
    draw: impl Fn(&mut Source) -> Pose<I, P>,
    measure: impl Fn(&Pose<I, P>) -> Option<[f64; 3]>,
) {
    let mut source = Source::new(seed);
    let mut worst: [Vec<Found<I, P>>; 3] = Default::default();
    for _ in 0..count {
        let pose = draw(&mut source).rounded(width);
        let Some(ratios) = measure(&pose) else { continue };
        for (kept, ratio) in worst.iter_mut().zip(ratios) {
            if kept.len() < STARTS || kept.last().is_some_and(|last| ratio > last.0) {
                kept.truncate(STARTS - 1);
                let place = kept.partition_point(|other| other.0 >= ratio);
                kept.insert(place, (ratio, pose));
            }
        }
    }
    for (order, starts) in worst.iter().enumerate() {
        let Some(random) = starts.first().filter(|_| !orders[order].is_empty()) else { continue };
        let climbs = starts.iter().map(|start| {
            climb(&mut source, *start, width, |pose| measure(pose).map(|ratios| ratios[order]))
        });
        let best = climbs.fold(*random, |best, next| if next.0 > best.0 { next } else { best });
        println!(
            "{group:8} {:7} {:13} {:6.2} {:8.2}  {:?}",
            format!("{width:?}"),
            orders[order],
            random.0,
            best.0,
            best.1
        );
    }
}

/// Uphill by random changes of one number or all of them, from a last place to a hundredth.
fn climb<const I: usize, const P: usize>(
    source: &mut Source,
    start: Found<I, P>,
    width: Width,
    measure: impl Fn(&Pose<I, P>) -> Option<f64>,
) -> Found<I, P> {
    let mut best = start;
    for _ in 0..STEPS {
        let mut pose = best.1;
        let size = source.magnitude(-17.0, -2.0);
        let numbers = pose.q.iter_mut().chain(&mut pose.rate).chain(&mut pose.second);
        let numbers: Vec<&mut f64> = numbers.chain(&mut pose.params).collect();
        let only = source.coin().then(|| (source.unit() * numbers.len() as f64) as usize);
        for (place, number) in numbers.into_iter().enumerate() {
            if only.is_none_or(|only| only == place) {
                *number *= 1.0 + size * source.between(-1.0, 1.0);
            }
        }
        let pose = pose.rounded(width);
        if let Some(ratio) = measure(&pose).filter(|ratio| *ratio > best.0) {
            best = (ratio, pose);
        }
    }
    best
}
