//! Efforts, rates, inertias and power through the transfer, beside those that the other solver has by itself.

use std::fmt::Debug;

use linkage_core::{CarriesOver, Solver};
use linkage_core::{Record, Transfer};
use linkage_tests::random::{Random, cases};

use crate::heavy_machines::*;

/// The drives of a solver in motion, and its mass matrix.
type Dynamics<'a, const N: usize> =
    &'a dyn Fn([f64; N], [f64; N], [f64; N]) -> Option<([f64; N], [[f64; N]; N])>;

/// Errors over ε times the condition of the ratios and the sum of the products: of efforts, inertias and power.
#[derive(Default)]
struct Errors([Vec<f64>; 3]);

impl Errors {
    /// The median and the worst of each.
    fn sorted(&mut self) -> [[f64; 2]; 3] {
        self.0.each_mut().map(|errors| {
            errors.sort_by(f64::total_cmp);
            [errors[errors.len() / 2], *errors.last().expect("there are poses")]
        })
    }
}

fn compared<A, B, const N: usize>(
    (a, b): (A, B),
    (drawn, reach): ([f64; N], [f64; N]),
    (of_a, of_b): (Dynamics<'_, N>, Dynamics<'_, N>),
) -> Errors
where
    A: CarriesOver<B, N> + Solver<Scalar = f64>,
    B: CarriesOver<A, N> + Solver<Scalar = f64>,
    A::Input: Record<Number = f64, Array = [f64; N]> + Debug,
    B::Input: Record<Number = f64, Array = [f64; N]> + Debug,
    A::Position: Record<Number = f64>,
{
    let mut random = Random::new(57);
    let mut found = Errors::default();
    for _ in 0..cases(300, 30_000) {
        let mut near = |center: [f64; N], reach: [f64; N]| -> [f64; N] {
            std::array::from_fn(|i| center[i] + reach[i] * (2.0 * random.unit() - 1.0))
        };
        let (q, v, acc) = (near(drawn, reach), near([0.0; N], reach), near([0.0; N], reach));
        let input = <A::Input as Record>::from_array;
        let Ok(there) = Transfer::<A, B, N>::new(a, input(q)) else { continue };
        let Ok(motion) = there.motion(input(v), input(acc)) else { continue };
        let [q_there, v_there, acc_there] = motion.map(Record::into_array);
        let Ok(ratios) = there.ratios() else { continue };
        // The rates by velocity and by motion are one.
        let rates = there.rates(input(v)).expect("its motion is known").into_array();
        for (rate, by_motion) in rates.iter().zip(v_there) {
            assert!((rate - by_motion).abs() <= 1e-13 * (rate.abs() + 1.0), "{rate} {by_motion}");
        }
        let Ok(back) = Transfer::<B, A, N>::new(b, <B::Input as Record>::from_array(q_there))
        else {
            continue;
        };
        let Ok(inverse) = back.ratios() else { continue };
        // The condition of the ratios, whatever their units: |J⁻¹||J|, whose rows are at least one.
        let places = || (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
        let condition: f64 = places().map(|(i, j)| (inverse[i][j] * ratios[j][i]).abs()).sum();
        let (Some((own, mass)), Some((other, mass_there))) =
            (of_a(q, v, acc), of_b(q_there, v_there, acc_there))
        else {
            continue;
        };
        if condition > 1e3 {
            continue;
        }
        let unit = f64::EPSILON * condition;
        let efforts = there.efforts(<B::Input as Record>::from_array(other));
        let efforts = efforts.expect("ratios are known").into_array();
        let inertia = there.inertia(mass_there).expect("ratios are known");
        let scale = |i: usize| (0..N).map(|j| (ratios[j][i] * other[j]).abs()).sum::<f64>();
        for i in 0..N {
            let error = (efforts[i] - own[i]).abs() / (unit * scale(i));
            found.0[0].push(error);
            for k in 0..N {
                let products = (0..N)
                    .flat_map(|j| (0..N).map(move |l| (j, l)))
                    .map(|(j, l)| (ratios[j][i] * mass_there[j][l] * ratios[l][k]).abs());
                let error = (inertia[i][k] - mass[i][k]).abs() / products.sum::<f64>();
                found.0[1].push(error / unit);
            }
        }
        let power = |efforts: [f64; N], rates: [f64; N]| -> [f64; 2] {
            let products = efforts.iter().zip(rates).map(|(effort, rate)| effort * rate);
            [products.clone().sum(), products.map(f64::abs).sum()]
        };
        let ([here, size], [there, size_there]) = (power(own, v), power(other, v_there));
        let error = (here - there).abs() / (unit * (size + size_there));
        found.0[2].push(error);
    }
    found
}

macro_rules! dynamics {
    ($solver:expr, $loads:expr, $($field:ident),*; several) => {
        &|q, v, acc| {
            let forces = $solver.forces(q, v, acc, $loads).ok()?;
            let equations = $solver.equations_of_motion(q, v, $loads).ok()?;
            Some(([$(forces.$field.drive),*], equations.mass))
        }
    };
    ($solver:expr, $loads:expr, $field:ident; one) => {
        &|[q], [v], [acc]| {
            let forces = $solver.forces(q, v, acc, $loads).ok()?;
            let equations = $solver.equations_of_motion(q, v, $loads).ok()?;
            Some(([forces.$field.drive], equations.mass))
        }
    };
}

#[test]
fn efforts_inertia_and_power_are_those_of_the_other_solver() {
    let five_bar = HeavyFiveBar::new();
    let (motors, hand) = (five_bar.motors(), five_bar.hand());
    let load = [3.0, -7.0];
    let by_motors: Dynamics<'_, 2> = dynamics!(motors, load, a, b; several);
    let by_hand: Dynamics<'_, 2> = dynamics!(hand, load, x, y; several);
    let digger = HeavyExcavator::new();
    let (cylinders, joints, teeth) = (digger.cylinders(), digger.joints(), digger.teeth());
    let weight = [2e3, -9e3];
    let by_cylinders: Dynamics<'_, 3> = dynamics!(cylinders, weight, lift, crowd, curl; several);
    let by_joints: Dynamics<'_, 3> = dynamics!(joints, weight, swing, reach, dig; several);
    let by_teeth: Dynamics<'_, 3> = dynamics!(teeth, weight, x, y, attack; several);
    let press = HeavyToggle::new();
    let (crank, ram) = (press.crank_side(), press.press());
    let by_crank: Dynamics<'_, 1> = dynamics!(crank, -900.0, theta; one);
    let by_ram: Dynamics<'_, 1> = dynamics!(ram, -900.0, x; one);
    let all = [
        (
            "five-bar, hand from motors",
            compared::<_, HeavyFiveBarMotors, 2>(
                (hand, motors),
                (HeavyFiveBarHand::DRAWN, [0.04; 2]),
                (by_hand, by_motors),
            ),
        ),
        (
            "five-bar, motors from hand",
            compared::<_, HeavyFiveBarHand, 2>(
                (motors, hand),
                (HeavyFiveBarMotors::DRAWN, [0.3; 2]),
                (by_motors, by_hand),
            ),
        ),
        (
            "excavator, joints from cylinders",
            compared::<_, HeavyExcavatorCylinders, 3>(
                (joints, cylinders),
                (HeavyExcavatorJoints::DRAWN, [0.2; 3]),
                (by_joints, by_cylinders),
            ),
        ),
        (
            "excavator, cylinders from joints",
            compared::<_, HeavyExcavatorJoints, 3>(
                (cylinders, joints),
                (HeavyExcavatorCylinders::DRAWN, [0.1; 3]),
                (by_cylinders, by_joints),
            ),
        ),
        (
            "excavator, teeth from joints",
            compared::<_, HeavyExcavatorJoints, 3>(
                (teeth, joints),
                (HeavyExcavatorTeeth::DRAWN, [0.2; 3]),
                (by_teeth, by_joints),
            ),
        ),
        (
            "press, ram from crank",
            compared::<_, HeavyToggleCrankSide, 1>(
                (ram, crank),
                (HeavyTogglePress::DRAWN, [0.02; 1]),
                (by_ram, by_crank),
            ),
        ),
        (
            "press, crank from ram",
            compared::<_, HeavyTogglePress, 1>(
                (crank, ram),
                (HeavyToggleCrankSide::DRAWN, [0.2; 1]),
                (by_crank, by_ram),
            ),
        ),
    ];
    for (pair, mut errors) in all {
        let [efforts, inertia, power] = errors.sorted();
        println!("{pair:35} efforts {efforts:.1?} inertia {inertia:.1?} power {power:.1?}");
        assert!(errors.0[0].len() > 100, "{pair}");
        for [median, worst] in [efforts, inertia, power] {
            // A press that is drawn next to its toggle has a ratio of forces that changes fast.
            let most = if pair == "press, crank from ram" { 200.0 } else { 16.0 };
            assert!(median <= most, "{pair}: {median} ε");
            // Next to a limit of the other solver its efforts have fewer digits than their products: a wrong sign or a
            // matrix that is not transposed would be off by 1e13 of these.
            assert!(worst <= 1e5, "{pair}: {worst} ε");
        }
    }
}
