//! Automatic differentiation and the formulas agree, to every order, and without the heap.

mod awkward;
mod exact;
mod sensitivities;
mod without_heap;
