//! Equations that are solved at run time: a row for each kind, which says what it reads on each path,
//! what it costs and what comes out.
//!
//! Each number that comes out is a node ([`Node::Solved`](super::node::Node::Solved)). The refusal of
//! a root is the search's own and names the unknown; that of amounts of friction names a joint.

use crate::ir::node::{Id, Path, RootSearch};
use crate::ir::operations::Operations;

/// Equations, and how they are solved.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Implicit {
    /// A search. For a root comes out the root and the size that the rounding of its equation is
    /// measured by; for an end the end and one at a dead point, zero elsewhere.
    Root(RootSearch),
    /// Newton's method. An amount a contact comes out: both paths put the solution in the place of the
    /// value that the amount stands on, where steps to it begin. Where straight-line code has made
    /// these steps, that value is its amount, and both paths ask for proofs.
    Amounts(Contacts),
}

/// The equations of amounts of friction that depend on each other.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Contacts {
    /// The joints, as errors name them, and whether each is a guide.
    pub joints: Vec<(String, bool)>,
    /// The rows, one after the other, as the run-time crate lays them out; then the first values of the
    /// steps.
    pub equations: Vec<Id>,
    /// Numbers above zero where straight-line code has found the amounts.
    pub positive: Vec<Id>,
    /// Pairs, one after the other, of which the first is less than the rounding of the second there.
    pub small: Vec<Id>,
}

impl Implicit {
    /// The count of numbers that come out.
    pub(crate) fn outputs(&self) -> usize {
        match self {
            Self::Root(_) => 2,
            Self::Amounts(contacts) => contacts.joints.len(),
        }
    }

    /// The contacts whose friction is solved; none of a search.
    pub fn contacts(&self) -> Option<&Contacts> {
        match self {
            Self::Root(_) => None,
            Self::Amounts(contacts) => Some(contacts),
        }
    }

    /// The unknown that is searched; none where it is no search.
    pub(crate) fn unknown(&self) -> Option<u32> {
        match self {
            Self::Root(sought) => Some(sought.unknown),
            Self::Amounts(_) => None,
        }
    }

    /// True if a function of its own searches.
    pub(crate) fn is_search(&self) -> bool {
        matches!(self, Self::Root(_))
    }

    /// The mode parameter that chooses among the solutions.
    pub(crate) fn chosen_by(&self) -> Option<u32> {
        match self {
            Self::Root(sought) => sought.trend.param(),
            Self::Amounts(_) => None,
        }
    }

    /// Calls `f` with what a number that comes out is made from, beside the value that it stands on.
    pub(super) fn for_operands(&self, output: u32, path: Path, f: &mut impl FnMut(Id)) {
        let lists: [&[Id]; 3] = match (self, path) {
            // A root's size stands on the root.
            (Self::Root(_), _) if output > 0 => return,
            (Self::Root(RootSearch { between, near, sides, .. }), _) => {
                [between, near.as_slice(), sides]
            }
            (Self::Amounts(_), Path::Unchecked) => return,
            (Self::Amounts(contacts), Path::Fast) if contacts.are_found() => {
                [&contacts.positive, &contacts.small, &[]]
            }
            (Self::Amounts(contacts), _) => {
                [&contacts.equations, &contacts.positive, &contacts.small]
            }
        };
        lists.into_iter().flatten().for_each(|&id| f(id));
    }

    /// The values that the slow path reads, and those that the fast path reads where these are others: given
    /// what is handed to a search, and the values that the needed outputs stand on.
    pub(crate) fn reads(
        &self,
        given: &[Id],
        beneath: impl Iterator<Item = Id>,
    ) -> (Vec<Id>, Option<Vec<Id>>) {
        let Self::Amounts(contacts) = self else { return (given.to_vec(), None) };
        let (rows, starts) = contacts.parts();
        let proofs = contacts.positive.iter().chain(&contacts.small).copied();
        let found = contacts.are_found().then(|| beneath.chain(proofs).collect());
        ([starts, &rows.concat()].concat(), found)
    }

    /// The same equations on other operands.
    pub(crate) fn on(&self, moved: &dyn Fn(Id) -> Id) -> Self {
        let mut new = self.clone();
        let put = |id: &mut Id| *id = moved(*id);
        match &mut new {
            Self::Root(RootSearch { between, near, sides, .. }) => {
                between.iter_mut().chain(near).chain(sides).for_each(put);
            }
            Self::Amounts(Contacts { equations, positive, small, .. }) => {
                equations.iter_mut().chain(positive).chain(small).for_each(put);
            }
        }
        new
    }

    /// The operations of the fast path: all is solved with the first number, and what a search computes
    /// is counted by itself.
    pub fn cost(&self, output: u32) -> Operations {
        match self {
            Self::Amounts(contacts) if output == 0 => contacts.cost(),
            _ => Operations::default(),
        }
    }
}

impl From<Contacts> for Implicit {
    fn from(contacts: Contacts) -> Self {
        Self::Amounts(contacts)
    }
}

impl Contacts {
    /// The rows, and where steps begin.
    pub fn parts(&self) -> (Vec<&[Id]>, &[Id]) {
        let count = self.joints.len();
        let (rows, starts) = self.equations.split_at(self.equations.len() - count);
        (rows.chunks(rows.len() / count).collect(), starts)
    }

    /// True where straight-line code has found the amounts.
    pub(crate) fn are_found(&self) -> bool {
        !self.positive.is_empty() || !self.small.is_empty()
    }

    /// A number whose bit j is set if contact j is a guide.
    pub(crate) fn guides(&self) -> u32 {
        let contacts = self.joints.iter().enumerate();
        contacts.map(|(j, (_, is_guide))| u32::from(*is_guide) << j).sum()
    }

    /// Four steps of Newton's method, and what asks whether three were enough.
    fn cost(&self) -> Operations {
        let mut total = Operations::default();
        if self.are_found() {
            // The comparison with rounding takes its last places.
            total.multiplications = self.small.len() as u32 / 2;
            return total;
        }
        let mut fused = |count: usize| {
            total.additions += count as u32;
            total.multiplications += count as u32;
        };
        let count = self.joints.len();
        let pins = self.joints.iter().filter(|(_, is_guide)| !is_guide).count();
        let below = count * (count - 1) / 2;
        let elimination = (0..count).map(|k| (count - k - 1).pow(2)).sum::<usize>();
        // Reactions, slopes, I − Φ′ and Φ − x; the elimination, and both sides of it.
        fused(4 * count * (2 * count + 2 * count + 1) + 4 * (elimination + 2 * below));
        // The bounds of all pairs, their elimination, the reactions and sizes once more.
        fused(2 * pins * (count + 2) + elimination + count * (2 * count + count + 1));
        total.divisions = (4 * (pins + below + count) + below) as u32;
        total.roots = (4 * pins + pins * (count + 2)) as u32;
        total
    }
}
