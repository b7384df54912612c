//! Motions and ranges beside an unknown: against closed forms, the same machine driven at the unknown,
//! and stepping.

use std::f64::consts::PI;

use linkage_core::Solver;
use linkage_core::find::Trend;
use linkage_core::range::{Stop, Stretch, limits};
use linkage_core::{Real, Side, SolveError, Tracker};
use linkage_tests::mechanisms::followed::*;
use linkage_tests::mechanisms::ranges::FourBar;
use linkage_tests::mechanisms::unknowns::{InLine, Press};
use linkage_tests::random::{Random, cases};
use num_dual::Dual64;

use super::set_points::ends_of_stroke;

const THETA: Stop = Stop::Limit { group: "theta" };

/// The only stretch, which ends at limits of the unknown.
#[track_caller]
fn only(stretches: &[Stretch<f64>]) -> [f64; 2] {
    let [stretch] = stretches else { panic!("{stretches:?}") };
    assert_eq!([stretch.from.stop, stretch.to.stop], [THETA; 2], "{stretch:?}");
    [stretch.from.at, stretch.to.at]
}

/// The dead points of a ram's equation are the ends of its stroke; next to them what an interval of
/// inputs ends at is its edge. A sample of the presses of `.ci/nightly`.
#[test]
fn limits_of_a_ram_are_its_stroke() {
    let [from, to] = only(&limits(&InLine::new(), [0.1, 0.4]).expect("an interval"));
    assert!((from - 0.17).abs() < 1e-16 && (to - 0.33).abs() < 1e-16, "{from} {to}");
    assert!(limits(&InLine::new(), [0.18, 0.32]).expect("an interval").is_whole());
    assert!(limits(&InLine::new(), [0.34, 0.4]).expect("an interval").is_empty());
    let mut random = Random::new(5);
    for _ in 0..cases(20, 200) {
        let [r, e] = [random.anywhere(0.02, 0.1), random.anywhere(-0.06, 0.06)];
        let l = r + e.abs() + random.anywhere(0.05, 0.3);
        let [(_, far), (_, near)] = ends_of_stroke([r, l, e]);
        let press = Press { r, l, e, from: -0.9, to: 4.0, ..Press::new() };
        let [from, to] = only(&limits(&press, [0.5 * near, 2.0 * far]).expect("an interval"));
        // √((l ± r)² − e²) loses what the smaller factor of it has lost.
        let tolerance = 8.0 * f64::EPSILON * (l + r) * (l + r) / near;
        assert!((from - near).abs() < tolerance && (to - far).abs() < tolerance, "{r} {l} {e}");
    }
    // The derivative of the stroke's ends by the crank's length: ∂(l + r)/∂r is one.
    let [r, l, e, near] = [0.08, 0.25, 0.0, 1.0].map(Dual64::from_re);
    let [from, to] = [-0.3, 3.4].map(Dual64::from_re);
    let press = Press { r: r.derivative(), l, e, from, to, seed: near };
    let ends = [0.1, 0.4].map(Dual64::from_re);
    let found = limits(&press, ends).expect("an interval");
    assert!((found[0].to.at.eps - 1.0).abs() < 1e-14, "{found:?}");
    assert!((found[0].from.at.eps + 1.0).abs() < 1e-14, "{found:?}");
}

