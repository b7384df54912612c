//! The ways to assemble a group, as far as they are proved.

pub use linkage_assemblies::Outcome;

/// A way to assemble a group.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ListedAssembly {
    /// The angle of the unknown from its value in the drawing.
    pub unknown: f64,
    /// The sides of the dyads in their order, a bit each: set where the inner pin is on the left of the way between the outer ones.
    pub sides: usize,
    /// True if the equation's left side grows with the unknown.
    pub rises: bool,
}

/// The ways to assemble a group in the pose of its drawing.
#[derive(Clone, Debug)]
pub struct Assemblies {
    /// The count of complex ones, whatever the lengths are.
    pub at_most: usize,
    pub outcome: Outcome,
    /// In the order of their unknowns, as far as they are proved.
    pub list: Vec<ListedAssembly>,
    /// The index of the drawing.
    pub drawn: Option<usize>,
    /// True if the unknowns are those of another way to solve the group than the one that is taken.
    pub is_by_another: bool,
}

impl Assemblies {
    /// True if these are all assemblies, the drawing among them.
    pub fn is_proved(&self) -> bool {
        self.outcome == Outcome::Proved && self.drawn.is_some()
    }

    /// The nearest other assembly with the drawing's sides and trend whose unknown is between these: a search there may find it.
    pub(crate) fn other_between(&self, [from, to]: [f64; 2]) -> Option<f64> {
        let drawn = self.list[self.drawn?];
        let is_like_it = |other: &&ListedAssembly| {
            **other != drawn
                && (other.sides, other.rises) == (drawn.sides, drawn.rises)
                && (from..=to).contains(&other.unknown)
        };
        let angles = self.list.iter().filter(is_like_it).map(|other| other.unknown);
        angles.min_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// The angle from the drawing to the nearest other assembly, where it is one of the unknown.
    pub fn nearest_other(&self) -> Option<f64> {
        if self.is_by_another {
            return None;
        }
        let others = self.list.iter().enumerate().filter(|(index, _)| Some(*index) != self.drawn);
        let angles = others.map(|(_, assembly)| assembly.unknown);
        angles.min_by(|a, b| a.abs().total_cmp(&b.abs()))
    }
}

/// The nearest other way to assemble a group than the drawing's: an angle by which a body is turned from there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OtherAssembly {
    pub body: usize,
    pub turned: f64,
}
