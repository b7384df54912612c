//! The pins and bodies of a group that one unknown and dyads of bars place, in the pose of the drawing.
//!
//! Bodies whose drives hold them together are one body there: each drive is at its drawn value.

use crate::chain::cutting::{Dyad, Found, Pair, SearchedGroup};
use crate::chain::machine::Machine;

/// The number of all that stands still, and that of the body that the unknown turns.
pub(super) const STANDING: usize = 0;
pub(super) const TURNED: usize = 1;
/// The most dyads of a group, and its most bodies.
pub(super) const DYADS: usize = 4;
pub(super) const BODIES: usize = 2 * DYADS + 2;

/// A pin as a point of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct BodyPin {
    pub body: usize,
    pub pin: usize,
}

/// A bar of a dyad: it hangs on another body and ends at the dyad's inner pin.
#[derive(Clone, Copy, Debug)]
pub(super) struct HungBar {
    pub body: usize,
    pub outer: BodyPin,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct PinnedDyad {
    pub bars: [HungBar; 2],
    pub inner: usize,
}

/// A group with one link left out: the distance of two pins is the equation.
#[derive(Clone, Debug)]
pub(super) struct PinnedGroup {
    /// The pin about which the unknown turns its body.
    pub pivot: usize,
    /// In the order in which they are placed.
    pub dyads: Vec<PinnedDyad>,
    pub equation: [BodyPin; 2],
}

impl PinnedGroup {
    /// The group of a search; `None` where it has a slide, or a dyad carries links between its bars.
    pub(super) fn of(machine: &Machine, search: &SearchedGroup) -> Option<Self> {
        let mut numbers = BodyNumbers { machine, of: vec![STANDING; machine.bodies.len()] };
        let (first, others) = search.steps.split_first()?;
        let Found::Crank { drive: None, body, pivot, .. } = first else { return None };
        numbers.of[*body] = TURNED;
        let mut dyads = Vec::new();
        for step in others {
            match step {
                Found::Dyad(dyad) => dyads.push(numbers.dyad(dyad, TURNED + 1 + 2 * dyads.len())?),
                Found::Crank { drive: Some(_), body, reference, .. } => {
                    numbers.of[*body] = numbers.of[*reference];
                }
                Found::Crank { .. } | Found::Slider { .. } | Found::Search(_) => return None,
            }
        }
        let [Pair::Pin(first), Pair::Pin(second)] = search.joints else { return None };
        let equation = [first, second].map(|pin| numbers.host(pin));
        (dyads.len() <= DYADS).then_some(Self { pivot: *pivot, dyads, equation })
    }
}

/// The numbers of bodies, by their indices in the machine.
struct BodyNumbers<'m> {
    machine: &'m Machine,
    of: Vec<usize>,
}

impl BodyNumbers<'_> {
    /// A placed pin: on a body of the group if there is one, else it stands still.
    fn host(&self, pin: usize) -> BodyPin {
        let own = self.machine.at(pin).map(|body| self.of[body]).find(|&body| body != STANDING);
        BodyPin { body: own.unwrap_or(STANDING), pin }
    }

    /// A dyad, whose bars have this number and the next.
    fn dyad(&mut self, dyad: &Dyad, number: usize) -> Option<PinnedDyad> {
        let Pair::Pin(inner) = dyad.inner else { return None };
        if !dyad.carried.is_empty() {
            return None;
        }
        let [Pair::Pin(first), Pair::Pin(second)] = dyad.legs.each_ref().map(|leg| leg.outer)
        else {
            return None;
        };
        let bars = [(first, number), (second, number + 1)];
        let bars = bars.map(|(pin, body)| HungBar { body, outer: self.host(pin) });
        for (leg, bar) in dyad.legs.iter().zip(bars) {
            leg.bodies.iter().for_each(|&body| self.of[body] = bar.body);
        }
        Some(PinnedDyad { bars, inner })
    }
}
