//! Messages about drawings that cannot be cut.

use crate::chain::Trouble;
use crate::chain::assembly_list::OtherAssembly;
use crate::chain::cutting::{Dyad, Pair};
use crate::chain::machine::{GROUND, Machine};
use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{Declaration, DriveStatement, StatementKind};

use crate::model::acting::RequestedEffort;
use crate::model::as_written::text;
use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::listed_assemblies::angle_in_words;
use crate::model::drawn::outline::loose;
use crate::model::mechanism::Mechanism;
use crate::model::names::listed;

/// The least sine by which a drawing tells the two sides of a dyad apart. Drawn to four digits, a
/// point is off by half of this of its distance.
pub(in crate::model::drawn) const LEAST_SINE: f64 = 1e-4;

/// Reports what is wrong with the counts of bodies and joints.
pub(in crate::model::drawn) fn report(
    bodies: &Bodies<'_>,
    trouble: &Trouble,
    diagnostics: &mut Diagnostics,
) {
    match trouble {
        Trouble::TooMany { bodies: those, drives, freedoms } => {
            too_many(bodies, (those, drives, *freedoms), diagnostics);
        }
        Trouble::Loose { bodies: those, freedoms } => {
            loose::loose(bodies, those, *freedoms, diagnostics);
        }
        Trouble::Undecided { bodies: those }
        | Trouble::Loaded { bodies: those }
        | Trouble::AtDeadPoint { bodies: those }
        | Trouble::AtLimits { bodies: those, .. }
        | Trouble::NotAlone { bodies: those, .. } => {
            let Some(link) = bodies.last_link(those) else { return };
            let (message, reason) = of_a_group(bodies, (those, trouble));
            diagnostics.error_because(link.span(), message, reason);
        }
    }
}

/// The message about a group of class III that is not solved, and what to do.
fn of_a_group(
    bodies: &Bodies<'_>,
    (those, trouble): (&[usize], &Trouble),
) -> (String, &'static str) {
    let all = bodies.listed(those);
    match trouble {
        Trouble::Loaded { .. } => (
            format!(
                "{all} are one group that no single unknown solves: what pushes in its joints is not known yet"
            ),
            "leave out masses and what acts, and the group is solved; or drive another joint",
        ),
        Trouble::AtDeadPoint { .. } => (
            format!("in the drawing {all} are at a dead point, or next to one"),
            "two ways to assemble them come together there: draw another pose",
        ),
        Trouble::AtLimits { dyad, .. } => {
            let [a, b] = dyad.map(|body| bodies.name(body));
            let message = format!(
                "however {all} are taken apart, two links stand in the drawing where their modes come together, \
                 as {a} and {b} do"
            );
            (
                message,
                "two bars are in one line there, or a bar is square to its guide: draw another pose",
            )
        }
        Trouble::NotAlone { other, .. } => {
            let other = other.as_ref().map_or(String::new(), |OtherAssembly { body, turned }| {
                format!(", {} turned by {}", bodies.name(*body), angle_in_words(*turned))
            });
            (
                format!("{all} can be assembled in another way close to the drawing{other}"),
                "no interval of an unknown holds the drawing alone: draw a pose where the two are farther \
                 apart, or declare the groups with `unknown` and `solve`",
            )
        }
        _ => (
            format!("{all} are one group of class III or higher"),
            "drive another joint, so that each pair of links stands on what is known; or declare \
             the groups with `unknown` and `solve`",
        ),
    }
}

