//! Tests of `reach/turn`.

use crate::exact::Exact;
pub(crate) use linkage_compiler::reach::turn::*;

/// Two bars that turn with the crank about its own pivot: their joint stays where it is.
#[test]
fn bars_on_the_pivot_of_the_crank_turn_with_it_or_never() {
    let range = |radius: i64, lengths: [i64; 2]| {
        let [first, second] = lengths.map(Exact::integer);
        let at = [Exact::integer(0), Exact::integer(0)];
        Turn::of_two_bars(&Exact::integer(radius), &at, [&first, &second]).range
    };
    // Inside the reach, at its outer end and at its inner end; and beyond both.
    assert_eq!(range(3, [2, 3]), Range::Full);
    assert_eq!([range(3, [1, 2]), range(3, [1, 4])], [Range::Full, Range::Full]);
    assert_eq!([range(3, [1, 1]), range(1, [1, 3])], [Range::Never, Range::Never]);
    assert_eq!([range(1, [3, 1]), range(2, [3, 1])], [Range::Never, Range::Full]);
}
