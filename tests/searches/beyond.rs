//! Drawn machines beyond what they reach: every entry point refuses by a limit, and by links that are drawn, never by a number
//! that is none.

use linkage_core::{Record, SolveError, Status, mechanism};

mechanism! {
    /// A four-bar knee: thigh is the ground, the shank is the coupler, and its flexion is given. A dyad.
    struct Knee {
        input flexion: angle;
        ground A(0, 0), D(-35mm, 10mm);
        pin B(12mm, -70mm), C(-25mm, -62mm), ankle(0, -450mm);
        link front(A, B);
        link rear(D, C);
        link shank(B, C, ankle);
        drive shank.angle = 167.8deg - flexion;
    }
}

mechanism! {
    /// The same with a foot: a search, so that the reactions in all joints are known.
    struct Leg {
        input flexion: angle;
        load ground_force: force;
        ground A(0, 0), D(-35mm, 10mm);
        pin B(12mm, -70mm), C(-25mm, -62mm), ankle(0, -450mm);
        link front(A, B);
        link rear(D, C);
        link shank(B, C, ankle);
        drive shank.angle = 167.8deg - flexion;
        mass 1kg on ankle;
        force (0, ground_force) on ankle;
        output ankle, B, C, shank.B, shank.C, flexion.drive;
    }
}

mechanism! {
    /// A shear whose cross slide is given: a group of class III over a slide.
    struct Shear {
        input x: length;
        ground A(0, 0), D(665.7mm, 0);
        guide floor through (0, 0) along 0deg;
        pin B(-30mm, 70mm), C(560mm, -360mm), blade(500mm, -410mm);
        link AB(A, B), BC(B, C, blade), DC(D, C), cross() on floor;
        guide way on cross through blade along 90deg;
        link ride(blade) on way;
        drive cross.slide = x;
    }
}

/// True of a pose, and of a refusal by a limit that names these links alone.
fn is_limit(links: &[&str], error: SolveError) -> bool {
    let names = match error {
        SolveError::OutOfReach { group, by } => Some((group, by)),
        SolveError::NoSolution { unknown, by, .. } => Some((unknown, by)),
        SolveError::SeveralDeadPoints { unknown } => Some((unknown, 1.0)),
        _ => None,
    };
    names.is_some_and(|(names, by)| {
        by > 0.0 && by.is_finite() && names.split(", ").all(|name| links.contains(&name))
    })
}

/// The count of refusals among the answers at inputs, each of which is a limit.
macro_rules! refusals {
    ($links:expr, $inputs:expr, $at:ident => [$($answer:expr),* $(,)?]) => {{
        let mut refused = 0;
        for $at in $inputs {
            let answers = [$($answer.map(|_| ())),*];
            for (nth, answer) in answers.iter().enumerate() {
                if let Err(error) = *answer {
                    assert!(is_limit($links, error), "answer {nth} at {}: {error}", $at);
                }
                // Where nothing moves there may be a pose at the limit itself.
                assert_eq!(answer.is_err(), answers[0].is_err(), "answer {nth} at {}", $at);
            }
            refused += u32::from(answers[0].is_err());
        }
        refused
    }};
}

/// All over a turn, off the limits themselves.
fn turn() -> impl Iterator<Item = f64> {
    (-180..180).map(|degree| (f64::from(degree) + 0.3).to_radians())
}

fn slides() -> impl Iterator<Item = f64> {
    (-200..200).map(|step| 0.02 * (f64::from(step) + 0.3))
}

const OF_KNEE: &[&str] = &["front", "rear", "shank"];
const OF_SHEAR: &[&str] = &["AB", "BC", "DC", "cross", "ride"];

#[test]
fn a_knee_beyond_its_range_is_at_a_limit_in_every_entry_point() {
    let (wide, narrow) = (Knee::new(), Knee::<f32>::default());
    let refused = refusals!(OF_KNEE, turn(), q => [
        wide.position(q), wide.velocity(q, 1.0), wide.motion(q, 1.0, 0.5), wide.jacobian(q),
        wide.coefficients(q),
    ]);
    // There is no pose next to 3.75° alone, where the shank's vector is that of the grounds.
    assert_eq!(refused, 2);
    let refused = refusals!(OF_KNEE, turn().map(|q| q as f32), q => [
        narrow.position(q), narrow.velocity(q, 1.0), narrow.motion(q, 1.0, 0.5), narrow.jacobian(q),
        narrow.coefficients(q),
    ]);
    assert_eq!(refused, 2);
}

#[test]
fn a_leg_beyond_its_range_is_at_a_limit_in_every_entry_point() {
    let (wide, narrow) = (Leg::new(), Leg::<f32>::default());
    let refused = refusals!(OF_KNEE, turn(), q => [
        wide.position(q), wide.velocity(q, 1.0), wide.motion(q, 1.0, 0.5), wide.jacobian(q),
        wide.coefficients(q), wide.forces(q, 1.0, 0.5, 700.0), wide.statics(q, 700.0),
        wide.forward_dynamics(q, 1.0, 2.0, 700.0), wide.state_rates([q, 1.0], 2.0, 700.0),
    ]);
    // The search was followed from -91.85° to 2.49°. It refuses most of what is beyond, and what it finds there is a pose.
    assert!((155..170).contains(&refused), "{refused}");
    let knee = Knee::new();
    for q in turn() {
        let Ok(p) = wide.position(q) else { continue };
        let right = knee.position(q).unwrap();
        let off = f64::hypot(p.B.x - right.B.x, p.B.y - right.B.y);
        // A root is known to the rounding of the sides over the slope, which is above 1e-6 at these angles.
        assert!(off < 1e-9, "{q}: {off:e}");
    }
    let refused = refusals!(OF_KNEE, turn().map(|q| q as f32), q => [
        narrow.position(q), narrow.velocity(q, 1.0), narrow.motion(q, 1.0, 0.5), narrow.jacobian(q),
        narrow.coefficients(q), narrow.forces(q, 1.0, 0.5, 700.0), narrow.statics(q, 700.0),
        narrow.forward_dynamics(q, 1.0, 2.0, 700.0), narrow.state_rates([q, 1.0], 2.0, 700.0),
    ]);
    assert!((155..170).contains(&refused), "{refused}");
}

