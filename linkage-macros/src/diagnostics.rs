//! Collects mistakes, and stops at the barriers between phases.

use proc_macro2::{Span, TokenStream};

/// The mistakes found so far. Dropping it without asking is a bug of the compiler, so it panics.
pub(crate) struct Diagnostics {
    errors: Vec<syn::Error>,
    asked: bool,
}

/// All mistakes of one declaration, as the compile errors that report them.
pub(crate) struct Failure(pub TokenStream);

impl Diagnostics {
    pub(crate) fn new() -> Self {
        Self { errors: Vec::new(), asked: false }
    }

    /// Reports a mistake at the span that made it: one line that says what to do.
    pub(crate) fn error(&mut self, span: Span, message: impl std::fmt::Display) {
        self.errors.push(syn::Error::new(span, message));
    }

    /// Reports a mistake whose second line carries the reason or the nearest name.
    pub(crate) fn error_because(
        &mut self,
        span: Span,
        message: impl std::fmt::Display,
        reason: impl std::fmt::Display,
    ) {
        self.error(span, format!("{message}\n{reason}"));
    }

    /// Takes over a mistake that `syn` found.
    pub(crate) fn adopt(&mut self, error: syn::Error) {
        self.errors.push(error);
    }

    /// Whether nothing was reported since `count` mistakes.
    pub(crate) fn count(&self) -> usize {
        self.errors.len()
    }

    /// The end of a phase: go on only where nothing was reported.
    pub(crate) fn barrier(&mut self) -> Result<(), Failure> {
        if self.errors.is_empty() {
            return Ok(());
        }
        self.asked = true;
        Err(Failure(self.errors.drain(..).map(|e| e.into_compile_error()).collect()))
    }

    /// The mistakes themselves, for tests that ask where they were made.
    #[cfg(test)]
    pub(crate) fn into_errors(mut self) -> Vec<syn::Error> {
        self.asked = true;
        std::mem::take(&mut self.errors)
    }

    /// The end of the last phase.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        let result = self.barrier();
        self.asked = true;
        result
    }
}

impl Drop for Diagnostics {
    fn drop(&mut self) {
        if !self.asked && !std::thread::panicking() {
            panic!("diagnostics were dropped without a barrier");
        }
    }
}

/// The candidate nearest to `name`, where one is near enough to have been meant.
pub(crate) fn nearest<'a>(
    name: &str,
    candidates: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    let allowed = name.chars().count().div_ceil(3).max(1);
    candidates
        .map(|candidate| (distance(name, candidate), candidate))
        .filter(|&(distance, _)| distance <= allowed)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

/// Optimal string alignment distance, letter case free of charge.
fn distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.to_lowercase().chars().collect();
    let b: Vec<char> = b.to_lowercase().chars().collect();
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let mut best = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
                if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                    best = best.min(rows[i - 2][j - 2] + 1);
                }
                best
            };
        }
    }
    rows[a.len()][b.len()]
}
