//! The printed declarations, a file a format.

#[rustfmt::skip]
pub(crate) mod pmks;
#[rustfmt::skip]
pub(crate) mod pylinkage;
#[rustfmt::skip]
pub(crate) mod pyslvs;
