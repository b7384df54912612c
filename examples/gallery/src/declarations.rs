//! The declarations, as they stand in the examples.

include!(concat!(env!("OUT_DIR"), "/declarations.rs"));