/// Where stepping finds a pose, and nowhere else; each end is where the crank that is searched is at
/// an end of its interval, or at a dead point. An ordinary run steps by six degrees, `.ci/nightly` by 1.2.
#[test]
fn limits_by_a_rocker_agree_with_stepping() {
    let mut random = Random::new(23);
    let (mut edges, mut dead_points) = (0, 0);
    for _ in 0..30 {
        let from = random.anywhere(-3.0, 2.0);
        let to = from + random.anywhere(0.3, 3.1);
        let machine = ByRocker { from, to, ..ByRocker::new() };
        let stretches = limits(&machine, [-PI, PI]).expect("an interval");
        let half_turn = cases(30, 150) as i32;
        for step in -half_turn..half_turn {
            let psi = (f64::from(step) + 0.37) * PI / f64::from(half_turn);
            let is_inside = stretches.iter().any(|s| s.from.at <= psi && psi <= s.to.at);
            let found = machine.position(psi);
            assert_eq!(found.is_ok(), is_inside, "{from} {to} {psi}: {found:?} {stretches:?}");
        }
        let four_bar = FourBar {
            crank: 0.08,
            coupler: 0.632,
            rocker: 0.374,
            base: 0.6657,
            elbow: Side::Right,
        };
        for end in stretches.iter().flat_map(|s| [s.from, s.to]).filter(|end| end.stop == THETA) {
            let theta = machine.position(end.at).expect("a limit has a pose").theta;
            let at = |theta| four_bar.position(theta).expect("it turns fully").DC.angle();
            if [from, to].iter().any(|&edge| (at(edge) - end.at).abs() < 1e-14) {
                edges += 1;
            } else {
                dead_points += 1;
                let rate = four_bar.velocity(theta, 1.0).expect("it turns fully").DC.omega;
                // Half the digits of the angle are lost at a dead point.
                assert!(rate.abs() < 1e-7, "{theta} {rate}");
            }
        }
    }
    assert!(edges > 10 && dead_points > 10, "{edges} {dead_points}");
}

/// The cranks of both presses turn as one, whatever the steps. The smallest go as far to either side of the dead
/// point as they are many, farther in `.ci/nightly`.
#[test]
fn twins_go_through_their_dead_point() {
    let many = cases(10, 160) as u32;
    let small = (0.0175 / 2.0 * f64::from(many), 0.0175, many);
    for (start, step, count) in
        [small, (1.6, 0.1, 32), (1.61, 0.07, 46), (1.5, 0.97, 3), (1.2, 2.3, 1)]
    {
        for sign in [1.0, -1.0] {
            let way = if sign > 0.0 { Trend::Falling } else { Trend::Rising };
            let mut tracker = Tracker::new(TwinPress { way, ..TwinPress::new() });
            for index in 0..=count {
                let turn = sign * (start - step * f64::from(index));
                let found = tracker.motion(turn, -sign, 0.5);
                let m = found.unwrap_or_else(|error| panic!("{turn} by {step}: {error}"));
                let errors = [
                    m.position.theta - turn,
                    m.velocity.theta + sign,
                    m.acceleration.theta - 0.5,
                    m.position.AB.sin - turn.sin(),
                ];
                // As for groups: an interpolation over the dead point cannot hide the other root.
                assert!(errors.iter().all(|error| error.abs() < 1e-7), "{turn}: {errors:?}");
            }
            assert_eq!(tracker.solver().way, way.flipped());
            // And back again.
            let m = tracker.motion(sign * start, sign, 0.0).expect("the way back");
            assert!((m.position.theta - sign * start).abs() < 1e-12);
            assert_eq!(tracker.solver().way, way);
        }
    }
}

#[test]
fn a_constant_mode_ends_at_the_dead_point() {
    let mut tracker = Tracker::new(StiffTwinPress::new());
    tracker.position(0.5).expect("clear of it");
    let singular = SolveError::Singular { group: "theta" };
    assert_eq!(tracker.position(-0.5).map(|p| p.theta), Err(singular));
    // It stays where it was.
    let on = tracker.position(0.2).expect("on this side");
    assert!((on.theta - 0.2).abs() < 1e-12);
    // Beyond its interval there is no root: the crank's end is 100°.
    let beyond = tracker.position(2.0);
    assert!(matches!(beyond, Err(SolveError::NoSolution { unknown: "theta", .. })), "{beyond:?}");
    // A step to the end and back cannot be distinguished from one through it.
    let mut tracker = Tracker::new(TwinPress::new());
    tracker.position(1.0).expect("clear of it");
    assert!(tracker.position(2.0 * PI - 1.0).is_err());
}

