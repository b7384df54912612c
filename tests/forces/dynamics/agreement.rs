//! Every mechanism of the tests that has equations of motion: they agree with the efforts that the same
//! motion asks for, with the energy, and with what a state's rates are made of.

use linkage_core::num_dual::{Dual2SVec, DualSVec};
use linkage_core::{Real, SolveError, differentiate, differentiate_twice};
use linkage_tests::mechanisms::dynamics::*;
use linkage_tests::mechanisms::forces::*;
use linkage_tests::random::Random;
use linkage_tests::widths::number;

/// Numbers of the inputs.
type Each<T, const N: usize> = [T; N];

/// Equations of motion, whatever the number of inputs.
trait Moving<T, const N: usize> {
    fn accelerations(&self, q: Each<T, N>, dq: Each<T, N>, drive: Each<T, N>) -> Each<T, N>;
    fn drives(&self, q: Each<T, N>, dq: Each<T, N>, ddq: Each<T, N>) -> Each<T, N>;
    fn equations(&self, q: Each<T, N>, dq: Each<T, N>) -> (Each<Each<T, N>, N>, Each<T, N>);
}

/// Kinetic and potential energy.
trait Energetic<T, const N: usize> {
    fn energies(&self, q: Each<T, N>, dq: Each<T, N>) -> Result<[T; 2], SolveError>;
}

/// With one input numbers are plain; loads stand behind everything else.
macro_rules! of_one_input {
    ($($name:ident: $owner:ident $(, $loads:expr)?;)+) => {$(
        impl<T: Real> Moving<T, 1> for $name<T> {
            fn accelerations(&self, [q]: [T; 1], [dq]: [T; 1], [drive]: [T; 1]) -> [T; 1] {
                [self.forward_dynamics(q, dq, drive $(, $loads)?).expect("a pose that moves")]
            }
            fn drives(&self, [q]: [T; 1], [dq]: [T; 1], [ddq]: [T; 1]) -> [T; 1] {
                [self.forces(q, dq, ddq $(, $loads)?).expect("a pose").$owner.drive]
            }
            fn equations(&self, [q]: [T; 1], [dq]: [T; 1]) -> ([[T; 1]; 1], [T; 1]) {
                let e = self.equations_of_motion(q, dq $(, $loads)?).expect("a pose");
                (e.mass, e.force)
            }
        }
    )+};
}

macro_rules! of_several_inputs {
    ($($name:ident<$count:literal>: $($owner:ident)+ $(, $loads:expr)?;)+) => {$(
        impl<T: Real> Moving<T, $count> for $name<T> {
            fn accelerations(
                &self,
                q: [T; $count],
                dq: [T; $count],
                drive: [T; $count],
            ) -> [T; $count] {
                self.forward_dynamics(q, dq, drive $(, $loads)?).expect("a pose that moves")
            }
            fn drives(&self, q: [T; $count], dq: [T; $count], ddq: [T; $count]) -> [T; $count] {
                let f = self.forces(q, dq, ddq $(, $loads)?).expect("a pose");
                [$(f.$owner.drive),+]
            }
            fn equations(
                &self,
                q: [T; $count],
                dq: [T; $count],
            ) -> ([[T; $count]; $count], [T; $count]) {
                let e = self.equations_of_motion(q, dq $(, $loads)?).expect("a pose");
                (e.mass, e.force)
            }
        }
    )+};
}

macro_rules! with_energy {
    ($($name:ident)+; $($several:ident<$count:literal>)+) => {
        $(impl<T: Real> Energetic<T, 1> for $name<T> {
            fn energies(&self, [q]: [T; 1], [dq]: [T; 1]) -> Result<[T; 2], SolveError> {
                self.energy(q, dq).map(|energy| [energy.kinetic, energy.potential])
            }
        })+
        $(impl<T: Real> Energetic<T, $count> for $several<T> {
            fn energies(&self, q: [T; $count], dq: [T; $count]) -> Result<[T; 2], SolveError> {
                self.energy(q, dq).map(|energy| [energy.kinetic, energy.potential])
            }
        })+
    };
}

