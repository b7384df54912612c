//! All numbers of one call, and how they are drawn.

use linkage_core::SolveError;

use super::numbers::{Number, Source};

/// Parameters, inputs, rates and accelerations, and whether the modes are the declared ones.
#[derive(Clone, Copy, Debug)]
pub(crate) struct State<T, const N: usize, const P: usize> {
    pub(crate) params: [T; P],
    pub(crate) q: [T; N],
    pub(crate) rate: [T; N],
    pub(crate) second: [T; N],
    pub(crate) flipped: bool,
}

impl<T: Copy, const N: usize, const P: usize> State<T, N, P> {
    pub(crate) const COUNT: usize = 3 * N + P;

    /// Every number with its place.
    pub(crate) fn map<U>(&self, mut f: impl FnMut(usize, T) -> U) -> State<U, N, P> {
        State {
            params: core::array::from_fn(|i| f(i, self.params[i])),
            q: core::array::from_fn(|i| f(P + i, self.q[i])),
            rate: core::array::from_fn(|i| f(P + N + i, self.rate[i])),
            second: core::array::from_fn(|i| f(P + 2 * N + i, self.second[i])),
            flipped: self.flipped,
        }
    }

    fn with(&self, place: usize, number: T) -> Self {
        self.map(|at, old| if at == place { number } else { old })
    }

    fn get(&self, place: usize) -> Option<T> {
        let all = [&self.params[..], &self.q, &self.rate, &self.second];
        all.into_iter().flatten().nth(place).copied()
    }
}

/// Which numbers are odd ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// None: dimensions as declared or a quarter longer or shorter, inputs within a turn.
    Sane,
    /// The same with one number that is.
    OneOdd,
    AllOdd,
    /// Inputs and dimensions as declared, rates of any class.
    OddRates,
    /// Within six steps of where a group falls out of reach.
    AtLimit,
}

const KINDS: [Kind; 8] = [
    Kind::Sane,
    Kind::Sane,
    Kind::OneOdd,
    Kind::AllOdd,
    Kind::OddRates,
    Kind::AtLimit,
    Kind::AtLimit,
    Kind::AtLimit,
];

/// The numbers that somebody might mean.
fn sane<T: Number, const N: usize, const P: usize>(
    source: &mut Source,
    defaults: &[f64; P],
) -> State<T, N, P> {
    let exactly = source.below(3) == 0;
    let mut near = |value: f64| {
        let share = if exactly { 1.0 } else { source.between(0.75, 1.25) };
        T::near(share * value)
    };
    let params = defaults.map(&mut near);
    // Lengths that drive are about as long as most dimensions are.
    let mut any =
        |size: f64| -> [T; N] { core::array::from_fn(|_| T::near(source.between(-size, size))) };
    let (q, rate, second) = (any(3.5), any(3.0), any(5.0));
    State { params, q, rate, second, flipped: source.below(2) == 0 }
}

/// A state of some kind; `position` answers whether it can be solved.
pub(crate) fn any<T: Number, const N: usize, const P: usize>(
    source: &mut Source,
    defaults: &[f64; P],
    position: impl Fn(&State<T, N, P>) -> Result<(), SolveError>,
) -> (Kind, State<T, N, P>) {
    let kind = KINDS[source.below(KINDS.len())];
    let state = sane(source, defaults);
    match kind {
        Kind::Sane => (kind, state),
        Kind::OneOdd => {
            let place = source.below(State::<T, N, P>::COUNT);
            (kind, state.with(place, source.odd()))
        }
        Kind::AllOdd => (kind, state.map(|_, _| source.odd())),
        Kind::OddRates => {
            (kind, state.map(|at, number| if at < P + N { number } else { source.odd() }))
        }
        Kind::AtLimit => match at_limit(source, defaults, &state, position) {
            Some(state) => (kind, state),
            None => (Kind::Sane, state),
        },
    }
}

/// Halves the way along one number from a pose that is solved to one out of reach, until no number
/// lies between, and goes up to six steps back or on.
fn at_limit<T: Number, const N: usize, const P: usize>(
    source: &mut Source,
    defaults: &[f64; P],
    state: &State<T, N, P>,
    position: impl Fn(&State<T, N, P>) -> Result<(), SolveError>,
) -> Option<State<T, N, P>> {
    position(state).ok()?;
    let out_of_reach = |state: &State<T, N, P>| {
        let found = position(state);
        matches!(found, Err(SolveError::OutOfReach { .. } | SolveError::NoSolution { .. }))
    };
    let (place, beyond) = (0..8).find_map(|_| {
        let place = source.below(P + N);
        let other: State<T, N, P> = sane(source, defaults);
        let factor = T::near([1.0, 2.0, 0.5, 3.0][source.below(4)]);
        let number = other.get(place)? * factor;
        out_of_reach(&state.with(place, number)).then_some((place, number))
    })?;
    let (mut inside, mut outside) = (state.get(place)?.rank(), beyond.rank());
    while inside.abs_diff(outside) > 1 {
        let middle = ((i128::from(inside) + i128::from(outside)) / 2) as i64;
        if position(&state.with(place, T::of_rank(middle))).is_ok() {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    let steps = source.below(13) as i64 - 6;
    Some(state.with(place, T::of_rank(inside + steps)))
}
