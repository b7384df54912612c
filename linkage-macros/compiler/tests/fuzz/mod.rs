//! Valid declarations, mangled: the whole compiler reports or compiles, never panics, and what it
//! gives out is Rust.
//!
//! The ordinary run takes a few seconds. `LINKAGE_FUZZ=1000000 cargo test --release -p
//! linkage-compiler fuzz` mangles a million times, `LINKAGE_FUZZ_SEED` elsewhere.

pub(crate) mod large;
pub(crate) mod mangle;
pub(crate) mod seeds;

use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::diagnostics::{Diagnostic, Diagnostics};
use crate::pipeline::{Options, Output};
use crate::{model, pipeline, syntax};
use mangle::Mangler;
use proc_macro2::{TokenStream, TokenTree};

/// The counts of declarations that compiled, of those with mistakes, and of the mistakes reported.
#[derive(Default)]
struct Tally {
    compiled: usize,
    reported: usize,
    messages: usize,
}

/// The messages among the generated tokens, in order.
pub(crate) fn messages(output: TokenStream) -> Vec<String> {
    let mut messages = Vec::new();
    let mut trees = output.into_iter().peekable();
    while let Some(tree) = trees.next() {
        let TokenTree::Ident(word) = tree else { continue };
        if word != "compile_error" {
            continue;
        }
        let text = trees.find_map(|tree| match tree {
            TokenTree::Group(group) => syn::parse2::<syn::LitStr>(group.stream()).ok(),
            _ => None,
        });
        messages.extend(text.map(|text| text.value()));
    }
    messages
}

/// Most of the time goes into stubs and into reading them: of what has mistakes, one in so many
/// is compiled to the end.
const STUBS: usize = 64;

impl Tally {
    fn compile(&mut self, source: &TokenStream) {
        let checked = catch_unwind(AssertUnwindSafe(|| mistakes(source.clone())));
        let mistakes = checked.unwrap_or_else(|_| panic!("the compiler panicked on\n{source}"));
        if mistakes == 0 {
            self.compiled += 1;
        } else {
            self.reported += 1;
            self.messages += mistakes;
            if !self.reported.is_multiple_of(STUBS) {
                return;
            }
        }
        let output = catch_unwind(AssertUnwindSafe(|| {
            let Output { tokens, diagnostics, notes, .. } =
                pipeline::compile(source.clone(), &Options::ALL);
            let text =
                |found: &[Diagnostic]| found.iter().map(Diagnostic::text).collect::<Vec<_>>();
            let checked = pipeline::check(source.clone());
            assert_eq!(text(&checked), text(&[diagnostics, notes].concat()), "{source}");
            tokens
        }));
        let output = output.unwrap_or_else(|_| panic!("the compiler panicked on\n{source}"));
        if let Err(error) = syn::parse2::<syn::File>(output.clone()) {
            panic!("{error}: what is no Rust was made of\n{source}\n{output}");
        }
        assert_eq!(messages(output).len(), mistakes, "{source}");
    }
}

/// The number of mistakes in a declaration; one without any resolves.
fn mistakes(source: TokenStream) -> usize {
    let mut diagnostics = Diagnostics::new();
    let tree = syntax::parse(source, &mut diagnostics);
    let mechanism = tree.and_then(|tree| model::resolve(&tree, &mut diagnostics).ok());
    let mistakes = diagnostics.into_mistakes().len();
    assert!(mistakes > 0 || mechanism.is_some(), "refused without a message");
    mistakes
}

/// The messages of one declaration with slips after the other, the same in every run.
pub(crate) fn mistaken() -> impl Iterator<Item = Vec<String>> {
    let mut mangler = Mangler::new(1);
    std::iter::from_fn(move || {
        let mut diagnostics = Diagnostics::new();
        let tree = syntax::parse(mangler.next(), &mut diagnostics);
        let _mechanism = tree.and_then(|tree| model::resolve(&tree, &mut diagnostics).ok());
        Some(diagnostics.into_mistakes().iter().map(Diagnostic::text).collect())
    })
}

fn number_from(variable: &str, default: u64) -> u64 {
    let value = std::env::var(variable).ok();
    value.map_or(default, |value| value.parse().expect("a whole number"))
}

#[test]
fn mangled_declarations_are_compiled_or_reported() {
    let rounds = number_from("LINKAGE_FUZZ", 300);
    let mut mangler = Mangler::new(number_from("LINKAGE_FUZZ_SEED", 1));
    let mut tally = Tally::default();
    for round in 0..rounds {
        tally.compile(&mangler.next());
        if round % 100_000 == 99_999 {
            println!("{} of {rounds}: {} compiled", round + 1, tally.compiled);
        }
        // Every parsed text is remembered for its spans.
        proc_macro2::extra::invalidate_current_thread_spans();
    }
    let Tally { compiled, reported, messages } = tally;
    println!("{compiled} compiled, {reported} reported in {messages} messages");
    // Manglings that are all refused, or all legal, would try little.
    assert!(compiled * 50 > rounds as usize && reported * 3 > rounds as usize);
}

#[test]
fn what_is_mangled_is_valid() {
    for source in seeds::all() {
        let output = pipeline::compile(
            source.parse().expect("a declaration is made of tokens"),
            &Options::ALL,
        )
        .tokens;
        assert_eq!(messages(output), [""; 0], "{source}");
    }
}
