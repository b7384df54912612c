//! The rewriting that a message proposes for a group of class III: the angle of one bar becomes an
//! unknown, the other bars form dyads, and the bar left over becomes the equation. It uses the
//! machine's own names.

use std::collections::BTreeSet;

use proc_macro2::Ident;

use crate::syntax::anatomy::{GroupSpec, JointRule};
use crate::syntax::tree::{
    Expr, ExprKind, GroupField, GroupFieldValue, GroupStatement, Leg, StatementKind,
};

use crate::model::as_written::text;
use crate::model::items::{Item, maker};
use crate::model::needs::Needs;

/// The replacement for statements that need each other, if one unknown is enough.
pub(super) fn instead(
    items: &[Item<'_>],
    needs: &Needs,
    circle: &BTreeSet<usize>,
) -> Option<String> {
    let dyads = circle.iter().filter_map(|&index| Some((index, two_bars(&items[index])?)));
    let ends = dyads.flat_map(|(index, group)| [(index, group, 0), (index, group, 1)]);
    let (index, group, kept) = ends.into_iter().find(|&(index, group, kept)| {
        let cut = Cut { items, group, index };
        cut.stands_on_what_is_known(kept, circle)
            && !cut.carries(&group.legs[1 - kept].link)
            && !cut.is_doubled(1 - kept)
            && cut.leaves_an_order(kept, needs, circle)
    })?;
    let (lengths, pin) = (lengths(group)?, group.pin.as_ref()?);
    let (leg, other) = (&group.legs[kept], &group.legs[1 - kept]);
    let (pivot, far) = (leg.joint.as_ref()?, other.joint.as_ref()?);
    let angle = free_name(items);
    let (length, distance) = (written(&lengths[kept]), written(&lengths[1 - kept]));
    Some(format!(
        "write `unknown {angle}: angle between (…, …);`, `crank {}({pivot}) -> {pin} {{ length: \
         {length}, angle: {angle} }}` for `{}`, and last `solve {angle} {{ distance({pin}, {far}) = \
         {distance}, mode: rising }}`",
        leg.link,
        items[index].rules.title(""),
    ))
}

/// A dyad of two bars that is to be taken apart.
struct Cut<'t> {
    items: &'t [Item<'t>],
    group: &'t GroupStatement,
    index: usize,
}

impl Cut<'_> {
    fn pivot(&self, leg: usize) -> Option<usize> {
        maker(self.items, self.group.legs[leg].joint.as_ref()?)
    }

    fn stands_on_what_is_known(&self, leg: usize, circle: &BTreeSet<usize>) -> bool {
        self.pivot(leg).is_some_and(|maker| !circle.contains(&maker))
    }

    fn others(&self) -> impl Iterator<Item = &Item<'_>> {
        let others = self.items.iter().enumerate().filter(|&(index, _)| index != self.index);
        others.map(|(_, item)| item)
    }

    /// True if another statement names the link.
    fn carries(&self, link: &Ident) -> bool {
        self.others().any(|item| item.rules.names_used().contains(link))
    }

    /// True if another bar joins the same two points, so that their distance never changes.
    fn is_doubled(&self, leg: usize) -> bool {
        let (far, pin) = (&self.group.legs[leg].joint, &self.group.pin);
        self.others().any(|item| {
            two_bars(item).is_some_and(|other| {
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
fn two_bars<'t>(item: &Item<'t>) -> Option<&'t GroupStatement> {
    match item.written? {
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
fn free_name(items: &[Item<'_>]) -> &'static str {
    let is_free = |name: &str| {
        let mut declared = items.iter().flat_map(|item| item.rules.declares());
        declared.all(|(known, _)| known != name)
    };
    let names = ["phi", "psi", "chi", "unknown_angle"];
    names.into_iter().find(|name| is_free(name)).unwrap_or("angle_")
}
