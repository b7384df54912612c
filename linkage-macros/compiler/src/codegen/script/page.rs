//! The code for a page on which the mechanism is dragged: its script, its text, and what a reader may set.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::Attribute;

use crate::codegen::docs::words;
use crate::codegen::identifiers::text;
use crate::codegen::rust::context::Context;
use crate::codegen::rust::solver::held;
use crate::interface::force_records;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::lower::routine::Lowered;
use crate::model::mechanism::{Dimension, Mechanism, Param, ParamKind};

/// The page of a mechanism, and nothing where the run-time crate has no feature `page`. `cx` is the solver's in
/// `f64`, `source` the declaration's text.
pub(in crate::codegen) fn items(
    cx: &Context<'_>,
    solver: &Lowered<'_>,
    source: &str,
) -> TokenStream {
    let mechanism = cx.mechanism;
    let (name, float) = (&cx.names.solver, &cx.names.scalar);
    let [with_page, paged, declared, vec, page] =
        ["with_page", "Paged", "Declared", "Vec", "Page"].map(|name| cx.paths.item(name));
    let script = super::object(mechanism, solver, cx.lowered);
    let inputs = mechanism.inputs.iter();
    let inputs = inputs.map(|input| number(&input.name, in_si(input.dimension), &input.docs));
    let params = mechanism.params.iter().map(setting);
    let loads = mechanism.dynamics.loads.iter();
    let loads = loads.map(|load| number(&load.name, in_si(load.dimension), &load.docs));
    let [inputs, params, loads] = [inputs.collect(), params.collect(), loads.collect::<String>()];
    let outputs = shown(mechanism).join("\n");
    let values = mechanism.params.iter().map(|param| value(cx, param));
    quote! {
        #with_page! {
            impl #paged for #name<#float> {
                const PAGE: #declared =
                    #declared::new([#script, #source, #inputs, #params, #loads, #outputs]);

                fn params(&self) -> #vec<#float> {
                    #vec::from([#(#values),*])
                }
            }

            impl #name<#float> {
                /// A page on which the mechanism is dragged, with these parameters at first.
                #[must_use]
                pub fn page(&self) -> #page<Self> {
                    #page::of(self)
                }
            }
        }
    }
}

/// The names that curves may be asked of.
fn shown(mechanism: &Mechanism) -> Vec<String> {
    let outputs = mechanism.outputs.iter().map(|output| text(&output.field));
    outputs.chain(mechanism.dynamics.asked.iter().map(force_records::path)).collect()
}

/// The unit of a quantity that is given in SI.
fn in_si(dimension: Dimension) -> (String, f64) {
    (unit(dimension, Order::Position), 1.0)
}

/// A line of the run-time's settings.
fn number(name: &Ident, (unit, size): (String, f64), docs: &[Attribute]) -> String {
    format!("{}\t{unit}\t{size:?}\t{}\n", text(name), words(docs))
}

fn setting(param: &Param) -> String {
    match &param.kind {
        ParamKind::Number { dimension, written_in, .. } => {
            let written = written_in.as_ref().map(|(word, size)| (word.clone(), size.to_f64()));
            let unit = written.unwrap_or_else(|| in_si(*dimension));
            number(&param.name, unit, &param.docs)
        }
        ParamKind::Mode { of, .. } => {
            let [plus, minus] = of.words();
            format!("{}\t{plus}\t{minus}\t{}\n", text(&param.name), words(&param.docs))
        }
    }
}

/// The number that stands for a parameter's present value in the script.
fn value(cx: &Context<'_>, param: &Param) -> TokenStream {
    let (held, float) = (held(param), &cx.names.scalar);
    match param.kind {
        ParamKind::Number { .. } => held,
        ParamKind::Mode { of, .. } => {
            let ty = cx.paths.item(of.row().type_name);
            quote!(#ty::sign::<#float>(#held))
        }
    }
}
