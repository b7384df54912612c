//! Derivatives of every order are computed without the heap: a counting allocator sees nothing.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::hint::black_box;

use linkage_core::{Real, Side, differentiate_twice, num_dual};
use linkage_tests::mechanisms::driven_groups::DrivenRrr;
use num_dual::{Dual, Dual2, Dual2SVec, Dual3, HyperDual};

struct Counting;

thread_local! {
    /// The count of this thread alone: the thread that runs the tests allocates at any time.
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        // SAFETY: the caller keeps to the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: `pointer` came from `alloc`.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

fn allocations(run: impl FnOnce()) -> usize {
    let before = ALLOCATIONS.get();
    run();
    ALLOCATIONS.get() - before
}

fn pose<D: Real>(bars: &DrivenRrr, q: [D; 4]) {
    black_box(bars.lift::<D>().position(q)).unwrap();
}

fn derivatives(bars: &DrivenRrr, q: [f64; 4]) {
    black_box(bars.jacobian(q)).unwrap();
    black_box(bars.sensitivity(q)).unwrap();
    black_box(bars.lift::<f32>().jacobian(q.map(|x| x as f32))).unwrap();
    black_box(differentiate_twice(q, |q| Ok(bars.lift().position(q)?.C.x))).unwrap();
    pose(bars, q.map(|x| Dual::new(x, 1.0)));
    pose(bars, q.map(|x| Dual2::new(x, 1.0, 0.5)));
    pose(bars, q.map(|x| Dual3::new(x, 1.0, 0.5, 0.25)));
    pose(bars, q.map(|x| HyperDual::new(x, 1.0, 0.5, 0.25)));
    pose(bars, q.map(|x| Dual2SVec::<f64, 4>::from_re(x).derivative(0)));
    pose(bars, q.map(|x| Dual::new(Dual2::new(x, 1.0, 0.0), Dual2::new(1.0, 0.5, 0.0))));
    // Errors do not allocate either.
    let out_of_reach = bars.jacobian([0.0, 0.0, 9.0, 0.0]);
    assert!(out_of_reach.is_err());
}

#[test]
fn derivatives_do_not_allocate() {
    assert!(allocations(|| drop(black_box(Box::new(1)))) > 0, "the allocator does not count");
    let bars = DrivenRrr { l1: 3.0, l2: 4.0, elbow: Side::Left };
    assert_eq!(allocations(|| derivatives(&bars, [0.0, 0.5, 4.0, 1.0])), 0);
}
