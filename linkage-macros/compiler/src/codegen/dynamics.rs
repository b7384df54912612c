//! `state_rates`: what integrators take, made of the second rates under forces.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::arguments::Arguments;
use super::context::Context;
use super::doc_comments::lines;
use super::identifiers::{generated, text};
use crate::interface::entries::Analysis;

/// Nothing where there is no forward dynamics.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    let forward = cx.interface.find(Analysis::ForwardDynamics.by_value());
    let Some(id) = forward else { return TokenStream::new() };
    let (solver, scalar) = (&cx.names.solver, &cx.names.scalar);
    let number = quote!(#scalar);
    let title = cx.entry(id).name();
    let forward = Ident::new(title, Span::call_site());
    let arguments = Arguments::new(cx, &cx.entry(id).given);
    // Values and rates are the state; drives and loads come as they do.
    let (own, declared) = (&arguments.names()[2..], arguments.declared(&number));
    let declared = &declared[2..];
    let count = cx.mechanism.inputs.len();
    let states = Literal::usize_unsuffixed(2 * count);
    let [real, result, error, ok] =
        ["Real", "Result", "SolveError", "Ok"].map(|i| cx.paths.item(i));
    let named = |letter: &str| (0..count).map(|i| generated(&format!("{letter}{i}_"))).collect();
    let [values, rates, seconds]: [Vec<_>; 3] = ["q", "v", "a"].map(named);
    let list = |names: &[Ident]| match names {
        [only] => quote!(#only),
        names => quote!([#(#names),*]),
    };
    let (q, v, a) = (list(&values), list(&rates), list(&seconds));
    let docs = lines(&format!(
        "The rates of a state, values and rates of the inputs: rates and second rates, what an \
         integrator takes.\n\n# Errors\nThose of `{title}`.",
    ));
    // A rate that moves no second rate is asked for nowhere else.
    let inputs = cx.mechanism.inputs.iter();
    let titles = inputs.map(|input| format!("{}_rate", text(&input.name)));
    quote! {
        impl<#scalar: #real> #solver<#scalar> {
            #docs
            #[inline]
            pub fn state_rates(
                &self,
                [#(#values,)* #(#rates),*]: [#scalar; #states],
                #(#declared),*
            ) -> #result<[#scalar; #states], #error> {
                let #a = self.#forward(#q, #v, #(#own),*)?;
                #(if !#scalar::is_finite(#rates) {
                    return #result::Err(#error::NotFinite { name: #titles });
                })*
                #ok([#(#rates,)* #(#seconds),*])
            }
        }
    }
}
