//! A program as routines: each a list of statements, in stages, with what it asks on the way and
//! what has to be asked before its result may be used.
//!
//! Everything about the generated code that has to be decided is decided here; `codegen` prints it.
//!
//! | module | what it decides |
//! |---|---|
//! | `plan` | which entry points compute for themselves |
//! | `ranges` | how large values can become, at all angles and on each arc |
//! | `overflow`, `input_limits` | what is asked so that none overflows, and in which comparisons |
//! | `witnesses` | which results stand for all |
//! | `checks` | what a condition becomes |
//! | `searches`, `interval` | what a search is given |
//! | `unique_root` | whether an equation has more than one root |
//! | `schedule` | the order of the statements |
//! | `locals`, `constants`, `nesting` | the names of values, of constants, and which values have none |
//! | `places` | where arguments are read |
//! | `always_finite`, `room` | what is asked in front of each operation where a language knows no infinity |
//! | `used` | what one path of a routine reads, and what a language without shadowing binds |

pub(crate) mod always_finite;
pub(crate) mod apart;
mod build;
mod checks;
mod constants;
pub mod input_limits;
pub mod interval;
pub mod locals;
pub mod nesting;
pub mod overflow;
pub(crate) mod places;
mod plan;
pub mod ranges;
pub(crate) mod room;
pub mod routine;
pub mod schedule;
mod searches;
pub mod unique_root;
pub(crate) mod used;
pub mod witnesses;

pub use build::{APPLIED, PLACED, lower, lower_marks, lower_pinned, lower_placing};
pub(crate) use plan::stands_on;
pub(crate) use routine::label;
pub(crate) use searches::TRIAL;
pub(crate) use used::bound_once;
