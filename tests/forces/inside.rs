//! Efforts inside a body whose parts move against each other: they act on the input that moves the parts
//! alone.

use linkage_core::{Real, differentiate};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::telescope::Telescope;
use linkage_tests::widths::{list, number};
use num_dual::DualSVec;

/// Values and rates of both inputs.
fn states() -> impl Iterator<Item = [[f64; 2]; 2]> {
    (0..40).map(|step| {
        let part = f64::from(step) / 40.0;
        [[6.3 * part, -0.1 + 0.35 * part], [1.5 - part, -0.4 + 0.9 * part]]
    })
}

/// From T to B it is (0.5 − s, −0.1) in the body, at any angle. The size of what is compared is 50 N: the
/// two masses' weight and inertia, and the spring at its longest. A hundred roundings at most.
fn a_spring_acts_on_the_slide_alone<T: Real>() {
    let pull = 7.0;
    let (with, without) =
        (Telescope::<T>::default(), Telescope { k: number::<T>(0.0), c: number::<T>(0.0) });
    let close = |what: &str, found: T, truth: f64| {
        let apart = (found.value() - truth).abs();
        assert!(apart < 100.0 * T::EPSILON * 50.0, "{what}: {found:?} {truth}");
    };
    for [q, rates] in states() {
        let (pose, rate, none) = (list::<T, 2>(q), list::<T, 2>(rates), number::<T>(0.0));
        let [s, speed] = [q[1], rates[1]];
        let length = (0.5 - s).hypot(0.1);
        let slope = (s - 0.5) / length;
        let by_spring = -40.0 * (length - 0.3) - 3.0 * slope * speed;

        let second = list::<T, 2>([0.8, -1.1]);
        let found = with.forces(pose, rate, second, number(pull)).expect("it is a crank");
        // In both the force's own damper stays.
        let bare = without.forces(pose, rate, second, none).expect("it is a crank");
        close("force", found.coil.force, by_spring);
        close("slide", found.s.drive - bare.s.drive, -slope * (by_spring + pull));
        close("crank", found.theta.drive - bare.theta.drive, 0.0);
        close("drive", found.AB.drive - bare.AB.drive, 0.0);
        close("bearing", found.AB.A.x - bare.AB.A.x, 0.0);
        close("bearing", found.AB.A.y - bare.AB.A.y, 0.0);
        close("length", with.position(pose).expect("it is a crank").coil_length, length);

        let [energy, less] = [&with, &without].map(|m| m.energy(pose, rate).expect("a crank"));
        let stored = 20.0 * (length - 0.3) * (length - 0.3);
        close("energy", energy.potential - less.potential, stored);
        let resting = with.statics(pose, none).expect("it is a crank").s.drive;
        let bare = without.statics(pose, none).expect("it is a crank").s.drive;
        close("statics", resting - bare, slope * 40.0 * (length - 0.3));

        let drives = list::<T, 2>([0.5, 2.0]);
        let moved = with.forward_dynamics(pose, rate, drives, number(pull)).expect("masses");
        let back = with.forces(pose, rate, moved, number(pull)).expect("it is a crank");
        close("drive of the crank", back.theta.drive, 0.5);
        close("drive of the slide", back.s.drive, 2.0);
    }
}

/// Energy grows by what the drives put in, less what the dampers take: T + V along the motion by dual numbers.
#[test]
fn energy_grows_by_what_drives_put_in() {
    let (free, pull) = (Telescope { c: 0.0, ..Telescope::new() }, 3.0);
    for [q, rates] in states() {
        let drives = [0.5, 2.0];
        let seconds = free.forward_dynamics(q, rates, drives, pull).expect("masses");
        let growth = differentiate([0.0], |[t]: [DualSVec<f64, 1>; 1]| {
            let real = DualSVec::from_re;
            let along = [0, 1].map(|k| t * real(rates[k]) + real(q[k]));
            let faster = [0, 1].map(|k| t * real(seconds[k]) + real(rates[k]));
            let machine = Telescope { k: real(40.0), c: real(0.0) };
            let energy = machine.energy(along, faster)?;
            Ok([energy.kinetic + energy.potential])
        });
        let growth = growth.expect("it is a crank")[(0, 0)];
        let [s, speed] = [q[1], rates[1]];
        let closing = (s - 0.5) / (0.5 - s).hypot(0.1) * speed;
        let put_in = drives[0] * rates[0] + drives[1] * speed + (pull + 2.0 * closing) * closing;
        // Some hundred roundings of powers of up to 50 W.
        assert!((growth - put_in).abs() < 100.0 * f64::EPSILON * 50.0, "{growth} {put_in}");
    }
}

in_both_widths! { a_spring_acts_on_the_slide_alone }
