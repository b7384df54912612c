//! Outputs: the fields of the result.

use std::collections::HashSet;

use proc_macro2::Ident;
use quote::format_ident;
use syn::Attribute;

use crate::diagnostics::nearest;
use crate::syntax::anatomy::GroupSpec;
use crate::syntax::tree::{
    Declaration, Expr, ExprKind, OutputItem, OutputStatement, StatementKind,
};

use crate::model::link_efforts::MEMBERS;
use crate::model::machine_functions::point_function;
use crate::model::mechanism::{LinkId, OutputKind};
use crate::model::names::{Entity, Kind};
use crate::model::ratios::is_of_the_pose;
use crate::model::reads::Allowed;
use crate::model::resolved_expr::{ResolvedExpr, bare_name};
use crate::model::scope::Scope;
use crate::model::statements::{Rules, drive_by};
use crate::model::{
    dynamics_outputs, effort_formulas, expressions, fits, given, laws, readings, uses,
};

/// An output may name anything, wherever it stands: [`outputs`] resolves it.
impl Rules for OutputStatement {
    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        self.items.iter().for_each(|item| f(&item.value));
    }
}

/// The outputs that are asked for; every moving point and every link where none is.
pub(in crate::model) fn outputs(scope: &mut Scope<'_>, tree: &Declaration) {
    let all = tree.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Output(output) => Some((statement, output)),
        _ => None,
    });
    let (beside, asked): (Vec<_>, Vec<_>) = all.partition(|(_, output)| output.is_beside);
    for (statement, OutputStatement { items, .. }) in &asked {
        items.iter().for_each(|item| output(scope, &statement.docs, item));
    }
    if asked.is_empty() {
        dynamics_outputs::every_effort_is_given(scope);
    }
    // Who asks for forces alone has asked nothing about the motion.
    let dynamics = &scope.mechanism.dynamics;
    let is_about_forces = !dynamics.asked.is_empty() || dynamics.energy;
    if asked.is_empty() || is_about_forces && scope.mechanism.outputs.is_empty() {
        every_moving_thing_is_given(scope);
    }
    let given: HashSet<_> = scope.mechanism.outputs.iter().map(|it| it.field.to_string()).collect();
    let is_new = |item: &&OutputItem| match &item.value.kind {
        ExprKind::Name(name) => item.name.is_some() || !given.contains(&name.to_string()),
        _ => true,
    };
    for (statement, OutputStatement { items, .. }) in &beside {
        items.iter().filter(is_new).for_each(|item| output(scope, &statement.docs, item));
    }
}

fn every_moving_thing_is_given(scope: &mut Scope<'_>) {
    for entity in scope.facts.order.clone() {
        match entity {
            Entity::Point(id) if !scope.facts.points[id.index()] => {}
            Entity::Unknown(id) => {
                let at = scope.mechanism.unknowns[id.index()].name.span();
                given::give_whole(scope, at, &[], entity);
            }
            _ => scope.mechanism.outputs.extend(given::whole(scope, entity)),
        }
    }
}

pub(in crate::model) fn output(scope: &mut Scope<'_>, docs: &[Attribute], item: &OutputItem) {
    match (&item.name, &item.value.kind) {
        (Some(name), _) if item.renamed_at.is_some() => name_stands_in_front(scope, name, item),
        (Some(name), _) => named_output(scope, docs, name, &item.value),
        (None, ExprKind::Name(name)) => whole_output(scope, docs, name),
        (None, ExprKind::Member(owner, member)) => {
            member_output(scope, docs, owner, member);
        }
        (None, ExprKind::Part(path)) => effort_formulas::part_output(scope, docs, path),
        (None, ExprKind::Mistake) => {}
        (None, _) => {
            if expressions::expression(scope, &item.value, Allowed::IN_OUTPUTS).is_none() {
                return;
            }
            let message = "an expression needs a name; write `output name = …`";
            let reason = "the name is the field of the result";
            scope.diagnostics.error_because(item.value.span, message, reason);
        }
    }
}

/// `fold = BC.angle - DC.angle`, `I = pole(BC)`
fn named_output(scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident, value: &Expr) {
    let is_new = output_name_is_new(scope, name);
    if let (Some(point), ExprKind::Call(function, arguments)) = (point_function(value), &value.kind)
    {
        let kind = is_new.and_then(|()| (point.output)(scope, function, arguments));
        kind.into_iter().for_each(|kind| given::give(scope, name.span(), name.clone(), docs, kind));
        return;
    }
    let quantity = expressions::expression(scope, value, Allowed::IN_OUTPUTS);
    let (Some(quantity), Some(())) = (quantity, is_new) else { return };
    give_number(scope, (name, docs), value, quantity);
}

