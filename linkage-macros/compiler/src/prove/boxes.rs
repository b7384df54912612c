//! A range, halved until the bounds of its boxes are near the best, or what they do not show is small.

use super::demand::Verdict;
use super::goal::{Goal, Unproved};
use super::one_box::OneBox;
use super::sloped::{INPUTS, InputBox};
use crate::ir::graph::Id;

/// A box of at most this factor above the largest bound at a point is not halved.
const NEAR: f64 = 1.1;

/// The boxes that a range is cut into before anything is known: of one input, and of several together.
const FIRST: [usize; 2] = [16, 64];

/// The limits of a search for bounds.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// The most boxes.
    pub boxes: usize,
    /// The smallest side of a box, as a share of its range.
    pub smallest: f64,
}

/// The bound of a result.
#[derive(Clone, Debug)]
pub struct ErrorBound {
    /// No error is larger, wherever it is proved.
    pub error: f64,
    /// No bound is smaller: the largest at a point.
    pub attained: f64,
    /// That point.
    pub at: Vec<f64>,
    /// The largest magnitude of the result at a corner of a box.
    pub largest: f64,
}

/// A box that is left.
pub(crate) type BoxSides = Vec<[f64; 2]>;

/// The proof over a range.
#[derive(Clone, Debug)]
pub struct Proof {
    /// By result, its bound, or why there is none.
    pub bounds: Vec<Result<ErrorBound, Unproved>>,
    /// Boxes in which a comparison of the fast path, or a bound, is not shown.
    pub open: Vec<BoxSides>,
    /// Boxes in which no pose has an answer.
    pub refused: Vec<BoxSides>,
    /// Boxes in which every bound holds.
    pub shown: Vec<BoxSides>,
    /// The boxes that were looked at.
    pub boxes: usize,
}

/// The results that are bounded, each once.
struct Attained {
    ids: Vec<Id>,
    bounds: Vec<ErrorBound>,
}

/// A box and its bounds, by result and column.
struct Examined {
    sides: BoxSides,
    frame: InputBox,
    bounds: Vec<Vec<f64>>,
    verdict: Verdict,
}

/// Where the fast path answers: boxes of the range are halved until they say so, or are small. No bound is looked for.
pub(crate) fn survey(subject: &Goal<'_>, effort: Budget) -> Proof {
    let mut proof =
        Proof { bounds: Vec::new(), open: vec![], refused: vec![], shown: vec![], boxes: 0 };
    let mut left = first(&subject.given.ranges);
    while let Some(sides) = left.pop() {
        proof.boxes += 1;
        let is_small = widest(&sides, &subject.given.ranges).1 <= effort.smallest;
        match OneBox::new(subject, InputBox::new(&sides)).verdict() {
            Verdict::Holds => proof.shown.push(sides),
            Verdict::Fails => proof.refused.push(sides),
            Verdict::Open if is_small || proof.boxes + left.len() >= effort.boxes => {
                proof.open.push(sides);
            }
            Verdict::Open => left.extend(halves(&sides, &subject.given.ranges)),
        }
    }
    proof
}

/// Bounds of all results over the range.
pub fn prove(subject: &Goal<'_>, effort: Budget) -> Proof {
    let reason = |id: Id| subject.unproved(id).or_else(|| subject.undemanded());
    let mut ids: Vec<Id> =
        subject.sinks.iter().copied().filter(|&id| reason(id).is_none()).collect();
    ids.sort();
    ids.dedup();
    let none = ErrorBound { error: 0.0, attained: 0.0, at: Vec::new(), largest: 0.0 };
    let bounds = vec![none; ids.len()];
    let mut results = Attained { ids, bounds };
    let mut proof =
        Proof { bounds: Vec::new(), open: vec![], refused: vec![], shown: vec![], boxes: 0 };
    let mut left = if results.ids.is_empty() { Vec::new() } else { first(&subject.given.ranges) };
    while !left.is_empty() {
        proof.boxes += left.len();
        let looked: Vec<Examined> =
            left.drain(..).map(|sides| look(subject, &results, sides)).collect();
        looked.iter().for_each(|one| results.attain(one));
        let is_last = proof.boxes + 2 * looked.len() > effort.boxes;
        for one in looked {
            let is_small = widest(&one.sides, &subject.given.ranges).1 <= effort.smallest;
            let is_near = one.verdict == Verdict::Holds && results.is_near(&one);
            if one.verdict == Verdict::Fails {
                proof.refused.push(one.sides);
            } else if !is_near && !is_small && !is_last {
                left.extend(halves(&one.sides, &subject.given.ranges));
            } else if one.verdict == Verdict::Holds && one.is_bounded() {
                results.keep(subject, &one);
                proof.shown.push(one.sides);
            } else {
                proof.open.push(one.sides);
            }
        }
    }
    proof.bounds = subject
        .sinks
        .iter()
        .map(|&id| match reason(id) {
            Some(why) => Err(why),
            None => {
                let at = results.ids.binary_search(&id).expect("every result is there");
                Ok(results.bounds[at].clone())
            }
        })
        .collect();
    proof
}

