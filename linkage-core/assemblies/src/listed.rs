//! The ways to assemble a group, as far as they are proved.

use core::f64::consts::{PI, TAU};

use libm::floor;

/// The most halvings of the room about an assembly, up to the rounding of the unknown.
const HALVINGS: usize = 52;

/// The part of the assemblies that is proved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// The list has all of them.
    Proved,
    /// Some may be missing, the first between these two values of the unknown, in radians: two assemblies are next to each other there, or
    /// have one unknown, or nearly meet. Behind them the list may end.
    Open {
        /// The lower value.
        from: f64,
        /// The upper value.
        to: f64,
    },
    /// The budget was spent before all of the circle was looked at.
    OutOfBudget,
}

/// A way to assemble a group.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Assembly {
    /// The unknown in radians, in [−π, π).
    pub unknown: f64,
    /// Two values of the unknown between which it lies, proved.
    pub between: [f64; 2],
    /// The sides of the dyads in their order, a bit each: set where the inner pin is on the left of the way between the outer ones.
    pub sides: usize,
    /// True if the equation's left side grows with the unknown.
    pub rises: bool,
    /// Half the angle to the nearest other assembly in radians, whichever sides it has; π where there is none.
    pub room: f64,
    /// The width on each side within which the unknown is searched, in radians: the room, or less where the dyads do not assemble on these sides.
    pub within: f64,
}

/// The ways to assemble a group in one pose of the inputs, at most `N`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct List<const N: usize> {
    assemblies: [Assembly; N],
    count: usize,
    /// The part that is proved.
    pub outcome: Outcome,
    /// Values of the product over all modes that were computed.
    pub samples: u32,
    /// Pieces of the circle that were looked at.
    pub pieces: u32,
}

/// The assembly that is nearest to what was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Nearest {
    /// The assembly.
    pub assembly: Assembly,
    /// Its distance from what was measured.
    pub off: f64,
    /// The distance of the next one, if there is one.
    pub runner_up: Option<f64>,
}

/// An angle within half a turn, from −π on.
pub(crate) fn wrapped(angle: f64) -> f64 {
    angle - TAU * floor((angle + PI) / TAU)
}

impl<const N: usize> List<N> {
    /// A list of none.
    pub(crate) fn new(outcome: Outcome) -> Self {
        let none = Assembly {
            unknown: 0.0,
            between: [0.0; 2],
            sides: 0,
            rises: false,
            room: PI,
            within: PI,
        };
        Self { assemblies: [none; N], count: 0, outcome, samples: 0, pieces: 0 }
    }

    /// A list of which nothing is known.
    #[must_use]
    pub fn unknown() -> Self {
        Self::new(Outcome::Open { from: -PI, to: PI })
    }

    /// False where there is no room for it.
    pub(crate) fn push(&mut self, assembly: Assembly) -> bool {
        let free = self.assemblies.get_mut(self.count);
        let is_free = free.is_some();
        if let Some(free) = free {
            *free = assembly;
            self.count += 1;
        }
        is_free
    }

    /// In the order of the unknown, with the room of each.
    pub(crate) fn sort(&mut self) {
        let all = &mut self.assemblies[..self.count];
        all.sort_unstable_by(|a, b| a.unknown.total_cmp(&b.unknown));
        let [Some(first), Some(last)] =
            [all.first(), all.last()].map(|end| end.map(|end| end.unknown))
        else {
            return;
        };
        // Once around from the last one to the first; a whole turn where it is one alone.
        let around = TAU - (last - first);
        let mut before = around;
        for index in 0..all.len() {
            let next = all.get(index + 1).map(|next| next.unknown);
            let behind = next.map_or(around, |next| next - all[index].unknown);
            all[index].room = before.min(behind) / 2.0;
            before = behind;
        }
    }

    /// The room of each assembly is halved until a search about it is inside.
    pub(crate) fn search_within(&mut self, is_inside: impl Fn(&Assembly, f64) -> bool) {
        for assembly in &mut self.assemblies[..self.count] {
            let mut within = assembly.room;
            for _ in 0..HALVINGS {
                if [within, -within].iter().all(|off| is_inside(assembly, *off)) {
                    break;
                }
                within /= 2.0;
            }
            assembly.within = within;
        }
    }

    /// The assemblies in the order of their unknowns.
    #[must_use]
    pub fn as_slice(&self) -> &[Assembly] {
        &self.assemblies[..self.count]
    }

    /// The assemblies in the order of their unknowns.
    pub fn iter(&self) -> core::slice::Iter<'_, Assembly> {
        self.as_slice().iter()
    }

    /// The count of assemblies that were found.
    #[must_use]
    pub fn len(&self) -> usize {
        self.count
    }

    /// True if none was found.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// True if the list has all assemblies.
    #[must_use]
    pub fn is_proved(&self) -> bool {
        self.outcome == Outcome::Proved
    }

    /// The assembly whose unknown is nearest to a measured one, in radians; whole turns make no difference.
    #[must_use]
    pub fn nearest(&self, unknown: f64) -> Option<Nearest> {
        self.nearest_by_angle(unknown, |assembly| Some(assembly.unknown))
    }

    /// The assembly in which an angle is nearest to the measured one, in radians; whole turns make no difference. An assembly without the
    /// angle is left out.
    pub fn nearest_by_angle(
        &self,
        measured: f64,
        mut angle: impl FnMut(&Assembly) -> Option<f64>,
    ) -> Option<Nearest> {
        self.nearest_by(|assembly| Some(wrapped(angle(assembly)? - measured).abs()))
    }

    /// The assembly with the least distance from what was measured. An assembly without a distance, or with one that is no number, is left
    /// out.
    pub fn nearest_by(
        &self,
        mut distance: impl FnMut(&Assembly) -> Option<f64>,
    ) -> Option<Nearest> {
        let mut nearest: Option<Nearest> = None;
        for &assembly in self {
            let Some(off) = distance(&assembly).filter(|off| !off.is_nan()) else { continue };
            nearest = Some(match nearest {
                Some(best) if best.off <= off => {
                    let runner_up = best.runner_up.map_or(off, |other| other.min(off));
                    Nearest { runner_up: Some(runner_up), ..best }
                }
                best => Nearest { assembly, off, runner_up: best.map(|best| best.off) },
            });
        }
        nearest
    }
}

impl<'l, const N: usize> IntoIterator for &'l List<N> {
    type Item = &'l Assembly;
    type IntoIter = core::slice::Iter<'l, Assembly>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}
