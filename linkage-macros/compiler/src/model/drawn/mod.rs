//! Mechanisms as they are drawn: `pin`, `link` and `drive` into drivers and groups.
//!
//! | rooms, each standing on those above it | |
//! |---|---|
//! | `outline` | what is drawn: its frames, lines and bodies, and messages about them |
//! | `reading` | reads these from the statements |
//! | `drive_equations` | the inputs at which the drives are as drawn, and what each moves |
//! | `group_frames` | the frames that groups give links |
//! | `writing` | makes a group of each step of the cut, all in solving order |
//!
//! Between `drive_equations` and `writing` the room `chain` cuts the machine that is drawn. What comes out is resolved by
//! the rules of declared groups, so that there is one meaning of everything. A group may have a slide or a drive the other way round, or
//! measure it from elsewhere: `group_frames` says so, and `drawn_joints` tells the mechanism.

pub mod drive_equations;
mod group_frames;
mod outline;
mod outlined;
pub mod reading;
pub(super) mod writing;

use crate::model::drawn_bodies::Outline;
use proc_macro2::Ident;

use crate::chain;
use crate::chain::cutting::Found;
use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{
    Declaration, LinkStatement, PinStatement, PointStatement, Statement, StatementKind,
};

use super::drawn_links::DrawnLinks;
use super::mechanism::Mechanism;
use outline::bodies::Bodies;
use reading::reader::Reader;
use reading::values::Measured;
pub use reading::values::value as value_at_defaults;
use writing::sorted::Written;

/// A drawing as groups.
struct CutDrawing<'t> {
    items: Vec<Written<'t>>,
    links: DrawnLinks,
    /// The inputs of its pose, where the drives determine them.
    inputs: Option<Vec<f64>>,
    outline: Outline,
}

/// True if anything of the declaration is drawn.
pub(super) fn is_drawn(tree: &Declaration) -> bool {
    tree.statements.iter().any(|statement| is_of_a_drawing(&statement.kind))
}

fn is_of_a_drawing(kind: &StatementKind) -> bool {
    matches!(kind, StatementKind::Pin(_) | StatementKind::Link(_) | StatementKind::Drive(_))
}

/// True if the statement declares one of the points on a link.
fn is_point_of(points: &[Ident], kind: &StatementKind) -> bool {
    matches!(kind, StatementKind::Point(PointStatement { name, on: Some(_), .. }) if points.contains(name))
}

/// The mechanism that a drawing means.
pub(super) fn resolve(tree: &Declaration, diagnostics: &mut Diagnostics) -> Option<Mechanism> {
    let mut values = Measured::of(tree, diagnostics)?;
    let turned = reading::couplings::turned_round(tree, &mut values);
    let CutDrawing { items, links, inputs, outline } =
        cut(turned.as_ref().unwrap_or(tree), values)?;
    let items: Vec<_> = items.iter().map(Written::item).collect();
    let scope = super::walked(tree, &items, diagnostics, Some(&links));
    let mut mechanism = (scope.diagnostics.count() == 0).then_some(scope.mechanism)?;
    mechanism.drawn = inputs;
    mechanism.outline = Some(outline);
    mechanism.as_drawn.is_found = true;
    mechanism.as_drawn.searches = links.searches;
    if links.holds_links {
        // Bars stand for links, so that what pushes in the joints of these is not known.
        outline::messages::report_held_reactions(tree, &mechanism, diagnostics);
        let asked = std::mem::take(&mut mechanism.dynamics.asked);
        mechanism.dynamics.asked = mechanism.dynamics.what_is_of_power(asked);
    }
    for statement in &tree.statements {
        document(&mut mechanism, statement);
    }
    Some(mechanism)
}

/// The drawing as groups; `None` where it is in error, which was reported.
fn cut<'t>(tree: &'t Declaration, mut values: Measured<'_>) -> Option<CutDrawing<'t>> {
    let (mut reader, drives) = Reader::of(tree, &mut values)?;
    if tree.is_damaged {
        // Freedoms are counted from all statements, and one was not understood.
        return None;
    }
    let frames = reading::framing::written(&mut reader)?;
    let mut bodies = reader.machine(drives, frames)?;
    bodies.machine.motions = values.motions(&bodies);
    reading::bare_links::note_slight_offsets(&bodies, values.scope.diagnostics);
    reading::shared_params::note_params_of_pins(&bodies, values.scope.diagnostics);
    let mut steps = steps(&bodies, values.scope.diagnostics)?;
    values.drives_agree(&bodies)?;
    if outline::lengths::pose_has_declared_lengths(&mut bodies, values.scope.diagnostics)? {
        steps = self::steps(&bodies, values.scope.diagnostics)?;
    }
    outline::listed_assemblies::note_assemblies(&bodies, &steps, values.scope.diagnostics);
    let inputs = values.inputs_of_the_drawing(&bodies);
    bodies.driven = values.driven(&bodies, inputs.as_deref());
    let mut writer = writing::writer::Writer::new(&bodies);
    writer.fixed_links();
    steps.iter().for_each(|step| writer.step(step));
    let (items, links) = writer.finish();
    let diagnostics = values.scope.diagnostics;
    writing::placed::report_places_of_unplaced(&bodies, &links.misplaced, diagnostics)?;
    writing::placed::report_distances_apart(&bodies, &links.bars, diagnostics)?;
    Some(CutDrawing { items, links, inputs, outline: bodies.outline() })
}

/// The groups of the machine; `None` where there are none, or one is at its limit, which was reported.
fn steps(bodies: &Bodies<'_>, diagnostics: &mut Diagnostics) -> Option<Vec<Found>> {
    let steps = match chain::cut(&bodies.machine) {
        Ok(steps) => steps,
        Err(troubles) => {
            for trouble in &troubles {
                outline::messages::report(bodies, trouble, diagnostics);
            }
            return None;
        }
    };
    if let Some(dyad) =
        chain::limits::at_limit(&bodies.machine, &steps, outline::messages::LEAST_SINE)
    {
        outline::messages::report_limit(bodies, dyad, diagnostics);
        return None;
    }
    Some(steps)
}

/// Gives the pins and links of a statement its documentation.
fn document(mechanism: &mut Mechanism, statement: &Statement) {
    let names: Vec<&Ident> = match &statement.kind {
        // Points that keep their statement are documented by it.
        StatementKind::Point(PointStatement { name, on: Some(_), .. }) => {
            let own = mechanism.points.iter().find(|point| point.name == *name);
            own.filter(|point| point.docs.is_empty()).map(|_| name).into_iter().collect()
        }
        StatementKind::Pin(PinStatement { points }) => {
            points.iter().map(|(name, _)| name).collect()
        }
        StatementKind::Link(LinkStatement { links, .. }) => {
            links.iter().map(|link| &link.name).collect()
        }
        _ => return,
    };
    for name in names {
        for point in mechanism.points.iter_mut().filter(|point| point.name == *name) {
            point.docs.clone_from(&statement.docs);
        }
        for link in mechanism.links.iter_mut().filter(|link| link.name == *name) {
            link.docs.clone_from(&statement.docs);
        }
        for output in mechanism.outputs.iter_mut().filter(|output| output.field == *name) {
            output.docs.extend(statement.docs.iter().cloned());
        }
    }
}

impl<'t> Bodies<'t> {
    /// The statements that stay as they are, but for what they say of links.
    fn other_statements(&self) -> impl Iterator<Item = (usize, &'t Statement)> + use<'t> {
        let statements = self.tree.statements.iter().enumerate();
        statements.filter(|(_, statement)| !is_of_a_drawing(&statement.kind))
    }
}
