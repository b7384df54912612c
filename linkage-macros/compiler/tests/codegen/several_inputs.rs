//! Code of solvers with several inputs.

use super::*;

#[test]
fn a_sweep_over_several_inputs_takes_a_record_of_series() {
    assert_has(
        &table(),
        &[
            "inputs: impl Inputs<TableInput<Series<'series, T>>>,",
            "let rates: TableInput<Series<'series, T>> = Into::into(rates);",
            "[inputs.s, inputs.X, rates.s, rates.X]",
        ],
    );
}

/// Values first, then rates: in the order of the series.
#[test]
fn a_solver_of_several_inputs_is_given_them_by_their_places() {
    let text = "pub struct Arm { input a, b: angle; ground O(0, 0);
        crank AB(O) -> B { length: 1m, angle: a } crank BC(B) -> C { length: 1m, angle: b } }";
    let tokens = text.parse().expect("these are tokens");
    let text = bare(&crate::pipeline::compile(tokens, &Options::NONE).tokens.to_string());
    for part in [
        "core_velocity_(ArmInput { a: given_(0), b: given_(1) }, \
         ArmInput { a: given_(2), b: given_(3) }), put_)",
        "[inputs.a, inputs.b, rates.a, rates.b]",
    ] {
        assert!(text.contains(&bare(part)), "no `{part}`");
    }
}
