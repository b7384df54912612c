//! Names where they are used: each exists, is of a kind that belongs there, and was made earlier.

use proc_macro2::Ident;

use crate::diagnostics::{Extent, nearest};
use crate::syntax::words::{LIKELY_NAMES, UNITS};

use crate::model::mechanism::{GuideId, LinkId, PointId};
use crate::model::names::{Entity, Kind, NUMBERS, Symbol, TooEarly, listed};
use crate::model::scope::Scope;

/// A name is declared once.
pub(super) fn name_is_new(scope: &mut Scope<'_>, name: &Ident) -> Option<()> {
    let text = name.to_string();
    let index = *scope.names.by_name.get(&text)?;
    let is_a_pin = scope.names.is_of_pins(name);
    let symbol = &mut scope.names.symbols[index];
    if symbol.declared {
        symbol.ambiguous = true;
        if is_a_pin && symbol.made_by == format!("ground {text}") {
            let message = format!("leave out `{text}` here");
            let reason = "a point of the ground is a pin of the links through it already";
            scope.diagnostics.error_because(name.span(), message, reason);
            return None;
        }
        let reason = format!("the first `{text}` is made by `{}`", symbol.made_by);
        let message = format!("the name `{text}` is taken; choose another");
        scope.diagnostics.error_because(name.span(), message, reason);
        return None;
    }
    symbol.declared = true;
    Some(())
}

pub(super) fn point(scope: &mut Scope<'_>, name: &Ident) -> Option<PointId> {
    match usable(scope, name, &[Kind::Point])? {
        Entity::Point(id) => Some(id),
        _ => None,
    }
}

pub(super) fn link(scope: &mut Scope<'_>, name: &Ident) -> Option<LinkId> {
    match usable(scope, name, &[Kind::Link])? {
        Entity::Link(id) => Some(id),
        _ => None,
    }
}

pub(super) fn guide(scope: &mut Scope<'_>, name: &Ident) -> Option<GuideId> {
    match usable(scope, name, &[Kind::Guide])? {
        Entity::Guide(id) => Some(id),
        _ => None,
    }
}

/// A name that is used exists, is of a kind that belongs there, and was made earlier. A name
/// whose own declaration was in error, or that has two, gives nothing, and no message.
pub(super) fn usable(scope: &mut Scope<'_>, name: &Ident, kinds: &[Kind]) -> Option<Entity> {
    let Some(symbol) = scope.names.symbol(name) else {
        match scope.unread.may_hold(&name.to_string()) {
            true => name_is_unknown(scope, kinds),
            false => name_exists(scope, name, kinds),
        }
        return None;
    };
    if symbol.ambiguous {
        return None;
    }
    if !kinds.contains(&symbol.kind) {
        let message = format!("`{name}` is {}, not {}", symbol.kind.one(), one_of(kinds));
        let reason = reason_for_kind(name, symbol, kinds, scope.drawn.is_some());
        report(scope, name.span(), message, reason);
        return None;
    }
    if symbol.statement >= scope.names.current {
        if symbol.statement == scope.names.current {
            if scope.drawn.is_some() && [Kind::Point, Kind::Link].contains(&symbol.kind) {
                moves_with_its_reader(scope, name);
                return None;
            }
            let message = format!("`{name}` is used inside the statement that makes it");
            let reason = "a statement can use what earlier ones have made";
            scope.diagnostics.error_because(name.span(), message, reason);
        } else {
            let (user, maker) = (scope.names.current, symbol.statement);
            scope.names.too_early.push(TooEarly { name: name.clone(), user, maker });
        }
        return None;
    }
    symbol.entity
}

/// Reports a point or a link of a drawing that moves with what is made of it.
pub(super) fn moves_with_its_reader(scope: &mut Scope<'_>, name: &Ident) {
    let message = format!("`{name}` moves with what reads it here");
    let reason = "a drive, a length or a place reads what does not move with it";
    scope.diagnostics.error_because(name.span(), message, reason);
}

/// Remembers that an unknown name for a number may be an input, or hold one.
fn name_is_unknown(scope: &mut Scope<'_>, kinds: &[Kind]) {
    if kinds == NUMBERS {
        scope.names.use_is_hidden = true;
        scope.names.number_is_unknown = true;
    }
}

