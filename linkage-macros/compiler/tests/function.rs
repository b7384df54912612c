//! Tests of `function`.

pub(crate) use linkage_compiler::function::*;

#[test]
fn a_row_stands_where_its_function_points() {
    for (place, row) in ROWS.iter().enumerate() {
        assert_eq!(row.function as usize, place);
        assert_eq!(Function::named(row.name), Some(row.function));
    }
}