/// A number among the forces where it is one of them, or of the pose.
fn give_number(
    scope: &mut Scope<'_>,
    (name, docs): (&Ident, &[Attribute]),
    value: &Expr,
    quantity: ResolvedExpr,
) {
    if is_of_the_pose(&scope.mechanism, &quantity) {
        if fits::no_link_angle(scope, value, &quantity).is_some() {
            let dimension = quantity.measure.dimension();
            let kind = OutputKind::Ratio { value: quantity.rest, dimension };
            given::give(scope, name.span(), name.clone(), docs, kind);
        }
        return;
    }
    match quantity.reads.is_of_forces() {
        true => effort_formulas::give_formula(scope, (name, docs), value, quantity),
        false => give_quantity(scope, name, docs, quantity),
    }
}

/// A number, or an angle that contains link angles.
fn give_quantity(scope: &mut Scope<'_>, name: &Ident, docs: &[Attribute], quantity: ResolvedExpr) {
    let kind = if quantity.links.is_empty() {
        let dimension = quantity.measure.dimension();
        OutputKind::Value { value: quantity.rest, dimension }
    } else {
        OutputKind::Angle(quantity.turn())
    };
    given::give(scope, name.span(), name.clone(), docs, kind);
}

/// Reports `C as tip`.
fn name_stands_in_front(scope: &mut Scope<'_>, name: &Ident, item: &OutputItem) {
    let whole = bare_name(&item.value).filter(|value| {
        matches!(scope.names.kind(value), Some(Kind::Point | Kind::Link | Kind::Unknown))
    });
    let (message, reason) = match whole {
        Some(whole) => (
            format!("leave out `as {name}`"),
            format!("the result has the field `{whole}`, named as it is declared; rename it there"),
        ),
        None => (
            format!("write the name in front: `output {name} = …`"),
            "the name of a number is the field of the result".to_string(),
        ),
    };
    scope.diagnostics.error_because(item.renamed_at.expect("`as` stands there"), message, reason);
}

