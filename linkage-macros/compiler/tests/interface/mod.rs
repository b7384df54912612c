//! Tests of `interface`.

pub(crate) mod components;
pub(crate) mod dimensions;
pub(crate) mod entries;
pub(crate) mod quantity;
pub(crate) mod units_in_words;

use crate::interface::entries::Analysis;
use crate::interface::records::RecordKind;
use crate::oracle::mechanism;
pub(crate) use linkage_compiler::interface::*;

#[test]
fn a_record_of_what_is_not_offered_is_not_used() {
    let mechanism = mechanism(
        "struct M { input theta: angle; ground A(0, 0), D(600mm, 0);
             crank AB(A) -> B { length: 80mm, angle: theta }
             rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
             mass 1kg on B;
             output C, DC.margin; }",
    );
    let used = |analysis: Analysis| {
        let interface = Interface::of(&mechanism).limited_to([analysis.by_value()].into_iter());
        let is_used = |kind| {
            let record = interface.records.iter().find(|record| record.kind == kind);
            interface.is_used(record.expect("the mechanism has such a record"))
        };
        [RecordKind::Motion, RecordKind::Margins, RecordKind::Equations].map(is_used)
    };
    assert_eq!(used(Analysis::Motion), [true, false, false]);
    assert_eq!(used(Analysis::Margins), [true, true, false]);
    assert_eq!(used(Analysis::EquationsOfMotion), [true, false, true]);
}
