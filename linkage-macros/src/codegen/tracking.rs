//! What following a motion through changes of mode needs: how clear of its limits every group is,
//! which parameter holds its mode, and arithmetic with whole results.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::arguments::Arguments;
use super::context::Context;
use super::identifiers::{function_name, generated};
use super::solver::construct;
use super::statements::Printer;
use super::text::Text;
use super::{formulas, results};
use crate::interface::EntryId;
use crate::interface::entries::Given;
use crate::lower::routine::Routine;
use crate::model::mechanism::{Param, ParamKind};

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
    let count = count(cx);
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
            type Values = [[#scalar::Enclosing; 2]; #count];

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

/// How many groups there are.
fn count(cx: &Context<'_>) -> Literal {
    Literal::usize_unsuffixed(cx.program().clearances.len())
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

/// How clear of their limits the groups are, and how that changes.
fn clearances(cx: &Context<'_>) -> TokenStream {
    let arguments = Arguments::of_our_own(cx, &[Given::Value, Given::Rate]);
    let scalar = &cx.names.scalar;
    let (received, mut body) = (arguments.received(&quote!(#scalar)), Text::long());
    let body = match &cx.lowered.clearances {
        Some(routine) => {
            with_rates(cx, routine, &mut body);
            let unread = arguments.unread(&routine.reads);
            quote!(#unread #body)
        }
        None => of_moving(cx, arguments.names()),
    };
    quote! {
        fn clearances(&self, #(#received),*) -> Self::Clearances { #body }
    }
}

/// Beside an unknown: a core without guards, as what is out of reach is a number below zero here, not a
/// refusal.
fn with_rates(cx: &Context<'_>, routine: &Routine, to: &mut Text) {
    let (printer, clearance) = (Printer::beginning(cx, routine, to), cx.paths.written("Clearance"));
    routine.stages.iter().for_each(|stage| printer.statements(&stage.statements, to));
    let names = ["value", "scale", "rate", "second_rate"];
    to.put("[").list(&cx.program().clearances, |to, group| {
        to.put(&clearance).put(" { ");
        let fields = names.iter().zip(group.sinks());
        to.list(fields, |to, (name, sink)| printer.value(sink, to.put(name).put(": "))).put(" }");
    });
    to.put("]");
}

/// Of a pose whose numbers move. The parameters stand still, and keep what derivatives they have.
fn of_moving(cx: &Context<'_>, names: &[Ident]) -> TokenStream {
    let [jet, moving] = ["Jet", "moving"].map(|name| cx.paths.item(name));
    let ([value, rate], lifted) = ([&names[0], &names[1]], generated("lifted_"));
    let (solver, scalar) = (&cx.names.solver, &cx.names.scalar);
    let along = match cx.inputs() {
        None => quote!(#jet::along(#value, #rate)),
        Some(record) => {
            let fields: Vec<_> = cx.mechanism.inputs.iter().map(|input| &input.name).collect();
            quote!(#record { #(#fields: #jet::along(#value.#fields, #rate.#fields)),* })
        }
    };
    let mode = |param: &Param| {
        let field = &param.name;
        quote!(self.#field)
    };
    let number = |param: &Param| {
        let field = &param.name;
        quote!(#jet::standing(self.#field))
    };
    let made = construct(cx, &quote!(#solver), number, mode);
    quote! {
        let #lifted: #solver<#jet<#scalar>> = #made;
        #moving(#lifted.told_(#along))
    }
}

/// Values and scales of a pose, whatever its numbers are: its formulas say them on the way. None beside
/// an unknown.
pub(super) fn told(cx: &Context<'_>) -> Option<TokenStream> {
    cx.lowered.clearances.is_none().then_some(())?;
    cx.interface.find("position").zip(cx.interface.find("motion"))?;
    let (scalar, count) = (&cx.names.scalar, count(cx));
    let arguments = Arguments::of_our_own(cx, &[Given::Value]);
    let (received, given) = (arguments.received(&quote!(#scalar)), &arguments.names()[0]);
    let body = match cx.lowered.routines.iter().find(|routine| routine.tells) {
        Some(routine) => on_the_way(cx, routine, given),
        None => {
            let unread = arguments.unread(&[]);
            quote!(#unread [])
        }
    };
    Some(quote! {
        fn told_(&self, #(#received),*) -> [[#scalar; 2]; #count] { #body }
    })
}

fn on_the_way(cx: &Context<'_>, routine: &Routine, value: &Ident) -> TokenStream {
    let (told, function) = (cx.paths.item("told"), function_name(&routine.name));
    let [checks, sin, cos] = ["checks_", "sin_", "cos_"].map(generated);
    let (turned, given) = match routine.given.first() {
        Some(Given::Cosine) => {
            let sin_cos = cx.scalar("sin_cos");
            (quote!(let (#sin, #cos) = #sin_cos(#value);), quote!(#cos, #sin))
        }
        _ => (TokenStream::new(), quote!(#value)),
    };
    let order = Literal::usize_unsuffixed(routine.stages.len());
    let (made, rest) = formulas::standstill(cx);
    quote! {
        #turned
        #made
        #told(|#checks| self.#function::<#order>(#checks, #given, #rest, #rest))
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
    let lifted = quote!(self.lift::<#scalar::Enclosing>());
    let values = match cx.lowered.clearances {
        // Their values are found with the rates.
        Some(_) => {
            let standing = cx.paths.item("standing");
            quote!(#standing(#modes::enclosures(self, #middle, #radius, #radius)))
        }
        None => quote!(#lifted.told_(#range)),
    };
    quote! {
        fn values(&self, #middle: #ty, #radius: #ty) -> Self::Values { #values }

        fn enclosures(&self, #middle: #ty, #radius: #ty, #rate: #ty) -> Self::Enclosures {
            #modes::clearances(&#lifted, #range, #rates)
        }
    }
}
