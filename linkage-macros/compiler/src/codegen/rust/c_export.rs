//! The additions of `export c;`: functions that C calls, and the text of their header.
//!
//! This is the only generated code that follows pointers. It does so in two places, `read_` and
//! `reply_`, behind a test for null; everything else is the solver's own safe interface. The items
//! stand in an unnamed constant, so that they meet no name of the user's.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::context::{Context, literal};
use super::paths::Paths;
use super::{results, solver};
use crate::codegen::arguments::Form;
use crate::codegen::c::c_identifiers::{self, PARAMETERS, Width};
use crate::codegen::c::header;
use crate::codegen::identifiers::{generated, string, text, used};
use crate::interface::entries::Entry;
use crate::model::mechanism::{Mechanism, Param, ParamKind, Sign};

/// Nothing unless the declaration says `export c;`.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    if !cx.mechanism.export_c {
        return TokenStream::new();
    }
    let name = &cx.names.solver;
    let (header, parameters) = (header::text(&cx.signatures, &Width::ALL, ""), parameters(cx));
    let [float, string] = ["f64", "str"].map(|item| cx.paths.item(item));
    let (read, reply) = (read(cx.mechanism, &cx.paths), reply(&cx.paths));
    let entries = &cx.interface.entries;
    let functions =
        Width::ALL.map(|width| entries.iter().map(move |entry| function(cx, entry, width)));
    let functions = functions.into_iter().flatten();
    quote! {
        impl #name<#float> {
            /// The header of the C functions that this mechanism exports, to be written to a file.
            pub const C_HEADER: &'static #string = #header;
        }

        #[allow(unsafe_code, reason = "C passes pointers; `export c` asked for functions it can call")]
        const _: () = { #parameters #read #reply #(#functions)* };
    }
}