fn too_many(
    bodies: &Bodies<'_>,
    (those, drives, freedoms): (&[usize], &[usize], usize),
    diagnostics: &mut Diagnostics,
) {
    if set_drives_too_much(bodies, (those, drives), diagnostics) {
        return;
    }
    let values = drives.iter().map(|&drive| bodies.drives[drive].1);
    let written = values.clone().map(|drive| format!("`drive {}`", drive_as_written(drive)));
    let written: Vec<_> = written.collect();
    let Some(link) = bodies.last_link(those) else { return };
    let who = bodies.listed(those);
    if freedoms > 0 && freedoms < drives.len() {
        let values: Vec<_> =
            values.clone().map(|drive| format!("`{}`", text(&drive.value))).collect();
        let at = values_span(bodies, drives).unwrap_or(link.span().into());
        let freedom = if freedoms == 1 { "one freedom" } else { &format!("{freedoms} freedoms") };
        // Several drives by one input are told apart by their links.
        let is_repeated = (1..values.len()).any(|index| values[..index].contains(&values[index]));
        let (names, what) = if is_repeated { (&written, "drive") } else { (&values, "input") };
        let several = if drives.len() == 1 { "" } else { "s" };
        let message = format!(
            "{} fight: {who} have {freedom} and {} {what}{several}",
            listed(names, "and"),
            drives.len()
        );
        diagnostics.error_because(at, message, format!("leave out {}", listed(&written, "or")));
        return;
    }
    if let Some(bar) = parallel_bar(&bodies.machine, those) {
        let name = bodies.link(bar).name;
        let message = format!(
            "`{name}` is one bar too many by count, but these bars are parallel and equal, so it moves"
        );
        let reason = format!("leave out `link {name}`; two points draw it");
        diagnostics.error_because(name.span(), message, reason);
        return;
    }
    let without = match written.is_empty() {
        true => String::new(),
        false => format!(" without {}", listed(&written, "and")),
    };
    let message = format!("{who} hold each other{without}: one constraint too many");
    let drives = written.iter().map(|drive| format!(" or {drive}")).collect::<String>();
    // A point that inputs move has no joints of its own, nor has what stands for a quantity.
    let is_link = those.iter().any(|&body| bodies.is_drawn(body) && bodies.link(body).name == link);
    let joints = if is_link { ", or one of its joints" } else { "" };
    let reason = format!("leave out `link {link}`{joints}{drives}");
    diagnostics.error_because(link.span(), message, reason);
}

/// Reports a set of inputs that moves links more than once; false where there is none or nothing there is driven.
fn set_drives_too_much(
    bodies: &Bodies<'_>,
    (those, drives): (&[usize], &[usize]),
    diagnostics: &mut Diagnostics,
) -> bool {
    let Some(set) = &bodies.tree.unwritten.set else { return false };
    let moved = those.iter().filter(|&&body| body != GROUND && !bodies.is_drawn(body));
    let links = moved.map(|&body| format!("`link {}`", bodies.link(body).name));
    let drives = drives.iter().map(|&drive| bodies.drives[drive].1);
    let drives = drives.map(|drive| format!("`drive {}`", drive_as_written(drive)));
    let told: Vec<_> = links.chain(drives).collect();
    if told.is_empty() {
        return false;
    }
    let message = format!("`{set}` drives more than the machine's freedoms");
    let who = bodies.listed(those);
    let reason = format!("{who} hold each other; leave out {}", listed(&told, "or"));
    diagnostics.error_because(set.span(), message, reason);
    true
}

/// The left side of a drive.
pub(in crate::model::drawn) fn drive_as_written(drive: &DriveStatement) -> String {
    let (link, member) =
        drive.written.as_ref().map_or((&drive.link, &drive.member), |(link, of)| (link, of));
    let own = format!("{link}.{member}");
    match &drive.to {
        Some((to, member)) => format!("{own} - {to}.{member}"),
        None => own,
    }
}

