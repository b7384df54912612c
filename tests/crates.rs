//! The crates themselves: their structure, and solvers on a machine that has nothing.

#[cfg(target_os = "linux")]
mod bare;
mod structure;
