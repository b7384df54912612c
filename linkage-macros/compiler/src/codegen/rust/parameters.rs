//! `Parameters`: the numeric parameters by name, and the same machine on other numbers.

use proc_macro2::TokenStream;
use quote::quote;

use super::context::{Context, numeric_params};
use super::solver;
use crate::codegen::identifiers::generated;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::model::mechanism::{Param, ParamKind};

/// The implementation; nothing for a mechanism without numeric parameters.
pub(super) fn implementation(cx: &Context<'_>) -> TokenStream {
    let params = numeric_params(cx.mechanism);
    if params.is_empty() {
        return TokenStream::new();
    }
    let (name, scalar, other) = (&cx.names.solver, &cx.names.scalar, &cx.names.lifted);
    let [trait_, any, float, string, fn_mut] =
        ["Parameters", "Scalar", "f64", "str", "FnMut"].map(|item| cx.paths.item(item));
    // One text: every token of generated code costs the compiler time.
    let units: Vec<String> = params.iter().map(|param| unit_of(param)).collect();
    let (units, number) = (units.join(" "), generated("number_"));
    let mapped = |param: &Param| {
        let held = solver::held(param);
        quote!(#number(#held))
    };
    let value = solver::construct(cx.mechanism, &cx.paths, &quote!(#name), mapped, solver::held);
    quote! {
        impl<#scalar: #any> #trait_ for #name<#scalar> {
            type Number = #scalar;
            type On<#other: #any> = #name<#other>;
            const NAMES: &'static [&'static #string] = &#name::<#float>::PARAMS;
            const UNITS: &'static #string = #units;
            #[inline]
            fn map<#other: #any>(&self, mut #number: impl #fn_mut(#scalar) -> #other) -> #name<#other> {
                #value
            }
        }
    }
}

fn unit_of(param: &Param) -> String {
    match &param.kind {
        ParamKind::Number { dimension, .. } => unit(*dimension, Order::Position),
        ParamKind::Mode { .. } => String::new(),
    }
}