/// The last bar that is parallel and equal to two others between the same two bodies: it holds nothing
/// that these do not.
fn parallel_bar(machine: &Machine, those: &[usize]) -> Option<usize> {
    /// The part of the machine's size by which drawings of one length differ.
    const SAME: f64 = 1e-9;
    let off = SAME * machine.size();
    let bar = |body: usize| -> Option<[usize; 2]> {
        machine.bodies[body].pins[..].try_into().ok().filter(|_| body != GROUND)
    };
    let both_ways = |[p, q]: [usize; 2]| [[p, q], [q, p]];
    let vector = |[p, q]: [usize; 2]| machine.pins[q] - machine.pins[p];
    // The bodies that both ends of a bar are pinned to.
    let ends = |body: usize, [p, q]: [usize; 2]| {
        let others = |pin: usize| {
            machine
                .at(pin)
                .filter(|other| *other != body && those.contains(other))
                .collect::<Vec<_>>()
        };
        let (at_p, at_q) = (others(p), others(q));
        at_p.into_iter()
            .flat_map(move |a| at_q.clone().into_iter().map(move |b| [a, b]))
            .collect::<Vec<_>>()
    };
    let holds_nothing = |&body: &usize| {
        let Some(own) = bar(body) else { return false };
        ends(body, own).into_iter().any(|between| {
            let is_same = |other: usize| {
                let pins = bar(other).filter(|_| other != body);
                pins.into_iter().flat_map(both_ways).any(|pins| {
                    let is_equal = (vector(pins) - vector(own)).length() < off;
                    is_equal && ends(other, pins).contains(&between)
                })
            };
            those.iter().filter(|&&other| is_same(other)).count() > 1
        })
    };
    those.iter().copied().rev().find(|body| holds_nothing(body))
}

/// Where the last of some drives stands.
fn values_span(bodies: &Bodies<'_>, drives: &[usize]) -> Option<crate::diagnostics::Extent> {
    drives.last().map(|&drive| bodies.drives[drive].1.value.span)
}

/// Reports forces in joints that were asked for where bars stand for links that a drive holds together.
pub(in crate::model::drawn) fn report_held_reactions(
    tree: &Declaration,
    mechanism: &Mechanism,
    diagnostics: &mut Diagnostics,
) {
    if !tree.statements.iter().any(
        |statement| matches!(&statement.kind, StatementKind::Output(output) if !output.is_beside),
    ) {
        return;
    }
    let dynamics = &mechanism.dynamics;
    let asked = dynamics.asked.iter().filter(|asked| !dynamics.is_of_power(asked.effort));
    let input = mechanism.inputs.first().map(|input| format!("; ask for `{}.drive`", input.name));
    for asked @ RequestedEffort { field, .. } in asked {
        let path = asked.path();
        let message = format!(
            "`{path}` is not known where a drive holds two moving links together{}",
            input.as_deref().unwrap_or_default()
        );
        let reason = "one bar stands for both links in their group, and what pushes in its joints is not \
                      what pushes in theirs";
        diagnostics.error_because(field.span(), message, reason);
    }
}

/// Reports a dyad whose two sides the drawing does not tell apart.
pub(in crate::model::drawn) fn report_limit(
    bodies: &Bodies<'_>,
    dyad: &Dyad,
    diagnostics: &mut Diagnostics,
) {
    let [a, b] = dyad.legs.each_ref().map(|leg| leg.bodies[0]);
    let [first, second] = [a, b].map(|body| bodies.name(body));
    let message = match (dyad.legs[0].outer, dyad.inner, dyad.legs[1].outer) {
        (Pair::Pin(_), Pair::Pin(_), Pair::Pin(_)) => {
            let are = if dyad.carried.is_empty() { "in one line" } else { "parallel" };
            format!(
                "in the drawing {first} and {second} are {are}: `left` and `right` come together there"
            )
        }
        (Pair::Pin(_), Pair::Pin(_), Pair::Slide(_)) => {
            format!(
                "in the drawing {first} stands square to its guide: `ahead` and `behind` come together there"
            )
        }
        (Pair::Pin(_), Pair::Slide(_), Pair::Pin(_)) => {
            format!(
                "in the drawing {first} is at the foot of {second}: `ahead` and `behind` come together there"
            )
        }
        _ => format!(
            "in the drawing {first} and {second} slide along one line: they are held by nothing there"
        ),
    };
    diagnostics.error_because(bodies.link(b).name.span(), message, "draw another pose");
}
