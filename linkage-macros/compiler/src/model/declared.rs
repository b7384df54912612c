//! Links and points as statements declare them, with the facts that are known of them so far.

use proc_macro2::Ident;
use syn::Attribute;

use crate::model::facts::LinkFacts;
use crate::model::mechanism::{
    GroupId, GroupName, Link, LinkId, PartOf, Point, PointId, StandsFor,
};
use crate::model::names::Entity;
use crate::model::scope::Scope;
use crate::model::uses::name_is_new;

/// The id of the group that is about to be made.
pub(super) fn next_group(scope: &Scope<'_>) -> GroupId {
    GroupId(scope.mechanism.groups.len() as u32)
}

pub(super) fn add_link(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
    made_by: GroupId,
    slides: bool,
) -> Option<LinkId> {
    name_is_new(scope, name)?;
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
        stands_for: scope.drawn.map_or(StandsFor::Itself, |drawn| drawn.stands_for(name)),
    });
    scope.facts.links.push(LinkFacts {
        moves: false,
        is_bar: false,
        length: None,
        has_its_joints: true,
        is_placed: true,
    });
    note(scope, name, Entity::Link(id));
    id
}

pub(super) fn add_point(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    name: &Ident,
    part_of: PartOf,
) -> Option<PointId> {
    name_is_new(scope, name)?;
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
    let (is_hidden, docs) = (scope.names.is_hidden(name), docs.to_vec());
    scope.mechanism.points.push(Point { name: name.clone(), docs, part_of, is_hidden });
    scope.facts.points.push(false);
    note(scope, name, Entity::Point(id));
    id
}

/// Remembers what somebody has named, which may be a result.
pub(super) fn note(scope: &mut Scope<'_>, name: &Ident, entity: Entity) {
    if !scope.names.is_hidden(name) {
        scope.facts.order.push(entity);
    }
}

/// The group that a name stands for by itself in a stub.
pub(super) fn group_by_itself(scope: &mut Scope<'_>, keyword: &str, name: &Ident) -> GroupId {
    let id = next_group(scope);
    let keyword = Ident::new(keyword, name.span());
    scope.mechanism.groups.push(GroupName { keyword, title: name.to_string() });
    id
}
