//! Statements of groups, made of their parts, and names in them.

use proc_macro2::Ident;

use crate::syntax::tree::{Expr, ExprKind, GroupField, GroupFieldValue, GroupStatement, Leg};

/// The statement of a group.
pub(in crate::model::drawn) fn group_of(
    keyword: &str,
    legs: Vec<(Ident, Ident)>,
    pin: Option<Ident>,
    fields: Vec<(&str, GroupFieldValue)>,
) -> GroupStatement {
    let span = legs[0].0.span();
    let field =
        |(name, value): (&str, GroupFieldValue)| GroupField { name: Ident::new(name, span), value };
    GroupStatement {
        keyword: Ident::new(keyword, span),
        legs: legs.into_iter().map(|(link, joint)| Leg { link, joint: Some(joint) }).collect(),
        pin,
        fields: fields.into_iter().map(field).collect(),
        end: span,
        head_is_read: true,
        fields_are_read: true,
    }
}

/// A name as an expression.
pub(in crate::model::drawn) fn named(name: &Ident) -> Expr {
    Expr { kind: ExprKind::Name(name.clone()), span: name.span().into() }
}
