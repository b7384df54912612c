//! All ways to assemble a group of class III in the pose of its drawing, proved.
//!
//! | part | |
//! |---|---|
//! | [`pinned`] | the pins and bodies of a group with one unknown |
//! | [`tower`], [`degree`] | its equation over residues of a prime: how many ways there are at most |
//!
//! The crate `linkage-assemblies` has the equation, and lists its zeros.

pub mod degree;
pub mod pinned;
pub mod tower;

use linkage_assemblies::{
    Assembly, Budget, ClosureDegree, List, MOST_DEGREE, PinnedDyad, PinnedGroup, Placed,
};

use super::assembly_list::{Assemblies, ListedAssembly, OtherAssembly};
use super::cutting::{Found, Pair, SearchedGroup};
use super::machine::Machine;

/// The most that is spent on a list: every piece has its samples.
pub const BUDGET: Budget = Budget { samples: 61 * 4000, pieces: 4000 };
/// The count of ways to solve a group by which its assemblies are listed at most, where the first does not prove them.
pub const CUTS: usize = 4;

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
pub fn assemblies(machine: &Machine, search: &SearchedGroup) -> Option<Assemblies> {
    let group = pinned::pinned(machine, search)?;
    let degree = degree::degree(&group)?;
    of_degree(machine, search, (&group, &degree))
}

/// The list of a group whose powers are known.
fn of_degree(
    machine: &Machine,
    search: &SearchedGroup,
    kind: (&PinnedGroup, &ClosureDegree),
) -> Option<Assemblies> {
    Some(as_drawn(machine, kind, &listed(machine, search, kind)?))
}

/// The list, its unknowns counted from the drawing.
pub fn listed(
    machine: &Machine,
    search: &SearchedGroup,
    (group, degree): (&PinnedGroup, &ClosureDegree),
) -> Option<List<{ 2 * MOST_DEGREE }>> {
    let [Pair::Pin(first), Pair::Pin(second)] = search.joints else { return None };
    let places: Vec<[f64; 2]> = machine.pins.iter().map(|pin| [pin.x, pin.y]).collect();
    let left_out = machine.pins[second] - machine.pins[first];
    let placed = Placed::new(group, degree, (&places, [left_out.x, left_out.y]))?;
    Some(placed.assemblies(BUDGET))
}

/// The list with its unknowns counted from the drawing, and the drawing found in it.
pub fn as_drawn(
    machine: &Machine,
    (group, degree): (&PinnedGroup, &ClosureDegree),
    listed: &List<{ 2 * MOST_DEGREE }>,
) -> Assemblies {
    let sides = drawn_sides(machine, group);
    // A drawing closes exactly, whatever the last places of its equation say.
    let is_drawn = |one: &Assembly| {
        let [from, to] = one.between;
        one.sides == sides && from < 0.0 && 0.0 < to
    };
    let list = listed.iter().map(|one| ListedAssembly {
        unknown: if is_drawn(one) { 0.0 } else { one.unknown },
        sides: one.sides,
        rises: one.rises,
    });
    Assemblies {
        at_most: 2 * degree.half,
        outcome: listed.outcome,
        list: list.collect(),
        drawn: listed.iter().position(is_drawn),
        is_by_another: false,
    }
}

/// The sides on which the dyads are drawn, as bits.
fn drawn_sides(machine: &Machine, group: &PinnedGroup) -> usize {
    let side = |(index, dyad): (usize, &PinnedDyad)| {
        let [from, to] = dyad.bars.map(|bar| machine.pins[bar.outer.place]);
        let [_, inner] = dyad.bars[0].ends;
        let is_left = (to - from).cross(machine.pins[inner] - from) > 0.0;
        usize::from(is_left) << index
    };
    group.dyads().map(side).sum()
}
