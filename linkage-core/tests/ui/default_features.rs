//! Compiles with the library's default features, and neither with fewer nor with those for pictures.

use linkage_core::{mechanism as _, num_dual as _};

mod without {
    pub mod sketch {
        pub fn is_missing() {}
    }
}

/// Two modules of one name would be ambiguous.
mod both {
    pub use super::without::*;
    pub use linkage_core::*;
}

fn main() {
    both::sketch::is_missing();
}