/// The name of an expression is not the name of anything else.
fn output_name_is_new(scope: &mut Scope<'_>, name: &Ident) -> Option<()> {
    let Some(kind) = scope.names.kind(name) else {
        return Some(());
    };
    let message = format!("the name `{name}` is taken; choose another");
    let reason = format!("`{name}` is {}", kind.one());
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// `blade`: a point, a link, or a `let`.
fn whole_output(scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident) {
    let is_of_forces = dynamics_outputs::output_of_the_whole(scope, docs, name)
        || drive_by::pull_output(scope, docs, name);
    if is_of_forces || output_is_a_result(scope, name).is_none() {
        return;
    }
    if name == "power" && scope.names.kind(name).is_none() {
        let message = "there is no `power`; write `output energy` or the `drive` of an input";
        let reason = "the power of a drive is its effort times the rate that you give";
        return scope.diagnostics.error_because(name.span(), message, reason);
    }
    match uses::usable(scope, name, &[Kind::Point, Kind::Link, Kind::Let, Kind::Unknown]) {
        Some(entity @ (Entity::Unknown(_) | Entity::Point(_))) => {
            given::give_whole(scope, name.span(), docs, entity);
        }
        Some(Entity::Link(link)) => {
            let slide = scope.mechanism.links[link.index()].slides;
            given::give_link(
                scope,
                docs,
                name,
                link,
                OutputKind::Link { link, direction: true, slide },
            );
        }
        Some(entity @ (Entity::Let(_) | Entity::Law(_))) => let_output(scope, docs, name, entity),
        _ => {}
    }
}

/// A `let` under its own name; a law stands in `forces`.
fn let_output(scope: &mut Scope<'_>, docs: &[Attribute], name: &Ident, entity: Entity) {
    let quantity = laws::value_of_let(scope, name, entity, Allowed::IN_FORCES);
    let Some(mut quantity) = quantity else { return };
    if let Entity::Let(id) = entity {
        quantity.rest = scope.mechanism.lets[id.index()].rest.clone();
    }
    let kind = ExprKind::Name(name.clone());
    let value = Expr { kind, span: name.span().into() };
    give_number(scope, (name, docs), &value, quantity);
}

/// Reports a name that is given from outside or stands in the ground: it is no result.
fn output_is_a_result(scope: &mut Scope<'_>, name: &Ident) -> Option<()> {
    let kind = scope.names.kind(name);
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
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// `DC.angle`, `ram.slide`, `BC.margin`, `BC.transmission`
fn member_output(scope: &mut Scope<'_>, docs: &[Attribute], owner: &Ident, member: &Ident) {
    if dynamics_outputs::effort_output(scope, docs, owner, member) {
        return;
    }
    let part = member.to_string();
    if scope.names.kind(owner) == Some(Kind::Point) {
        return coordinate_output(scope, docs, owner, member);
    }
    if scope.names.kind(owner) == Some(Kind::Unknown) {
        let message = format!("write `output {owner}`");
        let reason = format!("`{owner}` is a number, and `velocity` and `motion` give its rates");
        return scope.diagnostics.error_because(member.span(), message, reason);
    }
    if !MEMBERS.contains(&part.as_str()) {
        if part == "friction" {
            return effort_formulas::friction_is_at_a_joint(scope, owner, member);
        }
        // The parts of an unknown link are unknown too.
        if uses::link(scope, owner).is_some() {
            member_exists(scope, owner, member);
        }
        return;
    }
    let Some(link) = uses::link(scope, owner) else {
        return;
    };
    let kind = match part.as_str() {
        "angle" => OutputKind::Link { link, direction: true, slide: false },
        "slide" => match readings::link_slides(scope, owner, link, member) {
            Some(()) => OutputKind::Link { link, direction: false, slide: true },
            None => return,
        },
        _ => {
            let made_by = scope.mechanism.links[link.index()].made_by;
            let Some(()) = group_has_a_limit(scope, link, member) else {
                return;
            };
            let kind = match part.as_str() {
                "margin" => OutputKind::Margin(made_by),
                _ => OutputKind::Transmission(made_by),
            };
            let field = format_ident!("{owner}_{part}", span = owner.span());
            return given::give(scope, member.span(), field, docs, kind);
        }
    };
    given::give_link(scope, docs, member, link, kind);
}

/// `blade.x`: the field `blade_x`.
fn coordinate_output(scope: &mut Scope<'_>, docs: &[Attribute], owner: &Ident, member: &Ident) {
    if let Some(quantity) = readings::member(scope, owner, member, Allowed::IN_DIMENSIONS) {
        let dimension = quantity.measure.dimension();
        let field = format_ident!("{owner}_{member}", span = owner.span());
        let kind = OutputKind::Value { value: quantity.rest, dimension };
        given::give(scope, member.span(), field, docs, kind);
    }
}

/// Reports a part that links do not have. A point or guide that was reported as unknown may be a
/// joint of the link.
fn member_exists(scope: &mut Scope<'_>, owner: &Ident, member: &Ident) {
    let part = member.to_string();
    if scope.names.reported_unknown.contains(&part) {
        return;
    }
    let (message, reason) = match part.as_str() {
        "omega" | "alpha" => (
            format!("rates need no output of their own; write `output {owner}.angle`"),
            format!("`velocity` gives `{owner}.omega` and `motion` also `{owner}.alpha`"),
        ),
        "velocity" | "speed" | "rate" => {
            let slides = readings::slides(scope, owner);
            let moving = if slides { "slide" } else { "angle" };
            (
                format!("rates need no output of their own; write `output {owner}.{moving}`"),
                format!(
                    "`velocity` gives its rate; a number is `output v = rate({owner}.{moving})`"
                ),
            )
        }
        "x" | "y" => (
            format!("`{owner}` is a link and has no `{part}`; name a point"),
            format!("a point of it is declared `point P on {owner} at (x, y);`"),
        ),
        "torque" | "force" | "moment" | "reaction" => (
            format!("a link has no `{part}`; name its drive, or the joint at which a force acts"),
            match dynamics_outputs::forces_of(scope, owner) {
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
                    dynamics_outputs::forces_too(scope, owner)
                ),
            )
        }
    };
    scope.diagnostics.error_because(member.span(), message, reason);
}

/// Only a dyad has a transmission angle, and only one that can be out of reach a margin.
fn group_has_a_limit(scope: &mut Scope<'_>, link: LinkId, member: &Ident) -> Option<()> {
    let group = scope.mechanism.links[link.index()].made_by;
    let keyword = scope.mechanism.groups[group.index()].keyword.to_string();
    let anatomy = GroupSpec::of(&keyword)?;
    let is_parallel = member == "margin" && scope.mechanism.is_parallel(group);
    if !is_parallel && anatomy.has_a_limit() || anatomy.is_dyad() && member == "transmission" {
        return Some(());
    }
    let message = match is_parallel {
        true => format!("a parallelogram has no `{member}`"),
        false => format!("`{keyword}` has no `{member}`"),
    };
    let reason = match anatomy.is_dyad() {
        true if is_parallel => {
            "it is never out of reach; `transmission` tells how far its joints are from one line"
        }
        true => "it is never out of reach; `transmission` tells how far from parallel",
        false => "a driver transmits what it is given; ask the dyads that follow",
    };
    scope.diagnostics.error_because(member.span(), message, reason);
    None
}
