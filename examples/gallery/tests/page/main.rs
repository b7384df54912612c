//! The pages on which machines are dragged: their numbers against the solvers', and what a browser makes of
//! them.

mod browser;
#[path = "../chromium/mod.rs"]
mod chromium;
mod contents;
mod hard;
mod machines;
mod numbers;

/// The program of the README is the example that is compiled beside this test.
#[test]
fn the_readme_holds_the_program_of_a_page() {
    let readme = include_str!("../../../../README.md");
    let (_, program) = include_str!("../../examples/page.rs").split_once("\n\n").unwrap();
    assert!(readme.contains(&format!("```rust,ignore\n{program}```\n")));
}
