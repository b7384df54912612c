//! Parameters by name, of any machine.

use linkage_core::{Parameters, Real, Scalar, Side, mechanism};
use linkage_tests::in_both_widths;
use linkage_tests::widths::number;
use num_dual::Dual64;

mechanism! {
    /// A parameter of each kind that a number has, and a mode between them.
    pub struct Kinds {
        input theta: angle;
        param crank = 80mm;
        param elbow: mode = right;
        param turn = 30deg;
        param m = 2kg;
        param ratio: number = 1.5;
        param moment = 0.1(kg*m^2);
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B        { length: crank, angle: ratio * theta + turn }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: elbow }
        mass m on C;
        inertia moment on DC;
        output C, theta.drive;
    }
}

/// The numbers of a machine of which nothing else is known.
fn listed<P: Parameters>(machine: &P) -> Vec<(&'static str, &'static str, f64)>
where
    P::Number: Real,
{
    let mut list = Vec::new();
    machine.each(|name, unit, value| list.push((name, unit, value.value())));
    list
}

#[test]
fn parameters_are_told_in_order_with_their_units() {
    let kinds = Kinds { elbow: Side::Left, ratio: 2.5, ..Kinds::new() };
    assert_eq!(<Kinds as Parameters>::NAMES, Kinds::PARAMS);
    assert_eq!(
        listed(&kinds),
        [
            ("crank", "m", 0.08),
            ("turn", "rad", kinds.turn),
            ("m", "kg", 2.0),
            ("ratio", "1", 2.5),
            ("moment", "kg·m²", 0.1)
        ]
    );
}

#[test]
fn a_parameter_is_set_by_its_name_and_nothing_else_changes() {
    let kinds = Kinds { elbow: Side::Left, ..Kinds::new() };
    for (name, _, value) in listed(&kinds) {
        assert_eq!(kinds.parameter(name), Some(value));
        let other = kinds.with_parameter(name, 7.0).expect("it has this name");
        assert_eq!(other.elbow, Side::Left);
        let changed = listed(&other).into_iter().zip(listed(&kinds));
        for ((own, _, now), (_, _, before)) in changed {
            assert_eq!(now, if own == name { 7.0 } else { before }, "{name}: {own}");
        }
    }
    for name in ["elbow", "theta", "", "Crank"] {
        assert_eq!(
            (kinds.parameter(name), kinds.with_parameter(name, 7.0)),
            (None, None),
            "{name}"
        );
    }
    let scaled = kinds.with_named(|name| (name != "m").then_some(1.0));
    assert_eq!((scaled.crank, scaled.m, scaled.moment), (1.0, 2.0, 1.0));
}

fn on_other_numbers<T: Real + Scalar>() {
    let kinds = Kinds::<T> { crank: number(0.09), ..Default::default() };
    let lifted = kinds.lift::<f64>();
    let mapped: Kinds = kinds.map(|value| value.value());
    assert_eq!(listed(&mapped), listed(&lifted));
    assert_eq!(mapped.elbow, kinds.elbow);
}

/// A derivative by a parameter that its name chooses, against a difference.
#[test]
fn a_name_chooses_the_parameter_that_is_differentiated_by() {
    let kinds = Kinds::new();
    let slope = |chosen: &str| {
        let mut names = Kinds::PARAMS.iter();
        let machine: Kinds<Dual64> = kinds.map(|value| {
            let own = Dual64::from_re(value);
            if names.next() == Some(&chosen) { own.derivative() } else { own }
        });
        machine.position(Dual64::from_re(0.7)).expect("it stands").C.x.eps
    };
    for name in ["crank", "turn", "ratio"] {
        let at = |by: f64| {
            let moved = kinds.with_parameter(name, kinds.parameter(name).unwrap() + by).unwrap();
            moved.position(0.7).unwrap().C.x
        };
        let difference = (at(1e-6) - at(-1e-6)) / 2e-6;
        // h² of a third derivative of order one, and roundings over h.
        assert!((slope(name) - difference).abs() < 1e-9, "{name}: {} {difference}", slope(name));
        assert!(difference.abs() > 1e-3, "{name}");
    }
    assert_eq!(slope("m"), 0.0);
}

in_both_widths! { on_other_numbers }
