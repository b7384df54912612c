//! The rewriting that a message proposes for a group of class III: the angle of one bar becomes an
//! unknown, the other bars form dyads, and the bar left over becomes the equation. It uses the
//! machine's own names.

use std::collections::BTreeSet;

use proc_macro2::Ident;

use crate::syntax::anatomy::{GroupSpec, JointRule};
use crate::syntax::tree::{
    Declaration, Expr, ExprKind, GroupField, GroupFieldValue, GroupStatement, Leg, Statement,
    StatementKind,
};

use crate::model::as_written::text;
use crate::model::needs::{Needs, maker};
use crate::model::references::names_used;
use crate::model::statements::{declared_by, title};

/// The replacement for statements that need each other, if one unknown is enough.
pub(super) fn instead(
    tree: &Declaration,
    needs: &Needs,
    circle: &BTreeSet<usize>,
) -> Option<String> {
    let dyads =
        circle.iter().filter_map(|&index| Some((index, two_bars(&tree.statements[index])?)));
    let ends = dyads.flat_map(|(index, group)| [(index, group, 0), (index, group, 1)]);
    let (index, group, kept) = ends.into_iter().find(|&(index, group, kept)| {
        let cut = Cut { tree, group, index };
        cut.stands_on_what_is_known(kept, circle)
            && !cut.carries(&group.legs[1 - kept].link)
            && !cut.is_doubled(1 - kept)
            && cut.leaves_an_order(kept, needs, circle)
    })?;
    let (lengths, pin) = (lengths(group)?, group.pin.as_ref()?);
    let (leg, other) = (&group.legs[kept], &group.legs[1 - kept]);
    let (pivot, far) = (leg.joint.as_ref()?, other.joint.as_ref()?);
    let angle = free_name(tree);
    let (length, distance) = (written(&lengths[kept]), written(&lengths[1 - kept]));
    Some(format!(
        "write `unknown {angle}: angle between (…, …);`, `crank {}({pivot}) -> {pin} {{ length: \
         {length}, angle: {angle} }}` for `{}`, and last `solve {angle} {{ distance({pin}, {far}) = \
         {distance}, mode: rising }}`",
        leg.link,
        title(&tree.statements[index], ""),
    ))
}

/// A dyad of two bars that is to be taken apart.
struct Cut<'t> {
    tree: &'t Declaration,
    group: &'t GroupStatement,
    index: usize,
}

impl Cut<'_> {
    fn pivot(&self, leg: usize) -> Option<usize> {
        maker(self.tree, self.group.legs[leg].joint.as_ref()?)
    }

    fn stands_on_what_is_known(&self, leg: usize, circle: &BTreeSet<usize>) -> bool {
        self.pivot(leg).is_some_and(|maker| !circle.contains(&maker))
    }

    /// True if another statement names the link.
    fn carries(&self, link: &Ident) -> bool {
        let others = self.tree.statements.iter().enumerate();
        others
            .filter(|&(index, _)| index != self.index)
            .any(|(_, statement)| names_used(statement).contains(link))
    }

    /// True if another bar joins the same two points, so that their distance never changes.
    fn is_doubled(&self, leg: usize) -> bool {
        let (far, pin) = (&self.group.legs[leg].joint, &self.group.pin);
        let others = self.tree.statements.iter().enumerate();
        let mut others = others.filter(|&(index, _)| index != self.index);
        others.any(|(_, statement)| {
            two_bars(statement).is_some_and(|other| {
                other.pin == *far && other.legs.iter().any(|leg| leg.joint == *pin)
            })
        })
    }

    /// True if the statements of the circle have an order once this one needs its pivot alone.
    fn leaves_an_order(&self, leg: usize, needs: &Needs, circle: &BTreeSet<usize>) -> bool {
        let left = needs.with(self.index, self.pivot(leg).into_iter().collect());
        circle.iter().all(|&statement| left.circle(statement).is_empty())
    }
}

/// The dyad of two bars that the statement is, as far as all of it was read.
fn two_bars(statement: &Statement) -> Option<&GroupStatement> {
    match &statement.kind {
        StatementKind::Group(group) if is_of_two_bars(&group.keyword.to_string()) => {
            let is_whole = |leg: &Leg| leg.joint.is_some();
            (group.legs.len() == 2 && group.legs.iter().all(is_whole)).then_some(group)
        }
        _ => None,
    }
}

fn is_of_two_bars(keyword: &str) -> bool {
    let is_revolute = |joint: &JointRule| matches!(joint, JointRule::Revolute(_));
    GroupSpec::of(keyword).is_some_and(|anatomy| {
        let joints = anatomy.joints;
        joints.len() == 2 && joints.iter().all(is_revolute) && !anatomy.has_inner_slide()
    })
}

fn lengths(group: &GroupStatement) -> Option<&[Expr; 2]> {
    group.fields.iter().find_map(|field| match field {
        GroupField { name, value: GroupFieldValue::Pair(pair) } if name == "lengths" => Some(pair),
        _ => None,
    })
}

/// A number or a name as it was written; what is longer is to be filled in.
fn written(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Number { units, .. } if matches!(units[..], [] | [(_, 1)]) => text(expr),
        ExprKind::Name(_) => text(expr),
        _ => "…".to_string(),
    }
}

/// A name for the angle that nothing has.
fn free_name(tree: &Declaration) -> &'static str {
    let declared: Vec<String> =
        (tree.statements.iter().flat_map(declared_by)).map(|(name, _)| name.to_string()).collect();
    let names = ["phi", "psi", "chi", "unknown_angle"];
    names.into_iter().find(|name| !declared.iter().any(|known| known == name)).unwrap_or("angle_")
}
