//! Tables of truth, and the programs that compute them.

pub mod drivers;
pub mod flying_shear;
pub mod four_bar;
pub mod four_bar_published;
pub mod hard;
pub mod moving_bases;
pub mod rpp_systems;
pub mod single_groups;
pub mod slopes;
pub mod truth;
pub mod variable_dimensions;
