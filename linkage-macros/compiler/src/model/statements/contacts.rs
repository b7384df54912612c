//! Friction at pins and guides: the two bodies that rub, and the reaction that presses them together.

use proc_macro2::{Ident, Span};
use syn::Attribute;

use crate::syntax::tree::{
    Action, Declaration, Expr, FrictionSite, FrictionStatement, StatementKind,
};

use crate::model::acting::{Contact, Friction};
use crate::model::mechanism::{Body, Carrier, Dimension, Drive, LinkId, PartOf, PointId};
use crate::model::names::{Kind, listed};
use crate::model::scope::Scope;
use crate::model::statements::{Rules, acts, friction_numbers, mass};
use crate::model::{drawn_sliding, meant, unknown_friction, uses};

/// The most joints that rub where a load drives an input.
const MOST: usize = 8;

impl Rules for FrictionStatement {
    fn builds_on(&self) -> Vec<&Ident> {
        match &self.site {
            FrictionSite::Pin(name) | FrictionSite::Slider(name) => vec![name],
            FrictionSite::LinkAtPin(link, pin) => vec![link, pin],
            FrictionSite::Between([first, second], pin) => vec![first, second, pin],
        }
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        let Self { coefficient, radius, length, smooth, .. } = self;
        [coefficient].into_iter().chain(radius).chain(length).chain(smooth).for_each(f);
    }

    fn resolve(&self, _scope: &mut Scope<'_>, _docs: &[Attribute]) {
        // Which links meet at a pin is known when all are: `frictions`.
    }
}

/// A pin's friction as it is written of a link.
fn of_link(link: &Ident, pin: &Ident) -> String {
    format!("`friction 0.1 on {link} at {pin} radius 8mm`")
}

/// Friction of every joint that is said to have some, once all joints are known. Where anything was
/// reported, a joint may be missing.
pub(in crate::model) fn frictions(scope: &mut Scope<'_>, tree: &Declaration) {
    if scope.diagnostics.count() > 0 {
        return;
    }
    for statement in &tree.statements {
        let StatementKind::Action(Action::Friction(written)) = &statement.kind else {
            continue;
        };
        if !scope.mechanism.unknowns.is_empty() {
            unknown_friction::beside_an_unknown(scope, written.at);
            continue;
        }
        let Some(friction) = friction(scope, written) else { continue };
        if too_many_rub(scope, written.at) {
            return;
        }
        let known = &scope.mechanism.dynamics.frictions;
        if known.iter().any(|known| known.contact.is_at(friction.contact)) {
            let message = format!(
                "the friction of `{}` is given twice; remove one",
                scope.mechanism.contact_name(friction.contact)
            );
            scope.diagnostics.error(written.at, message);
            continue;
        }
        scope.mechanism.dynamics.frictions.push(friction);
    }
}

/// Friction is of what presses: where nothing has mass or acts, nothing does. It waits for other mistakes.
pub(in crate::model) fn frictions_are_pressed(scope: &mut Scope<'_>, tree: &Declaration) {
    let waits = scope.names.use_is_hidden || !scope.mechanism.dynamics.is_empty();
    let mut statements = tree.statements.iter().filter(|_| !waits);
    let first = statements.find_map(|statement| match &statement.kind {
        StatementKind::Action(Action::Friction(friction)) => Some(friction.at),
        _ => None,
    });
    if let Some(at) = first {
        let message =
            "friction where nothing presses does nothing; declare a mass or a force, or remove it";
        scope.diagnostics.error_because(at, message, "as in `mass 2kg on P`");
    }
}

/// Beside a load that drives all amounts follow from each other, and the code for them grows with their cube.
fn too_many_rub(scope: &mut Scope<'_>, at: Span) -> bool {
    let dynamics = &scope.mechanism.dynamics;
    let Some((_, load)) = dynamics.driven().filter(|_| dynamics.frictions.len() == MOST) else {
        return false;
    };
    let message = format!("a joint too many rubs beside `{}`, which drives an input", load.name);
    let reason = "its value and the friction of up to eight joints follow from each other";
    scope.diagnostics.error_because(at, message, reason);
    true
}

