//! Solvers on a machine that has nothing, and called from C.

mod bare_metal;
mod build;
mod c_caller;
mod c_harness;
#[allow(unreachable_pub, reason = "the library exports them")]
mod mechanisms;
mod printed_c;
