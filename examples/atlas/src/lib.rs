//! Hrones and Nelson's atlas of coupler curves, recomputed, and a search of four-bars for a drawn path.
//!
//! J. A. Hrones and G. L. Nelson drew some 7,300 curves of coupler points, for designers to turn the pages
//! until one has the shape they need ("Analysis of the Four-Bar Linkage", 1951). Here [`four_bar`] declares
//! the linkage, [`grid`] says which dimensions are drawn and which are searched, [`shape`] says how near two
//! curves are, and [`search`] turns the pages. A search larger than one machine is done in [`part`]s, by any
//! engine that runs programs (`cluster.py`), and [`refine`] takes what was found from the grid to the nearest
//! optimum.

pub mod drawn_path;
pub mod fingerprint;
pub mod four_bar;
pub mod grid;
pub mod options;
pub mod part;
pub mod picture;
pub mod progress;
pub mod refine;
pub mod search;
pub mod shape;
#[cfg(test)]
mod tests;
