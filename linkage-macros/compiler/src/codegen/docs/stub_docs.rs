//! Docs of the stub of a declaration with mistakes: the user's comments, and kinds as they are
//! written. Costs, ranges, units and what else follows from the whole declaration are unknown.

use proc_macro2::TokenStream;
use quote::quote;

use super::doc_comments::{after, lines};
use crate::codegen::identifiers::text;
use crate::interface::entries::Entry;
use crate::interface::force_records::path;
use crate::interface::quantity::Order;
use crate::interface::records::{Field, Subject};
use crate::interface::units_in_words::unit;
use crate::model::mechanism::{DeclaredOutput, Dimension, Mechanism, OutputKind, Param, ParamKind};

const WITH_MISTAKES: &str = "Stands in for the solver while its declaration has mistakes.";

pub(super) fn solver(mechanism: &Mechanism) -> TokenStream {
    after(&mechanism.docs, WITH_MISTAKES)
}

pub(super) fn param(param: &Param) -> TokenStream {
    let what = match param.kind {
        ParamKind::Number { .. } => "Parameter",
        ParamKind::Mode { .. } => "Mode",
    };
    after(&param.docs, &format!("{what} `{}`.", text(&param.name)))
}

/// A field of a record whose docs depend on the declaration; `None` for the others.
pub(super) fn field(mechanism: &Mechanism, field: &Field) -> Option<TokenStream> {
    Some(match field.subject {
        Subject::Input(index) => {
            let input = &mechanism.inputs[index];
            after(&input.docs, &given("Input", &text(&input.name), input.dimension))
        }
        Subject::Load(index) => {
            let load = &mechanism.dynamics.loads[index];
            after(&load.docs, &given("Load", &text(&load.name), load.dimension))
        }
        Subject::Effort(index) => {
            let asked = &mechanism.dynamics.asked[index];
            after(&asked.docs, &format!("`{}`.", path(asked)))
        }
        Subject::Output(index, _) => output(mechanism, &mechanism.outputs[index]),
        _ => return None,
    })
}

/// The unit of a kind that was understood.
fn given(what: &str, name: &str, dimension: Dimension) -> String {
    match dimension {
        Dimension::NUMBER => format!("{what} `{name}`."),
        _ => format!("{what} `{name}` in {}.", unit(dimension, Order::Position)),
    }
}

fn output(mechanism: &Mechanism, output: &DeclaredOutput) -> TokenStream {
    let name = text(&output.field);
    match output.kind {
        OutputKind::Point(point) => {
            after(&mechanism.points[point.index()].docs, &format!("Point `{name}`."))
        }
        OutputKind::Link { link, .. } => {
            after(&mechanism.links[link.index()].docs, &format!("Link `{name}`."))
        }
        _ => lines(&format!("Output `{name}`.")),
    }
}

/// A function of an entry point.
pub(super) fn entry(entry: &Entry) -> TokenStream {
    lines(&format!("{}.", entry.point.row().subject))
}

/// `COST`, whose numbers are zeros.
pub(super) fn cost() -> TokenStream {
    quote!(#[doc = " Unknown while the declaration has mistakes."])
}
