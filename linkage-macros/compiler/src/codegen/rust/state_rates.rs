//! `state_rates`: what integrators take, made of the accelerations under forces; and `mixed_dynamics`, of which
//! some accelerations are prescribed. Both are made of other entry points, and no formula is printed for them.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::context::Context;
use crate::codegen::arguments::clear_of;
use crate::codegen::docs::doc_comments::lines;
use crate::codegen::identifiers::{generated, text};
use crate::interface::entries::Analysis;
use crate::model::mechanism::Mechanism;

/// Nothing where there is no forward dynamics.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    let (state_rates, mixed) = (state_rates(cx), mixed(cx));
    quote!(#state_rates #mixed)
}

/// The names of the numbers of a state: values, rates and accelerations of the inputs.
fn state(mechanism: &Mechanism) -> [Vec<Ident>; 3] {
    let count = mechanism.inputs.len();
    let named = |letter: &str| (0..count).map(|i| generated(&format!("{letter}{i}_"))).collect();
    ["q", "v", "a"].map(named)
}

/// Refuses rates that are not finite: one that moves no acceleration is asked for nowhere else.
fn rates_are_finite(cx: &Context<'_>, rates: &[Ident]) -> TokenStream {
    let scalar = &cx.names.scalar;
    let [result, error] = ["Result", "SolveError"].map(|item| cx.paths.item(item));
    let inputs = &cx.mechanism.inputs;
    let titles = inputs.iter().map(|input| format!("{}_rate", text(&input.name)));
    quote! {
        #(if !#scalar::is_finite(#rates) {
            return #result::Err(#error::NotFinite { name: #titles });
        })*
    }
}

fn state_rates(cx: &Context<'_>) -> TokenStream {
    let forward = cx.interface.find(Analysis::ForwardDynamics.by_value());
    let Some(id) = forward else { return TokenStream::new() };
    let (solver, scalar) = (&cx.names.solver, &cx.names.scalar);
    let number = quote!(#scalar);
    let title = cx.entry(id).name();
    let forward = Ident::new(title, Span::call_site());
    let arguments = cx.signatures.arguments(&cx.entry(id).given);
    // Values and rates are the state; drives and loads come as they do.
    let (own, declared) = (&arguments.names()[2..], arguments.declared(&cx.paths, &number));
    let declared = &declared[2..];
    let count = cx.mechanism.inputs.len();
    let states = Literal::usize_unsuffixed(2 * count);
    let [real, result, error, ok] =
        ["Real", "Result", "SolveError", "Ok"].map(|i| cx.paths.item(i));
    let [values, rates, seconds] = state(cx.mechanism);
    let list = |names: &[Ident]| match names {
        [only] => quote!(#only),
        names => quote!([#(#names),*]),
    };
    let (q, v, a) = (list(&values), list(&rates), list(&seconds));
    let docs = lines(&format!(
        "The rates of a state, values and rates of the inputs: rates and accelerations, what an \
         integrator takes.\n\n# Errors\nThose of `{title}`.",
    ));
    let rates_are_finite = rates_are_finite(cx, &rates);
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
                #rates_are_finite
                #ok([#(#rates,)* #(#seconds),*])
            }
        }
    }
}

/// The functions of a motion that is prescribed in part, of several inputs alone: of one, `forces` and `forward_dynamics` are
/// both of them.
fn mixed(cx: &Context<'_>) -> TokenStream {
    let equations = cx.interface.find(Analysis::EquationsOfMotion.by_value());
    let (Some(id), Some(_)) = (equations, cx.interface.input_record()) else {
        return TokenStream::new();
    };
    let (solver, scalar) = (&cx.names.solver, &cx.names.scalar);
    let number = quote!(#scalar);
    let arguments = cx.signatures.arguments(&cx.entry(id).given);
    let (names, declared) = (arguments.names(), arguments.declared(&cx.paths, &number));
    let prescribed = clear_of(names, Ident::new("given", Span::call_site()));
    let (own, own_declared) = (&names[2..], &declared[2..]);
    let (declared, equations) =
        (&declared[..2], Ident::new(cx.entry(id).name(), Span::call_site()));
    let count = cx.columns();
    let states = Literal::usize_unsuffixed(2 * cx.mechanism.inputs.len());
    let [real, result, error, ok, given, mixed, solve, float] =
        ["Real", "Result", "SolveError", "Ok", "Given", "Mixed", "mixed_dynamics", "f64"]
            .map(|item| cx.paths.item(item));
    let [values, rates, _] = state(cx.mechanism);
    let rates_are_finite = rates_are_finite(cx, &rates);
    let [found, accelerations] = ["found_", "accelerations_"].map(generated);
    let seconds = (0..values.len()).map(Literal::usize_unsuffixed);
    let [docs, docs_of_rates] = docs_of_mixed();
    quote! {
        impl<#scalar: #real> #solver<#scalar> {
            #docs
            pub fn mixed_dynamics(
                &self,
                #(#declared,)*
                #prescribed: [#given<#scalar>; #count],
                #(#own_declared),*
            ) -> #result<#mixed<#scalar, #count>, #error> {
                let #found = self.#equations(#(#names),*)?;
                #solve(#found.mass, #found.force, #prescribed, #solver::<#float>::INPUTS)
            }

            #docs_of_rates
            #[inline]
            pub fn state_rates_given(
                &self,
                [#(#values,)* #(#rates),*]: [#scalar; #states],
                #prescribed: [#given<#scalar>; #count],
                #(#own_declared),*
            ) -> #result<[#scalar; #states], #error> {
                let #accelerations =
                    self.mixed_dynamics([#(#values),*], [#(#rates),*], #prescribed, #(#own),*)?.accelerations;
                #rates_are_finite
                #ok([#(#rates,)* #(#accelerations[#seconds]),*])
            }
        }
    }
}

fn docs_of_mixed() -> [TokenStream; 2] {
    [
        "Accelerations and drives of all inputs, of each of which one is given.\n\nThe given numbers are an \
         array in the order of `INPUTS`, the others follow from `equations_of_motion`.\n\n# Errors\nThose of \
         `equations_of_motion`. `Singular` names an input that is given its drive and moves no mass of its own; \
         `NotFinite` an input whose acceleration or drive is not finite.",
        "The rates of a state, where the caller writes values and rates of prescribed inputs from their functions of time: \
         `state_rates` by `mixed_dynamics`.\n\n# Errors\nThose of `mixed_dynamics`.",
    ]
    .map(lines)
}
