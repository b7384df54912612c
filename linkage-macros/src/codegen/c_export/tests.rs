//! The header and the functions of a small mechanism.

use crate::oracle::mechanism;
use crate::{codegen, equations, passes};

const ARM: &str = "pub struct SlowArm { input theta: angle; ground A(0, 0);
    crank AB(A) -> B { length: 0.5, angle: theta } output B;";

fn expansion(rest: &str) -> String {
    let mechanism = mechanism(&format!("{ARM} {rest} }}"));
    let program = passes::optimise(&equations::derive(&mechanism, passes::RULES));
    codegen::generate(&mechanism, &program).to_string()
}

#[test]
fn a_mechanism_that_is_not_exported_has_no_unsafe_code() {
    let code = expansion("");
    for word in ["unsafe", "no_mangle", "extern", "C_HEADER"] {
        assert!(!code.contains(word), "{word}");
    }
}

#[test]
fn every_entry_is_exported_in_both_widths_and_declared_in_the_header() {
    let code = expansion("export c;");
    for entry in ["position", "velocity", "motion", "coefficients", "position_at"] {
        for width in ["", "_f32"] {
            let name = format!("slow_arm_{entry}{width} (");
            assert!(code.contains(&name), "{name}");
            let name = format!("slow_arm_{entry}{width}(");
            assert!(code.contains(&name), "{name} in the header");
        }
    }
}
