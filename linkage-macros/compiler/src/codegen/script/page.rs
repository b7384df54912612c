//! The code for a page on which the mechanism is dragged: its script, its text, and what a reader may set.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::Attribute;

use super::plan_object;
use crate::codegen::docs::words;
use crate::codegen::identifiers::text;
use crate::codegen::rust::context::Context;
use crate::codegen::rust::solver::held;
use crate::diagnostics::Diagnostic;
use crate::interface::force_records;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::lower::routine::Lowered;
use crate::model::mechanism::{Dimension, Mechanism, Param, ParamKind};

/// A mechanism as its page has it, in texts.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct PageParts {
    /// The mechanism's name.
    pub name: String,
    /// Its doc comment, in one line.
    pub docs: String,
    /// An object of JavaScript: the names of all parts, and the statements that place them.
    pub plan: String,
    /// An object of JavaScript, the formulas among its fields.
    pub script: String,
    /// The inputs, a line each: a name, a unit, its size in SI, what the declaration says of it, and its value in the
    /// drawing, with tabs between.
    pub inputs: String,
    /// The parameters; of a mode two words in place of unit and size.
    pub params: String,
    /// The loads.
    pub loads: String,
    /// The names that curves may be asked of, outputs and forces, a line each.
    pub outputs: String,
    /// The parameters' defaults; of a mode +1 or −1.
    pub values: Vec<f64>,
    /// The remarks on the declaration, in the order of the source.
    pub notes: Vec<Diagnostic>,
}

impl PageParts {
    /// Those of a mechanism, from its solver's routines and those that place what is drawn: bodies, and what stands
    /// beside them.
    pub(crate) fn of(
        mechanism: &Mechanism,
        solver: &Lowered<'_>,
        drawing: (&Lowered<'_>, Option<&Lowered<'_>>),
    ) -> Self {
        let inputs = mechanism.inputs.iter().enumerate().map(|(nth, input)| {
            let line = number(&input.name, in_si(input.dimension), &input.docs);
            match &mechanism.drawn {
                Some(drawn) => format!("{}\t{:?}\n", line.trim_end_matches('\n'), drawn[nth]),
                None => line,
            }
        });
        let params = mechanism.params.iter().map(setting);
        let loads = mechanism.dynamics.loads.iter();
        let loads = loads.map(|load| number(&load.name, in_si(load.dimension), &load.docs));
        Self {
            name: text(&mechanism.name),
            docs: words(&mechanism.docs),
            plan: plan_object::object(mechanism),
            script: super::object(mechanism, solver, drawing),
            inputs: inputs.collect(),
            params: params.collect(),
            loads: loads.collect(),
            outputs: shown(mechanism).join("\n"),
            values: mechanism.params.iter().map(Param::default_value).collect(),
            notes: Vec::new(),
        }
    }
}

/// The page of a mechanism, and nothing where the run-time crate has no feature `page`. `cx` is the solver's in
/// `f64`, `source` the declaration's text.
pub(in crate::codegen) fn items(
    cx: &Context<'_>,
    solver: &Lowered<'_>,
    (marks, source): (Option<&Lowered<'_>>, &str),
) -> TokenStream {
    let mechanism = cx.mechanism;
    let (name, float) = (&cx.names.solver, &cx.names.scalar);
    let [with_page, paged, declared, vec, page] =
        ["with_page", "Paged", "Declared", "Vec", "Page"].map(|name| cx.paths.item(name));
    let PageParts { plan, script, inputs, params, loads, outputs, .. } =
        PageParts::of(mechanism, solver, (cx.lowered, marks));
    let values = mechanism.params.iter().map(|param| value(cx, param));
    quote! {
        #with_page! {
            impl #paged for #name<#float> {
                const PAGE: #declared<'static> =
                    #declared::new([#plan, #script, #source, #inputs, #params, #loads, #outputs]);

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
