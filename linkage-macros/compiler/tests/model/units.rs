//! Tests of `model/units`.

use crate::exact::Exact;
use crate::syntax::words::UNITS;
pub(crate) use linkage_compiler::model::units::*;

#[test]
fn units_are_exact() {
    let value = |digits: &str, name: &str| {
        let (_, factor) = unit(name).unwrap();
        Exact::decimal(digits).unwrap().mul(&factor)
    };
    assert_eq!(value("1", "in"), value("25.4", "mm"));
    assert_eq!(value("1", "ft"), value("12", "in"));
    assert_eq!(value("180", "deg"), Exact::pi());
    assert_eq!(value("0.5", "turn"), Exact::pi());
    assert_eq!(value("1500", "g"), value("1.5", "kg"));
    assert_eq!(value("0.05", "t"), value("50", "kg"));
    assert_eq!(value("0.05", "kN"), value("50", "N"));
    assert_eq!(value("2500", "ms"), value("2.5", "s"));
    assert_eq!(value("1e6", "um"), value("100", "cm"));
}

#[test]
fn every_listed_unit_exists() {
    assert!(UNITS.iter().all(|name| unit(name).is_some()));
}
