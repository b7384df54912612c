//! The solvers as a static library for a machine that has nothing: no standard library, no heap,
//! and a panic handler that cannot be linked, so that a reachable panic is a link error.
//!
//! With a feature of `control` it holds, in place of the solvers, one thing that the proof has to
//! catch, see `bare_metal.rs`; with `rubbing` the mechanisms whose joints rub, and with `fused`
//! the standard library, see `printed_c.rs`.
#![no_std]

#[cfg(feature = "control")]
mod control;
#[cfg(not(any(feature = "control", feature = "rubbing")))]
mod mechanisms;
#[cfg(not(any(feature = "control", feature = "rubbing")))]
mod methods;
#[cfg(feature = "rubbing")]
mod rubbing {
    include!(env!("LINKAGE_RUBBING"));
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
