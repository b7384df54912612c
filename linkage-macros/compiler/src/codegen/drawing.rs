//! The code for the feature `sketch`: the places and names of all parts, and the part that each depends on.
//! The drawing itself is in the run-time crate, once.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Drawing;
use super::docs::words;
use super::identifiers::{generated, text};
use super::rust::context::Context;
use super::rust::paths::Paths;
use super::rust::{formulas, root_functions};
use super::script::page;
use crate::interface::entries::ArgumentKind;
use crate::lower::routine::Lowered;
use crate::lower::{APPLIED, PLACED};
use crate::model::acting::{Ends, Force, Spring};
use crate::model::mechanism::{Carrier, Drive, Group, Mechanism, Slideway, Step};

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
    let page = drawing.source.map(|source| page::items(&cx, solver, source));
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
    let [into, into_iterator, sketch, film, result, error] =
        ["Into", "IntoIterator", "Sketch", "Film", "Result", "SolveError"].map(path);
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
        pub fn film(&self, #inputs: impl #into_iterator<Item = impl #into<#input>>) -> #film {
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
    let number = quote!(#float);
    let arguments = cx.signatures.arguments(&routine.given);
    let (declared, converted) =
        (arguments.declared(&cx.paths, &number), arguments.converted(&cx.paths, &number));
    let given = arguments.labelled(&routine.reads);
    let checks = generated("checks_");
    let formulas = formulas::Call { routine: APPLIED, stage: 0 }.under(cx, &quote!(#checks));
    let points = cx.mechanism.dynamics.forces.iter().flat_map(|force| match force {
        Force::At { point, .. } => vec![*point],
        Force::Between { points, .. } => points.to_vec(),
    });
    let points = points.map(|point| self::number(point.0));
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
    let names = |names: Vec<&Ident>| {
        let names = names.into_iter().map(text);
        quote!(&[#(#names),*])
    };
    let points = names(mechanism.points.iter().map(|point| &point.name).collect());
    let links = names(mechanism.links.iter().map(|link| &link.name).collect());
    let guides = names(mechanism.guides.iter().map(|guide| &guide.name).collect());
    let springs = mechanism.dynamics.springs.iter().filter_map(|declared| spring(paths, declared));
    let statements = mechanism.steps.iter().map(|step| statement(mechanism, paths, step));
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

/// The record of a spring between two points; none for a torsion spring.
fn spring(paths: &Paths, spring: &Spring) -> Option<TokenStream> {
    let Ends::Points(ends) = spring.ends else { return None };
    let (item, ends) = (paths.item("Spring"), ends.map(|end| number(end.0)));
    let kinds = [&spring.stiffness, &spring.damping].map(|number| !number.value.is_zero());
    Some(quote!(#item { ends: [#(#ends),*], kinds: [#(#kinds),*] }))
}

fn statement(mechanism: &Mechanism, paths: &Paths, step: &Step) -> TokenStream {
    let element = paths.item("Element");
    let on = |carrier: Carrier| match carrier {
        Carrier::Ground => option(paths, None),
        Carrier::Link(link) => option(paths, Some(link.0)),
    };
    match step {
        Step::Ground { point, .. } => {
            let point = number(point.0);
            quote!(#element::Ground(#point))
        }
        Step::Guide { guide, carrier, .. } => {
            let (guide, carrier) = (number(guide.0), on(*carrier));
            quote!(#element::Guide(#guide, #carrier))
        }
        Step::Point { point, carrier, .. } => {
            let (point, carrier) = (number(point.0), on(*carrier));
            quote!(#element::Point(#point, #carrier))
        }
        Step::Group(group) => self::group(mechanism, paths, group),
    }
}

fn group(mechanism: &Mechanism, paths: &Paths, group: &Group) -> TokenStream {
    let [element, member] = ["Element", "Member"].map(|name| paths.item(name));
    let members = group.outer.iter().enumerate().map(|(index, joint)| {
        let (link, shape) = (number(group.links[index].0), shape(mechanism, group, index));
        let on = joint.point().map(|point| point.0).or(joint.guide().map(|guide| guide.0));
        let on = on.map(number);
        let turned = match &joint.drive {
            Some(Drive::Angle { angle, relative_to: Carrier::Ground })
                if mechanism.turns(angle) =>
            {
                Some(quote!(.turned()))
            }
            _ => None,
        };
        quote!(#member::#shape(#link, #on)#turned)
    });
    let (members, pin): (Vec<_>, _) =
        (members.collect(), option(paths, group.pin.map(|pin| pin.0)));
    quote!(#element::Group(&[#(#members),*], #pin))
}

/// The word for the shape of a link, from its joints.
fn shape(mechanism: &Mechanism, group: &Group, index: usize) -> Ident {
    let link = group.links[index];
    let slides_in = group.inner.iter().find_map(|joint| match joint.slideway()? {
        Slideway::Guide(_) => None,
        Slideway::Bar(carrier) | Slideway::Slot { link: carrier, .. } => Some(*carrier),
    });
    let name = match (&group.lengths[index], slides_in, group.outer[index].guide()) {
        (Some(length), ..) if mechanism.moves(&length.value) => "cylinder",
        (Some(_), ..) => "bar",
        (None, Some(carrier), Some(_)) if carrier == link => "yoke",
        (None, Some(carrier), None) if carrier == link => "slotted_bar",
        (None, Some(_), _) => "sleeve",
        (None, None, Some(_)) => "block",
        (None, None, None) => "body",
    };
    format_ident!("{name}")
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
