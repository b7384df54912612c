//! How a result is made of its numbers, and how they are read from it again.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::context::Context;
use super::identifiers::function_name;
use super::token_list::Tokens;
use crate::interface::quantity::{Layout, Part};
use crate::interface::records::Shape;

/// The type of a result, for numbers of this type.
pub(super) fn ty(cx: &Context<'_>, shape: Shape, scalar: &TokenStream) -> TokenStream {
    match shape {
        Shape::Record(id) => {
            let name = &cx.record(id).name;
            quote!(#name<#scalar>)
        }
        Shape::Quantity(quantity, order) => match quantity.layout(order).record {
            Some(record) => {
                let record = cx.paths.outside(record);
                quote!(#record<#scalar>)
            }
            None => scalar.clone(),
        },
        Shape::Number => scalar.clone(),
        Shape::List(count) => {
            let count = Literal::usize_unsuffixed(count);
            quote!([#scalar; #count])
        }
        Shape::Matrix { rows, columns } => {
            let [rows, columns] = [rows, columns].map(Literal::usize_unsuffixed);
            quote!([[#scalar; #columns]; #rows])
        }
    }
}

/// A result from its numbers, which are taken off the front.
pub(super) fn assemble(
    cx: &Context<'_>,
    shape: Shape,
    values: &mut impl Iterator<Item = Tokens>,
) -> TokenStream {
    match shape {
        Shape::Number => values.take(1).map(|value| quote!(#value)).collect(),
        Shape::List(count) => {
            let values = values.take(count);
            quote!([#(#values),*])
        }
        Shape::Quantity(quantity, order) => quantity_of(cx, quantity.layout(order), values),
        Shape::Matrix { rows, columns } => {
            // The numbers come column by column.
            let values: Vec<_> = values.take(rows * columns).collect();
            let rows = (0..rows).map(|row| {
                let row = (0..columns).map(|column| &values[column * rows + row]);
                quote!([#(#row),*])
            });
            quote!([#(#rows),*])
        }
        Shape::Record(id) => {
            let record = cx.record(id);
            let name = &record.name;
            let fields = record.fields.iter().map(|field| {
                let (name, value) = (&field.name, assemble(cx, field.shape, values));
                quote!(#name: #value)
            });
            let fields: Vec<_> = fields.collect();
            quote!(#name { #(#fields),* })
        }
    }
}

fn quantity_of(
    cx: &Context<'_>,
    layout: &Layout,
    values: &mut impl Iterator<Item = Tokens>,
) -> TokenStream {
    let parts = layout.parts.iter().zip(values.take(layout.parts.len()));
    let Some(record) = layout.record else {
        return parts.map(|(_, value)| quote!(#value)).collect();
    };
    let record = cx.paths.item(record);
    let parts = parts.map(|(part, value)| given(part.field, &value));
    quote!(#record { #(#parts),* })
}

/// A field and its value, once where both have one name.
fn given(field: &str, value: &Tokens) -> TokenStream {
    let name = function_name(field);
    if value.is(field) { quote!(#name) } else { quote!(#name: #value) }
}

/// The numbers of a result, in the order in which [`assemble`] takes them.
pub(super) fn components(cx: &Context<'_>, shape: Shape, result: &TokenStream) -> Vec<TokenStream> {
    match shape {
        Shape::Number => vec![result.clone()],
        Shape::List(count) => {
            let index = (0..count).map(Literal::usize_unsuffixed);
            index.map(|index| quote!(#result[#index])).collect()
        }
        Shape::Quantity(quantity, order) => {
            let parts = quantity.layout(order).parts.iter();
            parts.map(|part| read(result, part)).collect()
        }
        Shape::Matrix { rows, columns } => {
            let index = Literal::usize_unsuffixed;
            let entry = |column, row| {
                let (column, row) = (index(column), index(row));
                quote!(#result[#row][#column])
            };
            (0..columns).flat_map(|c| (0..rows).map(move |r| entry(c, r))).collect()
        }
        Shape::Record(id) => {
            let fields = cx.record(id).fields.iter();
            let of = |field: &crate::interface::records::Field| {
                let name = &field.name;
                components(cx, field.shape, &quote!(#result.#name))
            };
            fields.flat_map(of).collect()
        }
    }
}

/// A component of a record; of a plain number the number itself.
pub(super) fn read(record: &TokenStream, part: &Part) -> TokenStream {
    if part.field.is_empty() {
        return record.clone();
    }
    let field: Ident = function_name(part.field);
    quote!(#record.#field)
}
