//! Margins where a pose is not: with their slopes, and beside groups that have no pose.

use core::f64::consts::PI;

use linkage_core::{Real, SolveError, differentiate};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::margins::*;
use linkage_tests::random::{Random, cases};
use linkage_tests::widths::{list, number};
use num_dual::{Derivative, DualNum, DualSVec};

/// A four-bar that cannot be assembled: its margin has the slopes of f64's differences, and its transmission,
/// 0 or π there, changes by nothing.
#[test]
fn slopes_are_there_beyond_the_limit() {
    for (d, l) in [([3.1, 4.3], [3.0, 2.0]), ([0.3, -0.4], [3.0, 2.0]), ([9.0, 1.0], [0.5, 4.0])] {
        let at = [d[0], d[1], l[0], l[1]];
        let slopes = differentiate(at, |[dx, dy, l1, l2]| {
            let group = MarginRrr { l1, l2 };
            let told = group.margins([number(0.0), number(0.0), dx, dy])?;
            Ok([told.DC_margin, told.DC_transmission])
        });
        let slopes = slopes.expect("the margin is there");
        let margin = |[dx, dy, l1, l2]: [f64; 4]| {
            let group = MarginRrr { l1, l2 };
            let told = group.margins([0.0, 0.0, dx, dy]).expect("the margin is there");
            assert!(told.DC_margin < 0.0 && (told.DC_transmission / PI).fract() == 0.0);
            told.DC_margin
        };
        for k in 0..4 {
            let beside = |by: f64| core::array::from_fn(|i| at[i] + if i == k { by } else { 0.0 });
            let h = 1e-5;
            let difference = (margin(beside(h)) - margin(beside(-h))) / (2.0 * h);
            // h² of a third derivative below 1e4, and roundings of a margin below 1e3 over h.
            assert!(
                (slopes[(0, k)] - difference).abs() <= 1e-5,
                "{at:?} {k} {slopes} {difference}"
            );
            assert_eq!(slopes[(1, k)], 0.0);
        }
    }
}

fn on_duals<T: Real + DualNum>()
where
    DualSVec<T, 1>: Real,
{
    let at = |d: f64| {
        let moved = DualSVec::<T, 1>::from_re(T::num(d)).derivative(0);
        let zero = number(0.0);
        let group = MarginRrr::<DualSVec<T, 1>>::default();
        group.margins([zero, zero, moved, zero])
    };
    let slope = |x: DualSVec<T, 1>| match x.eps {
        Derivative(Some(eps)) => eps[0].value(),
        _ => 0.0,
    };
    // In reach, beyond both limits, and at one, where the transmission has no slope.
    let inside = at(4.0).expect("in reach");
    assert!(inside.DC_transmission.value() > 0.5 && slope(inside.DC_transmission) > 0.1);
    for (d, limit) in [(5.5, PI), (0.5, 0.0)] {
        let beyond = at(d).expect("a margin is there");
        assert!(beyond.DC_margin.value() < -0.4);
        assert_eq!(beyond.DC_transmission.value(), T::num(limit).value());
        assert!(slope(beyond.DC_margin).abs() > 0.5 && slope(beyond.DC_transmission) == 0.0);
    }
    let refused = at(5.0).map(|told| told.DC_transmission);
    assert_eq!(refused, Err(SolveError::Singular { group: "DC.transmission" }));
    // Nothing that is differentiated is there: the transmission is that of stretched bars.
    let zero = number(0.0);
    let still = MarginRrr::<DualSVec<T, 1>>::default().margins([zero, zero, number(5.0), zero]);
    assert_eq!(still.map(|told| told.DC_transmission.value()), Ok(T::num(PI).value()));
}

