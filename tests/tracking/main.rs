//! A tracker follows its motion through change points.

mod change_points;
mod groups;
mod limits;
mod steps;