fn friction(scope: &mut Scope<'_>, written: &FrictionStatement) -> Option<Friction> {
    let (contact, name) = match &written.site {
        FrictionSite::Slider(link) => (slider(scope, link)?, link.to_string()),
        FrictionSite::Pin(pin) => (only_pair(scope, pin)?, pin.to_string()),
        FrictionSite::LinkAtPin(link, pin) => {
            (link_on_pin(scope, link, pin)?, format!("{link}.{pin}"))
        }
        FrictionSite::Between(bodies, pin) => {
            (pair_at(scope, bodies, pin)?, format!("{}.{pin}", bodies[0]))
        }
    };
    let name = format!("friction at {name}");
    let coefficient = friction_numbers::coefficient(scope, &written.coefficient, &name)?;
    let (radius, length, rate) = match contact {
        Contact::Pin { .. } => {
            friction_numbers::has_no(scope, &written.length, "a pin has a `radius` and no length")?;
            let radius = friction_numbers::radius(scope, written)?;
            let value = mass::not_negative(
                scope,
                radius,
                Dimension::LENGTH,
                "a radius",
                format!("{name}, radius"),
            )?;
            (Some(value), None, Dimension::NUMBER.times(Dimension::TIME, -1))
        }
        Contact::Guide(_) => {
            let message = "what slides has no radius; leave it out";
            friction_numbers::has_no(scope, &written.radius, message)?;
            let length = match &written.length {
                Some(length) => Some(friction_numbers::above_zero(
                    scope,
                    length,
                    Dimension::LENGTH,
                    "a length",
                )?),
                None => None,
            };
            (None, length, Dimension::LENGTH.times(Dimension::TIME, -1))
        }
    };
    let smooth = match &written.smooth {
        Some(smooth) => {
            Some(friction_numbers::above_zero(scope, smooth, rate, "a rate to smooth by")?)
        }
        None => None,
    };
    rubs(scope, contact, written.at)?;
    Some(Friction { contact, coefficient, radius, length, smooth })
}

/// The two bodies move against each other.
fn rubs(scope: &mut Scope<'_>, contact: Contact, at: Span) -> Option<()> {
    let link = contact.link();
    let group = scope.mechanism.group_with(link)?;
    let is_rigid = match &group.outer[0].drive {
        Some(Drive::Angle { angle, relative_to }) => {
            let mechanism = &scope.mechanism;
            let turns = !angle.links.is_empty() || mechanism.moves(&angle.rest);
            let is_own = matches!(contact, Contact::Pin { against, .. } if against == *relative_to);
            is_own && !turns
        }
        Some(Drive::Slide(slide)) => {
            matches!(contact, Contact::Guide(_)) && !scope.mechanism.moves(slide)
        }
        None => false,
    };
    if !is_rigid {
        return Some(());
    }
    let name = scope.mechanism.contact_name(contact);
    let message = format!("nothing moves at `{name}`, and nothing rubs");
    scope.diagnostics.error(at, message);
    None
}

