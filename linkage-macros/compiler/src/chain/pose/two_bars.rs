//! Two bars between pins, with the links of given angle that they carry.

use super::{HeldBodies, PoseChanges, Posed};
use crate::chain::cutting::{Carried, Dyad};
use crate::chain::limits::sine;
use crate::chain::plane::{Complex, Displaced};

impl Posed<'_> {
    /// Two bars from the first and the last of these pins, and the links between them.
    pub(super) fn two_bars(
        &mut self,
        dyad: &Dyad,
        held: [Option<HeldBodies>; 2],
        given: &PoseChanges,
        [u, v, w]: [usize; 3],
    ) -> Option<()> {
        let [a, b] = dyad.legs.each_ref().map(|leg| leg.bodies[0]);
        let outer = [(a, u), (b, w)].map(|(body, pin)| self.place(body, pin, given));
        let [first, second] = dyad.tips(v);
        let tips = [(a, held[0], first), (b, held[1], second)]
            .map(|(body, held, pin)| self.tip(body, held, pin, given));
        let carried = self.carried(dyad, given)?;
        let way = carried.iter().fold(Complex::new(0.0, 0.0), |sum, (_, way)| sum + *way);
        let ends = [self.pin(u, given)?, self.pin(w, given)? - way];
        let sign = sine(self.machine, dyad).signum();
        self.between_two_pins([a, b], ends, [outer, tips], sign)?;
        held.into_iter().for_each(|held| self.follow(held, given));
        if let Some(of) = &mut self.of[b] {
            of.shift = of.shift + way;
        }
        self.place_carried(dyad, given, &carried)
    }

    /// By link that the bars of a dyad carry, how it is turned from the drawing, and the vector from its first pin on
    /// the way to its second.
    fn carried(&self, dyad: &Dyad, given: &PoseChanges) -> Option<Vec<(Complex, Complex)>> {
        let turned = |carried: &Carried| {
            let changes = carried.drives.iter().map(|&[drive, body]| (Some(drive), body));
            let changes = changes.map(|(drive, body)| self.change(drive, body, given, 0.0));
            let turn = self.of[carried.reference]?.turn * Complex::turned(changes.sum());
            let [from, to] = carried.pins.map(|pin| self.place(carried.body, pin, given));
            Some((turn, turn * (to - from)))
        };
        dyad.carried.iter().map(turned).collect()
    }

    /// Places them behind the first bar.
    fn place_carried(
        &mut self,
        dyad: &Dyad,
        given: &PoseChanges,
        turned: &[(Complex, Complex)],
    ) -> Option<()> {
        for (carried, (turn, _)) in dyad.carried.iter().zip(turned) {
            let [from, _] = carried.pins;
            let (drawn, at) = (self.place(carried.body, from, given), self.pin(from, given)?);
            self.of[carried.body] = Some(Displaced::taking(drawn, at, *turn));
        }
        Some(())
    }
}
