//! Routines as text, in each language a folder: what is printed is what `lower` says, statement by
//! statement. Nothing is computed or decided here about the mechanism.
//!
//! | module | what it holds |
//! |---|---|
//! | `rust` | the expansion of a declaration: structs, entry points, searches, sweeps |
//! | `c` | the same functions in C99, their header, the run-time, and FMUs |
//! | `st` | the fast path in structured text of IEC 61131-3, as function blocks |
//! | `script` | the formulas in JavaScript, and the page that they move |
//! | `drawn_plan`, `drawing` | what a mechanism is drawn by: as data, and in Rust |
//! | `docs` | what documentation says of each item, and comments of headers |
//! | `printer` | the walk over a routine's statements, for every language |
//! | `arguments`, `listing` | the arguments of an entry point, and the sources of a list of assemblies |
//! | `identifiers`, `text` | names, and what code is written into |

mod arguments;
pub mod c;
pub mod docs;
mod drawing;
pub(crate) mod drawn_plan;
pub mod identifiers;
pub(crate) mod listing;
mod printer;
pub mod rust;
pub(crate) mod script;
pub mod st;
pub mod text;

use proc_macro2::TokenStream;

pub(crate) use docs::costs_in_words::{MOST, in_words};
pub(crate) use rust::assembly_functions::with_any;
pub(crate) use rust::driving_sets::{DrivenSet, generate as generate_sets};

use self::listing::Listing;
use crate::lower::routine::Lowered;
use crate::model::mechanism::Mechanism;

/// The sources of a drawing: the program that places everything, and of a page the one of masses, couples and wheels,
/// where there are any, and the declaration's text.
pub struct Drawing<'a> {
    pub placing: Lowered<'a>,
    pub marks: Option<Lowered<'a>>,
    pub source: Option<&'a str>,
}

/// Everything that the declaration of a mechanism expands to; what it is drawn by and lists of assemblies only where they are
/// given, and records that serde writes and reads where they are to be serialised.
pub fn generate(
    mechanism: &Mechanism,
    lowered: &Lowered<'_>,
    (drawing, listing): (Option<&Drawing<'_>>, Option<&Listing<'_>>),
    is_serialised: bool,
) -> TokenStream {
    let drawing = drawing.map(|drawing| drawing::items(mechanism, lowered, drawing));
    let listing = listing.map(|listing| rust::assembly_functions::items(mechanism, listing));
    let beside = drawing.into_iter().chain(listing).collect();
    rust::generate(mechanism, lowered, beside, is_serialised)
}
