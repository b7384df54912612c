//! Efforts, reactions and friction by the multipliers of all equations at once.

use super::acting::{Acting, Friction};
use super::acting_sum::Sum;
use super::jet::Jet;
use super::truth::{Equation, Pose, Truth};

/// All that is exerted in a moment.
#[derive(Clone, Debug)]
pub(super) struct Efforts {
    /// The multiplier of each equation.
    pub multipliers: Vec<f64>,
    pub inputs: Vec<f64>,
    pub springs: Vec<f64>,
    /// The effort of each stop, and the way to its nearer end.
    pub stops: Vec<[f64; 2]>,
    /// The effort of each friction: the couple on the first link at a pin, the force along a slide.
    pub frictions: Vec<f64>,
    pub losses: f64,
    /// Kinetic and potential energy.
    pub energy: [f64; 2],
    pub mass: f64,
    /// The largest of all forces.
    pub largest: f64,
    /// The factor of friction in an error: one over one less its largest share.
    pub magnified: f64,
}

/// The frictions, and all multipliers with them.
struct Rubbed {
    frictions: Vec<f64>,
    multipliers: Vec<f64>,
    /// The largest part of a change of friction that friction makes of it.
    share: f64,
}

impl Truth<'_> {
    /// The two links that turn on each other at a pin; the ground is none.
    pub(super) fn rubbing_links(&self, pin: usize) -> [Option<usize>; 2] {
        let links = self.drawing.bodies_at(pin);
        [links.first().copied(), links.get(1).copied()]
    }

    /// The multiplier of an equation that a link keeps.
    pub(super) fn multiplier(&self, all: &[f64], is_it: impl Fn(&Equation) -> bool) -> Option<f64> {
        self.equations.iter().position(is_it).map(|row| all[row])
    }

    /// The force that presses where a friction is.
    fn pressed(&self, friction: &Friction, all: &[f64]) -> f64 {
        let of = |is_it: &dyn Fn(&Equation) -> bool| {
            self.multiplier(all, is_it).expect("the joint has an equation")
        };
        match *friction {
            Friction::Pin { pin, coefficient, radius } => {
                let [x, y] = [0, 1].map(|of_axis| {
                    let first = self.rubbing_links(pin)[0].expect("a link turns on it");
                    of(&|equation| matches!(*equation, Equation::Pin { link, pin: at, axis } if (link, at, axis) == (first, pin, of_axis)))
                });
                coefficient * radius * x.hypot(y)
            }
            Friction::Guide { link: on, coefficient, length } => {
                let normal = of(
                    &|equation| matches!(*equation, Equation::Beside { link, .. } if link == on),
                );
                let couple = of(
                    &|equation| matches!(*equation, Equation::Parallel { link, .. } if link == on),
                );
                let by_couple = length.map_or(0.0, |length| 2.0 * couple.abs() / length);
                coefficient * normal.abs().max(by_couple)
            }
        }
    }

    /// All efforts in a moment; `None` where friction may hold itself, or something slips too slowly to say which way.
    pub(super) fn efforts(&self, acting: &Acting, pose: &Pose, loads: &[f64]) -> Option<Efforts> {
        let moment = self.moment(&pose.inputs, &pose.coordinates);
        let mut sum = Sum { truth: self, moment, along: vec![0.0; pose.jacobian.count] };
        let masses: Vec<_> =
            acting.masses.iter().map(|mass| sum.mass(mass, acting.gravity)).collect();
        acting.forces.iter().for_each(|load| sum.load(load, loads));
        let springs: Vec<_> = acting.springs.iter().map(|spring| sum.spring(spring)).collect();
        let stops: Vec<_> = acting.stops.iter().map(|stop| sum.stop(stop)).collect();
        let slips: Vec<_> = acting.frictions.iter().map(|friction| sum.slip(friction)).collect();
        let Rubbed { frictions, multipliers, share } =
            self.rubbed(acting, pose, &mut sum, &slips)?;
        let inputs: Vec<_> =
            (0..pose.inputs.len()).map(|input| self.effort(pose, &multipliers, input)).collect();
        let largest = multipliers.iter().chain(&sum.along).chain(&inputs);
        let largest = largest.fold(1.0_f64, |largest, part| largest.max(part.abs()));
        let total = |part: usize| masses.iter().map(|mass| mass[part]).sum::<f64>();
        let elastic =
            springs.iter().map(|spring| spring[1]).chain(stops.iter().map(|stop| stop[2]));
        Some(Efforts {
            inputs,
            losses: -frictions.iter().zip(&slips).map(|(force, slip)| force * slip).sum::<f64>(),
            springs: springs.iter().map(|spring| spring[0]).collect(),
            stops: stops.iter().map(|stop| [stop[0], stop[1]]).collect(),
            frictions,
            energy: [total(1), total(2) + elastic.sum::<f64>()],
            mass: total(0),
            largest,
            magnified: 1.0 / (1.0 - share),
            multipliers,
        })
    }

    /// The frictions and the multipliers that make each other, by repeated substitution.
    fn rubbed(
        &self,
        acting: &Acting,
        pose: &Pose,
        sum: &mut Sum<'_>,
        slips: &[f64],
    ) -> Option<Rubbed> {
        // Below this a slip's sign may be rounding.
        const SLOWEST: f64 = 1e-3;
        if slips.iter().any(|slip| slip.abs() < SLOWEST) {
            return None;
        }
        let frictionless = sum.along.clone();
        let solved = |along: &[f64]| -> Vec<f64> {
            pose.inverse.transposed_times(along).into_iter().map(|part| -part).collect()
        };
        let (mut multipliers, mut frictions) = (solved(&sum.along), vec![0.0; slips.len()]);
        let (mut last, mut share) = (f64::MAX, 0.0_f64);
        // A share of 0.7 is below the rounding of forces of some hundred newtons after these.
        for _ in 0..120 {
            let now: Vec<f64> = (acting.frictions.iter().zip(slips))
                .map(|(friction, slip)| -slip.signum() * self.pressed(friction, &multipliers))
                .collect();
            let changes = now.iter().zip(&frictions).map(|(a, b)| (a - b).abs());
            let change = changes.fold(0.0, f64::max);
            frictions = now;
            sum.along.clone_from(&frictionless);
            for (friction, size) in acting.frictions.iter().zip(&frictions) {
                sum.rubbing(friction, *size);
            }
            multipliers = solved(&sum.along);
            if change < 1e-12 {
                break;
            }
            // The first substitution has no friction before it.
            if change > 1e-9 && last < f64::MAX {
                share = share.max(change / last);
            }
            last = change;
        }
        (share < 0.7).then_some(Rubbed { frictions, multipliers, share })
    }

    /// The effort of an input: the power of all multipliers while it alone moves, at one unit a second.
    fn effort(&self, pose: &Pose, multipliers: &[f64], input: usize) -> f64 {
        let still = |all: &[Jet]| all.iter().map(|part| Jet::still(part.0[0])).collect::<Vec<_>>();
        let (mut inputs, coordinates) = (still(&pose.inputs), still(&pose.coordinates));
        inputs[input].0[1] = 1.0;
        let slopes = self.opened(&inputs, &coordinates, 1);
        -slopes.iter().zip(multipliers).map(|(slope, multiplier)| slope * multiplier).sum::<f64>()
    }
}
