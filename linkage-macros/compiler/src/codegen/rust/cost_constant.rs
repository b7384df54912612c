//! `COST`: the operations of every entry point, and of a trial of every search.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::context::Context;
use super::paths::Paths;
use super::token_list::Tokens;
use crate::codegen::docs::costs_in_words::MOST;
use crate::codegen::identifiers::generated;
use crate::interface::Interface;
use crate::interface::entries::Analysis;
use crate::ir::cost::Operations;

/// The type of `COST`.
pub(super) fn ty(cx: &Context<'_>) -> Tokens {
    cx.paths.item(match (cx.searches(), has_forces(cx.interface)) {
        (true, true) => "SearchingForcesCost",
        (true, false) => "SearchingCost",
        (false, true) => "ForcesCost",
        (false, false) => "Cost",
    })
}

/// True if an entry point about forces has a cost.
fn has_forces(interface: &Interface) -> bool {
    let mut points = interface.entries.iter().map(|entry| entry.point);
    points.any(|point| point.is_about_forces() && point.row().has_cost)
}

/// The initialiser of `COST`.
pub(super) fn constant(cx: &Context<'_>) -> TokenStream {
    let (cost, has_forces) = (ty(cx), has_forces(cx.interface));
    let points = Analysis::all().map(Analysis::by_value);
    let points = points.filter(|point| point.row().has_cost);
    let fields = points.filter(|point| has_forces || !point.is_about_forces()).map(|point| {
        let cost = cx
            .interface
            .find(point)
            .map_or_else(Operations::default, |id| cx.lowered.costs[id.index()]);
        let (name, cost) = (generated(point.name()), record(&cx.paths, cost));
        quote!(#name: #cost)
    });
    let searches = cx.searches().then(|| searches(cx)).map(|searches| quote!(searches: #searches));
    let fields = fields.chain(searches);
    quote!(#cost { #(#fields),* })
}

/// The costs of the searches, as a list.
fn searches(cx: &Context<'_>) -> TokenStream {
    let cost_type = cx.paths.item("SearchCost");
    let costs = cx.mechanism.unknowns.iter().enumerate().filter_map(|(index, unknown)| {
        let search = cx.lowered.search(index)?;
        let (name, evaluation) =
            (cx.mechanism.title_of_unknown(unknown), record(&cx.paths, search.cost));
        let [wide, narrow] = MOST.map(Literal::u32_unsuffixed);
        Some(quote!(#cost_type {
            unknown: #name,
            evaluation: #evaluation,
            evaluations: #wide,
            evaluations_f32: #narrow
        }))
    });
    quote!(&[#(#costs),*])
}

fn record(paths: &Paths, cost: Operations) -> TokenStream {
    let name = paths.item("Operations");
    let [additions, multiplications, divisions, roots, sines] =
        [cost.additions, cost.multiplications, cost.divisions, cost.roots, cost.sines]
            .map(Literal::u32_unsuffixed);
    quote!(#name {
        additions: #additions,
        multiplications: #multiplications,
        divisions: #divisions,
        roots: #roots,
        sines: #sines
    })
}
