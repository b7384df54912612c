//! Positions, velocities and accelerations are right: published and computed tables, planted
//! poses, exact identities, wherever a mechanism stands and however large it is.

mod chains;
mod coefficients;
mod identities;
mod modes;
mod parallelograms;
mod placement;
mod planted;
mod published_tables;
mod ratios;
mod readings;
mod scale;
mod tabulated;
