//! Counts the instructions of solvers on a Cortex-M4, and sums the bits of what they compute; on
//! any other machine it sums the same bits. Run by `cortex_m4/run.py`.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod board;
#[allow(dead_code, reason = "some of the mechanisms only have to compile here")]
mod mechanisms;

use core::fmt::Write;
use core::hint::black_box;

#[cfg(target_os = "none")]
use board::{Console, instructions};
use cam::{Cam, FlyingShear, Strip};
use linkage_core::{Real, Record};
use mechanisms::{DrivenFourBar, HeavyPress, SixBar, SliderCrank, TunedFourBar};

/// The count of calls to each function, at poses all around the turn.
const CALLS: u16 = 100;

/// Numbers whose bits can be summed.
trait Bits: Copy {
    fn bits(self) -> u64;
    fn angle(call: u16) -> Self;
}

impl Bits for f64 {
    fn bits(self) -> u64 {
        self.to_bits()
    }
    fn angle(call: u16) -> Self {
        Self::from(call) * 0.0625
    }
}

impl Bits for f32 {
    fn bits(self) -> u64 {
        self.to_bits().into()
    }
    fn angle(call: u16) -> Self {
        Self::from(call) * 0.0625
    }
}

/// One line of the report: a name, the instructions of one call, and a sum of all results' bits.
macro_rules! report {
    ($to:ident, $number:ident, $name:literal, $solver:expr, |$s:ident, $angle:ident| $call:expr) => {{
        let ($s, mut sum) = ($solver, 0_u64);
        for call in 0..CALLS {
            let $angle = <$number as Bits>::angle(call);
            if let Ok(rows) = $call {
                for row in rows {
                    sum = sum.rotate_left(7).wrapping_add(row.bits());
                }
            }
        }
        let empty = instructions(|| {
            for call in 0..CALLS {
                black_box(<$number as Bits>::angle(black_box(call)));
            }
        });
        let full = instructions(|| {
            for call in 0..CALLS {
                let $angle = <$number as Bits>::angle(black_box(call));
                let _ = black_box($call);
            }
        });
        let one = full.saturating_sub(empty) / u32::from(CALLS);
        let _ = writeln!($to, "{};{};{one};{sum:016x}", $name, stringify!($number));
    }};
}

macro_rules! width {
    ($to:ident, $number:ident) => {
        report!(
            $to,
            $number,
            "flying shear, `position`",
            FlyingShear::<$number>::default(),
            |s, a| { s.position(a).map(|p| [p.blade.x, p.blade.y]) }
        );
        report!(
            $to,
            $number,
            "flying shear, `motion`",
            FlyingShear::<$number>::default(),
            |s, a| { s.motion(a, 12.0, 3.0).map(|m| m.acceleration.blade).map(|a| [a.x, a.y]) }
        );
        report!(
            $to,
            $number,
            "flying shear, `motion_at`",
            FlyingShear::<$number>::default(),
            |s, a| {
                let (cos, sin) = (0.28 + 0.0 * a, 0.96);
                s.motion_at(cos, sin, 12.0, 3.0).map(|m| m.acceleration.blade).map(|a| [a.x, a.y])
            }
        );
        report!(
            $to,
            $number,
            "four-bar, compensated, `motion`",
            TunedFourBar::<$number>::default(),
            |s, a| { s.motion(a, 12.0, 3.0).map(|m| m.acceleration.Q).map(|a| [a.x, a.y]) }
        );
        report!(
            $to,
            $number,
            "slider-crank, `motion`",
            SliderCrank::<$number>::default(),
            |s, a| { s.motion(a, 12.0, 3.0).map(|m| m.acceleration.P).map(|a| [a.x, a.y]) }
        );
        report!($to, $number, "six-bar, `motion`", SixBar::<$number>::default(), |s, a| {
            s.motion(a, 12.0, 3.0).map(|m| m.acceleration.E).map(|a| [a.x, a.y])
        });
        report!(
            $to,
            $number,
            "four-bar, `forces`: its drive",
            DrivenFourBar::<$number>::default(),
            |s, a| { s.forces(a, 12.0, 3.0).map(|f| [f.theta.drive]) }
        );
        report!(
            $to,
            $number,
            "press, `forces` of everything",
            HeavyPress::<$number>::default(),
            |s, a| { s.forces(a, 12.0, 3.0, [100.0, 2.0]).map(Record::into_array) }
        );
        report!($to, $number, "electronic cam, ten steps", cam::<$number>(), |s, a| {
            let (mut cam, mut last) = (s, a);
            for _ in 0..10 {
                let strip = Strip { advance: 0.001, speed: 1.0, acceleration: 0.01 * a };
                last = cam.step(strip).map_or(a, |point| point.acceleration);
            }
            Ok::<_, ()>([last])
        });
    };
}

/// The electronic cam of the examples, before a cut: ten steps at 1 mm are all in the strip.
fn cam<T: Real>() -> Cam<T> {
    let number = |value: f64| T::lit(value, value as f32);
    match Cam::new(number(4.875), number(5.375), number(0.5)) {
        Ok(cam) => cam,
        Err(error) => unreachable!("a shear whose crank turns fully: {error}"),
    }
}

fn write_report(to: &mut impl Write) {
    width!(to, f64);
    width!(to, f32);
}

#[cfg(target_os = "none")]
#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    write_report(&mut Console);
    board::exit()
}

/// On another machine, nothing is counted.
#[cfg(not(target_os = "none"))]
fn instructions(work: impl FnOnce()) -> u32 {
    work();
    0
}

#[cfg(not(target_os = "none"))]
fn main() {
    let mut report = String::new();
    write_report(&mut report);
    print!("{report}");
}
