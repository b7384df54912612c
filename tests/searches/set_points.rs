//! Which input puts an output where it is wanted, from the middle of a stroke to its very ends,
//! against the same solver on numbers of 31 digits.

use std::f64::consts::{PI, TAU};

use linkage_core::find::{FindError, Root, Search, Trend};
use linkage_core::{Real, Scalar, SolveError};
use linkage_tests::double_double::DoubleDouble;
use linkage_tests::mechanisms::set_points::{CrankRocker, SliderCrank};
use linkage_tests::random::Random;
use num_dual::{Dual, Dual2, Dual64, HyperDual};

/// The ram's way beyond a wanted place, and its slope by the crank's angle.
pub(super) fn ram<T: Scalar>([r, l, e, wanted]: [T; 4], theta: T) -> [T; 2] {
    let solver = SliderCrank { r, l, e };
    let slide = solver.solve_position(theta).0.ram.slide;
    [slide - wanted, solver.solve_velocity(theta, T::lit(1.0, 1.0)).0.ram.slide]
}

/// The sine of the rocker's angle beyond a wanted one, and its slope by the crank's angle.
fn rocker<T: Scalar>([r, coupler, rocker, base, wanted]: [T; 5], theta: T) -> [T; 2] {
    let solver = CrankRocker { r, coupler, rocker, base };
    let angle = solver.solve_position(theta).0.DC;
    let omega = solver.solve_velocity(theta, T::lit(1.0, 1.0)).0.DC.omega;
    let (sin, cos) = wanted.sin_cos();
    let sine = T::det(angle.sin, cos, angle.cos, sin);
    [sine, omega * (angle.cos * cos + angle.sin * sin)]
}

/// A number of the width that is tested, with the numbers that stand for the truth and for its
/// conditioning.
pub(super) trait Width: Real + Into<f64> {
    const NARROW: bool;
    /// Half a unit in the last place of one.
    const HALF_UNIT: f64;
    fn of(value: f64) -> Self;
}

impl Width for f64 {
    const NARROW: bool = false;
    const HALF_UNIT: f64 = f64::EPSILON / 2.0;
    fn of(value: f64) -> Self {
        value
    }
}

impl Width for f32 {
    const NARROW: bool = true;
    const HALF_UNIT: f64 = f32::EPSILON as f64 / 2.0;
    fn of(value: f64) -> Self {
        value as f32
    }
}

/// The truth and the conditioning of an equation.
macro_rules! over_data {
    ($name:ident, $equation:ident, $count:literal) => {
        /// The residual of the equation at a root, over its change by half a unit in the last place of every
        /// number of the data and of the root.
        pub(super) fn $name<T: Width>(data: [T; $count], theta: T) -> f64 {
            let (data, theta): ([f64; $count], f64) = (data.map(Into::into), theta.into());
            let left = match T::NARROW {
                true => {
                    $equation(data.map(DoubleDouble::<true>::new), DoubleDouble::new(theta))[0].high
                }
                false => {
                    $equation(data.map(DoubleDouble::<false>::new), DoubleDouble::new(theta))[0]
                        .high
                }
            };
            let mut condition = $equation(data, theta)[1].abs() * theta.abs();
            for varied in 0..$count {
                let mut dual = data.map(Dual64::from_re);
                dual[varied].eps = data[varied];
                condition += $equation(dual, Dual64::from_re(theta))[0].eps.abs();
            }
            left.abs() / (condition * T::HALF_UNIT)
        }
    };
}

over_data! { ram_over_data, ram, 4 }
over_data! { rocker_over_data, rocker, 5 }

/// Evaluations and errors of many searches.
#[derive(Default, Debug)]
struct Record {
    searches: u32,
    evaluations: u32,
    most: u32,
    error: f64,
}

