//! The bound on functions made to break it, and what the public search refuses.

mod refused;
mod seeded;
mod several;

use super::*;
use crate::cases::cases;

/// SplitMix64.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.unit() * choices.len() as f64) as usize]
    }
}

/// A function with its root at `root`: steps, powers from the fiftieth part to the 31st, all
/// derivatives zero, noise, and almost a step.
fn adversary(kind: usize, power: f64, root: f64, noise: f64, x: f64) -> f64 {
    let (sign, away) = (
        if x > root {
            1.0
        } else if x < root {
            -1.0
        } else {
            0.0
        },
        (x - root).abs(),
    );
    match kind {
        0 => sign,
        1 => sign * away.powf(power),
        2 => sign * if away > 2e-3 { (-1.0 / away).exp() } else { 1e-300 },
        3 => sign * (1.0 + noise),
        _ => (1e6 * (x - root)).tanh(),
    }
}

#[test]
fn the_bound_holds_whatever_values_and_slopes_are() {
    let mut random = Random(1);
    let (mut most, mut right, mut count) = (0, 0, 0);
    while count < 20_000 {
        let [p, q] = [random.between(-3.0, 3.0), random.between(-3.0, 3.0)];
        let [a, b] = [p.min(q), p.max(q)];
        let near_end = random.unit() > 0.7;
        let part = if near_end { 10_f64.powf(random.between(-15.0, -1.0)) } else { random.unit() };
        let root = a + (b - a) * part;
        let kind = (random.unit() * 5.0) as usize;
        let power = random.of(&[0.02, 0.2, 1.0, 3.0, 9.0, 31.0]);
        let ends = [a, b].map(|x| adversary(kind, power, root, 0.0, x));
        if b - a < 1e-3 || !(ends[0] < 0.0 && ends[1] > 0.0) {
            continue;
        }
        let mut calls = 0;
        let found = Search::new([a, b], Trend::Rising).find(|x| {
            calls += 1;
            let lie = random.of(&[1.0, -1.0, 0.0, 1e-9, 1e9, f64::INFINITY, f64::NAN]);
            [adversary(kind, power, root, random.unit(), x), lie * random.between(0.1, 10.0)]
        });
        count += 1;
        most = most.max(calls);
        let found = found.expect("the signs differ");
        assert_eq!(found.evaluations, calls);
        assert!(a <= found.at && found.at <= b);
        right += usize::from((found.at - root).abs() <= 4.0 * f64::EPSILON * a.abs().max(b.abs()));
    }
    std::println!("{most} evaluations, {right} of {count} right");
    assert!(most <= Search::<f64>::MOST);
    // Three in seven of the slopes are steeper than any true one, or none, and half of the others
    // may end a search too early; what tells is that bisection goes on where slopes are no guide.
    assert!(right > count / 2);
}

#[test]
fn the_bounds_are_those_of_the_documentation() {
    assert_eq!((Search::<f64>::MOST, Search::<f32>::MOST), (61, 32));
}

/// Slopes that are right, however flat or steep the root is: a sample of the roots of `.ci/nightly`.
#[test]
fn roots_of_every_shape_are_found() {
    let mut random = Random(2);
    let mut most = [0, 0];
    for _ in 0..cases(6000, 20_000) {
        let [a, b] = [random.between(-3.0, 0.0), random.between(0.1, 3.0)];
        let root = a + (b - a) * random.between(0.01, 0.99);
        let power = random.of(&[0.3, 0.6, 1.0, 1.7, 3.0, 9.0]);
        let steep = 10_f64.powf(random.between(-3.0, 6.0));
        let is_step = random.unit() < 0.3;
        let f = |x: f64| {
            let (away, y) = (x - root, steep * (x - root));
            let (sign, size) = (away.signum(), away.abs());
            match is_step {
                true => [y.tanh(), steep / (y.cosh() * y.cosh())],
                false => [sign * steep * size.powf(power), steep * power * size.powf(power - 1.0)],
            }
        };
        let found = Search::new([a, b], Trend::Rising).find(f).expect("the signs differ");
        most[0] = most[0].max(found.evaluations);
        let (error, larger) = ((found.at - root).abs(), b.max(-a));
        // Where f underflows or is flat to its rounding there is nothing to tell it from zero; the
        // ninth power is below its own size at the end times ε² within 1e-3 of the root.
        let allowed = if is_step || power < 2.0 { 4.0 * larger * f64::EPSILON } else { 1e-3 };
        assert!(error <= allowed, "{power} {steep:e} {is_step}: {error:e} {found:?}");
        let [a, b] = [a as f32, b as f32];
        let single = |x: f32| f(x.into()).map(|y| y as f32);
        let found = Search::new([a, b], Trend::Rising).find(single).expect("the signs differ");
        most[1] = most[1].max(found.evaluations);
        let error = (f64::from(found.at) - root).abs();
        let unit = larger * f64::from(f32::EPSILON);
        let allowed = if is_step || power < 2.0 { 4.0 * unit } else { 0.1 };
        assert!(error <= allowed, "{power} {steep:e} {is_step}: {error:e} {found:?}");
    }
    std::println!("{most:?} evaluations");
    assert!(most[0] <= Search::<f64>::MOST && most[1] <= Search::<f32>::MOST);
}

