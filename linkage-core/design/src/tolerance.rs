//! Tolerances of dimensions and play of joints, and the output that comes of them.

use core::fmt;

use linkage_core::SolveError;

use crate::random::Random;
use crate::reactions::Reactions;

/// A dimension or a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Contribution {
    /// The name.
    pub name: String,
    /// The output by the dimension; of play the greatest over all directions.
    pub sensitivity: f64,
    /// The greatest deviation of the dimension to either side; of play the radius that the pin has.
    pub tolerance: f64,
    /// True for play.
    pub is_play: bool,
}

impl Contribution {
    /// The greatest deviation of the output.
    #[must_use]
    pub fn worst(&self) -> f64 {
        (self.sensitivity * self.tolerance).abs()
    }

    /// The variance of the output. A dimension is uniform within its tolerance, t²/3; a pin lies at its
    /// hole's wall, in any direction, r²/2.
    #[must_use]
    pub fn variance(&self) -> f64 {
        self.worst().powi(2) / if self.is_play { 2.0 } else { 3.0 }
    }
}

/// Tolerances at a pose, to first order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tolerance {
    contributions: Vec<Contribution>,
    margin: Option<f64>,
}

impl Tolerance {
    /// No tolerances.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// A dimension with the output's sensitivity to it, within ± a tolerance.
    #[must_use]
    pub fn dimension(mut self, name: &str, sensitivity: f64, tolerance: f64) -> Self {
        let name = name.to_owned();
        self.contributions.push(Contribution { name, sensitivity, tolerance, is_play: false });
        self
    }

    /// Play in one pin: the diameters of hole and pin differ by so much.
    #[must_use]
    pub fn play(mut self, name: &str, sensitivity: f64, diameters: f64) -> Self {
        let (name, tolerance) = (name.to_owned(), 0.5 * diameters);
        self.contributions.push(Contribution { name, sensitivity, tolerance, is_play: true });
        self
    }

    /// The same play in every pin.
    #[must_use]
    pub fn play_in_pins(self, reactions: &Reactions, diameters: f64) -> Self {
        reactions
            .pins()
            .into_iter()
            .fold(self, |all, (name, sensitivity)| all.play(&name, sensitivity, diameters))
    }

    /// The smallest margin of a group, by which the first order is judged.
    #[must_use]
    pub fn margin(mut self, margin: f64) -> Self {
        self.margin = Some(margin);
        self
    }

    /// The contributions, the largest share of the variance first.
    #[must_use]
    pub fn contributions(&self) -> Vec<&Contribution> {
        let mut sorted: Vec<&Contribution> = self.contributions.iter().collect();
        sorted.sort_by(|a, b| b.variance().total_cmp(&a.variance()));
        sorted
    }

    /// The greatest deviation of the output, all dimensions at their worst.
    #[must_use]
    pub fn worst(&self) -> f64 {
        self.contributions.iter().map(Contribution::worst).sum()
    }

