//! The one name space of a declaration: what is named where, and what the name stands for.
//!
//! All names are collected before the first statement is resolved, so that a use can tell a name
//! that does not exist from one that is made further down. A statement's names can be used from
//! the next statement on.

use std::collections::{HashMap, HashSet};

use proc_macro2::{Ident, Span};

use crate::model::mechanism::{
    GuideId, InputId, LawId, LetId, LinkId, LoadId, ParamId, PointId, References, SpringId, StopId,
    UnknownId,
};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Input,
    Param,
    Let,
    Point,
    Link,
    Guide,
    Load,
    Unknown,
    Spring,
    Stop,
}

/// The kinds of names that may stand in an expression.
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
            Self::Stop => "stop",
        }
    }

    /// The word with its article.
    pub(super) fn one(self) -> String {
        let article = if matches!(self, Self::Input | Self::Unknown) { "an" } else { "a" };
        format!("{article} {}", self.word())
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Entity {
    Input(InputId),
    Param(ParamId),
    Let(LetId),
    Law(LawId),
    Point(PointId),
    Link(LinkId),
    Guide(GuideId),
    Load(LoadId),
    /// The load that drives an input.
    Pull,
    Unknown(UnknownId),
    Spring(SpringId),
    Stop(StopId),
}

/// A name that was declared, correctly or not.
pub struct Symbol {
    pub name: String,
    pub kind: Kind,
    /// The index of the statement.
    pub statement: usize,
    /// The statement as messages call it: `crank AB`, `param l`.
    pub made_by: String,
    /// True if a drawing became what makes it.
    pub is_drawn: bool,
    /// True for the pin of a group.
    pub is_a_pin: bool,
    /// `None` until its statement is reached, and for good where that was in error.
    pub entity: Option<Entity>,
    /// True if its statement was reached, so that another declaration is the second.
    pub declared: bool,
    /// True if nobody has written it, so that no message proposes it.
    pub is_hidden: bool,
    /// True if another declaration was reached: the meaning of the name is unknown from there.
    pub ambiguous: bool,
}

pub struct Names {
    pub symbols: Vec<Symbol>,
    pub by_name: HashMap<String, usize>,
    /// The statement being resolved.
    pub current: usize,
    /// Names used before they are made.
    pub too_early: Vec<TooEarly>,
    /// Names that nothing declares, and that were reported.
    pub reported_unknown: HashSet<String>,
    /// True if one of them stands where a number does.
    pub number_is_unknown: bool,
    /// True if a mistake may have hidden the use of an input or a load.
    pub use_is_hidden: bool,
    /// The names behind `solve`.
    pub solved: HashSet<String>,
    /// The pins of a drawing while they are resolved as points that stand still, and the named expressions that move.
    pub pins: HashSet<String>,
}

impl Names {
    /// Names of which none is declared yet; `solved` are those behind `solve`.
    pub(super) fn new(solved: HashSet<String>) -> Self {
        Self {
            symbols: Vec::new(),
            by_name: HashMap::new(),
            current: 0,
            too_early: Vec::new(),
            reported_unknown: HashSet::new(),
            number_is_unknown: false,
            use_is_hidden: false,
            solved,
            pins: HashSet::new(),
        }
    }

    /// Adds a name that is not among them yet.
    pub(super) fn add(&mut self, symbol: Symbol) {
        if !self.by_name.contains_key(&symbol.name) {
            self.by_name.insert(symbol.name.clone(), self.symbols.len());
            self.symbols.push(symbol);
        }
    }

    /// No message proposes names other than these.
    pub(super) fn hide_unwritten(&mut self, written: &References) {
        for symbol in &mut self.symbols {
            symbol.is_hidden = !written.made.iter().any(|(name, _)| *name == symbol.name);
        }
    }

    /// Every name means its first declaration, although there are others.
    pub(super) fn are_unique(&mut self) {
        self.symbols.iter_mut().for_each(|symbol| symbol.ambiguous = false);
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

    /// The kind that the name is declared as, wherever its statement stands.
    pub(super) fn kind(&self, name: &Ident) -> Option<Kind> {
        self.symbol(name).filter(|symbol| !symbol.ambiguous).map(|symbol| symbol.kind)
    }

    /// The entity that the name stands for, if it can be used.
    pub(super) fn entity(&self, name: &Ident) -> Option<Entity> {
        self.symbol(name)
            .filter(|symbol| symbol.statement < self.current)
            .and_then(|symbol| symbol.entity)
    }

    /// The entity that the statement in hand has made of the name.
    pub(super) fn made(&self, name: &Ident) -> Option<Entity> {
        self.symbol(name).and_then(|symbol| symbol.entity)
    }

    /// All names of these kinds that somebody has written, in order of declaration.
    pub(super) fn of_kinds(&self, kinds: &[Kind]) -> impl Iterator<Item = &str> {
        let known = self.symbols.iter().filter(|symbol| !symbol.is_hidden);
        known.filter(|symbol| kinds.contains(&symbol.kind)).map(|symbol| symbol.name.as_str())
    }

    /// True of a pin of a drawing that stands still while numbers are resolved, and of a named expression that moves.
    pub(super) fn is_of_pins(&self, name: &Ident) -> bool {
        self.pins.contains(&name.to_string())
    }

    /// True if nobody has written the name.
    pub(super) fn is_hidden(&self, name: &Ident) -> bool {
        self.symbol(name).is_some_and(|symbol| symbol.is_hidden)
    }

    /// The name that stands for this.
    pub(super) fn name_of(&self, entity: Entity) -> Option<Ident> {
        let symbol = self.symbols.iter().find(|symbol| symbol.entity == Some(entity))?;
        Some(Ident::new(&symbol.name, Span::call_site()))
    }

    pub(super) fn symbol(&self, name: &Ident) -> Option<&Symbol> {
        self.by_name.get(&name.to_string()).map(|&index| &self.symbols[index])
    }
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

/// A name that a statement uses and a later one makes.
pub struct TooEarly {
    pub name: Ident,
    pub user: usize,
    pub maker: usize,
}
