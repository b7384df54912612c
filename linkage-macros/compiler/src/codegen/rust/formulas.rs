//! The functions that hold formulas: a `let` for every node, and a call at every condition and
//! angle. Whether a condition is compared or diagnosed is up to the checks that are handed in.
//!
//! Position, velocity and motion share their formulas, which are most of what a mechanism expands
//! to: the order is a constant, and what a lower one does not need is never compiled for it. One order
//! more is a pose that says how clear of their limits the groups are.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use super::context::Context;
use super::in_rust::RustPrinter;
use super::results;
use super::token_list::Tokens;
use crate::codegen::identifiers::{generated, used};
use crate::codegen::text::Text;
use crate::interface::Interface;
use crate::interface::records::{Field, Record, Shape};
use crate::lower::routine::{Routine, Stage};

/// A stage of a routine, to be called.
#[derive(Clone, Copy)]
pub(in crate::codegen) struct Call {
    pub routine: usize,
    pub stage: usize,
}

impl Call {
    /// The result under the checks.
    pub(in crate::codegen) fn under(self, cx: &Context<'_>, checks: &TokenStream) -> TokenStream {
        let routine = &cx.lowered.routines[self.routine];
        let name = generated(&routine.name);
        let arguments = cx.signatures.arguments(&routine.given);
        let last = routine.stages.len() - 1;
        if last == 0 {
            let given = arguments.names();
            return quote!(self.#name(#checks, #(#given),*));
        }
        // A stage needs one order of the inputs less than the next.
        let missing = last - self.stage;
        let (given, _) = arguments.names().split_at(arguments.names().len() - missing);
        let order = Literal::usize_unsuffixed(self.stage);
        let (made, rest) = standstill(cx);
        let rates = vec![rest; missing];
        let call = quote!(self.#name::<#order>(#checks, #(#given,)* #(#rates),*));
        if missing == 0 {
            return call;
        }
        let field = &stage_fields(cx.interface, routine)[self.stage].name;
        match made {
            Some(made) => quote!({ #made #call.#field }),
            None => quote!(#call.#field),
        }
    }
}

/// The functions that hold the formulas of all entry points.
pub(in crate::codegen) fn functions(cx: &Context<'_>) -> TokenStream {
    cx.lowered.routines.iter().map(|routine| function(cx, routine)).collect()
}

fn function(cx: &Context<'_>, routine: &Routine) -> TokenStream {
    let mut lines = Text::long();
    let printer = RustPrinter::beginning(cx, routine, &mut lines);
    let name = generated(&routine.name);
    match &routine.stages[..] {
        [only] => {
            printer.statements(&only.statements, &mut lines);
            assemble(&printer, only, &mut lines);
            definition(&printer, &name, &lines)
        }
        stages => {
            let ty = cx.paths.item("usize");
            let name = quote!(#name<const ORDER: #ty>);
            in_stages(&printer, stages, &mut lines);
            definition(&printer, &name, &lines)
        }
    }
}

fn assemble(printer: &RustPrinter<'_>, stage: &Stage, to: &mut Text) {
    let mut sinks = stage.sinks.iter();
    let cx = printer.dialect.cx;
    results::assemble(cx.interface, &cx.paths, stage.result, to, &mut |to| {
        let sink = sinks.next().expect("a result has as many numbers as sinks");
        printer.value(*sink, to);
    });
}

/// The rates of inputs that do not move, and what makes them: of one input a number, of several a
/// record.
pub(super) fn standstill(cx: &Context<'_>) -> (Option<TokenStream>, Tokens) {
    let (rest, zero) = (generated("rest_"), cx.literal(0.0, 0.0));
    let Some(record) = cx.interface.input_record() else { return (None, zero) };
    let fields = cx.mechanism.inputs.iter().map(|input| used(&input.name));
    let made = quote!(let #rest = #zero; let #rest = #record { #(#fields: #rest),* };);
    (Some(made), rest.into())
}

/// The record that the stages of a routine fill, a field each.
fn record_of<'a>(interface: &'a Interface, routine: &Routine) -> &'a Record {
    match routine.result {
        Shape::Record(record) => interface.record(record),
        _ => unreachable!("what is computed in stages is a record"),
    }
}

fn stage_fields<'a>(interface: &'a Interface, routine: &Routine) -> &'a [Field] {
    &record_of(interface, routine).fields
}

/// Stage after stage, each followed by its record. The records of the stages that are not asked
/// for hold zeros.
fn in_stages(printer: &RustPrinter<'_>, stages: &[Stage], to: &mut Text) {
    let cx = printer.dialect.cx;
    let record = record_of(cx.interface, printer.routine);
    let locals: Vec<String> =
        record.fields.iter().map(|field| format!("{}_", field.name)).collect();
    zeros(cx, &record.fields[1..], &locals[1..], to);
    let mut result = Text::default();
    result.put(&record.name.to_string()).put(" { ");
    result.list(record.fields.iter().zip(&locals), |to, (field, local)| {
        to.put(&field.name.to_string()).put(": ").put(local);
    });
    result.put(" }");
    for (nth, stage) in stages.iter().enumerate() {
        printer.statements(&stage.statements, to);
        to.put("let ").put(&locals[nth]).put(" = ");
        assemble(printer, stage, to);
        to.put(";\n");
        if nth + 1 < stages.len() {
            to.put("if ORDER == ").put(&nth.to_string()).put(" { return ").append(&result);
            to.put("; }\n");
        }
    }
    to.append(&result);
}

/// The records of the stages that may not be asked for. Their types are written: whatever they follow
/// from comes last, and until then rustc would look for them at every statement.
fn zeros(cx: &Context<'_>, fields: &[Field], locals: &[String], to: &mut Text) {
    to.put("let zero_ = ").put(&cx.written(0.0, 0.0)).put(";\n");
    let as_array = cx.paths.written("Record");
    for (field, local) in fields.iter().zip(locals) {
        let ty =
            results::ty(cx.interface, &cx.paths, field.shape, &cx.names.scalar.to_token_stream())
                .to_string();
        to.put("let ").put(local).put(": ").put(&ty).put(" = ").put(&as_array);
        let numbers = cx.interface.numbers(field.shape);
        to.put("::from_array([zero_; ").put(&numbers.to_string()).put("]);\n");
    }
}

/// The function that holds formulas.
///
/// Inlined always: as a call of its own it would hand its results over through memory, one more
/// time, which costs a four-bar's solve a tenth of its throughput and a fifth of its latency; and
/// a sweep would run it on the instruction set of the rest of the program.
fn definition(printer: &RustPrinter<'_>, name: &impl ToTokens, lines: &Text) -> TokenStream {
    let (cx, routine, scalar) =
        (printer.dialect.cx, printer.routine, &printer.dialect.cx.names.scalar);
    let scalar = quote!(#scalar);
    let unread = printer.dialect.arguments.unread(&routine.reads);
    let (result, received) = (
        results::ty(cx.interface, &cx.paths, routine.result, &scalar),
        printer.dialect.arguments.received(&scalar),
    );
    let (guard, guards) = (generated("checks_"), cx.paths.item("Checks"));
    let unguarded = (!routine.has_checks).then(|| quote!(let _ = #guard;));
    quote! {
        #[inline(always)]
        fn #name(&self, #guard: &mut impl #guards<#scalar>, #(#received),*) -> #result {
            #unguarded
            #unread
            #lines
        }
    }
}
