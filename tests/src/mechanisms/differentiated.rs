//! Every driver and every group, each declared twice: with its dimensions as parameters, on the
//! ground, and with every dimension an input, so that all of it moves.

use linkage_core::{Real, SolveError, mechanism};

use crate::conditioning::{Differentiated, Jacobians, Matrix, Range, Sensitivities, State};

/// Inputs as a solver takes them: one by itself, several as a list.
macro_rules! arranged {
    ($numbers:expr; $input:ident) => {
        $numbers[0]
    };
    ($numbers:expr; $($input:ident)+) => {
        core::array::from_fn::<_, { [$(stringify!($input)),+].len() }, _>(|i| $numbers[i])
    };
}

/// The solver with its mode, and its parameters in their order, from the state.
macro_rules! solver {
    ($name:ident, $at:ident, [$($param:ident)*], [$($mode:ident)?]) => {{
        #[allow(unused_mut, reason = "some have neither mode nor parameters")]
        let mut solver = $name::new().lift();
        #[allow(unused_mut, unused_variables, reason = "some have no parameters")]
        let mut params = $at.params.iter().copied();
        $(solver.$param = params.next().expect("as many as there are ranges");)*
        $(if $at.is_flipped {
            solver.$mode = solver.$mode.flipped();
        })?
        solver
    }};
}

/// Rows of a matrix of `nalgebra`.
macro_rules! rows {
    ($matrix:expr) => {
        $matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
    };
}

/// The functions and constants that the tests need of one declaration.
macro_rules! differentiated {
    ($name:ident, [$($input:ident)+], $params:tt, $mode:tt, $modes:expr, [$($range:expr),+]) => {
        impl Differentiated for $name {
            const NAME: &'static str = stringify!($name);
            const OUTPUTS: &'static [&'static str] = &$name::OUTPUTS;
            const RANGES: &'static [Range] = &[$($range),+];
            const INPUTS: usize = $name::INPUTS.len();
            const MODES: usize = $modes;

            fn position<T: Real>(at: &State<T>) -> Result<Vec<T>, SolveError> {
                let solver = solver!($name, at, $params, $mode);
                Ok(solver.position(arranged!(at.inputs; $($input)+))?.rows().to_vec())
            }

            fn motion<T: Real>(at: &State<T>) -> Result<[Vec<T>; 3], SolveError> {
                let motion = solver!($name, at, $params, $mode).motion(
                    arranged!(at.inputs; $($input)+),
                    arranged!(at.rates; $($input)+),
                    arranged!(at.seconds; $($input)+),
                )?;
                Ok([
                    motion.position.rows().to_vec(),
                    motion.velocity.rows().to_vec(),
                    motion.acceleration.rows().to_vec(),
                ])
            }

            fn coefficients<T: Real>(at: &State<T>) -> Result<Matrix<T>, SolveError> {
                let solver = solver!($name, at, $params, $mode);
                let slopes = solver.coefficients(arranged!(at.inputs; $($input)+))?;
                Ok(slopes.iter().map(|row| row.to_vec()).collect())
            }
        }

        jacobians!(f64, $name, [$($input)+], $params, $mode);
        jacobians!(f32, $name, [$($input)+], $params, $mode);
    };
}

macro_rules! jacobians {
    ($number:ty, $name:ident, [$($input:ident)+], $params:tt, $mode:tt) => {
        impl Jacobians<$number> for $name {
            fn jacobian(at: &State<$number>) -> Result<Matrix<$number>, SolveError> {
                let solver: $name<$number> = solver!($name, at, $params, $mode);
                Ok(rows!(solver.jacobian(arranged!(at.inputs; $($input)+))?))
            }
        }
    };
}

macro_rules! sensitive {
    ($number:ty, $name:ident, [$($input:ident)+], $params:tt, $mode:tt) => {
        impl Sensitivities<$number> for $name {
            fn sensitivity(at: &State<$number>) -> Result<Matrix<$number>, SolveError> {
                let solver: $name<$number> = solver!($name, at, $params, $mode);
                Ok(rows!(solver.sensitivity(arranged!(at.inputs; $($input)+))?))
            }
        }
    };
}

