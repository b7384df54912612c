//! The bounds of an entry point's results, in both widths.

use super::near_limits::{Near, subjects};
use super::sensitivity::{ProvedBoxes, Sensitive};
use super::stretches::{Stretches, over};
use super::{
    Asked, BoundReport, EntryReport, RangeReport, ResultReport, comparisons, costs, transmission,
};
use crate::interface::EntryId;
use crate::interface::components::Component;
use crate::interface::dimensions::of_result;
use crate::interface::entries::{ArgumentKind, Entry, Topic};
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::ir::graph::Id;
use crate::ir::program::Program;
use crate::lower::routine::Lowered;
use crate::model::mechanism::{Dimension, Mechanism};
use crate::prove::boxes::{Budget, Proof, prove};
use crate::prove::goal::{Goal, Unproved};
use crate::prove::outward::OutwardInterval;
use crate::prove::premises::Premises;

/// An entry point that is proved.
pub(super) struct Proved<'a> {
    pub mechanism: &'a Mechanism,
    pub program: &'a Program,
    pub lowered: &'a Lowered<'a>,
    pub asked: &'a Asked,
    pub id: EntryId,
}

/// The effort over one range: a four-bar takes 64 boxes, Jansen's leg 600.
const ONE: Budget = Budget { boxes: 4096, smallest: 1.0 / 32_768.0 };
const SEVERAL: Budget = Budget { boxes: 6000, smallest: 1.0 / 64.0 };

/// The share of a range next to a limit for which bounds are told by their distance alone.
const NEXT_TO_A_LIMIT: f64 = 0.01;

/// The proofs of one part of the range: double and single precision, with the inputs' rates and with their second
/// rates.
struct ProvedPart {
    by_rates: [Proof; 2],
    by_seconds: Option<[Proof; 2]>,
}