impl Record {
    fn add<T>(&mut self, root: &Root<T>, error: f64) {
        self.searches += 1;
        self.evaluations += root.evaluations;
        self.most = self.most.max(root.evaluations);
        self.error = self.error.max(error);
    }

    fn mean(&self) -> f64 {
        f64::from(self.evaluations) / f64::from(self.searches)
    }

    fn print(&self, title: &str) {
        let mean = self.mean();
        println!(
            "{title:28} {:5} searches, evaluations {mean:5.2} on average, {:3} at most, error {:5.2}",
            self.searches, self.most, self.error
        );
    }
}

/// The crank's angles at the ram's dead points, and its places there.
pub(super) fn ends_of_stroke([r, l, e]: [f64; 3]) -> [(f64, f64); 2] {
    let far = ((e / (r + l)).asin(), ((r + l) * (r + l) - e * e).sqrt());
    let near = (PI + (e / (l - r)).asin(), ((l - r) * (l - r) - e * e).sqrt());
    [far, near]
}

/// Targets at 10⁻ᵏ of half the stroke from one of its ends.
fn ram_set_points<T: Width>(last: i32) {
    let data = [0.08, 0.25, 0.03];
    let [(a, far), (b, near)] = ends_of_stroke(data);
    let mut random = Random::new(1);
    let (mut all, between) = (Record::default(), [a, b].map(T::of));
    for exponent in 0..=last {
        let mut record = Record::default();
        for _ in 0..200 {
            let part = random.anywhere(0.2, 1.0) * 10_f64.powi(-exponent);
            let away = part * (far - near) / 2.0;
            let wanted = if random.anywhere(0.0, 1.0) < 0.5 { far - away } else { near + away };
            let [r, l, e, wanted] = [data[0], data[1], data[2], wanted].map(T::of);
            // A place within four units in the last place of an end is that end.
            let slack = wanted * T::of(8.0 * T::HALF_UNIT);
            let search = Search::new(between, Trend::Falling).slack(slack);
            let root = search.find(|theta| ram([r, l, e, wanted], theta)).expect("in the stroke");
            let error = ram_over_data([r, l, e, wanted], root.at);
            record.add(&root, error);
            all.add(&root, error);
        }
        record.print(&format!("1e-{exponent:02} of the stroke's end"));
    }
    assert!(all.most <= Search::<T>::MOST && all.mean() <= 6.0, "{}", all.mean());
    // The finder ends within half a unit of where the rounded equation changes its sign, and that
    // rounding is less than the data's: most of their conditioning is the target's and the rod's.
    assert!(all.error <= 1.0, "{}", all.error);
}

#[test]
fn set_points_of_a_ram_in_double_precision() {
    ram_set_points::<f64>(15);
}

#[test]
fn set_points_of_a_ram_in_single_precision() {
    ram_set_points::<f32>(7);
}

/// The angles at which a crank-rocker's crank and coupler lie on one line, and the rocker's there.
fn ends_of_swing([r, coupler, rocker, base]: [f64; 4]) -> [(f64, f64); 2] {
    let at = |reach: f64, turn: f64| {
        let cos = (reach * reach + base * base - rocker * rocker) / (2.0 * reach * base);
        let pin = (reach * cos, reach * (1.0 - cos * cos).sqrt());
        // Left of the line from B to D, C is above the ground where the reach is.
        (cos.acos() + turn, pin.1.atan2(pin.0 - base))
    };
    [at(coupler + r, 0.0), at(coupler - r, PI)]
}

