//! `Solver`: what the run-time crate asks of a solver, once for all that it does with every mechanism.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::context::Context;
use super::identifiers::{function_name, generated, text};
use super::{fast_path, results, tracking};
use crate::interface::EntryId;
use crate::interface::entries::Entry;

/// The entry points by the orders of the inputs that they are given.
const ORDERS: [&str; 3] = ["position", "velocity", "motion"];

/// Whether the sweep of an entry point goes by the solver.
pub(super) fn sweeps(entry: &Entry) -> bool {
    ORDERS.contains(&entry.name)
}

/// Nothing where not everything is offered that the trait asks for, as in some tests.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    let found = |name: &str| cx.interface.find(name);
    let ([Some(position), Some(velocity), Some(motion)], Some(_)) =
        (ORDERS.map(found), found("coefficients"))
    else {
        return TokenStream::new();
    };
    let by_order = [position, velocity, motion];
    let (solver, scalar) = (&cx.names.solver, &cx.names.scalar);
    let [trait_, real, copy] = ["Solver", "Real", "Copy"].map(|item| cx.paths.item(item));
    let (any, count) = (generated("X_"), tracking::count(cx));
    let (types, titles, searches, flips) =
        (types(cx, by_order), titles(cx), searches(cx), tracking::flips(cx));
    let (input, entries, rows) = (input(cx), entries(cx, by_order), rows());
    let (solve, clearances) = (solve(cx, by_order), tracking::clearances(cx));
    quote! {
        impl<#scalar: #real> #trait_ for #solver<#scalar> {
            #types
            type Groups<#any: #copy> = [#any; #count];
            #titles
            #searches
            #flips
            #input
            #entries
            #rows
            #solve
            #clearances
        }
    }
}

fn types(cx: &Context<'_>, entries: [EntryId; 3]) -> TokenStream {
    let (scalar, rows, columns) = (&cx.names.scalar, cx.rows(), cx.columns());
    let input = cx.input(scalar);
    let [position, velocity, motion] =
        entries.map(|id| results::ty(cx, cx.entry(id).result, &quote!(#scalar)));
    quote! {
        type Scalar = #scalar;
        type Input = #input;
        type Position = #position;
        type Velocity = #velocity;
        type Motion = #motion;
        type Rows = [#scalar; #rows];
        type Coefficients = [[#scalar; #columns]; #rows];
    }
}

fn titles(cx: &Context<'_>) -> TokenStream {
    let (solver, name, groups) = (&cx.names.solver, text(&cx.names.solver), tracking::groups(cx));
    let [titles, float] = ["Titles", "f64"].map(|item| cx.paths.item(item));
    quote! {
        const TITLES: #titles = #titles {
            name: #name,
            inputs: &#solver::<#float>::INPUTS,
            outputs: &#solver::<#float>::OUTPUTS,
            groups: &[#(#groups),*],
        };
    }
}

fn searches(cx: &Context<'_>) -> Option<TokenStream> {
    let bool_ = cx.paths.item("bool");
    cx.searches().then(|| quote!(const SEARCHES: #bool_ = true;))
}

/// The input of its numbers.
fn input(cx: &Context<'_>) -> TokenStream {
    let (scalar, number) = (&cx.names.scalar, generated("number_"));
    let [fn_mut, usize_] = ["FnMut", "usize"].map(|item| cx.paths.item(item));
    let (ty, made) = (cx.input(scalar), of_numbers(cx, &number, 0));
    quote! {
        #[inline]
        fn input(mut #number: impl #fn_mut(#usize_) -> #scalar) -> #ty { #made }
    }
}

/// Values, rates or second rates of the inputs, from a function of the place of each among all.
pub(super) fn of_numbers(cx: &Context<'_>, number: &Ident, order: usize) -> TokenStream {
    let first = order * cx.mechanism.inputs.len();
    let place = |input| Literal::usize_unsuffixed(first + input);
    let Some(record) = cx.inputs() else {
        let place = place(0);
        return quote!(#number(#place));
    };
    let fields = cx.mechanism.inputs.iter().enumerate().map(|(nth, input)| {
        let (field, place) = (&input.name, place(nth));
        quote!(#field: #number(#place))
    });
    quote!(#record { #(#fields),* })
}

/// The entry points themselves.
fn entries(cx: &Context<'_>, entries: [EntryId; 3]) -> TokenStream {
    let (scalar, rows, columns) = (&cx.names.scalar, cx.rows(), cx.columns());
    let input = cx.input(scalar);
    let [result, error] = ["Result", "SolveError"].map(|item| cx.paths.item(item));
    let given = ["q_", "rate_", "acceleration_"].map(generated);
    let functions = entries.iter().zip(ORDERS).enumerate().map(|(order, (&id, name))| {
        let ty = results::ty(cx, cx.entry(id).result, &quote!(#scalar));
        (function_name(name), &given[..=order], ty)
    });
    let coefficients = function_name("coefficients");
    let functions =
        functions.chain([(coefficients, &given[..1], quote!([[#scalar; #columns]; #rows]))]);
    let functions = functions.map(|(name, given, ty)| {
        quote! {
            #[inline]
            fn #name(&self, #(#given: #input),*) -> #result<#ty, #error> {
                Self::#name(self, #(#given),*)
            }
        }
    });
    functions.collect()
}

/// Records as rows.
fn rows() -> TokenStream {
    let record = generated("record_");
    quote! {
        #[inline]
        fn position_rows(#record: Self::Position) -> Self::Rows { #record.rows() }

        #[inline]
        fn motion_rows(#record: Self::Motion) -> [Self::Rows; 3] {
            [#record.position.rows(), #record.velocity.rows(), #record.acceleration.rows()]
        }
    }
}

/// The fast paths, as sweeps call them. Poses with an unknown are searched one by one: the mask says no,
/// and a single call follows.
fn solve(cx: &Context<'_>, entries: [EntryId; 3]) -> TokenStream {
    let lane = &cx.names.lifted;
    let [usize_, any, function, once] =
        ["usize", "Scalar", "Fn", "FnOnce"].map(|item| cx.paths.item(item));
    let [given, put, on] = ["given_", "put_", "lifted_"].map(generated);
    let (received, body) = match cx.searches() {
        true => {
            let nothing = generated("result_");
            let body = quote! {
                let #nothing = #lane::num(0.0);
                #lane::gt(#nothing, #nothing)
            };
            ([quote!(_), quote!(_)], body)
        }
        false => {
            let put_solved = cx.paths.item("put_solved");
            let [position, velocity, motion] = entries.map(|id| {
                let entry = cx.entry(id);
                let core = fast_path::core_name(cx, entry);
                let given = (0..entry.given.len()).map(|order| of_numbers(cx, &given, order));
                quote!(#put_solved(#on.#core(#(#given),*), #put))
            });
            let body = quote! {
                let #on = self.lift::<#lane>();
                match ORDER { 0 => #position, 1 => #velocity, _ => #motion }
            };
            ([quote!(#given), quote!(#put)], body)
        }
    };
    let [given, put] = received;
    quote! {
        #[inline(always)]
        fn solve<const ORDER: #usize_, #lane: #any>(
            &self,
            #given: impl #function(#usize_) -> #lane,
            #put: impl #once(&[#lane]),
        ) -> #lane::Mask {
            #body
        }
    }
}