/// The two declarations that share their groups.
macro_rules! twins {
    (
        $fixed:ident, $moving:ident;
        inputs { $($input:ident: $measure:ident in $input_range:expr),+ }
        $(mode { $mode:ident: $default:ident })?
        lengths { $($length:ident in $length_range:expr),+ }
        angles { $($angle:ident in $angle_range:expr),+ }
        fixed { $($ground:tt)* }
        moving { $($carried:tt)* }
        $($shared:tt)+
    ) => {
        mechanism! {
            /// Dimensions are parameters.
            pub struct $fixed {
                $(input $input: $measure;)+
                $(param $mode: mode = $default;)?
                $(param $length = 1m;)+
                $(param $angle = 1rad;)+
                $($ground)*
                $($shared)+
            }
        }
        mechanism! {
            /// Dimensions are inputs.
            pub struct $moving {
                $(input $input: $measure;)+
                $(input $length: length;)+
                $(input $angle: angle;)+
                $(param $mode: mode = $default;)?
                $($carried)*
                $($shared)+
            }
        }
        differentiated!(
            $fixed, [$($input)+], [$($length)+ $($angle)+], [$($mode)?], modes!($($mode)?),
            [$($input_range,)+ $($length_range,)+ $($angle_range),+]
        );
        differentiated!(
            $moving, [$($input)+ $($length)+ $($angle)+], [], [$($mode)?], modes!($($mode)?),
            [$($input_range,)+ $($length_range,)+ $($angle_range),+]
        );
        sensitive!(f64, $fixed, [$($input)+], [$($length)+ $($angle)+], [$($mode)?]);
        sensitive!(f32, $fixed, [$($input)+], [$($length)+ $($angle)+], [$($mode)?]);
    };
}

macro_rules! modes {
    () => {
        1
    };
    ($mode:ident) => {
        2
    };
}

/// Half a turn either way.
const ANY_ANGLE: Range = (-3.140_625, 3.140_625);

twins! {
    Bars, MovingBars;
    inputs { theta: angle in ANY_ANGLE }
    mode { elbow: left }
    lengths {
        ax in (-0.5, 0.5), ay in (-0.5, 0.5), dx in (1.5, 3.0), dy in (-1.0, 1.0),
        r in (0.25, 1.0), l1 in (1.5, 3.0), l2 in (1.5, 3.0), px in (-1.0, 2.0), py in (-1.0, 1.0)
    }
    angles { phase in ANY_ANGLE }
    fixed { ground A(ax, ay), D(dx, dy); }
    moving {
        point A at (ax, ay);
        point D at (dx, dy);
    }
    crank AB(A) -> B        { length: r, angle: theta + phase }
    rrr   BC(B), DC(D) -> C { lengths: (l1, l2), mode: elbow }
    point P on BC at (px, py);
    output C, P, BC, DC;
}

twins! {
    Press, MovingPress;
    inputs { theta: angle in ANY_ANGLE }
    mode { side: ahead }
    lengths {
        kx in (-1.0, 1.0), ky in (-0.5, 0.5), r in (0.25, 1.0), l in (1.0, 3.0), e in (-0.5, 0.5),
        p in (0.5, 2.0)
    }
    angles { slope in ANY_ANGLE, beta in ANY_ANGLE }
    fixed {
        ground A(0.25m, -0.5m);
        guide rail through (kx, ky) along slope;
    }
    moving {
        ground A(0.25m, -0.5m);
        point K at (kx, ky);
        crank frame(K) { angle: slope }
        guide rail on frame through (0, 0) along 0deg;
    }
    crank AB(A) -> B              { length: r, angle: theta }
    rrp   BC(B), block(rail) -> C { length: l, offset: e, mode: side }
    point P on BC at polar (p, beta);
    output C, P, BC, block.slide;
}

