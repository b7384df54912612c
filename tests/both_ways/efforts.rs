//! Efforts, rates, inertias and power through the transfer, beside those that the other solver has by itself.
//!
//! Three evaluations meet: the first solver's pose with its ratios, the other solver's efforts at that pose, and the first
//! solver's own efforts. Each is as good as its own inputs are known: off by no more than what some roundings of the
//! inputs change. So the error is that of the products, and what roundings change in each factor of them; next to a limit
//! of either solver that is more than the products. These changes are taken by differences. Their sum over that of the
//! products is the condition.

use std::fmt::Debug;

use linkage_core::{CarriesOver, Solver};
use linkage_core::{Record, Transfer};
use linkage_tests::random::{Random, cases};

use crate::heavy_machines::*;
use crate::roundings::changes;

/// The drives of a solver in motion, and its mass matrix.
type Dynamics<'a, const N: usize> =
    &'a dyn Fn([f64; N], [f64; N], [f64; N]) -> Option<([f64; N], [[f64; N]; N])>;

/// Roundings by which each evaluation may be off, and those of the sums of products.
const ROUNDINGS: f64 = 4.0;

/// The same of the products alone, where roundings change no more than ten times these.
const OF_PRODUCTS: f64 = 16.0;

/// Errors of efforts, inertias and power over ε times the products and what roundings change; and all conditions.
#[derive(Default)]
struct Errors {
    of: [Vec<f64>; 3],
    conditions: Vec<f64>,
    /// The same over ε times the products alone, where the condition is at most ten.
    of_products: Vec<f64>,
}

/// The median and the worst.
fn ends(errors: &mut [f64]) -> [f64; 2] {
    errors.sort_by(f64::total_cmp);
    [errors[errors.len() / 2], *errors.last().expect("there are poses")]
}

/// Inputs, rates and second rates in one list.
fn parts<const N: usize>(x: &[f64]) -> [[f64; N]; 3] {
    [0, 1, 2].map(|order| std::array::from_fn(|i| x[order * N + i]))
}

/// Drives, then the mass matrix row by row.
fn listed<const N: usize>(dynamics: Dynamics<'_, N>, x: &[f64]) -> Option<Vec<f64>> {
    let [q, v, acc] = parts(x);
    let (drives, mass) = dynamics(q, v, acc)?;
    Some([&drives[..], mass.as_flattened()].concat())
}

/// Numbers that three evaluations have found, and what roundings change of it.
struct Known {
    ratios: Vec<f64>,
    ratios_by: Vec<f64>,
    own: Vec<f64>,
    own_by: Vec<f64>,
    other: Vec<f64>,
    other_by: Vec<f64>,
    there: Vec<f64>,
    there_by: Vec<f64>,
}

impl Known {
    /// The errors of what was carried over.
    fn compare<const N: usize>(
        &self,
        v: [f64; N],
        efforts: [f64; N],
        inertia: [[f64; N]; N],
        found: &mut Errors,
    ) {
        let ratio = |j: usize, i: usize| [self.ratios[j * N + i].abs(), self.ratios_by[j * N + i]];
        let (mut bounds, mut products) = ([0.0; N], [0.0; N]);
        for i in 0..N {
            for j in 0..N {
                let [value, by] = ratio(j, i);
                products[i] += value * self.other[j].abs();
                bounds[i] +=
                    value * (self.other[j].abs() + self.other_by[j]) + by * self.other[j].abs();
            }
            bounds[i] += self.own_by[i];
            let error = (efforts[i] - self.own[i]).abs();
            found.of[0].push(error / (f64::EPSILON * bounds[i]));
            found.conditions.push(bounds[i] / products[i]);
            if bounds[i] <= 10.0 * products[i] {
                found.of_products.push(error / (f64::EPSILON * products[i]));
            }
            for (k, &carried) in inertia[i].iter().enumerate() {
                let mut bound = self.own_by[N + i * N + k];
                for (j, l) in (0..N).flat_map(|j| (0..N).map(move |l| (j, l))) {
                    let ([left, left_by], [right, right_by]) = (ratio(j, i), ratio(l, k));
                    let (value, by) =
                        (self.other[N + j * N + l].abs(), self.other_by[N + j * N + l]);
                    bound +=
                        left * right * (value + by) + value * (left_by * right + left * right_by);
                }
                let error = (carried - self.own[N + i * N + k]).abs();
                found.of[1].push(error / (f64::EPSILON * bound));
            }
        }
        let power = |efforts: &[f64], rates: &[f64]| -> f64 {
            efforts.iter().zip(rates).map(|(effort, rate)| effort * rate).sum()
        };
        let mut bound: f64 = v.iter().zip(bounds).map(|(rate, bound)| rate.abs() * bound).sum();
        for j in 0..N {
            bound += self.other[j].abs() * (self.there[N + j].abs() + self.there_by[N + j]);
        }
        let error = (power(&self.own[..N], &v) - power(&self.other[..N], &self.there[N..])).abs();
        found.of[2].push(error / (f64::EPSILON * bound));
    }
}

