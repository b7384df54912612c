//! Efforts of mechanisms with laws, with outputs of efforts, with loads that drive and with told inputs, by numbers of
//! every class and of sizes from 1e-9 to 1e9: finite, or a typed error.

use linkage_core::{Given, Record, mechanism};
use linkage_tests::mechanisms::pulled::{Arm, Commanded, Engine};
use linkage_tests::mechanisms::rubbing_pulled::RubbingEngine;
use linkage_tests::mechanisms::told::{Chain, Trolley};

use super::calls::{At, Calls};
use super::numbers::{Number, Source};

mechanism! {
    /// A press with laws of rates and loads, in forces, in a coefficient of friction and in outputs.
    pub struct Lawful {
        input theta: angle;
        param damping = 40(N*s/m);
        param mu = 0.1;
        load work: force;
        ground A(0, 0);
        guide bed through A along 0deg;
        crank AB(A) -> B          { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        let speed = rate(ram.slide);
        let hot = exp(-abs(speed) / 2(m/s));
        let brake = -damping * speed * hot - work;
        mass 40kg on C;
        mass 5kg on BC uniform;
        inertia 0.4(kg*m^2) on AB;
        force (brake, min(0, brake)) on C;
        friction mu at A radius 30mm;
        friction mu + 0.1 * hot on ram length 120mm;
        output theta.drive, ram.bed, losses, brake, AB.A.friction,
            power = theta.drive * rate(theta), ratio = ram.bed.normal / (abs(brake) + 1N),
            share = ram.bed.couple / theta.drive, size = hypot(AB.A.x, AB.A.y);
    }
}

/// Numbers that are meant, one that is odd among them, all odd, or all of any size.
fn drawn<T: Number, const N: usize>(source: &mut Source) -> [T; N] {
    let (kind, odd) = (source.below(5), source.below(N));
    core::array::from_fn(|place| match kind {
        0 if place == odd => source.odd(),
        1 => source.odd(),
        2 => {
            let size = 10.0_f64.powf(source.between(-9.0, 9.0));
            T::near(if source.below(2) == 0 { size } else { -size })
        }
        _ => T::near(source.between(-4.0, 4.0)),
    })
}

/// A parameter as declared or any other.
fn param<T: Number>(source: &mut Source, declared: T) -> T {
    match source.below(4) {
        0 => source.odd(),
        1 => T::near(10.0_f64.powf(source.between(-9.0, 9.0))),
        _ => declared,
    }
}

/// An answer and that of the function without a branch.
macro_rules! both {
    ($at:ident, $name:literal, $solver:ident.$call:ident/$straight:ident($($given:expr),*)) => {{
        let found = $solver.$call($($given),*).map(|record| record.into_array());
        let found = $at.answer($name, found);
        let (record, usable) = $solver.$straight($($given),*);
        $at.straight($name, (record.into_array(), usable), found.as_ref());
    }};
}

fn lawful<T: Number>(source: &mut Source, calls: &mut Calls) {
    let [q, rate, second, work, creep, drive] = drawn::<T, 6>(source);
    let declared = Lawful::<T>::default();
    let solver =
        Lawful { damping: param(source, declared.damping), mu: param(source, declared.mu) };
    let state = (solver, [q, rate, second, work, creep, drive]);
    let mut at = At { calls, mechanism: "Lawful", state: &state };
    both!(at, "forces", solver.forces / solve_forces(q, rate, second, work));
    both!(at, "statics", solver.statics / solve_statics(q, creep, work));
    at.answer("holding", solver.holding(q, work));
    at.answer("forward_dynamics", solver.forward_dynamics(q, rate, drive, work).map(|a| [a]));
}

fn engines<T: Number>(source: &mut Source, calls: &mut Calls) {
    let [q, rate, second, brake, creep, gas] = drawn::<T, 6>(source);
    let numbers = [q, rate, second, brake, creep, gas];
    let solver = Engine { damping: param(source, Engine::<T>::default().damping) };
    let state = (solver, numbers);
    let mut at = At { calls: &mut *calls, mechanism: "Engine", state: &state };
    both!(at, "forces", solver.forces / solve_forces(q, rate, second, brake));
    both!(at, "statics", solver.statics / solve_statics(q, brake));
    at.answer("state_rates", solver.state_rates([q, rate], gas, brake));
    let solver = RubbingEngine { mu: param(source, RubbingEngine::<T>::default().mu) };
    let state = (solver, numbers);
    let mut at = At { calls: &mut *calls, mechanism: "RubbingEngine", state: &state };
    both!(at, "forces", solver.forces / solve_forces(q, rate, second, brake));
    both!(at, "statics", solver.statics / solve_statics(q, creep, brake));
    at.answer("holding", solver.holding(q, brake));
    at.answer("forward_dynamics", solver.forward_dynamics(q, rate, gas, brake).map(|a| [a]));
    let solver = Commanded::<T>::default();
    let mut at = At { calls, mechanism: "Commanded", state: &numbers };
    at.answer("forces", solver.forces(q, rate, second, brake).map(Record::into_array));
}

fn arm<T: Number>(source: &mut Source, calls: &mut Calls) {
    let [q, p, v, w, a, b, hand, shoulder, cylinder] = drawn::<T, 9>(source);
    let (solver, state) = (Arm::<T>::default(), [q, p, v, w, a, b, hand, shoulder, cylinder]);
    let mut at = At { calls, mechanism: "Arm", state: &state };
    both!(at, "forces", solver.forces / solve_forces([q, p], [v, w], [a, b], hand));
    both!(at, "statics", solver.statics / solve_statics([q, p], hand));
    let found = solver.forward_dynamics([q, p], [v, w], [shoulder, cylinder], hand);
    at.answer("forward_dynamics", found);
}

/// Told inputs of any mask; what is told stays as it was told.
macro_rules! told {
    ($at:ident, $solver:ident, $count:literal, $q:expr, $rates:expr, $given:expr $(, $load:expr)?) => {{
        let given: [Given<T>; $count] = $given;
        let found = $solver.mixed_dynamics($q, $rates, given $(, $load)?);
        if let Ok(found) = &found {
            for (nth, given) in given.into_iter().enumerate() {
                let is_kept = match given {
                    Given::Acceleration(rate) => rate == found.accelerations[nth],
                    Given::Drive(drive) => drive == found.drives[nth],
                };
                if !is_kept {
                    $at.wrong("mixed_dynamics", "another number than was given", found);
                }
            }
        }
        let found = found.map(|found| [found.accelerations, found.drives].concat());
        $at.answer("mixed_dynamics", found);
        let state = [$q, $rates].concat().try_into().expect("two orders");
        $at.answer("state_rates_given", $solver.state_rates_given(state, given $(, $load)?));
    }};
}

fn chain<T: Number>(source: &mut Source, calls: &mut Calls) {
    let (q, rates): ([T; 5], [T; 5]) = (drawn(source), drawn(source));
    let (numbers, [hand]) = (drawn::<T, 5>(source), drawn(source));
    let given = numbers.map(|number| match source.below(2) {
        0 => Given::Acceleration(number),
        _ => Given::Drive(number),
    });
    let solver = Chain { tip: param(source, Chain::<T>::default().tip) };
    let state = (solver, q, rates, given, hand);
    let mut at = At { calls: &mut *calls, mechanism: "Chain", state: &state };
    told!(at, solver, 5, q, rates, given, hand);
    let [x, sway, v, w] = drawn::<T, 4>(source);
    let solver = Trolley::<T>::default();
    let state = ([x, sway, v, w], given);
    let mut at = At { calls, mechanism: "Trolley", state: &state };
    told!(at, solver, 2, [x, sway], [v, w], [given[0], given[1]]);
}

/// So many calls of all of them.
pub(crate) fn run<T: Number>(source: &mut Source, count: u64, calls: &mut Calls) {
    let end = calls.count + count;
    while calls.count < end {
        lawful::<T>(source, calls);
        engines::<T>(source, calls);
        arm::<T>(source, calls);
        chain::<T>(source, calls);
    }
}
