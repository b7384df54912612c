//! The range of a crank as its dimensions determine it, and how far a drawing was followed, in words.

use crate::codegen::identifiers::text;
use crate::interface::Interface;
use crate::interface::entries::Analysis;
use crate::model::as_drawn::Stretch;
use crate::model::mechanism::{Mechanism, Rotatability, Touching};
use crate::reach::turn::{Range, degrees};

/// Over which angles a crank turns, why, and what happens at change points.
pub(super) fn in_words(
    mechanism: &Mechanism,
    interface: &Interface,
    found: &Rotatability,
) -> String {
    let group = mechanism.statement(found.group);
    let crank = text(&mechanism.links[found.crank.index()].name);
    let angle = match found.input {
        Some(input) => text(&mechanism.inputs[input.index()].name),
        None => format!("{crank}.angle"),
    };
    let range = match &found.turn.range {
        Range::Full => format!("`{crank}` turns fully"),
        Range::Within(intervals) => {
            let words = intervals.iter().map(|[from, to]| match degrees(*to - *from).as_str() {
                "0°" => format!("at {} alone", degrees(*from)),
                _ => format!("from {} to {}", degrees(*from), degrees(*to)),
            });
            format!("`{angle}` {}", words.collect::<Vec<_>>().join(" or "))
        }
        Range::Never => "never".to_string(),
    };
    let mut line = format!("{group}: {range}; {}", found.reason);
    let forward = Analysis::ForwardDynamics.by_value();
    let moves_under_forces = interface.find(forward).is_some();
    if !found.turn.change_points.is_empty() {
        line += ". At ";
        line += &change_points(&angle, &found.turn.change_points, moves_under_forces);
    }
    let has_ends = matches!(found.turn.range, Range::Within(_));
    if has_ends && found.input.is_some() && moves_under_forces {
        line += &format!(
            ". The ends are dead points of `{angle}`: `{}` is `Singular` there, and the mass \
             that `{angle}` moves grows beyond bounds towards them; take a crank that turns fully as input",
            forward.name()
        );
    }
    if found.is_parallelogram {
        line += IS_PARALLELOGRAM;
    }
    line
}

const IS_PARALLELOGRAM: &str = ". These are the lengths of a parallelogram, which `left` or `right` turns into an \
                                antiparallelogram: `mode: parallel` keeps it one";

/// The course of the motion where an angle has these values.
fn change_points(angle: &str, values: &[f64], moves_under_forces: bool) -> String {
    let values: Vec<_> = values.iter().copied().map(degrees).collect();
    let mut line = format!(
        "`{angle}` = {} both assembly modes are one: velocities are `Singular` there, \
         and a constant mode does not follow the motion through; `Tracker` does",
        values.join(" and ")
    );
    if moves_under_forces {
        line += ". Integrated by `state_rates` alone, a motion under forces jumps there to other \
                 velocities and another energy: ask through `Tracker::follow`";
    }
    line
}

/// The change points of a group that does not stand on a crank of the ground.
pub(super) fn of_touching(
    mechanism: &Mechanism,
    interface: &Interface,
    found: &Touching,
) -> String {
    let angle = text(&mechanism.inputs[0].name);
    let moves_under_forces = interface.find(Analysis::ForwardDynamics.by_value()).is_some();
    let group = mechanism.statement(found.group);
    let mut line =
        format!("{group}: at {}", change_points(&angle, &found.inputs, moves_under_forces));
    if found.is_parallelogram {
        line += IS_PARALLELOGRAM;
    }
    line
}

/// The way of an input, or of the first drive.
pub(super) fn goes(Stretch { input, ends, is_angle }: &Stretch) -> String {
    let [from, to] = match is_angle {
        true => ends.map(|end| format!("{:.1}°", end.to_degrees() + 0.0)),
        // A machine may be small, and an end next to the drawing.
        false => ends.map(|end| match end.abs() {
            size if size > 0.0 && size < 5e-4 => format!("{end:.1e} m"),
            _ => format!("{:.3} m", end + 0.0),
        }),
    };
    let who = input.as_ref().map_or("the first drive".to_string(), |input| format!("`{input}`"));
    format!("{who} goes from {from} to {to}")
}
