//! The one name space of a declaration: what is named where, and what the name stands for.
//!
//! All names are collected before the first statement is resolved, so that a use can tell a name
//! that does not exist from one that is made further down. A statement's names can be used from
//! the next statement on.

use std::collections::HashMap;

use proc_macro2::Ident;

use crate::diagnostics::{Extent, nearest};
use crate::syntax::action::Action;
use crate::syntax::tree::{Declaration, Statement, StatementKind};

use super::Resolver;
use super::mechanism::{
    GuideId, InputId, LetId, LinkId, LoadId, ParamId, PointId, SpringId, UnknownId,
};
use super::order::TooEarly;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Input,
    Param,
    Let,
    Point,
    Link,
    Guide,
    Load,
    Unknown,
    Spring,
}

/// What may stand in an expression.
pub(super) const NUMBERS: [Kind; 4] = [Kind::Input, Kind::Param, Kind::Let, Kind::Unknown];

impl Kind {
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Input => "input",
            Self::Param => "parameter",
            Self::Let => "`let`",
            Self::Point => "point",
            Self::Link => "link",
            Self::Guide => "guide",
            Self::Load => "load",
            Self::Unknown => "unknown",
            Self::Spring => "spring",
        }
    }

    /// The word with its article.
    pub(super) fn one(self) -> String {
        let article = if matches!(self, Self::Input | Self::Unknown) { "an" } else { "a" };
        format!("{article} {}", self.word())
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Entity {
    Input(InputId),
    Param(ParamId),
    Let(LetId),
    Point(PointId),
    Link(LinkId),
    Guide(GuideId),
    Load(LoadId),
    Unknown(UnknownId),
    Spring(SpringId),
}

/// A name that was declared, correctly or not.
struct Symbol {
    name: String,
    kind: Kind,
    /// The index of the statement.
    statement: usize,
    /// The statement as messages call it: `crank AB`, `param l`.
    made_by: String,
    /// Whether it is the pin of a group.
    is_a_pin: bool,
    /// `None` until its statement is reached, and for good where that was in error.
    entity: Option<Entity>,
    /// Whether its statement was reached, so that another declaration is the second.
    declared: bool,
    /// Whether another declaration was reached: what is meant by the name is unknown from there.
    ambiguous: bool,
}

pub(super) struct Names {
    symbols: Vec<Symbol>,
    by_name: HashMap<String, usize>,
    /// The statement being resolved.
    current: usize,
}

impl Names {
    pub(super) fn collect(tree: &Declaration) -> Self {
        let mut names = Self { symbols: Vec::new(), by_name: HashMap::new(), current: 0 };
        for (index, statement) in tree.statements.iter().enumerate() {
            for (name, kind) in declared_by(statement) {
                let name = name.to_string();
                if names.by_name.contains_key(&name) {
                    continue;
                }
                names.by_name.insert(name.clone(), names.symbols.len());
                let made_by = title(statement, &name);
                let is_a_pin =
                    kind == Kind::Point && matches!(statement.kind, StatementKind::Group(_));
                names.symbols.push(Symbol {
                    name,
                    kind,
                    statement: index,
                    made_by,
                    is_a_pin,
                    entity: None,
                    declared: false,
                    ambiguous: false,
                });
            }
        }
        names
    }

    /// Goes on to the statement with this index: what earlier ones made can be used.
    pub(super) fn go_to(&mut self, statement: usize) {
        self.current = statement;
    }

    /// From now on the name stands for this.
    pub(super) fn bind(&mut self, name: &Ident, entity: Entity) {
        let index = self.by_name[&name.to_string()];
        self.symbols[index].entity = Some(entity);
    }

    /// What the name was declared as, wherever that stands.
    pub(super) fn kind(&self, name: &Ident) -> Option<Kind> {
        self.symbol(name).filter(|symbol| !symbol.ambiguous).map(|symbol| symbol.kind)
    }

    /// What the name stands for, if it can be used.
    pub(super) fn entity(&self, name: &Ident) -> Option<Entity> {
        self.symbol(name)
            .filter(|symbol| symbol.statement < self.current)
            .and_then(|symbol| symbol.entity)
    }

    /// What the statement in hand has made of the name.
    pub(super) fn made(&self, name: &Ident) -> Option<Entity> {
        self.symbol(name).and_then(|symbol| symbol.entity)
    }

    /// All names of these kinds, in order of declaration.
    pub(super) fn of_kinds(&self, kinds: &[Kind]) -> impl Iterator<Item = &str> {
        self.symbols.iter().filter(|s| kinds.contains(&s.kind)).map(|s| s.name.as_str())
    }

    fn symbol(&self, name: &Ident) -> Option<&Symbol> {
        self.by_name.get(&name.to_string()).map(|&index| &self.symbols[index])
    }
}

/// The names a statement declares. The name of an output is not among them: it is a field of the
/// result alone.
pub(super) fn declared_by(statement: &Statement) -> Vec<(&Ident, Kind)> {
    match &statement.kind {
        StatementKind::Input { names, .. } => names.iter().map(|n| (n, Kind::Input)).collect(),
        StatementKind::Param { name, .. } => vec![(name, Kind::Param)],
        StatementKind::Let { name, .. } => vec![(name, Kind::Let)],
        StatementKind::Unknown { name, .. } => vec![(name, Kind::Unknown)],
        StatementKind::Ground { points } => points.iter().map(|p| (&p.0, Kind::Point)).collect(),
        StatementKind::Guide { name, .. } => vec![(name, Kind::Guide)],
        StatementKind::Point { name, .. } => vec![(name, Kind::Point)],
        StatementKind::Group(group) => {
            let links = group.legs.iter().map(|leg| (&leg.link, Kind::Link));
            links.chain(group.pin.iter().map(|pin| (pin, Kind::Point))).collect()
        }
        StatementKind::Load { names, .. } => names.iter().map(|n| (n, Kind::Load)).collect(),
        StatementKind::Action(Action::Spring { name, .. }) => {
            name.iter().map(|name| (name, Kind::Spring)).collect()
        }
        StatementKind::Solve(_)
        | StatementKind::Action(_)
        | StatementKind::Output { .. }
        | StatementKind::Numerics { .. }
        | StatementKind::Crate { .. }
        | StatementKind::Export { .. } => Vec::new(),
    }
}

/// The statement that declares `name`, as messages call it.
pub(super) fn title(statement: &Statement, name: &str) -> String {
    match &statement.kind {
        StatementKind::Input { .. } => format!("input {name}"),
        StatementKind::Param { .. } => format!("param {name}"),
        StatementKind::Let { .. } => format!("let {name}"),
        StatementKind::Unknown { .. } => format!("unknown {name}"),
        StatementKind::Solve(solve) => format!("solve {}", solve.unknown),
        StatementKind::Ground { .. } => format!("ground {name}"),
        StatementKind::Guide { .. } => format!("guide {name}"),
        StatementKind::Point { .. } => format!("point {name}"),
        StatementKind::Group(group) => {
            format!("{} {}", group.keyword, group.title())
        }
        StatementKind::Load { .. } => format!("load {name}"),
        StatementKind::Action(Action::Spring { .. }) => format!("spring {name}"),
        StatementKind::Action(_)
        | StatementKind::Output { .. }
        | StatementKind::Numerics { .. }
        | StatementKind::Crate { .. }
        | StatementKind::Export { .. } => String::new(),
    }
}

impl Resolver<'_> {
    /// A name is declared once.
    pub(super) fn name_is_new(&mut self, name: &Ident) -> Option<()> {
        let text = name.to_string();
        let index = *self.names.by_name.get(&text)?;
        let symbol = &mut self.names.symbols[index];
        if symbol.declared {
            symbol.ambiguous = true;
            let reason = format!("the first `{text}` is made by `{}`", symbol.made_by);
            let message = format!("the name `{text}` is taken; choose another");
            self.diagnostics.error_because(name.span(), message, reason);
            return None;
        }
        symbol.declared = true;
        Some(())
    }

    pub(super) fn point(&mut self, name: &Ident) -> Option<PointId> {
        match self.usable(name, &[Kind::Point])? {
            Entity::Point(id) => Some(id),
            _ => None,
        }
    }

    pub(super) fn link(&mut self, name: &Ident) -> Option<LinkId> {
        match self.usable(name, &[Kind::Link])? {
            Entity::Link(id) => Some(id),
            _ => None,
        }
    }

    pub(super) fn guide(&mut self, name: &Ident) -> Option<GuideId> {
        match self.usable(name, &[Kind::Guide])? {
            Entity::Guide(id) => Some(id),
            _ => None,
        }
    }

    /// A name that is used exists, is of a kind that belongs there, and was made earlier. A name
    /// whose own declaration was in error, or that has two, gives nothing, and no message.
    pub(super) fn usable(&mut self, name: &Ident, kinds: &[Kind]) -> Option<Entity> {
        let Some(symbol) = self.names.symbol(name) else {
            match self.unread.may_hold(&name.to_string()) {
                true => self.name_is_unknown(kinds),
                false => self.name_exists(name, kinds),
            }
            return None;
        };
        if symbol.ambiguous {
            return None;
        }
        if !kinds.contains(&symbol.kind) {
            let message = format!("`{name}` is {}, not {}", symbol.kind.one(), one_of(kinds));
            let reason = reason_for_kind(name, symbol, kinds);
            self.report(name.span(), message, reason);
            return None;
        }
        if symbol.statement >= self.names.current {
            if symbol.statement == self.names.current {
                let message = format!("`{name}` is used inside the statement that makes it");
                let reason = "a statement can use what earlier ones have made";
                self.diagnostics.error_because(name.span(), message, reason);
            } else {
                let (user, maker) = (self.names.current, symbol.statement);
                self.too_early.push(TooEarly { name: name.clone(), user, maker });
            }
            return None;
        }
        let entity = symbol.entity?;
        self.moves |= self.facts.moves(entity);
        self.follows |= self.searched.as_ref().is_some_and(|searched| searched.reaches(entity));
        Some(entity)
    }

    /// What stands for a number and is not known may be an input, or hold one.
    fn name_is_unknown(&mut self, kinds: &[Kind]) {
        if kinds == NUMBERS {
            self.use_is_hidden = true;
            self.number_is_unknown = true;
        }
    }

    /// Reports a name that nothing declares, with the nearest one of the kinds that belong there.
    fn name_exists(&mut self, name: &Ident, kinds: &[Kind]) {
        self.name_is_unknown(kinds);
        let text = name.to_string();
        let mut message = format!("no {} named `{text}`", words(kinds));
        let mut reason = None;
        match nearest(&text, self.names.of_kinds(kinds)) {
            Some(near) => {
                let kind = self.names.symbols[self.names.by_name[near]].kind;
                message += &format!("; {} with a similar name exists: `{near}`", kind.one());
            }
            None => {
                let earlier = |symbol: &&Symbol| {
                    kinds.contains(&symbol.kind) && symbol.statement < self.names.current
                };
                let known: Vec<_> = self.names.symbols.iter().filter(earlier).collect();
                if (1..=8).contains(&known.len()) {
                    let known: Vec<_> = known.iter().map(|s| format!("`{}`", s.name)).collect();
                    reason = Some(format!("declared so far: {}", known.join(", ")));
                } else if known.is_empty() && kinds == NUMBERS {
                    reason = Some(format!("declare it: `input {text}: angle;`"));
                }
            }
        }
        self.report(name.span(), message, reason);
    }

    /// Reports a mistake, with its second line where there is one.
    pub(super) fn report(
        &mut self,
        span: impl Into<Extent>,
        message: impl std::fmt::Display,
        reason: Option<impl std::fmt::Display>,
    ) {
        match reason {
            Some(reason) => self.diagnostics.error_because(span, message, reason),
            None => self.diagnostics.error(span, message),
        }
    }
}

