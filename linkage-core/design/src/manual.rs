//! The manual: from a question to a drawing, tolerances, and ratios of the trade.
//!
#![doc = include_str!("../docs/designing.md")]
