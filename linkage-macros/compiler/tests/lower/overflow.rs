//! Tests of `lower/overflow`.

use crate::exact::Exact;
use crate::ir::check::Least;
use crate::ir::graph::Id;
use crate::ir::hash::Map;
use crate::lower::ranges::Thresholds;
use crate::lower::routine::Threshold;
pub(crate) use linkage_compiler::lower::overflow::*;

const VALUE: Id = Id(7);

/// Threshold of the value where ranges ask for this in double and in single precision; none where they
/// show that the condition holds.
fn threshold([wide, narrow]: [Option<f64>; 2], spread: Option<Spread<'_>>) -> Option<Threshold> {
    let width = |least| {
        let mut thresholds = Thresholds::default();
        thresholds.insert(VALUE, least);
        Some(WidthLimits { thresholds, lengths: Map::default(), input: 1e6 })
    };
    let overflow = Overflow { wide: width(wide), narrow: width(narrow) };
    overflow.threshold(VALUE, Least::Rounding, spread)
}

/// A spread that is computed is compared with beside the threshold, and says more than a sign.
#[test]
fn a_sign_is_not_asked_where_the_rounding_is() {
    let computed = Some(Spread::AtRunTime(Id(3)));
    let known = Exact::integer(2);
    let known = Some(Spread::Known(&known));
    let both = |wide, narrow| Some(Threshold::Number(wide, narrow));
    assert_eq!(threshold([Some(0.0); 2], computed), None);
    assert_eq!(threshold([Some(1e-30), Some(0.0)], computed), both(1e-30, 0.0));
    assert_eq!(threshold([Some(0.0), Some(1e-7)], computed), both(0.0, 1e-7));
    assert_eq!(threshold([None, Some(1e-7)], computed), both(0.0, 1e-7));
    assert_eq!(threshold([None, Some(0.0)], computed), None);
    for spread in [None, known] {
        assert_eq!(threshold([Some(0.0); 2], spread), both(0.0, 0.0));
        assert_eq!(threshold([Some(1e-30), Some(1e-7)], spread), both(1e-30, 1e-7));
        assert_eq!(threshold([None; 2], spread), None);
    }
    // Where one width has no ranges, its results are asked, and of the value its rounding alone.
    let mut thresholds = Thresholds::default();
    thresholds.insert(VALUE, None);
    let overflow = Overflow {
        wide: Some(WidthLimits { thresholds, lengths: Map::default(), input: 1e60 }),
        narrow: None,
    };
    let found = overflow.threshold(VALUE, Least::Rounding, known);
    assert_eq!(found, both(0.0, 32.0 * f64::from(f32::EPSILON)));
}

/// Up to the digits that are written down, and never below.
#[test]
fn squares_of_full_precision_begin_where_they_do_at_run_time() {
    use linkage_core::Scalar;
    let narrow = f64::from(f32::smallest_square());
    let widths = [(WIDE[0], f64::smallest_square()), (NARROW[0], narrow)];
    for (assumed, smallest) in widths {
        assert!((smallest..1.03 * smallest).contains(&assumed.square), "{assumed:?}");
    }
}
