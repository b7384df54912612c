//! The statements of a routine for a language in which a name is bound once. A stage that needs the cosine of an
//! angle of which an earlier one needed the sine computes both again: there the sine has no name.

use super::routine::{Instruction, Stage};
use crate::ir::graph::Id;
use crate::ir::hash::Set;

/// The statements of each stage.
pub(crate) fn bound_once(stages: &[Stage]) -> Vec<Vec<Instruction>> {
    let mut bound: Set<Id> = Set::default();
    let mut new = |id: Option<Id>| id.filter(|&id| bound.insert(id));
    let mut statement = |statement: &Instruction| match *statement {
        Instruction::SinCos { angle, sin, cos, is_checked } => {
            Instruction::SinCos { angle, sin: new(sin), cos: new(cos), is_checked }
        }
        ref other => other.clone(),
    };
    stages.iter().map(|stage| stage.statements.iter().map(&mut statement).collect()).collect()
}
