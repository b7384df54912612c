//! How the straight line knows that its results are finite.
//!
//! Asking the results is right always, and late: all of them have to be kept until the last is
//! there. Where bounds on the inputs and on the divisors keep every value from overflowing, these
//! are asked instead, which are known early. That is decided here, for each width of its own; a
//! number that carries derivatives is asked for its results in any case, because a derivative may
//! overflow where the value does not.

use std::collections::HashMap;

use proc_macro2::TokenStream;
use quote::quote;

use super::dominance::undominated;
use super::pieces::Pieces;
use super::{Context, formulas, results};
use crate::ir::bounds::{Floors, Limits, Values};
use crate::ir::graph::{Check, Graph, Id, Node};
use crate::ir::liveness::{Course, live, live_nodes};
use crate::ir::program::{Entry, EntryKind};

/// What the straight line asks of inputs and divisors in place of its results.
pub(super) struct Bounds {
    wide: Option<Width>,
    narrow: Option<Width>,
}

/// The bounds of one width.
struct Width {
    floors: Floors,
    /// On inputs and rates; on second rates its square.
    input: f64,
}

/// From what asks least to what asks most. A pose beyond the bounds is not lost: the careful path
/// finds what there is to find.
const WIDE: [Limits; 3] = [wide(1e60, 0.0), wide(1e60, 1e-30), wide(1e20, 1e-30)];
const NARROW: [Limits; 4] =
    [narrow(1e6, 0.0), narrow(1e6, 1e-7), narrow(65_536.0, 1e-6), narrow(8192.0, 1e-5)];

/// Squares of full precision begin at the smallest normal number over ε².
const fn wide(input: f64, share: f64) -> Limits {
    let (normal, epsilon) = (f64::MIN_POSITIVE, f64::EPSILON);
    Limits { input, share, square: 4.6e-277, normal, epsilon, largest: 1e300, factor: 1e297 }
}

const fn narrow(input: f64, share: f64) -> Limits {
    let (normal, epsilon) = (f32::MIN_POSITIVE as f64, f32::EPSILON as f64);
    Limits { input, share, square: 8.4e-25, normal, epsilon, largest: 1e37, factor: 1e34 }
}

/// The bounds of every function that holds formulas, by its entry point, where there are any.
pub(super) fn all(cx: &Context<'_>) -> HashMap<EntryKind, Bounds> {
    let own = cx.program.entries.iter().filter(|entry| cx.has_formulas(entry));
    let led = own.filter(|entry| formulas::leading(cx, entry).kind == entry.kind);
    led.filter_map(|entry| Some((entry.kind, Bounds::find(cx, entry)?))).collect()
}

impl Bounds {
    /// Bounds under which no value overflows on the way to the sinks, if there are any and fewer
    /// questions come of it.
    fn find(cx: &Context<'_>, entry: &Entry) -> Option<Self> {
        let (graph, sinks) = (&cx.program.graph, &entry.sinks);
        let asked = asked(graph, sinks).len();
        if asked > 0 && asked >= undominated(graph, sinks).len() {
            return None;
        }
        let values = Values::new(graph, &live(graph, sinks, Course::Straight));
        let first = |limits: &[Limits]| {
            let width = |limits: &Limits| {
                Some(Width { floors: values.floors(limits)?, input: limits.input })
            };
            limits.iter().find_map(width)
        };
        let (wide, narrow) = (first(&WIDE), first(&NARROW));
        (wide.is_some() || narrow.is_some()).then_some(Self { wide, narrow })
    }

    /// The least that the condition on a value is to find there; nothing where bounds show that
    /// it holds, or where a spread that is known at run time asks for more.
    pub(super) fn least(
        &self,
        cx: &Context<'_>,
        value: Id,
        check: &Check,
        spread: Option<Id>,
    ) -> Option<Pieces> {
        let spread = spread.map(|spread| cx.program.graph.as_constant(spread));
        let sign = |limits: Limits| match check {
            Check::Square => limits.square,
            Check::ReachLine => limits.normal,
            _ => spread.flatten().map_or(0.0, |spread| limits.rounding_of(spread)),
        };
        let of = |width: &Option<Width>, limits: Limits| match width {
            Some(width) => width.floors.get(&value).copied().unwrap_or(Some(sign(limits))),
            None => Some(sign(limits)),
        };
        let (wide, narrow) = (of(&self.wide, WIDE[0]), of(&self.narrow, NARROW[0]));
        let asked = wide.or(narrow)?;
        // What is above rounding is above zero.
        if spread.is_some_and(|spread| spread.is_none()) && asked + narrow.unwrap_or(0.0) == 0.0 {
            return None;
        }
        Some(cx.literal(wide.unwrap_or(0.0), narrow.unwrap_or(0.0) as f32))
    }

