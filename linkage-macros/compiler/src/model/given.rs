//! Fields of the result as they are given, each once.

use proc_macro2::{Ident, Span};
use syn::Attribute;

use crate::model::mechanism::{DeclaredOutput, LinkId, OutputKind, Scalar};
use crate::model::names::Entity;
use crate::model::scope::Scope;

/// A point, a link, an unknown or a named expression as an output, under its own name.
pub(super) fn whole(scope: &Scope<'_>, entity: Entity) -> Option<DeclaredOutput> {
    let mechanism = &scope.mechanism;
    Some(match entity {
        Entity::Point(id) => {
            let point = &mechanism.points[id.index()];
            let kind = OutputKind::Point(id);
            DeclaredOutput { field: point.name.clone(), docs: point.docs.clone(), kind }
        }
        Entity::Link(id) => {
            let link = &mechanism.links[id.index()];
            let kind = OutputKind::Link { link: id, direction: true, slide: link.slides };
            DeclaredOutput { field: link.name.clone(), docs: link.docs.clone(), kind }
        }
        // A number with its rates, between its ends.
        Entity::Unknown(id) => {
            let unknown = &mechanism.unknowns[id.index()];
            let (value, dimension) = (Scalar::Unknown(id), unknown.dimension);
            let kind = OutputKind::Value { value, dimension };
            DeclaredOutput { field: unknown.name.clone(), docs: unknown.docs.clone(), kind }
        }
        _ => return None,
    })
}

pub(super) fn give_whole(scope: &mut Scope<'_>, at: Span, docs: &[Attribute], entity: Entity) {
    if let Some(DeclaredOutput { field, docs: own, kind }) = whole(scope, entity) {
        give(scope, at, field, &[docs, &own].concat(), kind);
    }
}

/// A link's angle and its slide, asked for one by one, make one field.
pub(super) fn give_link(
    scope: &mut Scope<'_>,
    docs: &[Attribute],
    at: &Ident,
    link: LinkId,
    kind: OutputKind,
) {
    let OutputKind::Link { direction: new_direction, slide: new_slide, .. } = kind else {
        return;
    };
    for output in &mut scope.mechanism.outputs {
        match &mut output.kind {
            OutputKind::Link { link: known, direction, slide }
                if *known == link && !(*direction && new_direction) && !(*slide && new_slide) =>
            {
                *direction |= new_direction;
                *slide |= new_slide;
                return;
            }
            _ => {}
        }
    }
    let declared = &scope.mechanism.links[link.index()];
    let (field, own) = (declared.name.clone(), declared.docs.clone());
    give(scope, at.span(), field, &[docs, &own].concat(), kind);
}

/// A field of the result is given once.
pub(super) fn give(
    scope: &mut Scope<'_>,
    span: Span,
    field: Ident,
    docs: &[Attribute],
    kind: OutputKind,
) {
    let asked = &scope.mechanism.dynamics.asked;
    if scope.mechanism.outputs.iter().any(|output| output.field == field)
        || asked.iter().any(|asked| asked.is_formula(&field))
    {
        return output_is_given_twice(scope, span, &field.to_string());
    }
    scope.mechanism.outputs.push(DeclaredOutput { field, docs: docs.to_vec(), kind });
}

pub(super) fn output_is_given_twice(scope: &mut Scope<'_>, at: Span, path: &str) {
    scope.diagnostics.error(at, format!("the output `{path}` is given twice; remove one"));
}
