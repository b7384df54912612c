//! Outputs: the fields of the result.

use proc_macro2::{Ident, Span};
use quote::format_ident;
use syn::Attribute;

use crate::diagnostics::nearest;
use crate::syntax::anatomy::GroupSpec;
use crate::syntax::tree::{Declaration, Expr, ExprKind, OutputItem, StatementKind};

use super::Resolver;
use super::expressions::{Allowed, ResolvedExpr, bare_name};
use super::mechanism::{DeclaredOutput, LinkId, OutputKind, Scalar as Resolved};
use super::names::{Entity, Kind};

pub(super) const MEMBERS: [&str; 4] = ["angle", "slide", "margin", "transmission"];

impl Resolver<'_> {
    /// The outputs that are asked for; every moving point and every link where none is.
    pub(super) fn outputs(&mut self, tree: &Declaration) {
        let mut is_asked = false;
        for statement in &tree.statements {
            if let StatementKind::Output { items } = &statement.kind {
                is_asked = true;
                for item in items {
                    self.output(&statement.docs, item);
                }
            }
        }
        if !is_asked {
            self.every_effort_is_given();
        }
        // Who asks for forces alone has asked nothing about the motion.
        let dynamics = &self.mechanism.dynamics;
        let is_about_forces = !dynamics.asked.is_empty() || dynamics.energy;
        if !is_asked || is_about_forces && self.mechanism.outputs.is_empty() {
            self.every_moving_thing_is_given();
        }
    }

    fn every_moving_thing_is_given(&mut self) {
        for entity in self.facts.order.clone() {
            match entity {
                Entity::Point(id) if !self.facts.points[id.index()] => {}
                Entity::Unknown(id) => {
                    let at = self.mechanism.unknowns[id.index()].name.span();
                    self.give_whole(at, &[], entity);
                }
                _ => self.mechanism.outputs.extend(self.whole(entity)),
            }
        }
    }

    /// A point, a link, an unknown or a named expression as an output, under its own name.
    pub(super) fn whole(&self, entity: Entity) -> Option<DeclaredOutput> {
        let mechanism = &self.mechanism;
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
                let (value, dimension) = (Resolved::Unknown(id), unknown.dimension);
                let kind = OutputKind::Value { value, dimension };
                DeclaredOutput { field: unknown.name.clone(), docs: unknown.docs.clone(), kind }
            }
            _ => return None,
        })
    }

    fn give_whole(&mut self, at: Span, docs: &[Attribute], entity: Entity) {
        if let Some(DeclaredOutput { field, docs: own, kind }) = self.whole(entity) {
            self.give(at, field, &[docs, &own].concat(), kind);
        }
    }

    pub(super) fn output(&mut self, docs: &[Attribute], item: &OutputItem) {
        match (&item.name, &item.value.kind) {
            (Some(name), _) if item.renamed_at.is_some() => self.name_stands_in_front(name, item),
            (Some(name), _) => self.named_output(docs, name, &item.value),
            (None, ExprKind::Name(name)) => self.whole_output(docs, name),
            (None, ExprKind::Member(owner, member)) => self.member_output(docs, owner, member),
            (None, ExprKind::Part(path)) => self.part_output(docs, path),
            (None, ExprKind::Mistake) => {}
            (None, _) => {
                if self.expression(&item.value, Allowed::IN_OUTPUTS).is_none() {
                    return;
                }
                let message = "an expression needs a name; write `output name = …`";
                let reason = "the name is the field of the result";
                self.diagnostics.error_because(item.value.span, message, reason);
            }
        }
    }

    /// `fold = BC.angle - DC.angle`
    fn named_output(&mut self, docs: &[Attribute], name: &Ident, value: &Expr) {
        let is_new = self.output_name_is_new(name);
        let quantity = self.expression(value, Allowed::IN_OUTPUTS);
        let (Some(quantity), Some(())) = (quantity, is_new) else { return };
        match quantity.reads.is_of_forces() {
            true => self.give_formula((name, docs), value, quantity),
            false => self.give_quantity(name, docs, quantity),
        }
    }

    /// A number, or an angle that contains link angles.
    fn give_quantity(&mut self, name: &Ident, docs: &[Attribute], quantity: ResolvedExpr) {
        let kind = if quantity.links.is_empty() {
            let dimension = quantity.measure.dimension();
            OutputKind::Value { value: quantity.rest, dimension }
        } else {
            OutputKind::Angle(quantity.turn())
        };
        self.give(name.span(), name.clone(), docs, kind);
    }

    /// Reports `C as tip`.
    fn name_stands_in_front(&mut self, name: &Ident, item: &OutputItem) {
        let whole = bare_name(&item.value).filter(|value| {
            matches!(self.names.kind(value), Some(Kind::Point | Kind::Link | Kind::Unknown))
        });
        let (message, reason) = match whole {
            Some(whole) => (
                format!("leave out `as {name}`"),
                format!(
                    "the result has the field `{whole}`, named as it is declared; rename it there"
                ),
            ),
            None => (
                format!("write the name in front: `output {name} = …`"),
                "the name of a number is the field of the result".to_string(),
            ),
        };
        self.diagnostics.error_because(
            item.renamed_at.expect("`as` stands there"),
            message,
            reason,
        );
    }

    /// The name of an expression is not the name of anything else.
    fn output_name_is_new(&mut self, name: &Ident) -> Option<()> {
        let Some(kind) = self.names.kind(name) else {
            return Some(());
        };
        let message = format!("the name `{name}` is taken; choose another");
        let reason = format!("`{name}` is {}", kind.one());
        self.diagnostics.error_because(name.span(), message, reason);
        None
    }

    /// `blade`: a point, a link, or a `let`.
    fn whole_output(&mut self, docs: &[Attribute], name: &Ident) {
        let is_of_forces = self.output_of_the_whole(docs, name) || self.pull_output(docs, name);
        if is_of_forces || self.output_is_a_result(name).is_none() {
            return;
        }
        if name == "power" && self.names.kind(name).is_none() {
            let message = "there is no `power`; write `output energy` or the `drive` of an input";
            let reason = "the power of a drive is its effort times the rate that you give";
            return self.diagnostics.error_because(name.span(), message, reason);
        }
        match self.usable(name, &[Kind::Point, Kind::Link, Kind::Let, Kind::Unknown]) {
            Some(entity @ (Entity::Unknown(_) | Entity::Point(_))) => {
                self.give_whole(name.span(), docs, entity);
            }
            Some(Entity::Link(link)) => {
                let slide = self.mechanism.links[link.index()].slides;
                self.give_link(docs, name, link, OutputKind::Link { link, direction: true, slide });
            }
            Some(entity @ (Entity::Let(_) | Entity::Law(_))) => self.let_output(docs, name, entity),
            _ => {}
        }
    }

    /// A `let` under its own name; a law stands in `forces`.
    fn let_output(&mut self, docs: &[Attribute], name: &Ident, entity: Entity) {
        let quantity = self.value_of_let(name, entity, Allowed::IN_FORCES);
        let Some(mut quantity) = quantity else { return };
        if let Entity::Let(id) = entity {
            quantity.rest = self.mechanism.lets[id.index()].rest.clone();
        }
        if !quantity.reads.is_of_forces() {
            return self.give_quantity(name, docs, quantity);
        }
        let kind = ExprKind::Name(name.clone());
        let value = Expr { kind, span: name.span().into() };
        self.give_formula((name, docs), &value, quantity);
    }

    /// Reports a name that is given from outside or stands in the ground: it is no result.
    fn output_is_a_result(&mut self, name: &Ident) -> Option<()> {
        let kind = self.names.kind(name);
        let reason = match kind {
            Some(Kind::Input | Kind::Param) => {
                format!("an expression of it is given by a name: `output twice = 2 * {name}`")
            }
            Some(Kind::Guide) => "the link that carries it has a direction".to_string(),
            Some(Kind::Spring) => {
                format!(
                    "between points it has `{name}.force` and `{name}.length`, between links \
                         `{name}.torque` and `{name}.angle`"
                )
            }
            Some(Kind::Stop) => format!("it has `{name}.force` and `{name}.gap`"),
            Some(Kind::Load) => "it is given, at each call".to_string(),
            _ => return Some(()),
        };
        let kind = kind.map_or(String::new(), Kind::one);
        let message = format!("`{name}` is {kind}, and an output is a point or a link");
        self.diagnostics.error_because(name.span(), message, reason);
        None
    }

    /// `DC.angle`, `ram.slide`, `BC.margin`, `BC.transmission`
    fn member_output(&mut self, docs: &[Attribute], owner: &Ident, member: &Ident) {
        if self.effort_output(docs, owner, member) {
            return;
        }
        let part = member.to_string();
        if self.names.kind(owner) == Some(Kind::Point) {
            return self.coordinate_output(docs, owner, member);
        }
        if self.names.kind(owner) == Some(Kind::Unknown) {
            let message = format!("write `output {owner}`");
            let reason =
                format!("`{owner}` is a number, and `velocity` and `motion` give its rates");
            return self.diagnostics.error_because(member.span(), message, reason);
        }
        if !MEMBERS.contains(&part.as_str()) {
            if part == "friction" {
                return self.friction_is_at_a_joint(owner, member);
            }
            // The parts of an unknown link are unknown too.
            if self.link(owner).is_some() {
                self.member_exists(owner, member);
            }
            return;
        }
        let Some(link) = self.link(owner) else {
            return;
        };
        let kind = match part.as_str() {
            "angle" => OutputKind::Link { link, direction: true, slide: false },
            "slide" => match self.link_slides(owner, link, member) {
                Some(()) => OutputKind::Link { link, direction: false, slide: true },
                None => return,
            },
            _ => {
                let made_by = self.mechanism.links[link.index()].made_by;
                let Some(()) = self.group_has_a_limit(link, member) else {
                    return;
                };
                let kind = match part.as_str() {
                    "margin" => OutputKind::Margin(made_by),
                    _ => OutputKind::Transmission(made_by),
                };
                let field = format_ident!("{owner}_{part}", span = owner.span());
                return self.give(member.span(), field, docs, kind);
            }
        };
        self.give_link(docs, member, link, kind);
    }

    /// `blade.x`: the field `blade_x`.
    fn coordinate_output(&mut self, docs: &[Attribute], owner: &Ident, member: &Ident) {
        if let Some(quantity) = self.member(owner, member, Allowed::IN_DIMENSIONS) {
            let dimension = quantity.measure.dimension();
            let field = format_ident!("{owner}_{member}", span = owner.span());
            let kind = OutputKind::Value { value: quantity.rest, dimension };
            self.give(member.span(), field, docs, kind);
        }
    }

    /// Reports a part that links do not have. A point or guide that was reported as unknown may be a
    /// joint of the link.
    fn member_exists(&mut self, owner: &Ident, member: &Ident) {
        let part = member.to_string();
        if self.reported_unknown.contains(&part) {
            return;
        }
        let (message, reason) = match part.as_str() {
            "omega" | "alpha" => (
                format!("rates need no output of their own; write `output {owner}.angle`"),
                format!("`velocity` gives `{owner}.omega` and `motion` also `{owner}.alpha`"),
            ),
            "x" | "y" => (
                format!("`{owner}` is a link and has no `{part}`; name a point"),
                format!("a point of it is declared `point P on {owner} at (x, y);`"),
            ),
            "torque" | "force" | "moment" | "reaction" => (
                format!(
                    "a link has no `{part}`; name its drive, or the joint at which a force acts"
                ),
                match self.forces_of(owner) {
                    Some(known) => known,
                    None => "nothing has mass and nothing acts, so there are no forces".to_string(),
                },
            ),
            _ => {
                let near = nearest(&part, MEMBERS.into_iter());
                let near = near.map(|near| format!("; one with a similar name exists: `{near}`"));
                (
                    format!("a link has no `{part}`{}", near.unwrap_or_default()),
                    format!(
                        "it has `angle`, `slide` if it slides, `margin` and `transmission`{}",
                        self.forces_too(owner)
                    ),
                )
            }
        };
        self.diagnostics.error_because(member.span(), message, reason);
    }

    /// Only a dyad has a transmission angle, and only one that can be out of reach a margin.
    fn group_has_a_limit(&mut self, link: LinkId, member: &Ident) -> Option<()> {
        let group = self.mechanism.links[link.index()].made_by;
        let keyword = self.mechanism.groups[group.index()].keyword.to_string();
        let anatomy = GroupSpec::of(&keyword)?;
        if anatomy.has_a_limit() || anatomy.is_dyad() && member == "transmission" {
            return Some(());
        }
        let message = format!("`{keyword}` has no `{member}`");
        let reason = match anatomy.is_dyad() {
            true => "it is never out of reach; `transmission` tells how far from parallel",
            false => "a driver transmits what it is given; ask the dyads that follow",
        };
        self.diagnostics.error_because(member.span(), message, reason);
        None
    }

    /// A link's angle and its slide, asked for one by one, make one field.
    fn give_link(&mut self, docs: &[Attribute], at: &Ident, link: LinkId, kind: OutputKind) {
        let OutputKind::Link { direction: new_direction, slide: new_slide, .. } = kind else {
            return;
        };
        for output in &mut self.mechanism.outputs {
            match &mut output.kind {
                OutputKind::Link { link: known, direction, slide }
                    if *known == link
                        && !(*direction && new_direction)
                        && !(*slide && new_slide) =>
                {
                    *direction |= new_direction;
                    *slide |= new_slide;
                    return;
                }
                _ => {}
            }
        }
        let declared = &self.mechanism.links[link.index()];
        let (field, own) = (declared.name.clone(), declared.docs.clone());
        self.give(at.span(), field, &[docs, &own].concat(), kind);
    }

    /// A field of the result is given once.
    pub(super) fn give(&mut self, span: Span, field: Ident, docs: &[Attribute], kind: OutputKind) {
        let asked = &self.mechanism.dynamics.asked;
        if self.mechanism.outputs.iter().any(|output| output.field == field)
            || asked.iter().any(|asked| asked.is_formula(&field))
        {
            return self.output_is_given_twice(span, &field.to_string());
        }
        self.mechanism.outputs.push(DeclaredOutput { field, docs: docs.to_vec(), kind });
    }
}
