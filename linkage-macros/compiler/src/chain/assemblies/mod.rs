//! All ways to assemble a group of class III in the pose of its drawing, proved.
//!
//! | part | |
//! |---|---|
//! | [`pinned`] | the pins and bodies of a group with one unknown |
//! | [`closure`] | its equation over any numbers |
//! | [`tower`], [`degree`] | the equation over residues of a prime: how many ways there are at most |
//! | [`disc`], [`drawn_group`] | the equation with its roundings, of all modes at once and of one |
//! | [`chebyshev`], [`circle`] | the zeros of a polynomial around the circle |
//!
//! An assembly is a zero of the closure's product over all modes. Where dyads do not assemble the product is that of a closure and its
//! conjugate, whose zeros are double: a zero at which it changes its sign is an assembly.

mod chebyshev;
mod circle;
mod closure;
mod degree;
mod disc;
mod drawn_group;
mod pinned;
mod tower;

use circle::{CircleOrigin, zeros};
use degree::ClosureDegree;
use drawn_group::{DrawnGroup, DyadSides};
use pinned::PinnedGroup;

use super::assembly_list::{Assemblies, ListedAssembly, OtherAssembly, Outcome};
use super::cutting::{Found, Pair, SearchedGroup};
use super::machine::Machine;
use super::plane::Complex;

/// The most pieces of the circle that are looked at.
const BUDGET: usize = 4000;
/// Tangents of half the angles from which the circle is divided. The second is for an assembly that lies where the first divides.
const ORIGINS: [f64; 2] = [0.187_5, 0.343_75];
/// The widths of angles within which the mode of a zero is looked for.
const WIDTHS: [f64; 4] = [1e-12, 1e-11, 1e-10, 1e-9];
/// The count of ways to solve a group by which its assemblies are listed at most, where the first does not prove them.
const CUTS: usize = 4;

/// The list of the first option that proves it: its count is that of any other.
pub(super) fn by_another(machine: &Machine, options: &[SearchedGroup]) -> Option<Assemblies> {
    let mut lists = options.iter().filter_map(|search| assemblies(machine, search)).take(CUTS);
    let proved = lists.find(Assemblies::is_proved)?;
    Some(Assemblies { is_by_another: true, ..proved })
}

/// The nearest assembly beside the drawing, by the first way to solve the group that proves all of them.
pub(super) fn nearest_other(machine: &Machine, options: &[SearchedGroup]) -> Option<OtherAssembly> {
    let lists = options.iter().filter_map(|search| Some((search, assemblies(machine, search)?)));
    let (search, list) = lists.take(CUTS).find(|(_, list)| list.is_proved())?;
    let Found::Crank { body, .. } = search.steps[0] else { return None };
    Some(OtherAssembly { body, turned: list.nearest_other()? })
}

/// The ways to assemble the group of a search; `None` where it has slides, links of given angle in its dyads, or no degree.
pub(super) fn assemblies(machine: &Machine, search: &SearchedGroup) -> Option<Assemblies> {
    let group = PinnedGroup::of(machine, search)?;
    let degree = degree::degree(&group)?;
    of_degree(machine, search, (&group, &degree))
}

/// The list of a group whose powers are known.
fn of_degree(
    machine: &Machine,
    search: &SearchedGroup,
    (group, degree): (&PinnedGroup, &ClosureDegree),
) -> Option<Assemblies> {
    let [Pair::Pin(first), Pair::Pin(second)] = search.joints else { return None };
    // A power of two, by which places are divided without rounding.
    let unit = machine.size().log2().round().exp2();
    let pins: Vec<Complex> = machine.pins.iter().map(|pin| pin.times(1.0 / unit)).collect();
    let left_out = [first, second].map(|pin| pins[pin]);
    let drawn = DrawnGroup { group, degree, pins: &pins, left_out };
    let mut lists = ORIGINS.iter().map(|&tangent| drawn.assemblies(CircleOrigin { tangent }));
    let first = lists.next()?;
    match first.outcome {
        Outcome::Open { .. } => lists.find(Assemblies::is_proved).or(Some(first)),
        Outcome::Proved | Outcome::OutOfBudget => Some(first),
    }
}

impl DrawnGroup<'_> {
    fn assemblies(&self, origin: CircleOrigin) -> Assemblies {
        let (mut list, mut unplaced) = (Vec::new(), None);
        let found = |ends: [f64; 2]| match self.assembly(ends) {
            Some(assembly) => list.push(assembly),
            None => unplaced = unplaced.or(Some(ends)),
        };
        let outcome = zeros(self, (self.degree.half, origin), BUDGET, found);
        let outcome = match (outcome, unplaced) {
            (Outcome::Proved, Some([from, to])) => Outcome::Open { from, to },
            _ => outcome,
        };
        list.sort_by(|a, b| a.unknown.total_cmp(&b.unknown));
        let sides = self.drawn();
        let is_drawn = |one: &ListedAssembly| one.unknown == 0.0 && one.sides == sides;
        let drawn = list.iter().position(is_drawn);
        Assemblies { at_most: 2 * self.degree.half, outcome, list, drawn, is_by_another: false }
    }

    /// The assembly at a zero of the product: the only mode whose equation changes its sign there.
    fn assembly(&self, [from, to]: [f64; 2]) -> Option<ListedAssembly> {
        WIDTHS.iter().find_map(|width| {
            let ends = [from - width, to + width];
            let mut changing = (0..self.modes()).filter_map(|sides| {
                let [low, high] = ends.map(|end| self.missed(end, sides));
                let (low, high) = low.zip(high)?;
                ((low > 0.0) != (high > 0.0)).then_some((sides, high > 0.0))
            });
            let (sides, rises) = changing.next()?;
            // A drawing closes exactly, whatever the last places of its equation say.
            let is_drawn = sides == self.drawn() && ends[0] < 0.0 && 0.0 < ends[1];
            let unknown = || if is_drawn { 0.0 } else { self.root(ends, sides, rises) };
            changing.next().is_none().then(|| ListedAssembly { unknown: unknown(), sides, rises })
        })
    }

    /// The place at which the equation of a mode changes its sign, by halving.
    fn root(&self, [mut low, mut high]: [f64; 2], sides: DyadSides, rises: bool) -> f64 {
        loop {
            let middle = (low + high) / 2.0;
            if !(low < middle && middle < high) {
                return middle;
            }
            let is_above = self.missed(middle, sides).is_some_and(|missed| missed > 0.0) == rises;
            match is_above {
                true => high = middle,
                false => low = middle,
            }
        }
    }
}

#[cfg(test)]
mod tests;
