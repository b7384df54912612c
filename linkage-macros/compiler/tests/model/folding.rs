//! Tests of `model/folding`.

pub(crate) use linkage_compiler::model::folding::*;

#[test]
fn six_significant_digits_are_shown() {
    assert_eq!(shown_f64(5.3), "5.3");
    assert_eq!(shown_f64(2.0 / 3.0), "0.666667");
    assert_eq!(shown_f64(-0.3), "-0.3");
    assert_eq!(shown_f64(0.0), "0");
    assert_eq!(shown_f64(632.0), "632");
}
