//! The rules on tiny declarations: what they resolve to, and every mistake with its token.

use super::mechanism::Mechanism;
use super::resolve;
use crate::diagnostics::Diagnostics;
use crate::syntax::parse;

/// The mechanism with these statements, and its mistakes as "token: message / reason".
fn resolved(statements: &str) -> (Option<Mechanism>, String) {
    let mut diagnostics = Diagnostics::new();
    let source = format!("pub struct M {{ {statements} }}");
    let tokens = source.parse().expect("the source is made of Rust's tokens");
    let tree = parse(tokens, &mut diagnostics).expect("the declaration has a name");
    assert_eq!(diagnostics.count(), 0, "the parser has nothing against `{statements}`");
    let mechanism = resolve(&tree, &mut diagnostics);
    let mistakes = diagnostics.into_errors().into_iter().map(|error| {
        let token = error.span().source_text().unwrap_or_default();
        format!("{token}: {}", error.to_string().replace('\n', " / "))
    });
    (mechanism, mistakes.collect::<Vec<_>>().join("\n"))
}
