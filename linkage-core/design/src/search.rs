//! Draws and starts, over threads: each has a stream of random numbers and a place of its own, so that one
//! thread and two give the same bits.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{OnceLock, mpsc};

/// The state of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The part of the search that is under way.
    pub stage: Stage,
    /// Draws or starts that are done.
    pub done: usize,
    /// Draws or starts in all.
    pub of: usize,
    /// The least sum of squares so far where all is kept.
    pub best: Option<f64>,
}

/// A part of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Random machines are looked at.
    Draws,
    /// The best of them are improved.
    Starts,
}

impl core::fmt::Display for Progress {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let stage = match self.stage {
            Stage::Draws => "draws",
            Stage::Starts => "starts",
        };
        write!(f, "{} of {} {stage}", self.done, self.of)?;
        match self.best {
            Some(best) => write!(f, ", sum of squares {best:.6e}"),
            None => Ok(()),
        }
    }
}

/// The results for 0 … count − 1, in that order; none for those that a break left out. `done` is called on
/// this thread with each result.
pub(crate) fn each<T: Send + Sync>(
    count: usize,
    threads: usize,
    one: impl Fn(usize) -> T + Sync,
    mut done: impl FnMut(usize, &T) -> ControlFlow<()>,
) -> Vec<Option<T>> {
    let results: Vec<OnceLock<T>> = (0..count).map(|_| OnceLock::new()).collect();
    let put = |index: usize| {
        results[index].get_or_init(|| one(index));
    };
    let mut told = |index: usize| {
        results[index].get().map_or(ControlFlow::Continue(()), |result| done(index, result))
    };
    distribute(count, threads, &put, &mut told);
    results.into_iter().map(OnceLock::into_inner).collect()
}

/// Calls a function for 0 … count − 1 on some threads, and another one on this thread for each that is done. One function
/// for whatever is computed: threads and channels are long to compile.
fn distribute(
    count: usize,
    threads: usize,
    one: &(dyn Fn(usize) + Sync),
    done: &mut dyn FnMut(usize) -> ControlFlow<()>,
) {
    if threads <= 1 {
        for index in 0..count {
            one(index);
            if done(index).is_break() {
                return;
            }
        }
        return;
    }
    let (next, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
    std::thread::scope(|scope| {
        let (send, receive) = mpsc::channel();
        for _ in 0..threads {
            let (send, next, stopped) = (send.clone(), &next, &stopped);
            scope.spawn(move || {
                while !stopped.load(Ordering::Relaxed) {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    if index >= count {
                        break;
                    }
                    one(index);
                    if send.send(index).is_err() {
                        break;
                    }
                }
            });
        }
        drop(send);
        for index in receive {
            if done(index).is_break() {
                stopped.store(true, Ordering::Relaxed);
            }
        }
    });
}
