//! The defects that the proof has to catch, one at a time: each has to break the build.

/// A panic: the length of the list is not known.
#[cfg(feature = "indexing")]
#[unsafe(no_mangle)]
extern "C" fn control(index: usize) -> f64 {
    [0.5, 0.25][index]
}

/// The heap.
#[cfg(feature = "boxing")]
#[unsafe(no_mangle)]
extern "C" fn control(index: usize) -> usize {
    extern crate alloc;
    *core::hint::black_box(alloc::boxed::Box::new(index))
}

/// The heap behind the compiler's back.
#[cfg(feature = "malloc")]
#[unsafe(no_mangle)]
extern "C" fn control(index: usize) -> *mut core::ffi::c_void {
    unsafe extern "C" {
        fn malloc(size: usize) -> *mut core::ffi::c_void;
    }
    // SAFETY: any size may be asked for.
    unsafe { malloc(index) }
}

/// The standard library.
#[cfg(feature = "printing")]
#[unsafe(no_mangle)]
extern "C" fn control(index: usize) -> usize {
    extern crate std;
    std::println!("{index}");
    index
}

/// Nothing wrong: what the other controls are without their mistakes.
#[cfg(not(any(
    feature = "indexing",
    feature = "boxing",
    feature = "malloc",
    feature = "printing"
)))]
#[unsafe(no_mangle)]
extern "C" fn control(index: usize) -> f64 {
    match index {
        0 => 0.5,
        _ => 0.25,
    }
}
