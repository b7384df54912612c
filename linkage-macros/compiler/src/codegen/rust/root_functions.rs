//! The functions that find roots.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::context::Context;
use super::in_rust::RustPrinter;
use super::paths::Paths;
use crate::codegen::docs::doc_comments;
use crate::codegen::identifiers::{generated, text};
use crate::codegen::text::Text;
use crate::ir::graph::{Target, Trend};
use crate::lower::TRIAL;
use crate::lower::routine::Apart;
use crate::lower::routine::Search;
use crate::model::mechanism::Mechanism;

/// One function a root: nothing but this is done again and again.
pub(in crate::codegen) fn functions(cx: &Context<'_>) -> TokenStream {
    cx.lowered.searches.iter().map(|search| function(cx, search)).collect()
}

fn function(cx: &Context<'_>, search: &Search) -> TokenStream {
    let (printer, scalar) = (RustPrinter::new(cx, &search.routine), &cx.names.scalar);
    let given = search.given.iter().map(|&id| printer.name(id));
    let count = Literal::usize_unsuffixed(search.given.len());
    let [result, error, option] = ["Result", "FindError", "Option"].map(|item| cx.paths.item(item));
    let finder = if search.checks_span_at_run_time { "root_within_a_turn" } else { "root" };
    let (find, trial) = (cx.paths.item(finder), generated(TRIAL));
    let trend = trend(cx.mechanism, &cx.paths, search.sought.trend);
    let between = search.sought.between.map(|end| printer.value_alone(end));
    let near = search.sought.near.map(|near| printer.value_alone(near));
    let near = near.map_or(quote!(#option::None), |near| quote!(#option::Some(#near)));
    let mut lines = Text::default();
    let stages = search.routine.stages.iter();
    stages.for_each(|stage| printer.statements(&stage.statements, &mut lines));
    lines.put("[").list(search.sought.sides, |to, side| printer.value(side, to)).put("]");
    let given: Vec<_> = given.collect();
    let (real, plain) = (cx.paths.item("Real"), generated("plain_"));
    let (name, docs) = (generated(&search.routine.name), docs(cx.mechanism, search));
    if let Target::End(end) = search.sought.wanted {
        let (bound, end) = (cx.paths.item("bound"), Literal::u8_unsuffixed(end));
        return quote! {
            #docs
            fn #name(&self, [#(#given),*]: [#scalar; #count]) -> (#scalar, #scalar) {
                #bound([#(#between),*], #trend, #end, |#trial: #scalar| {
                    #lines
                })
            }
        };
    }
    // By the root before or by a declared seed.
    let (received, passed, find, begins) = match search.apart {
        Some(apart) => {
            let [seed, by_seed] = ["Seed", "root_by_seed"].map(|item| cx.paths.item(item));
            let (side, name) = (apart_of(&cx.paths, &printer, search, apart), generated("seed_"));
            let received = quote!(, #name: #option<&mut #seed<#scalar>>,);
            (received, quote!(, #option::None), by_seed, quote!(#name, #side))
        }
        None => (TokenStream::new(), TokenStream::new(), find, near),
    };
    quote! {
        #docs
        fn #name(
            &self,
            [#(#given),*]: [#scalar; #count] #received
        ) -> #result<[#scalar; 2], #error> {
            let #plain = || {
                self.lift::<<#scalar as #real>::Plain>()
                    .#name([#(#real::plain_value(#given)),*] #passed)
            };
            #find([#(#between),*], #trend, #begins, #plain, |#trial: #scalar| {
                #lines
            })
        }
    }
}

/// The side that no trial changes, as the search is given it.
fn apart_of(
    paths: &Paths,
    printer: &RustPrinter<'_>,
    search: &Search,
    apart: Apart,
) -> TokenStream {
    let Apart { given, has_one_root } = apart;
    let (ty, is_right) = (paths.item("Apart"), given == 1);
    let given = printer.value_alone(search.sought.sides[given]);
    quote!(#ty { given: #given, is_right: #is_right, has_one_root: #has_one_root })
}

fn docs(mechanism: &Mechanism, search: &Search) -> TokenStream {
    let name = text(&mechanism.unknowns[search.sought.unknown as usize].name);
    doc_comments::lines(&match search.sought.wanted {
        Target::Root => format!(
            "Where `{name}` solves its equation, and the size that its rounding is measured by."
        ),
        Target::End(end) => format!(
            "The {} end of where `{name}` can solve its equation, and one at a dead point.",
            if end == 0 { "lower" } else { "upper" }
        ),
    })
}

/// The sign of the slope at the root.
fn trend(mechanism: &Mechanism, paths: &Paths, trend: Trend) -> TokenStream {
    let ty = paths.item("Trend");
    match trend {
        Trend::Rising => quote!(#ty::Rising),
        Trend::Falling => quote!(#ty::Falling),
        Trend::Param(param) => {
            let field = &mechanism.params[param as usize].name;
            quote!(self.#field)
        }
    }
}