twins! {
    QuickReturn, MovingQuickReturn;
    inputs { theta: angle in ANY_ANGLE }
    mode { side: ahead }
    lengths {
        dx in (-1.0, 1.0), dy in (-2.5, -0.5), r in (0.25, 1.5), e in (-0.75, 0.75),
        px in (1.0, 4.0), py in (-1.0, 1.0)
    }
    angles { phase in ANY_ANGLE }
    fixed { ground A(0.25m, -0.5m), D(dx, dy); }
    moving {
        ground A(0.25m, -0.5m);
        point D at (dx, dy);
    }
    crank AB(A) -> B       { length: r, angle: theta + phase }
    rpr   block(B), bar(D) { offset: e, mode: side }
    point P on bar at (px, py);
    output P, bar, block.slide;
}

twins! {
    CrossedGuides, MovingCrossedGuides;
    inputs { theta: angle in ANY_ANGLE }
    lengths {
        kx in (-2.0, 2.0), ky in (-2.0, 2.0), r in (0.25, 1.0), e1 in (-0.5, 0.5),
        e2 in (-0.5, 0.5)
    }
    angles { tilt in ANY_ANGLE, slope in ANY_ANGLE }
    fixed {
        ground A(0, 0);
        guide post through (kx, ky) along slope;
    }
    moving {
        ground A(0, 0);
        point K at (kx, ky);
        crank frame(K) { angle: slope }
        guide post on frame through (0, 0) along 0deg;
    }
    crank AB(A) -> B { length: r, angle: theta }
    guide arm on AB through B along tilt;
    prp   shoe(arm), block(post) -> C { offsets: (e1, e2) }
    output C, shoe.slide, block.slide;
}

twins! {
    Yoke, MovingYoke;
    inputs { theta: angle in ANY_ANGLE }
    lengths {
        kx in (-2.0, 2.0), ky in (-2.0, 2.0), r in (0.25, 1.0), e1 in (-0.5, 0.5),
        e2 in (-0.5, 0.5), px in (-1.0, 1.0), py in (-1.0, 1.0)
    }
    angles { slope in ANY_ANGLE, slot in (0.25, 2.75) }
    fixed {
        ground A(0, 0);
        guide rail through (kx, ky) along slope;
    }
    moving {
        ground A(0, 0);
        point K at (kx, ky);
        crank frame(K) { angle: slope }
        guide rail on frame through (0, 0) along 0deg;
    }
    crank AB(A) -> B           { length: r, angle: theta }
    rpp   block(B), yoke(rail) { slot: slot, offsets: (e1, e2) }
    point P on yoke at (px, py);
    output P, yoke.slide, block;
}

twins! {
    Manipulator, MovingManipulator;
    inputs { s: length in (-1.0, 1.0), phi: angle in ANY_ANGLE, z: length in (-1.0, 1.0) }
    lengths {
        kx in (-1.0, 1.0), ky in (-1.0, 1.0), e in (-0.5, 0.5), r in (0.25, 1.0),
        gx in (-0.5, 0.5), gy in (-0.5, 0.5), w in (-0.5, 0.5), l in (0.25, 1.0)
    }
    angles { slope in ANY_ANGLE, tilt in ANY_ANGLE, phase in ANY_ANGLE }
    fixed { guide bed through (kx, ky) along slope; }
    moving {
        point K at (kx, ky);
        crank frame(K) { angle: slope }
        guide bed on frame through (0, 0) along 0deg;
    }
    slider ram(bed) -> P { slide: s, offset: e }
    crank arm(P) -> Q    { length: r, relative_to: ram, angle: phi }
    guide groove on arm through (gx, gy) along tilt;
    slider quill(groove) -> R { slide: z, offset: w }
    crank wrist(R) -> T { length: l, relative_to: ram, angle: phase - 2 * arm.angle }
    output Q, R, T, wrist;
}
