//! The additions of `export assemblies;`: the list of all assemblies, and the solver of each.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use linkage_assemblies::{BodyPin, HungBar, PinnedDyad};

use super::context::Context;
use super::paths::Paths;
use super::{formulas, solver};
use crate::codegen::identifiers::{generated, used};
use crate::codegen::listing::Listing;
use crate::model::any_assembly::AnyAssembly;
use crate::model::mechanism::{Mechanism, Param, ParamId};

/// The list, as functions of the solver.
pub(in crate::codegen) fn items(mechanism: &Mechanism, listing: &Listing<'_>) -> TokenStream {
    let cx = Context::new(mechanism, &listing.pinned);
    let (name, scalar) = (&cx.names.solver, &cx.names.scalar);
    let most = Literal::usize_unsuffixed(2 * listing.degree.half);
    let routine = &cx.lowered.routines[0];
    let number = quote!(#scalar);
    let arguments = cx.signatures.arguments(&routine.given);
    let (declared, converted) =
        (arguments.declared(&cx.paths, &number), arguments.converted(&cx.paths, &number));
    let given = arguments.labelled(&routine.reads);
    let [checks, budget] = ["checks_", "budget_"].map(generated);
    let called = formulas::Call { routine: 0, stage: 0 }.under(&cx, &quote!(#checks));
    let functions = formulas::functions(&cx);
    let items = ["Real", "f64", "usize", "Budget", "List", "Result", "SolveError", "PinnedKind"];
    let [real, float, usize_, budget_type, list, result, error, kind_type] =
        items.map(|item| cx.paths.item(item));
    let [listed, diagnose] = ["listed", "diagnose_all"].map(|item| cx.paths.item(item));
    let kind = kind(&cx.paths, listing);
    quote! {
        impl #name<#float> {
            /// The most assemblies, whatever the lengths are.
            pub const ASSEMBLIES: #usize_ = #most;
        }
        impl<#scalar: #real> #name<#scalar> {
            #functions

            /// All ways to assemble the machine's first group that is searched, at these inputs, by at most as many samples and pieces as
            /// the budget has. The list says if it is proved. Angles are in radians.
            ///
            /// # Errors
            /// Those of `position` for what is given, for lengths, and for what the group stands on. A group that cannot be
            /// assembled has an empty list.
            pub fn assemblies(
                &self,
                #(#declared,)*
                #budget: #budget_type,
            ) -> #result<#list<#most>, #error> {
                const KIND: #kind_type = #kind;
                #converted
                let numbers_ = #diagnose::<#scalar, _, 0>(&#given, |#checks| #called, |_| []);
                #listed(&KIND, numbers_, #budget)
            }
        }
    }
}

fn kind(paths: &Paths, Listing { group, degree, .. }: &Listing<'_>) -> TokenStream {
    let items = ["PinnedKind", "PinnedGroup", "ClosureDegree", "Some", "Option"];
    let [kind, pinned, closure, some, option] = items.map(|item| paths.item(item));
    let number = |number: usize| Literal::usize_unsuffixed(number);
    let pivot = group.pivot.map(number);
    let dyads = group.dyads.iter().map(|dyad| match dyad {
        Some(dyad) => {
            let dyad = self::dyad(paths, dyad);
            quote!(#some(#dyad))
        }
        None => quote!(#option::None),
    });
    let equation = group.equation.map(|at| pin(paths, at));
    let powers = degree.powers.map(Literal::u32_unsuffixed);
    let half = number(degree.half);
    quote! {
        #kind {
            group: #pinned {
                pivot: [#(#pivot),*],
                dyads: [#(#dyads),*],
                equation: [#(#equation),*],
            },
            degree: #closure { powers: [#(#powers),*], half: #half },
        }
    }
}

fn dyad(paths: &Paths, dyad: &PinnedDyad) -> TokenStream {
    let [item, hung] = ["PinnedDyad", "HungBar"].map(|item| paths.item(item));
    let bars = dyad.bars.map(|HungBar { body, outer, ends }| {
        let outer = pin(paths, outer);
        let (body, ends) = (Literal::usize_unsuffixed(body), ends.map(Literal::usize_unsuffixed));
        quote!(#hung { body: #body, outer: #outer, ends: [#(#ends),*] })
    });
    quote!(#item { bars: [#(#bars),*] })
}

fn pin(paths: &Paths, BodyPin { body, place }: BodyPin) -> TokenStream {
    let item = paths.item("BodyPin");
    let [body, place] = [body, place].map(Literal::usize_unsuffixed);
    quote!(#item { body: #body, place: #place })
}

/// The solver of an assembly, beside both structs.
pub(crate) fn with_any(mechanism: &Mechanism, any: &AnyAssembly) -> TokenStream {
    let own = [&mechanism.name, &any.mechanism.name].map(Ident::to_string);
    let paths = Paths::beside(mechanism, own.into());
    let [name, other] = [mechanism, &any.mechanism].map(|one| used(&one.name));
    let (scalar, assembly) = (generated("T"), generated("assembly_"));
    let is = |param: &Param, id: ParamId| any.mechanism.params[id.index()].name == param.name;
    let [real, lit, assembled] = ["Real", "Scalar", "Assembly"].map(|item| paths.item(item));
    let [side, trend] = ["assembled_side", "assembled_trend"].map(|item| paths.item(item));
    let number = |param: &Param| match () {
        () if is(param, any.near) => quote!(<#scalar as #lit>::num(#assembly.unknown)),
        () if is(param, any.room) => quote!(<#scalar as #lit>::num(#assembly.within)),
        () => solver::held(param),
    };
    let is_left = any.is_left;
    let mode = |param: &Param| {
        let dyad = any.sides.iter().position(|&own| is(param, own));
        match dyad.map(Literal::usize_unsuffixed) {
            Some(dyad) => quote!(#side(#assembly, #dyad)),
            None if is(param, any.trend) => quote!(#trend(#assembly, #is_left)),
            None => solver::held(param),
        }
    };
    let value = solver::construct(&any.mechanism, &paths, &quote!(#other), number, mode);
    let import = paths.import_in_constant();
    quote! {
        const _: () = {
            #import
            impl<#scalar: #real> #name<#scalar> {
                /// The solver of one assembly: it begins at the unknown in the list, and looks no farther than half way to the next assembly
                /// there, nor than its groups can be assembled there.
                #[must_use]
                pub fn with(&self, #assembly: &#assembled) -> #other<#scalar> { #value }
            }
        };
    }
}
