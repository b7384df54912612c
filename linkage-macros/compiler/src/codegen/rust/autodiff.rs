//! Jacobians and sensitivities: the coefficients as a matrix, and the position solver on dual numbers.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::context::{Context, numeric_params};
use super::{results, solver};
use crate::codegen::docs;
use crate::codegen::identifiers::{generated, used};
use crate::interface::entries::{Analysis, ArgumentKind};
use crate::model::mechanism::Param;

/// For `f32` and `f64`, and only where the run-time crate has its feature `ad`.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    if !cx.interface.has(Analysis::Position) {
        return TokenStream::new();
    }
    let (with_ad, name, number) = (cx.paths.item("with_ad"), &cx.names.solver, &cx.names.scalar);
    let differentiable = cx.paths.item("Differentiable");
    let (jacobian, sensitivity) = (jacobian(cx), sensitivity(cx));
    quote! {
        #with_ad! {
            impl<#number: #differentiable> #name<#number> { #jacobian #sensitivity }
        }
    }
}

fn jacobian(cx: &Context<'_>) -> TokenStream {
    let arguments = cx.signatures.arguments(&[ArgumentKind::Value]);
    let number = &cx.names.scalar;
    let number = quote!(#number);
    let (declared, converted) =
        (arguments.declared(&cx.paths, &number), arguments.converted(&cx.paths, &number));
    let names = arguments.names();
    let (rows, columns, docs) = (cx.rows(), cx.columns(), docs::jacobian(cx.mechanism));
    let [matrix, error, result] =
        ["SMatrix", "SolveError", "Result"].map(|name| cx.paths.item(name));
    let of_lifted = cx.paths.item("jacobian");
    let values = match &cx.mechanism.inputs[..] {
        [_] => quote!([#(#names),*]),
        inputs => {
            let fields = inputs.iter().map(|input| used(&input.name));
            let record = names.first();
            quote!([#(#record.#fields),*])
        }
    };
    quote! {
        #docs
        pub fn jacobian(&self, #(#declared),*) -> #result<#matrix<#number, #rows, #columns>, #error> {
            #converted
            #of_lifted(self.coefficients(#(#names),*), #values, || self.lift())
        }
    }
}

/// With respect to the numeric parameters; none, none.
fn sensitivity(cx: &Context<'_>) -> Option<TokenStream> {
    let params = numeric_params(cx.mechanism);
    if params.is_empty() {
        return None;
    }
    let arguments = cx.signatures.arguments(&[ArgumentKind::Value]);
    let number = &cx.names.scalar;
    let number = quote!(#number);
    let (declared, converted) =
        (arguments.declared(&cx.paths, &number), arguments.converted(&cx.paths, &number));
    let (rows, docs) = (cx.rows(), docs::sensitivity(cx.mechanism, &params));
    let columns = Literal::usize_unsuffixed(params.len());
    let [matrix, error, result] =
        ["SMatrix", "SolveError", "Result"].map(|name| cx.paths.item(name));
    let differentiate = cx.paths.item("differentiate");
    let fields: Vec<_> = params.iter().map(|param| used(&param.name)).collect();
    let duals: Vec<_> = (0..fields.len()).map(|i| generated(&format!("p{i}_"))).collect();
    let (name, at) = (&cx.names.solver, constant_inputs(cx));
    let dual = |param: &Param| {
        let index = fields.iter().position(|field| *field == param.name);
        let dual = index.map(|index| &duals[index]);
        quote!(#dual)
    };
    let solver = solver::construct(cx.mechanism, &cx.paths, &quote!(#name), dual, solver::held);
    let answer = quote!((#solver).position(#at));
    let of_duals = results::in_place(&cx.paths, &answer, |found| quote!(#found.rows()));
    Some(quote! {
        #docs
        pub fn sensitivity(&self, #(#declared),*) -> #result<#matrix<#number, #rows, #columns>, #error> {
            #converted
            #differentiate([#(self.#fields),*], |[#(#duals),*]| #of_duals)
        }
    })
}

/// The inputs as numbers without derivatives.
fn constant_inputs(cx: &Context<'_>) -> TokenStream {
    let arguments = cx.signatures.arguments(&[ArgumentKind::Value]);
    let lifted = |value: TokenStream| solver::lifted_number(&cx.paths, &value, &quote!(_));
    let inputs = arguments.names().iter().flat_map(|argument| {
        cx.mechanism.inputs.iter().map(move |input| (argument, used(&input.name)))
    });
    let Some(record) = cx.interface.input_record() else {
        return inputs.map(|(argument, _)| lifted(quote!(#argument))).collect();
    };
    let fields = inputs.map(|(argument, field)| {
        let value = lifted(quote!(#argument.#field));
        quote!(#field: #value)
    });
    quote!(#record { #(#fields),* })
}
