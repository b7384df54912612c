//! Messages about links that nothing holds: those that are not joined, and those that no drive moves.

use proc_macro2::Ident;

use crate::chain::machine::{GROUND, Slide};
use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{InputStatement, StatementKind};

use crate::model::drawn::outline::bodies::{Bodies, LinkOutline, PinPlace};
use crate::model::names::listed;
use crate::model::references::names_used;

/// Reports bodies that move when every input is held.
pub(in crate::model::drawn) fn loose(
    bodies: &Bodies<'_>,
    those: &[usize],
    freedoms: usize,
    diagnostics: &mut Diagnostics,
) {
    if let Some(set) = &bodies.tree.unwritten.set {
        return drives_too_little(bodies, set, (those, freedoms), diagnostics);
    }
    let hanging = those.iter().find_map(|&body| hanging(bodies, body));
    if let Some((link, pin)) = hanging.filter(|_| those.len() > 1) {
        let message = format!("`{link}` hangs on `{pin}` alone, and turns about it");
        diagnostics.error_because(link.span(), message, held_by(bodies, link, pin));
        return;
    }
    let Some(last) = bodies.last_link(those) else { return };
    let likely = those.iter().copied().filter(|&body| body != GROUND);
    let likely = likely.map(|body| (bodies.link(body).name, drive(bodies, body)));
    let (link, drive) =
        likely.clone().find_map(|(link, drive)| Some((link, drive?))).unwrap_or_else(|| {
            let pinned = those.iter().find(|&&body| is_pinned_to_the_ground(bodies, body));
            let link = pinned.map_or(last, |&body| bodies.link(body).name);
            (link, format!("drive {link}.angle = …;"))
        });
    let (still, them) =
        if those.len() == 1 { ("still moves", "it") } else { ("still move", "one of them") };
    let few = match freedoms {
        1 => "one drive too few".to_string(),
        _ => format!("{freedoms} drives too few"),
    };
    let message = format!("{} {still} when every input is held: {few}", bodies.listed(those));
    let reason = format!("drive {them}, `{drive}`, or pin {them} to another link");
    diagnostics.error_because(link.span(), message, reason);
}

/// Reports a set of inputs that leaves freedoms.
fn drives_too_little(
    bodies: &Bodies<'_>,
    set: &Ident,
    (those, freedoms): (&[usize], usize),
    diagnostics: &mut Diagnostics,
) {
    let inputs = bodies.tree.statements.iter().map(|statement| match &statement.kind {
        StatementKind::Input(input) => input.names.len(),
        _ => 0,
    });
    let inputs: usize = inputs.sum();
    let more = if freedoms == 1 { "one more" } else { &format!("{freedoms} more") };
    let message = format!("`{set}` drives {inputs} of {} freedoms; name {more}", inputs + freedoms);
    let moves = if those.len() == 1 { "still moves" } else { "still move" };
    let reason = format!("{} {moves} when every input is held", bodies.listed(those));
    diagnostics.error_because(set.span(), message, reason);
}

/// A link with one joint, which it turns about, and the pin.
fn hanging<'b>(bodies: &'b Bodies<'_>, body: usize) -> Option<(&'b Ident, &'b Ident)> {
    let machine = &bodies.machine;
    let slides = machine.slides.iter().any(|slide| [slide.body, slide.carrier].contains(&body));
    let is_driven = machine.drives.iter().any(|drive| drive.bodies.contains(&body));
    let own = machine.bodies.get(body)?;
    let mut joints = own.pins.iter().filter(|&&pin| machine.at(pin).count() > 1);
    let (Some(&pin), None) = (joints.next(), joints.next()) else { return None };
    let hangs = body != GROUND && !slides && !is_driven && own.pins.len() == 1;
    hangs.then(|| (bodies.link(body).name, &bodies.pins[pin].name))
}

/// The statement that holds a link with one pin.
fn held_by(bodies: &Bodies<'_>, link: &Ident, pin: &Ident) -> String {
    if let Some(pins) = pins_in_the_name(&bodies.pins, link).filter(|pins| pins.contains(pin)) {
        return format!("name its other pins: `link {link}({})`", listed_names(&pins));
    }
    let is_free = |guide: usize| !bodies.links.iter().any(|link| link.on.contains(&guide));
    let guides = bodies.guides.iter().enumerate();
    let free = guides.clone().find(|(index, _)| is_free(*index)).or(guides.clone().next());
    let guide = free.map_or("GUIDE".to_string(), |(_, guide)| guide.name.to_string());
    format!(
        "let it slide, `link {link}({pin}) on {guide};`, give it another pin, or drive it: `drive {link}.angle = …;`"
    )
}

/// The pins that a link is named after, as `CE` is after `C` and `E`.
pub(in crate::model::drawn) fn pins_in_the_name(
    pins: &[PinPlace<'_>],
    link: &Ident,
) -> Option<Vec<Ident>> {
    let name = link.to_string();
    let (mut rest, mut found) = (&name[..], Vec::new());
    while !rest.is_empty() {
        let fits = pins.iter().filter(|pin| rest.starts_with(&pin.name.to_string()));
        let longest = fits.max_by_key(|pin| pin.name.to_string().len())?;
        rest = &rest[longest.name.to_string().len()..];
        found.push(longest.name.clone());
    }
    (found.len() > 1).then_some(found)
}

pub(in crate::model::drawn) fn listed_names(names: &[Ident]) -> String {
    names.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// The links through a pin, as messages quote them.
pub(in crate::model::drawn) fn links_through(bodies: &[LinkOutline<'_>], pin: usize) -> String {
    let through = bodies.iter().filter(|link| link.pins.contains(&pin));
    let names: Vec<_> = through.map(|link| format!("`{}`", link.name)).collect();
    listed(&names, "and")
}

fn is_pinned_to_the_ground(bodies: &Bodies<'_>, body: usize) -> bool {
    let machine = &bodies.machine;
    body != GROUND
        && machine.bodies[body].pins.iter().any(|pin| machine.bodies[GROUND].pins.contains(pin))
}

/// The drive of a body that an input is declared for which nothing uses: an angle of a link that is pinned to the
/// ground, or a length of one that slides there.
fn drive(bodies: &Bodies<'_>, body: usize) -> Option<String> {
    let is_used = |input: &Ident| {
        let statements = &bodies.tree.statements;
        statements.iter().any(|statement| names_used(statement).contains(input))
    };
    let link = bodies.link(body).name;
    let slides = |slide: &Slide| slide.body == body && slide.carrier == GROUND;
    let wanted = match bodies.machine.slides.iter().any(slides) {
        true => "length",
        false if is_pinned_to_the_ground(bodies, body) => "angle",
        false => return None,
    };
    let input = bodies.tree.statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::Input(InputStatement { names, kind: Some(kind), .. }) if kind == wanted => {
            names.iter().find(|name| !is_used(name))
        }
        _ => None,
    })?;
    let member = if wanted == "length" { "slide" } else { "angle" };
    Some(format!("drive {link}.{member} = {input};"))
}
