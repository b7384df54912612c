//! Every mechanism of the examples as a film, the figures of the language, and the site that shows
//! them. What is drawn here is drawn by `linkage_core::sketch`; what is said here is how each moves.

pub mod declarations;
pub mod figures;
pub mod motions;
pub mod page;
pub mod sheet;

pub use motions::{Kind, Piece, pieces, readme};
