//! The code for the feature `sketch`: the places and names of all parts, and the part that each depends on.
//! The drawing itself is in the run-time crate, once.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::Drawing;
use super::docs::words;
use super::drawn_plan::{self, PlanStatement};
use super::identifiers::{generated, text};
use super::rust::context::Context;
use super::rust::paths::Paths;
use super::rust::{formulas, root_functions};
use super::script::page;
use crate::interface::entries::ArgumentKind;
use crate::lower::routine::Lowered;
use crate::lower::{APPLIED, PLACED};
use crate::model::mechanism::Mechanism;

/// Nothing where the run-time crate has no feature `sketch`: Cargo may turn the macro's on for
/// another build of that crate.
pub(super) fn items(
    mechanism: &Mechanism,
    solver: &Lowered<'_>,
    drawing: &Drawing<'_>,
) -> TokenStream {
    let cx = Context::in_double(mechanism, &drawing.placing);
    let (with_sketch, name, float) =
        (cx.paths.item("with_sketch"), &cx.names.solver, &cx.names.scalar);
    let (formulas, searches) = (formulas::functions(&cx), root_functions::functions(&cx));
    let (drawn, methods, applied) = (drawn(&cx), methods(&cx), applied(&cx));
    let marks = drawing.marks.as_ref();
    let page = drawing.source.map(|source| page::items(&cx, solver, (marks, source)));
    quote! {
        #with_sketch! {
            impl #name<#float> { #methods #applied #formulas #searches }
            #drawn
            #page
        }
    }
}

