//! What the careful path does where the straight line goes on regardless: at a guard, at what it
//! is given, and at what comes out.

use std::collections::HashSet;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::blocks::Statement;
use super::body::Body;
use super::names::{generated, local};
use super::rows;
use crate::ir::graph::{Check, GuardId, Id, Node};
use crate::ir::program::EntryKind;

/// A guard as a call: the value goes on as the call returns it.
pub(super) fn check(body: &Body<'_>, id: Id, value: Id, guard: GuardId) -> Statement {
    let condition = body.graph().condition(guard);
    let function = body.cx.paths.item(match condition.check {
        Check::ReachCircles => "reach_circles",
        Check::ReachLine => "reach_line",
        Check::ReachOffset => "reach_offset",
        Check::Nonzero => "nonzero",
        Check::Positive(_) => "positive",
        Check::Square if condition.operands.is_empty() => "square",
        Check::Square => "square_of_centres",
    });
    let looked_at = match condition.check {
        Check::ReachCircles | Check::ReachLine | Check::ReachOffset | Check::Square => {
            &condition.operands[..]
        }
        // These look at the value alone; the operands are there to be computed first.
        Check::Nonzero | Check::Positive(_) => &[],
    };
    let group = &body.cx.program.groups[condition.group as usize];
    let length = match &condition.check {
        Check::Positive(name) => Some(name),
        _ => None,
    };
    let length = length.into_iter();
    let operands = [value].into_iter().chain(looked_at.iter().copied());
    let (name, values) = (local(id), operands.clone().map(|operand| body.value(operand)));
    Statement {
        defines: vec![id],
        uses: body.locals(operands),
        code: quote!(let #name = #function(#(#values,)* #group #(, #length)*)?;),
        condition: None,
    }
}

/// The inputs and parameters that are read, and the test that each is finite.
pub(super) fn finite_inputs(body: &Body<'_>, leaves: &[Node]) -> TokenStream {
    let (given, scalar, text) =
        (generated("given_"), &body.cx.names.scalar, body.cx.paths.item("str"));
    let read = |&leaf: &Node| Some((body.arguments.leaf(leaf)?, body.arguments.label(leaf)?));
    let pairs: Vec<_> =
        leaves.iter().filter_map(read).map(|(value, label)| quote!((#value, #label))).collect();
    let count = Literal::usize_unsuffixed(pairs.len());
    let function = body.cx.paths.item("finite_input");
    let (value, label) = (generated("value_"), generated("name_"));
    quote! {
        let #given: [(#scalar, &'static #text); #count] = [#(#pairs),*];
        for &(#value, #label) in &#given { #function(#value, #label)?; }
    }
}

/// Asks of every result whether it is finite, in order: in a loop, because an early exit for each
/// of a thousand results takes the compiler seconds.
pub(super) fn finite_results(body: &Body<'_>, kind: EntryKind, sinks: &[Id]) -> TokenStream {
    let mut seen = HashSet::new();
    let known = |id| matches!(body.graph().node(id), Node::Constant(_) | Node::Mode(_));
    let sinks = sinks.iter().zip(rows::sink_labels(body.cx, kind));
    let pairs: Vec<_> = sinks
        .filter(|&(&sink, _)| !known(sink) && seen.insert(sink))
        .map(|(&sink, label)| {
            let value = body.value(sink);
            quote!((#value, #label))
        })
        .collect();
    if pairs.is_empty() {
        return TokenStream::new();
    }
    let (function, given) = (body.cx.paths.item("finite_result"), generated("given_"));
    let (value, label) = (generated("value_"), generated("name_"));
    quote!(for &(#value, #label) in &[#(#pairs),*] { #function(#value, #label, &#given)?; })
}
