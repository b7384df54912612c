//! Every mechanism of the examples as a film, the figures of the language, and the site that shows
//! them. `linkage_core::sketch` draws the films; this crate defines the motion of each.

pub mod declarations;
pub mod figures;
pub mod live;
pub mod motions;
pub mod page;
pub mod sheet;

pub use motions::{Kind, Piece, pieces, readme};
