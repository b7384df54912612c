//! Distances from a change point, in units of √ε, from which on a tracker does one thing or another.
//!
//! Two parallelograms whose cranks turn independently of each other, so that every clearance is that of
//! bars 1 and 2 at a crank angle: the distance of the outer joints is d² = base² + 1 − 2 base cos θ, and
//! the value under the root of the height is read from the generated code, which other tests hold to
//! dual numbers.

use linkage_core::Solver;
use linkage_core::{Direction, Float, Real, Record, Side, Tracker, mechanism};
use linkage_tests::mechanisms::scaled_change_points::{ScaledPairs, ScaledPairsMotion, TwoGrounds};
use linkage_tests::random::cases;

mechanism! {
    /// Two parallelograms on one input: the second crank turns three times as fast, and passes its
    /// change point where the input is a third of `shift`.
    struct SideBySide {
        input theta: angle;
        param base = 2m;
        param other = 2m;
        param shift: angle = 0deg;
        param elbow: mode = right;
        param knee: mode = right;
        ground A(0, 0), D(base, 0), P(0, 9m), T(other, 9m);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }
        crank PQ(P) -> Q        { length: 1m, angle: 3 * theta - shift }
        rrr   QR(Q), TR(T) -> R { lengths: (2m, 1m), mode: knee }
        output DC, TR;
    }
}

fn number<T: Float>(value: f64) -> T {
    T::lit(value, value as f32)
}

/// √ε of a width.
fn root<T: Float>() -> f64 {
    f64::sqrt(T::EPSILON)
}

/// Clearance of a group in units of its scale, and its second rate.
fn clearance<T: Float>(of: &SideBySide<T>, theta: f64, group: usize) -> [f64; 2] {
    let all = of.clearances(number(theta), number(1.0));
    let found = all.as_ref()[group];
    [found.value, found.second_rate].map(|number| number.value() / found.scale.value())
}

/// The ground of a parallelogram whose clearance at θ = 0 is so many parts of its scale.
fn ground<T: Float>(wanted: f64) -> T {
    let at = |base: f64| clearance(&SideBySide { base, ..SideBySide::new() }, 0.0, 0)[0];
    // A longer ground is farther from the limit; halvings to the last place.
    let [mut low, mut high] = [1.9, 2.1];
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if at(middle) < wanted { low = middle } else { high = middle }
    }
    number(high)
}

/// The angle behind θ = 0 at which the clearance of an exact parallelogram is so many parts of its scale.
fn angle(wanted: f64) -> f64 {
    let [mut low, mut high] = [0.0, 1.0];
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let is_low = clearance(&SideBySide::<f64>::new(), middle, 0)[0] < wanted;
        if is_low { low = middle } else { high = middle }
    }
    high
}

/// A tracker that has come from θ = −0.3, where both are parallelograms.
fn started<T: Float>(solver: SideBySide<T>) -> Tracker<SideBySide<T>> {
    let mut tracker = Tracker::new(solver);
    tracker.motion(number::<T>(-0.3), number::<T>(1.0), number::<T>(0.0)).expect("it assembles");
    tracker
}

fn go<T: Float>(tracker: &mut Tracker<SideBySide<T>>, theta: f64) -> [f64; 2] {
    let motion = tracker.motion(number::<T>(theta), number::<T>(1.0), number::<T>(0.0));
    let velocity = motion.expect("the motion goes on").velocity;
    [velocity.DC.omega.value(), velocity.TR.omega.value()]
}

const BEFORE: Side = Side::Right;
const BEHIND: Side = Side::Left;

/// A pose lies on the change point where its clearance is below 4 √ε of its scale: the modes stay those of
/// the last pose before.
fn modes_change_at_four<T: Float>() {
    for (parts, wanted) in [(1.0, BEFORE), (3.9, BEFORE), (4.1, BEHIND), (9.0, BEHIND)] {
        let theta = angle(parts * root::<T>());
        // The second crank is far from its own. In one step, or first to so near that it is clear of its
        // limit on all of the last step.
        for first in [-0.3, -theta.max(1e-3)] {
            let shift = number(1.5);
            let mut tracker = started(SideBySide { shift, ..SideBySide::<T>::default() });
            go(&mut tracker, first);
            go(&mut tracker, theta);
            assert_eq!(tracker.solver().elbow, wanted, "{parts} √ε from {first}");
        }
    }
}

#[test]
fn modes_change_where_a_clearance_is_four_times_the_root_of_epsilon() {
    modes_change_at_four::<f64>();
    modes_change_at_four::<f32>();
}