of_one_input! {
    HeavyFourBar: theta;
    DrivenFourBar: theta;
    HeavySixBar: AB;
    Press: theta, [number(300.0), number(-2.0)];
    ShakenFourBar: theta;
    TwoParallelograms: q;
    Oscillator: x, number(0.7);
    FallingLeg: theta;
    SwingingFourBar: theta;
    Squeezer: beta;
    AnyFourBar: theta, [number(12.0), number(1.5)];
    HeavyShaper: theta, number(80.0);
    RockerDriven: rocker;
}

of_several_inputs! {
    Lift<2>: lift tilt, number(150.0);
    SprungLift<2>: lift tilt;
    TwoMasses<2>: x y, number(0.4);
    Crane<2>: x sway;
    HeavyRobot<2>: first second;
    TiltedLift<2>: tilt lift;
    GearedArm<3>: base shoulder motor;
}

with_energy! {
    HeavyFourBar Press ShakenFourBar TwoParallelograms Oscillator FallingLeg SwingingFourBar Squeezer
    AnyFourBar HeavyShaper;
    Lift<2> SprungLift<2> TwoMasses<2> Crane<2> HeavyRobot<2> TiltedLift<2>
    GearedArm<3>
}

/// Where values, rates and drives of an input are drawn.
type Ranges<const N: usize> = [[[f64; 2]; 3]; N];

struct State<const N: usize> {
    q: [f64; N],
    dq: [f64; N],
    drive: [f64; N],
}

fn states<const N: usize>(ranges: &Ranges<N>) -> Vec<State<N>> {
    let mut random = Random::new(41);
    let mut drawn =
        |kind: usize| ranges.map(|range| random.anywhere(range[kind][0], range[kind][1]));
    (0..50).map(|_| State { q: drawn(0), dq: drawn(1), drive: drawn(2) }).collect()
}

/// The size of an input's drive by its terms: what each acceleration takes, what acts at rest, what the
/// rates add, and the drive itself.
fn sizes<M: Moving<f64, N>, const N: usize>(machine: &M, at: &State<N>) -> [f64; N] {
    let ddq = machine.accelerations(at.q, at.dq, at.drive);
    let ((mass, force), (_, at_rest)) =
        (machine.equations(at.q, at.dq), machine.equations(at.q, [0.0; N]));
    core::array::from_fn(|row| {
        let inertia: f64 = (0..N).map(|column| (mass[row][column] * ddq[column]).abs()).sum();
        let rates = (force[row] - at_rest[row]).abs();
        inertia + at_rest[row].abs() + rates + at.drive[row].abs()
    })
}

/// The drives that were given are recovered from the accelerations that they cause.
#[track_caller]
fn check_drives<M: Moving<f64, N>, const N: usize>(machine: &M, ranges: Ranges<N>) {
    let mut worst = 0.0_f64;
    for at in states(&ranges) {
        let ddq = machine.accelerations(at.q, at.dq, at.drive);
        let (found, sizes) = (machine.drives(at.q, at.dq, ddq), sizes(machine, &at));
        for row in 0..N {
            worst = worst.max((found[row] - at.drive[row]).abs() / sizes[row]);
        }
        let (mass, force) = machine.equations(at.q, at.dq);
        for row in 0..N {
            // M q̈ = force + drive, with as many roundings as M has entries, and those of solving.
            let inertia: f64 = (0..N).map(|column| mass[row][column] * ddq[column]).sum();
            let apart = (inertia - force[row] - at.drive[row]).abs();
            assert!(apart <= 16.0 * f64::EPSILON * sizes[row], "{apart} of {}", sizes[row]);
            assert!((0..N).all(|column| mass[row][column] == mass[column][row]));
        }
    }
    assert!(worst <= 64.0 * f64::EPSILON, "{:.1} ε", worst / f64::EPSILON);
}

