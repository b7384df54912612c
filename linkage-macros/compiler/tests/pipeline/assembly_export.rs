//! Groups that can be listed, and messages about those that cannot.

use crate::{Options, check, compile};

/// A triad by an unknown: a crank on another, and a dyad on it.
const TRIAD: [&str; 4] = [
    "input t: angle; ground O(0, 0), B(4m, 0), C(2m, 5m); crank OA(O) -> A { length: 1m, angle: t }",
    "unknown phi: angle between (20deg, 80deg);",
    "crank AP(A) -> P { length: 1.5m, angle: phi }",
    "rrr PQ(P), BQ(B) -> Q { lengths: (2m, 1.5m), mode: left } point R on PQ at (1m, 2m); \
     solve phi { distance(R, C) = 2.5m, mode: rising }",
];

fn declaration(statements: [&str; 4]) -> String {
    let [a, b, c, d] = statements;
    format!("pub struct M {{ {a} {b} {c} {d} export assemblies; }}")
}

/// A triad with one of its parts replaced.
fn with(part: usize, text: &str) -> String {
    let mut statements = TRIAD;
    statements[part] = text;
    declaration(statements)
}

fn told(source: &str) -> Vec<String> {
    let told = check(source.parse().expect("these are tokens")).into_iter();
    told.map(|told| format!("{} / {}", told.message, told.note.unwrap_or_default())).collect()
}

/// Groups that can be listed: the angle may have other terms, and the equation its sides the other way round.
#[test]
fn triads_are_listed() {
    let rows = [
        declaration(TRIAD),
        with(2, "crank AP(A) -> P { length: 1.5m, angle: 10deg + phi - t }"),
        with(
            2,
            "let more = 2 * t; crank AP(A) -> P { length: 1.5m, angle: phi + more, relative_to: OA }",
        ),
        with(
            3,
            "rrr PQ(P), BQ(B) -> Q { lengths: (2m, 1.5m), mode: left } point R on PQ at (1m, 2m); \
             solve phi { 2.5m = distance(R, C), mode: rising }",
        ),
    ];
    for source in rows {
        let mistakes = told(&source);
        assert!(mistakes.iter().all(|told| !told.contains("export")), "{source}: {mistakes:?}");
        let output = compile(source.parse().expect("these are tokens"), &Options::default());
        assert!(output.diagnostics.is_empty(), "{source}: {:?}", output.diagnostics);
        let tokens = output.tokens.to_string();
        for made in ["ASSEMBLIES : usize = 6", "fn assemblies", "struct MAssembly", "fn with"] {
            assert!(tokens.contains(made), "{made} of {source}");
        }
    }
}

/// A solver of which no list is asked has none, and all that it has stands in one with a list.
#[test]
fn a_list_adds_to_a_solver_and_changes_nothing_of_it() {
    let asked = declaration(TRIAD);
    let plain = asked.replace("export assemblies;", "");
    let [plain, asked] = [plain, asked].map(|source| {
        let output = compile(source.parse().expect("these are tokens"), &Options::default());
        output.tokens.into_iter().map(|token| token.to_string()).collect::<Vec<_>>()
    });
    // The module of the solver, and the import of it.
    assert!(asked.len() > plain.len());
    let module = |tokens: &[String]| {
        let place = tokens.iter().position(|token| token == "M_").expect("it has a module");
        tokens[place + 1].clone()
    };
    let [plain, asked] = [module(&plain), module(&asked)];
    assert!(!plain.contains("assemblies") && asked.contains("fn assemblies"));
    // The list is the last thing that is added, in front of the brackets that end the module.
    let end = plain.trim_end_matches(['}', ' ', ';']).len();
    let before = plain[..end].bytes().zip(asked.bytes()).take_while(|(a, b)| a == b).count();
    assert!(before + 4 >= end, "{before} of {end}: {}", &plain[before..(before + 80).min(end)]);
}

/// Each reason why a list cannot be made.
#[test]
fn what_cannot_be_listed_says_why() {
    const MESSAGE: &str = "`export assemblies` needs a group of pins that one unknown solves / ";
    let no_unknown = "pub struct M { input t: angle; ground A(0, 0); \
                      crank AB(A) -> B { length: 1m, angle: t } export assemblies; }";
    let rows = [
        (no_unknown.to_string(), "nothing is searched here"),
        (
            with(2, "crank AP(A) -> P { length: 1.5m, angle: 2 * phi }"),
            "the unknown must be added to the angle of one crank",
        ),
        (
            with(2, "crank AP(A) -> P { length: 1.5m, angle: t - phi }"),
            "the unknown must be added to the angle of one crank",
        ),
        (
            with(
                3,
                "guide rail through B along 0deg; rrp PQ(P), block(rail) -> Q { length: 4m, mode: ahead } \
                 point R on PQ at (1m, 2m); solve phi { distance(R, C) = 2.5m, mode: rising }",
            ),
            "between `unknown` and `solve` only a crank and pairs of bars with a mode of their own may stand",
        ),
        (
            with(
                3,
                "rrr PQ(P), BQ(B) -> Q { lengths: (2m, 1.5m), mode: left } point R on PQ at (1m, 2m); \
                 solve phi { R.y = 2.5m, mode: rising }",
            ),
            "its equation must be the `distance` of two points",
        ),
    ];
    for (source, reason) in rows {
        let told = told(&source);
        let wanted = format!("{MESSAGE}{reason}");
        assert!(told.iter().any(|told| told.starts_with(&wanted)), "{source}: {told:?}");
    }
}
