//! `Mechanism`: the solver for code that serves every mechanism, inputs and outputs as arrays.

use proc_macro2::TokenStream;
use quote::quote;

use super::context::Context;
use super::identifiers::{generated, text};
use super::results;

/// Nothing where not everything is offered that the trait asks for.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    let offered = ["position", "velocity", "motion", "coefficients"];
    if offered.iter().any(|name| cx.interface.find(name).is_none()) {
        return TokenStream::new();
    }
    let (solver, scalar, name) = (&cx.names.solver, &cx.names.scalar, text(&cx.names.solver));
    let (rows, columns) = (cx.rows(), cx.columns());
    let [trait_, real, str_, usize_, result, error, from_fn, fn_mut] =
        ["Mechanism", "Real", "str", "usize", "Result", "SolveError", "from_fn", "FnMut"]
            .map(|item| cx.paths.item(item));
    let float = cx.paths.item("f64");
    let [q, rate, acceleration, value] = ["q_", "rate_", "acceleration_", "value_"].map(generated);
    // One input is a number there, and several become a record by themselves.
    let given = |name| match cx.inputs() {
        None => quote!([#name]: Self::Inputs),
        Some(_) => quote!(#name: Self::Inputs),
    };
    let [inputs, rates, accelerations] = [&q, &rate, &acceleration].map(given);
    let [position, velocity] = [quote!(self.position(#q)), quote!(self.velocity(#q, #rate))]
        .map(|answer| results::in_place(cx, &answer, |found| quote!(#found.rows())));
    let motion = quote!(self.motion(#q, #rate, #acceleration));
    let motion = results::in_place(
        cx,
        &motion,
        |found| quote!([#found.position.rows(), #found.velocity.rows(), #found.acceleration.rows()]),
    );
    quote! {
        impl<#scalar: #real> #trait_ for #solver<#scalar> {
            type Scalar = #scalar;
            type Inputs = [#scalar; #columns];
            type Rows = [#scalar; #rows];
            type Coefficients = [[#scalar; #columns]; #rows];

            const NAME: &'static #str_ = #name;
            const INPUTS: &'static [&'static #str_] = &#solver::<#float>::INPUTS;
            const OUTPUTS: &'static [&'static #str_] = &#solver::<#float>::OUTPUTS;

            fn inputs(#value: impl #fn_mut(#usize_) -> #scalar) -> Self::Inputs { #from_fn(#value) }

            fn position(&self, #inputs) -> #result<Self::Rows, #error> { #position }

            fn velocity(&self, #inputs, #rates) -> #result<Self::Rows, #error> { #velocity }

            fn motion(
                &self,
                #inputs,
                #rates,
                #accelerations,
            ) -> #result<[Self::Rows; 3], #error> {
                #motion
            }

            fn coefficients(&self, #inputs) -> #result<Self::Coefficients, #error> {
                self.coefficients(#q)
            }
        }
    }
}
