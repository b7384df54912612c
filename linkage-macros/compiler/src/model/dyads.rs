//! Drivers and dyads: what all of them share before each is looked at by itself.

use proc_macro2::Ident;
use syn::Attribute;

use crate::diagnostics::nearest;
use crate::syntax::tree;
use crate::syntax::words::built_by;

use super::facts::LinkFacts;
use super::fields::{self, Fields};
use super::mechanism::{GroupId, GroupName, GuideId, Link, LinkId, PartOf, Point, PointId, Step};
use super::names::{Entity, Kind};
use super::scope::Scope;
use super::{jointed, uses};
use crate::syntax::anatomy::{GroupSpec, JointRule, KEYWORDS, Pin, Reason};

/// The things a group statement has made, and those it was given.
pub(super) struct Parts<'t> {
    pub group: &'t tree::GroupStatement,
    pub anatomy: &'static GroupSpec,
    pub id: GroupId,
    /// One a leg; `None` where the name was in error.
    pub links: Vec<Option<LinkId>>,
    pub outer: Vec<Option<OuterJoint>>,
    pub pin: Option<PointId>,
    pub fields: Fields<'t>,
}

/// The support of an outer joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OuterJoint {
    Point(PointId),
    Guide(GuideId),
}

impl Parts<'_> {
    /// True if the group has a pin, or should have one.
    pub(super) fn has_pin(&self) -> bool {
        match self.anatomy.pin {
            Pin::Needed => true,
            Pin::Optional => self.group.pin.is_some(),
            Pin::None(_) => false,
        }
    }

    pub(super) fn link(&self, i: usize) -> Option<LinkId> {
        self.links.get(i).copied().flatten()
    }

    pub(super) fn point(&self, i: usize) -> Option<PointId> {
        match self.outer.get(i).copied().flatten()? {
            OuterJoint::Point(id) => Some(id),
            OuterJoint::Guide(_) => None,
        }
    }

    pub(super) fn guide(&self, i: usize) -> Option<GuideId> {
        match self.outer.get(i).copied().flatten()? {
            OuterJoint::Guide(id) => Some(id),
            OuterJoint::Point(_) => None,
        }
    }
}

pub(super) fn group(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    group: &tree::GroupStatement,
    moves: bool,
) {
    let Some(anatomy) = GroupSpec::of(&group.keyword.to_string()) else {
        group_exists(scope, &group.keyword);
        names_stay_unknown(scope, group);
        return;
    };
    if !group.head_is_read || !each_joint_has_a_link(scope, group, anatomy) {
        names_stay_unknown(scope, group);
        outer_joints(scope, group, anatomy);
        fields::fields(scope, group, anatomy);
        return;
    }
    let id = next_group(scope);
    let links: Vec<_> = (group.legs.iter().zip(anatomy.slides()))
        .map(|(leg, slides)| add_link(scope, docs, &leg.link, id, slides))
        .collect();
    let pin = pin(scope, docs, group, anatomy, id);
    let (keyword, title) = (group.keyword.clone(), group.title());
    scope.mechanism.groups.push(GroupName { keyword, title });
    let outer = outer_joints(scope, group, anatomy);
    let fields = fields::fields(scope, group, anatomy);
    let parts = Parts { group, anatomy, id, links, outer, pin, fields };
    let step = jointed::jointed(scope, &parts).map(Step::Group);
    facts_of_what_was_made(scope, &parts, step.is_some(), moves);
    scope.mechanism.steps.extend(step);
}

/// Everything a group makes moves if anything it was given moves.
fn facts_of_what_was_made(scope: &mut Scope<'_>, parts: &Parts, is_placed: bool, moves: bool) {
    let pin_is_known = parts.pin.is_some() == parts.has_pin();
    for (link, joint) in parts.links.iter().zip(&parts.outer) {
        if let Some(link) = link {
            let facts = &mut scope.facts.links[link.index()];
            facts.moves = moves;
            facts.has_its_joints = joint.is_some() && pin_is_known;
            facts.is_placed = is_placed;
        }
    }
    if let Some(pin) = parts.pin {
        scope.facts.points[pin.index()] = moves;
    }
}

/// Reserves the names of a statement that cannot be understood. They stay unresolved.
fn names_stay_unknown(scope: &mut Scope<'_>, group: &tree::GroupStatement) {
    for name in group.legs.iter().map(|leg| &leg.link).chain(&group.pin) {
        uses::name_is_new(scope, name);
    }
}

