//! `Mechanism`: the solver for code that serves every mechanism, inputs and outputs as arrays.

use proc_macro2::TokenStream;
use quote::quote;

use super::context::Context;
use super::identifiers::{generated, text};

/// Nothing where not everything is offered that the trait asks for.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    let offered = ["position", "velocity", "motion", "coefficients"];
    if offered.iter().any(|name| cx.interface.find(name).is_none()) {
        return TokenStream::new();
    }
    let (solver, scalar, name) = (&cx.names.solver, &cx.names.scalar, text(&cx.names.solver));
    let (rows, columns) = (cx.rows(), cx.columns());
    let [trait_, real, str_, usize_, result, error, ok, from_fn, fn_mut] =
        ["Mechanism", "Real", "str", "usize", "Result", "SolveError", "Ok", "from_fn", "FnMut"]
            .map(|item| cx.paths.item(item));
    let float = cx.paths.item("f64");
    let [q, rate, acceleration, value, found] =
        ["q_", "rate_", "acceleration_", "value_", "result_"].map(generated);
    // One input is a number there, and several become a record by themselves.
    let given = |name| match cx.inputs() {
        None => quote!([#name]: Self::Inputs),
        Some(_) => quote!(#name: Self::Inputs),
    };
    let [inputs, rates, accelerations] = [&q, &rate, &acceleration].map(given);
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

            fn position(&self, #inputs) -> #result<Self::Rows, #error> {
                #ok(self.position(#q)?.rows())
            }

            fn velocity(&self, #inputs, #rates) -> #result<Self::Rows, #error> {
                #ok(self.velocity(#q, #rate)?.rows())
            }

            fn motion(
                &self,
                #inputs,
                #rates,
                #accelerations,
            ) -> #result<[Self::Rows; 3], #error> {
                let #found = self.motion(#q, #rate, #acceleration)?;
                #ok([#found.position.rows(), #found.velocity.rows(), #found.acceleration.rows()])
            }

            fn coefficients(&self, #inputs) -> #result<Self::Coefficients, #error> {
                self.coefficients(#q)
            }
        }
    }
}
