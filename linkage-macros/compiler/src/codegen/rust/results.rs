//! The construction of a result from its numbers, and the reading of the numbers from a result.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::paths::Paths;
use crate::codegen::identifiers::generated;
use crate::codegen::text::Text;
use crate::interface::Interface;
use crate::interface::components::Component;
use crate::interface::quantity::{Layout, QuantityPart};
use crate::interface::records::Shape;

/// The type of a result, for numbers of this type.
pub(super) fn ty(
    interface: &Interface,
    paths: &Paths,
    shape: Shape,
    scalar: &TokenStream,
) -> TokenStream {
    match shape {
        Shape::Record(id) => {
            let name = &interface.record(id).name;
            quote!(#name<#scalar>)
        }
        Shape::Quantity(quantity, order) => match quantity.layout(order).record {
            Some(record) => {
                let record = paths.outside(record);
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

/// An answer with something else in place of its result. `?` or a closure would be shorter to read, and
/// more for rustc to check.
pub(super) fn in_place(
    paths: &Paths,
    answer: &TokenStream,
    other: impl FnOnce(&Ident) -> TokenStream,
) -> TokenStream {
    let [ok, err] = ["Ok", "Err"].map(|item| paths.item(item));
    let [result, error] = ["result_", "error_"].map(generated);
    let other = other(&result);
    quote!(match #answer { #ok(#result) => #ok(#other), #err(#error) => #err(#error) })
}

/// Writes a result of its numbers, of which each call of `next` writes one.
pub(super) fn assemble(
    interface: &Interface,
    paths: &Paths,
    shape: Shape,
    to: &mut Text,
    next: &mut dyn FnMut(&mut Text),
) {
    match shape {
        Shape::Number => next(to),
        Shape::List(count) => {
            to.put("[").list(0..count, |to, _| next(to)).put("]");
        }
        Shape::Quantity(quantity, order) => quantity_of(paths, quantity.layout(order), to, next),
        Shape::Matrix { rows, columns } => {
            // The numbers come column by column.
            let values = (0..rows * columns).map(|_| {
                let mut value = Text::default();
                next(&mut value);
                value
            });
            let values: Vec<Text> = values.collect();
            let row = |to: &mut Text, row: usize| {
                let row = (0..columns).map(|column| &values[column * rows + row]);
                to.put("[").list(row, |to, value| to.append(value)).put("]");
            };
            to.put("[").list(0..rows, row).put("]");
        }
        Shape::Record(id) => {
            let record = interface.record(id);
            to.put(&record.name.to_string()).put(" { ");
            to.list(&record.fields, |to, field| {
                to.put(&field.name.to_string()).put(": ");
                assemble(interface, paths, field.shape, to, next);
            });
            to.put(" }");
        }
    }
}

fn quantity_of(paths: &Paths, layout: &Layout, to: &mut Text, next: &mut dyn FnMut(&mut Text)) {
    let Some(record) = layout.record else {
        return layout.parts.iter().for_each(|_| next(to));
    };
    to.put(&paths.written(record)).put(" { ");
    to.list(layout.parts, |to, part| to.field(part.field, &mut *next)).put(" }");
}

/// The numbers of a result, in the order in which [`assemble`] takes them.
pub(super) fn components(interface: &Interface, shape: Shape, result: &str) -> Vec<String> {
    let written = |step: &Component| match step {
        Component::Field(name) => format!(".{name}"),
        Component::Index(at) => format!("[{at}]"),
    };
    let ways = interface.components(shape).into_iter();
    ways.map(|way| result.to_string() + &way.iter().map(written).collect::<String>()).collect()
}

/// A component of a record; of a plain number the number itself.
pub(super) fn read(record: &str, part: &QuantityPart) -> String {
    match part.field {
        "" => record.to_string(),
        field => format!("{record}.{field}"),
    }
}
