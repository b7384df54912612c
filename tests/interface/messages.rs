//! The messages that a control engineer reads when a pose cannot be computed.

use linkage_core::SolveError;

#[test]
fn an_error_names_the_group_and_the_missing_distance() {
    let error = SolveError::OutOfReach { group: "BC, DC", by: 0.25 };
    assert_eq!(error.to_string(), "BC, DC: out of reach by 250 mm");
}
