//! Atoms: the numbers that arithmetic does not open.
//!
//! Equal atoms are the same place in memory, for as long as the compiler runs. So a number that
//! is built of others shares them, however often it names them: a chain of groups of constants
//! stays as small as the graph it came from, equality costs nothing, and each atom is evaluated
//! once.

use core::cmp::Ordering;
use core::fmt::{self, Debug, Formatter};
use core::hash::{Hash, Hasher};
use core::ptr;
use std::collections::HashMap;
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};

use super::enclosure::Enclosure;
use super::sum::Term;
use super::{Exact, Form};

/// What an atom is.
///
/// The order of the variants is the order of factors in a product and of terms in a sum.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) enum Kind {
    Pi,
    /// The root of a positive number: an integer without small square factors, or one that is not
    /// rational and has the first coefficient ±1. Its power in a product is always one.
    Root(Exact),
    /// The sine of an angle in the normal form of [`super::angle`]; its power is never above one.
    Sin(Exact),
    Cos(Exact),
    /// The arc sine of a number whose first coefficient is positive.
    Asin(Exact),
    Atan(Exact),
    /// A sum of several terms whose first coefficient is one, as a factor: a divisor mostly.
    Sum(Exact),
}

/// An interned atom.
#[derive(Clone, Copy)]
pub(super) struct Atom(&'static Interned);

struct Interned {
    kind: Kind,
    /// The finest enclosure asked for so far.
    finest: Mutex<Option<Enclosure>>,
}

static ATOMS: LazyLock<Mutex<HashMap<Kind, Atom>>> = LazyLock::new(Mutex::default);

impl Atom {
    /// The atom of this kind, which is made unless it exists.
    pub(super) fn new(kind: Kind) -> Self {
        let mut atoms = locked(&ATOMS);
        if let Some(&atom) = atoms.get(&kind) {
            return atom;
        }
        let interned = Interned { kind: kind.clone(), finest: Mutex::default() };
        let atom = Self(Box::leak(Box::new(interned)));
        atoms.insert(kind, atom);
        atom
    }

    pub(super) fn kind(self) -> &'static Kind {
        &self.0.kind
    }

    /// See [`Exact::enclose`].
    pub(super) fn enclosed(self, bits: u32) -> Option<Enclosure> {
        if let Some(known) = locked(&self.0.finest).as_ref().filter(|known| known.bits() >= bits) {
            return Some(known.with_bits(bits));
        }
        let enclosure = match self.kind() {
            Kind::Pi => Enclosure::pi(bits),
            Kind::Root(radicand) => radicand.enclosed(bits)?.sqrt()?,
            Kind::Sin(angle) => angle.enclosed(bits)?.sin(),
            Kind::Cos(angle) => angle.enclosed(bits)?.cos(),
            Kind::Asin(sine) => sine.enclosed(bits)?.asin()?,
            Kind::Atan(tangent) => tangent.enclosed(bits)?.atan(),
            Kind::Sum(sum) => sum.enclosed(bits)?,
        };
        *locked(&self.0.finest) = Some(enclosure.clone());
        Some(enclosure)
    }

    /// Whether the form alone says that the atom is positive.
    pub(super) fn is_surely_positive(self) -> bool {
        match self.kind() {
            Kind::Pi | Kind::Root(_) => true,
            // Multiples of π are between 0 and 45°.
            Kind::Sin(angle) | Kind::Cos(angle) => {
                angle.as_term().is_some_and(Term::is_multiple_of_pi)
            }
            Kind::Asin(value) | Kind::Atan(value) => matches!(value.form, Form::Rational(_)),
            Kind::Sum(_) => false,
        }
    }
}

impl PartialEq for Atom {
    fn eq(&self, other: &Self) -> bool {
        ptr::eq(self.0, other.0)
    }
}

impl Eq for Atom {}

impl Hash for Atom {
    fn hash<H: Hasher>(&self, state: &mut H) {
        ptr::hash(self.0, state);
    }
}

/// By what the atoms are, not by where: the same source is compiled to the same text.
impl Ord for Atom {
    fn cmp(&self, other: &Self) -> Ordering {
        if self == other { Ordering::Equal } else { self.kind().cmp(other.kind()) }
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

/// What is guarded is never left half written: a panic elsewhere does not spoil it.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
