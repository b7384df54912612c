//! What following a motion through changes of mode needs: how clear of its limits every group is,
//! which parameter holds its mode, and arithmetic with whole results.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::Context;
use super::blocks::lay_out;
use super::body::Body;
use super::names::generated;
use super::results::Order;
use crate::ir::liveness::Course;
use crate::ir::program::EntryKind;
use crate::model::mechanism::ParamKind;

/// `Modes` for the solver, and `Linear` for what goes in and comes out.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    let complete = [EntryKind::Position, EntryKind::Motion].map(|kind| cx.entry(kind).is_some());
    if complete != [true, true] {
        return TokenStream::new();
    }
    let (modes, linear) = (modes(cx), linear(cx));
    quote!(#modes #linear)
}

fn modes(cx: &Context<'_>) -> TokenStream {
    let (names, scalar) = (&cx.names, &cx.names.scalar);
    let (solver, position, motion) = (&names.solver, &names.position, &names.motion);
    let path = |name| cx.paths.item(name);
    let [modes, real, clearance, result, error, usize_] =
        ["Modes", "Real", "Clearance", "Result", "SolveError", "usize"].map(path);
    let input = match &cx.mechanism.inputs[..] {
        [_] => quote!(#scalar),
        _ => {
            let record = &names.input;
            quote!(#record<#scalar>)
        }
    };
    let count = Literal::usize_unsuffixed(cx.program.clearances.len());
    let [q, rate, acceleration, param] = ["q_", "rate_", "acceleration_", "param_"].map(generated);
    let (groups, clearances, flips) = (groups(cx), clearances(cx), flips(cx, &param));
    let enclosures = enclosures(cx);
    quote! {
        impl<#scalar: #real> #modes for #solver<#scalar> {
            type Scalar = #scalar;
            type Input = #input;
            type Position = #position<#scalar>;
            type Motion = #motion<#scalar>;
            type Clearances = [#clearance<#scalar>; #count];
            type Enclosures = [#clearance<<#scalar as #real>::Enclosing>; #count];

            #groups

            #[inline]
            fn flip(&mut self, #param: #usize_) { #flips }

            #[inline]
            fn position(&self, #q: #input) -> #result<#position<#scalar>, #error> {
                Self::position(self, #q)
            }

            #[inline]
            fn motion(
                &self,
                #q: #input,
                #rate: #input,
                #acceleration: #input,
            ) -> #result<#motion<#scalar>, #error> {
                Self::motion(self, #q, #rate, #acceleration)
            }

            #clearances

            #enclosures
        }
    }
}

/// The groups' titles, and the parameters that hold their modes.
fn groups(cx: &Context<'_>) -> TokenStream {
    let [option, some, none, usize_, str_] =
        ["Option", "Some", "None", "usize", "str"].map(|name| cx.paths.item(name));
    let groups = cx.program.clearances.iter().map(|clearance| {
        let title = &cx.program.groups[clearance.group as usize];
        let param = match clearance.param {
            Some(param) => {
                let param = Literal::u32_unsuffixed(param);
                quote!(#some(#param))
            }
            None => quote!(#none),
        };
        quote!((#title, #param))
    });
    quote!(const GROUPS: &'static [(&'static #str_, #option<#usize_>)] = &[#(#groups),*];)
}

/// The mode that a parameter's number stands for becomes the other.
fn flips(cx: &Context<'_>, param: &Ident) -> TokenStream {
    let modes = cx.mechanism.params.iter().enumerate();
    let modes = modes.filter(|(_, param)| !matches!(param.kind, ParamKind::Number { .. }));
    let flips = modes.map(|(index, param)| {
        let (index, field) = (Literal::usize_unsuffixed(index), &param.name);
        quote!(#index => self.#field = self.#field.flipped(),)
    });
    let flips: TokenStream = flips.collect();
    match flips.is_empty() {
        true => quote!(let _ = #param;),
        false => quote!(match #param { #flips _ => {} }),
    }
}

/// A core without guards: what is out of reach is a number below zero here, not a refusal.
fn clearances(cx: &Context<'_>) -> TokenStream {
    let (scalar, clearance) = (&cx.names.scalar, cx.paths.item("Clearance"));
    let arguments = cx.arguments(EntryKind::Velocity);
    let body = Body { cx, arguments: &arguments, course: Course::Open, bounds: None };
    let sinks: Vec<_> = cx.program.clearances.iter().flat_map(|group| group.sinks).collect();
    let statements = body.statements(&sinks);
    let lines = lay_out(&statements.list, &body.locals(sinks.iter().copied()), &cx.locals);
    let (received, unread) =
        (arguments.received(&quote!(#scalar)), arguments.unread(&statements.leaves));
    let values = cx.program.clearances.iter().map(|group| {
        let [value, rate, second_rate, scale] = group.sinks.map(|sink| body.value(sink));
        quote! {
            #clearance { value: #value, rate: #rate, second_rate: #second_rate, scale: #scale }
        }
    });
    quote! {
        fn clearances(&self, #(#received),*) -> Self::Clearances {
            #unread
            #lines
            [#(#values),*]
        }
    }
}

/// The same on ranges of numbers.
fn enclosures(cx: &Context<'_>) -> TokenStream {
    let arguments = cx.arguments(EntryKind::Velocity);
    let scalar = &cx.names.scalar;
    let [real, modes] = ["Real", "Modes"].map(|name| cx.paths.item(name));
    let [middle, radius, rate, none] = ["middle_", "radius_", "rate_", "none_"].map(generated);
    let ty = arguments.ty(&quote!(#scalar));
    let enclosing = quote!(<#scalar as #real>::Enclosing);
    let literal = cx.literal(0.0, 0.0);
    let around = |value: &Ident, radius: &dyn Fn(&TokenStream) -> TokenStream| {
        if !arguments.are_records() {
            let radius = radius(&TokenStream::new());
            return quote!(#real::enclosing(#value, #radius));
        }
        let record = &cx.names.input;
        let fields = cx.mechanism.inputs.iter().map(|input| {
            let field = &input.name;
            let radius = radius(&quote!(.#field));
            quote!(#field: #real::enclosing(#value.#field, #radius))
        });
        quote!(#record { #(#fields),* })
    };
    let range = around(&middle, &|field| quote!(#radius #field));
    let rates = around(&rate, &|_| quote!(#none));
    quote! {
        fn enclosures(&self, #middle: #ty, #radius: #ty, #rate: #ty) -> Self::Enclosures {
            let #none = #literal;
            #modes::clearances(&self.lift::<#enclosing>(), #range, #rates)
        }
    }
}

/// Sums and differences of records, field by field.
fn linear(cx: &Context<'_>) -> TokenStream {
    let outputs: Vec<&Ident> = cx.mechanism.outputs.iter().map(|output| &output.field).collect();
    let inputs: Vec<&Ident> = cx.mechanism.inputs.iter().map(|input| &input.name).collect();
    let orders = ["position", "velocity", "acceleration"].map(generated_field);
    let records = Order::ALL.map(|order| of_record(cx, order.record(cx), &outputs));
    let motion = of_record(cx, &cx.names.motion, &orders.each_ref());
    let input = (inputs.len() > 1).then(|| of_record(cx, &cx.names.input, &inputs));
    quote!(#(#records)* #motion #input)
}

/// A field that the generated code names itself.
fn generated_field(name: &str) -> Ident {
    Ident::new(name, proc_macro2::Span::call_site())
}

fn of_record(cx: &Context<'_>, record: &Ident, fields: &[&Ident]) -> TokenStream {
    let (scalar, any, linear) =
        (&cx.names.scalar, cx.paths.item("Scalar"), cx.paths.item("Linear"));
    let [factor, other, test] = ["factor_", "other_", "test_"].map(generated);
    let [test_fn, bool_, copy] = ["Fn", "bool", "Copy"].map(|name| cx.paths.item(name));
    quote! {
        impl<#scalar: #any> #linear<#scalar> for #record<#scalar> {
            #[inline]
            fn plus(self, #factor: #scalar, #other: Self) -> Self {
                Self { #(#fields: #linear::<#scalar>::plus(self.#fields, #factor, #other.#fields)),* }
            }
            #[inline]
            fn minus(self, #other: Self) -> Self {
                Self { #(#fields: #linear::<#scalar>::minus(self.#fields, #other.#fields)),* }
            }
            #[inline]
            fn all(self, #test: impl #test_fn(#scalar) -> #bool_ + #copy) -> #bool_ {
                #(#linear::<#scalar>::all(self.#fields, #test))&&*
            }
        }
    }
}
