//! The documentation of every search: its interval, its mode, and what it costs.

use super::costs_in_words::{self, MOST};
use crate::codegen::identifiers::text;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::lower::routine::{Lowered, Search};
use crate::model::mechanism::{Mechanism, Mode, Scalar, Sign, Unknown};
use crate::syntax::anatomy::Modes;

/// The entry of each unknown in the documentation of the solver.
pub(super) fn in_words(mechanism: &Mechanism, lowered: &Lowered<'_>) -> Vec<String> {
    let unknowns = mechanism.unknowns.iter().enumerate();
    let of_unknown = |(index, unknown)| Some(of_search(mechanism, lowered.search(index)?, unknown));
    unknowns.filter_map(of_unknown).collect()
}

fn of_search(mechanism: &Mechanism, search: &Search, unknown: &Unknown) -> String {
    let mode = mode(mechanism, unknown);
    let [wide, narrow] = MOST;
    let seed = match unknown.near {
        Some(_) => ", three more for the seed",
        None => "",
    };
    let roots = match search.has_one_root {
        Some(true) => ", one root",
        Some(false) => ", may have several roots",
        None => "",
    };
    format!(
        "`{}`{}, {mode}{roots}: up to {wide} evaluations (f32: {narrow}){seed}, twice as many where an end \
         lies beyond a dead point of the equation; each of {}",
        text(&unknown.name),
        ends(unknown),
        costs_in_words::in_words(search.cost),
    )
}

/// `rising`, `falling` or the parameter that says which.
pub(super) fn mode(mechanism: &Mechanism, unknown: &Unknown) -> String {
    let [plus, minus] = Modes::Trend.words();
    match unknown.mode {
        Mode::Fixed(Sign::Plus) => plus.to_string(),
        Mode::Fixed(Sign::Minus) => minus.to_string(),
        Mode::Param(param) => {
            format!("{plus} or {minus} by `{}`", text(&mechanism.params[param.index()].name))
        }
    }
}

/// The interval of the search if its ends are constant, and the unit.
fn ends(unknown: &Unknown) -> String {
    let unit = unit(unknown.dimension, Order::Position);
    match &unknown.between {
        [Scalar::Constant(from), Scalar::Constant(to)] => {
            format!(" from {:.6} to {:.6} {unit}", from.to_f64(), to.to_f64())
        }
        _ => format!(" in {unit}"),
    }
}
