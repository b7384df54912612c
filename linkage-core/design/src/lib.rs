//! Dimensions of planar mechanisms from what they shall do.
//!
//! A declaration says what a machine is; a design says what it shall do. [`free!`] names the parameters that
//! may change, an *aim* gives residuals whose sum of squares becomes least, a *keep* gives reserves that stay
//! positive. Derivatives are exact: aims and keeps are functions of the solver on dual numbers.
//!
//! ```
//! use core::f64::consts::{FRAC_PI_2, PI};
//! use linkage_core::mechanism;
//! use linkage_design::free;
//!
//! mechanism! {
//!     /// A crank-rocker whose rocker shall follow a parabola over a quarter turn of the crank.
//!     pub struct Generator {
//!         input turn: angle;
//!         param coupler = 4m;
//!         param rocker = 2.5m;
//!         let reach = 1m + coupler;
//!         let squares = reach * reach - rocker * rocker;
//!         let crank_at_limit = acos((squares + 5m * 5m) / (10m * reach));
//!         let rocker_at_limit = acos((squares - 5m * 5m) / (10m * rocker));
//!         ground A(0, 0), D(5m, 0);
//!         crank AB(A) -> B        { length: 1m, angle: crank_at_limit + turn }
//!         rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }
//!         crank pointer(D)        { angle: rocker_at_limit + 2 * turn * turn / (3 * pi) }
//!         // The crank away from the rocker's pivot: there the transmission angle is greatest.
//!         ground F(-1m, 0);
//!         rrr   fB(F), fD(D) -> fC { lengths: (coupler, rocker), mode: left }
//!         output error = DC.angle - pointer.angle, greatest = fD.angle - fB.angle;
//!     }
//! }
//!
//! let found = free!(Generator: coupler, rocker)
//!     .within([2.0..=8.0, 1.0..=6.0])
//!     .aim("parabola", (1..=30).map(|k| FRAC_PI_2 * f64::from(k) / 30.0), |machine, turn| {
//!         Ok([machine.position(turn.into())?.error.angle()])
//!     })
//!     .keep("transmission up to 135°", [0.0], |machine, turn| {
//!         Ok([-machine.position(turn.into())?.greatest.angle() + 0.75 * PI])
//!     })
//!     .starts(10)
//!     .run()?;
//! assert!((found.cost - 0.007_592_373_605).abs() < 1e-11);
//! assert!((found.solver.coupler - 4.128_654_158).abs() < 1e-8);
//! # Ok::<(), linkage_design::DesignError>(())
//! ```
//!
//! The [manual] goes from a question to a drawing, and on to the tolerances of it.
//!
//! # The search
//!
//! Starts are drawn at random within the ranges, or are the best of many cheap [draws](Design::draws). From each
//! of them sequential quadratic programming ([`Slsqp`], behind the trait [`Kernel`]) goes to an optimum; a calibration,
//! which keeps nothing and has small residuals, is faster by [`LeastSquares`]. A pose
//! that is refused is a rejected step. Each draw and each start has a stream of random numbers of its own, so
//! that the result is the same bits with one [thread](Design::threads) and with several.
//!
//! The answer says what is at its limit and its [price](Price), how far each parameter is
//! [determined](Found::deviations), and which are left open.
//!
//! # Tolerances
//!
//! [`Reactions`] to a unit load on an output are its sensitivities to every dimension and to play in every joint, and
//! [`Tolerance`] makes of them a worst case, a standard deviation and a table by share.

mod design;
mod error;
mod follows;
mod found;
mod guards;
mod kernel;
mod least_squares;
pub mod manual;
mod mend;
mod nearest;
mod optimality;
mod placed;
mod problem;
mod random;
mod reactions;
mod rows;
mod search;
mod starts;
mod targets;
mod tolerance;
mod verdict;

pub use design::Design;
pub use error::DesignError;
pub use follows::{Follows, Pose};
pub use found::{Counts, Found, Other, Price};
pub use kernel::{Evaluation, Goal, Kernel, Slsqp};
pub use least_squares::LeastSquares;
pub use placed::{Placement, placement};
pub use reactions::Reactions;
pub use rows::{Dual, Rows};
pub use search::{Progress, Stage};
pub use tolerance::{Contribution, Drawn, Tolerance};
pub use verdict::{Confirmed, Verdict};

/// The parameters of a machine that a design may change: `free!(Press: rod, crank, start)`.
///
/// The declared values are the first start. Parameters that are not named, and modes, are those of a machine that may
/// be given: `free!(Press: rod, crank; of press)`. A name that is no parameter is an error of rustc.
#[macro_export]
macro_rules! free {
    ($machine:ident: $($parameter:ident),+ $(,)?) => {
        $crate::free!($machine: $($parameter),+; of $machine::new())
    };
    ($machine:ident: $($parameter:ident),+; of $declared:expr) => {{
        let declared: $machine = $declared;
        $(let _: f64 = declared.$parameter;)+
        $crate::Design::of(declared, [$(stringify!($parameter)),+])
    }};
}