/// `on ram`
fn slider(scope: &mut Scope<'_>, name: &Ident) -> Option<Contact> {
    if scope.names.kind(name) == Some(Kind::Point) {
        let message = format!("`{name}` is a point: write `at {name}`");
        let reason = "a pin's friction is `friction 0.1 at C radius 8mm`";
        scope.diagnostics.error_because(name.span(), message, reason);
        return None;
    }
    if let Some(ram) = meant::slider_on(scope, name) {
        let message = format!("`{name}` is a guide: write `on {ram}`");
        scope.diagnostics.error_because(name.span(), message, "friction is on what slides there");
        return None;
    }
    let link = uses::link(scope, name)?;
    if scope.mechanism.links[link.index()].slides {
        return drawn_sliding::slides_by(scope, name, link).map(Contact::Guide);
    }
    let message = format!("`{name}` does not slide");
    let pin = meant::point_on(scope, link).unwrap_or("P".to_string());
    let reason =
        format!("at one of its pins friction is `friction 0.1 on {name} at {pin} radius 8mm`");
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// The links that meet at a pin: those that stand there, and those that are joined by it.
fn at_pin(scope: &Scope<'_>, pin: PointId) -> (Vec<LinkId>, Vec<LinkId>) {
    let standing = scope.mechanism.standing().into_iter();
    let standing = standing.filter(|(point, _)| *point == pin).map(|(_, link)| link).collect();
    let mut groups = scope.mechanism.group_steps();
    let joined = groups.find(|group| group.pin == Some(pin) && group.links.len() == 2);
    (standing, joined.map_or(Vec::new(), |group| group.links.clone()))
}

/// The body that has the point, if one has: a link that stands there turns against it.
fn base(scope: &Scope<'_>, pin: PointId) -> Option<Carrier> {
    match scope.mechanism.owner(pin)? {
        Body::Ground => Some(Carrier::Ground),
        Body::Link(link) => Some(Carrier::Link(link)),
        Body::Pin(_) => {
            let part = scope.mechanism.points[pin.index()].part_of;
            matches!(part, PartOf::Driven(_)).then_some(Carrier::Ground)
        }
    }
}

/// `at C`: two bodies that meet there, and no load on the pin itself.
fn only_pair(scope: &mut Scope<'_>, name: &Ident) -> Option<Contact> {
    let pin = uses::point(scope, name)?;
    let (mut standing, joined) = at_pin(scope, pin);
    // Beside a link that moves, a part of the ground does not turn.
    let moves = |link: &LinkId| scope.facts.links[link.index()].moves;
    if standing.iter().any(moves) {
        standing.retain(moves);
    }
    match (&standing[..], &joined[..], base(scope, pin)) {
        (&[link], [], Some(against)) if !scope.mechanism.is_loaded_joint(pin) => {
            return Some(Contact::Pin { link, pin, against });
        }
        (&[], &[link, other], _) if !scope.mechanism.dynamics.loads_point(pin) => {
            return Some(Contact::Pin { link, pin, against: Carrier::Link(other) });
        }
        _ => {}
    }
    let links: Vec<_> = joined.iter().chain(&standing).copied().collect();
    unknown_friction::known_by_their_links(scope, name, &links)?;
    let names: Vec<_> = links.iter().map(|link| named_link(scope, *link)).collect();
    let (message, reason) = match (&names[..], joined.len()) {
        ([], _) => (
            format!("no link turns at `{name}`"),
            "a pin's friction stands at a joint, and a slide's is `friction 0.1 on ram`"
                .to_string(),
        ),
        ([first, ..], _) if standing.is_empty() || scope.mechanism.is_loaded_joint(pin) => (
            format!("something is put on `{name}` itself: say which link turns on it"),
            format!("as in {}", of_link(first, name)),
        ),
        ([first, ..], _) => (
            format!("several links meet at `{name}`: say which turns"),
            format!("as in {}; there meet {}", of_link(first, name), quoted_list(&names)),
        ),
    };
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// `on BC at C`
fn link_on_pin(scope: &mut Scope<'_>, name: &Ident, pin_name: &Ident) -> Option<Contact> {
    let (link, pin) = (uses::link(scope, name)?, uses::point(scope, pin_name)?);
    let (standing, joined) = at_pin(scope, pin);
    unknown_friction::known_by_their_links(scope, pin_name, &[&standing[..], &joined].concat())?;
    if let Some(place) = joined.iter().position(|own| *own == link) {
        return Some(Contact::Pin { link, pin, against: Carrier::Link(joined[1 - place]) });
    }
    if standing.contains(&link) {
        if let Some(against) = base(scope, pin) {
            return Some(Contact::Pin { link, pin, against });
        }
        let others: Vec<_> = joined.iter().map(|other| named_link(scope, *other)).collect();
        let message = format!("say against which link `{name}` turns at `{pin_name}`");
        let reason = format!(
            "`friction 0.1 between {name} and {} at {pin_name} radius 8mm`; `{pin_name}` joins {}",
            others[0],
            quoted_list(&others)
        );
        scope.diagnostics.error_because(name.span(), message, reason);
        return None;
    }
    if let (Some(Body::Link(owner)), &[only]) = (scope.mechanism.owner(pin), &standing[..])
        && owner == link
    {
        if scope.mechanism.is_loaded_joint(pin) {
            return other_link_rubs(scope, pin_name, only);
        }
        return Some(Contact::Pin { link: only, pin, against: Carrier::Link(link) });
    }
    let message = format!("`{name}` does not turn at `{pin_name}`");
    let links: Vec<_> =
        standing.iter().chain(&joined).map(|link| named_link(scope, *link)).collect();
    let reason = match links.is_empty() {
        true => format!("no link turns at `{pin_name}`"),
        false => format!("there turn {}", quoted_list(&links)),
    };
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// Something is put on a joint of a drawing: each link is pressed by another force, and what presses this one is not
/// that of the group's friction.
fn other_link_rubs(scope: &mut Scope<'_>, pin: &Ident, other: LinkId) -> Option<Contact> {
    let other = named_link(scope, other);
    let message = format!("something is put on `{pin}` itself: let `{other}` rub");
    scope.diagnostics.error_because(pin.span(), message, format!("as in {}", of_link(&other, pin)));
    None
}

/// `between BC and EF at C`: the one that stands on the pin presses with its own force.
fn pair_at(scope: &mut Scope<'_>, names: &[Ident; 2], pin_name: &Ident) -> Option<Contact> {
    let bodies = acts::two_bodies(scope, names, "friction is")?;
    let pin = uses::point(scope, pin_name)?;
    let (standing, joined) = at_pin(scope, pin);
    let owner = match scope.mechanism.owner(pin)? {
        Body::Ground => vec![Carrier::Ground],
        Body::Link(link) => vec![Carrier::Link(link)],
        Body::Pin(_) => joined.iter().map(|link| Carrier::Link(*link)).collect(),
    };
    let stands = |body: Carrier| match body {
        Carrier::Link(link) => standing.contains(&link).then_some(link),
        Carrier::Ground => None,
    };
    let found =
        [(bodies[0], bodies[1]), (bodies[1], bodies[0])].into_iter().find_map(|(one, against)| {
            let link = match one {
                Carrier::Link(link) if joined.contains(&link) && owner.contains(&against) => link,
                one => stands(one).filter(|_| owner.contains(&against))?,
            };
            Some(Contact::Pin { link, pin, against })
        });
    if found.is_none() {
        let message =
            format!("`{}` and `{}` do not turn on each other at `{pin_name}`", names[0], names[1]);
        let reason = "friction is between a link that stands on the pin and one that has it";
        scope.diagnostics.error_because(pin_name.span(), message, reason);
    }
    found
}

fn named_link(scope: &Scope<'_>, link: LinkId) -> Ident {
    scope.mechanism.links[link.index()].name.clone()
}

fn quoted_list(names: &[Ident]) -> String {
    let names: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
    listed(&names, "and")
}
