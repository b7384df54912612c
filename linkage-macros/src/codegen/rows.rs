//! The scalar rows of the outputs, and what errors call a single component of a result.

use proc_macro2::{Literal, Span, TokenStream};
use quote::ToTokens;

use super::Context;
use super::names::text;
use crate::ir::program::EntryKind;
use crate::model::mechanism::{Output, OutputKind, Shape};

/// A string about a user identifier, with its span.
pub(super) fn string(text: &str, span: Span) -> TokenStream {
    let mut literal = Literal::string(text);
    literal.set_span(span);
    literal.into_token_stream()
}

/// The rows of one output, `blade.x` and `blade.y`: as many as its shape has rates.
pub(super) fn of(output: &Output) -> Vec<String> {
    let field = text(&output.field);
    let part = |part: &str| format!("{field}.{part}");
    let ending = |ending: &str| match field.strip_suffix(&format!("_{ending}")) {
        Some(link) => format!("{link}.{ending}"),
        None => field.clone(),
    };
    match (&output.kind, output.kind.shape()) {
        (OutputKind::Margin(_), _) => vec![ending("margin")],
        (OutputKind::Transmission(_), _) => vec![ending("transmission")],
        (OutputKind::Turn(_), _) | (_, Shape::Value) => vec![field],
        (_, Shape::Point) => vec![part("x"), part("y")],
        (_, Shape::Direction) => vec![part("angle")],
        (_, Shape::SlidingDirection) => vec![part("angle"), part("slide")],
        (_, Shape::Slide) => vec![part("slide")],
    }
}

/// All rows.
pub(super) fn names(cx: &Context<'_>) -> Vec<String> {
    cx.mechanism.outputs.iter().flat_map(of).collect()
}

/// All rows, as string literals.
pub(super) fn literals(cx: &Context<'_>) -> Vec<TokenStream> {
    let rows = |output| of(output).into_iter().map(|row| string(&row, output.field.span()));
    cx.mechanism.outputs.iter().flat_map(rows).collect()
}

/// What an error calls each sink of an entry point, in the order of the sinks.
pub(super) fn sink_labels(cx: &Context<'_>, kind: EntryKind) -> Vec<String> {
    let outputs = &cx.mechanism.outputs;
    let rates = |what: &str| -> Vec<String> {
        outputs.iter().flat_map(of).map(|row| format!("{what} of {row}")).collect()
    };
    match kind {
        EntryKind::Position | EntryKind::PositionAt => positions(outputs),
        EntryKind::Velocity | EntryKind::VelocityAt => rates("velocity"),
        EntryKind::Motion | EntryKind::MotionAt => {
            [positions(outputs), rates("velocity"), rates("acceleration")].concat()
        }
        EntryKind::Coefficients => {
            let inputs = cx.mechanism.inputs.iter().map(|input| text(&input.name));
            inputs.flat_map(|input| rates(&format!("coefficient of {input}"))).collect()
        }
        EntryKind::Margins => outputs.iter().filter(|o| o.is_margin()).flat_map(of).collect(),
    }
}

/// The components of the positions: a direction has two of them for its one row.
fn positions(outputs: &[Output]) -> Vec<String> {
    let components = |output| {
        let mut rows = of(output);
        let shape = output.kind.shape();
        if shape.positions() > shape.rates() {
            rows.insert(0, rows[0].clone());
        }
        rows
    };
    outputs.iter().flat_map(components).collect()
}