    /// Whether the inputs that the entry point reads lie within their bounds.
    fn inputs(&self, cx: &Context<'_>, entry: &Entry) -> Vec<TokenStream> {
        let arguments = cx.arguments(entry.kind);
        let input = |width: &Option<Width>, largest| width.as_ref().map_or(largest, |w| w.input);
        let first = [input(&self.wide, f64::MAX), input(&self.narrow, f64::from(f32::MAX))];
        let within = |node| {
            let bound = match node {
                Node::Input { order: 2, .. } => first.map(|bound| bound * bound),
                _ => first,
            };
            Some(within(cx, &arguments.leaf(node)?, bound))
        };
        asked(&cx.program.graph, &entry.sinks).into_iter().filter_map(within).collect()
    }
}

/// The inputs and rates that bounds are asked of: those that not only sines and cosines read.
fn asked(graph: &Graph, sinks: &[Id]) -> Vec<Node> {
    let live = live(graph, sinks, Course::Straight);
    let mut only_turned = vec![true; graph.len()];
    sinks.iter().for_each(|sink| only_turned[sink.index()] = false);
    for (_, node) in live_nodes(graph, &live) {
        if !matches!(node, Node::Sin(_) | Node::Cos(_)) {
            node.for_operands(&mut |operand| only_turned[operand.index()] = false);
        }
    }
    live_nodes(graph, &live)
        .filter(|&(id, node)| matches!(node, Node::Input { .. }) && !only_turned[id.index()])
        .map(|(_, node)| node)
        .collect()
}

/// |value| ≤ bound.
fn within(cx: &Context<'_>, value: &Pieces, [wide, narrow]: [f64; 2]) -> TokenStream {
    let is_within = cx.scalar("is_within");
    let bound = cx.literal(wide.min(f64::MAX), (narrow as f32).min(f32::MAX));
    quote!(#is_within(#value, #bound))
}

/// Whether the result is finite, as a term of a mask; nothing where it cannot be otherwise.
pub(super) fn test(cx: &Context<'_>, entry: &Entry, result: &TokenStream) -> Option<TokenStream> {
    let results = results_are_finite(cx, entry, result)?;
    let Some(bounds) = cx.bounds.get(&formulas::leading(cx, entry).kind) else {
        return Some(results);
    };
    let (plain, mask, scalar) = (cx.scalar("plain"), cx.paths.item("Mask"), &cx.names.scalar);
    let (wide, narrow) = (bounds.wide.is_some(), bounds.narrow.is_some());
    let terms = bounds.inputs(cx, entry).into_iter().chain([quote! {
        (if #plain(#wide, #narrow) { <#scalar::Mask as #mask>::ALL } else { #results })
    }]);
    Some(quote!(#(#terms)&*))
}

/// Of their sum, because what is not finite stays so.
fn results_are_finite(
    cx: &Context<'_>,
    entry: &Entry,
    result: &TokenStream,
) -> Option<TokenStream> {
    let tested = undominated(&cx.program.graph, &entry.sinks);
    let components = results::components_of(cx, entry.kind, result);
    let read = |id| entry.sinks.iter().position(|&sink| sink == id).map(|at| &components[at]);
    let values: Vec<_> = tested.into_iter().filter_map(read).cloned().collect();
    (!values.is_empty()).then(|| {
        let (is_finite, sum) = (cx.scalar("is_finite"), sum(&values));
        quote!(#is_finite(#sum))
    })
}

/// The sum as a balanced tree: it is short in time, and shallow for the compiler.
fn sum(values: &[TokenStream]) -> TokenStream {
    match values {
        [] => TokenStream::new(),
        [only] => only.clone(),
        _ => {
            let (left, right) = values.split_at(values.len().div_ceil(2));
            let (left, right) = (term(left), term(right));
            quote!(#left + #right)
        }
    }
}

fn term(values: &[TokenStream]) -> TokenStream {
    let sum = sum(values);
    if values.len() > 1 { quote!((#sum)) } else { sum }
}