/// A ram that is an input stops at its dead point, and returns on the branch that it came on.
#[test]
fn a_ram_stops_at_its_dead_point() {
    let mut tracker = Tracker::new(InLine::new());
    for x in [0.2, 0.3, 0.329, 0.33, 0.329, 0.2] {
        let theta = tracker.position(x).unwrap_or_else(|error| panic!("{x}: {error}")).theta;
        let again = 0.08 * theta.cos() + (0.0625 - (0.08 * theta.sin()).powi(2)).sqrt();
        assert!((again - x).abs() < 1e-15 && (0.0..=PI).contains(&theta), "{x} {theta}");
    }
    let beyond = tracker.position(0.35);
    assert!(matches!(beyond, Err(SolveError::NoSolution { unknown: "theta", .. })), "{beyond:?}");
}

/// The rocker's pose is that of the same machine driven at its crank.
#[test]
fn a_four_bar_by_its_rocker_is_followed_as_by_its_crank() {
    let direct =
        FourBar { crank: 0.08, coupler: 0.632, rocker: 0.374, base: 0.6657, elbow: Side::Right };
    let mut tracker = Tracker::new(ByRocker::new());
    let at = |theta: f64| direct.position(theta).expect("it turns fully").DC.angle();
    for step in 0..=100 {
        let theta = 0.3 + 0.022 * f64::from(step);
        let m = tracker.motion(at(theta), 1.0, 0.0).unwrap_or_else(|e| panic!("{theta}: {e}"));
        let by_crank = direct.motion(m.position.theta, m.velocity.theta, m.acceleration.theta);
        let by_crank = by_crank.expect("it turns fully");
        assert!((m.position.theta - theta).abs() < 1e-12, "{theta} {}", m.position.theta);
        assert!((by_crank.velocity.DC.omega - 1.0).abs() < 1e-12);
        assert!(by_crank.acceleration.DC.alpha.abs() < 1e-9);
    }
}

#[test]
fn a_group_behind_an_unknown_changes_its_mode() {
    for step in [0.008, 0.05, 0.077, 0.6] {
        let mut tracker = Tracker::new(Lifted::new());
        let count = (0.8 / step) as u32;
        for index in 0..=count {
            let y = 0.4 - step * f64::from(index);
            let m = tracker.motion(y, -1.0, 0.5).unwrap_or_else(|error| panic!("{y}: {error}"));
            let theta = (y / 0.5).asin();
            assert!((m.position.theta - theta).abs() < 1e-14);
            assert!((m.position.DC.angle() - theta).abs() < 1e-9, "{y}");
            assert!((m.velocity.DC.omega - m.velocity.theta).abs() < 1e-7, "{y}");
        }
        assert_eq!(tracker.solver().elbow, Side::Right);
    }
}

/// A change of the group that the equation is made of is refused; on both sides of it there are poses.
#[test]
fn a_group_inside_the_search_keeps_its_mode() {
    let mut tracker = Tracker::new(Inside::new());
    for psi in [0.8, 0.5, 0.3] {
        let p = tracker.position(psi).expect("on one side");
        assert!((p.theta - psi).abs() < 1e-12);
    }
    let refused = tracker.position(-0.5).map(|p| p.theta);
    assert!(refused.is_err(), "{refused:?}");
    assert!((tracker.position(0.6).expect("still there").theta - 0.6).abs() < 1e-12);
    let other = Inside { elbow: Side::Right, ..Inside::new() };
    assert!((Tracker::new(other).position(-0.5).expect("there").theta + 0.5).abs() < 1e-12);
}

/// Where several roots have the trend, another one may be found: a tracker goes on with its own, or
/// refuses.
#[test]
fn another_root_is_no_continuation() {
    let (mut refused, mut jumps) = (0, 0);
    for way in [Trend::Falling, Trend::Rising] {
        for sign in [1.0, -1.0] {
            let solver = Waves { way, ..Waves::new() };
            let mut tracker = Tracker::new(solver);
            let (mut last, mut alone) = (None::<f64>, None::<f64>);
            for step in 0..=200 {
                let x = 0.2013 + sign * (0.01 * f64::from(step) - 1.0);
                let found = solver.position(x).ok().map(|p| p.theta);
                jumps += u32::from(found.zip(alone).is_some_and(|(a, b)| (a - b).abs() > 0.5));
                alone = found.or(alone);
                match tracker.position(x) {
                    Ok(p) => {
                        assert!(last.is_none_or(|last| (p.theta - last).abs() < 0.3), "{x}");
                        last = Some(p.theta);
                    }
                    Err(_) => refused += 1,
                }
            }
        }
    }
    assert!(jumps > 0 && refused > 0, "{jumps} {refused}");
}