fn drawn(cx: &Context<'_>) -> TokenStream {
    let (name, float) = (&cx.names.solver, &cx.names.scalar);
    let path = |name| cx.paths.item(name);
    let [drawn, plan_type, vec, result, error, place, place_open] =
        ["Drawn", "Plan", "Vec", "Result", "SolveError", "place", "place_open"].map(path);
    let routine = &cx.lowered.routines[PLACED];
    let arguments = cx.signatures.arguments(&[ArgumentKind::Value]);
    let given = arguments.labelled(&routine.reads);
    let (q, checks, input) = (&arguments.names()[0], generated("checks_"), cx.input(float));
    let formulas = formulas::Call { routine: PLACED, stage: 0 }.under(cx, &quote!(#checks));
    let (without, str_) = (generated("without_"), cx.paths.item("str"));
    let unused = routine.reads.is_empty().then(|| quote!(let _ = #q;));
    let (plan, followed) = (plan(cx.mechanism, &cx.paths), followed(cx));
    quote! {
        impl #drawn for #name<#float> {
            type Input = #input;
            const PLAN: #plan_type = #plan;

            fn place(&self, #q: #input) -> #result<#vec<#float>, #error> {
                #unused
                #place(&Self::PLAN, &#given, |#checks| #formulas)
            }

            fn place_open(&self, #q: #input, #without: &'static #str_) -> #vec<#float> {
                #place_open(#without, |#checks| #formulas)
            }

            #followed
        }
    }
}

fn followed(cx: &Context<'_>) -> TokenStream {
    let (inputs, input) = (generated("path_"), cx.input(&cx.names.scalar));
    let [vec, option, error, followed] =
        ["Vec", "Option", "SolveError", "followed"].map(|name| cx.paths.item(name));
    quote! {
        fn followed(self, #inputs: &[#input]) -> #vec<(Self, #option<#error>)> {
            #followed(self, #inputs)
        }
    }
}

fn methods(cx: &Context<'_>) -> TokenStream {
    let path = |name| cx.paths.item(name);
    let [into, inputs_of, sketch, film, result, error] =
        ["Into", "ListOfInputs", "Sketch", "Film", "Result", "SolveError"].map(path);
    let [q, inputs] = ["q_", "path_"].map(generated);
    let input = cx.input(&cx.names.scalar);
    quote! {
        /// The mechanism as it stands at the inputs, to be drawn.
        ///
        /// # Errors
        /// Those of `position`, whatever the outputs are.
        pub fn sketch(&self, #q: impl #into<#input>) -> #result<#sketch, #error> {
            #sketch::of(self, #into::into(#q))
        }

        /// The mechanism as it moves through the inputs, one pose each, to be drawn. Poses out of
        /// reach are gaps of the film.
        #[must_use]
        pub fn film(&self, #inputs: impl #inputs_of<#input>) -> #film {
            #film::of(*self, #inputs)
        }
    }
}

/// The forces that the declaration puts on points, where there are any.
fn applied(cx: &Context<'_>) -> Option<TokenStream> {
    let routine = cx.lowered.routines.get(APPLIED)?;
    let path = |name| cx.paths.item(name);
    let [result, record, error, applied, drawn] =
        ["Result", "Applied", "SolveError", "applied", "Drawn"].map(path);
    let float = &cx.names.scalar;
    let scalar = quote!(#float);
    let arguments = cx.signatures.arguments(&routine.given);
    let (declared, converted) =
        (arguments.declared(&cx.paths, &scalar), arguments.converted(&cx.paths, &scalar));
    let given = arguments.labelled(&routine.reads);
    let checks = generated("checks_");
    let formulas = formulas::Call { routine: APPLIED, stage: 0 }.under(cx, &quote!(#checks));
    let points = drawn_plan::pushed(cx.mechanism).map(number);
    Some(quote! {
        /// The forces that the declaration puts on points, for `applied` of a film.
        ///
        /// # Errors
        /// What is given and not finite, and what a force is said by and cannot be assembled.
        pub fn applied(&self, #(#declared),*) -> #result<#record, #error> {
            #converted
            #applied(&<Self as #drawn>::PLAN, &[#(#points),*], &#given, |#checks| #formulas)
        }
    })
}

/// Names and statements, ids being places in the lists of names.
fn plan(mechanism: &Mechanism, paths: &Paths) -> TokenStream {
    let plan = paths.item("Plan");
    let name = text(&mechanism.name);
    let docs = words(&mechanism.docs);
    let [points, links, guides] = drawn_plan::names(mechanism).map(|names| quote!(&[#(#names),*]));
    let springs = drawn_plan::springs(mechanism).map(|drawn_plan::PlanSpring { ends, kinds }| {
        let (item, ends) = (paths.item("Spring"), ends.map(number));
        quote!(#item { ends: [#(#ends),*], kinds: [#(#kinds),*] })
    });
    let statements = drawn_plan::statements(mechanism).map(|placed| statement(paths, placed));
    quote! {
        #plan {
            name: #name,
            docs: #docs,
            points: #points,
            links: #links,
            guides: #guides,
            statements: &[#(#statements),*],
            springs: &[#(#springs),*],
        }
    }
}

fn statement(paths: &Paths, placed: PlanStatement) -> TokenStream {
    let element = paths.item("Element");
    match placed {
        PlanStatement::Ground(point) => {
            let point = number(point);
            quote!(#element::Ground(#point))
        }
        PlanStatement::Guide(guide, on) => {
            let (guide, on) = (number(guide), option(paths, on));
            quote!(#element::Guide(#guide, #on))
        }
        PlanStatement::Point(point, on) => {
            let (point, on) = (number(point), option(paths, on));
            quote!(#element::Point(#point, #on))
        }
        PlanStatement::Group(members, pin) => {
            let (members, pin) = (members.iter().map(|own| member(paths, own)), option(paths, pin));
            quote!(#element::Group(&[#(#members),*], #pin))
        }
    }
}

fn member(paths: &Paths, member: &drawn_plan::PlanMember) -> TokenStream {
    let (item, shape) = (paths.item("Member"), format_ident!("{}", member.shape));
    let (link, on) = (number(member.link), member.pivot.or(member.guide).map(number));
    let turned = member.is_turned.then(|| quote!(.turned()));
    quote!(#item::#shape(#link, #on)#turned)
}

fn number(id: u32) -> Literal {
    Literal::u32_unsuffixed(id)
}

fn option(paths: &Paths, id: Option<u32>) -> TokenStream {
    let [some, none] = ["Some", "None"].map(|name| paths.item(name));
    match id.map(number) {
        Some(id) => quote!(#some(#id)),
        None => quote!(#none),
    }
}
