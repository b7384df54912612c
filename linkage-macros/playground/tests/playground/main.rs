//! The compiler as a page calls it: texts of every kind, the same answers for a browser, and a stranger's way in one.

mod browser;
#[allow(dead_code, reason = "the gallery runs pages in another way as well")]
#[path = "../../../../examples/gallery/tests/chromium/mod.rs"]
mod chromium;
#[path = "../../../../tests/skipped.rs"]
mod skipped;
mod texts;
mod wasm;
mod way;

/// The machines to begin with, by their files.
pub(crate) const MACHINES: [(&str, &str); 6] = [
    ("four_bar", include_str!("../../machines/four_bar.rs")),
    ("slider_crank", include_str!("../../machines/slider_crank.rs")),
    ("quick_return", include_str!("../../machines/quick_return.rs")),
    ("jansen", include_str!("../../machines/jansen.rs")),
    ("lift", include_str!("../../machines/lift.rs")),
    ("press", include_str!("../../machines/press.rs")),
];
