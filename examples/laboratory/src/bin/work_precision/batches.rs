//! The sweeps of the declared mechanisms: every number of a motion goes to a slice of its own.

use linkage_core::{
    AngularAcceleration as Alpha, AngularVelocity as Omega, Direction, Float, LengthMismatch,
    Point, Slide, Status,
};

use laboratory::generated as g;

/// As many slices as a motion has numbers, and the statuses.
pub(crate) struct Slices<'a, T, const N: usize> {
    pub(crate) numbers: [&'a mut [T]; N],
    pub(crate) status: &'a mut [Status],
}

type Swept = Result<(), LengthMismatch>;

pub(crate) fn four_bar<T: Float>(
    solver: &g::FourBar<T>,
    (angles, omega, alpha): (&[T], T, T),
    Slices { numbers, status }: Slices<'_, T, 14>,
) -> Swept {
    let [px, py, b, c, d, e, vx, vy, bw, dw, ax, ay, ba, da] = numbers;
    let motion = g::FourBarMotion {
        position: g::FourBarPosition {
            P: Point { x: px, y: py },
            BC: Direction { cos: b, sin: c },
            DC: Direction { cos: d, sin: e },
        },
        velocity: g::FourBarVelocity {
            P: Point { x: vx, y: vy },
            BC: Omega { omega: bw },
            DC: Omega { omega: dw },
        },
        acceleration: g::FourBarAcceleration {
            P: Point { x: ax, y: ay },
            BC: Alpha { alpha: ba },
            DC: Alpha { alpha: da },
        },
    };
    solver.sweep_motion(angles, omega, alpha, motion, status, ())
}

pub(crate) fn six_bar<T: Float>(
    solver: &g::SixBar<T>,
    (angles, omega, alpha): (&[T], T, T),
    Slices { numbers, status }: Slices<'_, T, 13>,
) -> Swept {
    let [c, s, block, ram, pin, w, block_v, ram_v, pin_v, a, block_a, ram_a, pin_a] = numbers;
    let motion = g::SixBarMotion {
        position: g::SixBarPosition {
            rod: Direction { cos: c, sin: s },
            block: Slide { slide: block },
            ram: Slide { slide: ram },
            pin: Slide { slide: pin },
        },
        velocity: g::SixBarVelocity {
            rod: Omega { omega: w },
            block: Slide { slide: block_v },
            ram: Slide { slide: ram_v },
            pin: Slide { slide: pin_v },
        },
        acceleration: g::SixBarAcceleration {
            rod: Alpha { alpha: a },
            block: Slide { slide: block_a },
            ram: Slide { slide: ram_a },
            pin: Slide { slide: pin_a },
        },
    };
    solver.sweep_motion(angles, omega, alpha, motion, status, ())
}

pub(crate) fn stephenson<T: Float>(
    solver: &g::Stephenson<T>,
    (angles, omega, alpha): (&[T], T, T),
    Slices { numbers, status }: Slices<'_, T, 16>,
) -> Swept {
    let [px, py, ex, ey, c, s, pvx, pvy, evx, evy, w, pax, pay, eax, eay, a] = numbers;
    let motion = g::StephensonMotion {
        position: g::StephensonPosition {
            P: Point { x: px, y: py },
            E: Point { x: ex, y: ey },
            FE: Direction { cos: c, sin: s },
        },
        velocity: g::StephensonVelocity {
            P: Point { x: pvx, y: pvy },
            E: Point { x: evx, y: evy },
            FE: Omega { omega: w },
        },
        acceleration: g::StephensonAcceleration {
            P: Point { x: pax, y: pay },
            E: Point { x: eax, y: eay },
            FE: Alpha { alpha: a },
        },
    };
    solver.sweep_motion(angles, omega, alpha, motion, status, ())
}

pub(crate) fn chain<T: Float>(
    solver: &g::Chain<T>,
    (angles, omega, alpha): (&[T], T, T),
    Slices { numbers, status }: Slices<'_, T, 10>,
) -> Swept {
    let [x, y, c, s, vx, vy, w, ax, ay, a] = numbers;
    let motion = g::ChainMotion {
        position: g::ChainPosition { C4: Point { x, y }, R4: Direction { cos: c, sin: s } },
        velocity: g::ChainVelocity { C4: Point { x: vx, y: vy }, R4: Omega { omega: w } },
        acceleration: g::ChainAcceleration { C4: Point { x: ax, y: ay }, R4: Alpha { alpha: a } },
    };
    solver.sweep_motion(angles, omega, alpha, motion, status, ())
}