#[test]
fn forces_at_the_second_rates_are_the_drives() {
    const TURN: [f64; 2] = [0.0, 6.3];
    check_drives(&HeavyFourBar::new(), [[TURN, [-20.0, 20.0], [-1.0, 1.0]]]);
    check_drives(&DrivenFourBar::new(), [[TURN, [-20.0, 20.0], [-1.0, 1.0]]]);
    check_drives(&HeavySixBar::new(), [[TURN, [-9.0, 9.0], [-50.0, 50.0]]]);
    check_drives(&Press::new(), [[TURN, [-9.0, 9.0], [-50.0, 50.0]]]);
    check_drives(&ShakenFourBar::new(), [[TURN, [-9.0, 9.0], [-1.0, 1.0]]]);
    check_drives(&TwoParallelograms::new(), [[TURN, [-9.0, 9.0], [-1.0, 1.0]]]);
    check_drives(
        &Oscillator { c: 2.0, ..Oscillator::new() },
        [[[-1.0, 1.0], [-9.0, 9.0], [-1.0, 1.0]]],
    );
    check_drives(&FallingLeg::new(), [[TURN, [-9.0, 9.0], [-9.0, 9.0]]]);
    check_drives(
        &SwingingFourBar { c: 0.3, ..SwingingFourBar::new() },
        [[TURN, [-9.0, 9.0], [-1.0, 1.0]]],
    );
    check_drives(&Squeezer::new(), [[[-0.6, 0.6], [-900.0, 900.0], [-0.1, 0.1]]]);
    check_drives(&HeavyShaper::new(), [[TURN, [-9.0, 9.0], [-90.0, 90.0]]]);
    check_drives(&RockerDriven::new(), [[[0.4, 1.5], [-9.0, 9.0], [-90.0, 90.0]]]);
    const FAST: [f64; 2] = [-2.0, 2.0];
    const STRONG: [f64; 2] = [-500.0, 500.0];
    let tilt = [[-0.5, 1.5], FAST, [-90.0, 90.0]];
    check_drives(&Lift::new(), [[[0.7, 1.2], FAST, STRONG], tilt]);
    check_drives(&SprungLift::new(), [[[0.7, 1.2], FAST, STRONG], tilt]);
    check_drives(&TiltedLift::new(), [tilt, [[0.7, 1.2], FAST, STRONG]]);
    check_drives(&TwoMasses::new(), [[[-1.0, 1.0], FAST, FAST]; 2]);
    check_drives(&Crane::new(), [[[-1.0, 1.0], FAST, STRONG], [[-1.0, 1.0], FAST, [0.0, 0.0]]]);
    check_drives(&HeavyRobot::new(), [[[1.2, 2.6], FAST, FAST], [[0.5, 1.9], FAST, FAST]]);
    let joint = [TURN, [-5.0, 5.0], [-9.0, 9.0]];
    check_drives(&GearedArm::new(), [[[-1.0, 1.0], FAST, STRONG], joint, joint]);
}

/// Four-bars of random lengths, masses, springs and dampers.
#[test]
fn forces_at_the_second_rates_are_the_drives_of_any_four_bar() {
    let mut random = Random::new(7);
    for _ in 0..100 {
        let mut around = |x: f64| x * random.anywhere(0.8, 1.2);
        let machine = AnyFourBar {
            crank: around(1.0),
            coupler: around(3.0),
            rocker: around(2.5),
            aside: around(0.4),
            m1: around(2.0),
            m2: around(3.0),
            m3: around(1.0),
            k: around(40.0),
            c: around(3.0),
        };
        let turn = [[0.0, 6.3], [-5.0, 5.0], [-30.0, 30.0]];
        check_drives(&machine, [turn]);
        check_energy(&machine, &machine.lift(), &machine.lift(), [turn], |[q], [dq]| {
            let (p, v) = (machine.position(q).unwrap(), machine.velocity(q, dq).unwrap());
            let pull = 12.0 * (p.BC.cos * v.P.x + p.BC.sin * v.P.y);
            pull - 0.9 * v.DC.omega * v.DC.omega - machine.c * v.reach * v.reach
        });
    }
}