#[test]
fn set_points_of_random_crank_rockers() {
    let mut random = Random::new(2);
    let (mut record, mut machines) = (Record::default(), 0);
    while machines < 300 {
        let lengths = [(); 4].map(|()| random.anywhere(0.2, 2.0));
        let [r, coupler, rocker_length, base] = lengths;
        let longest = lengths.iter().fold(0.0_f64, |longest, &length| longest.max(length));
        let is_shortest = lengths.iter().all(|&length| r <= length);
        let grashof = lengths.iter().sum::<f64>() / 2.0 - (longest + r);
        if !is_shortest || grashof < 0.01 {
            continue;
        }
        machines += 1;
        let [(a, high), (b, low)] = ends_of_swing(lengths);
        // The mode whose inner joint is left of BD goes from one end to the other in this order.
        let (from, to) = if a < b { (a, b) } else { (b, a) };
        let trend = if (high > low) == (a < b) { Trend::Falling } else { Trend::Rising };
        for _ in 0..40 {
            let part = 10_f64.powf(random.anywhere(-12.0, -0.3));
            let part = if random.anywhere(0.0, 1.0) < 0.5 { part } else { 1.0 - part };
            let data = [r, coupler, rocker_length, base, low + part * (high - low)];
            let root = Search::new([from, to], trend)
                .slack(4.0 * f64::EPSILON)
                .find(|theta| rocker(data, theta))
                .unwrap_or_else(|error| panic!("{lengths:?} {part:e}: {error}"));
            record.add(&root, rocker_over_data(data, root.at));
        }
    }
    record.print("rocker");
    assert!(record.most <= Search::<f64>::MOST && record.mean() <= 7.3, "{}", record.mean());
    assert!(record.error <= 1.0, "{}", record.error);
}

/// Ends that lie up to 0.6 rad beyond both dead points.
#[test]
fn ends_beyond_dead_points() {
    let data = [0.08, 0.25, 0.03];
    let [(a, far), (b, near)] = ends_of_stroke(data);
    let mut random = Random::new(3);
    let (mut record, mut moved) = (Record::default(), 0);
    for _ in 0..4000 {
        let between = [a - random.anywhere(0.0, 0.6), b + random.anywhere(0.0, 0.6)];
        let away = 10_f64.powf(random.anywhere(-15.0, 0.0)) * (far - near) / 2.0;
        let wanted = if random.anywhere(0.0, 1.0) < 0.5 { far - away } else { near + away };
        let data = [data[0], data[1], data[2], wanted];
        let ends = between.map(|end| ram(data, end)[0]);
        moved += u32::from(ends[0] < 0.0 || ends[1] > 0.0);
        let search = Search::new(between, Trend::Falling).slack(8.0 * f64::EPSILON * wanted);
        let root = search.find(|theta| ram(data, theta)).expect("in the stroke");
        record.add(&root, ram_over_data(data, root.at));
        // Between the dead points, to what the place of a dead point is known.
        assert!(a - 1e-7 <= root.at && root.at <= b + 1e-7, "{root:?}");
    }
    record.print("beyond dead points");
    assert!(moved > 2000, "{moved}");
    assert!(record.most <= 2 * Search::<f64>::MOST && record.mean() <= 9.5, "{}", record.mean());
    assert!(record.error <= 1.0, "{}", record.error);
}

/// A press ram commanded at 1 kHz. The drive turns at up to 50 rad/s, half a radian in ten calls.
#[test]
fn a_motion_of_small_steps_takes_three_evaluations() {
    let [(a, far), (b, near)] = ends_of_stroke([0.08, 0.25, 0.03]);
    let half = (far - near) / 2.0;
    let (mut warm, mut cold) = (Record::default(), Record::default());
    let mut known = [0.0; 3];
    for step in 0..3000 {
        let t = f64::from(step) * 1e-3;
        let way = 0.8 * (TAU * 2.0 * t).sin() + 0.15 * (TAU * 11.0 * t).sin();
        let data = [0.08, 0.25, 0.03, near + half * (1.0 + way)];
        let search = Search::new([a, b], Trend::Falling);
        let f = |theta| ram(data, theta);
        let root = search.find(f).expect("in the stroke");
        cold.add(&root, ram_over_data(data, root.at));
        let seed = 3.0 * known[0] - 3.0 * known[1] + known[2];
        let root = search.near(seed).find(f).expect("in the stroke");
        if step >= 3 {
            warm.add(&root, ram_over_data(data, root.at));
        }
        known = [root.at, known[0], known[1]];
    }
    warm.print("warm at 1 kHz");
    cold.print("the same cold");
    assert!(warm.most <= 3 && warm.mean() <= 2.1, "{} {}", warm.most, warm.mean());
    assert!(warm.error <= 1.0, "{}", warm.error);
}

