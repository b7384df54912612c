//! The careful path: the same graph once more, in order, stopping at the first thing that is
//! wrong. It runs only where the straight line's mask said no.

use proc_macro2::TokenStream;
use quote::quote;

use super::blocks::{Statement, lay_out};
use super::body::Body;
use super::names::{function_name, local};
use super::{Context, docs, entry, results, rows};
use crate::ir::graph::{Check, GuardId, Id, Node};
use crate::ir::liveness::Course;
use crate::ir::program::Entry;

/// The name of the careful function beside an entry point.
pub(super) fn name(entry: &Entry) -> proc_macro2::Ident {
    function_name(&format!("explain_{}_", entry::method(entry.kind)))
}

/// A guard as a call: the value goes on as the call returns it.
pub(super) fn check(body: &Body<'_>, id: Id, value: Id, guard: GuardId) -> Statement {
    let condition = body.graph().condition(guard);
    let function = body.cx.paths.item(match condition.check {
        Check::ReachCircles => "reach_circles",
        Check::ReachLine => "reach_line",
        Check::ReachOffset => "reach_offset",
        Check::Nonzero => "nonzero",
        Check::Positive(_) => "positive",
        Check::Square => "square",
    });
    let looked_at = match condition.check {
        Check::ReachCircles | Check::ReachLine | Check::ReachOffset => &condition.operands[..],
        // These look at the value alone; the operands are there to be computed first.
        Check::Nonzero | Check::Positive(_) | Check::Square => &[],
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

/// The function that says why the straight line of an entry point gave no answer.
pub(super) fn function(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let arguments = cx.arguments(entry.kind);
    let body = Body { cx, arguments: &arguments, course: Course::Careful };
    let statements = body.statements(&entry.sinks);
    let kept = body.locals(entry.sinks.iter().copied());
    let (lines, _) = lay_out(&statements.list, &kept);

    let scalar = &cx.names.scalar;
    let (name, received) = (name(entry), arguments.received(&quote!(#scalar)));
    let unread = arguments.unread(&statements.leaves);
    let inputs = finite_inputs(&body, &statements.leaves);
    let finite = finite_results(&body, entry);
    let values = entry.sinks.iter().map(|&sink| body.value(sink)).collect();
    let (result, value) =
        (entry::result(cx, entry.kind), results::assemble(cx, entry.kind, values));
    let (outcome, error, ok) =
        (cx.paths.item("Result"), cx.paths.item("SolveError"), cx.paths.item("Ok"));
    let docs = docs::careful(entry);
    quote! {
        #docs
        #[cold]
        #[inline(never)]
        fn #name(&self, #(#received),*) -> #outcome<#result, #error> {
            #unread
            #inputs
            #lines
            #finite
            #ok(#value)
        }
    }
}

fn finite_inputs(body: &Body<'_>, leaves: &[Node]) -> TokenStream {
    let finite = body.cx.paths.item("finite_input");
    let check = |&leaf: &Node| {
        let (value, label) = (body.arguments.leaf(leaf), body.arguments.label(leaf));
        quote!(#finite(#value, #label)?;)
    };
    leaves.iter().map(check).collect()
}

fn finite_results(body: &Body<'_>, entry: &Entry) -> TokenStream {
    let finite = body.cx.paths.item("finite_result");
    let labels = rows::sink_labels(body.cx, entry.kind);
    let mut seen = std::collections::HashSet::new();
    let mut checks = TokenStream::new();
    for (&sink, label) in entry.sinks.iter().zip(labels) {
        let known = matches!(body.graph().node(sink), Node::Constant(_) | Node::Mode(_));
        if !known && seen.insert(sink) {
            let value = body.value(sink);
            checks.extend(quote!(#finite(#value, #label)?;));
        }
    }
    checks
}
