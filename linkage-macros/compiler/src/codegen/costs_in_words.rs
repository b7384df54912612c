//! `COST`, and what a solver costs in words.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::context::Context;
use super::identifiers::generated;
use super::token_list::Tokens;
use crate::interface::EntryId;
use crate::interface::entries::Analysis;
use crate::ir::cost::Operations;

/// The most evaluations between two ends, in double and in single precision, as the run-time crate
/// bounds them.
pub(super) const MOST: [u32; 2] = [61, 32];

/// The operations of an entry point.
pub(super) fn of(cx: &Context<'_>, entry: EntryId) -> Operations {
    cx.lowered.costs[entry.index()]
}

/// The type of `COST`.
pub(super) fn ty(cx: &Context<'_>) -> Tokens {
    cx.paths.item(match (cx.searches(), has_forces(cx)) {
        (true, true) => "SearchingForcesCost",
        (true, false) => "SearchingCost",
        (false, true) => "ForcesCost",
        (false, false) => "Cost",
    })
}

/// True if an entry point about forces has a cost.
fn has_forces(cx: &Context<'_>) -> bool {
    let mut points = cx.interface.entries.iter().map(|entry| entry.point);
    points.any(|point| point.is_about_forces() && point.row().has_cost)
}

/// The initialiser of `COST`.
pub(super) fn constant(cx: &Context<'_>) -> TokenStream {
    let (cost, has_forces) = (ty(cx), has_forces(cx));
    let points = Analysis::all().map(Analysis::by_value);
    let points = points.filter(|point| point.row().has_cost);
    let fields = points.filter(|point| has_forces || !point.is_about_forces()).map(|point| {
        let cost = cx.interface.find(point).map_or_else(Operations::default, |id| of(cx, id));
        let (name, cost) = (generated(point.name()), record(cx, cost));
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
        let (name, evaluation) = (cx.mechanism.title_of_unknown(unknown), record(cx, search.cost));
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

pub(super) fn record(cx: &Context<'_>, cost: Operations) -> TokenStream {
    let name = cx.paths.item("Operations");
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

/// `20 additions, 31 multiplications and 1 square root`; `no operation` where it is free.
pub(super) fn in_words(cost: Operations) -> String {
    let counts = [
        (cost.additions, "addition"),
        (cost.multiplications, "multiplication"),
        (cost.divisions, "division"),
        (cost.roots, "square root"),
        (cost.sines, "sine-cosine pair"),
    ];
    let words: Vec<String> = counts
        .iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, word)| match count {
            1 => format!("1 {word}"),
            _ => format!("{count} {word}s"),
        })
        .collect();
    match &words[..] {
        [] => "no operation".to_string(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn searches_take_as_many_evaluations_as_at_run_time() {
        use linkage_core::find::Search;
        assert_eq!(MOST, [Search::<f64>::MOST, Search::<f32>::MOST]);
    }

    #[test]
    fn a_cost_reads_as_a_sentence() {
        let none = Operations::default();
        assert_eq!(in_words(none), "no operation");
        assert_eq!(in_words(Operations { divisions: 1, ..none }), "1 division");
        let several = Operations { additions: 2, multiplications: 1, roots: 3, ..none };
        assert_eq!(in_words(several), "2 additions, 1 multiplication and 3 square roots");
    }
}
