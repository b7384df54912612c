//! `COST`: the operations of every entry point, and of a trial of every search.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::context::Context;
use crate::codegen::docs::costs_in_words::MOST;
use crate::interface::Interface;
use crate::interface::entries::Analysis;
use crate::ir::cost::Operations;

/// True if an entry point about forces has a cost.
fn has_forces(interface: &Interface) -> bool {
    let mut points = interface.entries.iter().map(|entry| entry.point);
    points.any(|point| point.is_about_forces() && point.row().has_cost)
}

/// The initialiser of `COST`. What has no forces leaves their entry points out: each token costs a user's compiler.
pub(super) fn constant(cx: &Context<'_>) -> TokenStream {
    let has_forces = has_forces(cx.interface);
    let points = Analysis::all().map(Analysis::by_value);
    let points = points.filter(|point| point.row().has_cost);
    let points = points.filter(|point| has_forces || !point.is_about_forces()).map(|point| {
        let id = cx.interface.find(point);
        counts(id.map_or_else(Operations::default, |id| cx.lowered.costs[id.index()]))
    });
    let (cost, searches) = (cx.paths.item("cost"), searches(cx));
    quote!(#cost(&[#(#points),*], &[#(#searches),*]))
}

/// The costs of the searches.
fn searches(cx: &Context<'_>) -> Vec<TokenStream> {
    let search_cost = cx.paths.item("search_cost");
    let costs = cx.mechanism.unknowns.iter().enumerate().filter_map(|(index, unknown)| {
        let search = cx.lowered.search(index)?;
        let (name, evaluation) = (cx.mechanism.title_of_unknown(unknown), counts(search.cost));
        let most = MOST.map(Literal::u32_unsuffixed);
        Some(quote!(#search_cost(#name, #evaluation, [#(#most),*])))
    });
    costs.collect()
}

/// The numbers of an entry point, in the order in which the run-time crate takes them.
fn counts(cost: Operations) -> TokenStream {
    let Operations { additions, multiplications, divisions, roots, sines } = cost;
    let counts = [additions, multiplications, divisions, roots, sines].map(Literal::u32_unsuffixed);
    quote!([#(#counts),*])
}
