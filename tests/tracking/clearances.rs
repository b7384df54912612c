//! The groups' clearances along a line of inputs: rates against dual numbers, and ranges against the values
//! in them.

use core::f64::consts::PI;
use linkage_core::private::{Clearance, Solver};
use linkage_core::{Real, Record, mechanism};
use linkage_tests::mechanisms::change_points::*;
use linkage_tests::mechanisms::compensated::ConstantRrp;
use linkage_tests::mechanisms::twins::*;
use linkage_tests::random::{Random, cases};
use num_dual::Dual2_64;

mechanism! {
    struct CompensatedRow {
        numerics compensated;
        input theta: angle;
        input lift: length;
        ground A(0, 0), D(534mm, 22mm), E(995mm, 108mm);
        crank AB(A) -> B { length: 68mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (495mm, 331mm + lift), mode: left }
        guide rail through (153mm, -600mm) along -4deg;
        rrp CR(C), block(rail) -> R { length: 1749mm, mode: ahead }
        rpr cyl(E), stem(R) { offset: 30mm, mode: ahead }
        output block, cyl;
    }
}

/// A place, the rate there and how far around, of every input.
type Stretch<const N: usize> = [[f64; 3]; N];

/// The input of these numbers.
fn input<M: Solver, const N: usize>(numbers: [M::Scalar; N]) -> M::Input
where
    M::Input: Record<Array = [M::Scalar; N]>,
{
    Record::from_array(numbers)
}

/// Some inputs of every group with a mode, and of all of them in a row; a radius of up to 0.3 rad, of
/// most groups' limits farther than that.
fn inputs(random: &mut Random) -> Stretch<2> {
    let radius = [1e-6, 1e-3, 0.03, 0.3][random.anywhere(0.0, 4.0) as usize];
    let mut one = |size: f64| {
        let around = radius * random.anywhere(0.0, 1.0);
        [random.anywhere(-PI, PI), random.anywhere(-2.0, 2.0), around].map(|x| size * x)
    };
    [one(1.0), one(5e-3)]
}

/// With a second rate of zero the clearance of a dual number along the line has the rates.
fn rates_agree<M, D, const N: usize>(solver: &M, dual: &D, stretch: Stretch<N>)
where
    M: Solver<Scalar = f64, Input: Record<Array = [f64; N]>>,
    D: Solver<Scalar = Dual2_64, Input: Record<Array = [Dual2_64; N]>>,
{
    let along = stretch.map(|[at, rate, _]| Dual2_64::new(at, rate, 0.0));
    let still = [Dual2_64::from_re(0.0); N];
    let expected = dual.clearances(input::<D, N>(along), input::<D, N>(still));
    let [at, rate] = [0, 1].map(|which| input::<M, N>(stretch.map(|of| of[which])));
    let found = solver.clearances(at, rate);
    assert_eq!(found.as_ref().len(), M::TITLES.groups.len());
    for (found, expected) in found.as_ref().iter().zip(expected.as_ref()) {
        let Clearance { value: Dual2_64 { re, v1, v2, .. }, scale, .. } = *expected;
        // Behind a group out of reach there are no numbers.
        if !(re.is_finite() && v2.is_finite()) {
            continue;
        }
        let found = [found.value, found.rate, found.second_rate, found.scale];
        let sizes = [1.0, 1.0 + v1.abs(), 1.0 + v1.abs() + v2.abs(), 1.0];
        for ((found, expected), size) in found.into_iter().zip([re, v1, v2, scale.re]).zip(sizes) {
            // Some hundred roundings, grown by up to three roots taken near their zero.
            assert!((found - expected).abs() <= 1e-9 * size, "{found} for {expected}: {stretch:?}");
        }
    }
}

/// The count of groups whose ranges are finite. Each of these ranges contains all values at places between.
fn known_of_ranges<M, const N: usize>(solver: &M, stretch: Stretch<N>) -> usize
where
    M: Solver<Scalar = f64, Input: Record<Array = [f64; N]>>,
{
    // On the straight line of a step, both ways from its middle.
    let [middle, radius] = [0, 2].map(|which| input::<M, N>(stretch.map(|of| of[which])));
    let (ranges, values) =
        (solver.enclosures(middle, radius, radius), solver.values(middle, radius));
    let mut known = 0;
    for (group, (ranges, [value, scale])) in ranges.as_ref().iter().zip(values.as_ref()).enumerate()
    {
        let of = [ranges.value, ranges.rate, ranges.second_rate, ranges.scale].map(Real::bounds);
        if of.iter().flatten().any(|bound| !bound.is_finite()) {
            continue;
        }
        known += 1;
        // The same formulas: without rates no more is known, and no less.
        for (one, other) in [value.bounds(), scale.bounds()].iter().zip([of[0], of[3]]) {
            assert!(one.iter().zip(other).all(|(a, b)| (a - b).abs() <= 1e-12), "{stretch:?}");
        }
        for part in -8..=8 {
            let place = |[at, _, around]: [f64; 3]| at + f64::from(part) / 8.0 * around;
            let here = solver.clearances(input::<M, N>(stretch.map(place)), radius);
            let here = here.as_ref()[group];
            let here = [here.value, here.rate, here.second_rate, here.scale];
            for (which, (number, [least, most])) in here.into_iter().zip(of).enumerate() {
                // The number's own rounding, as above.
                let own = 1e-12 * (1.0 + number.abs());
                let is_inside = (least - own..=most + own).contains(&number);
                assert!(is_inside, "{which}: {number} in {least}..{most} at {part} of {stretch:?}");
            }
        }
    }
    known
}

/// Calls the macro with every solver and as many of the inputs as it has.
macro_rules! of_every_group {
    ($check:ident, $stretch:ident) => {
        let [theta, lift] = $stretch;
        $check!(Parallelogram, [theta]);
        $check!(EqualSliderCrank, [theta]);
        $check!(OverThePivot, [theta]);
        $check!(TouchingOffset, [theta]);
        $check!(ThreeCranks, [theta]);
        $check!(Row, [theta, lift]);
        // Their poses have other formulas.
        $check!(ConstantDragLink, [theta]);
        $check!(ConstantStephenson, [theta]);
        $check!(ConstantBlock, [theta]);
        $check!(TunedCranks, [theta, lift]);
        $check!(ConstantRrp, [theta, lift]);
        $check!(CompensatedRow, [theta, lift]);
    };
}

#[test]
fn rates_are_those_of_dual_numbers() {
    let mut random = Random::new(71);
    for _ in 0..300 {
        let stretch = inputs(&mut random);
        macro_rules! check {
            ($solver:ident, $of:expr) => {
                rates_agree(&$solver::new(), &$solver::new().lift::<Dual2_64>(), $of)
            };
        }
        of_every_group!(check, stretch);
    }
}

/// A sample of the stretches of `.ci/nightly`.
#[test]
fn ranges_hold_the_values_between() {
    let (mut random, mut known, mut asked) = (Random::new(72), 0, 0);
    for _ in 0..cases(120, 300) {
        let stretch = inputs(&mut random);
        macro_rules! check {
            ($solver:ident, $of:expr) => {
                known += known_of_ranges(&$solver::new(), $of);
                asked += <$solver as Solver>::TITLES.groups.len();
            };
        }
        of_every_group!(check, stretch);
    }
    // Over 0.3 rad of a row of four groups nothing may be known of the last.
    assert!(4 * known > 3 * asked, "{known} of {asked}");
}
