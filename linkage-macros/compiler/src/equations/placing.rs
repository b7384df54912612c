//! Where everything that is declared stands, whether an output asks for it or not: what a drawing
//! is made of.
//!
//! It is a program of its own with a graph of its own: more sinks in the solver's graph would
//! change which of its products are contracted and what is computed when.

use crate::equations::forces;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::symbol::{GraphBuilder, Sym};
use crate::ir::construct::Rule;
use crate::ir::program::{EntryOutputs, Program};
use crate::model::mechanism::{Mechanism, Step};

/// Point after point x and y; link after link the frame's origin, the direction's cosine and sine,
/// and the slide, zero where it has none; guide after guide origin, cosine and sine; statement after
/// statement its [`dimensions`]. A second answer gives the forces that the declaration puts on points,
/// if there are any: x and y of one after the other.
pub(crate) fn derive(mechanism: &Mechanism, rules: &[Rule]) -> Program {
    let builder = GraphBuilder::new(rules);
    let kinematics = Kinematics::of(&builder, mechanism, InputMotion::free(mechanism, &builder));
    let mut placed: Vec<Sym<'_>> = Vec::new();
    for point in mechanism.point_ids() {
        let at = kinematics.point(point).position();
        placed.extend([at.x, at.y]);
    }
    for link in mechanism.link_ids() {
        let motion = kinematics.link(link);
        let (origin, u) = (motion.frame.origin.position(), motion.frame.direction.u);
        let slide = motion.slide.map_or(builder.zero(), |slide| slide.value);
        placed.extend([origin.x, origin.y, u.x, u.y, slide]);
    }
    for guide in mechanism.guide_ids() {
        let frame = kinematics.guide(guide);
        let (origin, u) = (frame.origin.position(), frame.direction.u);
        placed.extend([origin.x, origin.y, u.x, u.y]);
    }
    placed.extend(mechanism.steps.iter().flat_map(|step| dimensions(&kinematics, step)));
    let sinks = placed.into_iter().map(|symbol| symbol.id).collect();
    let mut answers = vec![EntryOutputs { entry: None, sinks }];
    let forces = forces::declared(&kinematics);
    if !forces.is_empty() {
        let numbers = forces.into_iter().flat_map(|(_, force)| [force.x.id, force.y.id]);
        answers.push(EntryOutputs { entry: None, sinks: numbers.collect() });
    }
    let closures = kinematics.closures.clone();
    drop(kinematics);
    Program {
        graph: builder.into_graph(),
        answers,
        clearances: Vec::new(),
        closures,
        groups: mechanism.titles(),
    }
}

/// The lengths and offsets of a statement, in its own order: known also where the group that they
/// belong to cannot be assembled.
fn dimensions<'s>(kinematics: &Kinematics<'s>, step: &'s Step) -> Vec<Sym<'s>> {
    let Step::Group(group) = step else { return Vec::new() };
    let lengths = group.lengths.iter().flatten().map(|length| &length.value);
    let jets = lengths.chain(group.offsets()).map(|expr| kinematics.jet(expr));
    jets.map(|jet| jet.value).collect()
}
