//! Tests of `codegen/identifiers`.

pub(crate) use linkage_compiler::codegen::identifiers::*;
use proc_macro2::{Ident, Span};
use quote::format_ident;

#[test]
fn an_argument_is_a_lower_case_identifier() {
    let named = |name: &str, suffix| argument(&format_ident!("{name}"), suffix).to_string();
    assert_eq!(named("theta", "_rate"), "theta_rate");
    assert_eq!(named("Q", ""), "q");
    assert_eq!(named("As", ""), "as_");
    assert_eq!(named("out", ""), "out_");
    let raw = Ident::new_raw("type", Span::call_site());
    assert_eq!(argument(&raw, "").to_string(), "type_");
    assert_eq!(argument(&raw, "_rate").to_string(), "type_rate");
}

#[test]
fn a_mechanism_may_be_named_like_a_type_parameter() {
    assert_eq!(clear_of("T", &format_ident!("T")), "T_");
    assert_eq!(clear_of("T", &format_ident!("U")), "T");
}
