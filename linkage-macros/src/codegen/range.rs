//! What the dimensions say about the turn of a crank, in words.

use super::context::Context;
use super::names::text;
use crate::model::turning::{Range, Turning};

/// Over which angles a crank turns, why, and what happens at change points.
pub(super) fn in_words(cx: &Context<'_>, turning: &Turning) -> String {
    let group = &cx.mechanism.groups[turning.group.index()];
    let crank = text(&cx.mechanism.links[turning.crank.index()].name);
    let angle = match turning.input {
        Some(input) => text(&cx.mechanism.inputs[input.index()].name),
        None => format!("{crank}.angle"),
    };
    let range = match &turning.range {
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
    let mut line = format!("{} {}: {range}; {}", group.keyword, group.title, turning.reason);
    if !turning.change_points.is_empty() {
        let angles: Vec<_> = turning.change_points.iter().copied().map(degrees).collect();
        let angles = angles.join(" and ");
        line += &format!(
            ". At `{angle}` = {angles} both assembly modes are one: velocities are `Singular` there, \
             and a constant mode does not follow the motion through; `Tracker` does"
        );
    }
    if turning.is_parallelogram {
        line += &format!(
            ". These are the lengths of a parallelogram, which a constant mode turns into an \
             antiparallelogram: make the rocker a crank with `relative_to: {crank}, angle: 0`"
        );
    }
    line
}

/// An angle to a hundredth of a degree.
fn degrees(angle: f64) -> String {
    let hundredths = (angle * 100.0).round() / 100.0;
    // Adding zero takes the sign off minus zero.
    format!("{}°", hundredths + 0.0)
}
