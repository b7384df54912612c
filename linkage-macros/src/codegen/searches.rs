//! The functions that find roots, and what a search costs.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::context::Context;
use super::costs_in_words::{self, MOST};
use super::doc_comments;
use super::identifiers::{function_name, generated, text};
use super::statements::Printer;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::lower::TRIAL;
use crate::lower::routine::Search;
use crate::model::mechanism::{Expr, Sign, Unknown};

/// One function a root: nothing but this is done again and again.
pub(super) fn functions(cx: &Context<'_>) -> TokenStream {
    cx.lowered.searches.iter().map(|search| function(cx, search)).collect()
}

fn function(cx: &Context<'_>, search: &Search) -> TokenStream {
    let (printer, scalar) = (Printer::new(cx, &search.routine), &cx.names.scalar);
    let given = search.given.iter().map(|&id| printer.name(id));
    let count = Literal::usize_unsuffixed(search.given.len());
    let [result, error, option, trend] =
        ["Result", "FindError", "Option", "Trend"].map(|item| cx.paths.item(item));
    let (find, trial) = (cx.paths.item("root"), generated(TRIAL));
    let mode = if search.sought.rises { quote!(Rising) } else { quote!(Falling) };
    let between = search.sought.between.map(|end| printer.value(end));
    let near = search.sought.near.map(|near| printer.value(near));
    let near = match near {
        Some(near) => quote!(#option::Some(#near)),
        None => quote!(#option::None),
    };
    let lines = search.routine.stages.iter().map(|stage| printer.statements(&stage.statements));
    let sides = search.sought.sides.map(|side| printer.value(side));
    let (name, docs) = (function_name(&search.routine.name), docs(cx, search));
    quote! {
        #docs
        fn #name(&self, [#(#given),*]: [#scalar; #count]) -> #result<[#scalar; 2], #error> {
            #find([#(#between),*], #trend::#mode, #near, |#trial: #scalar| {
                #(#lines)*
                [#(#sides),*]
            })
        }
    }
}

fn docs(cx: &Context<'_>, search: &Search) -> TokenStream {
    let unknown = &cx.mechanism.unknowns[search.sought.unknown as usize];
    doc_comments::lines(&format!(
        "Where `{}` solves its equation, and the size that its rounding is measured by.",
        text(&unknown.name)
    ))
}

/// What the page of the solver says of each unknown.
pub(super) fn in_words(cx: &Context<'_>) -> Vec<String> {
    let unknowns = cx.mechanism.unknowns.iter().enumerate();
    unknowns.filter_map(|(index, unknown)| of_unknown(cx, index, unknown)).collect()
}

fn of_unknown(cx: &Context<'_>, index: usize, unknown: &Unknown) -> Option<String> {
    let search = cx.search(index)?;
    let mode = if unknown.mode == Sign::Plus { "rising" } else { "falling" };
    let [wide, narrow] = MOST;
    let seed = match unknown.near {
        Some(_) => ", three more for the seed",
        None => "",
    };
    Some(format!(
        "`{}`{}, {mode}: up to {wide} evaluations (f32: {narrow}){seed}, twice as many where an end \
         lies beyond a dead point of the equation; each of {}",
        text(&unknown.name),
        ends(unknown),
        costs_in_words::in_words(search.cost),
    ))
}

/// Where it is looked for, where that is constant.
fn ends(unknown: &Unknown) -> String {
    let unit = unit(unknown.dimension, Order::Position);
    match &unknown.between {
        [Expr::Constant(from), Expr::Constant(to)] => {
            format!(" from {:.6} to {:.6} {unit}", from.to_f64(), to.to_f64())
        }
        _ => format!(" in {unit}"),
    }
}
