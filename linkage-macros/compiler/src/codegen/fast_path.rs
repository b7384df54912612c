//! `solve_…`: the formulas read without a branch. They go on regardless, and a mask says in the
//! end whether the result may be used.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::arguments::Arguments;
use super::context::Context;
use super::identifiers::{function_name, generated};
use super::text::Text;
use super::token_list::Tokens;
use super::{doc_comments, docs, formulas, results};
use crate::interface::EntryId;
use crate::interface::entries::Entry;
use crate::ir::graph::Node;
use crate::lower::routine::{Adapted, Asked, Compute, Limits};

/// The name of the core of an entry point, which has the numbers and records themselves for arguments:
/// the public function, where that has.
pub(super) fn core_name(cx: &Context<'_>, entry: &Entry) -> Ident {
    match has_core(cx, entry) {
        true => function_name(&format!("core_{}_", entry.name())),
        false => public_name(entry),
    }
}

fn public_name(entry: &Entry) -> Ident {
    function_name(&format!("solve_{}", entry.name()))
}

/// Whether the public function turns its arguments into others before anything is computed.
fn has_core(cx: &Context<'_>, entry: &Entry) -> bool {
    entry.takes_cosine() || Arguments::new(cx, &entry.given).has_records()
}

/// `solve_…`, and the core that it shares with everything else.
///
/// Inlined always, as everything is that lanes call: what is not would run on the instruction set of
/// the rest of the program, and hand its results over through memory.
pub(super) fn function(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let (entry, scalar) = (cx.entry(id), &cx.names.scalar);
    let number = quote!(#scalar);
    let arguments = Arguments::new(cx, &entry.given);
    let (declared, received) = (arguments.declared(&number), arguments.received(&number));
    let (converted, answer) = (arguments.converted(&number), answer(cx, id));
    let body = match cx.compute(id) {
        Compute::Via { entry: other, given: Adapted::CosineAndSine } => {
            by_cosine(cx, &arguments, *other)
        }
        Compute::Via { entry: other, given: Adapted::UnitRate } => {
            at_unit_rate(cx, &arguments, *other)
        }
        Compute::Own { routine, stage, asked } => {
            compared(cx, id, formulas::Call { routine: *routine, stage: *stage }, asked)
        }
    };
    let (docs, result) = (docs::fast_path(cx, id), results::ty(cx, entry.result, &number));
    let (name, core) = (public_name(entry), core_name(cx, entry));
    let square = Together::of(cx, id).map(|_| {
        let square = generated(SQUARE);
        quote!(, #square: #scalar)
    });
    let (shown, core) = match has_core(cx, entry) {
        false => (body, None),
        true => (
            quote!(#converted #answer),
            Some(quote! {
                #[inline(always)]
                fn #core(&self, #(#received),* #square) -> (#result, #scalar::Mask) { #body }
            }),
        ),
    };
    quote! {
        #docs
        #[inline(always)]
        #[must_use]
        pub fn #name(&self, #(#declared),*) -> (#result, #scalar::Mask) { #shown }

        #core
    }
}

/// The answer to the arguments of an entry point, by one call: of the core, where that has the same.
pub(super) fn call(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let entry = cx.entry(id);
    if !entry.takes_cosine() {
        return answer(cx, id);
    }
    let (arguments, name) = (Arguments::new(cx, &entry.given), public_name(entry));
    let given = arguments.names();
    quote!(self.#name(#(#given),*))
}

/// The core's answer to the arguments of an entry point. The amplitude of a given cosine and sine is
/// divided out here, because an angle's have none.
fn answer(cx: &Context<'_>, id: EntryId) -> TokenStream {
    let entry = cx.entry(id);
    let (arguments, core) = (Arguments::new(cx, &entry.given), core_name(cx, entry));
    let (names, [result, ok]) = (arguments.names(), ["result_", "ok_"].map(generated));
    if !entry.takes_cosine() {
        return quote!(self.#core(#(#names),*));
    }
    let (given, rates) = names.split_at(2);
    let ([cos, sin, near], on_circle) =
        (["cos_", "sin_", "near_"].map(generated), cx.paths.item("on_circle"));
    let square = Together::of(cx, id).map(|_| {
        // A sum with −0 is the other number, whatever it is, and no addition.
        let none = cx.literal(-0.0, -0.0);
        quote!(, #none)
    });
    quote! {
        let (#cos, #sin, #near) = #on_circle(#(#given),*);
        let (#result, #ok) = self.#core(#cos, #sin #(, #rates)* #square);
        (#result, #ok & #near)
    }
}

/// The formulas, every condition compared, and the test that every result is finite.
fn compared(cx: &Context<'_>, id: EntryId, call: formulas::Call, asked: &Asked) -> TokenStream {
    let start = cx.paths.item("AllMet");
    compared_from(cx, id, call, asked, &quote!(#start::new()))
}

/// The fast path of a sweep's pose, whose searches begin by the seeds of their unknowns; none where nothing is
/// searched by a seed, or where the formulas are another entry point's.
pub(super) fn following(cx: &Context<'_>, id: EntryId) -> Option<TokenStream> {
    let Compute::Own { routine, stage, asked } = cx.compute(id) else { return None };
    let has_seeds = cx.lowered.searches.iter().any(|search| search.apart.is_some());
    let entry = cx.entry(id);
    if !has_seeds || !entry.is_a_stage() {
        return None;
    }
    let (scalar, seeds) = (&cx.names.scalar, generated("seeds_"));
    let number = quote!(#scalar);
    let received = Arguments::new(cx, &entry.given).received(&number);
    let [start, seed] = ["AllMet", "Seed"].map(|item| cx.paths.item(item));
    let start = quote!(#start::following(#seeds));
    let call = formulas::Call { routine: *routine, stage: *stage };
    let body = compared_from(cx, id, call, asked, &start);
    let (name, result) = (following_name(entry), results::ty(cx, entry.result, &number));
    let docs = doc_comments::lines(&format!(
        "`{}` in a sweep: searches begin by what the pose before has left.",
        public_name(entry),
    ));
    Some(quote! {
        #docs
        fn #name(&self, #(#received,)* #seeds: &mut [#seed<#scalar>]) -> (#result, #scalar::Mask) {
            #body
        }
    })
}

/// The name of the function that [`following`] makes.
pub(super) fn following_name(entry: &Entry) -> Ident {
    function_name(&format!("follow_{}_", entry.name()))
}

/// [`compared`], the conditions by these checks.
fn compared_from(
    cx: &Context<'_>,
    id: EntryId,
    call: formulas::Call,
    asked: &Asked,
    start: &TokenStream,
) -> TokenStream {
    let [all_met, result] = ["all_met_", "result_"].map(generated);
    let formulas = call.under(cx, &quote!(&mut #all_met));
    let finite = is_finite(cx, id, asked, "result_").map(|finite| quote!(& #finite));
    quote! {
        let mut #all_met = #start;
        let #result = #formulas;
        (#result, #all_met.all() #finite)
    }
}

/// The core of the other entry point, given the angle's cosine and sine.
fn by_cosine(cx: &Context<'_>, arguments: &Arguments<'_>, other: EntryId) -> TokenStream {
    let [sin, cos, result, ok] = ["sin_", "cos_", "result_", "ok_"].map(generated);
    let (sin_cos, core) = (cx.scalar("sin_cos_near"), core_name(cx, cx.entry(other)));
    let (angle, rates) = arguments.names().split_first().expect("the angle comes first");
    if Together::of(cx, other).is_some() {
        return quote! {
            let (#sin, #cos) = #sin_cos(#angle);
            self.#core(#cos, #sin #(, #rates)*, #angle * #angle)
        };
    }
    let is_near = cx.scalar("is_near");
    quote! {
        let (#sin, #cos) = #sin_cos(#angle);
        let (#result, #ok) = self.#core(#cos, #sin #(, #rates)*);
        (#result, #is_near(#angle) & #ok)
    }
}

/// The square of the angle, for a core that compares it together with its rates; zero where cosine and sine
/// are given.
const SQUARE: &str = "square_";

/// The angles for which sines are right without a look at more of π, in rad, in both widths: 2²⁰ and some
/// 8192 turns.
const NEAR: [f64; 2] = [1_048_576.0, 51_471.0];

/// One comparison for an angle and its rates: (θ² + θ̇²)² + θ̈² up to the fourth power of a limit keeps angle
/// and rate within the limit and the second rate within its square. In double precision it lies at 170 000
/// turns and as many a second.
struct Together<'a> {
    limits: &'a Limits,
}

impl<'a> Together<'a> {
    /// Of an entry point that is given cosine and sine and asks for rates.
    fn of(cx: &'a Context<'_>, id: EntryId) -> Option<Self> {
        let Compute::Own { asked, .. } = cx.compute(id) else { return None };
        let limits = asked.limits.as_ref().filter(|limits| !limits.inputs.is_empty())?;
        cx.entry(id).takes_cosine().then_some(Self { limits })
    }

    /// Powers of the limit: the least that the angle or a rate has.
    fn limit(&self, cx: &Context<'_>, power: i32) -> Tokens {
        let mut least = NEAR;
        for (node, bounds) in &self.limits.inputs {
            let is_second = matches!(node, Node::Input { order: 2, .. });
            for (least, bound) in least.iter_mut().zip(bounds) {
                *least = least.min(if is_second { bound.sqrt() } else { *bound });
            }
        }
        let [wide, narrow] = least.map(|limit| limit.powi(power));
        cx.literal(wide, narrow as f32)
    }

    fn is_met(&self, cx: &Context<'_>, entry: &Entry) -> TokenStream {
        let arguments = Arguments::new(cx, &entry.given);
        let [fused, is_met] = ["fused", "ge"].map(|item| cx.scalar(item));
        let of_order = |wanted: u8| {
            let is_it = |node: &Node| matches!(node, Node::Input { order, .. } if *order == wanted);
            let mut nodes = self.limits.inputs.iter().map(|(node, _)| *node);
            nodes.find(is_it).and_then(|node| arguments.read(node))
        };
        let square = generated(SQUARE);
        let squares = match of_order(1) {
            Some(rate) => quote!(#fused(#rate, #rate, #square)),
            None => quote!(#square),
        };
        let Some(second) = of_order(2) else {
            let limit = self.limit(cx, 2);
            return quote!(#is_met(#limit, #squares));
        };
        let limit = self.limit(cx, 4);
        quote!(#is_met(#limit, #fused(#squares, #squares, #second * #second)))
    }
}

/// The velocities at a rate of one, a column of rows.
fn at_unit_rate(cx: &Context<'_>, arguments: &Arguments<'_>, velocity: EntryId) -> TokenStream {
    let [result, ok] = ["result_", "ok_"].map(generated);
    let (answer, column) = (of_unit_rate(cx, arguments, velocity), cx.paths.item("column"));
    quote! {
        let (#result, #ok) = #answer;
        (#column(#result.rows()), #ok)
    }
}

/// The core's answer to a rate of one.
pub(super) fn of_unit_rate(
    cx: &Context<'_>,
    arguments: &Arguments<'_>,
    velocity: EntryId,
) -> TokenStream {
    let (names, one) = (arguments.names(), cx.literal(1.0, 1.0));
    let core = core_name(cx, cx.entry(velocity));
    quote!(self.#core(#(#names,)* #one))
}

/// |value| ≤ bound for each of the inputs; a rate together with its second rate, whose bound is the
/// square of the rate's: |q̈| ≤ bound² − q̇² is one comparison for two.
fn within(cx: &Context<'_>, entry: &Entry, inputs: &[(Node, [f64; 2])]) -> Vec<TokenStream> {
    let (arguments, is_within, fused) =
        (Arguments::new(cx, &entry.given), cx.scalar("is_within"), cx.scalar("fused"));
    let is_asked = |node| inputs.iter().any(|&(other, _)| other == node);
    let term = |&(node, [wide, narrow]): &(Node, [f64; 2])| {
        let Node::Input { input, order } = node else { return None };
        if order == 1 && is_asked(Node::Input { input, order: 2 }) {
            return None;
        }
        let value = arguments.read(node)?;
        let bound = cx.literal(wide.min(f64::MAX), (narrow as f32).min(f32::MAX));
        let rate = Node::Input { input, order: 1 };
        if order < 2 || !is_asked(rate) {
            return Some(quote!(#is_within(#value, #bound)));
        }
        let rate = arguments.read(rate)?;
        Some(quote!(#is_within(#value, #fused(-#rate, #rate, #bound))))
    };
    inputs.iter().filter_map(term).collect()
}

/// Whether the result is finite, as a term of a mask; nothing where it cannot be otherwise.
fn is_finite(cx: &Context<'_>, id: EntryId, asked: &Asked, result: &str) -> Option<TokenStream> {
    let entry = cx.entry(id);
    let components = results::components(cx, entry.result, result);
    let witnesses: Vec<_> = asked.witnesses.iter().map(|&at| components[at].clone()).collect();
    if witnesses.is_empty() {
        return None;
    }
    // Of their sum, because what is not finite stays so.
    let (is_finite, sum) = (cx.scalar("is_finite"), Text::from(sum(&witnesses)));
    let Some(Limits { wide, narrow, inputs }) = &asked.limits else {
        return Some(quote!(#is_finite(#sum)));
    };
    let (plain, unless) = (cx.scalar("plain"), cx.paths.item("is_finite_unless"));
    let mut terms = match Together::of(cx, id) {
        Some(together) => vec![together.is_met(cx, entry)],
        None => within(cx, entry, inputs),
    };
    terms.push(quote!(#unless(#plain(#wide, #narrow), #sum)));
    Some(quote!(#(#terms)&*))
}

/// The sum as a balanced tree: it is short in time, and shallow for the compiler.
fn sum(values: &[String]) -> String {
    match values {
        [] => String::new(),
        [only] => only.clone(),
        _ => {
            let (left, right) = values.split_at(values.len().div_ceil(2));
            let (left, right) = (term(left), term(right));
            format!("{left} + {right}")
        }
    }
}

fn term(values: &[String]) -> String {
    let sum = sum(values);
    if values.len() > 1 { format!("({sum})") } else { sum }
}
