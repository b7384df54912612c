//! The named four-bar with masses, and with three frictions that follow from its reactions.

use laboratory::race::{calls, swept};
use linkage_core::{Record, mechanism};

use super::{OK, Pair, turn};

macro_rules! heavy {
    ($solver:ident { $($statement:tt)* }) => {
        four_bar! { $solver, [0.1016 0.3048, (0.0), 0.254 0.1778, 0.15, (0.05)], {
            mass 1kg on BC at (0.12, 0.02);
            inertia 0.01(kg*m^2) on BC;
            mass 0.5kg on DC at (0.09, 0);
            gravity (0, -9.81(m/s^2));
            $($statement)*
        } }
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
        calls(turn(), |angle| $solver::new().forces(angle, 2.0, 1.0))
    };
    ($solver:ident, $record:ident) => {
        sweep_of!($solver, $record, sweep_forces, turn(), 2.0, 1.0)
    };
}

/// The lines that are measured on this machine alone.
pub(crate) fn pairs() -> Vec<Pair> {
    let pair = |what, runs| Pair::new(what, 2.5, runs);
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
