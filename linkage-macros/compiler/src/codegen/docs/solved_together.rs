//! The groups that were found in a drawing where some are solved at once: a list in words, since no declaration says them.

use super::ranges_in_words::goes;
use crate::model::as_drawn::Stretch;
use crate::model::mechanism::{Carrier, Mechanism, PointId, Step, Tracked};

/// The list, with the statements at each place of the others, and how far the groups that are solved at once are certified.
pub(super) fn lines(
    mechanism: &Mechanism,
    mut others: impl FnMut(usize) -> Vec<String>,
) -> Vec<String> {
    let mut lines = vec![
        " The links and joints of the drawing are these drivers and groups, one behind the other. The list is no declaration: \
         no statement by hand solves several unknowns at once."
            .to_string(),
        String::new(),
    ];
    let mut place = 0;
    while place <= mechanism.steps.len() {
        let tracked = mechanism.tracked.iter().find(|tracked| tracked.steps[0] == place);
        if let Some(tracked) = tracked {
            lines.push(format!(" - {}", together(mechanism, tracked)));
            place = tracked.steps[1];
        } else {
            let statements = others(place).into_iter();
            lines.extend(statements.map(|said| format!(" - `{}`", said.trim_end_matches(';'))));
            place += 1;
        }
    }
    lines
        .extend(mechanism.tracked.iter().flat_map(|group| [String::new(), solved_together(group)]));
    lines
}

/// The links of a group, and where it closes.
fn together(mechanism: &Mechanism, tracked: &Tracked) -> String {
    let [from, to] = tracked.steps;
    let links = mechanism.steps[from..to].iter().filter_map(|step| match step {
        Step::Group(group) => Some(&group.links),
        _ => None,
    });
    let links = links.flatten().map(|link| format!("`{}`", mechanism.links[link.index()].name));
    let closings = tracked.closings.iter().map(|closing| {
        let [made, met] = closing.points;
        let made = &mechanism.points[made.index()].name;
        match link_of(mechanism, met) {
            Some(link) => format!("`{made}` on `{link}`"),
            None => format!("`{made}`"),
        }
    });
    format!(
        "{} together, so that they meet at {}",
        links.collect::<Vec<_>>().join(", "),
        closings.collect::<Vec<_>>().join(", ")
    )
}

/// The link on which a point is placed.
fn link_of(mechanism: &Mechanism, searched: PointId) -> Option<String> {
    mechanism.steps.iter().find_map(|step| match step {
        Step::Point { point, carrier: Carrier::Link(link), .. } if *point == searched => {
            Some(mechanism.links[link.index()].name.to_string())
        }
        _ => None,
    })
}

/// The unknowns that are solved at once, and how far.
fn solved_together(tracked: &Tracked) -> String {
    let names: Vec<_> =
        tracked.fit.unknowns.iter().map(|unknown| format!("`{}`", unknown.name)).collect();
    let stretch =
        Stretch { input: None, ends: tracked.fit.stretch(), is_angle: tracked.fit.is_turned };
    format!(
        " {} are solved at once, by steps of Newton's method that are certified while {} about the drawing.",
        names.join(", "),
        goes(&stretch)
    )
}
