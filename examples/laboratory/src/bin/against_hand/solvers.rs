//! Solvers that no hand form is written for: what they leave out shows in their instructions.

use laboratory::generated::{CouplerPoint, FourBar};
use linkage_core::{Record, mechanism};

use crate::kernels::put;

mechanism! {
    /// The Stephenson III six-bar, of which only the first loop's point is asked for.
    struct FirstLoop {
        input theta: angle;

        ground A(0, 0), D(100mm, 0), F(180mm, 60mm);

        crank AB(A) -> B        { length: 40mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (110mm, 90mm), mode: left }
        point P on BC at (70mm, 50mm);
        rrr   PE(P), FE(F) -> E { lengths: (120mm, 100mm), mode: left }

        output P;
    }
}

mechanism! {
    /// The first loop alone, which takes as many operations; the counts differ by a few moves.
    struct OnlyLoop {
        input theta: angle;

        ground A(0, 0), D(100mm, 0);

        crank AB(A) -> B        { length: 40mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (110mm, 90mm), mode: left }
        point P on BC at (70mm, 50mm);

        output P;
    }
}

macro_rules! solvers {
    ($($module:ident: $title:literal, $n:literal, |$($input:ident),*| $call:expr;)*) => {
        $(mod $module {
            use super::*;

            #[inline(never)]
            pub(super) fn made($($input: f64,)* out: &mut [f64; $n]) -> bool {
                put($call.ok(), out, Record::into_array)
            }
        })*

        /// Calls all of them, so that they stand in the program, and gives their paths and titles.
        pub(crate) fn called() -> Vec<(&'static str, &'static str)> {
            vec![$({
                $(let $input = std::hint::black_box(0.7);)*
                std::hint::black_box($module::made($($input,)* &mut [0.0; $n]));
                (concat!("solvers::", stringify!($module), "::made"), $title)
            }),*]
        }
    };
}

solvers! {
    coupler_point: "S1, coupler point alone", 6, |t, w, a| CouplerPoint::new().motion(t, w, a);
    given: "S1, cosine and sine given", 14, |c, s, w, a| FourBar::new().motion_at(c, s, w, a);
    first_loop: "first loop of a six-bar", 6, |t, w, a| FirstLoop::new().motion(t, w, a);
    only_loop: "that loop by itself", 6, |t, w, a| OnlyLoop::new().motion(t, w, a);
}
