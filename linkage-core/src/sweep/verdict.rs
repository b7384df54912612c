//! Conclusions that a sweep draws from the fast path's comparisons: which poses may be used and, where some
//! may not, which of these are out of reach.
//!
//! Comparisons say that a condition is not met, and leave the reason to the slow path. One reason is as
//! common as solved poses, in a map of a workspace say, and vectors can tell it: every condition before a
//! group's reach is met, what is given is finite, and what stands under the group's root is below zero by
//! more than rounding. Then the slow path would find nothing else.

use core::fmt::Debug;
use core::ops::BitAnd;

use crate::scalar::Sealed;
use crate::{LaneMask, Mask};

/// The number of poses that are computed beside each other, before the compiler takes several such sets at
/// a time into vectors. A vector of poses begins while the one before waits for its root. Three would take
/// more registers than most machines have.
pub(super) const TOGETHER: usize = 2;

type PoseMask = LaneMask<TOGETHER>;

/// The question that comparisons answer.
pub(super) trait Asked: Copy + Debug + 'static {
    /// The answer.
    type Mask: Mask;

    /// That of a comparison.
    fn compared(met: PoseMask) -> Self::Mask;

    /// That of a result's being finite, which it is not where a group is out of reach.
    fn finite(met: PoseMask) -> Self::Mask;

    /// The poses that may be used.
    fn usable(mask: Self::Mask) -> PoseMask;
}

/// Which poses may be used.
#[derive(Clone, Copy, Debug)]
pub(super) enum Usable {}

impl Asked for Usable {
    type Mask = PoseMask;

    #[inline(always)]
    fn compared(met: PoseMask) -> PoseMask {
        met
    }
    #[inline(always)]
    fn finite(met: PoseMask) -> PoseMask {
        met
    }
    #[inline(always)]
    fn usable(mask: PoseMask) -> PoseMask {
        mask
    }
}

/// Which poses are out of reach as well.
#[derive(Clone, Copy, Debug)]
pub(super) enum OutOfReach {}

impl Asked for OutOfReach {
    type Mask = Verdict;

    #[inline(always)]
    fn compared(met: PoseMask) -> Verdict {
        Verdict { met, sound: met, ..Verdict::ALL }
    }
    #[inline(always)]
    fn finite(met: PoseMask) -> Verdict {
        Verdict { met, ..Verdict::ALL }
    }
    #[inline(always)]
    fn usable(mask: Verdict) -> PoseMask {
        mask.met
    }
}

/// The state of each pose after the conditions so far.
#[derive(Clone, Copy, Debug)]
pub(super) struct Verdict {
    /// All of them are met.
    met: PoseMask,
    /// Those before the last one are met.
    earlier: PoseMask,
    /// No first failure is a group out of reach.
    reached: PoseMask,
    /// The range conditions are met: an angle is small enough for its sine to be right, for example.
    sound: PoseMask,
}

impl Verdict {
    /// The poses whose first failure is a group out of reach.
    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn out_of_reach(self) -> [bool; TOGETHER] {
        let mut out = self.sound.to_array();
        for (out, reached) in out.iter_mut().zip(self.reached.to_array()) {
            *out &= !reached;
        }
        out
    }
}

/// Combines conditions beside the formulas.
impl BitAnd for Verdict {
    type Output = Self;

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn bitand(self, other: Self) -> Self {
        Self {
            met: self.met & other.met,
            earlier: self.earlier & other.earlier,
            reached: self.reached & other.reached,
            sound: self.sound & other.sound,
        }
    }
}

impl Sealed for Verdict {}

impl Mask for Verdict {
    const ALL: Self = Self {
        met: PoseMask::ALL,
        earlier: PoseMask::ALL,
        reached: PoseMask::ALL,
        sound: PoseMask::ALL,
    };

    #[inline(always)]
    fn all(self) -> bool {
        self.met.all()
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn and_condition(self, condition: Self) -> Self {
        Self { met: self.met & condition.met, ..self }
    }

    #[cfg_attr(debug_assertions, inline(never))]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn behind_condition(self) -> Self {
        Self { earlier: self.met, ..self }
    }

    #[inline(always)]
    fn behind_reach(self, is_beyond: impl FnOnce() -> Self) -> Self {
        let mut reached = self.reached.to_array();
        let refused = (self.earlier & is_beyond().met).to_array();
        for (reached, refused) in reached.iter_mut().zip(refused) {
            *reached &= !refused;
        }
        Self { reached: PoseMask::new(reached), earlier: self.met, ..self }
    }
}