    /// The standard deviation of the output: the root of the sum of squares.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.contributions.iter().map(Contribution::variance).sum::<f64>().sqrt()
    }

    /// The second order against the first, in the worst case next to a limit: T/(4·margin), where T is the sum
    /// of the tolerances. The output goes there with √margin, whose second derivative is 1/(2·margin) of the
    /// first. None without a margin.
    #[must_use]
    pub fn second_over_first(&self) -> Option<f64> {
        let sum: f64 = self.contributions.iter().map(|of| of.tolerance).sum();
        self.margin.map(|margin| sum / (4.0 * margin))
    }

    /// True while the margin is five times the sum of the tolerances, or is not given: below that the worst
    /// case is some 5 % low and more, and then poses are refused.
    #[must_use]
    pub fn is_trusted(&self) -> bool {
        // Out of reach the ratio is negative.
        self.second_over_first().is_none_or(|ratio| (0.0..=0.05).contains(&ratio))
    }

    /// The output's deviations by random machines and the solver as it is. The function is given the deviation
    /// of each dimension, and the shift of each pin, both in the order in which they were named, and gives the
    /// output's deviation.
    #[must_use]
    pub fn drawn(
        &self,
        count: usize,
        seed: u64,
        mut output: impl FnMut(&[f64], &[[f64; 2]]) -> Result<f64, SolveError>,
    ) -> Drawn {
        let mut random = Random::of(seed, 0);
        let (mut found, mut refused) = (Vec::with_capacity(count), 0);
        let (mut dimensions, mut pins) = (Vec::new(), Vec::new());
        for _ in 0..count {
            dimensions.clear();
            pins.clear();
            for Contribution { tolerance, is_play, .. } in &self.contributions {
                let uniform = random.uniform();
                if *is_play {
                    let (sin, cos) = (uniform * core::f64::consts::TAU).sin_cos();
                    pins.push([tolerance * cos, tolerance * sin]);
                } else {
                    dimensions.push(tolerance * (2.0 * uniform - 1.0));
                }
            }
            match output(&dimensions, &pins) {
                Ok(deviation) => found.push(deviation),
                Err(_) => refused += 1,
            }
        }
        Drawn::of(found, refused)
    }

    /// The pose of some inputs at which the worst case is greatest, with its tolerances; none without inputs.
    ///
    /// # Errors
    /// Those of a pose.
    pub fn worst_over<E>(
        inputs: impl IntoIterator<Item = f64>,
        at: impl Fn(f64) -> Result<Self, E>,
    ) -> Result<Option<(f64, Self)>, E> {
        let mut worst: Option<(f64, Self)> = None;
        for input in inputs {
            let here = at(input)?;
            if worst.as_ref().is_none_or(|worst| here.worst() > worst.1.worst()) {
                worst = Some((input, here));
            }
        }
        Ok(worst)
    }
}

impl fmt::Display for Tolerance {
    /// A table by share, in SI units.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let variance = self.deviation().powi(2);
        let width = self.contributions.iter().map(|of| of.name.len()).max().unwrap_or(0).max(9);
        writeln!(f, "{:width$}  sensitivity   tolerance       worst  share", "dimension")?;
        for of in self.contributions() {
            let share = 100.0 * of.variance() / variance;
            writeln!(
                f,
                "{:width$}  {:11.4}  {:10.3e}  {:10.3e}  {share:3.0} %",
                of.name,
                of.sensitivity,
                of.tolerance,
                of.worst()
            )?;
        }
        writeln!(
            f,
            "worst case {:.3e}, standard deviation {:.3e}",
            self.worst(),
            self.deviation()
        )?;
        match self.second_over_first() {
            Some(ratio) if !self.is_trusted() => writeln!(
                f,
                "near a limit: the second order is {ratio:.2} of the first; draw, or widen the margin"
            ),
            _ => Ok(()),
        }
    }
}

/// Deviations of an output over many random machines.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// The mean.
    pub mean: f64,
    /// The standard deviation.
    pub deviation: f64,
    /// The number of machines that could not be assembled.
    pub refused: usize,
    /// The sizes in rising order.
    sizes: Vec<f64>,
}

impl Drawn {
    fn of(found: Vec<f64>, refused: usize) -> Self {
        let count = found.len() as f64;
        let mean = found.iter().sum::<f64>() / count;
        let variance = found.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / count;
        let mut sizes: Vec<f64> = found.iter().map(|x| x.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        Self { mean, deviation: variance.sqrt(), refused, sizes }
    }

    /// The size of the deviation that a share of the machines does not exceed: 0.9973, or 1 for all of those
    /// that were drawn.
    #[must_use]
    pub fn within(&self, share: f64) -> f64 {
        let last = self.sizes.len().saturating_sub(1);
        let at = (share.clamp(0.0, 1.0) * last as f64).round() as usize;
        self.sizes.get(at).copied().unwrap_or(f64::NAN)
    }
}
