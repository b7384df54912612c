//! Compiles with the library's default features, and not with fewer.

use linkage_core::{mechanism as _, num_dual as _};

fn main() {}
