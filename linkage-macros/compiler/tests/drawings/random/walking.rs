//! A walk of a machine about its drawing, by the truth alone.

use super::super::variants::Random;
use super::growing::{DRAWN_CONDITION, between};
use super::jet::Jet;
use super::truth::{Pose, Truth};

/// The motion that is followed in one step: some degrees, or some millimetres.
const STEP: [f64; 2] = [0.06, 0.01];
/// Next to a limit rounding hides what is compared.
const LARGEST_CONDITION: f64 = 3.0 * DRAWN_CONDITION;

/// The ends between which an input may go, about the drawing.
pub(super) type Reach = [f64; 2];

/// The way that inputs go where nothing else ends them: most of a quarter turn, and a part of a link's length.
pub(super) fn free_reach(is_angle: bool) -> Reach {
    if is_angle { [-1.2, 1.2] } else { [-0.15, 0.15] }
}

/// Poses that hang together with the drawing: one input or all of them go on and turn back at random.
pub(super) fn poses(
    truth: &Truth<'_>,
    random: &mut Random,
    reaches: &[Reach],
    one_at_a_time: bool,
    count: usize,
) -> Vec<Pose> {
    let Some(drawn) = truth.drawn() else { return Vec::new() };
    let middle: Vec<_> = drawn.inputs.iter().map(|input| input.0[0]).collect();
    let mut found = Vec::new();
    let (mut at, mut last) = (middle.clone(), drawn.clone());
    let mut ways: Vec<f64> = middle.iter().map(|_| between(random, [-1.0, 1.0])).collect();
    for nth in 0..3 * count {
        if found.len() == count {
            break;
        }
        if one_at_a_time && nth % 8 == 0 {
            (at, last) = (middle.clone(), drawn.clone());
            let moving = random.below(ways.len());
            ways.iter_mut().for_each(|way| *way = 0.0);
            ways[moving] = if random.below(2) == 0 { 1.0 } else { -1.0 };
        }
        let inputs: Vec<_> = (0..at.len())
            .map(|input| {
                let step = STEP[usize::from(!truth.drawing.inputs[input].is_angle)];
                let value = at[input] + step * ways[input] * between(random, [0.4, 1.0]);
                let rates = [(); 2].map(|()| between(random, [-2.0, 2.0]));
                Jet([value, rates[0], rates[1]])
            })
            .collect();
        let is_within = (0..at.len()).all(|input| {
            let [from, to] = reaches[input];
            (from..=to).contains(&(inputs[input].0[0] - middle[input]))
        });
        let near: Vec<_> = last.coordinates.iter().map(|part| part.0[0]).collect();
        let pose = if is_within { truth.pose(&inputs, &near) } else { None };
        let is_same = |pose: &Pose| {
            pose.condition() < LARGEST_CONDITION && pose.is_positive == drawn.is_positive
        };
        match pose.filter(is_same) {
            Some(pose) => {
                at = inputs.iter().map(|input| input.0[0]).collect();
                last = pose.clone();
                found.push(pose);
            }
            None => ways.iter_mut().for_each(|way| {
                *way = match one_at_a_time {
                    true => -*way,
                    false => between(random, [-1.0, 1.0]),
                }
            }),
        }
    }
    found
}
