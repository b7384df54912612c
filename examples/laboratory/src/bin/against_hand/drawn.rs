//! The mechanisms that were drawn at random, as a table; both ways to a motion and to the positions are
//! made of a row.

use laboratory::hand::{Bar, CrankDyad, Dyad, Joint, Moving, cos_sin, crank_dyad, dyad};

use crate::kernels::{Contest, Visit, plain_and_fast, put};

/// +1 or −1.
macro_rules! side {
    (left) => {
        1.0
    };
    (right) => {
        -1.0
    };
}

/// The numbers of the points and links that are asked for, in the order of the generated records.
macro_rules! asked {
    (position, $m:ident, [$($p:ident)*], [$($l:ident)*]) => {
        [
            $($m.$p.position.x, $m.$p.position.y,)*
            $($m.$l.direction().x, $m.$l.direction().y,)*
        ]
    };
    (motion, $m:ident, [$($p:ident)*], [$($l:ident)*]) => {
        [
            $($m.$p.position.x, $m.$p.position.y,)*
            $($m.$l.direction().x, $m.$l.direction().y,)*
            $($m.$p.velocity.x, $m.$p.velocity.y,)* $($m.$l.omega,)*
            $($m.$p.acceleration.x, $m.$p.acceleration.y,)* $($m.$l.alpha,)*
        ]
    };
}

/// How many they are.
macro_rules! count {
    (position, [$($p:ident)*], [$($l:ident)*]) => {
        0 $(+ { let _ = stringify!($p); 2 })* $(+ { let _ = stringify!($l); 2 })*
    };
    (motion, [$($p:ident)*], [$($l:ident)*]) => {
        0 $(+ { let _ = stringify!($p); 6 })* $(+ { let _ = stringify!($l); 4 })*
    };
}

/// The six functions of a mechanism, given how a hand moves it.
macro_rules! both_ways {
    ($points:tt $links:tt) => {
        const MOTION: usize = count!(motion, $points, $links);
        const POSITION: usize = count!(position, $points, $links);

        #[inline(never)]
        pub(crate) fn motion_made([t, w, a]: [f64; 3], out: &mut [f64; MOTION]) -> bool {
            put(Made::new().motion(t, w, a).ok(), out, Record::into_array)
        }

        #[inline(never)]
        pub(crate) fn motion_fast([t, w, a]: [f64; 3], out: &mut [f64; MOTION]) -> bool {
            put(Fast::new().motion(t, w, a).ok(), out, Record::into_array)
        }

        #[inline(never)]
        pub(crate) fn motion_by_hand(input: [f64; 3], out: &mut [f64; MOTION]) -> bool {
            put(moved(input), out, |m| asked!(motion, m, $points, $links))
        }

        #[inline(never)]
        pub(crate) fn position_made([t, _, _]: [f64; 3], out: &mut [f64; POSITION]) -> bool {
            put(Made::new().position(t).ok(), out, Record::into_array)
        }

        #[inline(never)]
        pub(crate) fn position_fast([t, _, _]: [f64; 3], out: &mut [f64; POSITION]) -> bool {
            put(Fast::new().position(t).ok(), out, Record::into_array)
        }

        #[inline(never)]
        pub(crate) fn position_by_hand([t, _, _]: [f64; 3], out: &mut [f64; POSITION]) -> bool {
            put(moved([t, 0.0, 0.0]), out, |m| asked!(position, m, $points, $links))
        }

        pub(crate) const MOTIONS: Contest<MOTION> =
            Contest { made: motion_made, fast: motion_fast, by_hand: motion_by_hand };
        pub(crate) const POSITIONS: Contest<POSITION> =
            Contest { made: position_made, fast: position_fast, by_hand: position_by_hand };
    };
}

/// A four-bar, or one whose points P of the coupler, Q of the rocker and F of the ground are joints of a
/// second dyad.
macro_rules! drawn {
    ($name:ident: crank $crank:tt, D($gx:tt, $gy:tt), lengths $l2:tt $l3:tt $mode:tt,
     P($u:tt, $($v:tt)+) $(, Q($qu:tt, $($qv:tt)+), F($fx:tt, $($fy:tt)+),
     second $from:ident $to:ident lengths $l4:tt $l5:tt $other:tt)?,
     output [$($p:ident)*] [$($l:ident)*]) => {
        #[allow(non_snake_case, reason = "points and links have their names of the declaration")]
        pub(crate) mod $name {
            use super::*;
            use linkage_core::{Record, mechanism};

            plain_and_fast! { Made, Fast, {
                input theta: angle;
                ground A(0, 0), D($gx, $gy);
                crank AB(A) -> B { length: $crank, angle: theta }
                rrr BC(B), DC(D) -> C { lengths: ($l2, $l3), mode: $mode }
                point P on BC at ($u, $($v)+);
                $(
                    point Q on DC at ($qu, $($qv)+);
                    ground F($fx, $($fy)+);
                    rrr XE($from), YE($to) -> E { lengths: ($l4, $l5), mode: $other }
                )?
                output $($p,)* $($l),*;
            } }

            const FORM: CrankDyad = CrankDyad {
                crank: $crank,
                dyad: Dyad { pivot: [$gx, $gy], lengths: [$l2, $l3], side: side!($mode) },
            };

            #[inline(always)]
            #[allow(unused_variables, reason = "not everything is a joint")]
            fn moved([angle, omega, alpha]: [f64; 3]) -> Option<Moved> {
                let (b, [BC, DC]) = crank_dyad(FORM, cos_sin(angle), [omega, alpha])?;
                let (C, P) = (DC.end_about(FORM.dyad.pivot), BC.point(b, [$u, $($v)+]));
                let (XE, YE, E) = (BC, DC, C);
                $(
                    let Q = DC.point_about(FORM.dyad.pivot, [$qu, $($qv)+]);
                    let F = [$fx, $($fy)+];
                    let to = joint!($to, Q, F);
                    let [XE, YE] = dyad(first!($from, P, Q), to, [$l4, $l5], side!($other))?;
                    let E = YE.end_at(to);
                )?
                Some(Moved { C, P, E, BC, DC, XE, YE })
            }

            both_ways!([$($p)*] [$($l)*]);
        }
    };
}

/// A first joint.
macro_rules! first {
    (P, $p:ident, $q:ident) => {
        $p
    };
    (Q, $p:ident, $q:ident) => {
        $q
    };
}

/// A second joint, whatever it is.
macro_rules! joint {
    (Q, $q:ident, $f:ident) => {
        Joint::Link($q)
    };
    (F, $q:ident, $f:ident) => {
        Joint::Ground($f)
    };
}

/// Goes through all of them.
macro_rules! every {
    ($($name:ident)*) => {
        pub(crate) fn every(visit: &mut impl Visit) {
            $(
                visit.contest(stringify!($name), "motion", &$name::MOTIONS);
                visit.contest(stringify!($name), "position", &$name::POSITIONS);
            )*
        }
    };
}

/// Everything that can be asked for.
#[allow(non_snake_case, reason = "points and links have their names of the declarations")]
struct Moved {
    C: Moving,
    P: Moving,
    E: Moving,
    BC: Bar,
    DC: Bar,
    XE: Bar,
    YE: Bar,
}

include!("table.rs");
