//! Every mistake has its message, at its token: one file a mistake, named for it, in folders by
//! phase; `mixed` has several at once.
//!
//! `TRYBUILD=overwrite cargo test -p linkage-core --test ui` writes the messages down anew.

#[test]
fn mistakes_are_reported_at_their_tokens() {
    let tests = trybuild::TestCases::new();
    tests.compile_fail("tests/ui/*/*.rs");
}
