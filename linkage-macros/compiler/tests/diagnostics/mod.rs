//! Tests of `diagnostics`.

pub(crate) mod told;

pub(crate) use linkage_compiler::diagnostics::*;
use proc_macro2::{Span, TokenStream};
pub(crate) use told::told;

fn messages(failure: Failure) -> Vec<String> {
    failure.0.iter().map(Diagnostic::text).collect()
}

#[test]
fn every_mistake_is_reported_in_the_order_of_appearance() {
    let mut diagnostics = Diagnostics::new();
    diagnostics.error(Span::call_site(), "first");
    diagnostics.error_because(Span::call_site(), "second", "its reason");
    diagnostics.adopt(syn::Error::new(Span::call_site(), "third"));
    assert_eq!(diagnostics.count(), 3);
    let failure = diagnostics.finish().expect_err("three mistakes were reported");
    assert_eq!(messages(failure), ["first", "second\nits reason", "third"]);
}

#[test]
fn a_note_is_no_mistake_and_is_told_once_in_the_order_of_the_source() {
    let tokens: TokenStream = "a\nb".parse().expect("these are tokens");
    let mut diagnostics = Diagnostics::new();
    for tree in tokens.into_iter().collect::<Vec<_>>().into_iter().rev() {
        diagnostics.note_because(tree.span(), &tree, "why");
        diagnostics.note_because(tree.span(), &tree, "why");
    }
    assert!(diagnostics.barrier().is_ok() && diagnostics.count() == 0);
    let notes = diagnostics.take_notes();
    assert!(notes.iter().all(|note| note.level == Level::Note));
    assert_eq!(messages(Failure(notes)), ["a\nwhy", "b\nwhy"]);
    assert!(diagnostics.finish().is_ok());
}

#[test]
fn mistakes_come_in_the_order_of_the_source() {
    let tokens: TokenStream = "a\nb c".parse().expect("these are tokens");
    let mut diagnostics = Diagnostics::new();
    for tree in tokens.into_iter().collect::<Vec<_>>().into_iter().rev() {
        diagnostics.error(tree.span(), &tree);
    }
    let failure = diagnostics.finish().expect_err("three mistakes were reported");
    assert_eq!(messages(failure), ["a", "b", "c"]);
}

#[test]
fn a_mistake_is_reported_at_its_token() {
    let tokens: TokenStream = "a b c".parse().expect("these are tokens");
    let b = tokens.into_iter().nth(1).expect("there are three");
    let mut diagnostics = Diagnostics::new();
    diagnostics.error(b.span(), "here");
    let failure = diagnostics.finish().expect_err("a mistake was reported");
    let sources: Vec<_> = failure.0[0]
        .compile_error()
        .into_iter()
        .filter_map(|tree| tree.span().source_text())
        .collect();
    assert!(!sources.is_empty() && sources.iter().all(|text| text == "b"), "{sources:?}");
}

#[test]
fn a_barrier_stops_after_a_mistake_and_only_then() {
    let mut diagnostics = Diagnostics::new();
    assert!(diagnostics.barrier().is_ok());
    diagnostics.error(Span::call_site(), "late");
    let failure = diagnostics.barrier().expect_err("a mistake was reported");
    assert_eq!(messages(failure), ["late"]);
    // A mistake that a barrier has handed over is not reported twice.
    assert!(diagnostics.finish().is_ok());
}

#[test]
#[should_panic(expected = "diagnostics were dropped without a barrier")]
fn forgetting_to_ask_is_a_panic() {
    drop(Diagnostics::new());
}

#[test]
#[should_panic(expected = "diagnostics were dropped without a barrier")]
fn a_mistake_behind_a_barrier_must_be_asked_for_again() {
    let mut diagnostics = Diagnostics::new();
    assert!(diagnostics.barrier().is_ok());
    diagnostics.error(Span::call_site(), "late");
    drop(diagnostics);
}

#[test]
fn the_nearest_name_is_one_that_may_have_been_meant() {
    let names = ["A", "B", "blade", "coupler", "theta", "phi"];
    for (name, expected) in [
        ("Bb", Some("B")),
        ("b", Some("B")),
        ("balde", Some("blade")),
        ("blad", Some("blade")),
        ("bladee", Some("blade")),
        ("BLADE", Some("blade")),
        ("copuelr", Some("coupler")),
        ("thet", Some("theta")),
        ("quadrant", None),
        ("Q", None),
        ("blowtorch", None),
    ] {
        assert_eq!(nearest(name, names.into_iter()), expected, "{name}");
    }
    assert_eq!(nearest("A", std::iter::empty()), None);
}

#[test]
fn a_swap_costs_as_much_as_any_other_slip() {
    for (a, b, expected) in [
        ("", "", 0),
        ("", "abc", 3),
        ("abc", "", 3),
        ("rrp", "rpr", 1),
        ("rrr", "rrp", 1),
        ("ground", "gorund", 1),
        ("kitten", "sitting", 3),
        ("Theta", "theta", 0),
    ] {
        assert_eq!(distance(a, b), expected, "{a} {b}");
    }
}
