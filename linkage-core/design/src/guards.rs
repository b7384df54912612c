//! Conditions over a whole range of the input: kept at samples, then confirmed between them.

use linkage_core::SolveError;
use linkage_core::Solver;
use linkage_core::num_dual::Derivative;
use linkage_core::range::{Stretches, extrema, limits};

use crate::design::Design;
use crate::rows::{Block, Dual};
use crate::verdict::{Broken, Guard};

/// Samples of a range: sixteen a turn and one more.
fn samples([from, to]: [f64; 2]) -> Vec<f64> {
    let count = ((to - from).abs() * 16.0 / core::f64::consts::TAU).ceil().clamp(4.0, 256.0);
    (0..=count as usize).map(|k| from + (to - from) * k as f64 / count).collect()
}

/// The clearance of each group against its scale: negative where the group cannot be assembled. A group
/// behind such a one has none, and is given the number of the one before.
pub(crate) fn clearances<M, const N: usize>(machine: &M, input: f64, to: &mut Vec<Dual<N>>)
where
    M: Solver<Scalar = Dual<N>, Input = Dual<N>>,
{
    let told = machine.told(
        |parameter| parameter,
        |_| Dual::from_re(input),
        |[value, scale]: [Dual<N>; 2]| value / scale,
    );
    let mut last = Dual::from_re(-1.0);
    for &clearance in told.as_ref() {
        let is_number = crate::rows::finite(&[clearance]).is_ok();
        last = if is_number { clearance } else { last };
        to.push(last);
    }
}

/// A clearance that a machine keeps at the samples, against its scale.
const ROOM: f64 = 1e-6;

impl<'a, M: 'a, F: 'a, const N: usize> Design<'a, M, F, N> {
    /// A number that stays above a limit over a range of the input: at samples, and confirmed between them by
    /// [`extrema`], which adds the places where it does not. For a transmission angle of 40° compare its sine
    /// with `40f64.to_radians().sin()`.
    pub fn at_least(
        self,
        name: &str,
        least: f64,
        between: [f64; 2],
        number: impl Fn(&M, Dual<N>) -> Result<Dual<N>, SolveError> + Clone + Send + Sync + 'a,
    ) -> Self {
        let asked = number.clone();
        let block = Block::sampled(name, samples(between), 1, move |machine, input, to| {
            to.push(asked(machine, Dual::from_re(input))? - least);
            Ok(())
        });
        let broken = move |_: &F, plain: &M| {
            let lowest = extrema(between, |input| rates(|input| number(plain, input), input))?;
            // The searches keep to the limit within their own digits.
            let is_kept = lowest.least()[1] >= least - 1e-7 * least.abs().max(1e-3);
            let below = lowest.iter().filter(|at| at.value < least).map(|at| at.at);
            let ends = [lowest.least()[0]];
            Ok(if is_kept { Vec::new() } else { rising(below.chain(ends)) })
        };
        self.guarded(block, Box::new(broken))
    }

    fn guarded(self, block: Block<'a, M, N>, broken: Broken<'a, M, F>) -> Self {
        let (keep, mut design) = self.kept(block);
        design.guards.push(Guard { keep, broken });
        design
    }
}

/// A number with its first and second derivative by the input. The first is exact, in the place of that by
/// the first parameter; the second, which only guides a search, is its central difference.
fn rates<const N: usize>(
    number: impl Fn(Dual<N>) -> Result<Dual<N>, SolveError>,
    input: f64,
) -> Result<[f64; 3], SolveError> {
    let at = |input: f64| {
        let number = number(Dual::from_re(input).derivative(0))?;
        let slope = match number.eps {
            Derivative(Some(slopes)) => slopes[0],
            _ => 0.0,
        };
        Ok([number.re, slope])
    };
    // The difference errs by h² of a third derivative and by ε/h: 10⁻¹⁰ at the most.
    let h = 1e-5;
    let [value, slope] = at(input)?;
    let curvature = match (at(input + h), at(input - h)) {
        (Ok(after), Ok(before)) => (after[1] - before[1]) / (2.0 * h),
        (Ok(after), Err(_)) => (after[1] - slope) / h,
        (Err(_), Ok(before)) => (slope - before[1]) / h,
        (Err(error), Err(_)) => return Err(error),
    };
    Ok([value, slope, curvature])
}

fn rising(inputs: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut inputs: Vec<f64> = inputs.collect();
    inputs.sort_by(f64::total_cmp);
    inputs.dedup();
    inputs
}

impl<'a, M, F, const N: usize> Design<'a, M, F, N>
where
    M: Solver<Scalar = Dual<N>, Input = Dual<N>> + 'a,
    F: Solver<Scalar = f64, Input = f64> + 'a,
{
    /// The machine can be assembled over a range of the input: at samples, and confirmed between them by
    /// [`limits`], which adds the places where it cannot. Starts that cannot are mended.
    pub fn turns(self, between: [f64; 2]) -> Self {
        let at = samples(between);
        let block =
            Block::sampled("turns", at.clone(), M::TITLES.groups.len(), |machine, input, to| {
                let before = to.len();
                clearances(machine, input, to);
                to[before..].iter_mut().for_each(|clearance| *clearance -= ROOM);
                Ok(())
            });
        let broken = move |found: &F, _: &M| Ok(gaps(&limits(found, between)?, between));
        self.mended(at).guarded(block, Box::new(broken))
    }

    /// Starts that cannot be assembled at these inputs are mended: the slopes of the groups' clearances lead to
    /// a machine that can.
    pub fn mended(mut self, at: impl IntoIterator<Item = f64>) -> Self {
        let at: Vec<f64> = at.into_iter().collect();
        self.reaches(move |machine, to| {
            at.iter().for_each(|&input| clearances(machine, input, to));
        });
        self
    }
}

/// The middles of what stretches leave out of a range, and the change points between them.
fn gaps(stretches: &Stretches, [from, to]: [f64; 2]) -> Vec<f64> {
    if stretches.is_whole() {
        return Vec::new();
    }
    let ends = stretches.iter().flat_map(|stretch| [stretch.from, stretch.to]);
    let at: Vec<f64> = ends.filter(|end| !end.is_edge()).map(|end| end.at).collect();
    let mut places = vec![from];
    places.extend(stretches.iter().flat_map(|stretch| [stretch.from.at, stretch.to.at]));
    places.push(to);
    let middles = places.chunks(2).filter(|gap| gap[1] > gap[0]).map(|gap| 0.5 * (gap[0] + gap[1]));
    rising(middles.chain(at))
}
