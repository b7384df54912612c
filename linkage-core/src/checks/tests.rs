use super::*;
use crate::diagnosis::{Nonzero, Positive};

#[test]
fn the_first_error_is_kept() {
    let mut first_error = FirstError::new();
    assert_eq!(first_error.guard(2.0, Nonzero("a")), 2.0);
    assert_eq!(first_error.first(), Ok(()));
    first_error.guard(0.0, Nonzero("b"));
    first_error.guard(-1.0, Positive("c", "length"));
    assert_eq!(first_error.first(), Err(SolveError::Singular { group: "b" }));
}

#[test]
fn all_is_met_only_where_every_condition_is() {
    let met = |ask: fn(&mut AllMet<bool>)| {
        let mut all = AllMet::new();
        ask(&mut all);
        all.away(1.0, 0.0);
        all.all()
    };
    assert!(met(|m| m.at_least(0.0, 0.0)));
    assert!(!met(|m| m.at_least(-1e-300, 0.0)));
    assert!(!met(|m| m.at_least(1e-320, f64::smallest_square())));
    assert!(!met(|m| m.above(0.0, 0.0)));
    assert!(met(|m| m.above(2.0, 1.0)) && !met(|m| m.above(1.0, 1.0)));
    assert!(met(|m| m.above_rounding(1e-13, 1.0)));
    assert!(!met(|m| m.above_rounding(1e-13, 1000.0)));
    assert!(met(|m| m.away(-1e-300, 0.0)));
    assert!(!met(|m| m.away(0.0, 0.0)));
    assert!(met(|m| m.away(-2.0, 1.0)) && !met(|m| m.away(-1.0, 1.0)));
    assert!(!met(|m| _ = m.sin_cos(1e9)));
    assert!(!met(|m| m.above(f64::NAN, 0.0)));
    assert!(!met(|m| m.at_least(f64::NAN, 0.0)));
    assert!(!met(|m| m.away(f64::NAN, 0.0)));
}

#[test]
fn the_one_does_not_diagnose_and_the_other_does_not_compare() {
    let mut all = AllMet::<bool>::new();
    assert_eq!(all.guard(0.0, Nonzero("a")), 0.0);
    assert!(all.all());
    let mut first_error = FirstError::new();
    first_error.above(-1.0, 0.0);
    assert_eq!(first_error.first(), Ok(()));
}