/// "input, parameter or `let`"
fn words(kinds: &[Kind]) -> String {
    // What is searched is not among what is usually meant.
    let usual = kinds.iter().filter(|&&kind| kind != Kind::Unknown || kinds.len() == 1);
    let words: Vec<_> = usual.map(|kind| kind.word()).collect();
    listed(&words, "or")
}

/// "a point or a link"; what stands in an expression is a number, whoever declares it.
fn one_of(kinds: &[Kind]) -> String {
    if kinds == NUMBERS {
        return "a number".to_string();
    }
    let words: Vec<_> = kinds.iter().map(|kind| kind.one()).collect();
    listed(&words, "or")
}

/// "a, b or c"
pub(super) fn listed<S: AsRef<str>>(words: &[S], joint: &str) -> String {
    let mut text = String::new();
    for (i, word) in words.iter().enumerate() {
        match i {
            0 => {}
            _ if i + 1 == words.len() => text += &format!(" {joint} "),
            _ => text += ", ",
        }
        text += word.as_ref();
    }
    text
}

/// What to write instead, where a name of one kind stands where another belongs.
fn reason_for_kind(name: &Ident, found: &Symbol, wanted: &[Kind]) -> Option<String> {
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
        (Kind::Point, [Kind::Link]) if found.is_a_pin => {
            Some(format!("it is the pin of `{}`: name the link", found.made_by))
        }
        (Kind::Point, [Kind::Link]) => {
            Some("a link is what a `crank`, `slider` or dyad makes".into())
        }
        _ => None,
    }
}
