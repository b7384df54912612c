//! Declarations, by what the tests that use them ask.

pub mod chains;
pub mod change_points;
pub mod compensated;
pub mod differentiated;
pub mod driven_groups;
pub mod drivers;
pub mod exact_inputs;
pub mod forces;
pub mod heavy_groups;
pub mod identities;
pub mod margins;
pub mod moving_bases;
pub mod near_limits;
pub mod placement;
pub mod published;
pub mod ranges;
pub mod resolvers;
pub mod right_or_refused;
pub mod scaled_change_points;
pub mod set_points;
pub mod single_groups;
pub mod slides;
pub mod stacked_sliders;
pub mod statuses;
pub mod unknowns;
pub mod variable_dimensions;