#[test]
fn a_shear_beyond_its_range_is_at_a_limit_in_every_entry_point() {
    let (wide, narrow) = (Shear::new(), Shear::<f32>::default());
    let refused = refusals!(OF_SHEAR, slides(), x => [
        wide.position(x), wide.velocity(x, 1.0), wide.motion(x, 1.0, 0.5), wide.jacobian(x),
        wide.coefficients(x),
    ]);
    assert!((300..400).contains(&refused), "{refused}");
    let refused = refusals!(OF_SHEAR, slides().map(|x| x as f32), x => [
        narrow.position(x), narrow.velocity(x, 1.0), narrow.motion(x, 1.0, 0.5), narrow.jacobian(x),
        narrow.coefficients(x),
    ]);
    assert!((300..400).contains(&refused), "{refused}");
}

/// Newton's and Euler's equations of the shank, which both bars push along themselves alone, give what presses at its pins and
/// what drives it.
#[test]
fn what_presses_on_a_driven_shank_is_in_balance() {
    let leg = Leg::new();
    let mut loaded = 0;
    for q in (-90..=0).map(|degree| f64::from(degree).to_radians()) {
        let (p, m) = (leg.position(q).unwrap(), leg.motion(q, 3.0, -20.0).unwrap());
        let f = leg.forces(q, 3.0, -20.0, 700.0).unwrap();
        let a = m.acceleration.ankle;
        // Both bars push as much as it takes: the mass of 1 kg times its acceleration less the load.
        let needed = [a.x, a.y - 700.0];
        let along = |pin: [f64; 2], ground: [f64; 2]| {
            let (x, y) = (pin[0] - ground[0], pin[1] - ground[1]);
            [x / x.hypot(y), y / x.hypot(y)]
        };
        let (b, c) = ([p.B.x, p.B.y], [p.C.x, p.C.y]);
        let (front, rear) = (along(b, [0.0, 0.0]), along(c, [-0.035, 0.01]));
        let cross = |[x, y]: [f64; 2], [u, v]: [f64; 2]| x * v - y * u;
        let sine = cross(front, rear);
        let pushes = [cross(needed, rear) / sine, cross(front, needed) / sine];
        let (at_b, at_c) = (front.map(|x| x * pushes[0]), rear.map(|x| x * pushes[1]));
        let from_ankle = |pin: [f64; 2]| [pin[0] - p.ankle.x, pin[1] - p.ankle.y];
        let couple = -cross(from_ankle(b), at_b) - cross(from_ankle(c), at_c);
        // The angle of the shank falls as it is flexed. Rounding leaves some dozen units in
        // the last place of the largest push, and of its arm of 0.5 m.
        let size = pushes[0].abs() + pushes[1].abs() + 700.0;
        let within = 64.0 * f64::EPSILON * size / sine.abs();
        let pairs = [
            (f.shank.B.x, at_b[0]),
            (f.shank.B.y, at_b[1]),
            (f.shank.C.x, at_c[0]),
            (f.shank.C.y, at_c[1]),
            (f.flexion.drive, -couple),
        ];
        for (nth, (found, right)) in pairs.into_iter().enumerate() {
            assert!((found - right).abs() <= within, "{nth} at {q}: {found} {right}");
        }
        loaded += u32::from(size > 1000.0);
    }
    assert!(loaded > 80, "{loaded}");
}

/// The statuses of a sweep are those of single calls, and none says that a number is not finite.
#[test]
fn sweeps_beyond_what_is_reached_have_the_statuses_of_calls() {
    macro_rules! swept {
        ($solver:expr, $record:ident, $inputs:expr) => {{
            let inputs: Vec<f64> = $inputs.collect();
            let mut status = vec![Status::Solved; inputs.len()];
            let mut rows = vec![vec![0.0; inputs.len()]; $record::<f64>::LABELS.len()];
            let mut parts = rows.iter_mut();
            let out = std::array::from_fn(|_| &mut parts.next().expect("a row a number")[..]);
            let out = <$record<&mut [f64]> as Record>::from_array(out);
            $solver
                .sweep_position(&inputs[..], out, &mut status, ())
                .expect("all are of one length");
            for (&at, &status) in inputs.iter().zip(&status) {
                let single = match $solver.position(at) {
                    Ok(_) => Status::Solved,
                    Err(SolveError::OutOfReach { .. }) => Status::OutOfReach,
                    Err(SolveError::NoSolution { .. }) => Status::NoSolution,
                    Err(SolveError::SeveralDeadPoints { .. }) => Status::SeveralDeadPoints,
                    Err(other) => panic!("{other} at {at}"),
                };
                assert_eq!(status, single, "at {at}");
            }
        }};
    }
    swept!(Knee::new(), KneePosition, turn());
    swept!(Leg::new(), LegPosition, turn());
    swept!(Shear::new(), ShearPosition, slides());
}
