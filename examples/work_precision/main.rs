//! Speed against error: the generated solver beside what else one can do, in one run.

mod dual;
mod error;
mod generated;
mod half_angle;
mod harness;
mod mechanisms;
mod newton;
mod number;
mod plane;
mod sine;
mod straightforward;
#[rustfmt::skip]
mod truth;
mod tuned;

use generated as g;
use half_angle::HalfAngle;
use harness::{Race, latency, throughput};
use mechanisms::{FOUR_BAR, four_bar};
use straightforward::Straightforward;
use tuned::Tuned;

fn angles(n: usize) -> Vec<f64> {
    let mut state = 12345_u64;
    (0..n)
        .map(|_| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1u64 << 53) as f64 * std::f64::consts::TAU
        })
        .collect()
}

fn main() {
    let (w, al) = (250.0, 1000.0);
    let solver = g::FourBar::new();
    let comp = g::FourBarCompensated::new();
    let point = g::CouplerPoint::new();
    let a = || angles(512);
    let mut race = Race::default();
    race.enter(
        "straightforward",
        throughput(a(), move |t| four_bar::<Straightforward, f64>([t, w, al])),
    );
    race.enter(
        "tuned",
        throughput(a(), move |t: f64| tuned::four_bar(number::Number::sin_cos_by_hand(t), [w, al])),
    );
    race.enter("tuned generic", throughput(a(), move |t: f64| four_bar::<Tuned, f64>([t, w, al])));
    race.enter("half angle", throughput(a(), move |t| four_bar::<HalfAngle, f64>([t, w, al])));
    race.enter("dual", throughput(a(), move |t| dual::four_bar::<f64>([t, w, al])));
    race.enter("generated", throughput(a(), move |t| solver.motion(t, w, al)));
    race.enter("generated comp", throughput(a(), move |t| comp.motion(t, w, al)));
    race.enter("generated P", throughput(a(), move |t| point.motion(t, w, al)));
    race.enter(
        "generated at",
        throughput(a(), move |t| solver.motion_at(t * 0.5, 0.866 * t, w, al)),
    );
    race.enter("sincos std", throughput(a(), move |t| t.sin_cos()));
    race.enter("sincos by hand", throughput(a(), move |t: f64| number::Number::sin_cos_by_hand(t)));
    for t in race.run(2001, |_| ()) {
        println!("{:20} {:7.3} {:8.2}", t.name, t.ratio, t.nanoseconds);
    }
    let mut race = Race::default();
    let last = |r: &Option<[f64; 14]>| r.map_or(0.0, |r| r[10] + r[11]);
    race.enter(
        "straightforward",
        latency(a(), move |t| four_bar::<Straightforward, f64>([t, w, al]), last),
    );
    race.enter(
        "tuned",
        latency(
            a(),
            move |t: f64| tuned::four_bar(number::Number::sin_cos_by_hand(t), [w, al]),
            last,
        ),
    );
    race.enter(
        "tuned generic",
        latency(a(), move |t: f64| four_bar::<Tuned, f64>([t, w, al]), last),
    );
    race.enter("half angle", latency(a(), move |t| four_bar::<HalfAngle, f64>([t, w, al]), last));
    race.enter("dual", latency(a(), move |t| dual::four_bar::<f64>([t, w, al]), last));
    race.enter(
        "generated",
        latency(
            a(),
            move |t| solver.motion(t, w, al),
            |r| r.map_or(0.0, |r| r.acceleration.P.x + r.acceleration.P.y),
        ),
    );
    for t in race.run(2001, |_| ()) {
        println!("{:20} {:7.3} {:8.2}", t.name, t.ratio, t.nanoseconds);
    }
    println!("{:?}", error::errors::<f64, 14>(&FOUR_BAR, |x| four_bar::<Straightforward, f64>(x)));
    println!(
        "{:?}",
        error::errors::<f64, 14>(&FOUR_BAR, |[t, w, al]| tuned::four_bar(
            number::Number::sin_cos_by_hand(t),
            [w, al]
        ))
    );
    println!("{:?}", error::errors::<f64, 14>(&FOUR_BAR, |x| four_bar::<HalfAngle, f64>(x)));
    println!("{:?}", error::errors::<f64, 14>(&FOUR_BAR, |x| dual::four_bar(x)));
    println!(
        "{:?}",
        error::errors::<f64, 14>(&FOUR_BAR, |[t, w, al]| solver
            .motion(t, w, al)
            .ok()
            .map(|m| g::four_bar(&m)))
    );
    println!(
        "{:?}",
        error::errors::<f64, 14>(&FOUR_BAR, |[t, w, al]| comp
            .motion(t, w, al)
            .ok()
            .map(|m| g::four_bar_compensated(&m)))
    );
}
