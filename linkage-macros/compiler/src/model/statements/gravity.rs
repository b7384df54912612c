//! `gravity (0, -g);`: the acceleration of what falls, in ground axes.

use proc_macro2::Span;
use syn::Attribute;

use crate::syntax::tree::{Expr, GravityStatement};

use crate::model::mechanism::Dimension;
use crate::model::numbers;
use crate::model::scope::Scope;
use crate::model::statements::{Rules, acts};

impl Rules for GravityStatement {
    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.value.iter().for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        gravity(scope, self.at, &self.value);
    }
}

/// Gravity is given once, and no input changes it.
fn gravity(scope: &mut Scope<'_>, at: Span, value: &[Expr; 2]) {
    let acceleration = Dimension::LENGTH.times(Dimension::TIME, -2);
    let value = [0, 1].map(|k| {
        acts::changes_with_no_input(scope, &value[k], "gravity")?;
        numbers::scalar(scope, &value[k], acceleration)
    });
    if scope.facts.gravity_at.replace(at).is_some() {
        let message = "gravity is given twice; remove one";
        scope.diagnostics.error(at, message);
    }
    if let [Some(x), Some(y)] = value {
        scope.mechanism.dynamics.gravity = Some([x, y]);
    }
}
