//! Tests of `lower/locals`.

pub(crate) use linkage_compiler::lower::locals::*;

#[test]
fn a_local_has_one_underscore_between_its_words_and_one_behind() {
    assert_eq!(single_underscores("a__b__x_"), "a_b_x_");
    assert_eq!(single_underscores("_b_x_"), "b_x_");
}
