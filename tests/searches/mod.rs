//! The searches: the input at which an output has a wanted value, the range of an input, the extremes of an
//! output.

mod at_once;
mod beyond;
mod class_three;
mod class_three_forces;
mod derived;
mod followed;
mod named;
mod ranges;
mod seeded;
mod set_points;
mod several;
mod sides;
mod unknowns;
