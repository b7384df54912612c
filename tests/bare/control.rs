//! The defects that the proof has to catch: each has to break the build, or the link of a program that holds it.

/// A panic: the length of the list is not known.
#[unsafe(no_mangle)]
extern "C" fn control_indexing(index: usize) -> f64 {
    [0.5, 0.25][index]
}

/// The heap.
#[cfg(feature = "boxing")]
#[unsafe(no_mangle)]
extern "C" fn control_boxing(index: usize) -> usize {
    extern crate alloc;
    *core::hint::black_box(alloc::boxed::Box::new(index))
}

/// The heap behind the compiler's back.
#[unsafe(no_mangle)]
extern "C" fn control_malloc(index: usize) -> *mut core::ffi::c_void {
    unsafe extern "C" {
        fn malloc(size: usize) -> *mut core::ffi::c_void;
    }
    // SAFETY: any size may be asked for.
    unsafe { malloc(index) }
}

/// The standard library.
#[cfg(feature = "printing")]
#[unsafe(no_mangle)]
extern "C" fn control_printing(index: usize) -> usize {
    extern crate std;
    std::println!("{index}");
    index
}

/// Nothing wrong: what the other controls are without their mistakes.
#[unsafe(no_mangle)]
extern "C" fn control_sound(index: usize) -> f64 {
    match index {
        0 => 0.5,
        _ => 0.25,
    }
}
