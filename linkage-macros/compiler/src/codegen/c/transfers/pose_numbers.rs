//! The numbers of a pose in C, and lines that every function has.

use super::set_in_c::RowInC;
use crate::codegen::c::c_identifiers::Width;
use crate::interface::carried_over::PlaceInPose;

/// The end of a function that has called another.
pub(super) const RETURNED: &str = "if (status != LINKAGE_OK) {\nreturn status;\n}\n";

pub(super) fn null_checks(pointers: &[&str]) -> String {
    let check = |name: &&str| {
        format!(
            "if ({name} == NULL) {{\nreturn linkage_because(error, LINKAGE_NULL_POINTER, \"{name}\");\n}}\n"
        )
    };
    pointers.iter().map(check).collect()
}

/// A number of a width.
pub(super) fn literal(value: f64, width: Width) -> String {
    match width {
        Width::Double => format!("{value:?}"),
        Width::Single => format!("{:?}f", value as f32),
    }
}

/// The numbers of a pose, or of its rates.
pub(super) struct PoseNumbers {
    pub inputs: Vec<String>,
    pub rows: Vec<RowInC>,
    pub width: Width,
}

impl PoseNumbers {
    /// A number of this width.
    pub(super) fn value(&self, place: &PlaceInPose) -> String {
        match place {
            PlaceInPose::Input(input) => self.inputs[*input].clone(),
            PlaceInPose::Fixed(value) => literal(*value, self.width),
            PlaceInPose::Row(row, drawn) => match &self.rows[*row] {
                RowInC::Number(value) => value.clone(),
                RowInC::Angle([cosine, sine]) => {
                    let suffix = if self.width == Width::Single { "_f32" } else { "" };
                    let drawn = literal(drawn.unwrap_or(0.0), self.width);
                    format!("linkage_angle_near{suffix}({cosine}, {sine}, {drawn})")
                }
            },
        }
    }

    /// The same in double precision where there is one: its products are exact there.
    pub(super) fn wide(&self, place: &PlaceInPose) -> String {
        let value = self.value(place);
        if self.width == Width::Single { format!("(LinkageWide){value}") } else { value }
    }
}