impl Attained {
    /// Raises what bounds are attained at corners of a box in which the fast path answers.
    fn attain(&mut self, one: &Examined) {
        if one.verdict != Verdict::Holds {
            return;
        }
        for (bound, columns) in self.bounds.iter_mut().zip(&one.bounds) {
            for (corner, &attained) in columns[1..].iter().enumerate() {
                if attained.is_finite() && (attained > bound.attained || bound.at.is_empty()) {
                    (bound.attained, bound.at) = (attained, one.frame.corner(corner));
                }
            }
        }
    }

    /// True if no bound of the box is far above what is attained.
    fn is_near(&self, one: &Examined) -> bool {
        let mut both = self.bounds.iter().zip(&one.bounds);
        both.all(|(bound, columns)| columns[0] <= NEAR * bound.attained)
    }

    fn keep(&mut self, subject: &Goal<'_>, one: &Examined) {
        // Values are looked at once more: most boxes are halved, and theirs are not kept.
        let values = OneBox::new(subject, one.frame);
        for ((bound, columns), &id) in self.bounds.iter_mut().zip(&one.bounds).zip(&self.ids) {
            bound.error = bound.error.max(columns[0]);
            let corners = 1..one.frame.columns();
            let at = |column: usize| values.column(id, column).magnitude();
            bound.largest = corners.map(at).fold(bound.largest, f64::max);
        }
    }
}

impl Examined {
    fn is_bounded(&self) -> bool {
        self.bounds.iter().all(|columns| columns[0].is_finite())
    }
}

fn look(subject: &Goal<'_>, results: &Attained, sides: BoxSides) -> Examined {
    let frame = InputBox::new(&sides);
    let values = OneBox::new(subject, frame);
    let verdict = values.verdict();
    // Adjoints are most of the work, and say nothing where the fast path does not answer.
    let bounds = match verdict {
        Verdict::Holds => results.ids.iter().map(|&id| values.bounds(id)).collect(),
        _ => Vec::new(),
    };
    Examined { sides, frame, bounds, verdict }
}

/// The range, cut into equal boxes.
pub(crate) fn first(ranges: &[[f64; 2]]) -> Vec<BoxSides> {
    assert!(ranges.len() <= INPUTS, "so many inputs are followed at once");
    let cuts = match ranges.len() {
        0 | 1 => FIRST[0],
        2 => (FIRST[1] as f64).sqrt() as usize,
        _ => (FIRST[1] as f64).cbrt().round() as usize,
    };
    ranges.iter().fold(vec![Vec::new()], |boxes, &[from, to]| {
        let end = |at: usize| match at {
            _ if at == cuts => to,
            _ => from + (to - from) * (at as f64 / cuts as f64),
        };
        let parts: Vec<[f64; 2]> = (0..cuts).map(|at| [end(at), end(at + 1)]).collect();
        let with = |sides: BoxSides| {
            parts.iter().map(move |&part| [&sides[..], &[part]].concat()).collect::<Vec<_>>()
        };
        boxes.into_iter().flat_map(with).collect()
    })
}

/// The side that is the largest share of its range, and this share.
pub(crate) fn widest(sides: &[[f64; 2]], ranges: &[[f64; 2]]) -> (usize, f64) {
    let share = |([low, high], [from, to]): (&[f64; 2], &[f64; 2])| (high - low) / (to - from);
    let shares = sides.iter().zip(ranges).map(share).enumerate();
    shares.fold((0, 0.0), |most, next| if next.1 > most.1 { next } else { most })
}

/// The box halved across its widest side.
pub(crate) fn halves(sides: &[[f64; 2]], ranges: &[[f64; 2]]) -> [BoxSides; 2] {
    let (side, _) = widest(sides, ranges);
    let [low, high] = sides[side];
    let middle = low + (high - low) / 2.0;
    [[low, middle], [middle, high]].map(|half| {
        let mut sides = sides.to_vec();
        sides[side] = half;
        sides
    })
}