/// Also where the mode is a parameter, which changes at dead points alone.
#[test]
fn an_interval_ends_the_range_of_an_equation_at_either_end() {
    let edge = 100_f64.to_radians();
    for (way, between, to) in
        [(Trend::Falling, [1.0, 2.5], edge), (Trend::Rising, [-2.5, -1.0], -edge)]
    {
        let twin = TwinPress { way, ..TwinPress::new() };
        let found = limits(&twin, between).expect("an interval");
        let [stretch] = &found[..] else { panic!("{found:?}") };
        let end = if to > 0.0 { stretch.to } else { stretch.from };
        // A ram's place is known to some ε of 0.33 m, and goes by 0.08 m a radian there.
        assert!(end.stop == THETA && (end.at - to).abs() < 1e-14, "{stretch:?}");
    }
}

/// The end of the interval counts where the mode is a parameter, too: there the twin's slide is away from
/// the ram's at 100°, with the twin's rates.
#[test]
fn an_end_of_the_interval_is_a_limit_of_either_mode() {
    let slide = |turn: f64| {
        let (sin, cos) = turn.sin_cos();
        let rod = (0.25_f64.powi(2) - (0.08 * sin).powi(2)).sqrt();
        // The rod's rates are those of its square, l² − r² sin² θ, by half and over the rod.
        let (first, second) = (-0.0064 * sin * cos / rod, -0.0064 * (2.0 * turn).cos() / rod);
        [0.08 * cos + rod, -0.08 * sin + first, -0.08 * cos + second - first * first / rod]
    };
    let edge = slide(100_f64.to_radians())[0];
    for way in [Trend::Falling, Trend::Rising] {
        for (turn, rate) in [(1.3, 1.0), (1.7, -2.0), (2.2, 0.5)] {
            let [value, first, second] = slide(turn);
            let wanted = [value - edge, first * rate, second * rate * rate];
            let found = TwinPress { way, ..TwinPress::new() }.clearances(turn, rate);
            let ends = found.as_ref().iter().filter(|end| {
                let found = [end.value, end.rate, end.second_rate];
                // Some dozens of roundings of numbers below one.
                found.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-14)
            });
            assert_eq!(ends.count(), 1, "{way:?} {turn}: {found:?} {wanted:?}");
        }
    }
}

/// The end of the rod that the input moves, and its derivatives by the input.
fn rod_end(psi: f64) -> [[f64; 2]; 3] {
    let (sin, cos) = psi.sin_cos();
    [[3.0 + 0.8 * cos, 0.8 * sin], [-0.8 * sin, 0.8 * cos], [-0.8 * cos, -0.8 * sin]]
}

