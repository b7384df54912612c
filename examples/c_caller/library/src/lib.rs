//! The shear as a static library: everything in it is what `export c;` makes.
#![no_std]

mod mechanism;

/// A library without the standard library has to say what a panic does. No solver has one.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