#[test]
fn intervals_of_any_size_are_searched() {
    let least = f64::from_bits(1);
    for [a, b] in [
        [0.0, least],
        [-least, least],
        [1.0, 1.0_f64.next_up()],
        [-8e307, 8e307],
        [1e300, 1.0000001e300],
        [-1e-310, 3e-310],
        [-1e-3, 1e300],
        [0.0, f64::MIN_POSITIVE],
    ] {
        let root = a / 3.0 + b / 3.0 * 2.0;
        let mut calls = 0;
        let found = Search::new([a, b], Trend::Falling).find(|x| {
            calls += 1;
            let sign = if x > a && x >= root { -1.0 } else { 1.0 };
            [sign * ((x - root).abs() / b + 1e-300), -1.0 / b]
        });
        let found = found.expect("the signs differ").at;
        assert!(a <= found && found <= b);
        assert!((found - root).abs() <= f64::EPSILON * b.max(-a) + 2.0 * least, "{a} {b} {found}");
        assert!(calls <= Search::<f64>::MOST);
    }
}

#[test]
fn ends_that_are_no_interval_are_refused() {
    let nan = f64::NAN;
    for between in [
        [1.0, 0.0],
        [1.0, 1.0],
        [nan, 1.0],
        [0.0, nan],
        [nan, nan],
        [f64::NEG_INFINITY, 0.0],
        [0.0, f64::INFINITY],
        [f64::INFINITY, f64::INFINITY],
        [-1.7e308, 1.7e308],
    ] {
        let found = Search::new(between, Trend::Rising).find(|_| panic!("nothing to evaluate"));
        assert!(matches!(found, Err(FindError::Interval { .. })), "{between:?} {found:?}");
        let near = Search::new(between, Trend::Rising).near(0.5);
        assert!(near.find(|_| panic!("nothing to evaluate")).is_err());
    }
}

#[test]
fn what_is_no_number_is_an_error_where_it_is_met() {
    let search = Search::new([0.0, 2.0], Trend::Rising);
    for (low, high) in [(f64::NAN, 2.0), (f64::INFINITY, 2.0), (0.0, f64::NAN)] {
        let at = if low.is_finite() { 2.0 } else { 0.0 };
        let value = |x: f64| if x == 0.0 { low - 1.0 } else { high - 1.0 };
        assert_eq!(search.find(|x| [value(x), 1.0]), Err(FindError::NotFinite { at }));
    }
    // In between it is met at a trial.
    let found = search.find(|x| [if x == 1.0 { f64::NAN } else { x - 1.0 }, 1.0]);
    assert_eq!(found, Err(FindError::NotFinite { at: 1.0 }));
    // A seed that meets it is left aside.
    let found = search.near(0.5).find(|x| [if x == 0.5 { f64::NAN } else { x - 1.25 }, 1.0]);
    assert_eq!(found.map(|root| root.at), Ok(1.25));
    // Slopes that are not finite, or have the wrong sign, are ignored and cause no error.
    for slope in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 0.0] {
        let root = search.find(|x| [x - 0.3, slope]).expect("the signs differ");
        assert!((root.at - 0.3).abs() <= 2.0 * f64::EPSILON, "{slope} {root:?}");
    }
}

#[test]
fn an_end_is_the_root_within_the_slack() {
    let line = |x: f64| [x - 1.0, 1.0];
    let missing = |at, by| Err(FindError::NoSolution { at, by, other: None });
    let at = |between| Search::new(between, Trend::Rising).find(line).map(|root| root.at);
    assert_eq!(at([1.0, 2.0]), Ok(1.0));
    assert_eq!(at([0.0, 1.0]), Ok(1.0));
    assert_eq!(at([1.5, 2.0]), missing(1.5, 0.5));
    assert_eq!(at([0.0, 0.75]), missing(0.75, 0.25));
    let slack = Search::new([1.5, 2.0], Trend::Rising).slack(0.5);
    assert_eq!(slack.find(line).map(|root| root.at), Ok(1.5));
    let slack = Search::new([1.5, 2.0], Trend::Rising).slack(0.49);
    assert!(slack.find(line).is_err());
    // The wrong trend: both ends miss, and the nearer one is told, with the root that there is.
    let other = Some(Crossing { trend: Trend::Rising, at: 1.0 });
    for (between, at, by) in [([0.5, 2.0], 0.5, 0.5), ([0.0, 1.75], 1.75, 0.75)] {
        let falling = Search::new(between, Trend::Falling).find(line);
        assert_eq!(falling, Err(FindError::NoSolution { at, by, other }));
    }
}

