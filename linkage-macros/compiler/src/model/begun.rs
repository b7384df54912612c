//! The scope in front of the first statement: the names of all of them, and what their text alone says.

use proc_macro2::Ident;

use crate::diagnostics::Diagnostics;
use crate::exact::Exact;
use crate::syntax::tree::{self, Declaration, ExprKind, StatementKind, Unread};

use crate::model::dimension::Dimension;
use crate::model::facts::Facts;
use crate::model::items::Item;
use crate::model::mechanism::{Mechanism, References};
use crate::model::names::{Kind, Names, Symbol};
use crate::model::references::expressions;
use crate::model::scope::Scope;
use crate::model::statements::drive_by;
use crate::model::units::unit;

/// The scope in front of the first of the items that the declaration is.
pub(super) fn scope<'d>(
    tree: &Declaration,
    items: &[Item<'_>],
    unread: &'d Unread,
    diagnostics: &'d mut Diagnostics,
) -> Scope<'d> {
    let driving = drive_by::named_by(tree).map(Ident::to_string);
    let longest_with_unit = longest_with_unit(tree);
    let empty = Mechanism::empty(tree.docs.clone(), tree.visibility.clone(), tree.name.clone());
    Scope {
        diagnostics,
        unread,
        names: names(items),
        mechanism: Mechanism { references: References::of(tree), ..empty },
        facts: Facts::of(longest_with_unit, driving),
        drawn: None,
    }
}

/// All names that items make.
pub(super) fn names(items: &[Item<'_>]) -> Names {
    let solved = items.iter().filter_map(|item| match item.written {
        Some(StatementKind::Solve(solve)) => Some(solve.unknown.to_string()),
        _ => None,
    });
    let mut names = Names::new(solved.collect());
    for (index, item) in items.iter().enumerate() {
        let declared = item.rules.declares();
        let is_a_group = declared.iter().any(|(_, kind)| *kind == Kind::Link);
        for (name, kind) in declared {
            let name = name.to_string();
            let made_by = item.rules.title(&name);
            let is_a_pin = kind == Kind::Point && is_a_group;
            names.add(Symbol {
                name,
                kind,
                statement: index,
                made_by,
                is_drawn: item.written.is_none(),
                is_a_pin,
                entity: None,
                declared: false,
                is_hidden: false,
                ambiguous: false,
            });
        }
    }
    names
}

/// The longest length with a unit.
pub(super) fn longest_with_unit(tree: &Declaration) -> Option<Exact> {
    let mut longest = None;
    let mut note = |expr: &tree::Expr| {
        let ExprKind::Number { digits, units } = &expr.kind else { return };
        let [(name, 1)] = &units[..] else { return };
        let Some((Dimension::LENGTH, factor)) = unit(name) else { return };
        let Some(value) = Exact::decimal(digits).map(|value| value.mul(&factor)) else { return };
        if longest.as_ref().is_none_or(|longest| value.cmp_value(longest).is_gt()) {
            longest = Some(value);
        }
    };
    for statement in &tree.statements {
        expressions(statement, &mut |expr| expr.each_part(&mut note));
    }
    longest.filter(|longest: &Exact| !longest.is_zero())
}