/// Each margin of the chain is that of the machine without the other groups, and NaN behind a group that has no
/// pose and nowhere else; a record of nothing but NaN is the error.
fn beside_groups_without_a_pose<T: Real>() {
    let mut random = Random::new(54);
    let (mut behind, mut beside, mut known) = (0, 0, 0);
    for _ in 0..cases(2_000, 20_000) {
        let draw = [random.between(0.02, 0.6), random.between(0.1, 0.6), random.between(0.05, 0.8)];
        let [crank, coupler, lever] = list::<T, 3>(draw);
        let theta = number::<T>(random.between(0.0, 6.2));
        let chain = MarginChain { crank, coupler, lever };
        let told = chain.margins(theta).expect("two margins are known");
        let [dc, gf, kl] = [told.DC_margin, told.GF_margin, told.KL_margin].map(Real::value);
        assert!(dc.is_finite() && kl.is_finite() && told.DC_transmission.value().is_finite());
        let alone = MarginAlone { crank, coupler, lever };
        let first = alone.position(theta);
        assert_eq!(gf.is_nan(), first.is_err(), "{draw:?}");
        assert_eq!(told.GF_transmission.value().is_nan(), gf.is_nan());
        if let Ok(p) = first {
            // The same formulas on the same numbers, but for the slow path's square root of a sum.
            assert!(is_same(p.DC_margin, told.DC_margin));
            let [gx, gy] = [number::<T>(0.15), number::<T>(0.35)];
            let pair = MarginRrr { l1: number(0.18), l2: lever };
            let expected = pair.margins([p.E.x, p.E.y, gx, gy]).expect("its own margin");
            let (expected, d) = (expected.DC_margin.value(), p.E.distance([gx, gy].into()).value());
            // Some ten roundings of lengths below one, over the distance that is divided by.
            let allowed = 20.0 * T::EPSILON / d.min(1.0).powi(2);
            assert!((gf - expected).abs() <= allowed, "{draw:?} {gf} {expected}");
            known += 1;
        } else {
            let refusal = MarginBehind { crank, coupler, lever }.margins(theta);
            let refused = matches!(refusal, Err(SolveError::OutOfReach { group: "BC, DC", .. }));
            assert!(refused && dc < 0.0, "{draw:?} {dc}");
            behind += 1;
            beside += u32::from(kl > 0.0);
        }
    }
    assert!(known > 200 && behind > 200 && beside > 100, "{known} {behind} {beside}");
}

/// From any machine that cannot be assembled there is a way back: of the bars in reach and of those beyond it the
/// margin has slopes, whatever is told beside it.
#[test]
fn no_margin_is_refused_its_slopes() {
    let mut random = Random::new(7);
    let (mut beyond, mut inside) = (0, 0);
    for _ in 0..cases(2_000, 20_000) {
        let at = [random.between(0.02, 0.6), random.between(0.1, 0.6), random.between(0.0, 6.2)];
        let slopes = differentiate(at, |[crank, coupler, theta]| {
            let chain = MarginChain { crank, coupler, ..MarginChain::new().lift() };
            let told = chain.margins(theta)?;
            Ok([told.DC_margin, told.DC_transmission, told.KL_margin])
        });
        let slopes = slopes.unwrap_or_else(|error| panic!("{at:?}: {error}"));
        let chain = MarginChain { crank: at[0], coupler: at[1], ..MarginChain::new() };
        if chain.margins(at[2]).expect("two are known").DC_margin < 0.0 {
            assert!(slopes.row(1).iter().all(|&slope| slope == 0.0), "{at:?} {slopes}");
            beyond += 1;
        } else {
            inside += 1;
        }
    }
    assert!(beyond > 500 && inside > 500, "{beyond} {inside}");
}

/// True if they differ by no more than the slow path's square root of a sum makes.
fn is_same<T: Real>(a: T, b: T) -> bool {
    (a.value() - b.value()).abs() <= 4.0 * T::EPSILON * b.value().abs()
}

/// Before a search without a root, and before a dyad in the search that cannot be assembled.
fn before_a_search<T: Real>() {
    let search = MarginSearch::<T>::default();
    let all = search.margins(list([0.25, -0.1])).expect("all are known");
    assert!(
        [all.KL_margin, all.ram_margin, all.GF_margin]
            .map(|x| x.value())
            .iter()
            .all(|x| x.is_finite())
    );
    // Beyond the stroke of 330 mm; and with a crank that leaves the rod at some angles, behind any root.
    let long = MarginSearch { crank: number(0.5) };
    for (search, x) in [(search, 0.4), (long, 2.0)] {
        let told = search.margins(list([x, -0.1])).expect("the first is known");
        assert!(is_same(told.KL_margin, all.KL_margin));
        assert!(told.ram_margin.value().is_nan() && told.GF_margin.value().is_nan());
    }
    // Before the search nothing is known either, beyond the reach of P's bars but their own margin.
    let far = search.margins(list([0.25, 5.0])).expect("the first is known");
    assert!(far.KL_margin.value() < -4.0 && is_same(far.GF_margin, all.GF_margin));
}

/// A number that is none for another reason than a group without a pose is refused as before.
#[test]
fn nothing_else_is_let_through() {
    let chain = MarginChain::new();
    assert_eq!(
        chain.margins(f64::NAN).map(|told| told.KL_margin),
        Err(SolveError::NotFinite { name: "theta" })
    );
    // The second dyad is out of reach as well as its lever is no length.
    let wrong = MarginChain { crank: 0.6, coupler: 0.1, lever: -0.1 };
    let refused = wrong.margins(2.0).map(|told| told.KL_margin);
    assert!(
        matches!(refused, Err(SolveError::Invalid { .. } | SolveError::OutOfReach { .. })),
        "{refused:?}"
    );
    // The margin itself overflows, of a group without a pose.
    let far = MarginRrr::new().margins([0.0, 0.0, 1e200, 0.0]).map(|told| told.DC_margin);
    assert!(far.is_err(), "{far:?}");
}

in_both_widths! { on_duals beside_groups_without_a_pose before_a_search }
