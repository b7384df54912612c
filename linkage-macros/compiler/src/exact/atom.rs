//! Atoms: the numbers that arithmetic does not open.
//!
//! Each distinct atom exists once. Numbers built from it share it, however often they name it: a
//! chain of groups of constants stays as small as the graph it came from, equality costs nothing, and
//! each atom is evaluated once.
//!
//! They are known to their thread, from when they are made until the [`AtomScope`] they were made in
//! ends, which is that of a compilation: a server that compiles one declaration after the other
//! keeps nothing of them.

use core::borrow::Borrow;
use core::cell::RefCell;
use core::cmp::Ordering;
use core::fmt::{self, Debug, Formatter};
use core::hash::{Hash, Hasher};
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use super::enclosure::Enclosure;
use super::{Exact, ExactForm};
use crate::function::Function;

/// The kind of an atom, with its arguments.
///
/// The order of the variants is the order of factors in a product and of terms in a sum.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) enum AtomKind {
    Pi,
    /// The root of a positive number: an integer without small square factors, or one that is not
    /// rational and has the first coefficient ±1. Its power in a product is always one.
    Root(Exact),
    /// A function of one number. The angle of a sine is in the normal form of [`super::angle`], and a
    /// sine's power is never above one; the argument of an arc has a positive first coefficient.
    Of(Function, Exact),
    /// A sum of several terms whose first coefficient is one, as a factor: a divisor mostly.
    Sum(Exact),
}

/// An atom, the only one of its kind.
#[derive(Clone)]
pub(super) struct Atom(Rc<KnownAtom>);

struct KnownAtom {
    /// No two atoms of a thread ever have the same.
    number: u64,
    kind: AtomKind,
    /// The nesting depth: the number of atoms inside each other.
    depth: u32,
}

/// An atom that is found by what it is.
struct ByKind(Atom);

impl Borrow<AtomKind> for ByKind {
    fn borrow(&self) -> &AtomKind {
        self.0.kind()
    }
}

impl Hash for ByKind {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.kind().hash(state);
    }
}

impl PartialEq for ByKind {
    fn eq(&self, other: &Self) -> bool {
        self.0.kind() == other.0.kind()
    }
}

impl Eq for ByKind {}

/// The atoms of a thread.
#[derive(Default)]
struct Atoms {
    by_kind: HashSet<ByKind>,
    /// In the order they were made in: what an atom is made of stands before it.
    made: Vec<Atom>,
    /// The number of the next one.
    next: u64,
    /// The finest enclosure asked for so far, by the atom's number.
    finest: HashMap<u64, Enclosure>,
}

thread_local! {
    static ATOMS: RefCell<Atoms> = RefCell::default();
}

impl Atoms {
    fn atom(&mut self, kind: AtomKind) -> Atom {
        if let Some(ByKind(atom)) = self.by_kind.get(&kind) {
            return atom.clone();
        }
        let depth = 1 + kind.argument().map_or(0, Exact::depth);
        let atom = Atom(Rc::new(KnownAtom { number: self.next, kind, depth }));
        self.next += 1;
        self.by_kind.insert(ByKind(atom.clone()));
        self.made.push(atom.clone());
        atom
    }

    /// The atoms that are not yet known so finely among this one and what it is made of, the
    /// innermost first.
    fn coarse(&self, atom: &Atom, bits: u32) -> Vec<Atom> {
        let is_coarse =
            |atom: &Atom| self.finest.get(&atom.0.number).is_none_or(|finest| finest.bits() < bits);
        let mut found = HashMap::new();
        let mut next = vec![atom.clone()];
        while let Some(atom) = next.pop() {
            if !is_coarse(&atom) || found.contains_key(&atom.0.number) {
                continue;
            }
            if let Some(Exact { form: ExactForm::Sum(terms) }) = atom.kind().argument() {
                let factors = terms.iter().flat_map(|term| &term.factors);
                next.extend(factors.map(|factor| factor.atom.clone()));
            }
            found.insert(atom.0.number, atom);
        }
        let mut found: Vec<_> = found.into_values().collect();
        found.sort_unstable_by_key(|atom| atom.0.number);
        found
    }

