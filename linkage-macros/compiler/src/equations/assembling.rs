//! The numbers by which the assemblies of a group of pins are listed: its lengths, and the places of what it hangs on.
//!
//! It is a program of its own with a graph of its own, like that of a drawing. The unknown is zero in it, and the body that it
//! turns stands as the rest of its angle says.

use linkage_assemblies::{BodyPin, DYADS, HungBar, PinnedDyad, PinnedGroup, STANDING, TURNED};

use crate::equations::jet::Jet;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::symbol::{GraphBuilder, Sym};
use crate::ir::construct::Rule;
use crate::ir::program::{EntryOutputs, Program};
use crate::model::any_assembly::Unlisted;
use crate::model::mechanism::{
    AngleSum, Assembly, Carrier, Drive, Equation, Group, LinkId, Mechanism, Operator, PointId,
    Scalar, Step, UnknownId,
};
use crate::syntax::anatomy::Class;

/// A group of pins that the first unknown solves.
pub(crate) struct PinnedProgram {
    /// One answer: the length of the link that was left out, then x and y of place after place.
    pub program: Program,
    pub group: PinnedGroup,
}

/// The program of the group of the first unknown.
pub(crate) fn derive(mechanism: &Mechanism, rules: &[Rule]) -> Result<PinnedProgram, Unlisted> {
    let unknown = mechanism.unknowns.first().ok_or(Unlisted::NoUnknown)?;
    let builder = GraphBuilder::new(rules);
    let inputs = InputMotion::at_rest(&InputMotion::free(mechanism, &builder), &builder);
    let mut known = Kinematics::before(&builder, mechanism, inputs.clone());
    let [first, last] = unknown.steps;
    known.take_until(first);
    known.name_lets();
    let at = Kinematics::of_trial(inputs, &known, UnknownId(0), Jet::zero(&builder), false);
    let mut pinning = Pinning { known: &known, at: &at, links: Vec::new(), places: Vec::new() };
    let Equation::Distance { points, length, .. } = &unknown.equation else {
        return Err(Unlisted::OtherEquation);
    };
    let mut pivot = None;
    let (mut dyads, mut count) = ([None; DYADS], 0);
    for step in &mechanism.steps[first..last] {
        match step {
            Step::Group(group) if group.kind == Class::Crank && pivot.is_none() => {
                pivot = Some(pinning.crank(group)?);
            }
            Step::Group(group) if group.is_of_bars() && pivot.is_some() => {
                let free = dyads.get_mut(count).ok_or(Unlisted::OtherGroup)?;
                *free = Some(pinning.dyad(group)?);
                count += 1;
            }
            Step::Group(_) => return Err(Unlisted::OtherGroup),
            Step::Ground { .. } | Step::Guide { .. } | Step::Point { .. } => {}
        }
    }
    let pivot = pivot.ok_or(Unlisted::NoCrank)?;
    let [one, other] = points.map(|point| pinning.host(point));
    let group = PinnedGroup { pivot, dyads, equation: [one?, other?] };
    let length = at.length(length, unknown.group.0).value;
    let places = pinning.places.iter().flatten();
    let sinks = [length.id].into_iter().chain(places.map(|number| number.id)).collect();
    let answers = vec![EntryOutputs { entry: None, sinks }];
    let (clearances, closures, groups) = (Vec::new(), Vec::new(), mechanism.titles());
    drop((known, at));
    let graph = builder.into_graph();
    Ok(PinnedProgram { program: Program { graph, answers, clearances, closures, groups }, group })
}

/// A group whose links are numbered one after the other.
struct Pinning<'k, 's> {
    /// All that stands in front of the unknown.
    known: &'k Kinematics<'s>,
    /// All up to the equation, at an unknown of zero.
    at: &'k Kinematics<'s>,
    /// The links with their bodies' numbers.
    links: Vec<(LinkId, usize)>,
    places: Vec<[Sym<'s>; 2]>,
}

impl<'s> Pinning<'_, 's> {
    fn put(&mut self, place: [Sym<'s>; 2]) -> usize {
        self.places.push(place);
        self.places.len() - 1
    }

    /// The crank that the unknown turns: the places of its pivot.
    fn crank(&mut self, group: &Group) -> Result<[usize; 2], Unlisted> {
        let Some(Drive::Angle { angle, relative_to }) = &group.outer[0].drive else {
            return Err(Unlisted::NoCrank);
        };
        let pivot = group.stands_on(0);
        let stands = |link: LinkId| self.known.links[link.index()].is_some();
        let is_on_what_stands = match relative_to {
            Carrier::Ground => true,
            Carrier::Link(link) => stands(*link),
        };
        let AngleSum { links, rest } = angle;
        let follows = self.is_added(rest) && links.iter().all(|&(link, _)| stands(link));
        if !(follows && is_on_what_stands) {
            return Err(Unlisted::NoCrank);
        }
        let BodyPin { place: standing, .. } = self.host(pivot)?;
        self.links.push((group.links[0], TURNED));
        let zero = self.at.builder.zero();
        Ok([standing, self.put([zero, zero])])
    }

    /// True if the unknown is a term of the sum, once, and nothing else of it.
    fn is_added(&self, sum: &Scalar) -> bool {
        match sum {
            Scalar::Unknown(UnknownId(0)) => true,
            Scalar::Chain(first, rest) => {
                let rest = rest.iter().map(|(operator, term)| (*operator, term));
                let mut terms = [(Operator::Add, &**first)].into_iter().chain(rest);
                let is_sum = terms
                    .clone()
                    .all(|(operator, _)| matches!(operator, Operator::Add | Operator::Sub));
                let mut with = terms.by_ref().filter(|(_, term)| !self.known.is_known(term));
                let only = with.next().filter(|_| with.next().is_none());
                is_sum && matches!(only, Some((Operator::Add, term)) if self.is_added(term))
            }
            _ => false,
        }
    }

    fn dyad(&mut self, group: &Group) -> Result<PinnedDyad, Unlisted> {
        if !matches!(group.assembly, Assembly::Signed(_)) {
            return Err(Unlisted::OtherGroup);
        }
        let number = self.links.len() + TURNED;
        let outer = [0, 1].map(|bar| self.host(group.stands_on(bar)));
        let [first, second] = outer;
        let outer = [first?, second?];
        let zero = self.at.builder.zero();
        let bars = [0, 1].map(|bar| {
            let length = self.at.length(group.length(bar), group.id.0).value;
            let ends = [self.put([zero, zero]), self.put([length, zero])];
            HungBar { body: number + bar, outer: outer[bar], ends }
        });
        self.links.extend([0, 1].map(|bar| (group.links[bar], number + bar)));
        Ok(PinnedDyad { bars })
    }

    /// A point: on a link of the group if it is on one, else where it stands.
    fn host(&mut self, point: PointId) -> Result<BodyPin, Unlisted> {
        let on_link = self.links.iter().find_map(|&(link, body)| {
            let place = self.at.coordinates.get(&(Carrier::Link(link), point))?;
            Some((link, body, place.map(|part| part.value)))
        });
        let (body, place) = match on_link {
            Some((link, TURNED, [x, y])) => {
                let turned = self.at.link(link).frame.vector(x, y);
                (TURNED, [turned.x, turned.y])
            }
            Some((_, body, place)) => (body, place),
            None => {
                let stands = self.known.points[point.index()].ok_or(Unlisted::OtherPoint)?;
                let at = stands.position();
                (STANDING, [at.x, at.y])
            }
        };
        Ok(BodyPin { body, place: self.put(place) })
    }
}
