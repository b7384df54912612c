//! Hrones and Nelson's atlas of coupler curves, recomputed, and a search of four-bars for a drawn path.
//!
//! J. A. Hrones and G. L. Nelson drew some 7,300 curves of coupler points, for designers to turn the pages
//! until one has the shape they need ("Analysis of the Four-Bar Linkage", 1951). Here [`four_bar`] declares
//! the linkage, [`grid`] says which dimensions are drawn and which are searched, [`shape`] says how near two
//! curves are, and [`search`] turns the pages.

pub mod drawn_path;
pub mod four_bar;
pub mod grid;
pub mod picture;
pub mod progress;
pub mod search;
pub mod shape;
#[cfg(test)]
mod tests;