/// At one input both are lowest. What stays above √ε of its scale keeps its mode, what falls lower changes,
/// whichever of them comes first.
fn both_at_once<T: Float>() {
    for (parts, wanted) in
        [(0.0, BEHIND), (0.5, BEHIND), (0.9, BEHIND), (1.1, BEFORE), (2.0, BEFORE)]
    {
        let near = ground::<T>(parts * root::<T>());
        let exact = number::<T>(2.0);
        for near_is_first in [false, true] {
            let [base, other] = if near_is_first { [near, exact] } else { [exact, near] };
            let solver = SideBySide { base, other, ..SideBySide::<T>::default() };
            let mut tracker = started(solver);
            let rates = go(&mut tracker, 0.3);
            let (elbow, knee) = (tracker.solver().elbow, tracker.solver().knee);
            let modes = if near_is_first { [elbow, knee] } else { [knee, elbow] };
            assert_eq!(modes, [wanted, BEHIND], "{parts} √ε");
            // Parallelograms turn as their cranks do, antiparallelograms the other way.
            let rates = [rates[0], rates[1] / 3.0];
            let [missed, passed] = if near_is_first { rates } else { [rates[1], rates[0]] };
            assert!((passed - 1.0).abs() < 1e-2, "{parts} √ε: {rates:?}");
            assert_eq!(missed > 0.0, wanted == BEHIND, "{parts} √ε: {rates:?}");
        }
    }
}

#[test]
fn a_second_group_changes_where_it_is_below_the_root_of_epsilon_and_no_higher() {
    both_at_once::<f64>();
    both_at_once::<f32>();
}

/// The step ends between two change points, clear of both but so close behind the first that its
/// surroundings hold the second: only the first is passed.
fn ends_between<T: Float>() {
    let root = root::<T>();
    // 16 times 0.9 √ε high, the surroundings end; the second group's place is a tenth before that.
    let base = ground::<T>(0.9 * root);
    let wide = clearance(&SideBySide { base: base.value(), ..SideBySide::new() }, 0.0, 0);
    let aside = (2.0 * 16.0 * 0.9 * root / wide[1]).sqrt();
    let (end, place) = (0.6 * aside, 0.9 * aside);
    let solver = SideBySide { base, shift: number(3.0 * place), ..SideBySide::<T>::default() };
    for group in 0..2 {
        let [value, _] = clearance(&solver, end, group);
        assert!(value > 4.5 * root, "{group}: {} √ε", value / root);
    }
    let mut tracker = started(solver);
    let rates = go(&mut tracker, end);
    assert_eq!((tracker.solver().elbow, tracker.solver().knee), (BEHIND, BEFORE));
    assert!((rates[1] - 3.0).abs() < 1e-2, "{rates:?}");
    let rates = go(&mut tracker, 0.3);
    assert_eq!((tracker.solver().elbow, tracker.solver().knee), (BEHIND, BEHIND));
    assert!((rates[1] - 3.0).abs() < 1e-2, "{rates:?}");
}

#[test]
fn a_change_point_behind_the_end_of_a_step_is_left_to_the_next_step() {
    ends_between::<f64>();
    ends_between::<f32>();
}

/// A parallelogram's rocker turns as its crank does, without an acceleration, however close to the change
/// point a walk of small steps comes. From the solver's own formulas its second rate is off by some ε/w³ at
/// w from it, and below `near` = ½ w² of the scale it is interpolated. Forty ε are for the roundings of
/// some ten operations, and for the weights of eight nodes. The walk is by 25ths of the distance, and by hundredths
/// in `.ci/nightly`.
fn accelerations<T: Float>(near: f64) -> f64 {
    let width = angle(near);
    let allowed = 40.0 * T::EPSILON / width.powi(3);
    let mut worst = 0.0_f64;
    for sign in [1.0, -1.0] {
        let solver = ScaledPairs::<T>::default();
        let elbow = if sign > 0.0 { solver.elbow } else { solver.elbow.flipped() };
        let mut tracker = Tracker::new(ScaledPairs { elbow, ..solver });
        // By parts of the distance, from far away to as near as rounding lets it.
        let shrunk = 1.0 - 1.0 / cases(25, 100) as f64;
        let mut off = 8.0 * width;
        while off > 1e-3 * width {
            let motion =
                tracker.motion(number::<T>(sign * off), number::<T>(-sign), number::<T>(0.0));
            let rocker = motion.expect("it turns").acceleration.DC.alpha.value();
            worst = worst.max(rocker.abs());
            assert!(rocker.abs() < allowed, "{off:e}: {rocker:e}, {allowed:e} allowed");
            off *= shrunk;
        }
    }
    worst / allowed
}

#[test]
fn accelerations_are_as_right_next_to_a_change_point_as_where_interpolation_begins() {
    println!(
        "{} and {} of what is allowed",
        accelerations::<f64>(1.2e-4),
        accelerations::<f32>(4.8e-3)
    );
}

