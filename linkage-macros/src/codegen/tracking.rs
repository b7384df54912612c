//! What following a motion through changes of mode needs: how clear of its limits every group is,
//! which parameter holds its mode, and arithmetic with whole results.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::context::Context;
use super::identifiers::generated;
use super::results;
use super::statements::Printer;
use super::text::Text;
use crate::interface::EntryId;
use crate::model::mechanism::ParamKind;

/// `Modes` for the solver.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    let [Some(position), Some(motion)] = ["position", "motion"].map(|name| cx.interface.find(name))
    else {
        return TokenStream::new();
    };
    modes(cx, position, motion)
}

fn modes(cx: &Context<'_>, position: EntryId, motion: EntryId) -> TokenStream {
    let (solver, scalar) = (&cx.names.solver, &cx.names.scalar);
    let number = quote!(#scalar);
    let [position, motion] =
        [position, motion].map(|id| results::ty(cx, cx.entry(id).result, &number));
    let path = |name| cx.paths.item(name);
    let [modes, real, clearance, result, error] =
        ["Modes", "Real", "Clearance", "Result", "SolveError"].map(path);
    let input = cx.input(scalar);
    let count = Literal::usize_unsuffixed(cx.program().clearances.len());
    let [q, rate, acceleration] = ["q_", "rate_", "acceleration_"].map(generated);
    let (groups, clearances, flips) = (groups(cx), clearances(cx), flips(cx));
    let enclosures = enclosures(cx);
    let searches = cx.searches().then(|| {
        let bool_ = path("bool");
        quote!(const SEARCHES: #bool_ = true;)
    });
    quote! {
        impl<#scalar: #real> #modes for #solver<#scalar> {
            type Scalar = #scalar;
            type Input = #input;
            type Position = #position;
            type Motion = #motion;
            type Clearances = [#clearance<#scalar>; #count];
            type Enclosures = [#clearance<#scalar::Enclosing>; #count];

            #searches

            #groups

            #flips

            #[inline]
            fn position(&self, #q: #input) -> #result<#position, #error> {
                Self::position(self, #q)
            }

            #[inline]
            fn motion(
                &self,
                #q: #input,
                #rate: #input,
                #acceleration: #input,
            ) -> #result<#motion, #error> {
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
    let groups = cx.program().clearances.iter().map(|clearance| {
        let title = &cx.program().groups[clearance.group as usize];
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

/// The mode that a parameter's number stands for becomes the other; nothing where none is a parameter.
fn flips(cx: &Context<'_>) -> Option<TokenStream> {
    let modes = cx.mechanism.params.iter().enumerate();
    let modes = modes.filter(|(_, param)| !matches!(param.kind, ParamKind::Number { .. }));
    let flips = modes.map(|(index, param)| {
        let (index, field) = (Literal::usize_unsuffixed(index), &param.name);
        quote!(#index => self.#field = self.#field.flipped(),)
    });
    let flips: TokenStream = flips.collect();
    let (param, size) = (generated("param_"), cx.paths.item("usize"));
    let flip = quote! {
        #[inline]
        fn flip(&mut self, #param: #size) { match #param { #flips _ => {} } }
    };
    (!flips.is_empty()).then_some(flip)
}

/// A core without guards: what is out of reach is a number below zero here, not a refusal.
fn clearances(cx: &Context<'_>) -> TokenStream {
    let (scalar, clearance) = (&cx.names.scalar, cx.paths.written("Clearance"));
    let (mut lines, routine) = (Text::long(), &cx.lowered.clearances);
    let printer = Printer::beginning(cx, routine, &mut lines);
    routine.stages.iter().for_each(|stage| printer.statements(&stage.statements, &mut lines));
    let (received, unread) =
        (printer.arguments.received(&quote!(#scalar)), printer.arguments.unread(&routine.reads));
    let names = ["value", "rate", "second_rate", "scale"];
    lines.put("[").list(&cx.program().clearances, |to, group| {
        to.put(&clearance).put(" { ");
        let fields = names.iter().zip(group.sinks);
        to.list(fields, |to, (name, sink)| printer.value(sink, to.put(name).put(": "))).put(" }");
    });
    lines.put("]");
    quote! {
        fn clearances(&self, #(#received),*) -> Self::Clearances {
            #unread
            #lines
        }
    }
}

/// The same on ranges of numbers.
fn enclosures(cx: &Context<'_>) -> TokenStream {
    let (scalar, modes, zero) = (&cx.names.scalar, cx.paths.item("Modes"), cx.literal(0.0, 0.0));
    let ty = cx.input(scalar);
    let [middle, radius, rate] = ["middle_", "radius_", "rate_"].map(generated);
    // Every number of the inputs as the middle of a range.
    let around = |value: &Ident, radius: &dyn Fn(Option<&Ident>) -> TokenStream| {
        let Some(record) = cx.inputs() else {
            let radius = radius(None);
            return quote!(#value.enclosing(#radius));
        };
        let fields = cx.mechanism.inputs.iter().map(|input| {
            let (field, radius) = (&input.name, radius(Some(&input.name)));
            quote!(#field: #value.#field.enclosing(#radius))
        });
        quote!(#record { #(#fields),* })
    };
    let range = around(&middle, &|field| match field {
        Some(field) => quote!(#radius.#field),
        None => quote!(#radius),
    });
    let rates = around(&rate, &|_| quote!(#zero));
    quote! {
        fn enclosures(&self, #middle: #ty, #radius: #ty, #rate: #ty) -> Self::Enclosures {
            #modes::clearances(&self.lift::<#scalar::Enclosing>(), #range, #rates)
        }
    }
}
