//! Drawn parallelograms stay such at run time: in both widths, in sweeps and on dual numbers; and what presses in their joints
//! is told everywhere but where all of them are in one line.

use std::f64::consts::{PI, TAU};

use linkage_core::{Record, SolveError, Status, mechanism};
use linkage_tests::random::Random;
use num_dual::Dual64;

mechanism! {
    /// A wiper for two blades: the second rocker hangs on the first by a tie rod.
    struct Wiper {
        input theta: angle;
        ground A(0, 0), D(-250mm, 60mm), H(350mm, 60mm);
        pin B(45mm, 0), C(-245mm, -20mm), E(-320mm, 50mm), F(280mm, 50mm);
        link AB(A, B);
        link rod(B, C);
        link first(D, C, E);
        link tie(E, F);
        link second(H, F);
        drive AB.angle = theta;
    }
}

mechanism! {
    /// The rods of a locomotive, pushed at the last wheel.
    struct Rods {
        input theta: angle;
        load steam: force;
        ground A(0, 0), D(1.4m, 0), G(2.9m, 0);
        pin B(0.12m, 0.16m), C(1.52m, 0.16m), F(3.02m, 0.16m);
        link first(A, B), second(D, C), third(G, F), rod(B, C), rear(C, F);
        drive first.angle = theta;
        mass 80kg on rod uniform;
        force (0, steam) on F;
    }
}

/// The angles of a turn and a half, the change points among them.
fn angles() -> Vec<f64> {
    (-36..=72).map(|step| f64::from(step) * TAU / 72.0).collect()
}

/// C − D is B − A: the opening of a parallelogram, whose corners are rounded in numbers of this size.
macro_rules! opening {
    ($pose:expr, $tip:ident - $pivot:expr, $of:ident - $at:expr) => {{
        let (tip, of, pivot, at) = ($pose.$tip, $pose.$of, $pivot, $at);
        (tip.x - pivot[0] - (of.x - at[0])).hypot(tip.y - pivot[1] - (of.y - at[1]))
    }};
}

#[test]
fn both_widths_stay_parallelograms_through_all_change_points() {
    let (wiper, narrow) = (Wiper::new(), Wiper::<f32>::default());
    let (rods, thin) = (Rods::new(), Rods::<f32>::default());
    for theta in angles() {
        let p = wiper.position(theta).unwrap();
        // Sums of lengths of less than a metre, and of three.
        assert!(opening!(p, F - [0.35, 0.06], E - [-0.25, 0.06]) < 4.0 * f64::EPSILON, "{theta}");
        let p = rods.position(theta).unwrap();
        assert!(opening!(p, C - [1.4, 0.0], B - [0.0, 0.0]) < 8.0 * f64::EPSILON, "{theta}");
        assert!(opening!(p, F - [2.9, 0.0], C - [1.4, 0.0]) < 8.0 * f64::EPSILON, "{theta}");
        let p = narrow.position(theta as f32).unwrap();
        assert!(opening!(p, F - [0.35, 0.06], E - [-0.25, 0.06]) < 4.0 * f32::EPSILON, "{theta}");
        let p = thin.position(theta as f32).unwrap();
        assert!(opening!(p, C - [1.4, 0.0], B - [0.0, 0.0]) < 8.0 * f32::EPSILON, "{theta}");
        assert!(opening!(p, F - [2.9, 0.0], C - [1.4, 0.0]) < 8.0 * f32::EPSILON, "{theta}");
        // Both wheels turn as one: bars of one length keep their direction and their pace.
        let m = rods.motion(theta, 3.0, -2.0).unwrap();
        let rates = [m.velocity.second.omega, m.velocity.third.omega, m.velocity.rod.omega];
        assert_eq!(rates, [3.0, 3.0, 0.0], "{theta}");
        let rates = [m.acceleration.second.alpha, m.acceleration.rear.alpha];
        assert_eq!(rates, [-2.0, 0.0], "{theta}");
    }
}

