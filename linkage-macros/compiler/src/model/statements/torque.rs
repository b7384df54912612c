//! `torque t on DC;` and `torque t between AB and DC;`.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::{Expr, TorqueBetweenStatement, TorqueStatement};

use crate::model::acting::Torque;
use crate::model::mechanism::{Carrier, Dimension, Scalar};
use crate::model::scope::Scope;
use crate::model::statements::{Rules, acts};
use crate::model::uses;

impl Rules for TorqueStatement {
    fn builds_on(&self) -> Vec<&Ident> {
        vec![&self.on]
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        f(&self.value);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        let on = uses::link(scope, &self.on).map(Carrier::Link);
        let value = acts::acting(scope, &self.value, Dimension::TORQUE);
        scope.mechanism.dynamics.torques.extend(torque(on, None, value));
    }
}

impl Rules for TorqueBetweenStatement {
    fn builds_on(&self) -> Vec<&Ident> {
        self.bodies.iter().collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        f(&self.value);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        let torque = torque_between(scope, &self.value, &self.bodies);
        scope.mechanism.dynamics.torques.extend(torque);
    }
}

fn torque_between(scope: &mut Scope<'_>, value: &Expr, names: &[Ident; 2]) -> Option<Torque> {
    let value = acts::acting(scope, value, Dimension::TORQUE);
    let [against, on] = acts::two_bodies(scope, names, "a torque acts")?;
    torque(Some(on), Some(against), value)
}

fn torque(on: Option<Carrier>, against: Option<Carrier>, value: Option<Scalar>) -> Option<Torque> {
    Some(Torque { on: on?, against, value: value? })
}
