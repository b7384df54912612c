//! Where of a range the fast path answers, and where it ends.

use crate::prove::boxes::{Budget, survey};
use crate::prove::demand::{Demand, Verdict};
use crate::prove::goal::Goal;
use crate::prove::one_box::OneBox;
use crate::prove::premises::Premises;
use crate::prove::sloped::InputBox;

/// Stretches of one range.
pub(super) struct Stretches {
    /// Over which the fast path answers.
    pub shown: Vec<[f64; 2]>,
    /// In which it may not, though there may be poses.
    pub open: Vec<[f64; 2]>,
}

const BUDGET: Budget = Budget { boxes: 4096, smallest: 1.0 / 65_536.0 };

impl Stretches {
    pub(super) fn of(subject: &Goal<'_>) -> Self {
        let found = survey(subject, BUDGET);
        let joined = |boxes: &[Vec<[f64; 2]>]| {
            let mut sides: Vec<[f64; 2]> = boxes.iter().map(|sides| sides[0]).collect();
            sides.sort_by(|a, b| a[0].total_cmp(&b[0]));
            let mut joined: Vec<[f64; 2]> = Vec::new();
            for [from, to] in sides {
                match joined.last_mut() {
                    Some(last) if last[1] == from => last[1] = to,
                    _ => joined.push([from, to]),
                }
            }
            joined
        };
        Self { shown: joined(&found.shown), open: joined(&found.open) }
    }
}

/// Where next to `inside` the fast path stops answering, on the way to `outside`, as far as rounding tells.
pub(super) fn limit(subject: &Goal<'_>, [mut inside, mut outside]: [f64; 2]) -> f64 {
    for _ in 0..64 {
        let middle = inside + (outside - inside) / 2.0;
        if middle == inside || middle == outside {
            break;
        }
        match verdict(subject, middle) {
            Verdict::Holds => inside = middle,
            Verdict::Fails | Verdict::Open => outside = middle,
        }
    }
    inside
}

fn verdict(subject: &Goal<'_>, at: f64) -> Verdict {
    OneBox::new(subject, InputBox::new(&[[at, at]])).verdict()
}

/// The group whose comparison does not hold there.
pub(super) fn failing(subject: &Goal<'_>, at: f64) -> Option<u32> {
    let values = OneBox::new(subject, InputBox::new(&[[at, at]]));
    let of = |id| values.range(id);
    subject.demands.iter().find_map(|demand| match demand {
        Demand::Compare { group, .. } if demand.verdict(subject.width, &of) != Verdict::Holds => {
            Some(*group)
        }
        _ => None,
    })
}

/// The same over a part of the one range.
pub(super) fn over(given: &Premises, part: [f64; 2]) -> Premises {
    Premises { ranges: vec![part], ..given.clone() }
}
