//! The only thing generated code may name.
//!
//! Everything it needs is re-exported here, the prelude's names included, so that it compiles
//! where the prelude is switched off or `core` is shadowed. Nothing here is part of the public
//! interface.

pub use core::array::from_fn;
pub use core::clone::Clone;
pub use core::cmp::PartialEq;
pub use core::convert::{From, Into};
pub use core::default::Default;
pub use core::fmt::{self, Debug, Formatter};
pub use core::marker::{Copy, PhantomData};
pub use core::ops::{Add, BitAnd, Div, Fn, FnMut, FnOnce, Mul, Neg, Sub};
pub use core::option::Option::{self, None, Some};
pub use core::prelude::v1::derive;
pub use core::primitive::{bool, f32, f64, i32, str, u32, usize};
pub use core::result::Result::{self, Err, Ok};

pub use crate::assemblies::{
    Assembly, Budget, List, PinnedKind, assembled_side, assembled_trend, listed,
};
pub use crate::c_interface::{CError, c_sense, c_side, c_trend};
pub use crate::checks::{AllMet, Behind, Checks, FirstError};
pub use crate::clearance::{Clearance, told};
pub use crate::cost::{cost, search_cost};
pub use crate::crossing::Trend;
#[cfg(feature = "ad")]
pub use crate::derivatives::{Differentiable, differentiate, jacobian};
pub use crate::diagnosis::*;
pub use crate::friction::{Amounts, System};
pub use crate::mixed::{Given, Mixed, ROUNDINGS_OF_A_PIVOT, mixed_dynamics};
pub use crate::record::{column, joined};
pub use crate::resolver::{from_angle, from_circle, on_circle};
pub use crate::roots::FindError;
pub use crate::roots::bound::bound;
pub use crate::roots::seed::{Apart, Seed, root_by_seed};
pub use crate::roots::unknown::{open, root, root_within_a_turn};
pub use crate::scalar::{Sealed, is_finite_unless};
#[cfg(feature = "sketch")]
pub use crate::sketch::{
    Applied, Drawn, Element, Film, Member, Plan, Sketch, Spring, applied, followed, place,
    place_open,
};
#[cfg(feature = "page")]
pub use crate::sketch::{Declared, Page, Paged};
pub use crate::slow_path::{apart, diagnose, diagnose_all, diagnose_in_part};
pub use crate::solver::{Solver, Titles, lifted};
pub use crate::sweep::kinds::*;
pub use crate::sweep::{
    Entry, LengthMismatch, Progress, Series, Status, put_found, put_solved, put_usable, sweep,
};
pub use crate::transfer::{AssembledSide, CarriesOver, Place, Transfer, TransferError, Way};
pub use crate::unavailable::*;
pub use crate::with_ad_ as with_ad;
pub use crate::with_page_ as with_page;
pub use crate::with_serde_ as with_serde;
pub use crate::with_sketch_ as with_sketch;
pub use crate::{
    AngularAcceleration, AngularVelocity, Cost, Direction, Float, Force, GuideForce, Mask,
    Mechanism, Parameters, Point, Real, Record, Scalar, Sense, Shaking, Side, Slide,
    SlidingAcceleration, SlidingDirection, SlidingVelocity, SolveError,
};
pub use linkage_assemblies::{BodyPin, ClosureDegree, HungBar, PinnedDyad, PinnedGroup};
#[cfg(feature = "ad")]
pub use nalgebra::SMatrix;
#[cfg(feature = "ad")]
pub use num_dual::DualSVec;
#[cfg(feature = "serde")]
pub use serde;
#[cfg(feature = "sketch")]
pub use std::vec::Vec;

/// Items that generated code calls by their name alone. No functions: an argument may have a function's name.
pub mod names {
    pub use super::{
        AllMet, AngularAcceleration, AngularVelocity, Checks, Clearance, Clone, Copy, Cost, Debug,
        Default, Direction, Float, Fn, FnMut, FnOnce, From, Inputs, Into, LengthMismatch, OfMotion,
        OfPosition, OfVelocity, Ok, Option, PartialEq, PhantomData, Point, Progress, Real, Record,
        Result, Scalar, Series, Side, Slide, SlidingAcceleration, SlidingDirection,
        SlidingVelocity, SolveError, Solver, Some, Status, Titles, derive, f64, str, usize,
    };
}

/// Imported under the names of arguments. A constant of the user's that has such a name would make
/// a pattern of the argument; a function of that name in between hides it, and leaves the argument
/// alone.
pub const fn argument() {}

/// Its argument where the feature `ad` is on: the macro that generates the code cannot see the
/// features of the crate that runs it.
#[cfg(feature = "ad")]
#[doc(hidden)]
#[macro_export]
macro_rules! with_ad_ {
    ($($code:tt)*) => { $($code)* };
}

/// Nothing, as the feature `ad` is off.
#[cfg(not(feature = "ad"))]
#[doc(hidden)]
#[macro_export]
macro_rules! with_ad_ {
    ($($code:tt)*) => {};
}

/// Its argument where the feature `sketch` is on.
#[cfg(feature = "sketch")]
#[doc(hidden)]
#[macro_export]
macro_rules! with_sketch_ {
    ($($code:tt)*) => { $($code)* };
}

/// Nothing, as the feature `sketch` is off.
#[cfg(not(feature = "sketch"))]
#[doc(hidden)]
#[macro_export]
macro_rules! with_sketch_ {
    ($($code:tt)*) => {};
}

/// Its argument where the feature `page` is on.
#[cfg(feature = "page")]
#[doc(hidden)]
#[macro_export]
macro_rules! with_page_ {
    ($($code:tt)*) => { $($code)* };
}

/// Nothing, as the feature `page` is off.
#[cfg(not(feature = "page"))]
#[doc(hidden)]
#[macro_export]
macro_rules! with_page_ {
    ($($code:tt)*) => {};
}

/// An item with the attributes in front of it where the feature `serde` is on.
#[cfg(feature = "serde")]
#[doc(hidden)]
#[macro_export]
macro_rules! with_serde_ {
    ({ $($attributes:tt)* } $($item:tt)*) => { $($attributes)* $($item)* };
}

/// The item alone, as the feature `serde` is off.
#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! with_serde_ {
    ({ $($attributes:tt)* } $($item:tt)*) => { $($item)* };
}
