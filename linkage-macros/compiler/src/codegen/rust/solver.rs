//! The struct that stands for the mechanism: its parameters, defaults and constants.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::context::{Context, literal, numeric_params};
use super::paths::Paths;
use super::token_list::Tokens;
use super::{cost_constant, module, structs};
use crate::codegen::identifiers::{generated, text};
use crate::codegen::{docs, identifiers};
use crate::interface::{force_records, labels};
use crate::model::mechanism::{DeclaredOutput, Mechanism, Param, ParamKind, Sign};
use crate::syntax::anatomy::Modes;

/// The implementations that need no solving: constants, `Default` and `lift`.
pub(super) fn implementation(cx: &Context<'_>) -> TokenStream {
    let (constants, default, lift) = (constants(cx), default(cx), lift(cx));
    quote!(#constants #default #lift)
}

/// The struct itself.
pub(super) fn definition(cx: &Context<'_>) -> TokenStream {
    let (scalar, visibility) = (&cx.names.scalar, module::visibility_inside(cx.mechanism));
    let (docs, attributes) =
        (docs::solver(cx.mechanism, cx.lowered), structs::attributes(cx.mechanism, &cx.paths));
    let declared = &cx.mechanism.name;
    let (fields, float) = (fields(cx.mechanism, &cx.paths, scalar), cx.paths.outside("f64"));
    quote! {
        #docs
        #attributes
        #visibility struct #declared<#scalar = #float> { #fields }
    }
}

/// A field for each parameter.
pub(super) fn fields(mechanism: &Mechanism, paths: &Paths, scalar: &Ident) -> TokenStream {
    let fields = mechanism.params.iter().map(|param| {
        let (docs, field) = (docs::param(mechanism, param), &param.name);
        let ty = match mode_type(param) {
            Some(ty) => paths.outside(ty),
            None => scalar.clone().into(),
        };
        quote!(#docs pub #field: #ty,)
    });
    let phantom = paths.outside("PhantomData");
    let marker = marker(mechanism, paths)
        .map(|(field, _)| quote!(#[doc(hidden)] pub #field: #phantom<#scalar>,));
    quote!(#(#fields)* #marker)
}

/// The type of a mode parameter; none for a number's, which is the type parameter.
fn mode_type(param: &Param) -> Option<&'static str> {
    match param.kind {
        ParamKind::Number { .. } => None,
        ParamKind::Mode { of, .. } => Some(of.row().type_name),
    }
}

/// Without a numeric parameter nothing holds the type parameter: the field that does, by its name
/// and its value, whose type has the value's name. The field is public, so that `..Solver::new()`
/// stays usable, and its name says what to write in place of `Solver {}`.
pub(super) fn marker(mechanism: &Mechanism, paths: &Paths) -> Option<(Ident, Tokens)> {
    let taken = |name: &str| mechanism.params.iter().any(|param| param.name == name);
    let mut name = String::from("use_new_");
    while taken(&name) {
        name.push('_');
    }
    let phantom = paths.item("PhantomData");
    numeric_params(mechanism).is_empty().then(|| (generated(&name), phantom))
}

/// A parameter as the solver holds it.
pub(in crate::codegen) fn held(param: &Param) -> TokenStream {
    let field = identifiers::used(&param.name);
    quote!(self.#field)
}

/// `Self { … }` with every field given by the expression made for its parameter.
pub(super) fn construct(
    mechanism: &Mechanism,
    paths: &Paths,
    name: &TokenStream,
    number: impl Fn(&Param) -> TokenStream,
    mode: impl Fn(&Param) -> TokenStream,
) -> TokenStream {
    let fields = mechanism.params.iter().map(|param| {
        let field = identifiers::used(&param.name);
        let value = match param.kind {
            ParamKind::Number { .. } => number(param),
            _ => mode(param),
        };
        quote!(#field: #value,)
    });
    let marker = marker(mechanism, paths).map(|(field, value)| quote!(#field: #value));
    quote!(#name { #(#fields)* #marker })
}

/// The parameter as declared, a number by `lit` or as a plain literal.
pub(super) fn defaults(
    mechanism: &Mechanism,
    paths: &Paths,
    name: &TokenStream,
    number: impl Fn(f64, f32) -> Tokens,
) -> TokenStream {
    let number = |param: &Param| match &param.kind {
        ParamKind::Number { default, .. } => {
            number(default.to_f64(), default.to_f32()).into_token_stream()
        }
        _ => TokenStream::new(),
    };
    let mode = |param: &Param| {
        let ty = mode_type(param).map(|ty| paths.item(ty));
        let variant = default_variant(param);
        quote!(#ty::#variant)
    };
    construct(mechanism, paths, name, number, mode)
}

fn default_variant(param: &Param) -> TokenStream {
    let ParamKind::Mode { of, default } = param.kind else { return TokenStream::new() };
    let [plus, minus] = of.words();
    let word = if default == Sign::Plus { plus } else { minus };
    format_ident!("{}", Modes::variant(word)).into_token_stream()
}

/// The constants and `new`, in an implementation that is named without a type parameter.
fn constants(cx: &Context<'_>) -> TokenStream {
    let (name, scalar) = (&cx.names.solver, &cx.names.scalar);
    let new = defaults(cx.mechanism, &cx.paths, &quote!(#name), |wide, _| literal(wide));
    let (outputs, rows) = (output_rows(cx.mechanism), cx.rows());
    let inputs = cx.mechanism.inputs.iter().map(|input| &input.name);
    let inputs = inputs.map(|name| identifiers::string(&text(name), name.span()));
    let params = numeric_params(cx.mechanism);
    let params: Vec<_> =
        params.iter().map(|p| identifiers::string(&text(&p.name), p.name.span())).collect();
    let (columns, numbers) = (cx.columns(), Literal::usize_unsuffixed(params.len()));
    let (cost_type, cost) = (cx.paths.item("Cost"), cost_constant::constant(cx));
    let (forces, cost_docs, drawn) =
        (force_rows(cx.mechanism), docs::cost(cx.mechanism.is_stub), drawn(cx));
    let [float, string, same_as] = ["f64", "str", "SameAs"].map(|name| cx.paths.item(name));
    quote! {
        impl #name<#float> {
            /// The scalar rows of the results, in the order of every list of rows.
            pub const OUTPUTS: [&'static #string; #rows] = [#(#outputs),*];
            /// The inputs, in the order of the columns of Jacobians.
            pub const INPUTS: [&'static #string; #columns] = [#(#inputs),*];
            /// The numeric parameters, in the order of the columns of sensitivities.
            pub const PARAMS: [&'static #string; #numbers] = [#(#params),*];
            #drawn
            #forces
            #cost_docs
            pub const COST: #cost_type = #cost;

        }

        impl<#scalar> #name<#scalar> {
            /// The solver with all parameters at their declared values, in `f64`.
            #[inline]
            #[must_use]
            pub const fn new() -> #name<#float> where #float: #same_as<#scalar> { #new }
        }
    }
}

/// The inputs of the pose in which the mechanism is drawn; nothing where it is not.
fn drawn(cx: &Context<'_>) -> TokenStream {
    let Some(values) = &cx.mechanism.drawn else { return TokenStream::new() };
    let float = cx.paths.item("f64");
    let (values, columns) =
        (values.iter().map(|&value| Literal::f64_unsuffixed(value)), cx.columns());
    quote! {
        /// The inputs of the pose in which the mechanism is drawn, in metres and radians.
        pub const DRAWN: [#float; #columns] = [#(#values),*];
    }
}

/// The rows of forces, and the loads; nothing where nothing is asked about forces.
fn force_rows(mechanism: &Mechanism) -> TokenStream {
    let dynamics = &mechanism.dynamics;
    if dynamics.asked.is_empty() {
        return TokenStream::new();
    }
    let rows: Vec<_> = (dynamics.asked.iter())
        .flat_map(|asked| {
            force_records::rows(asked).into_iter().map(|row| (row, asked.field.span()))
        })
        .map(|(row, span)| identifiers::string(&row, span))
        .collect();
    let loads: Vec<_> = (dynamics.loads.iter())
        .map(|load| identifiers::string(&text(&load.name), load.name.span()))
        .collect();
    let [rows_count, loads_count] = [rows.len(), loads.len()].map(Literal::usize_unsuffixed);
    quote! {
        /// The numbers of `forces` and `statics`, in the order of their fields.
        pub const FORCES: [&'static str; #rows_count] = [#(#rows),*];
        /// The loads, in the order in which they are given.
        pub const LOADS: [&'static str; #loads_count] = [#(#loads),*];
    }
}

/// All rows of the outputs.
fn output_rows(mechanism: &Mechanism) -> Vec<TokenStream> {
    let rows = |output: &DeclaredOutput| {
        let rows = labels::rows(mechanism, output).into_iter();
        rows.map(|row| identifiers::string(&row, output.field.span())).collect::<Vec<_>>()
    };
    mechanism.outputs.iter().flat_map(rows).collect()
}

fn default(cx: &Context<'_>) -> TokenStream {
    let (name, scalar) = (&cx.names.solver, &cx.names.scalar);
    let (default, any) = (cx.paths.item("Default"), cx.paths.item("Scalar"));
    let value =
        defaults(cx.mechanism, &cx.paths, &quote!(Self), |wide, narrow| cx.literal(wide, narrow));
    quote! {
        impl<#scalar: #any> #default for #name<#scalar> {
            /// The solver with all parameters at their declared values, rounded once.
            #[inline]
            fn default() -> Self { #value }
        }
    }
}

/// `lift`: the same mechanism on other numbers.
fn lift(cx: &Context<'_>) -> TokenStream {
    let (name, scalar, lifted) = (&cx.names.solver, &cx.names.scalar, &cx.names.lifted);
    let (any, real) = (cx.paths.item("Scalar"), cx.paths.item("Real"));
    let value = if numeric_params(cx.mechanism).is_empty() {
        construct(cx.mechanism, &cx.paths, &quote!(#name), held, held)
    } else {
        let [trait_, number] = ["Parameters", "lifted"].map(|item| cx.paths.item(item));
        quote!(#trait_::map(self, #number))
    };
    quote! {
        impl<#scalar: #real> #name<#scalar> {
            /// The same solver on other numbers, the parameters without derivatives.
            #[inline]
            #[must_use]
            pub fn lift<#lifted: #any>(&self) -> #name<#lifted> { #value }
        }
    }
}

/// A number without its derivatives as one of another type.
pub(super) fn lifted_number(
    paths: &Paths,
    value: &TokenStream,
    target: &TokenStream,
) -> TokenStream {
    let [real, scalar, narrow] = ["Real", "Scalar", "f32"].map(|name| paths.item(name));
    let value = quote!(#real::value(#value));
    quote!(<#target as #scalar>::lit(#value, #value as #narrow))
}
