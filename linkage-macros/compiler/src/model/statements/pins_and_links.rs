//! `pin`, `link` and `drive`, which `drawn` makes into drivers and groups before any rule is asked.

use proc_macro2::Ident;
use syn::Attribute;

use crate::syntax::tree::{DriveStatement, Expr, GroupStatement, LinkStatement, PinStatement};

use crate::model::declared;
use crate::model::mechanism::PartOf;
use crate::model::names::{Entity, Kind};
use crate::model::scope::Scope;
use crate::model::statements::Rules;

impl Rules for PinStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        self.points.iter().map(|(name, _)| (name, Kind::Point)).collect()
    }

    fn title(&self, name: &str) -> String {
        format!("pin {name}")
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.points.iter().flat_map(|(_, place)| place).for_each(f);
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let by_itself = declared::group_by_itself(scope, "pin", name);
        Some(Entity::Point(declared::new_point(scope, docs, name, PartOf::Pin(by_itself))))
    }
}

impl Rules for LinkStatement {
    fn declares(&self) -> Vec<(&Ident, Kind)> {
        self.links.iter().map(|link| (&link.name, Kind::Link)).collect()
    }

    fn builds_on(&self) -> Vec<&Ident> {
        self.links.iter().flat_map(|link| link.pins.iter().chain(&link.on)).collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.fields.iter().flat_map(GroupStatement::values).for_each(f);
    }

    fn stand_in(&self, scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) -> Option<Entity> {
        let slides = !self.links.iter().find(|link| link.name == *name)?.on.is_empty();
        let by_itself = declared::group_by_itself(scope, "link", name);
        Some(Entity::Link(declared::new_link(scope, docs, name, by_itself, slides)))
    }
}

impl Rules for DriveStatement {
    fn title(&self, _name: &str) -> String {
        format!("drive {}.{}", self.link, self.member)
    }

    fn builds_on(&self) -> Vec<&Ident> {
        [&self.link].into_iter().chain(self.to.iter().map(|(link, _)| link)).collect()
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        f(&self.value);
    }
}