impl Proved<'_> {
    pub(super) fn report(&self, sensitive: Option<&Sensitive>) -> EntryReport {
        let sinks = comparisons::sinks(self.lowered, self.id);
        let demands = comparisons::demands(self.lowered, self.id);
        let (by_rates, by_seconds) = self.given();
        let graph = &self.program.graph;
        let whole = subjects(graph, (sinks, &demands), &by_rates);
        let (stretches, parts) = self.parts(&whole[1]);
        let of_part = |ranges: &Vec<[f64; 2]>| {
            let run = |given: &Premises, effort| {
                let given = Premises { ranges: ranges.clone(), ..given.clone() };
                let of = (sinks, &demands[..]);
                subjects(graph, of, &given).each_ref().map(|subject| prove(subject, effort))
            };
            let effort = if ranges.len() == 1 { ONE } else { SEVERAL };
            let by_seconds = by_seconds.as_ref().map(|given| run(given, effort));
            ProvedPart { by_rates: run(&by_rates, effort), by_seconds }
        };
        let proved: Vec<ProvedPart> = parts.iter().map(of_part).collect();
        let near = Near { subjects: whole.each_ref(), sinks, groups: &self.program.groups };
        let limits = match (&stretches, &by_rates.ranges[..]) {
            (Some(stretches), [range]) => near.limits(stretches, *range),
            _ => Vec::new(),
        };
        let boxes = proved.iter().flat_map(|part| part.by_rates[0].shown.clone());
        let looked = ProvedBoxes { given: &by_rates, boxes: boxes.collect() };
        let share = share(&proved, &by_rates.ranges);
        let covers = |stretches: &Stretches| stretches.shown[..] == by_rates.ranges[..];
        let is_straight = match &stretches {
            Some(stretches) => whole[1].undemanded().is_none() && covers(stretches),
            None => share == 1.0,
        };
        EntryReport {
            name: self.entry().point.name().to_string(),
            ranges: self.ranges(),
            given: self.asked.words.clone(),
            results: self.results(&whole, &proved, sensitive, &looked),
            comparisons: demands.len(),
            is_straight,
            stretches: parts
                .iter()
                .filter(|ranges| ranges.len() == 1)
                .map(|ranges| ranges[0])
                .collect(),
            open: stretches.map_or_else(Vec::new, |stretches| stretches.open),
            share,
            limits,
            transmissions: transmission::transmissions(self.lowered, self.id, &looked),
            largest_rate: comparisons::largest_rate(self.lowered, self.id),
            operations: costs::operations(self.lowered, self.id),
            beside: costs::beside(self.mechanism, self.lowered, self.id),
        }
    }

    pub(super) fn entry(&self) -> &Entry {
        self.lowered.interface.entry(self.id)
    }

    fn ranges(&self) -> Vec<RangeReport> {
        let names = self.asked.ranges.iter().zip(&self.asked.given.ranges);
        let range = |((name, unit), &ends): (&(String, String), &[f64; 2])| RangeReport {
            name: name.clone(),
            unit: unit.clone(),
            ends,
        };
        names.map(range).collect()
    }

    /// The premises with the inputs' rates, and with their accelerations where bounds are multiples of both.
    fn given(&self) -> (Premises, Option<Premises>) {
        let columns = self.mechanism.inputs.len();
        let none = vec![OutwardInterval::ZERO; columns];
        let is_kinematic = self.entry().point.row().topic == Topic::Kinematics;
        if !is_kinematic || self.asked.rates.is_some() {
            let rates = self.asked.rates.clone().unwrap_or_else(|| vec![0.0; columns]);
            let rates: Vec<_> = rates.into_iter().map(OutwardInterval::point).collect();
            return (self.asked.at_rates(&rates, &none, false), None);
        }
        // Several have all rates up to the same size.
        let one = match columns {
            1 => OutwardInterval::point(1.0),
            _ => OutwardInterval::between(-1.0, 1.0),
        };
        let ones = vec![one; columns];
        let reads = self.entry().given.contains(&ArgumentKind::Acceleration);
        let by_seconds = reads.then(|| self.asked.at_rates(&none, &ones, true));
        (self.asked.at_rates(&ones, &none, true), by_seconds)
    }

    /// The stretches of one range over which the fast path answers; and the parts over which bounds are proved.
    fn parts(&self, single: &Goal<'_>) -> (Option<Stretches>, Vec<Vec<[f64; 2]>>) {
        let ranges = &single.given.ranges;
        let [range] = ranges[..] else { return (None, vec![ranges.clone()]) };
        // Results that cannot be proved say so by themselves.
        if single.undemanded().is_some() {
            return (None, Vec::new());
        }
        let stretches = Stretches::of(single);
        let margin = (range[1] - range[0]) * NEXT_TO_A_LIMIT;
        let away = |&[low, high]: &[f64; 2]| {
            let low = if low > range[0] { low + margin } else { low };
            let high = if high < range[1] { high - margin } else { high };
            (low < high).then(|| over(single.given, [low, high]).ranges)
        };
        let parts = stretches.shown.iter().filter_map(away).collect();
        (Some(stretches), parts)
    }

    fn results(
        &self,
        whole: &[Goal<'_>; 2],
        proved: &[ProvedPart],
        sensitive: Option<&Sensitive>,
        looked: &ProvedBoxes<'_>,
    ) -> Vec<ResultReport> {
        let sinks = whole[0].sinks;
        let interface = &self.lowered.interface;
        let names = interface.components(self.entry().result);
        let measures = self.measures(sinks.len());
        let sensitivities = sensitive.map(|of| of.at(self.entry().point, looked));
        let scales = whole[0].given.scales_with_rates;
        let result = |(at, &sink): (usize, &Id)| {
            let (dimension, order) = measures[at];
            let why = whole[1].unproved(sink).or_else(|| whole[1].undemanded());
            let bounds = match why {
                Some(why) => Err(self.in_words(why)),
                None if proved.is_empty() => {
                    Err("no pose of the range is shown to have an answer".to_string())
                }
                None => bounds(at, proved, order),
            };
            ResultReport {
                name: self.name(&names[at]),
                unit: unit(dimension, order),
                rates: if scales { order as u32 } else { 0 },
                bounds,
                sensitivities: sensitivities.as_ref().map_or_else(Vec::new, |of| of[at].clone()),
            }
        };
        sinks.iter().enumerate().map(result).collect()
    }

    fn name(&self, way: &[Component]) -> String {
        let step = |step: &Component| match step {
            Component::Field(name) => format!(".{name}"),
            Component::Index(at) => format!("[{at}]"),
        };
        let steps: String = way.iter().map(step).collect();
        match steps.strip_prefix('.') {
            Some(name) => name.to_string(),
            None => format!("{}{steps}", self.entry().point.name()),
        }
    }

    /// Dimension and order of each number.
    fn measures(&self, count: usize) -> Vec<(Dimension, Order)> {
        let known = of_result(&self.lowered.interface, self.mechanism, self.entry());
        if known.len() == count {
            return known;
        }
        let inputs = self.mechanism.inputs.iter();
        if self.entry().point.is_about_dynamics() {
            return inputs.map(|input| (input.dimension, Order::Acceleration)).collect();
        }
        vec![(Dimension::NUMBER, Order::Position); count]
    }

    fn in_words(&self, why: Unproved) -> String {
        match why {
            Unproved::Function(function) => {
                format!("the library's `{}` has no stated error", function.name())
            }
            Unproved::SolvedAmount => "amounts of friction are solved at run time".to_string(),
            Unproved::Unknown(unknown) => {
                let name = &self.mechanism.unknowns[unknown as usize].name;
                format!("a search finds the unknown `{name}`")
            }
            Unproved::Together(group) => {
                let links = &self.program.groups[group as usize];
                format!("steps of Newton's method find the unknowns of {links} together")
            }
        }
    }
}