/// The parameters in a layout that C can fill with anything; nothing without parameters.
fn parameters(cx: &Context<'_>) -> TokenStream {
    if cx.mechanism.params.is_empty() {
        return TokenStream::new();
    }
    let (name, scalar) = (&cx.names.solver, &cx.names.scalar);
    let [any, result, error, ok] = ["Scalar", "Result", "CError", "Ok"].map(|i| cx.paths.item(i));
    let derives = cx.paths.derives(&["Clone", "Copy"]);
    let i32 = cx.paths.item("i32");
    let fields = cx.mechanism.params.iter().map(|param| {
        let field = used(&param.name);
        let ty = if is_number(param) { quote!(#scalar) } else { quote!(#i32) };
        quote!(#field: #ty)
    });
    let solver =
        solver::construct(cx.mechanism, &cx.paths, &quote!(#name), solver::held, |param| {
            mode(&cx.paths, param)
        });
    let marker =
        solver::marker(cx.mechanism, &cx.paths).map(|(field, ty)| quote!(#field: #ty<#scalar>));
    let defaults = Width::ALL.map(|width| default(cx, width));
    quote! {
        #[repr(C)]
        #derives
        #[allow(non_snake_case, reason = "fields are named as declared")]
        struct Parameters_<#scalar> { #(#fields,)* #marker }

        impl<#scalar: #any> Parameters_<#scalar> {
            fn solver_(self) -> #result<#name<#scalar>, #error> { #ok(#solver) }
        }

        #(#defaults)*
    }
}

fn is_number(param: &Param) -> bool {
    matches!(param.kind, ParamKind::Number { .. })
}

/// A mode parameter from the number that C gives.
fn mode(paths: &Paths, param: &Param) -> TokenStream {
    let (field, name) = (used(&param.name), string(&text(&param.name), param.name.span()));
    let convert = match param.kind {
        ParamKind::Mode { of, .. } => Some(paths.item(of.row().from_c)),
        ParamKind::Number { .. } => None,
    };
    quote!(#convert(self.#field, #name)?)
}

/// The function that returns the parameters as declared.
fn default(cx: &Context<'_>, width: Width) -> TokenStream {
    let number = cx.paths.item(width.in_rust());
    let name = generated(&c_identifiers::default(&cx.names.solver, width));
    let fields = cx.mechanism.params.iter().map(|param| {
        let field = used(&param.name);
        let value = match &param.kind {
            ParamKind::Number { default, .. } if width == Width::Double => {
                literal(default.to_f64())
            }
            ParamKind::Number { default, .. } => literal(default.to_f32()),
            ParamKind::Mode { default, .. } => match default {
                Sign::Plus => quote!(1).into(),
                Sign::Minus => quote!(-1).into(),
            },
        };
        quote!(#field: #value)
    });
    let marker =
        solver::marker(cx.mechanism, &cx.paths).map(|(field, value)| quote!(#field: #value));
    quote! {
        #[unsafe(no_mangle)]
        extern "C" fn #name() -> Parameters_<#number> { Parameters_ { #(#fields,)* #marker } }
    }
}

/// The function `read_`, which reads the value behind a pointer from C; nothing where no function takes one.
fn read(mechanism: &Mechanism, paths: &Paths) -> TokenStream {
    let takes_pointers = !mechanism.params.is_empty()
        || mechanism.inputs.len() > 1
        || mechanism.dynamics.loads.len() > 1;
    if !takes_pointers {
        return TokenStream::new();
    }
    let [copy, str, error] = ["Copy", "str", "CError"].map(|item| paths.item(item));
    let [result, ok, err] = ["Result", "Ok", "Err"].map(|item| paths.item(item));
    quote! {
        /// # Safety
        /// The pointer is null or points to a value.
        unsafe fn read_<V: #copy>(from_: *const V, name_: &'static #str) -> #result<V, #error> {
            if from_.is_null() {
                return #err(#error::null_pointer(name_));
            }
            // SAFETY: the pointer is not null, so by the caller's word it points to a value.
            #ok(unsafe { from_.read() })
        }
    }
}

/// Hands an answer, or why there is none, over to C. The error of an answer is left as it was.
fn reply(paths: &Paths) -> TokenStream {
    let [str, i32, error] = ["str", "i32", "CError"].map(|item| paths.item(item));
    let [result, ok, err] = ["Result", "Ok", "Err"].map(|item| paths.item(item));
    quote! {
        /// # Safety
        /// Each pointer is null or points to where a value of its type may be written.
        unsafe fn reply_<V>(
            answer_: #result<V, #error>,
            to_: *mut V,
            name_: &'static #str,
            why_: *mut #error,
        ) -> #i32 {
            let reason_ = match answer_ {
                _ if to_.is_null() => #error::null_pointer(name_),
                #ok(value_) => {
                    // SAFETY: the pointer is not null, so by the caller's word it can be written.
                    unsafe { to_.write(value_) };
                    return 0;
                }
                #err(reason_) => reason_,
            };
            if !why_.is_null() {
                // SAFETY: as above.
                unsafe { why_.write(reason_) };
            }
            reason_.status
        }
    }
}

/// One entry point for one width.
fn function(cx: &Context<'_>, of: &Entry, width: Width) -> TokenStream {
    let name = generated(&c_identifiers::function(&cx.names.solver, of, width));
    let method = generated(of.name());
    let number = cx.paths.item(width.in_rust());
    let number = quote!(#number);
    let arguments = cx.signatures.arguments(&of.given);
    let names: Vec<Ident> =
        (0..arguments.names().len()).map(|i| generated(&format!("q{i}_"))).collect();
    let (mut declared, mut read) = (TokenStream::new(), TokenStream::new());
    for ((argument, form), name) in arguments.parts().zip(&names) {
        let ty = form.ty(&number);
        if let Form::Number = form {
            declared.extend(quote!(#name: #ty,));
            continue;
        }
        let label = string(&text(argument), argument.span());
        declared.extend(quote!(#name: *const #ty,));
        read.extend(quote!(let #name = unsafe { read_(#name, #label) }?;));
    }
    let (solver, parameter) = called(cx, &number);
    let value = results::ty(cx.interface, &cx.paths, of.result, &number);
    let [result, ok, error, i32] = ["Result", "Ok", "CError", "i32"].map(|i| cx.paths.item(i));
    let label = of.point.answer();
    let (to, why, answer) = (generated("to_"), generated("why_"), generated("answer_"));
    quote! {
        #[unsafe(no_mangle)]
        unsafe extern "C" fn #name(
            #parameter #declared #to: *mut #value, #why: *mut #error,
        ) -> #i32 {
            let #answer = (|| -> #result<#value, #error> {
                #read
                #ok(#solver.#method(#(#names),*)?)
            })();
            // SAFETY: what C has to guarantee is what the header asks for.
            unsafe { reply_(#answer, #to, #label, #why) }
        }
    }
}

/// The solver to call, and the argument it comes from if it has parameters.
fn called(cx: &Context<'_>, number: &TokenStream) -> (TokenStream, TokenStream) {
    let (name, from) = (&cx.names.solver, generated("mechanism_"));
    if cx.mechanism.params.is_empty() {
        let default = cx.paths.item("Default");
        return (quote!(<#name<#number> as #default>::default()), TokenStream::new());
    }
    let read = quote!(unsafe { read_(#from, #PARAMETERS) }?.solver_()?);
    (read, quote!(#from: *const Parameters_<#number>,))
}
