//! The mechanisms that were drawn at random, as a table; both ways to a motion and to the positions are
//! made of a row.

use laboratory::hand::rails::{Rail, Rod};
use laboratory::hand::{Bar, CrankDyad, Dyad, Joint, Moving, cos_sin, crank_dyad, dyad};

use crate::kernels::{Call, Contest, TURN, Visit, put};

/// +1 or −1.
macro_rules! side {
    (left) => {
        1.0
    };
    (right) => {
        -1.0
    };
}

/// The numbers of the points, links and slides that are asked for, in the order of the generated records.
macro_rules! asked {
    (position, $m:ident, [$($p:ident)*], [$($l:ident)*], [$($s:ident)*]) => {
        [
            $($m.$p.position.x, $m.$p.position.y,)*
            $($m.$l.direction().x, $m.$l.direction().y,)* $($m.$s.value,)*
        ]
    };
    (motion, $m:ident, [$($p:ident)*], [$($l:ident)*], [$($s:ident)*]) => {
        [
            $($m.$p.position.x, $m.$p.position.y,)*
            $($m.$l.direction().x, $m.$l.direction().y,)* $($m.$s.value,)*
            $($m.$p.velocity.x, $m.$p.velocity.y,)* $($m.$l.omega,)* $($m.$s.rate,)*
            $($m.$p.acceleration.x, $m.$p.acceleration.y,)* $($m.$l.alpha,)* $($m.$s.second,)*
        ]
    };
}

/// The number of these numbers.
macro_rules! count {
    (position, [$($p:ident)*], [$($l:ident)*], [$($s:ident)*]) => {
        0 $(+ { let _ = stringify!($p); 2 })* $(+ { let _ = stringify!($l); 2 })*
            $(+ { let _ = stringify!($s); 1 })*
    };
    (motion, [$($p:ident)*], [$($l:ident)*], [$($s:ident)*]) => {
        0 $(+ { let _ = stringify!($p); 6 })* $(+ { let _ = stringify!($l); 4 })*
            $(+ { let _ = stringify!($s); 3 })*
    };
}

/// The four contests of a mechanism.
macro_rules! contests {
    ($inputs:ident, $ranges:expr) => {
        pub(crate) const MOTIONS: Contest<MOTION> = Contest {
            made: Call::$inputs(motion_made),
            by_hand: Call::$inputs(motion_by_hand),
            ranges: $ranges,
        };
        pub(crate) const POSITIONS: Contest<POSITION> = Contest {
            made: Call::$inputs(position_made),
            by_hand: Call::$inputs(position_by_hand),
            ranges: $ranges,
        };
    };
}

/// The four functions of a mechanism, given how a hand moves it.
macro_rules! both_ways {
    ($points:tt $links:tt $slides:tt) => {
        both_ways!(@one $points $links $slides [TURN; 2]);
    };
    (@sizes $points:tt $links:tt $slides:tt) => {
        const MOTION: usize = count!(motion, $points, $links, $slides);
        const POSITION: usize = count!(position, $points, $links, $slides);
    };
    (@one $points:tt $links:tt $slides:tt $ranges:expr) => {
        both_ways!(@sizes $points $links $slides);

        #[inline(never)]
        pub(crate) fn motion_made(t: f64, w: f64, a: f64, out: &mut [f64; MOTION]) -> bool {
            put(Made::new().motion(t, w, a).ok(), out, Record::into_array)
        }

        #[inline(never)]
        pub(crate) fn motion_by_hand(t: f64, w: f64, a: f64, out: &mut [f64; MOTION]) -> bool {
            put(moved([t, w, a]), out, |m| asked!(motion, m, $points, $links, $slides))
        }

        #[inline(never)]
        pub(crate) fn position_made(t: f64, _: f64, _: f64, out: &mut [f64; POSITION]) -> bool {
            put(Made::new().position(t).ok(), out, Record::into_array)
        }

        #[inline(never)]
        pub(crate) fn position_by_hand(t: f64, _: f64, _: f64, out: &mut [f64; POSITION]) -> bool {
            put(moved([t, 0.0, 0.0]), out, |m| asked!(position, m, $points, $links, $slides))
        }

        contests!(One, $ranges);
    };
    (@two $points:tt $links:tt $slides:tt $ranges:expr) => {
        both_ways!(@sizes $points $links $slides);

        #[inline(never)]
        pub(crate) fn motion_made(
            q: f64, r: f64, v: f64, w: f64, a: f64, b: f64, out: &mut [f64; MOTION],
        ) -> bool {
            put(Made::new().motion([q, r], [v, w], [a, b]).ok(), out, Record::into_array)
        }

        #[inline(never)]
        pub(crate) fn motion_by_hand(
            q: f64, r: f64, v: f64, w: f64, a: f64, b: f64, out: &mut [f64; MOTION],
        ) -> bool {
            let moved = moved([[q, v, a], [r, w, b]]);
            put(moved, out, |m| asked!(motion, m, $points, $links, $slides))
        }

        #[inline(never)]
        pub(crate) fn position_made(
            q: f64, r: f64, _: f64, _: f64, _: f64, _: f64, out: &mut [f64; POSITION],
        ) -> bool {
            put(Made::new().position([q, r]).ok(), out, Record::into_array)
        }

        #[inline(never)]
        pub(crate) fn position_by_hand(
            q: f64, r: f64, _: f64, _: f64, _: f64, _: f64, out: &mut [f64; POSITION],
        ) -> bool {
            let moved = moved([[q, 0.0, 0.0], [r, 0.0, 0.0]]);
            put(moved, out, |m| asked!(position, m, $points, $links, $slides))
        }

        contests!(Two, $ranges);
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

            mechanism! { pub(crate) struct Made {
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

            both_ways!([$($p)*] [$($l)*] []);
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
    ($table:ident: $($name:ident)*) => {
        fn $table(visit: &mut impl Visit) {
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

/// A machine with sliding joints or several inputs: the inputs with their ranges, the statements, what is
/// asked for (points, links, slides), and how a hand moves it.
macro_rules! machine {
    ($name:ident: $count:ident [$($input:ident: $kind:ident),*] between $ranges:expr,
     { $($statements:tt)* }, output [$($p:ident)*] [$($l:ident)*] [$($s:ident)*],
     $by_hand:ident($($form:expr),*) -> $Moved:ident) => {
        pub(crate) mod $name {
            use super::*;
            use crate::machines;
            use linkage_core::{Record, mechanism};

            mechanism! { pub(crate) struct Made {
                $(input $input: $kind;)*
                $($statements)*
                output $($p),* $(, $l)* $(, $s.slide)*;
            } }

            #[inline(always)]
            fn moved(inputs: inputs!($count)) -> Option<machines::$Moved> {
                machines::$by_hand(both!($count, inputs), $($form),*)
            }

            both_ways!(@$count [$($p)*] [$($l)*] [$($s)*] $ranges);
        }
    };
}

/// Inputs with their rates, as the functions of a machine have them.
macro_rules! inputs {
    (one) => {
        [f64; 3]
    };
    (two) => {
        [[f64; 3]; 2]
    };
}

macro_rules! both {
    (one, $inputs:ident) => {
        [$inputs, [0.0; 3]]
    };
    (two, $inputs:ident) => {
        $inputs
    };
}

include!(concat!(env!("OUT_DIR"), "/bars.rs"));
include!(concat!(env!("OUT_DIR"), "/machines.rs"));

pub(crate) fn every(visit: &mut impl Visit) {
    bars(visit);
    machines(visit);
}
