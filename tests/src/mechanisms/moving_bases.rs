//! Fourteen links; every group stands on links that move.

use linkage_core::mechanism;

macro_rules! moving_bases {
    ($(#[$doc:meta])* $name:ident, $($numerics:tt)*) => {
        mechanism! {
            $(#[$doc])*
            pub struct $name {
                $($numerics)*

                input theta: angle;

                ground A(0, 0), D(3m, 0.4m);

                crank AB(A) -> B { length: 1.1m, angle: theta + 0.2rad }
                crank DE(D) -> E { length: 0.3m, angle: -2 * theta + 15deg }
                rrr   BC(B), EC(E) -> C { lengths: (3.2m, 2.4m), mode: left }
                point P on BC at polar (1.7m, 0.4rad);
                point T on EC at polar (1.1m, -0.4rad);

                guide groove on EC through E along 0.5rad;
                rrp   PF(P), block(groove) -> F { length: 5.5m, offset: 0.12m, mode: ahead }
                point G on PF at polar (2.2m, 0.2rad);

                rpr   sleeve(G), bar(T) { offset: -0.3m, mode: behind }
                point H on bar at (1.4m, -0.5m);

                guide rail on BC through P along -0.3rad;
                rpp   pin(H), yoke(rail) { slot: 2rad, offsets: (0.01m, 0.02m) }
                point Y on yoke at (0.2m, 0.3m);

                guide track on PF through G along 1.1rad;
                prp   shoe(rail), slipper(track) -> U { offsets: (0.4m, 0.05m) }

                rrr   UX(U), YX(Y) -> X { lengths: (6.5m, 5.5m), mode: left }

                output C, F, H, Y, U, X, EC, PF, bar, UX,
                    block.slide, sleeve.slide, yoke.slide, pin.slide, shoe.slide, slipper.slide;
            }
        }
    };
}

moving_bases! {
    /// Two geared cranks carry one group of each class, and one more to close the chain.
    MovingBases,
}

moving_bases! {
    /// The same with products carried to twice the width.
    CompensatedBases, numerics compensated;
}
