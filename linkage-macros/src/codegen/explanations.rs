//! The careful path: the same graph once more, in order, stopping at the first thing that is
//! wrong. It runs only where the straight line's mask said no.
//!
//! Position, velocity and motion are one function, which stops where enough is known: nobody
//! waits for it, and most of what a mechanism expands to would be copies of it.

use std::collections::HashSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::blocks::{Statement, lay_out};
use super::body::{Body, Statements};
use super::careful::{finite_inputs, finite_results};
use super::names::{function_name, generated};
use super::{Context, docs, entry, results};
use crate::ir::graph::Id;
use crate::ir::liveness::Course;
use crate::ir::program::{Entry, EntryKind};

/// The name of the careful function beside an entry point.
pub(super) fn name(kind: EntryKind) -> Ident {
    function_name(&format!("explain_{}_", entry::method(kind)))
}

/// The careful functions of all entry points.
pub(super) fn functions(cx: &Context<'_>) -> TokenStream {
    use EntryKind::{Motion, MotionAt, Position, PositionAt, Velocity, VelocityAt};
    let orders = [[Position, Velocity, Motion], [PositionAt, VelocityAt, MotionAt]];
    let orders: Vec<Orders<'_>> = orders.iter().filter_map(|kinds| Orders::of(cx, kinds)).collect();
    let wholes = orders.iter().map(Orders::whole);
    let each = cx.program.entries.iter().map(|entry| {
        let body = match orders.iter().find_map(|orders| orders.call(entry.kind)) {
            Some(call) => call,
            None if cx.on_the_circle(entry).is_some() => by_cosine(cx, entry),
            None if entry.kind == EntryKind::Coefficients && cx.entry(Velocity).is_some() => {
                by_velocities(cx)
            }
            None => alone(cx, entry),
        };
        function(cx, entry.kind, &docs::careful(entry), &[], body)
    });
    quote!(#(#wholes)* #(#each)*)
}

/// A careful function with these arguments and more.
fn function(
    cx: &Context<'_>,
    kind: EntryKind,
    docs: &TokenStream,
    more: &[TokenStream],
    body: TokenStream,
) -> TokenStream {
    let name = match more {
        [] => name(kind),
        _ => whole_name(kind),
    };
    let received = cx.arguments(kind).received(&{
        let scalar = &cx.names.scalar;
        quote!(#scalar)
    });
    let [outcome, error] = ["Result", "SolveError"].map(|item| cx.paths.item(item));
    let result = entry::result(cx, kind);
    quote! {
        #docs
        #[cold]
        #[inline(never)]
        fn #name(&self, #(#received,)* #(#more),*) -> #outcome<#result, #error> { #body }
    }
}

/// `explain_` and `explain_at_`.
fn whole_name(kind: EntryKind) -> Ident {
    function_name(if entry::takes_cosine(kind) { "explain_at_" } else { "explain_" })
}

/// A function for one entry point alone.
fn alone(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let arguments = cx.arguments(entry.kind);
    let body = Body { cx, arguments: &arguments, course: Course::Careful };
    let statements = body.statements(&entry.sinks);
    let (lines, _) = lay_out(&statements.list, &body.locals(entry.sinks.iter().copied()));
    let unread = arguments.unread(&statements.leaves);
    let inputs = finite_inputs(&body, &statements.leaves);
    let finite = finite_results(&body, entry.kind, &entry.sinks);
    let values = entry.sinks.iter().map(|&sink| body.value(sink)).collect();
    let (value, ok) = (results::assemble(cx, entry.kind, values), cx.paths.item("Ok"));
    quote!(#unread #inputs #lines #finite #ok(#value))
}

/// The angle, once it is known to be finite, by its cosine and sine.
fn by_cosine(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let arguments = cx.arguments(entry.kind);
    let (angle, rates) = arguments.names().split_first().expect("the angle comes first");
    let label = super::names::text(&cx.mechanism.inputs[0].name);
    let (finite, sin_cos) = (cx.paths.item("finite_input"), cx.scalar("sin_cos"));
    let [sin, cos] = ["sin_", "cos_"].map(generated);
    let name = cx.on_the_circle(entry).map(|at| name(at.kind));
    quote! {
        #finite(#angle, #label)?;
        let (#sin, #cos) = #sin_cos(#angle);
        self.#name(#cos, #sin #(, #rates)*)
    }
}

/// Coefficients are the velocities at a unit rate of each input in turn.
fn by_velocities(cx: &Context<'_>) -> TokenStream {
    let [zero, one] = ["zero_", "one_"].map(generated);
    let (nought, unit, ok) = (cx.literal(0.0, 0.0), cx.literal(1.0, 1.0), cx.paths.item("Ok"));
    let (arguments, velocity) = (cx.arguments(EntryKind::Coefficients), name(EntryKind::Velocity));
    let (inputs, given) = (&cx.mechanism.inputs, arguments.names());
    let columns: Vec<_> = (0..inputs.len()).map(|i| generated(&format!("column{i}_"))).collect();
    let velocities = columns.iter().enumerate().map(|(moving, column)| {
        let fields = inputs.iter().enumerate().map(|(i, input)| {
            let (field, rate) = (&input.name, if i == moving { &one } else { &zero });
            quote!(#field: #rate)
        });
        let (record, rates) = (&cx.names.input, quote!(#(#fields),*));
        let rates = if arguments.are_records() { quote!(#record { #rates }) } else { quote!(#one) };
        quote!(let #column = self.#velocity(#(#given,)* #rates)?.rows();)
    });
    let rows = cx.mechanism.outputs.iter().map(|output| output.kind.shape().rates()).sum();
    let rows = (0..rows).map(|row| {
        let row = Literal::usize_unsuffixed(row);
        quote!([#(#columns[#row]),*])
    });
    let still = arguments.are_records().then(|| quote!(let #zero = #nought;));
    quote! {
        #still
        let #one = #unit;
        #(#velocities)*
        #ok([#(#rows),*])
    }
}

/// Position, velocity and motion of one kind of input.
struct Orders<'a> {
    cx: &'a Context<'a>,
    entries: [&'a Entry; 3],
}

impl<'a> Orders<'a> {
    /// `None` where one is missing, or where another function does the work.
    fn of(cx: &'a Context<'a>, kinds: &[EntryKind; 3]) -> Option<Self> {
        let entry = |kind| cx.entry(kind).filter(|entry| cx.on_the_circle(entry).is_none());
        let entries = [entry(kinds[0])?, entry(kinds[1])?, entry(kinds[2])?];
        Some(Self { cx, entries })
    }

    fn motion(&self) -> &'a Entry {
        self.entries[2]
    }

    /// What an entry point calls in place of a function of its own.
    fn call(&self, kind: EntryKind) -> Option<TokenStream> {
        let cx = self.cx;
        let order = self.entries.iter().position(|entry| entry.kind == kind)?;
        let (given, whole) = (cx.arguments(kind), whole_name(kind));
        let given = given.names();
        let missing = self.entries.len() - 1 - order;
        let zero = generated("zero_");
        let still = (missing > 0).then(|| self.at_rest(&zero));
        let zeros = vec![&zero; missing];
        let order = Literal::usize_unsuffixed(order);
        let part = match missing {
            0 => return Some(quote!(self.#whole(#(#given,)* #order))),
            1 => quote!(velocity),
            _ => quote!(position),
        };
        let ok = cx.paths.item("Ok");
        Some(quote! {
            #still
            #ok(self.#whole(#(#given,)* #(#zeros,)* #order)?.#part)
        })
    }

    /// The rates of all inputs as zeros.
    fn at_rest(&self, name: &Ident) -> TokenStream {
        let (cx, nought) = (self.cx, self.cx.literal(0.0, 0.0));
        if !cx.arguments(self.motion().kind).are_records() {
            return quote!(let #name = #nought;);
        }
        let record = &cx.names.input;
        let fields = cx.mechanism.inputs.iter().map(|input| &input.name);
        quote!(let #name = #nought; let #name = #record { #(#fields: #name),* };)
    }

    /// The one function that does the work.
    fn whole(&self) -> TokenStream {
        let (cx, motion) = (self.cx, self.motion());
        let arguments = cx.arguments(motion.kind);
        let body = Body { cx, arguments: &arguments, course: Course::Careful };
        let (mut statements, mut done) = (Statements::default(), HashSet::new());
        let zero = generated("zero_");
        for (order, entry) in self.entries.iter().enumerate() {
            body.add_statements(&mut statements, &mut done, &entry.sinks);
            if entry.kind != motion.kind {
                statements.list.push(self.stop(&body, order, &zero));
            }
        }
        let sinks = &motion.sinks;
        let (lines, _) = lay_out(&statements.list, &body.locals(sinks.iter().copied()));
        let unread = arguments.unread(&statements.leaves);
        let inputs = finite_inputs(&body, &statements.leaves);
        let finite = finite_results(&body, motion.kind, sinks);
        let values = sinks.iter().map(|&sink| body.value(sink)).collect();
        let value = results::assemble(cx, motion.kind, values);
        let (nought, ok) = (cx.literal(0.0, 0.0), cx.paths.item("Ok"));
        let (last, ty) = (generated("order_"), cx.paths.item("usize"));
        let code = quote! {
            let #zero = #nought;
            #unread #inputs #lines #finite
            #ok(#value)
        };
        function(cx, motion.kind, &docs::explanation(), &[quote!(#last: #ty)], code)
    }

    /// The end for those who asked for no higher order; what they have not asked for is zero.
    fn stop(&self, body: &Body<'_>, order: usize, zero: &Ident) -> Statement {
        let (cx, entry, motion) = (self.cx, self.entries[order], self.motion());
        let known: usize = self.entries[..=order].iter().map(|entry| entry.sinks.len()).sum();
        let sinks = &motion.sinks[..known];
        let finite = finite_results(body, entry.kind, &entry.sinks);
        let value = |i: usize| match sinks.get(i) {
            Some(&sink) => body.value(sink),
            None => quote!(#zero),
        };
        let values = (0..motion.sinks.len()).map(value).collect();
        let value = results::assemble(cx, motion.kind, values);
        let (last, ok) = (generated("order_"), cx.paths.item("Ok"));
        let order = Literal::usize_unsuffixed(order);
        let used = |sinks: &[Id]| body.locals(sinks.iter().copied());
        Statement {
            uses: used(sinks),
            code: quote!(if #last == #order { #finite return #ok(#value); }),
            ..Statement::default()
        }
    }
}