type One = DualSVec<f64, 1>;

/// The masses are the second derivatives of the kinetic energy by the rates, and along the motion under the
/// given drives kinetic and potential energy grow by what the drives put in and what else is neither
/// weight nor spring.
#[track_caller]
fn check_energy<M, D, H, const N: usize>(
    machine: &M,
    dual: &D,
    twice: &H,
    ranges: Ranges<N>,
    other: impl Fn([f64; N], [f64; N]) -> f64,
) where
    M: Moving<f64, N>,
    D: Energetic<One, N>,
    H: Energetic<Dual2SVec<f64, N>, N>,
{
    for at in states(&ranges) {
        let ddq = machine.accelerations(at.q, at.dq, at.drive);
        let real = |x: f64| One::from_re(x);
        let growth = differentiate([0.0], |[t]: [One; 1]| {
            let along = |value: [f64; N], rate: [f64; N]| {
                core::array::from_fn(|k| t * real(rate[k]) + real(value[k]))
            };
            let [kinetic, potential] = dual.energies(along(at.q, at.dq), along(at.dq, ddq))?;
            Ok([kinetic + potential])
        });
        let growth = growth.expect("a pose")[(0, 0)];
        let power: f64 = (0..N).map(|k| at.drive[k] * at.dq[k]).sum::<f64>() + other(at.q, at.dq);
        let sizes = sizes(machine, &at);
        let size: f64 = (0..N).map(|k| sizes[k] * at.dq[k].abs()).sum();
        // A hundred operations with duals.
        assert!(
            (growth - power).abs() <= 100.0 * f64::EPSILON * size,
            "{growth} {power} of {size}"
        );
        let (mass, _) = machine.equations(at.q, at.dq);
        let hessian = differentiate_twice(at.dq, |dq| {
            let q = at.q.map(Dual2SVec::from_re);
            Ok(twice.energies(q, dq)?[0])
        });
        let hessian = hessian.expect("a pose").hessian;
        for row in 0..N {
            for column in 0..N {
                let size = (mass[row][row] * mass[column][column]).sqrt();
                let apart = (mass[row][column] - hessian[(row, column)]).abs();
                assert!(apart <= 32.0 * f64::EPSILON * size, "{row} {column}: {apart} of {size}");
            }
        }
    }
}

macro_rules! energy {
    ($machine:expr, $ranges:expr) => {
        energy!($machine, $ranges, |_, _| 0.0)
    };
    ($machine:expr, $ranges:expr, $other:expr) => {
        check_energy(&$machine, &$machine.lift(), &$machine.lift(), $ranges, $other)
    };
}