/// The cost of a seed that does not help.
#[test]
fn a_bad_seed_costs_three_evaluations() {
    let [(a, _), (b, near)] = ends_of_stroke([0.08, 0.25, 0.03]);
    let data = [0.08, 0.25, 0.03, near + 1e-3];
    let search = Search::new([a, b], Trend::Falling);
    let f = |theta| ram(data, theta);
    let cold = search.find(f).expect("in the stroke");
    for seed in [a, b, a - 1.0, b + 1.0, 0.5, 3.0, f64::NAN, f64::INFINITY, 1e300] {
        let root = search.near(seed).find(f).expect("in the stroke");
        assert!(ram_over_data(data, root.at) <= 1.0, "{seed}: {root:?}");
        assert!(root.evaluations <= cold.evaluations + 3, "{seed}: {root:?}");
    }
    // A root of the other trend next to the seed is not taken.
    let wide = Search::new([a - 3.0, b], Trend::Falling);
    let other = Search::new([a - 3.0, a], Trend::Rising).find(f).expect("in the stroke");
    let root = wide.near(other.at).find(f).expect("in the stroke");
    assert!(other.at < a && a < root.at, "{other:?} {root:?}");
    assert!(ram_over_data(data, root.at) <= 1.0, "{root:?}");
}

/// The derivatives of a root by the target and by a length against those of the implicit equation.
fn derivatives<D: Real>(at: f64, wanted: D, rod: D) -> D {
    let [(a, _), (b, _)] = ends_of_stroke([0.08, 0.25, 0.03]);
    let lit = |value: f64| D::lit(value, value as f32);
    let between = [lit(a), lit(b)];
    let root = Search::new(between, Trend::Falling)
        .find(|theta| ram([lit(0.08), rod, lit(0.03), wanted], theta))
        .expect("in the stroke");
    // Dual numbers divide by multiplying with the reciprocal: another rounding of the last step.
    assert!((root.at.value() - at).abs() <= 2.0 * f64::EPSILON, "{root:?} {at}");
    root.at
}

