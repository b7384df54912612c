//! A tracker follows its motion through change points.

mod change_points;
mod clearances;
mod followed;
mod groups;
mod interpolated;
mod limits;
mod steps;
mod thresholds;
