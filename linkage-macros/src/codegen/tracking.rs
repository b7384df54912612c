//! What following a motion through changes of mode needs: how clear of its limits every group is, and
//! which parameter holds its mode.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::arguments::Arguments;
use super::as_solver::of_numbers;
use super::context::Context;
use super::identifiers::{function_name, generated};
use super::solver::construct;
use super::statements::Printer;
use super::text::Text;
use crate::interface::entries::Given;
use crate::lower::routine::Routine;
use crate::model::mechanism::{Param, ParamKind};

/// How many groups there are.
pub(super) fn count(cx: &Context<'_>) -> Literal {
    Literal::usize_unsuffixed(cx.program().clearances.len())
}

/// The groups' titles, and the parameters that hold their modes.
pub(super) fn groups(cx: &Context<'_>) -> Vec<TokenStream> {
    let [some, none] = ["Some", "None"].map(|name| cx.paths.item(name));
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
    groups.collect()
}

/// The mode that a parameter's number stands for becomes the other; nothing where none is a parameter.
pub(super) fn flips(cx: &Context<'_>) -> Option<TokenStream> {
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

/// How clear of their limits the groups are, as the trait asks it: the formulas of a pose say it on their
/// way. Beside an unknown a routine of its own does, which has rates, too.
pub(super) fn clearances(cx: &Context<'_>) -> TokenStream {
    match cx.lowered.clearances {
        None => told(cx, &on_the_way(cx)),
        Some(_) => {
            let (told, others) = (told(cx, &at_rest(cx)), with_rates_asked(cx));
            quote!(#told #others)
        }
    }
}

/// `told`: a solver of other numbers, asked.
fn told(cx: &Context<'_>, asked: &TokenStream) -> TokenStream {
    let (scalar, lifted, count) = (&cx.names.scalar, &cx.names.lifted, count(cx));
    let [real, copy, function, usize_] =
        ["Real", "Copy", "Fn", "usize"].map(|item| cx.paths.item(item));
    let [standing, input, of, any, solver] =
        ["standing_", "input_", "of_", "X_", "lifted_"].map(generated);
    let kept = |param: &Param| {
        let field = &param.name;
        quote!(self.#field)
    };
    let number = |param: &Param| {
        let field = &param.name;
        quote!(#standing(self.#field))
    };
    let name = &cx.names.solver;
    let made = construct(cx, &quote!(#name::<#lifted>), number, kept);
    let unread = cx.numeric_params().is_empty().then(|| quote!(let _ = #standing;));
    quote! {
        fn told<#lifted: #real, #any: #copy>(
            &self,
            #standing: impl #function(#scalar) -> #lifted,
            #input: impl #function(#usize_) -> #lifted,
            #of: impl #function([#lifted; 2]) -> #any,
        ) -> [#any; #count] {
            #unread
            let #solver = #made;
            #asked
        }
    }
}

/// A core without guards, as what is out of reach is a number below zero here, not a refusal.
pub(super) fn with_rates(cx: &Context<'_>) -> Option<TokenStream> {
    let routine = cx.lowered.clearances.as_ref()?;
    let arguments = Arguments::of_our_own(cx, &[Given::Value, Given::Rate]);
    let scalar = &cx.names.scalar;
    let (received, unread) =
        (arguments.received(&quote!(#scalar)), arguments.unread(&routine.reads));
    let (count, clearance) = (count(cx), cx.paths.item("Clearance"));
    let body = listed(cx, routine);
    Some(quote! {
        fn clearances_(&self, #(#received),*) -> [#clearance<#scalar>; #count] { #unread #body }
    })
}

fn listed(cx: &Context<'_>, routine: &Routine) -> Text {
    let mut text = Text::long();
    let (printer, clearance) =
        (Printer::beginning(cx, routine, &mut text), cx.paths.written("Clearance"));
    routine.stages.iter().for_each(|stage| printer.statements(&stage.statements, &mut text));
    let names = ["value", "scale", "rate", "second_rate"];
    text.put("[").list(&cx.program().clearances, |to, group| {
        to.put(&clearance).put(" { ");
        let fields = names.iter().zip(group.sinks());
        to.list(fields, |to, (name, sink)| printer.value(sink, to.put(name).put(": "))).put(" }");
    });
    text.put("]");
    text
}

/// What the formulas of a pose say on the way.
fn on_the_way(cx: &Context<'_>) -> TokenStream {
    let lifted = &cx.names.lifted;
    let [solver, input, of, checks, sin, cos, rest] =
        ["lifted_", "input_", "of_", "checks_", "sin_", "cos_", "rest_"].map(generated);
    let Some(routine) = cx.lowered.routines.iter().find(|routine| routine.tells) else {
        return quote!(let _ = (#solver, #input, #of); []);
    };
    let (told, function) = (cx.paths.item("told"), function_name(&routine.name));
    let value = of_numbers(cx, &input, 0);
    let (turned, given) = match routine.given.first() {
        Some(Given::Cosine) => {
            (quote!(let (#sin, #cos) = #lifted::sin_cos(#value);), quote!(#cos, #sin))
        }
        _ => (TokenStream::new(), value),
    };
    let order = Literal::usize_unsuffixed(routine.stages.len());
    let at_rest = standstill(cx);
    quote! {
        #turned
        let #rest = #at_rest;
        #told(|#checks| #solver.#function::<#order>(#checks, #given, #rest, #rest)).map(#of)
    }
}

/// The rates of inputs that do not move.
fn standstill(cx: &Context<'_>) -> TokenStream {
    let lifted = &cx.names.lifted;
    let zero = quote!(#lifted::num(0.0));
    let Some(record) = cx.inputs() else { return zero };
    let fields = cx.mechanism.inputs.iter().map(|input| {
        let field = &input.name;
        quote!(#field: #zero)
    });
    quote!(#record { #(#fields),* })
}

/// What the routine with rates says where nothing moves.
fn at_rest(cx: &Context<'_>) -> TokenStream {
    let [solver, input, of, group] = ["lifted_", "input_", "of_", "group_"].map(generated);
    let (value, at_rest) = (of_numbers(cx, &input, 0), standstill(cx));
    quote! {
        #solver.clearances_(#value, #at_rest).map(|#group| #of([#group.value, #group.scale]))
    }
}

/// The routine with rates, asked for them on numbers and on ranges.
fn with_rates_asked(cx: &Context<'_>) -> TokenStream {
    let scalar = &cx.names.scalar;
    let (groups, clearance) = (quote!(Self::Groups), cx.paths.item("Clearance"));
    let ty = cx.input(scalar);
    let [q, rate, middle, radius] = ["q_", "rate_", "middle_", "radius_"].map(generated);
    let none = cx.literal(0.0, 0.0);
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
    let rates = around(&rate, &|_| quote!(#none));
    quote! {
        fn clearances(&self, #q: #ty, #rate: #ty) -> #groups<#clearance<#scalar>> {
            self.clearances_(#q, #rate)
        }

        fn enclosures(
            &self,
            #middle: #ty,
            #radius: #ty,
            #rate: #ty,
        ) -> #groups<#clearance<#scalar::Enclosing>> {
            self.lift::<#scalar::Enclosing>().clearances_(#range, #rates)
        }
    }
}
