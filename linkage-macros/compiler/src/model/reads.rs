//! The readings of an expression, and those that may stand where it does.

use std::ops::Deref;

use crate::model::acting::Effort;

/// Readings of an expression that no dimension may have.
pub struct Readings {
    pub load: bool,
    pub rate: bool,
    /// Efforts and reactions.
    pub efforts: Vec<Effort>,
    /// A function with a corner.
    pub corner: Option<&'static str>,
}

static NONE: Readings = Readings { load: false, rate: false, efforts: Vec::new(), corner: None };

/// The readings of an expression: most have none. They stand apart from the expression, which is
/// resolved a level of its nesting at a time, each on the stack.
#[derive(Default)]
pub struct Reads(Option<Box<Readings>>);

/// Readings that may stand where an expression does.
#[derive(Clone, Copy)]
pub(super) struct Allowed {
    /// Loads, rates, and laws of them.
    pub forces: bool,
    /// Functions with a corner.
    pub corners: bool,
    /// Efforts and reactions.
    pub efforts: bool,
}

impl Allowed {
    /// In what a machine is made of, and how it moves.
    pub(super) const IN_DIMENSIONS: Self = Self { forces: false, corners: false, efforts: false };
    /// In forces and torques, and in what is named: that is refused where it is used.
    pub(super) const IN_FORCES: Self = Self { forces: true, corners: true, efforts: false };
    pub(super) const IN_OUTPUTS: Self = Self { efforts: true, ..Self::IN_FORCES };
}

impl Readings {
    /// True if the value is one of forces, and not of a pose.
    pub(super) fn is_of_forces(&self) -> bool {
        self.load || self.rate || !self.efforts.is_empty()
    }
}

impl Deref for Reads {
    type Target = Readings;

    fn deref(&self) -> &Readings {
        self.0.as_deref().unwrap_or(&NONE)
    }
}

impl Reads {
    pub(super) fn a_load() -> Self {
        Self::default().with(|reads| reads.load = true)
    }

    pub(super) fn an_effort(effort: Effort) -> Self {
        Self::default().with(|reads| reads.efforts.push(effort))
    }

    /// These and the same of a rate.
    pub(super) fn of_a_rate(self) -> Self {
        self.with(|reads| reads.rate = true)
    }

    /// These and a corner of the function, in front of others.
    pub(super) fn with_a_corner(self, function: &'static str) -> Self {
        self.with(|reads| reads.corner = Some(function))
    }

    /// These and others.
    pub(super) fn and(self, other: &Self) -> Self {
        let Some(other) = &other.0 else { return self };
        self.with(|reads| {
            reads.load |= other.load;
            reads.rate |= other.rate;
            reads.efforts.extend_from_slice(&other.efforts);
            reads.corner = reads.corner.or(other.corner);
        })
    }

    fn with(mut self, change: impl FnOnce(&mut Readings)) -> Self {
        let none = || Box::new(Readings { efforts: Vec::new(), ..NONE });
        change(self.0.get_or_insert_with(none));
        self
    }
}

impl Clone for Reads {
    fn clone(&self) -> Self {
        Self::default().and(self)
    }
}