/// A parabola, and the root of the wanted trend where both are between the ends.
#[test]
fn a_dead_point_between_the_ends_separates_the_trends() {
    let parabola = |x: f64| [x * x - 1.0, 2.0 * x];
    let at = |between, trend| Search::new(between, trend).find(parabola).map(|root| root.at);
    assert_eq!(at([-2.0, 2.0], Trend::Rising), Ok(1.0));
    assert_eq!(at([-2.0, 3.0], Trend::Falling), Ok(-1.0));
    // Also where the root of the other trend is an end.
    assert_eq!(at([-1.0, 2.0], Trend::Rising), Ok(1.0));
    assert_eq!(at([-2.0, 1.0], Trend::Falling), Ok(-1.0));
    assert_eq!(at([1.0, 2.0], Trend::Rising), Ok(1.0));
    assert_eq!(at([-2.0, -1.0], Trend::Falling), Ok(-1.0));
    // One that touches zero, and one that does not come near.
    let touching = |x: f64| [x * x, 2.0 * x];
    let found = Search::new([-1.0, 2.0], Trend::Rising).find(touching).expect("it touches");
    assert!(found.at.abs() < 1e-9, "{found:?}");
    let above = Search::new([-1.0, 2.0], Trend::Rising).find(|x: f64| [x * x + 0.25, 2.0 * x]);
    match above {
        Err(FindError::NoSolution { at, by, other: None }) => {
            assert!(at.abs() < 1e-9 && by == 0.25, "{at} {by}");
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_seed_does_not_lead_beyond_the_ends() {
    // Beyond the upper end by less than the tolerance of the larger, lower one.
    let beyond = 1.0 + 2.0 * f64::EPSILON;
    let search = Search::new([-4.0, 1.0], Trend::Rising).near(1.0);
    let found = search.find(|x| [x - beyond, 1.0]);
    let by = 2.0 * f64::EPSILON;
    assert_eq!(found, Err(FindError::NoSolution { at: 1.0, by, other: None }));
}

/// Where there is no slope to go by and the last bracket is two neighbours, the better of them.
#[test]
fn of_the_last_bracket_the_end_with_less_left_is_the_root() {
    for (low, high) in [(1e-9, 1.0), (1.0, 1e-9)] {
        let step = |x: f64| [if x < 0.7 { -low } else { high }, 0.0];
        let root = Search::new([0.0, 1.0], Trend::Rising).find(step).expect("the signs differ");
        assert_eq!(root.at < 0.7, low < high, "{root:?}");
        assert!((root.at - 0.7).abs() <= 2.0 * f64::EPSILON, "{root:?}");
    }
}

/// The first trial is right relative to the distance from the nearer end, on either side.
#[test]
fn a_search_begins_at_the_root_of_the_cubic() {
    for away in [1e-15, 1e-9, 1e-3, 0.4] {
        // (3 − 2u) u² has double roots of its slope at both ends.
        let smooth = |u: f64| (3.0 - 2.0 * u) * u * u;
        let [a, b] =
            [(0.0, -away), (1.0, 1.0 - away)].map(|(x, value)| At { x, value, slope: 0.0 });
        let found = start::cubic([a, b]);
        assert!((smooth(found) - away).abs() <= 0.01 * away, "{away} {found}");
        let [a, b] = [(2.0, away - 1.0), (3.0, away)].map(|(x, value)| At { x, value, slope: 0.0 });
        let found = 3.0 - start::cubic([a, b]);
        // Three itself has a last place.
        let allowed = 0.01 * away + 4.0 * f64::EPSILON * away.sqrt() * 3.0;
        assert!((smooth(found) - away).abs() <= allowed, "{away} {found}");
    }
    // Without slopes it is the root of the line.
    let ends = [(0.0, -1.0), (1.0, 3.0)].map(|(x, value)| At { x, value, slope: f64::INFINITY });
    assert_eq!(start::cubic(ends), 0.25);
}

/// The slope's root, as right as a root is.
#[test]
fn a_lowest_point_is_found_to_its_last_places() {
    let mut random = Random(3);
    let mut most = 0;
    for _ in 0..1000 {
        let (place, skew) = (random.between(-0.5, 0.5), random.between(-0.1, 0.1));
        let f = |x: f64| {
            let away = x - place;
            let value = 1.0 - away.cos() + skew * away * away * away;
            At { x, value, slope: away.sin() + 3.0 * skew * away * away }
        };
        let mut calls = 0;
        let found = lowest([f(-1.0), f(0.9)], -1.0, u32::MAX, &mut |x| {
            calls += 1;
            Ok(f(x))
        });
        let found = found.expect("numbers everywhere");
        assert!((found.x - place).abs() <= 2.0 * f64::EPSILON, "{place} {skew} {found:?}");
        most = most.max(calls);
    }
    std::println!("{most} evaluations of a lowest point at most");
    assert!(most <= 8);
}
