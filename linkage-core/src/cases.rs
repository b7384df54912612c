//! The number of cases that a test of this crate draws.

/// The number of cases that a test draws: `plain` in an ordinary run, and `whole` where the environment variable
/// `LINKAGE_WHOLE` is set, as `.ci/nightly` sets it. A count that a test asserts is a share of this number.
pub(crate) fn cases(plain: usize, whole: usize) -> usize {
    if std::env::var_os("LINKAGE_WHOLE").is_some() { whole } else { plain }
}