    /// Forgets all but the first atoms.
    fn truncate(&mut self, count: usize) {
        // The last first: what it is made of is still held, so that no drop is inside another.
        while self.made.len() > count {
            let Some(last) = self.made.pop() else { return };
            self.by_kind.remove(last.kind());
            self.finest.remove(&last.0.number);
        }
    }
}

impl Drop for Atoms {
    fn drop(&mut self) {
        self.truncate(0);
    }
}

/// Forgets the atoms that were made since it began, when it ends. No number that holds one of
/// them may be used afterwards: an equal one would be another atom.
pub struct AtomScope {
    before: usize,
}

impl AtomScope {
    pub fn begin() -> Self {
        Self { before: known() }
    }
}

impl Drop for AtomScope {
    fn drop(&mut self) {
        ATOMS.with_borrow_mut(|atoms| atoms.truncate(self.before));
    }
}

/// The number of atoms the thread knows.
pub fn known() -> usize {
    ATOMS.with_borrow(|atoms| atoms.made.len())
}

impl AtomKind {
    /// The argument of the root, function or sum; π has none.
    fn argument(&self) -> Option<&Exact> {
        match self {
            Self::Pi => None,
            Self::Root(argument) | Self::Of(_, argument) | Self::Sum(argument) => Some(argument),
        }
    }
}

impl Atom {
    /// The atom of this kind, which is made unless it exists.
    pub(super) fn new(kind: AtomKind) -> Self {
        ATOMS.with_borrow_mut(|atoms| atoms.atom(kind))
    }

    pub(super) fn kind(&self) -> &AtomKind {
        &self.0.kind
    }

    pub(super) fn depth(&self) -> u32 {
        self.0.depth
    }

    /// See [`Exact::enclose`].
    pub(super) fn enclosed(&self, bits: u32) -> Option<Enclosure> {
        let number = self.0.number;
        let known = ATOMS.with_borrow(|atoms| {
            let finest = atoms.finest.get(&number).filter(|finest| finest.bits() >= bits);
            finest.map(|finest| finest.with_bits(bits))
        });
        known.or_else(|| {
            // The parts are enclosed first, so that no call is nested in another.
            let coarse = ATOMS.with_borrow(|atoms| atoms.coarse(self, bits));
            coarse.iter().try_fold(None, |_, atom| atom.enclosed_by_parts(bits).map(Some))?
        })
    }

    /// The same, and remembers it.
    fn enclosed_by_parts(&self, bits: u32) -> Option<Enclosure> {
        let enclosure = match self.kind() {
            AtomKind::Pi => Enclosure::pi(bits),
            AtomKind::Root(radicand) => radicand.enclosed(bits)?.sqrt()?,
            AtomKind::Of(function, argument) => argument.enclosed(bits)?.apply(*function)?,
            AtomKind::Sum(sum) => sum.enclosed(bits)?,
        };
        ATOMS.with_borrow_mut(|atoms| atoms.finest.insert(self.0.number, enclosure.clone()));
        Some(enclosure)
    }
}

impl PartialEq for Atom {
    fn eq(&self, other: &Self) -> bool {
        self.0.number == other.0.number
    }
}

impl Eq for Atom {}

impl Hash for Atom {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.number.hash(state);
    }
}

/// By what the atoms are: the same number has the same text, wherever it stands. Those that are
/// deep come last and by when they were made, because comparing them is a call in a call.
impl Ord for Atom {
    fn cmp(&self, other: &Self) -> Ordering {
        const DEEP: u32 = 32;
        match (self == other, self.depth() > DEEP, other.depth() > DEEP) {
            (true, ..) => Ordering::Equal,
            (false, false, false) => self.kind().cmp(other.kind()),
            (false, true, true) => self.0.number.cmp(&other.0.number),
            (false, deep, other_deep) => deep.cmp(&other_deep),
        }
    }
}

impl PartialOrd for Atom {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// The short text: written out, a number that shares its parts grows without bounds.
impl Debug for Atom {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "`{}`", Exact::atom(self.kind().clone()))
    }
}
