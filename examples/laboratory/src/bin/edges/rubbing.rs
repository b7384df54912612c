//! The named four-bar with masses, and with three frictions that follow from its reactions.

use std::f64::consts::TAU;

use linkage_core::{Record, mechanism};

use crate::machines::{OK, POSES};
use crate::race::{Pair, calls, swept};

macro_rules! heavy {
    ($solver:ident { $($statement:tt)* }) => {
        mechanism! {
            struct $solver {
                input theta: angle;
                ground A(0, 0), D(0.3048, 0.0);
                crank AB(A) -> B        { length: 0.1016, angle: theta }
                rrr   BC(B), DC(D) -> C { lengths: (0.254, 0.1778), mode: left }
                mass 1kg on BC at (0.12, 0.02);
                inertia 0.01(kg*m^2) on BC;
                mass 0.5kg on DC at (0.09, 0);
                gravity (0, -9.81(m/s^2));
                $($statement)*
            }
        }
    };
}

heavy! { Free {} }
heavy! { Rubbing {
    friction 0.1 at B radius 8mm;
    friction 0.1 at C radius 8mm;
    friction 0.1 at D radius 10mm;
} }
heavy! { Tuned {
    param mu = 0.1;
    param radius = 8mm;
    friction mu at B radius radius;
    friction mu at C radius radius;
    friction mu at D radius radius;
} }

macro_rules! forces {
    ($solver:ident) => {
        calls(turn(), |&angle| $solver::new().forces(angle, 2.0, 1.0))
    };
    ($solver:ident, $record:ident) => {{
        let angles = turn();
        swept(POSES, move |out, status| {
            let out: $record<&mut [f64]> = Record::from_array(out);
            $solver::new().sweep_forces(&angles, 2.0, 1.0, out, status, ()).expect(OK);
        })
    }};
}

fn turn() -> Vec<f64> {
    (0..POSES).map(|k| k as f64 * TAU / POSES as f64).collect()
}

/// The lines that are measured on this machine alone.
pub(crate) fn pairs() -> Vec<Pair> {
    let pair = |what, runs| Pair { what, aim: 2.5, runs };
    vec![
        pair("7 three frictions, a call", [forces!(Rubbing), forces!(Free)]),
        pair("7 tuned frictions, a call", [forces!(Tuned), forces!(Free)]),
        pair(
            "7 three frictions, sweep",
            [forces!(Rubbing, RubbingForces), forces!(Free, FreeForces)],
        ),
        pair("7 tuned frictions, sweep", [forces!(Tuned, TunedForces), forces!(Free, FreeForces)]),
    ]
}
