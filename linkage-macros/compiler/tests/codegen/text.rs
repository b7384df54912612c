//! Tests of `codegen/text`.

pub(crate) use linkage_compiler::codegen::text::*;
use quote::quote;

#[test]
fn a_field_with_the_name_of_its_value_is_written_once() {
    let mut text = Text::default();
    text.put("Point { ").list(["x", "y"], |text, field| {
        text.field(field, |text| {
            text.put("x");
        })
    });
    text.put(" }");
    assert_eq!(quote!(#text).to_string(), quote!(Point { x, y: x }).to_string());
}