#[test]
fn a_root_carries_its_derivatives() {
    let [(a, _), (b, _)] = ends_of_stroke([0.08, 0.25, 0.03]);
    let search = Search::new([a, b], Trend::Falling);
    for wanted in [0.18, 0.2, 0.25, 0.31, 0.3282] {
        let at = |wanted, rod| {
            search.find(|theta| ram([0.08, rod, 0.03, wanted], theta)).expect("in the stroke").at
        };
        let theta = at(wanted, 0.25);
        let motion = SliderCrank::new().motion(theta, 1.0, 0.0).expect("in the stroke");
        let (slope, second) = (motion.velocity.ram.slide, motion.acceleration.ram.slide);
        let close = |found: f64, expected: f64| {
            // The data's rounding changes the root by about ε over the slope, and thereby the slope. Its four
            // terms, all below 0.1, are rounded besides. The slope enters three times.
            let root = f64::EPSILON / slope.abs();
            let of_slope = (root * second.abs() + 4.0 * 0.1 * f64::EPSILON) / slope.abs();
            let allowed = 3.0 * of_slope + 8.0 * f64::EPSILON;
            assert!((found - expected).abs() <= allowed * expected.abs(), "{found} {expected}");
        };
        // θ(x) with s(θ(x)) = x: θ′ = 1/s′, θ″ = −s″/s′³.
        let [first, curved] = [1.0 / slope, -second / (slope * slope * slope)];
        let dual = derivatives(theta, Dual64::new(wanted, 1.0), Dual64::from_re(0.25));
        close(dual.eps, first);
        let dual2 = derivatives(theta, Dual2::new(wanted, 1.0, 0.0), Dual2::<f64>::from_re(0.25));
        close(dual2.v1, first);
        close(dual2.v2, curved);
        let nested = derivatives(
            theta,
            Dual::new(Dual64::new(wanted, 1.0), Dual64::from_re(1.0)),
            Dual::from_re(Dual64::from_re(0.25)),
        );
        close(nested.eps.eps, curved);
        // Mixed, by the rod: the rod's own slope at constant angle is l/√(l² − h²).
        let mixed = derivatives(
            theta,
            HyperDual::<f64>::new(wanted, 1.0, 0.0, 0.0),
            HyperDual::new(0.25, 0.0, 1.0, 0.0),
        );
        let h = 0.08 * theta.sin() - 0.03;
        let by_rod = 0.25 / (0.25_f64 * 0.25 - h * h).sqrt();
        close(mixed.eps2, -by_rod / slope);
        // s(θ(x, l), l) = x, differentiated by x and then by l.
        let rod = Dual64::new(0.25, 1.0);
        let lengths = [Dual64::from_re(0.08), rod, Dual64::from_re(0.03), Dual64::from_re(wanted)];
        let slope_by_rod = ram(lengths, Dual64::from_re(theta))[1].eps;
        close(mixed.eps1eps2, -(second * mixed.eps2 + slope_by_rod) * first / slope);
    }
    // At the dead point itself the angle has no derivative.
    let top = |theta: Dual64| {
        let wanted = Dual64::new(0.0, 1.0);
        [-(theta * theta) - wanted, Dual64::from_re(-2.0) * theta]
    };
    let ends = [0.0, 1.0].map(Dual64::from_re);
    assert_eq!(Search::new(ends, Trend::Falling).find(top), Err(FindError::Singular { at: 0.0 }));
}

#[test]
fn what_cannot_be_reached_or_assembled_is_an_error() {
    let press = SliderCrank::new();
    let solved = |wanted: f64, between: [f64; 2]| {
        Search::new(between, Trend::Falling).find(|theta| match press.motion(theta, 1.0, 0.0) {
            Ok(at) => [at.position.ram.slide - wanted, at.velocity.ram.slide],
            Err(SolveError::OutOfReach { .. }) => [f64::NAN; 2],
            Err(other) => panic!("{other}"),
        })
    };
    let [(a, far), (b, near)] = ends_of_stroke([0.08, 0.25, 0.03]);
    let missing = |wanted: f64, between, by: f64| {
        let found = solved(wanted, between);
        let is_by = |found: f64| (found - by).abs() < 1e-15;
        assert!(matches!(found, Err(FindError::NoSolution { by, .. }) if is_by(by)), "{found:?}");
    };
    missing(far + 0.01, [a, b], 0.01);
    missing(near - 0.02, [a, b], 0.02);
    // Ends beyond the dead points are moved there first.
    missing(far + 0.01, [a - 0.5, b + 0.3], 0.01);
    missing(near - 0.02, [a - 0.5, b + 0.3], 0.02);
    // Only a root of the other trend.
    assert!(matches!(solved(0.25, [-2.5, a]), Err(FindError::NoSolution { .. })));
    // A rod that does not reach the bed at every angle.
    let short = SliderCrank { l: 0.045, ..press };
    let ends = [0.0, PI];
    let found = Search::new(ends, Trend::Falling).find(|theta| {
        short
            .motion(theta, 1.0, 0.0)
            .map_or([f64::NAN; 2], |at| [at.position.ram.slide - 0.02, at.velocity.ram.slide])
    });
    assert!(matches!(found, Err(FindError::NotFinite { .. })), "{found:?}");
}
