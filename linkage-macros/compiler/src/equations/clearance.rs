//! Clearance of each group with an assembly mode from its limits, for following a motion.
//!
//! A group's height comes from a square root; what stands under the root is smooth wherever the
//! group's joints go, zero at a toggle and negative out of reach. Where it touches zero and turns
//! back, the motion goes on through a change point and the root changes its sign, which is the
//! mode; where it passes through zero, the motion ends. The value under the root is looked at with
//! its rates while the inputs move along a straight line, and given with a scale: a small change of all
//! lengths by a share δ of themselves changes the value by at most 4 δ of it.

use crate::equations::certified_steps;
use crate::equations::dead_points;
use crate::equations::groups::formulas;
use crate::equations::jet::Jet;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::parts::ClearanceTerms;
use crate::equations::symbol::GraphBuilder;
use crate::exact::Exact;
use crate::ir::program;
use crate::model::mechanism::{Mechanism, Mode, Step, UnknownId};

/// Clearances of all groups with an assembly mode, in solving order, as functions of a pose without
/// unknowns. Running them on numbers that move along a straight line gives their rates.
pub(super) fn of_pose(kinematics: &Kinematics<'_>) -> Vec<program::Clearance> {
    let steps = kinematics.mechanism.steps.iter();
    let of_groups = steps.filter_map(|step| of_step(kinematics, step));
    let of_groups = of_groups.chain(of_tracked(kinematics));
    of_groups.map(|clearance| program::Clearance { rates: None, ..clearance }).collect()
}

/// The same with rates, and of unknowns: what is searched turns on the ends of the search, as what
/// stands behind a group does on its limit.
pub(super) fn beside_unknowns<'s>(
    mechanism: &'s Mechanism,
    builder: &'s GraphBuilder<'s>,
) -> Vec<program::Clearance> {
    // Along a straight line the inputs' rates are constant.
    let inputs = InputMotion::without_second_rates(&InputMotion::free(mechanism, builder), builder);
    let mut ends = Vec::new();
    let kinematics = Kinematics::with_unknowns(builder, mechanism, inputs, |known, id| {
        ends.push((id, dead_points::of_ends(known, id)));
    });
    let (mut ends, mut clearances) = (ends.into_iter().peekable(), Vec::new());
    for (index, step) in mechanism.steps.iter().enumerate() {
        let begins = |id: UnknownId| mechanism.unknowns[id.index()].steps[0] <= index;
        while let Some((id, of_ends)) = ends.next_if(|&(id, _)| begins(id)) {
            clearances.extend(of_ends);
            clearances.push(dead_points::of_root(&kinematics, id));
        }
        clearances.extend(of_step(&kinematics, step));
    }
    clearances.extend(of_tracked(&kinematics));
    clearances
}

/// Groups that are solved by all their unknowns at once end with the stretch on which they are followed.
fn of_tracked(kinematics: &Kinematics<'_>) -> Vec<program::Clearance> {
    let builder = kinematics.builder;
    let found = kinematics.mechanism.tracked.iter().filter_map(|tracked| {
        let Jet { value, rate, accel } = certified_steps::inside(kinematics, tracked)?;
        let [from, to] = tracked.fit.stretch();
        // The value is at most one, or the square of half the stretch.
        let scale = if tracked.fit.is_turned { 1.0 } else { (to - from).powi(2) };
        Some(program::Clearance {
            group: tracked.group.0,
            param: None,
            value: value.id,
            scale: builder.constant(Exact::float(scale).expect("a stretch is finite")).id,
            rates: Some([rate.id, accel.id]),
        })
    });
    found.collect()
}

fn of_step<'s>(kinematics: &Kinematics<'s>, step: &'s Step) -> Option<program::Clearance> {
    let Step::Group(group) = step else { return None };
    let (mode, clearance) = (group.mode()?, formulas(group.kind).clearance(kinematics, group)?);
    let param = match mode {
        Mode::Fixed(_) => None,
        Mode::Param(param) => Some(param.0),
    };
    let ClearanceTerms { value, scale } = clearance;
    if value.is_fixed() {
        // A group that never moves never changes its mode.
        return None;
    }
    let rates = Some([value.rate.id, value.accel.id]);
    Some(program::Clearance {
        group: group.id.0,
        param,
        value: value.value.id,
        scale: scale.id,
        rates,
    })
}