/// One pair of solvers, the second of which has the efforts that are carried over.
struct Pair<'a, A, B, const N: usize> {
    a: A,
    b: B,
    of_a: Dynamics<'a, N>,
    of_b: Dynamics<'a, N>,
    /// Sizes of the inputs of each: a radian, or the machine's size.
    sizes: [[f64; N]; 2],
}

impl<A, B, const N: usize> Pair<'_, A, B, N>
where
    A: CarriesOver<B, N> + Solver<Scalar = f64>,
    B: CarriesOver<A, N> + Solver<Scalar = f64>,
    A::Input: Record<Number = f64, Array = [f64; N]> + Debug,
    B::Input: Record<Number = f64, Array = [f64; N]> + Debug,
    A::Position: Record<Number = f64>,
{
    fn transfer(&self, q: [f64; N]) -> Option<Transfer<A, B, N>> {
        Transfer::new(self.a, <A::Input as Record>::from_array(q)).ok()
    }

    /// Nothing where the other solver does not have the pose, too: next to a limit of it.
    fn is_known_there(&self, q: [f64; N]) -> Option<()> {
        let there = self.transfer(q)?.coordinates;
        Transfer::<B, A, N>::new(self.b, there).ok().map(drop)
    }

    /// The other's inputs, rates and second rates.
    fn there(&self, x: &[f64]) -> Option<Vec<f64>> {
        let [q, v, acc] = parts(x).map(<A::Input as Record>::from_array);
        let there = self.transfer(q.into_array())?.motion(v, acc).ok()?;
        Some(there.map(Record::into_array).as_flattened().to_vec())
    }

    fn ratios(&self, q: &[f64]) -> Option<Vec<f64>> {
        let q = std::array::from_fn(|i| q[i]);
        Some(self.transfer(q)?.ratios().ok()?.as_flattened().to_vec())
    }

    fn at(&self, x: &[f64], found: &mut Errors) -> Option<()> {
        let [q, v, _] = parts::<N>(x);
        self.is_known_there(q)?;
        let sized = |values: &[f64], sizes: [f64; N]| -> Vec<f64> {
            let sized = values.iter().enumerate();
            // Rates in a test are such as change an input by a share of its size in a second.
            sized.map(|(i, value)| value.abs() + sizes[i % N]).collect()
        };
        let weights = sized(x, self.sizes[0]);
        let [ratios, ratios_by] = changes(&|q| self.ratios(q), &x[..N], &weights[..N])?;
        let [there, there_by] = changes(&|x| self.there(x), x, &weights)?;
        let own_of = |x: &[f64]| listed(self.of_a, x);
        let [own, own_by] = changes(&own_of, x, &weights)?;
        // The other solver is given what the first has found.
        let given = sized(&there, self.sizes[1]);
        let given: Vec<f64> = given.iter().zip(&there_by).map(|(own, by)| own + by).collect();
        let other_of = |x: &[f64]| listed(self.of_b, x);
        let [other, other_by] = changes(&other_of, &there, &given)?;

        let transfer = self.transfer(q)?;
        let [rates] = [transfer.rates(<A::Input as Record>::from_array(v)).ok()?.into_array()];
        for (rate, by_motion) in rates.iter().zip(&there[N..]) {
            assert!((rate - by_motion).abs() <= 1e-13 * (rate.abs() + 1.0), "{rate} {by_motion}");
        }
        let efforts = std::array::from_fn(|j| other[j]);
        let efforts = transfer.efforts(<B::Input as Record>::from_array(efforts)).ok()?;
        let efforts = efforts.into_array();
        let mass = std::array::from_fn(|j| std::array::from_fn(|l| other[N + j * N + l]));
        let inertia = transfer.inertia(mass).ok()?;

        let known = Known { ratios, ratios_by, own, own_by, other, other_by, there, there_by };
        known.compare::<N>(v, efforts, inertia, found);
        Some(())
    }

    fn compared(&self, drawn: [f64; N], reach: [f64; N]) -> Errors {
        let mut random = Random::new(57);
        let mut found = Errors::default();
        for pose in 0..cases(300, 10_000) {
            // Every fourth pose is at rest.
            let moving = if pose % 4 == 0 { 0.0 } else { 1.0 };
            let x = [(drawn, 1.0), ([0.0; N], moving), ([0.0; N], moving)];
            let x = x.map(|(center, share)| {
                std::array::from_fn::<f64, N, _>(|i| {
                    center[i] + share * reach[i] * (2.0 * random.unit() - 1.0)
                })
            });
            // A pose of another assembly has nothing to compare.
            let _ = self.at(x.as_flattened(), &mut found);
        }
        found
    }
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

/// Tells and bounds the errors of a pair.
fn hold<A, B, const N: usize>(
    name: &str,
    pair: &Pair<'_, A, B, N>,
    drawn: [f64; N],
    reach: [f64; N],
) where
    A: CarriesOver<B, N> + Solver<Scalar = f64>,
    B: CarriesOver<A, N> + Solver<Scalar = f64>,
    A::Input: Record<Number = f64, Array = [f64; N]> + Debug,
    B::Input: Record<Number = f64, Array = [f64; N]> + Debug,
    A::Position: Record<Number = f64>,
{
    let Errors { mut of, mut conditions, mut of_products } = pair.compared(drawn, reach);
    let ([condition, most], found) = (ends(&mut conditions), of.each_mut().map(|of| ends(of)));
    let count = of_products.len();
    let [_, plain] = if count == 0 { [0.0; 2] } else { ends(&mut of_products) };
    println!(
        "{name:35} condition {condition:.1} to {most:.1e}; efforts, inertia, power over it {found:.2?}; where it is at most \
         ten {count} times, {plain:.1} of the products"
    );
    assert!(conditions.len() > 100, "{name}");
    for [_, worst] in found {
        assert!(worst <= ROUNDINGS, "{name}: {worst}");
    }
    assert!(plain <= OF_PRODUCTS, "{name}: {plain} of the products");
}

#[test]
fn efforts_inertia_and_power_are_those_of_the_other_solver() {
    five_bar();
    excavator();
    press();
    bicycle();
}

fn five_bar() {
    let machine = HeavyFiveBar::new();
    let (motors, hand) = (machine.motors(), machine.hand());
    let load = [3.0, -7.0];
    let by_motors: Dynamics<'_, 2> = dynamics!(motors, load, a, b; several);
    let by_hand: Dynamics<'_, 2> = dynamics!(hand, load, x, y; several);
    let (turns, size) = ([1.0; 2], [0.2; 2]);
    let pair = Pair { a: hand, b: motors, of_a: by_hand, of_b: by_motors, sizes: [size, turns] };
    hold("five-bar, hand from motors", &pair, HeavyFiveBarHand::DRAWN, [0.04; 2]);
    let pair = Pair { a: motors, b: hand, of_a: by_motors, of_b: by_hand, sizes: [turns, size] };
    hold("five-bar, motors from hand", &pair, HeavyFiveBarMotors::DRAWN, [0.3; 2]);
}

fn excavator() {
    let machine = HeavyExcavator::new();
    let (cylinders, joints, teeth) = (machine.cylinders(), machine.joints(), machine.teeth());
    let weight = [2e3, -9e3];
    let by_cylinders: Dynamics<'_, 3> = dynamics!(cylinders, weight, lift, crowd, curl; several);
    let by_joints: Dynamics<'_, 3> = dynamics!(joints, weight, swing, reach, dig; several);
    let by_teeth: Dynamics<'_, 3> = dynamics!(teeth, weight, x, y, attack; several);
    let (turns, lengths, tool) = ([1.0; 3], [3.0; 3], [5.0, 5.0, 1.0]);
    let pair = Pair {
        a: joints,
        b: cylinders,
        of_a: by_joints,
        of_b: by_cylinders,
        sizes: [turns, lengths],
    };
    hold("excavator, joints from cylinders", &pair, HeavyExcavatorJoints::DRAWN, [0.2; 3]);
    let pair = Pair {
        a: cylinders,
        b: joints,
        of_a: by_cylinders,
        of_b: by_joints,
        sizes: [lengths, turns],
    };
    hold("excavator, cylinders from joints", &pair, HeavyExcavatorCylinders::DRAWN, [0.1; 3]);
    let pair = Pair { a: teeth, b: joints, of_a: by_teeth, of_b: by_joints, sizes: [tool, turns] };
    hold("excavator, teeth from joints", &pair, HeavyExcavatorTeeth::DRAWN, [0.2; 3]);
}

fn press() {
    let machine = HeavyToggle::new();
    let (crank, ram) = (machine.crank_side(), machine.press());
    let by_crank: Dynamics<'_, 1> = dynamics!(crank, -900.0, theta; one);
    let by_ram: Dynamics<'_, 1> = dynamics!(ram, -900.0, x; one);
    let (turn, length) = ([1.0], [0.4]);
    let pair = Pair { a: ram, b: crank, of_a: by_ram, of_b: by_crank, sizes: [length, turn] };
    hold("press, ram from crank", &pair, HeavyTogglePress::DRAWN, [0.02]);
    let pair = Pair { a: crank, b: ram, of_a: by_crank, of_b: by_ram, sizes: [turn, length] };
    hold("press, crank from ram", &pair, HeavyToggleCrankSide::DRAWN, [0.2]);
}

/// The wheel is driven by a search.
fn bicycle() {
    let machine = HeavyHorst::new();
    let (shock, wheel, lever) = (machine.shock(), machine.wheel(), machine.lever());
    let by_shock: Dynamics<'_, 1> = dynamics!(shock, 700.0, stroke; one);
    let by_wheel: Dynamics<'_, 1> = dynamics!(wheel, 700.0, travel; one);
    let by_lever: Dynamics<'_, 1> = dynamics!(lever, 700.0, lean; one);
    let (turn, length) = ([1.0], [0.4]);
    let pair = Pair { a: wheel, b: shock, of_a: by_wheel, of_b: by_shock, sizes: [length; 2] };
    hold("bicycle, wheel from shock", &pair, HeavyHorstWheel::DRAWN, [0.05]);
    let pair = Pair { a: shock, b: wheel, of_a: by_shock, of_b: by_wheel, sizes: [length; 2] };
    hold("bicycle, shock from wheel", &pair, HeavyHorstShock::DRAWN, [0.02]);
    let pair = Pair { a: lever, b: wheel, of_a: by_lever, of_b: by_wheel, sizes: [turn, length] };
    hold("bicycle, rocker from wheel", &pair, HeavyHorstLever::DRAWN, [0.2]);
}
