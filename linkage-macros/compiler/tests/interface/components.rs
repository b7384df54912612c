//! Tests of `interface/components`.

use crate::interface::Interface;
use crate::interface::entries::Analysis;
use crate::oracle::mechanism;
pub(crate) use linkage_compiler::interface::components::*;

#[test]
fn a_result_is_read_in_the_order_of_its_numbers() {
    let mechanism = mechanism(
        "struct M { input s: length; input u: length; ground A(0, 0), D(600mm, 0);
             rrr AC(A), DC(D) -> C { lengths: (s, u), mode: right }
             output C, AC, AC.margin; }",
    );
    let interface = Interface::of(&mechanism);
    let ways = |analysis: Analysis| -> Vec<String> {
        let entry = interface.find(analysis.by_value()).expect("it is offered");
        let shape = interface.entry(entry).result;
        let ways = interface.components(shape);
        assert_eq!(ways.len(), interface.numbers(shape));
        let written = |step: &Component| match step {
            Component::Field(name) => format!(".{name}"),
            Component::Index(at) => format!("[{at}]"),
        };
        ways.iter().map(|way| way.iter().map(written).collect()).collect()
    };
    assert_eq!(
        ways(Analysis::Position),
        [".C.x", ".C.y", ".AC.cos", ".AC.sin", ".AC_margin"].map(str::to_string)
    );
    assert_eq!(ways(Analysis::Motion)[5], ".velocity.C.x");
    // Column by column, while an element is addressed by its row.
    assert_eq!(ways(Analysis::Coefficients)[..2], ["[0][0]", "[1][0]"].map(str::to_string));
}