/// The clearance of an equation from having no root, and its rates, where the input moves the dead point.
/// With A, B and E in line the rod's place for B is |AE| − 1 away from E. The reference is in closed form.
#[test]
fn clearances_of_an_equation_have_the_rates_of_closed_forms() {
    const ROD: f64 = 2.9;
    for psi in [-2.5, -0.7, 0.4, 1.0, 2.9] {
        for rate in [1.0, -3.0] {
            let [[x, y], [dx, dy], [ddx, ddy]] = rod_end(psi);
            let found = Rodded::new().clearances(psi, rate);
            let [lower, upper, ..] = found.as_ref() else { panic!("two ends") };
            // |AE| and its derivatives, then (l² − (|AE| − 1)²)/2l.
            let u = x.hypot(y);
            let du = (x * dx + y * dy) / u;
            let ddu = (dx * dx + dy * dy + x * ddx + y * ddy - du * du) / u;
            let at_dead_point = [
                (ROD * ROD - (u - 1.0) * (u - 1.0)) / (2.0 * ROD),
                -(u - 1.0) * du / ROD,
                -(du * du + (u - 1.0) * ddu) / ROD,
            ];
            // The crank at the end of its interval, where it stays: (|BE|² − l²)/2l.
            let (sin, cos) = (5.0 * PI / 6.0).sin_cos();
            let (x, y) = (x - cos, y - sin);
            let at_edge = [
                (x * x + y * y - ROD * ROD) / (2.0 * ROD),
                (x * dx + y * dy) / ROD,
                (dx * dx + dy * dy + x * ddx + y * ddy) / ROD,
            ];
            for (end, [value, first, second]) in [(lower, at_dead_point), (upper, at_edge)] {
                let found = [end.value, end.rate, end.second_rate];
                let wanted = [value, first * rate, second * rate * rate];
                for (found, wanted) in found.iter().zip(wanted) {
                    // Some dozens of roundings of numbers up to 30.
                    assert!((found - wanted).abs() < 1e-13, "{psi} {rate}: {found} {wanted}");
                }
            }
        }
    }
}

/// The values without rates equal those that come with rates. Somewhere they are finite, and value and scale
/// differ.
#[test]
fn values_of_an_equation_are_those_that_come_with_rates() {
    let mut known = 0;
    for psi in [-2.5, -0.7, 0.4, 1.0, 2.9] {
        for radius in [0.0, 1e-6, 1e-3] {
            let solver = Rodded::new();
            let (values, ranges) =
                (solver.values(psi, radius), solver.enclosures(psi, radius, radius));
            assert_eq!(values.as_ref().len(), ranges.as_ref().len());
            for ([value, scale], range) in values.as_ref().iter().zip(ranges.as_ref()) {
                let [value, scale] = [value, scale].map(|found| found.bounds());
                let expected = [range.value.bounds(), range.scale.bounds()];
                // The same formulas; where nothing is known a bound may be no number.
                let bits = |bounds: [f64; 2]| bounds.map(f64::to_bits);
                assert_eq!([value, scale].map(bits), expected.map(bits), "{psi} {radius}");
                known += usize::from(value.iter().all(|x| x.is_finite()) && value != scale);
            }
        }
    }
    assert!(known > 15, "{known}");
}

/// Where an equation has several dead points its ends do not tell of a root between two of them: limits
/// go by the solver, and a tracker refuses to follow such a root.
#[test]
fn limits_of_waves_are_where_the_solver_has_a_root() {
    for way in [Trend::Falling, Trend::Rising] {
        let waves = Waves { way, ..Waves::new() };
        let found = limits(&waves, [-1.5, 1.9]).expect("an interval");
        for step in 0..170 {
            let x = -1.5 + 0.02 * f64::from(step) + 0.0071;
            let is_inside = found.iter().any(|s| s.from.at <= x && x <= s.to.at);
            assert_eq!(waves.position(x).is_ok(), is_inside, "{way:?} {x} {found:?}");
        }
        // The sine's troughs and crests: sin 3θ + θ/8 where 3 cos 3θ = −1/8.
        let turn = |k: f64| {
            let theta = (k * 2.0 * PI + (-1.0 / 24.0_f64).acos()) / 3.0;
            [theta, 2.0 * PI / 3.0 * (2.0 * k + 1.0) - theta]
        };
        let value = |theta: f64| (3.0 * theta).sin() + theta / 8.0;
        let [trough, crest] = [value(turn(0.0)[1]), value(turn(1.0)[0])];
        let [stretch] = &found[..] else { panic!("{found:?}") };
        for (end, expected) in [(stretch.from, trough), (stretch.to, crest)] {
            assert!((end.at - expected).abs() < 1e-13, "{way:?} {end:?} {expected}");
        }
    }
    let mut tracker = Tracker::new(Waves::new());
    let refused = tracker.position(-0.6).map(|p| p.theta);
    assert_eq!(refused, Err(SolveError::SeveralDeadPoints { unknown: "theta" }));
    assert!(tracker.solver().position(-0.6).is_ok());
}