#[test]
fn energy_grows_by_what_is_put_in_and_its_hessian_is_the_mass() {
    const TURN: [f64; 2] = [0.0, 6.3];
    const FAST: [f64; 2] = [-2.0, 2.0];
    const STRONG: [f64; 2] = [-500.0, 500.0];
    energy!(HeavyFourBar::new(), [[TURN, [-20.0, 20.0], [-1.0, 1.0]]]);
    energy!(ShakenFourBar::new(), [[TURN, [-9.0, 9.0], [-1.0, 1.0]]]);
    energy!(TwoParallelograms::new(), [[TURN, [-9.0, 9.0], [-1.0, 1.0]]]);
    energy!(FallingLeg::new(), [[TURN, [-9.0, 9.0], [-9.0, 9.0]]]);
    energy!(Squeezer::new(), [[[-0.6, 0.6], [-900.0, 900.0], [-0.1, 0.1]]]);
    energy!(Crane::new(), [[[-1.0, 1.0], FAST, STRONG], [[-1.0, 1.0], FAST, STRONG]]);
    let press = Press::new();
    energy!(press, [[TURN, [-9.0, 9.0], [-50.0, 50.0]]], |[q], [dq]| {
        let v = press.velocity(q, dq).unwrap();
        300.0 * v.C.y - 2.0 * dq
    });
    let oscillator = Oscillator { c: 2.0, ..Oscillator::new() };
    energy!(oscillator, [[[-1.0, 1.0], [-9.0, 9.0], [-1.0, 1.0]]], |[x], [v]| {
        (0.7 - oscillator.k * x - oscillator.c * v) * v
    });
    let swinging = SwingingFourBar { c: 0.3, ..SwingingFourBar::new() };
    energy!(swinging, [[TURN, [-9.0, 9.0], [-1.0, 1.0]]], |[q], [dq]| {
        let v = swinging.velocity(q, dq).unwrap();
        -0.3 * v.DC.omega * v.DC.omega
    });
    let shaper = HeavyShaper::new();
    // At 10° the guide on the crank is parallel to the fixed one.
    energy!(shaper, [[[0.6, 2.9], [-9.0, 9.0], [-90.0, 90.0]]], |[q], [dq]| {
        let (p, v) = (shaper.position(q).unwrap(), shaper.velocity(q, dq).unwrap());
        let force = -80.0 - 5.0 * v.ram.slide;
        force * (p.ram.cos * v.E.x + p.ram.sin * v.E.y)
    });
    let tilt = [[-0.5, 1.5], FAST, [-90.0, 90.0]];
    let lift = Lift::new();
    energy!(lift, [[[0.7, 1.2], FAST, STRONG], tilt], |q, dq| {
        -150.0 * lift.velocity(q, dq).unwrap().T.y
    });
    let sprung = SprungLift::new();
    energy!(sprung, [[[0.7, 1.2], FAST, STRONG], tilt], |q, dq| {
        let stretching = sprung.velocity(q, dq).unwrap().dT;
        -40.0 * stretching * stretching - 2.0 * dq[1] * dq[1]
    });
    energy!(TiltedLift::new(), [tilt, [[0.7, 1.2], FAST, STRONG]]);
    energy!(TwoMasses::new(), [[[-1.0, 1.0], FAST, FAST]; 2], |[x, y], [u, v]| {
        15.0 * (y - 2.0 * x) * u + (0.4 - 15.0 * (y - x)) * v
    });
    let robot = HeavyRobot::new();
    energy!(robot, [[[1.2, 2.6], FAST, FAST], [[0.5, 1.9], FAST, FAST]], |q, dq| {
        let stretching = robot.velocity(q, dq).unwrap().reach;
        -2.0 * stretching * stretching
    });
    let joint = [TURN, [-5.0, 5.0], [-9.0, 9.0]];
    energy!(GearedArm::new(), [[[-1.0, 1.0], FAST, STRONG], joint, joint], |_, [_, _, motor]| {
        -0.2 * (motor / 3.0) * (motor / 3.0)
    });
}

#[test]
fn the_rates_of_a_state_are_its_rates_and_second_rates() {
    let press = Press::new();
    let ddq = press.forward_dynamics(0.4, 2.0, 5.0, [300.0, -2.0]).unwrap();
    assert_eq!(press.state_rates([0.4, 2.0], 5.0, [300.0, -2.0]).unwrap(), [2.0, ddq]);
    let lift = SprungLift::new();
    let ddq = lift.forward_dynamics([0.9, 0.4], [0.3, 1.0], [400.0, -30.0]).unwrap();
    let rates = lift.state_rates([0.9, 0.4, 0.3, 1.0], [400.0, -30.0]).unwrap();
    assert_eq!(rates, [0.3, 1.0, ddq[0], ddq[1]]);
    let arm = GearedArm::new();
    let ddq = arm.forward_dynamics([0.1, 0.2, 0.3], [1.0, 2.0, 3.0], [4.0, 5.0, 6.0]).unwrap();
    let rates = arm.state_rates([0.1, 0.2, 0.3, 1.0, 2.0, 3.0], [4.0, 5.0, 6.0]).unwrap();
    assert_eq!(rates, [1.0, 2.0, 3.0, ddq[0], ddq[1], ddq[2]]);
}
