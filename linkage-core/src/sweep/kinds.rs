//! The entry points that have sweeps, as types: they tell an [`Entry`](super::Entry) of one mechanism from the
//! next.

/// The entry point `position`.
#[derive(Debug)]
pub enum OfPosition {}

/// The entry point `velocity`.
#[derive(Debug)]
pub enum OfVelocity {}

/// The entry point `motion`.
#[derive(Debug)]
pub enum OfMotion {}

/// The entry point `forces`.
#[derive(Debug)]
pub enum OfForces {}

/// The entry point `statics`.
#[derive(Debug)]
pub enum OfStatics {}

/// The entry point `energy`.
#[derive(Debug)]
pub enum OfEnergy {}

/// The entry point `forward_dynamics`.
#[derive(Debug)]
pub enum OfForwardDynamics {}

/// The entry point `equations_of_motion`.
#[derive(Debug)]
pub enum OfEquationsOfMotion {}
