//! What is searched for rather than solved: the input at which an output is where it is wanted, the
//! range of an input, the extremes of an output.

mod derived;
mod followed;
mod named;
mod ranges;
mod seeded;
mod set_points;
mod several;
mod sides;
mod unknowns;