/// Reports a name that nothing declares, with the nearest one of the kinds that belong there.
fn name_exists(scope: &mut Scope<'_>, name: &Ident, kinds: &[Kind]) {
    name_is_unknown(scope, kinds);
    let text = name.to_string();
    scope.names.reported_unknown.insert(text.clone());
    if kinds == NUMBERS && scope.names.solved.contains(&text) {
        // Where it is solved, that is said.
        return;
    }
    let mut message = format!("no {} named `{text}`", words(kinds));
    let mut reason = None;
    match nearest(&text, scope.names.of_kinds(kinds)) {
        Some(near) => {
            let kind = scope.names.symbols[scope.names.by_name[near]].kind;
            message += &format!("; {} with a similar name exists: `{near}`", kind.one());
            let guides: Vec<_> = scope.names.of_kinds(&[Kind::Guide]).collect();
            if kind != Kind::Guide && kinds.contains(&Kind::Guide) && !guides.is_empty() {
                reason = Some(format!("guides are `{}`", guides.join("`, `")));
            }
        }
        None if kinds == NUMBERS && is_meant_as_unit(&text) => {
            reason = Some("a product of units stands in parentheses: `0.1(kg*m^2)`".into());
        }
        None => {
            let earlier = |symbol: &&Symbol| {
                let is_earlier = symbol.statement < scope.names.current;
                kinds.contains(&symbol.kind) && is_earlier && !symbol.is_hidden
            };
            let known: Vec<_> = scope.names.symbols.iter().filter(earlier).collect();
            if (1..=8).contains(&known.len()) {
                let known: Vec<_> = known.iter().map(|s| format!("`{}`", s.name)).collect();
                reason = Some(format!("declared so far: {}", known.join(", ")));
            } else if known.is_empty() && kinds == NUMBERS {
                reason = Some(format!("declare it: `input {text}: angle;`"));
            } else if known.is_empty() && kinds == [Kind::Guide] {
                reason = Some(format!(
                    "declare it in front of this: `guide {text} through A along 0deg;`"
                ));
            } else if kinds == [Kind::Unknown] {
                reason = Some(format!(
                    "declare it in front of what it drives: `unknown {text}: angle between (…, …);`"
                ));
            }
        }
    }
    report(scope, name.span(), message, reason);
}

/// Reports a mistake, with its second line where there is one.
pub(super) fn report(
    scope: &mut Scope<'_>,
    span: impl Into<Extent>,
    message: impl std::fmt::Display,
    reason: Option<impl std::fmt::Display>,
) {
    match reason {
        Some(reason) => scope.diagnostics.error_because(span, message, reason),
        None => scope.diagnostics.error(span, message),
    }
}

/// True for a unit, or a power of one as on a drawing, that is hardly a name: `2kg*m2`.
fn is_meant_as_unit(name: &str) -> bool {
    let unit = name.trim_end_matches(['2', '3']);
    UNITS.contains(&unit) && !LIKELY_NAMES.contains(&unit)
}

/// "input, parameter or `let`"
fn words(kinds: &[Kind]) -> String {
    // An unknown is seldom meant: it is listed only where nothing else fits.
    let usual = kinds.iter().filter(|&&kind| kind != Kind::Unknown || kinds.len() == 1);
    let words: Vec<_> = usual.map(|kind| kind.word()).collect();
    listed(&words, "or")
}

/// "a point or a link"; a name in an expression is a number, whatever statement declares it.
fn one_of(kinds: &[Kind]) -> String {
    if kinds == NUMBERS {
        return "a number".to_string();
    }
    let words: Vec<_> = kinds.iter().map(|kind| kind.one()).collect();
    listed(&words, "or")
}

/// The correction where a name of one kind stands in the place of another.
fn reason_for_kind(
    name: &Ident,
    found: &Symbol,
    wanted: &[Kind],
    is_drawn: bool,
) -> Option<String> {
    match (found.kind, wanted) {
        (Kind::Link, [Kind::Point]) => {
            Some(format!("name a joint of `{name}`, or a `point` on it"))
        }
        (Kind::Link, [Kind::Guide]) => Some(format!("declare a line on it: `guide g on {name} …`")),
        (Kind::Link, _) if wanted == NUMBERS => {
            Some(format!("its angle is `{name}.angle`, and `{name}.slide` its slide if it slides"))
        }
        (Kind::Point, _) if wanted == NUMBERS => {
            Some(format!("its coordinates are `{name}.x` and `{name}.y`"))
        }
        (Kind::Point, [Kind::Link]) if found.is_a_pin && is_drawn => {
            let links = found.made_by.split_once(' ').map_or("", |(_, links)| links);
            Some(format!("name a link through it: `{}`", links.replace(", ", "` or `")))
        }
        (Kind::Point, [Kind::Link]) if found.is_a_pin => {
            Some(format!("it is the pin of `{}`: name the link", found.made_by))
        }
        (Kind::Point, [Kind::Link]) => {
            Some("a link is what a `crank`, `slider` or dyad makes".into())
        }
        _ => None,
    }
}
