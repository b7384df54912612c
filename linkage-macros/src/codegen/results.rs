//! The records that entry points take and return.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::pieces::Pieces;
use super::{Context, docs};
use crate::ir::program::EntryKind;
use crate::model::mechanism::{Output, OutputKind, Shape};

/// How often a record's components were differentiated by time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    Position,
    Velocity,
    Acceleration,
}

impl Order {
    pub(super) const ALL: [Self; 3] = [Self::Position, Self::Velocity, Self::Acceleration];

    pub(super) fn record<'a>(self, cx: &'a Context<'_>) -> &'a Ident {
        match self {
            Self::Position => &cx.names.position,
            Self::Velocity => &cx.names.velocity,
            Self::Acceleration => &cx.names.acceleration,
        }
    }

    /// The field of a motion that holds the record.
    pub(super) fn field(self) -> &'static str {
        match self {
            Self::Position => "position",
            Self::Velocity => "velocity",
            Self::Acceleration => "acceleration",
        }
    }

    /// The run-time type of a shape and its fields; no type for a plain number.
    pub(super) fn fields(self, shape: Shape) -> (Option<&'static str>, &'static [&'static str]) {
        match (shape, self) {
            (Shape::Point, _) => (Some("Point"), &["x", "y"]),
            (Shape::Slide, _) => (Some("Slide"), &["slide"]),
            (Shape::Value, _) => (None, &[""]),
            (Shape::Direction, Self::Position) => (Some("Direction"), &["cos", "sin"]),
            (Shape::Direction, Self::Velocity) => (Some("AngularVelocity"), &["omega"]),
            (Shape::Direction, Self::Acceleration) => (Some("AngularAcceleration"), &["alpha"]),
            (Shape::SlidingDirection, Self::Position) => {
                (Some("SlidingDirection"), &["cos", "sin", "slide"])
            }
            (Shape::SlidingDirection, Self::Velocity) => {
                (Some("SlidingVelocity"), &["omega", "slide"])
            }
            (Shape::SlidingDirection, Self::Acceleration) => {
                (Some("SlidingAcceleration"), &["alpha", "slide"])
            }
        }
    }
}

impl Output {
    /// Whether the output also exists where the pose does not.
    pub(super) fn is_margin(&self) -> bool {
        matches!(self.kind, OutputKind::Margin(_) | OutputKind::Transmission(_))
    }
}

