//! The mechanisms, each declared once with constant dimensions and once with its dimensions as parameters,
//! behind functions of lists.

use linkage_core::{Real, SolveError, mechanism};
use linkage_tests::conditioning::State;
use linkage_tests::double_double::DoubleDouble;
use num_dual::Dual64;

/// The two ways to declare dimensions, in the order of [`Twin::double`]: their formulas differ.
pub(crate) const WAYS: [&str; 2] = ["constant", "tunable"];

/// Rows of the positions, then of the velocities, then of the accelerations.
pub(crate) type Answer<T> = Result<Vec<T>, SolveError>;

/// A solver with the dimensions of the declaration.
#[derive(Clone, Copy)]
pub(crate) struct Way<T> {
    pub(crate) motion: fn([&[T]; 3]) -> Answer<T>,
    pub(crate) position: fn(&[T]) -> Result<(), SolveError>,
}

pub(crate) struct Twin {
    pub(crate) name: &'static str,
    pub(crate) group: &'static str,
    /// The range of a length; an angle has none.
    pub(crate) inputs: &'static [Option<[f64; 2]>],
    pub(crate) params: &'static [f64],
    /// The names of the rows of the positions.
    pub(crate) labels: &'static [&'static str],
    pub(crate) double: [Way<f64>; WAYS.len()],
    pub(crate) single: [Way<f32>; WAYS.len()],
    /// With the dimensions of the state: all rows, or not finite ones.
    pub(crate) truth: fn(&State<DoubleDouble>) -> Vec<DoubleDouble>,
    pub(crate) dual: fn(&State<Dual64>) -> Answer<Dual64>,
}

macro_rules! input_kind {
    (angle) => {
        None
    };
    (length between $low:literal $high:literal) => {
        Some([$low, $high])
    };
}

/// One input is given as itself, several as a list.
macro_rules! given {
    ([$one:ident], $list:expr) => {
        $list[0]
    };
    ([$($several:ident)+], $list:expr) => {
        <[_; 0 $(+ { let _ = stringify!($several); 1 })+]>::try_from($list).expect("as many inputs")
    };
}

macro_rules! rows {
    ($motion:expr) => {{
        let m = $motion;
        [&m.position.rows()[..], &m.velocity.rows()[..], &m.acceleration.rows()[..]].concat()
    }};
}

macro_rules! twin {
    ($name:ident, $group:literal,
     [$($input:ident: $kind:ident $(between $low:literal $high:literal)?),*],
     [$(($param:ident = $($value:tt)+))*], { $($statements:tt)* }) => {
        #[allow(clippy::excessive_precision, reason = "the digits are all of the number's")]
        mod $name {
            use super::*;

            mechanism! { struct Constant {
                $(input $input: $kind;)* $(let $param = $($value)+;)* $($statements)*
            } }
            mechanism! { struct Tunable {
                $(input $input: $kind;)* $(param $param = $($value)+;)* $($statements)*
            } }

            fn tuned<T: linkage_core::Scalar>(params: &[T]) -> Tunable<T> {
                let [$($param),*] = params.try_into().expect("as many parameters");
                Tunable { $($param),* }
            }

            pub(super) const TWIN: Twin = Twin {
                name: stringify!($name),
                group: $group,
                inputs: &[$(input_kind!($kind $(between $low $high)?)),*],
                params: &[$($($value)+),*],
                labels: &Tunable::OUTPUTS,
                double: [way!(Constant [$($input)*]), way!(Tunable [$($input)*])],
                single: [way!(Constant [$($input)*]), way!(Tunable [$($input)*])],
                truth: |at| {
                    let [q, rate, second] = [&at.inputs[..], &at.rates, &at.seconds];
                    let solver = tuned(&at.params);
                    let (motion, _) = solver.solve_motion(
                        given!([$($input)*], q),
                        given!([$($input)*], rate),
                        given!([$($input)*], second),
                    );
                    rows!(motion)
                },
                dual: |at| {
                    let [q, rate, second] = [&at.inputs[..], &at.rates, &at.seconds];
                    let solver = tuned(&at.params);
                    Ok(rows!(solver.motion(
                        given!([$($input)*], q),
                        given!([$($input)*], rate),
                        given!([$($input)*], second),
                    )?))
                },
            };
        }
    };
}

macro_rules! way {
    ($solver:ident $inputs:tt) => {
        Way {
            motion: |[q, rate, second]| {
                Ok(rows!($solver::default().motion(
                    given!($inputs, q),
                    given!($inputs, rate),
                    given!($inputs, second),
                )?))
            },
            position: |q| $solver::default().position(given!($inputs, q)).map(|_| ()),
        }
    };
}

/// Gathers all of them.
macro_rules! twins {
    ($($name:ident)*) => {
        pub(crate) fn all() -> Vec<Twin> {
            vec![$($name::TWIN),*]
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/twins.rs"));

/// The answers of every way in one width, as numbers that hold them exactly.
pub(crate) fn answers<T: Real, const N: usize>(
    ways: &[Way<T>; N],
    lists: [&[f64]; 3],
) -> ([Answer<f64>; N], [Result<(), SolveError>; N]) {
    let lists = lists.map(|list| list.iter().map(|&x| T::num(x)).collect::<Vec<_>>());
    let [q, rate, second] = &lists;
    let motions = ways.each_ref().map(|way| {
        let rows = (way.motion)([q, rate, second])?;
        Ok(rows.iter().map(|row| row.value()).collect())
    });
    (motions, ways.each_ref().map(|way| (way.position)(q)))
}