/// Bars that miss the change point by more than counts have one mode on both sides, and turn over
/// within √(2 misfit) of an angle: nothing is interpolated over that, and the answer is the solver's.
fn near_misses<T: Float>() {
    for parts in [1.5, 10.0, 300.0] {
        let base = ground::<T>(parts * root::<T>());
        let solver = ScaledPairs::<T> { base, ..ScaledPairs::default() };
        let mut tracker = Tracker::new(solver);
        for step in -400..=400 {
            let theta = number::<T>(0.3 * f64::from(step) / 400.0);
            let [one, none] = [number::<T>(1.0), number::<T>(0.0)];
            let found = tracker.motion(theta, one, none).expect("it turns");
            let wanted = solver.motion(theta, one, none).expect("it assembles");
            let rows = |motion: ScaledPairsMotion<T>| motion.into_array().map(Real::value);
            assert_eq!(rows(found), rows(wanted), "{parts} √ε at {}", theta.value());
            assert_eq!(tracker.solver().elbow, solver.elbow, "{parts} √ε at {}", theta.value());
        }
    }
}

#[test]
fn a_near_miss_has_the_answers_of_the_solver() {
    near_misses::<f64>();
    near_misses::<f32>();
}

/// A first pose next to one group's change point, with another's on the way to where rounding no longer
/// shows, has the modes of the solver: each group is in the branch that the solver gives it.
fn first_poses<T: Float>(near: f64) {
    let width = angle(near);
    // Clear of its limit, by four times √ε: half of the width in `f32`.
    for off in [0.6, 0.8, -0.6, -0.8].map(|share| share * width) {
        for rate in [1.0, -1.0] {
            for place in [-1.1, -0.5, 0.5, 1.1].map(|share| off + share * width) {
                for modes in [[BEFORE, BEHIND], [BEHIND, BEFORE], [BEFORE; 2], [BEHIND; 2]] {
                    let [elbow, knee] = modes;
                    let shift = number(3.0 * place);
                    let solver = SideBySide { elbow, knee, shift, ..SideBySide::<T>::default() };
                    let [theta, rate, none] = [off, rate, 0.0].map(number::<T>);
                    let mut tracker = Tracker::new(solver);
                    let found = tracker.motion(theta, rate, none).expect("it goes on").position;
                    let wanted = solver.position(theta).expect("it assembles");
                    let other =
                        SideBySide { elbow: elbow.flipped(), knee: knee.flipped(), ..solver };
                    let other = other.position(theta).expect("it assembles");
                    let links = [[found.DC, wanted.DC, other.DC], [found.TR, wanted.TR, other.TR]];
                    for [found, wanted, other] in links {
                        let from = |branch: Direction<T>| {
                            (found.cos - branch.cos).value().hypot((found.sin - branch.sin).value())
                        };
                        // In `f32` a link that turns nine times as fast is interpolated to 0.03.
                        let [right, wrong] = [wanted, other].map(from);
                        assert!(
                            right < 0.5 * wrong,
                            "{off:e} {place:e} {modes:?}: {right} {wrong}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn a_first_pose_next_to_a_change_point_has_the_modes_of_the_solver() {
    first_poses::<f64>(1.2e-4);
    first_poses::<f32>(4.8e-3);
}

/// Two parallelograms in a row pass their change points at once. A first pose next to them is clear of
/// both, and the second crank's rates are made of the root of the first one's clearance. An ordinary run takes
/// ten of the forty distances that `.ci/nightly` takes.
fn first_poses_in_a_row<T: Float>(near: f64) {
    let width = angle(near);
    let least = angle(4.5 * root::<T>());
    let count = cases(10, 40);
    let part = |nth: usize| nth as f64 / (count - 1) as f64;
    for off in (0..count).map(|nth| least + (0.97 * width - least) * part(nth)) {
        for (side, mode) in [(1.0, Side::Left), (-1.0, Side::Right)] {
            for rate in [1.0, -1.0] {
                let solver = TwoGrounds { elbow: mode, knee: mode, ..TwoGrounds::<T>::default() };
                let [theta, rate, none] = [side * off, rate, 0.0].map(number::<T>);
                let motion = Tracker::new(solver).motion(theta, rate, none);
                let velocity = motion.expect("it goes on").velocity;
                for omega in [velocity.DC.omega, velocity.FE.omega] {
                    let by = (omega / rate).value() - 1.0;
                    // Rates are off by some ε over the square of the distance.
                    let allowed = 40.0 * T::EPSILON / (least * least);
                    assert!(by.abs() < allowed, "{off:e} {side}: {by:e} of {allowed:e}");
                }
            }
        }
    }
}

#[test]
fn a_first_pose_next_to_two_change_points_turns_on() {
    first_poses_in_a_row::<f64>(1.2e-4);
    first_poses_in_a_row::<f32>(4.8e-3);
}
