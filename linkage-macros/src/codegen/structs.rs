//! The records that entry points take and return.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::context::Context;
use super::docs;
use super::identifiers::generated;
use super::results::{read, ty};
use crate::interface::quantity::Order;
use crate::interface::records::{Field, Kind, Record, Shape};

/// All records of a mechanism.
pub(super) fn definitions(cx: &Context<'_>) -> TokenStream {
    let records = cx.interface.records.iter().filter(|record| is_returned(cx, record));
    records.map(|record| definition(cx, record)).collect()
}

/// Whether something is given or returns it: margins may be outputs without an entry point.
pub(super) fn is_returned(cx: &Context<'_>, record: &Record) -> bool {
    record.kind != Kind::Margins || cx.interface.find("margins").is_some()
}

/// What can be done with them.
pub(super) fn implementations(cx: &Context<'_>) -> TokenStream {
    let implementation = |record: &Record| match record.kind {
        Kind::Inputs | Kind::Loads => from_list(cx, record),
        Kind::Outputs(order) => rows(cx, record, order),
        Kind::Motion | Kind::Margins | Kind::Forces | Kind::ForcesOf(_) => TokenStream::new(),
    };
    cx.interface.records.iter().map(implementation).collect()
}

/// What stands in front of every struct: names are as declared, no number is `Eq`, and hardly
/// anyone reads every result.
pub(super) fn attributes(cx: &Context<'_>) -> TokenStream {
    let derives = cx.paths.derives(&["Clone", "Copy", "Debug", "PartialEq"]);
    let layout = cx.mechanism.export_c.then(|| quote!(#[repr(C)]));
    quote! {
        #derives
        #layout
        #[allow(
            dead_code,
            non_snake_case,
            clippy::derive_partial_eq_without_eq,
            reason = "names are as declared, and results are there to choose from"
        )]
    }
}

fn definition(cx: &Context<'_>, record: &Record) -> TokenStream {
    let (name, scalar, visibility) = (&record.name, &cx.names.scalar, &cx.mechanism.visibility);
    let (docs, attributes) = (docs::record(cx, record), attributes(cx));
    let fields = record.fields.iter().map(|field| {
        let (docs, name) = (docs::field(cx, field), &field.name);
        let ty = ty(cx, field.shape, &quote!(#scalar));
        quote!(#docs pub #name: #ty)
    });
    let fields: Vec<_> = fields.collect();
    // What is as declared by us alone stands on lines of its own.
    let last = (record.kind == Kind::Motion).then(|| quote!(,));
    let named = matches!(record.kind, Kind::ForcesOf(_))
        .then(|| quote!(#[allow(non_camel_case_types, reason = "names are as declared")]));
    quote! {
        #docs
        #attributes
        #named
        #visibility struct #name<#scalar> { #(#fields),* #last }
    }
}

/// `rows()`: the record as a list, in the order of `OUTPUTS`.
fn rows(cx: &Context<'_>, record: &Record, order: Order) -> TokenStream {
    let (name, scalar, count) = (&record.name, &cx.names.scalar, cx.rows());
    let bound = cx.paths.item("Scalar");
    let rows = record.fields.iter().flat_map(rows_of);
    let docs = docs::rows(order);
    quote! {
        impl<#scalar: #bound> #name<#scalar> {
            #docs
            #[inline]
            #[must_use]
            pub fn rows(&self) -> [#scalar; #count] { [#(#rows),*] }
        }
    }
}

/// The rows of an output: of a direction the angle, of anything else its components.
fn rows_of(field: &Field) -> Vec<TokenStream> {
    let Shape::Quantity(quantity, order) = field.shape else { return Vec::new() };
    let (name, layout) = (&field.name, quantity.layout(order));
    let angle = layout.parts.len() - layout.rows.len();
    let angle = (angle > 0).then(|| quote!(self.#name.angle()));
    let rest = if angle.is_some() { &layout.parts[2..] } else { layout.parts };
    let rest = rest.iter().map(|part| read(&quote!(self.#name), part));
    angle.into_iter().chain(rest).collect()
}

/// How a plain list becomes the record of several inputs.
fn from_list(cx: &Context<'_>, record: &Record) -> TokenStream {
    let (name, scalar, from) = (&record.name, &cx.names.scalar, cx.paths.item("From"));
    let fields: Vec<_> = record.fields.iter().map(|field| &field.name).collect();
    let count = Literal::usize_unsuffixed(fields.len());
    // Lower-case locals of their own: a field's name may be that of a constant.
    let locals: Vec<_> = (0..fields.len()).map(|i| generated(&format!("q{i}_"))).collect();
    quote! {
        impl<#scalar> #from<[#scalar; #count]> for #name<#scalar> {
            #[inline]
            fn from([#(#locals),*]: [#scalar; #count]) -> Self {
                Self { #(#fields: #locals),* }
            }
        }
    }
}

/// `Linear` for all of them: sums and differences, and tests of every number, field by field.
pub(super) fn linear(cx: &Context<'_>) -> TokenStream {
    let is_other = |kind: Kind| matches!(kind, Kind::Outputs(_) | Kind::Motion);
    let all = &cx.interface.records;
    let others = all.iter().filter(|record| is_other(record.kind));
    let inputs = all.iter().filter(|record| record.kind == Kind::Inputs);
    others.chain(inputs).map(|record| linear_of(cx, record)).collect()
}

fn linear_of(cx: &Context<'_>, record: &Record) -> TokenStream {
    let (scalar, any, linear) =
        (&cx.names.scalar, cx.paths.item("Scalar"), cx.paths.item("Linear"));
    let [factor, other, test] = ["factor_", "other_", "test_"].map(generated);
    let [test_fn, bool_, copy] = ["Fn", "bool", "Copy"].map(|name| cx.paths.item(name));
    let (record, fields) = (&record.name, record.fields.iter().map(|field| &field.name));
    let fields: Vec<_> = fields.collect();
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
