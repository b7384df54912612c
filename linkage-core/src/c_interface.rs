//! Answers of the C functions of `export c;`: a status code, and a record that explains it.
//!
//! The layouts and codes here are the ones that the generated header declares. Pointers are only
//! made here; what follows one is written where `export c;` is, in the crate that asked for it.

use core::ptr;

use crate::crossing::Trend;
use crate::{Sense, Side, SolveError};

/// Why a C function gave no answer: `LinkageError` of the header.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CError {
    /// 0, or one of the codes below.
    pub status: i32,
    /// The missing length in metres where a group is out of reach; the remaining difference of the
    /// equation where an unknown has no solution; otherwise 0.
    pub by: f64,
    /// The links of the group, not terminated; null where no group is to blame.
    pub group: *const u8,
    /// The number of bytes of `group`.
    pub group_length: usize,
    /// The input, parameter, length, result or argument to blame, not terminated; null where the
    /// group says it all.
    pub name: *const u8,
    /// The number of bytes of `name`.
    pub name_length: usize,
}

const OUT_OF_REACH: i32 = 1;
const SINGULAR: i32 = 2;
const INVALID_LENGTH: i32 = 3;
const NOT_FINITE: i32 = 4;
const NULL_POINTER: i32 = 5;
const INVALID_MODE: i32 = 6;
const OFF_CIRCLE: i32 = 7;
const NO_SOLUTION: i32 = 8;
const SEVERAL_DEAD_POINTS: i32 = 9;
const JAMS: i32 = 10;
const NOT_CERTIFIED: i32 = 12;

impl CError {
    /// Nothing is wrong: what the errors begin with.
    pub const NONE: Self = Self {
        status: 0,
        by: 0.0,
        group: ptr::null(),
        group_length: 0,
        name: ptr::null(),
        name_length: 0,
    };

    /// An argument that has to point to something is null.
    #[must_use]
    pub const fn null_pointer(name: &'static str) -> Self {
        Self::NONE.because_of(NULL_POINTER, name)
    }

    const fn because_of(self, status: i32, name: &'static str) -> Self {
        Self { status, name: name.as_ptr(), name_length: name.len(), ..self }
    }

    const fn in_group(self, status: i32, group: &'static str) -> Self {
        Self { status, group: group.as_ptr(), group_length: group.len(), ..self }
    }
}

impl From<SolveError> for CError {
    fn from(error: SolveError) -> Self {
        match error {
            SolveError::OutOfReach { group, by } => {
                Self { by, ..Self::NONE.in_group(OUT_OF_REACH, group) }
            }
            SolveError::Singular { group } => Self::NONE.in_group(SINGULAR, group),
            SolveError::Invalid { group, name } => {
                Self::NONE.in_group(INVALID_LENGTH, group).because_of(INVALID_LENGTH, name)
            }
            SolveError::NotFinite { name } => Self::NONE.because_of(NOT_FINITE, name),
            SolveError::NoSolution { unknown, by, .. } => {
                Self { by, ..Self::NONE.because_of(NO_SOLUTION, unknown) }
            }
            SolveError::SeveralDeadPoints { unknown } => {
                Self::NONE.because_of(SEVERAL_DEAD_POINTS, unknown)
            }
            SolveError::Jams { joint } => Self::NONE.because_of(JAMS, joint),
            SolveError::NotCertified { group } => Self::NONE.in_group(NOT_CERTIFIED, group),
            SolveError::OffCircle { name, .. } => Self::NONE.because_of(OFF_CIRCLE, name),
        }
    }
}

/// `LINKAGE_LEFT` or `LINKAGE_RIGHT` as a side; no other number is one.
pub const fn c_side(mode: i32, name: &'static str) -> Result<Side, CError> {
    match mode {
        1 => Ok(Side::Left),
        -1 => Ok(Side::Right),
        _ => Err(CError::NONE.because_of(INVALID_MODE, name)),
    }
}

/// `LINKAGE_AHEAD` or `LINKAGE_BEHIND` as a sense; no other number is one.
pub const fn c_sense(mode: i32, name: &'static str) -> Result<Sense, CError> {
    match mode {
        1 => Ok(Sense::Ahead),
        -1 => Ok(Sense::Behind),
        _ => Err(CError::NONE.because_of(INVALID_MODE, name)),
    }
}

/// 1 or −1 as a trend; no other number is one.
pub const fn c_trend(mode: i32, name: &'static str) -> Result<Trend, CError> {
    match mode {
        1 => Ok(Trend::Rising),
        -1 => Ok(Trend::Falling),
        _ => Err(CError::NONE.because_of(INVALID_MODE, name)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The status, the distance, and how long the two names are.
    fn parts(error: impl Into<CError>) -> (i32, f64, usize, usize) {
        let error = error.into();
        (error.status, error.by, error.group_length, error.name_length)
    }

    #[test]
    fn every_error_has_a_code_and_keeps_its_words() {
        let (group, name) = ("BC, DC", "length");
        let reach = SolveError::OutOfReach { group, by: 0.25 };
        assert_eq!(parts(reach), (OUT_OF_REACH, 0.25, 6, 0));
        assert_eq!(CError::from(reach).group, group.as_ptr());
        assert!(CError::from(reach).name.is_null());
        assert_eq!(parts(SolveError::Singular { group }), (SINGULAR, 0.0, 6, 0));
        assert_eq!(parts(SolveError::Invalid { group, name }), (INVALID_LENGTH, 0.0, 6, 6));
        assert_eq!(parts(SolveError::NotFinite { name }), (NOT_FINITE, 0.0, 0, 6));
        let off_circle = SolveError::OffCircle { name: "theta", amplitude: 0.5 };
        assert_eq!(parts(off_circle), (OFF_CIRCLE, 0.0, 0, 5));
        let no_solution =
            SolveError::NoSolution { unknown: "theta", by: 0.5, unit: "m", other: None };
        assert_eq!(parts(no_solution), (NO_SOLUTION, 0.5, 0, 5));
        let several = SolveError::SeveralDeadPoints { unknown: "theta" };
        assert_eq!(parts(several), (SEVERAL_DEAD_POINTS, 0.0, 0, 5));
        assert_eq!(parts(SolveError::Jams { joint: "ram" }), (JAMS, 0.0, 0, 3));
        assert_eq!(parts(SolveError::NotCertified { group }), (NOT_CERTIFIED, 0.0, 6, 0));
        assert_eq!(parts(CError::null_pointer("error")), (NULL_POINTER, 0.0, 0, 5));
        assert_eq!(parts(CError::NONE), (0, 0.0, 0, 0));
    }

    #[test]
    fn only_the_declared_numbers_are_modes() {
        assert!(matches!(c_side(1, "elbow"), Ok(Side::Left)));
        assert!(matches!(c_side(-1, "elbow"), Ok(Side::Right)));
        assert!(matches!(c_sense(1, "way"), Ok(Sense::Ahead)));
        assert!(matches!(c_sense(-1, "way"), Ok(Sense::Behind)));
        assert!(matches!(c_trend(1, "way"), Ok(Trend::Rising)));
        assert!(matches!(c_trend(-1, "way"), Ok(Trend::Falling)));
        for mode in [0, 2, -2, i32::MIN] {
            let error = c_side(mode, "elbow").unwrap_err();
            assert_eq!(parts(error), (INVALID_MODE, 0.0, 0, 5));
            assert_eq!(parts(c_sense(mode, "way").unwrap_err()), (INVALID_MODE, 0.0, 0, 3));
            assert_eq!(parts(c_trend(mode, "way").unwrap_err()), (INVALID_MODE, 0.0, 0, 3));
        }
    }
}
