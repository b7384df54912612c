//! Tables of truth, and the programs that compute them.

pub mod forces;
pub mod four_bar_published;
pub mod hard;
pub mod slopes;
pub mod text;
pub mod truth;

/// A module for every file, with the file's tables.
macro_rules! tables {
    ($($file:ident: $($name:ident)+;)+) => {$(
        pub mod $file {
            use super::truth::Table;
            use std::sync::LazyLock;

            const TEXT: &str = include_str!(concat!(stringify!($file), ".txt"));
            $(pub static $name: LazyLock<Table> =
                LazyLock::new(|| Table::read(TEXT, stringify!($name)));)+
        }
    )+};
}

tables! {
    drivers: GANTRY POLAR_ARM GEARED_FIVE_BAR RACK_AND_PINION EXCAVATOR SWINGING_GUIDE;
    flying_shear: FLYING_SHEAR;
    four_bar: FOUR_BAR;
    moving_bases: MOVING_BASES;
    rpp_systems: CRANK_RPP SIX_BAR;
    single_groups: COUPLER_FOUR_BAR COUPLER_FOUR_BAR_FLIPPED INCLINED_SLIDER_CRANK
        INCLINED_SLIDER_CRANK_FLIPPED OFFSET_QUICK_RETURN OFFSET_QUICK_RETURN_FLIPPED
        CROSSED_GUIDES OBLIQUE_YOKE;
    variable_dimensions: VARIABLE_FOUR_BAR VARIABLE_BAR VARIABLE_CROSS VARIABLE_YOKE VARIABLE_ROD;
}
