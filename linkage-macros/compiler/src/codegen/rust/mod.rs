//! Routines into Rust: one struct for the mechanism, records for what goes in and comes out, and
//! for every entry point a fast path, a slow path and the function that chooses.
//!
//! Paths into the run-time crate are made in `paths`, and nowhere else.

mod as_solver;
pub(super) mod assembly_functions;
mod autodiff;
mod c_export;
mod checked;
pub(super) mod context;
mod cost_constant;
mod declared_arguments;
pub(super) mod driving_sets;
mod editor_names;
mod fast_path;
pub(super) mod formulas;
mod in_rust;
mod input_records;
mod module;
mod parameters;
pub mod paths;
mod results;
pub(super) mod root_functions;
mod slow_path;
pub(super) mod solver;
mod state_rates;
mod structs;
mod sweeps;
mod token_list;
mod tracking;

use proc_macro2::TokenStream;
use quote::quote;

use self::context::Context;
use crate::lower::routine::Lowered;
use crate::model::mechanism::Mechanism;

/// Everything that the declaration of a mechanism expands to, with what is `beside` the solver, and records that serde writes and reads where they are to be serialised.
pub(super) fn generate(
    mechanism: &Mechanism,
    lowered: &Lowered<'_>,
    beside: TokenStream,
    is_serialised: bool,
) -> TokenStream {
    let cx = Context::new(mechanism, lowered);
    let (solver, records) = (solver::definition(&cx), structs::definitions(&cx, is_serialised));
    let implementations = implementations(&cx, &beside);
    module::around(&cx, &quote! { #solver #records #implementations })
}

/// All that is done with the structs, in an unnamed constant: what it imports meets no name of the
/// user's, and its paths are short.
fn implementations(cx: &Context<'_>, beside: &TokenStream) -> TokenStream {
    let import = cx.paths.import_in_constant();
    let arguments = cx.paths.import_arguments(declared_arguments::all_names(&cx.signatures));
    let (solver, records) = (solver::implementation(cx), structs::implementations(cx));
    let parameters = parameters::implementation(cx);
    let fast = cx.entries().map(|entry| fast_path::function(cx, entry));
    let followed = cx.entries().map(|entry| fast_path::following(cx, entry));
    let checked = cx.entries().map(|entry| checked::function(cx, entry));
    let slow = cx.entries().map(|entry| slow_path::function(cx, entry));
    let (formulas, searches) = (formulas::functions(cx), root_functions::functions(cx));
    let sweeps = sweeps::items(cx);
    let (derivatives, clearances) = (autodiff::items(cx), tracking::with_rates(cx));
    let (as_solver, dynamics) = (as_solver::items(cx), state_rates::items(cx));
    let (c_export, references) = (c_export::items(cx), editor_names::items(cx));
    let (name, scalar) = (&cx.names.solver, &cx.names.scalar);
    // A search decides at every trial, which lanes cannot do together.
    let any = cx.paths.item(if cx.searches() { "Real" } else { "Scalar" });
    let real = cx.paths.item("Real");
    let has_loads = !cx.mechanism.dynamics.loads.is_empty();
    let many = has_loads.then(|| {
        quote! {
            #[allow(clippy::too_many_arguments, reason = "rates, loads, results and statuses")]
        }
    });
    quote! {
        #[allow(clippy::approx_constant, reason = "a dimension may be near a constant by chance")]
        #many
        const _: () = {
            #import
            #arguments
            #solver
            #parameters
            #records
            impl<#scalar: #any> #name<#scalar> { #(#fast)* #formulas #searches }
            impl<#scalar: #real> #name<#scalar> { #(#checked)* #(#slow)* #(#followed)* #clearances }
            #sweeps
            #derivatives
            #as_solver
            #dynamics
            #c_export
            #references
            #beside
        };
    }
}
