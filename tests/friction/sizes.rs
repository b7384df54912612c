//! Machines a thousand million times as large or as small, under forces as large or as small: in powers of two
//! every number is the same but for its exponent.

use linkage_core::{Float, Record, SolveError, Status, mechanism};
use linkage_tests::random::{Random, cases};

mechanism! {
    /// A six-bar of which `size` makes every length, and `force` and both together every load.
    pub struct Sized {
        input theta: angle;
        param mu = 0.1;
        param size = 1;
        param weight = 2kg;
        param stiff = 300(N*m/rad);
        load work: force;
        ground A(0, 0), D(0.9m * size, -0.1m * size);
        guide rail through (0, 0.9m * size) along 5deg;
        crank AB(A) -> B { length: 0.2m * size, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (0.8m * size, 0.5m * size), mode: left }
        rrp CK(C), ram(rail) -> K { length: 0.9m * size, mode: ahead }
        let law = work * (1 + 0.1 * sign(rate(theta)));
        mass weight on BC uniform;
        mass weight on K;
        force (law, 0) on K;
        torque 0.1m * size * work on DC;
        stop end DC.angle between (60deg, 80deg) { stiffness: stiff }
        friction mu at A radius 12mm * size;
        friction mu at B radius 12mm * size;
        friction mu on BC at C radius 12mm * size;
        friction mu at D radius 12mm * size;
        friction mu between CK and BC at C radius 12mm * size;
        friction mu on CK at K radius 12mm * size;
        friction mu on ram length 120mm * size;
        output AB.A, BC.B, BC.C, DC.D, CK.C, ram.rail, ram.rail.friction, theta.drive, losses, end.force,
            BC.B.friction;
    }
}

mechanism! {
    /// A crank that its piston pushes; the load follows.
    pub struct SizedPump {
        input theta: angle;
        param mu = 0.1;
        param size = 1;
        load brake: torque;
        load push: force;
        ground A(0, 0);
        guide bore through A along 0deg;
        crank AB(A) -> B              { length: 80mm * size, angle: theta }
        rrp   BC(B), piston(bore) -> C { length: 250mm * size, mode: ahead }
        torque -brake on AB;
        force (push, 0) on C;
        friction mu at A radius 20mm * size;
        friction mu at B radius 20mm * size;
        friction mu on BC at C radius 20mm * size;
        friction mu on piston length 90mm * size;
        drive theta by push;
        output push, AB.A, piston.bore;
    }
}

/// Powers of two: 2³⁰ is 1.07e9.
const POWERS: [i32; 5] = [-30, -11, 0, 13, 30];

fn number<T: Float>(x: f64) -> T {
    T::lit(x, x as f32)
}

/// Forces and couples of an answer.
type Numbers = Result<(Vec<f64>, Vec<f64>), SolveError>;

/// Everything that is asked of a machine, its lengths and forces by these powers of two.
fn asked<T: Float>(random: &mut Random, [size, force]: [i32; 2]) -> Vec<Numbers> {
    let [mu, q, rate, accel, work, drive] =
        [(0.0, 1.2), (-3.2, 3.2), (-9.0, 9.0), (-40.0, 40.0), (-500.0, 500.0), (-90.0, 90.0)]
            .map(|(low, high)| random.between(low, high));
    let [size, force] = [size, force].map(|power| 2.0_f64.powi(power));
    let lit = number::<T>;
    let bar = Sized::<T> {
        mu: lit(mu),
        size: lit(size),
        weight: lit(2.0 * force / size),
        stiff: lit(300.0 * force * size),
    };
    let by_kind = |numbers: Result<SizedForces<T>, SolveError>| {
        let numbers = numbers?.into_array().map(|number| number.value());
        // Friction of a pin, the couple of the guide, the drive, the losses, and the stop.
        let is_couple = |at: &usize| [6, 12, 14, 15, 16].contains(at);
        let (couples, forces): (Vec<_>, Vec<_>) = (0..numbers.len()).partition(is_couple);
        Ok((
            forces.iter().map(|&at| numbers[at]).collect(),
            couples.iter().map(|&at| numbers[at]).collect(),
        ))
    };
    let [q, rate, accel, work] = [q, rate, accel, work * force].map(lit);
    let zero = lit(0.0);
    let couples = |found: Result<Vec<T>, SolveError>| {
        Ok((Vec::new(), found?.into_iter().map(|number| number.value()).collect()))
    };
    let pump = SizedPump::<T> { mu: lit(0.2 * mu), size: lit(size) };
    let pushed = pump.statics(q, rate, lit(drive * force * size)).map(|found| {
        let numbers = found.into_array().map(|number| number.value());
        (numbers[..4].to_vec(), numbers[4..].to_vec())
    });
    let second = bar.forward_dynamics(q, rate, lit(drive * force * size), work);
    vec![
        by_kind(bar.forces(q, rate, accel, work)),
        by_kind(bar.forces(q, zero, accel, work)),
        by_kind(bar.statics(q, rate, work)),
        couples(bar.holding(q, work).map(|ends| ends.to_vec())),
        second.map(|second| (Vec::new(), vec![second.value() * force * size])),
        pushed,
    ]
}

/// All answers at these powers, the same draws at each.
fn all<T: Float>(draws: usize, powers: [i32; 2]) -> Vec<Numbers> {
    let mut random = Random::new(51);
    (0..draws).flat_map(|_| asked::<T>(&mut random, powers)).collect()
}

/// Compares all answers at these powers with those at the size of one; the number of answers and of refusals.
fn compare<T: Float>(draws: usize, at_one: &[Numbers], powers: [i32; 2]) -> [usize; 2] {
    let [size, force] = powers.map(|power| 2.0_f64.powi(power));
    let mut counts = [0; 2];
    for (plain, scaled) in at_one.iter().zip(all::<T>(draws, powers)) {
        match (plain, scaled) {
            (Ok((forces, couples)), Ok(scaled)) => {
                let forces: Vec<f64> = forces.iter().map(|x| x * force).collect();
                let couples: Vec<f64> = couples.iter().map(|x| x * force * size).collect();
                assert!(forces.iter().chain(&couples).all(|number| number.is_finite()));
                assert_eq!((forces, couples), scaled, "{powers:?}");
                counts[0] += 1;
            }
            (plain, scaled) => {
                let status = |found: Option<SolveError>| found.map_or(Status::Solved, Status::from);
                let [plain, scaled] = [plain.as_ref().err().copied(), scaled.err()].map(status);
                assert_eq!(plain, scaled, "{powers:?}");
                counts[1] += 1;
            }
        }
    }
    counts
}

/// A sample of the draws of `.ci/nightly`, at every pair of powers.
#[test]
fn sizes_change_exponents_alone() {
    let draws = cases(40, 100);
    let (wide, narrow) = (all::<f64>(draws, [0, 0]), all::<f32>(draws, [0, 0]));
    for size in POWERS {
        for force in POWERS {
            let powers = [size, force];
            let counts =
                [compare::<f64>(draws, &wide, powers), compare::<f32>(draws, &narrow, powers)];
            assert!(counts.as_flattened().iter().all(|&count| count > draws), "{counts:?}");
        }
    }
}