#[test]
fn a_sweep_has_the_numbers_of_its_single_calls() {
    let angles = angles();
    const NUMBERS: usize = WiperPosition::<f64>::LABELS.len();
    let mut rows = vec![vec![f64::NAN; angles.len()]; NUMBERS];
    let mut status = vec![Status::Solved; angles.len()];
    let mut parts = rows.iter_mut();
    let out: [&mut [f64]; NUMBERS] = std::array::from_fn(|_| &mut parts.next().unwrap()[..]);
    let out = <WiperPosition<&mut [f64]> as Record>::from_array(out);
    Wiper::new().sweep_position(&angles[..], out, &mut status, ()).unwrap();
    for (at, &theta) in angles.iter().enumerate() {
        assert_eq!(status[at], Status::Solved);
        let single = Wiper::new().position(theta).unwrap().into_array();
        // Blocks round otherwise than calls. `linkage report` proves each number within 9 ε.
        for (row, single) in rows.iter().zip(single) {
            assert!(
                (row[at] - single).abs() <= 18.0 * f64::EPSILON,
                "{theta}: {} {single}",
                row[at]
            );
        }
    }
}

/// The derivative of a pose on dual numbers is the Jacobian, at change points too.
#[test]
fn dual_numbers_have_the_derivatives_of_the_jacobian() {
    let (plain, dual) = (Rods::new(), Rods::<Dual64>::default());
    for theta in angles() {
        let p = dual.position(Dual64::new(theta, 1.0)).unwrap();
        let v = plain.velocity(theta, 1.0).unwrap();
        for (dual, plain) in [(p.B, v.B), (p.C, v.C), (p.F, v.F)] {
            // A product or two of each.
            let off = (dual.x.eps - plain.x).hypot(dual.y.eps - plain.y);
            assert!(off <= 4.0 * f64::EPSILON * 0.2, "{theta}: {off:e}");
        }
        let at = plain.position(theta).unwrap();
        assert_eq!([p.F.x.re, p.F.y.re], [at.F.x, at.F.y]);
    }
}

/// Where all pins of the rods are in one line their forces follow from nothing, and what drives the machine is known by
/// power alone; beside it everything is told, and larger the nearer.
#[test]
fn reactions_are_singular_where_all_pins_are_in_one_line() {
    let (rods, narrow) = (Rods::new(), Rods::<f32>::default());
    for theta in [0.0, PI, -PI, TAU] {
        let refusals = [
            rods.forces(theta, 2.0, 0.5, 1e3).map(drop),
            rods.statics(theta, 1e3).map(drop),
            narrow.forces(theta as f32, 2.0, 0.5, 1e3).map(drop),
            narrow.statics(theta as f32, 1e3).map(drop),
        ];
        for refused in refusals {
            let of = ["rear, third", "third, rear", "rod, second", "second, rod"];
            assert!(
                matches!(refused, Err(SolveError::Singular { group }) if of.contains(&group)),
                "{theta}: {refused:?}"
            );
        }
        rods.position(theta).unwrap();
        rods.motion(theta, 2.0, 0.5).unwrap();
        let found = rods.forward_dynamics(theta, 2.0, 5.0, 1e3).unwrap();
        assert!(found.is_finite());
    }
    let mut random = Random::new(3);
    for _ in 0..200 {
        let theta = random.anywhere(0.01, PI - 0.01);
        for theta in [theta, -theta] {
            let f = rods.forces(theta, 2.0, 0.5, 1e3).unwrap();
            // Power: the drive turns the mass of the rod, 80 kg at 0.2 m, and holds what is pushed at F.
            let wanted = 80.0 * 0.04 * 0.5 - 1e3 * 0.2 * theta.cos();
            let off = (f.theta.drive - wanted).abs();
            // The rods' forces grow as one over the sine, and so does what rounding leaves of their moment.
            assert!(off < 64.0 * f64::EPSILON * 1e3 / theta.sin().abs(), "{theta}: {off:e}");
        }
    }
    let angles = angles();
    let mut status = vec![Status::Solved; angles.len()];
    const NUMBERS: usize = RodsForces::<f64>::LABELS.len();
    let mut rows = vec![vec![0.0; angles.len()]; NUMBERS];
    let mut parts = rows.iter_mut();
    let out: [&mut [f64]; NUMBERS] = std::array::from_fn(|_| &mut parts.next().unwrap()[..]);
    let out = <RodsForces<&mut [f64]> as Record>::from_array(out);
    Rods::new().sweep_forces(&angles[..], 2.0, 0.5, 1e3, out, &mut status, ()).unwrap();
    for (&theta, status) in angles.iter().zip(status) {
        let single = Rods::new().forces(theta, 2.0, 0.5, 1e3);
        assert_eq!(status == Status::Singular, single.is_err(), "{theta}: {single:?}");
        assert_eq!(single.is_err(), theta.sin().abs() < 1e-9, "{theta}");
    }
}