/// All records of a mechanism.
pub(super) fn definitions(cx: &Context<'_>) -> TokenStream {
    let input = (cx.mechanism.inputs.len() > 1).then(|| input(cx));
    let orders = Order::ALL.map(|order| record(cx, order));
    let (motion, margins) = (motion(cx), cx.entry(EntryKind::Margins).map(|_| margins(cx)));
    quote!(#input #(#orders)* #motion #margins)
}

/// What can be done with them.
pub(super) fn implementations(cx: &Context<'_>) -> TokenStream {
    let from = (cx.mechanism.inputs.len() > 1).then(|| input_from_list(cx));
    let rows = Order::ALL.map(|order| rows(cx, order));
    quote!(#from #(#rows)*)
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

fn record(cx: &Context<'_>, order: Order) -> TokenStream {
    let (name, scalar, visibility) = (order.record(cx), &cx.names.scalar, &cx.mechanism.visibility);
    let (docs, attributes) = (docs::record(cx, order), attributes(cx));
    let fields = cx.mechanism.outputs.iter().map(|output| {
        let (docs, field) = (docs::output(cx, output, order), &output.field);
        let ty = match order.fields(output.kind.shape()).0 {
            Some(ty) => {
                let ty = cx.paths.outside(ty);
                quote!(#ty<#scalar>)
            }
            None => quote!(#scalar),
        };
        quote!(#docs pub #field: #ty)
    });
    quote! {
        #docs
        #attributes
        #visibility struct #name<#scalar> { #(#fields),* }
    }
}

/// `rows()`: the record as a list, in the order of `OUTPUTS`.
fn rows(cx: &Context<'_>, order: Order) -> TokenStream {
    let (name, scalar, count) = (order.record(cx), &cx.names.scalar, cx.rows());
    let bound = cx.paths.item("Scalar");
    let rows = cx.mechanism.outputs.iter().flat_map(|output| {
        let field = &output.field;
        let (_, parts) = order.fields(output.kind.shape());
        let angle = parts.starts_with(&["cos", "sin"]).then(|| quote!(self.#field.angle()));
        let rest = if angle.is_some() { &parts[2..] } else { parts };
        let rest = rest.iter().map(move |part| read(field, part));
        angle.into_iter().chain(rest)
    });
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

fn read(field: &Ident, part: &str) -> TokenStream {
    if part.is_empty() {
        return quote!(self.#field);
    }
    let part = Ident::new(part, proc_macro2::Span::call_site());
    quote!(self.#field.#part)
}

fn motion(cx: &Context<'_>) -> TokenStream {
    let (names, scalar, visibility) = (&cx.names, &cx.names.scalar, &cx.mechanism.visibility);
    let (name, attributes, docs) = (&names.motion, attributes(cx), docs::motion(cx));
    let (position, velocity, acceleration) =
        (&names.position, &names.velocity, &names.acceleration);
    quote! {
        #docs
        #attributes
        #visibility struct #name<#scalar> {
            /// In metres and radians.
            pub position: #position<#scalar>,
            /// In m/s and rad/s.
            pub velocity: #velocity<#scalar>,
            /// In m/s² and rad/s².
            pub acceleration: #acceleration<#scalar>,
        }
    }
}

fn margins(cx: &Context<'_>) -> TokenStream {
    let (name, scalar, visibility) =
        (&cx.names.margins, &cx.names.scalar, &cx.mechanism.visibility);
    let (attributes, docs) = (attributes(cx), docs::margins(cx));
    let fields = cx.mechanism.outputs.iter().filter(|output| output.is_margin()).map(|output| {
        let (docs, field) = (docs::output(cx, output, Order::Position), &output.field);
        quote!(#docs pub #field: #scalar)
    });
    quote! {
        #docs
        #attributes
        #visibility struct #name<#scalar> { #(#fields),* }
    }
}

/// The record of several inputs.
fn input(cx: &Context<'_>) -> TokenStream {
    let (name, scalar, visibility) = (&cx.names.input, &cx.names.scalar, &cx.mechanism.visibility);
    let (attributes, docs) = (attributes(cx), docs::input_record(cx));
    let fields = cx.mechanism.inputs.iter().map(|input| &input.name);
    let field_docs = cx.mechanism.inputs.iter().map(docs::input);
    quote! {
        #docs
        #attributes
        #visibility struct #name<#scalar> { #(#field_docs pub #fields: #scalar),* }
    }
}

/// How a plain list becomes the record of several inputs.
fn input_from_list(cx: &Context<'_>) -> TokenStream {
    let (name, scalar, from) = (&cx.names.input, &cx.names.scalar, cx.paths.item("From"));
    let fields: Vec<_> = cx.mechanism.inputs.iter().map(|input| &input.name).collect();
    let count = cx.columns();
    // Lower-case locals of their own: a field's name may be that of a constant.
    let locals: Vec<_> =
        (0..fields.len()).map(|i| super::names::generated(&format!("q{i}_"))).collect();
    quote! {
        impl<#scalar> #from<[#scalar; #count]> for #name<#scalar> {
            #[inline]
            fn from([#(#locals),*]: [#scalar; #count]) -> Self {
                Self { #(#fields: #locals),* }
            }
        }
    }
}

/// The result of an entry point from the values of its sinks.
pub(super) fn assemble(cx: &Context<'_>, kind: EntryKind, values: Vec<Pieces>) -> TokenStream {
    let inputs = cx.mechanism.inputs.len();
    let mut values = values.into_iter();
    match kind {
        EntryKind::Position | EntryKind::PositionAt => record_of(cx, Order::Position, values),
        EntryKind::Velocity | EntryKind::VelocityAt => record_of(cx, Order::Velocity, values),
        EntryKind::Motion | EntryKind::MotionAt => {
            let name = &cx.names.motion;
            let [position, velocity, acceleration] =
                Order::ALL.map(|order| record_of(cx, order, values.by_ref()));
            quote!(#name { position: #position, velocity: #velocity, acceleration: #acceleration })
        }
        EntryKind::Coefficients => {
            // The sinks come an input at a time; a row holds one output's for all inputs.
            let values: Vec<_> = values.collect();
            let count = values.len() / inputs;
            let rows = (0..count).map(|row| {
                let row = (0..inputs).map(|input| &values[input * count + row]);
                quote!([#(#row),*])
            });
            quote!([#(#rows),*])
        }
        EntryKind::Margins => {
            let (name, outputs) = (&cx.names.margins, &cx.mechanism.outputs);
            let fields = outputs.iter().filter(|o| o.is_margin()).map(|output| &output.field);
            quote!(#name { #(#fields: #values),* })
        }
    }
}

/// One record, from as many values as it has components.
pub(super) fn record_of(
    cx: &Context<'_>,
    order: Order,
    mut values: impl Iterator<Item = Pieces>,
) -> TokenStream {
    let name = order.record(cx);
    let fields: Vec<_> = cx
        .mechanism
        .outputs
        .iter()
        .map(|output| {
            let (ty, parts) = order.fields(output.kind.shape());
            let components: Vec<_> = values.by_ref().take(parts.len()).collect();
            let field = &output.field;
            let Some(ty) = ty else { return quote!(#field: #(#components)*) };
            let ty = cx.paths.item(ty);
            let parts = parts.iter().zip(components).map(|(part, value)| given(part, value));
            quote!(#field: #ty { #(#parts),* })
        })
        .collect();
    quote!(#name { #(#fields),* })
}

/// How many components a record has.
pub(super) fn count(cx: &Context<'_>, order: Order) -> usize {
    let shapes = cx.mechanism.outputs.iter().map(|output| output.kind.shape());
    shapes.map(|shape| order.fields(shape).1.len()).sum()
}

/// A field and its value, once where both have one name.
fn given(field: &str, value: Pieces) -> TokenStream {
    let name = Ident::new(field, proc_macro2::Span::call_site());
    if value.is(field) { quote!(#name) } else { quote!(#name: #value) }
}

/// The components of a record, in the order in which [`assemble`] takes them.
pub(super) fn components(cx: &Context<'_>, order: Order, record: &TokenStream) -> Vec<TokenStream> {
    let of = |output: &Output| {
        let field = &output.field;
        let (ty, parts) = order.fields(output.kind.shape());
        let part = |part: &&str| {
            let part = Ident::new(part, proc_macro2::Span::call_site());
            quote!(#record.#field.#part)
        };
        match ty {
            Some(_) => parts.iter().map(part).collect(),
            None => vec![quote!(#record.#field)],
        }
    };
    cx.mechanism.outputs.iter().flat_map(of).collect()
}

/// The components of the result of an entry point, in the order of its sinks.
pub(super) fn components_of(
    cx: &Context<'_>,
    kind: EntryKind,
    result: &TokenStream,
) -> Vec<TokenStream> {
    match kind {
        EntryKind::Position | EntryKind::PositionAt => components(cx, Order::Position, result),
        EntryKind::Velocity | EntryKind::VelocityAt => components(cx, Order::Velocity, result),
        EntryKind::Motion | EntryKind::MotionAt => {
            let of = |order: Order| {
                let part = Ident::new(order.field(), proc_macro2::Span::call_site());
                components(cx, order, &quote!(#result.#part))
            };
            Order::ALL.into_iter().flat_map(of).collect()
        }
        EntryKind::Coefficients => {
            let (inputs, outputs) = (&cx.mechanism.inputs, &cx.mechanism.outputs);
            let rows: usize = outputs.iter().map(|output| output.kind.shape().rates()).sum();
            let index = Literal::usize_unsuffixed;
            let entry = |column, row| {
                let (column, row) = (index(column), index(row));
                quote!(#result[#row][#column])
            };
            (0..inputs.len()).flat_map(|c| (0..rows).map(move |r| entry(c, r))).collect()
        }
        EntryKind::Margins => {
            let outputs = cx.mechanism.outputs.iter().filter(|output| output.is_margin());
            let fields = outputs.map(|output| &output.field);
            fields.map(|field| quote!(#result.#field)).collect()
        }
    }
}