/// The bound of a result in both widths, the largest of all parts.
fn bounds(at: usize, proved: &[ProvedPart], order: Order) -> Result<[BoundReport; 2], String> {
    let of_width = |width: usize| {
        let mut all = BoundReport {
            largest: 0.0,
            within: 0.0,
            attained: 0.0,
            with_acceleration: 0.0,
            at: Vec::new(),
        };
        for part in proved {
            let proof = &part.by_rates[width];
            let bound = proof.bounds[at].as_ref().expect("it has no reason not to be proved");
            all.largest = all.largest.max(bound.largest);
            all.within = all.within.max(bound.error);
            if bound.attained > all.attained || all.at.is_empty() {
                (all.attained, all.at) = (bound.attained, bound.at.clone());
            }
            if let (Order::Acceleration, Some(proofs)) = (order, &part.by_seconds) {
                let second = proofs[width].bounds[at].as_ref().expect("nor here");
                all.with_acceleration = all.with_acceleration.max(second.error);
            }
        }
        all
    };
    let is_shown = |width: usize| proved.iter().any(|part| !part.by_rates[width].shown.is_empty());
    match [0, 1].into_iter().all(is_shown) {
        true => Ok([0, 1].map(of_width)),
        false => Err("the fast path is shown to answer nowhere in the range".to_string()),
    }
}

/// The share of the ranges over which every bound holds, in the width in which it is less.
fn share(proved: &[ProvedPart], ranges: &[[f64; 2]]) -> f64 {
    let volume = |sides: &[[f64; 2]]| -> f64 { sides.iter().map(|[from, to]| to - from).product() };
    let of_width = |width: usize| {
        let proofs = proved.iter().map(|part| &part.by_rates[width]);
        let shown: f64 = proofs.flat_map(|proof| &proof.shown).map(|sides| volume(sides)).sum();
        shown / volume(ranges)
    };
    let share = of_width(0).min(of_width(1));
    // A sum of all boxes is the whole but for rounding; the smallest box is far above that.
    if share > 1.0 - 1e-9 { 1.0 } else { share }
}
