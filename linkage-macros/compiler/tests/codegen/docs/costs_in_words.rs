//! Tests of `codegen/docs/costs_in_words`.

use crate::ir::cost::Operations;
pub(crate) use linkage_compiler::codegen::docs::costs_in_words::*;

#[test]
fn searches_take_as_many_evaluations_as_at_run_time() {
    use linkage_core::find::Search;
    assert_eq!(MOST, [Search::<f64>::MOST, Search::<f32>::MOST]);
}

#[test]
fn a_cost_reads_as_a_sentence() {
    let none = Operations::default();
    assert_eq!(in_words(none), "no operation");
    assert_eq!(in_words(Operations { divisions: 1, ..none }), "1 division");
    let several = Operations { additions: 2, multiplications: 1, roots: 3, ..none };
    assert_eq!(in_words(several), "2 additions, 1 multiplication and 3 square roots");
}