/// The id of the group that is about to be made.
pub(super) fn next_group(scope: &Scope<'_>) -> GroupId {
    GroupId(scope.mechanism.groups.len() as u32)
}

fn add_link(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
    made_by: GroupId,
    slides: bool,
) -> Option<LinkId> {
    uses::name_is_new(scope, name)?;
    let id = new_link(scope, docs, name, made_by, slides);
    scope.names.bind(name, Entity::Link(id));
    Some(id)
}

pub(super) fn new_link(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
    made_by: GroupId,
    slides: bool,
) -> LinkId {
    let id = LinkId(scope.mechanism.links.len() as u32);
    scope.mechanism.links.push(Link {
        name: name.clone(),
        docs: docs.to_vec(),
        made_by,
        slides,
        stands_for: None,
    });
    scope.facts.links.push(LinkFacts {
        moves: false,
        is_bar: false,
        length: None,
        has_its_joints: true,
        is_placed: true,
    });
    scope.facts.order.push(Entity::Link(id));
    id
}

pub(super) fn add_point(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
    part_of: PartOf,
) -> Option<PointId> {
    uses::name_is_new(scope, name)?;
    let id = new_point(scope, docs, name, part_of);
    scope.names.bind(name, Entity::Point(id));
    Some(id)
}

pub(super) fn new_point(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
    part_of: PartOf,
) -> PointId {
    let id = PointId(scope.mechanism.points.len() as u32);
    scope.mechanism.points.push(Point { name: name.clone(), docs: docs.to_vec(), part_of });
    scope.facts.points.push(false);
    scope.facts.order.push(Entity::Point(id));
    id
}

/// A group names a pin exactly where its inner joint is one.
fn pin(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    group: &tree::GroupStatement,
    anatomy: &GroupSpec,
    id: GroupId,
) -> Option<PointId> {
    let keyword = anatomy.keyword;
    match (&group.pin, anatomy.pin) {
        (Some(pin), Pin::None(reason)) => {
            let message = format!("`{keyword}` makes no pin; remove `-> {pin}`");
            scope.diagnostics.error_because(pin.span(), message, reason);
            uses::name_is_new(scope, pin);
            None
        }
        (Some(pin), _) => add_point(scope, docs, pin, PartOf::Pin(id)),
        (None, Pin::Needed) if group.head_is_read => {
            let message = format!("`{keyword}` makes a pin; name it with `-> C`");
            let reason = format!("it reads `{}`", anatomy.form);
            scope.diagnostics.error_because(group.keyword.span(), message, reason);
            None
        }
        (None, _) => None,
    }
}

/// A driver has one link, a dyad two.
fn each_joint_has_a_link(
    scope: &mut Scope<'_>,
    group: &tree::GroupStatement,
    anatomy: &GroupSpec,
) -> bool {
    let (found, wanted) = (group.legs.len(), anatomy.joints.len());
    let span = match group.legs.get(wanted) {
        _ if found == wanted => return true,
        Some(extra) => extra.link.span(),
        None => group.keyword.span(),
    };
    let links = if wanted == 1 { "one link" } else { "two links" };
    let found = match found {
        0 => "none is given".into(),
        1 => "one is given".into(),
        _ => format!("{found} are given"),
    };
    let message = format!("`{}` has {links}, and {found}", anatomy.keyword);
    let reason = format!("it reads `{}`", anatomy.form);
    scope.diagnostics.error_because(span, message, reason);
    false
}

fn outer_joints(
    scope: &mut Scope<'_>,
    group: &tree::GroupStatement,
    anatomy: &GroupSpec,
) -> Vec<Option<OuterJoint>> {
    let outer: Vec<_> = (group.legs.iter().zip(anatomy.joints))
        .map(|(leg, &joint)| joint_stands_on_its_kind(scope, leg.joint.as_ref()?, joint, anatomy))
        .collect();
    match outer[..] {
        [Some(first), Some(second)] if outer_joints_differ(scope, group, first, second) => outer,
        [Some(_), Some(_)] => vec![None, None],
        _ => outer,
    }
}

