//! All ways to assemble a machine at given inputs, proved.
//!
//! A group of class III can be assembled in several ways: a plate on three bars in up to six. A solver finds the one that is drawn. With
//! `export assemblies;` it also lists all of them, and [`with`](crate::reference::statements#settings) gives a solver of each.
//!
#![cfg_attr(feature = "macros", doc = "```")]
#![cfg_attr(not(feature = "macros"), doc = "```ignore")]
//! use linkage_core::assemblies::Budget;
//! use linkage_core::mechanism;
//!
//! mechanism! {
//!     /// A plate on three bars, the first of which a crank carries.
//!     pub struct Carrier {
//!         input t: angle;
//!         export assemblies;
//!         ground A(-1m, 0), D(4m, 0), G(2m, 5m);
//!         pin B(-0.5m, 0.6m), P(0.8m, 1.2m), Q(3m, 0.6m), R(1.9m, 3.1m);
//!         link AB(A, B), BP(B, P), plate(P, Q, R), DQ(D, Q), GR(G, R);
//!         drive AB.angle = t;
//!         output plate;
//!     }
//! }
//!
//! fn main() -> Result<(), linkage_core::SolveError> {
//!     let machine = Carrier::new();
//!     let [t] = Carrier::DRAWN;
//!     let list = machine.assemblies(t, Budget::default())?;
//!     assert!(list.is_proved() && list.len() == 2 && Carrier::ASSEMBLIES == 6);
//!     // A sensor on the plate says in which of both the machine is.
//!     let turned = |at: &_| Some(machine.with(at).position(t).ok()?.plate.angle());
//!     let drawn = machine.position(t)?.plate.angle();
//!     let found = list.nearest_by_angle(drawn + 0.001, turned).expect("there are two");
//!     assert!((found.off - 0.001).abs() < 1e-9 && found.runner_up > Some(0.02));
//!     Ok(())
//! }
//! ```
//!
//! # The method
//! The group's equation, multiplied over all modes of its dyads and times powers of their bases, is a trigonometric polynomial of the unknown.
//! Its degree depends on the kind of group alone, and the compiler finds it by residues of a prime. As many values as it has coefficients are
//! all of it on a part of the circle. They are enclosed with all roundings, and a part is settled where its coefficients show that it has no zero, or a
//! single one. A part that is not settled is divided. What remains is [`Outcome::Open`]: two assemblies that nearly meet, or a machine that
//! moves while its inputs stand still.
//!
//! # Numbers
//! It computes in `f64` whatever the solver's numbers are, and takes lengths and places as the solver has rounded them: what is proved is
//! proved of the machine with these numbers. Nothing allocates or panics, and [`Budget`] bounds the work.

pub use linkage_assemblies::{Assembly, Budget, List, Nearest, Outcome};

use linkage_assemblies::{ClosureDegree, MOST_PLACES, PinnedGroup, Placed};

use crate::crossing::Trend;
use crate::{Real, Side, SolveError};

/// The kind of a group, and how its assemblies are counted.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct PinnedKind {
    /// Its pins and bodies.
    pub group: PinnedGroup,
    /// The powers that make its closure a polynomial.
    pub degree: ClosureDegree,
}

/// The list of a group from its numbers: the length of the link that was left out, then x and y of place after place.
///
/// # Errors
/// Those of the numbers.
#[doc(hidden)]
pub fn listed<T: Real, const NUMBERS: usize, const N: usize>(
    kind: &PinnedKind,
    numbers: Result<[T; NUMBERS], SolveError>,
    budget: Budget,
) -> Result<List<N>, SolveError> {
    let numbers = numbers?;
    let mut places = [[0.0; 2]; MOST_PLACES];
    let mut length = 0.0;
    if let Some((first, rest)) = numbers.split_first() {
        length = first.value();
        for (place, pair) in places.iter_mut().zip(rest.chunks_exact(2)) {
            *place = [pair[0].value(), pair[1].value()];
        }
    }
    let placed = Placed::new(&kind.group, &kind.degree, (&places, [length, 0.0]));
    Ok(placed.map_or_else(List::unknown, |placed| placed.assemblies(budget)))
}

/// The side of a dyad in an assembly.
#[doc(hidden)]
#[must_use]
pub fn assembled_side(assembly: &Assembly, dyad: usize) -> Side {
    if assembly.sides >> dyad & 1 == 1 { Side::Left } else { Side::Right }
}

/// The trend of an equation in an assembly, which has the distance on its left side or on its right one.
#[doc(hidden)]
#[must_use]
pub fn assembled_trend(assembly: &Assembly, is_left: bool) -> Trend {
    if assembly.rises == is_left { Trend::Rising } else { Trend::Falling }
}
