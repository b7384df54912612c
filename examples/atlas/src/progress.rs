//! Progress of a long computation: a bar on a terminal, a line every tenth of the way elsewhere.

use std::io::IsTerminal;
use std::sync::atomic::{AtomicU64, Ordering};

use indicatif::{ProgressBar, ProgressStyle};

/// Told by many threads what is done.
#[derive(Debug)]
pub struct Progress {
    /// None where nobody looks, or where what is written is kept.
    bar: Option<ProgressBar>,
    is_told: bool,
    what: &'static str,
    total: u64,
    done: AtomicU64,
}

impl Progress {
    /// Tells on the standard error stream how many of so many are done.
    #[must_use]
    pub fn of(what: &'static str, total: u64) -> Self {
        let bar = std::io::stderr().is_terminal().then(|| {
            let template = "{msg} {wide_bar} {percent:>3} %, {eta} to go";
            let style = ProgressStyle::with_template(template);
            let style = style.unwrap_or_else(|_| ProgressStyle::default_bar());
            ProgressBar::new(total).with_style(style).with_message(what)
        });
        Self { bar, is_told: true, what, total, done: AtomicU64::new(0) }
    }

    /// Tells nobody.
    #[must_use]
    pub fn silent() -> Self {
        Self { bar: None, is_told: false, what: "", total: 0, done: AtomicU64::new(0) }
    }

    /// So many more are done.
    pub fn advance(&self, more: u64) {
        if let Some(bar) = &self.bar {
            bar.inc(more);
            return;
        }
        let before = self.done.fetch_add(more, Ordering::Relaxed);
        let tenths = |done: u64| done * 10 / self.total.max(1);
        if self.is_told && tenths(before + more) > tenths(before) {
            eprintln!("{}: {} % of {}", self.what, 10 * tenths(before + more), self.total);
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
