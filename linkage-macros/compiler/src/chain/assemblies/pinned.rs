//! The pins and bodies of a group that one unknown and dyads of bars place, in the pose of the drawing.
//!
//! Bodies whose drives hold them together are one body there: each drive is at its drawn value. A place is numbered as its pin is.

use linkage_assemblies::{BodyPin, DYADS, HungBar, PinnedDyad, PinnedGroup, STANDING, TURNED};

use crate::chain::cutting::{Dyad, Found, Pair, SearchedGroup};
use crate::chain::machine::Machine;

/// The group of a search; `None` where it has a slide, or a dyad carries links between its bars.
pub fn pinned(machine: &Machine, search: &SearchedGroup) -> Option<PinnedGroup> {
    let mut numbers = BodyNumbers { machine, of: vec![STANDING; machine.bodies.len()] };
    let (first, others) = search.steps.split_first()?;
    let Found::Crank { drive: None, body, pivot, .. } = first else { return None };
    numbers.of[*body] = TURNED;
    let (mut dyads, mut count) = ([None; DYADS], 0);
    for step in others {
        match step {
            Found::Dyad(dyad) => {
                *dyads.get_mut(count)? = Some(numbers.dyad(dyad, TURNED + 1 + 2 * count)?);
                count += 1;
            }
            Found::Crank { drive: Some(_), body, reference, .. } => {
                numbers.of[*body] = numbers.of[*reference];
            }
            Found::Crank { .. } | Found::Slider { .. } | Found::Search(_) | Found::Tracked(_) => {
                return None;
            }
        }
    }
    let [Pair::Pin(first), Pair::Pin(second)] = search.joints else { return None };
    let equation = [first, second].map(|pin| numbers.host(pin));
    Some(PinnedGroup { pivot: [*pivot; 2], dyads, equation })
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
        BodyPin { body: own.unwrap_or(STANDING), place: pin }
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
        let bars =
            bars.map(|(pin, body)| HungBar { body, outer: self.host(pin), ends: [pin, inner] });
        for (leg, bar) in dyad.legs.iter().zip(bars) {
            leg.bodies.iter().for_each(|&body| self.of[body] = bar.body);
        }
        Some(PinnedDyad { bars })
    }
}
