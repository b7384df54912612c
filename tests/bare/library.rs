//! The solvers as a static library for a machine that has nothing: no standard library, no heap,
//! and a panic handler that cannot be linked, so that a reachable panic is a link error.
//!
//! It also holds what the proof has to catch, see `bare_metal.rs`. With a feature of `unbuildable` it holds
//! one thing in place of the solvers that may not even compile; with `all` it holds every mechanism that rubs, and with
//! `fused` the standard library, see `printed_c.rs`.
#![no_std]

mod control;
#[cfg(not(feature = "unbuildable"))]
mod mechanisms;
#[cfg(not(feature = "unbuildable"))]
mod methods;
#[cfg(not(feature = "unbuildable"))]
mod rubbing {
    use linkage_core::mechanism;
    include!(concat!(env!("CARGO_MANIFEST_DIR"), "/rubbing.rs"));
    #[cfg(feature = "all")]
    include!(concat!(env!("CARGO_MANIFEST_DIR"), "/other_rubbing.rs"));
}

#[cfg(not(feature = "fused"))]
unsafe extern "C" {
    fn a_panic_is_reachable() -> !;
}

#[cfg(not(feature = "fused"))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    // SAFETY: never run, as nothing that holds this call can be linked.
    unsafe { a_panic_is_reachable() }
}