/// A revolute joint stands on a point, a prismatic joint on a guide.
fn joint_stands_on_its_kind(
    scope: &mut Scope<'_>,
    name: &Ident,
    joint: JointRule,
    anatomy: &GroupSpec,
) -> Option<OuterJoint> {
    let (reason, wrong, wanted) = match (joint, scope.names.kind(name)) {
        (JointRule::Revolute(reason), Some(Kind::Guide)) => (reason, Kind::Guide, Kind::Point),
        (JointRule::Prismatic(reason), Some(Kind::Point)) => (reason, Kind::Point, Kind::Guide),
        (JointRule::Revolute(_), _) => return uses::point(scope, name).map(OuterJoint::Point),
        (JointRule::Prismatic(_), _) => return uses::guide(scope, name).map(OuterJoint::Guide),
    };
    let keyword = anatomy.keyword;
    let (wrong, wanted) = (wrong.one(), wanted.one());
    match reason {
        Reason::Letter(ordinal) => {
            let letter = if wanted == "a point" { 'R' } else { 'P' };
            let message = format!(
                "`{name}` is {wrong}, and the {ordinal} letter of `{keyword}` is {letter}: \
                 it needs {wanted}"
            );
            let reason = dyad_with_the_other_letter(keyword, ordinal)
                .map(|other| format!("a group with {wrong} there is `{other}`"));
            uses::report(scope, name.span(), message, reason);
        }
        Reason::Driver(does) => {
            let message = format!("`{name}` is {wrong}, and a `{keyword}` {does}");
            let reason = format!("it reads `{}`", anatomy.form);
            scope.diagnostics.error_because(name.span(), message, reason);
        }
    }
    None
}

/// The two links of a group stand on two different things.
fn outer_joints_differ(
    scope: &mut Scope<'_>,
    group: &tree::GroupStatement,
    first: OuterJoint,
    second: OuterJoint,
) -> bool {
    if first != second {
        return true;
    }
    let Some(joint) = &group.legs[1].joint else { return true };
    let message = format!("both links of `{}` stand on `{joint}`", group.keyword);
    let reason = match second {
        OuterJoint::Point(_) => "between two links on one point the inner joint is undetermined",
        OuterJoint::Guide(_) => "two links on one guide never cross",
    };
    scope.diagnostics.error_because(joint.span(), message, reason);
    false
}

/// Reports a group that does not exist, with what to write instead.
fn group_exists(scope: &mut Scope<'_>, keyword: &Ident) {
    let text = keyword.to_string();
    let letters = text.to_lowercase();
    let is_letters = letters.len() > 1 && letters.chars().all(|c| c == 'r' || c == 'p');
    let reversed: String = letters.chars().rev().collect();
    let (message, reason) = match letters.as_str() {
        _ if GroupSpec::of(&letters).is_none() && GroupSpec::of(&reversed).is_some() => {
            let has_bar = GroupSpec::of(&reversed).is_some_and(GroupSpec::has_length);
            let first = if has_bar { "bar" } else { "pinned block" };
            (
                format!("no group `{text}`; write `{reversed}` with the {first} first"),
                "a dyad is the same read from either end".to_string(),
            )
        }
        "ppp" => (
            format!("no group `{text}`; a dyad needs a revolute joint"),
            "links with prismatic joints alone cannot turn, and are not determined".to_string(),
        ),
        _ if is_letters && letters.len() != 3 => (
            format!("no group `{text}`; a dyad has three joints, so three letters"),
            "outer joint of the first link, inner joint, outer joint of the second".to_string(),
        ),
        _ => {
            let near = nearest(&text, KEYWORDS.into_iter());
            let near = near.map(|near| format!("; one with a similar name exists: `{near}`"));
            let known = || format!("they are {}", known_groups());
            (
                format!("no driver or group `{text}`{}", near.unwrap_or_default()),
                built_by(&text).map_or_else(known, str::to_string),
            )
        }
    };
    scope.diagnostics.error_because(keyword.span(), message, reason);
}

fn known_groups() -> String {
    KEYWORDS.into_iter().map(|known| format!("`{known}`")).collect::<Vec<_>>().join(", ")
}

/// The dyad whose first or third letter is the other one.
fn dyad_with_the_other_letter(keyword: &str, ordinal: &str) -> Option<&'static str> {
    let position = if ordinal == "first" { 0 } else { 2 };
    let flipped: String = keyword
        .char_indices()
        .map(|(i, letter)| match letter {
            _ if i != position => letter,
            'r' => 'p',
            _ => 'r',
        })
        .collect();
    let reversed: String = flipped.chars().rev().collect();
    let anatomy = GroupSpec::of(&flipped).or_else(|| GroupSpec::of(&reversed));
    anatomy.map(|anatomy| anatomy.keyword)
}
