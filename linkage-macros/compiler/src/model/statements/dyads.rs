//! Drivers and dyads: what all of them share before each is looked at by itself.

use proc_macro2::Ident;
use syn::Attribute;

use crate::diagnostics::nearest;
use crate::syntax::anatomy::{GroupSpec, JointRule, KEYWORDS, Pin, Reason};
use crate::syntax::tree::{self, Expr};
use crate::syntax::words::built_by;

use crate::model::mechanism::{GroupId, GroupName, PartOf, PointId, Step};
use crate::model::names::{Entity, Kind};
use crate::model::parts_of_groups::{Dimensions, OuterJoint, Parts};
use crate::model::scope::Scope;
use crate::model::statements::Rules;
use crate::model::{declared, fields, jointed, uses};

impl Rules for tree::GroupStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        let links = self.legs.iter().map(|leg| (&leg.link, Kind::Link));
        links.chain(self.pin.iter().map(|pin| (pin, Kind::Point))).collect()
    }

    fn title(&self, _name: &str) -> String {
        format!("{} {}", self.keyword, tree::GroupStatement::title(self))
    }

    fn builds_on(&self) -> Vec<&Ident> {
        self.legs.iter().filter_map(|leg| leg.joint.as_ref()).collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.values().for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, docs: &[Attribute]) {
        group(scope, docs, self, self.moves(scope));
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let made_by = self.group_of_stub(scope);
        let Some(place) = self.legs.iter().position(|leg| leg.link == *name) else {
            return Some(Entity::Point(declared::new_point(
                scope,
                docs,
                name,
                PartOf::Pin(made_by),
            )));
        };
        // Where the group is not known, its links have every field.
        let anatomy = GroupSpec::of(&self.keyword.to_string());
        let slides = anatomy.is_none_or(|anatomy| anatomy.slides().get(place) == Some(&true));
        Some(Entity::Link(declared::new_link(scope, docs, name, made_by, slides)))
    }
}

impl tree::GroupStatement {
    /// The group that a stub has of the statement: that of its names which have a place already.
    fn group_of_stub(&self, scope: &mut Scope<'_>) -> GroupId {
        let of_name = |(name, _): (&Ident, Kind)| match scope.names.made(name)? {
            Entity::Link(id) => Some(scope.mechanism.links[id.index()].made_by),
            Entity::Point(id) => match scope.mechanism.points[id.index()].part_of {
                PartOf::Pin(group) => Some(group),
                _ => None,
            },
            _ => None,
        };
        if let Some(known) = self.declares().into_iter().find_map(of_name) {
            return known;
        }
        let id = declared::next_group(scope);
        let (keyword, title) = (self.keyword.clone(), self.title());
        scope.mechanism.groups.push(GroupName { keyword, title });
        id
    }
}

fn group(scope: &mut Scope<'_>, docs: &[Attribute], group: &tree::GroupStatement, moves: bool) {
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
    let id = declared::next_group(scope);
    let links: Vec<_> = (group.legs.iter().zip(anatomy.slides()))
        .map(|(leg, slides)| declared::add_link(scope, docs, &leg.link, id, slides))
        .collect();
    let pin = pin(scope, docs, group, anatomy, id);
    let (keyword, title) = (group.keyword.clone(), group.title());
    scope.mechanism.groups.push(GroupName { keyword, title });
    let outer = outer_joints(scope, group, anatomy);
    let fields = fields::fields(scope, group, anatomy);
    let (at, pin_name) = (group.keyword.span(), group.pin.clone());
    let parts = Parts { at, anatomy, id, links, outer, pin_name, pin };
    let dimensions = jointed::dimensions(scope, &parts, group, &fields);
    group_is_made(scope, &parts, dimensions, moves);
}

/// The step of a group. Everything that it makes moves if anything it was given moves.
pub(in crate::model) fn group_is_made(
    scope: &mut Scope<'_>,
    parts: &Parts,
    dimensions: Dimensions,
    moves: bool,
) {
    let step = jointed::place_group(scope, parts, dimensions).map(Step::Group);
    let is_placed = step.is_some();
    scope.mechanism.steps.extend(step);
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
        (Some(pin), _) => declared::add_point(scope, docs, pin, PartOf::Pin(id)),
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
    if legs_are_exchanged(scope, group, anatomy) {
        return vec![None; group.legs.len()];
    }
    let outer: Vec<_> = (group.legs.iter().zip(anatomy.joints))
        .map(|(leg, &joint)| joint_stands_on_its_kind(scope, leg.joint.as_ref()?, joint, anatomy))
        .collect();
    match outer[..] {
        [Some(first), Some(second)] if outer_joints_differ(scope, group, first, second) => outer,
        [Some(_), Some(_)] => vec![None, None],
        _ => outer,
    }
}

/// Reports a dyad whose joints are written from its other end.
fn legs_are_exchanged(
    scope: &mut Scope<'_>,
    group: &tree::GroupStatement,
    anatomy: &GroupSpec,
) -> bool {
    let ([first, second], [JointRule::Revolute(_), JointRule::Prismatic(_)]) =
        (&group.legs[..], anatomy.joints)
    else {
        return false;
    };
    let (Some(guide), Some(point)) = (&first.joint, &second.joint) else { return false };
    let kinds = [guide, point].map(|joint| scope.names.kind(joint));
    if kinds != [Some(Kind::Guide), Some(Kind::Point)] {
        return false;
    }
    let (keyword, pin) = (anatomy.keyword, group.pin.as_ref());
    let pin = pin.map_or(String::new(), |pin| format!(" -> {pin}"));
    let message =
        format!("write `{keyword} {}({point}), {}({guide}){pin}`", second.link, first.link);
    let what = if anatomy.has_length() { "bar" } else { "pinned block" };
    let reason = format!("the {what} comes first, and then what slides on a guide");
    scope.diagnostics.error_because(first.link.span(), message, reason);
    true
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
