//! Outputs of a stub: a field for each, however much of it was understood.

use quote::format_ident;

use proc_macro2::Ident;

use super::{NUMBER, number};
use crate::model::Resolver;
use crate::model::acting::{Effort, Formula};
use crate::model::expressions::bare_name;
use crate::model::facts::Reads;
use crate::model::ids::FormulaId;
use crate::model::mechanism::{AngleSum, DeclaredOutput, OutputKind, Scalar};
use crate::model::names::Kind;
use crate::model::spring_damper::is_rate;
use crate::syntax::tree::{self, Declaration, ExprKind, OutputItem, StatementKind};

impl Resolver<'_> {
    /// A field for an output whose name is known, if not its value.
    pub(super) fn named_output_of_stub(&mut self, tree: &Declaration, item: &OutputItem) {
        let named = bare_name(&item.value);
        let is_number =
            |name: &&Ident| matches!(self.names.kind(name), Some(Kind::Let | Kind::Unknown));
        let Some(name) = item.name.as_ref().or(named.filter(is_number)) else { return };
        if self.has_field(name) || self.is_formula(name) {
            return;
        }
        if self.reads_forces(&item.value) {
            let effort = Effort::Formula(FormulaId(self.mechanism.dynamics.formulas.len() as u32));
            let formula = Formula { value: Scalar::zero(), dimension: NUMBER, reads: Vec::new() };
            self.mechanism.dynamics.formulas.push(formula);
            return self.ask_once(name, name.clone(), effort);
        }
        // A point under another name is a mistake, and its coordinates may be asked for.
        let whole = named.and_then(|value| self.names.made(value)).and_then(|it| self.whole(it));
        let kind = match whole {
            Some(output) => output.kind,
            None if self.holds_angle(tree, &item.value, tree.statements.len()) => {
                OutputKind::Angle(AngleSum { links: Vec::new(), rest: Scalar::zero() })
            }
            None => number(),
        };
        self.mechanism.outputs.push(DeclaredOutput { field: name.clone(), docs: Vec::new(), kind });
    }

    /// True if an expression holds the angle of a link, directly or under a name that an earlier
    /// statement gives it.
    fn holds_angle(&self, tree: &Declaration, value: &tree::Expr, before: usize) -> bool {
        match &value.kind {
            ExprKind::Member(_, member) => member == "angle",
            ExprKind::Name(name) => {
                let maker = self.names.symbol(name).map(|symbol| symbol.statement);
                let maker = maker.filter(|&maker| maker < before);
                maker.is_some_and(|maker| match &tree.statements[maker].kind {
                    StatementKind::Let { value, .. } => self.holds_angle(tree, value, maker),
                    _ => false,
                })
            }
            _ => value.parts().any(|part| self.holds_angle(tree, part, before)),
        }
    }

    fn is_formula(&self, name: &Ident) -> bool {
        self.mechanism.dynamics.asked.iter().any(|asked| asked.is_formula(name))
    }

    /// True if an expression reads forces as far as it shows.
    fn reads_forces(&self, value: &tree::Expr) -> bool {
        let reads = |resolver: &Self, part: &tree::Expr| match &part.kind {
            ExprKind::Part(..) => true,
            ExprKind::Name(name) => {
                name == "losses" || resolver.names.kind(name) == Some(Kind::Load)
            }
            ExprKind::Member(_, member) => member == "drive" || member == "push",
            _ => is_rate(part),
        };
        self.first(value, &|resolver, part| {
            reads(resolver, part) || resolver.is_law(part, Reads::is_of_forces)
        })
        .is_some()
    }

    pub(super) fn has_field(&self, name: &Ident) -> bool {
        self.mechanism.outputs.iter().any(|output| output.field == *name)
    }

    /// True if an output has become a field.
    pub(super) fn is_given(&self, item: &OutputItem) -> bool {
        let dynamics = &self.mechanism.dynamics;
        let owns = |name: &Ident| dynamics.asked.iter().any(|asked| asked.owner == *name);
        match (&item.name, &item.value.kind) {
            (Some(name), _) => self.has_field(name) || self.is_formula(name),
            (None, ExprKind::Name(name)) => {
                self.has_field(name) || owns(name) || name == "energy" && dynamics.energy
            }
            (None, ExprKind::Part(path)) => owns(&path[0]),
            (None, ExprKind::Member(owner, member)) => {
                let of_both = format_ident!("{owner}_{member}");
                self.has_field(owner) || self.has_field(&of_both) || owns(owner)
            }
            _ => false,
        }
    }
}
