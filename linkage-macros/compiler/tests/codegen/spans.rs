//! Every identifier of a declaration reaches the output with its own span.

use std::collections::HashSet;

use crate::pipeline::{self, Options};
use proc_macro2::{Ident, LineColumn, TokenStream, TokenTree};

/// Every identifier among the tokens and where it stands.
fn identifiers(stream: TokenStream, found: &mut Vec<(String, LineColumn)>) {
    for tree in stream {
        match tree {
            TokenTree::Group(group) => identifiers(group.stream(), found),
            TokenTree::Ident(ident) => found.push(located(&ident)),
            _ => {}
        }
    }
}

fn located(ident: &Ident) -> (String, LineColumn) {
    (ident.to_string(), ident.span().start())
}

/// Names of every kind, made and used in every kind of place, some of them fields and some not.
const SOURCE: &str = "pub struct Press {
    input theta: angle;
    input lift: length;
    param reach = 0.9m;
    param side: mode = right;
    let half = reach / 2;
    ground A(0, 0), D(0.9m, half);
    guide rail through D along 20deg;
    guide line through A towards D;
    crank AB(A) -> B { length: half / 3, angle: theta }
    crank wheel(A) { angle: AB.angle, relative_to: AB }
    guide slot on wheel through A along theta;
    rrr BC(B), DC(D) -> C { lengths: (reach, lift), mode: side }
    rrp BE(B), block(rail) -> E { length: 3m, offset: half, mode: ahead }
    slider ram(line) -> R { slide: lift + half }
    prp p(slot), q(rail) -> S { }
    point P on BC at polar (half, theta);
    output C, P, DC.margin, ram.slide, fold = BC.angle - DC.angle, sum = lift + half;
}";

const NAMES: &str = "theta lift reach side half A D rail line AB B wheel slot BC DC C BE block E \
                     ram R p q S P fold sum Press";

#[test]
fn every_name_reaches_the_output_with_its_own_span_wherever_it_stands() {
    let source: TokenStream = SOURCE.parse().expect("a declaration is made of tokens");
    let names: HashSet<&str> = NAMES.split_whitespace().collect();
    let (mut written, mut made) = (Vec::new(), Vec::new());
    identifiers(source.clone(), &mut written);
    identifiers(pipeline::compile(source, &Options::PAGE).tokens, &mut made);
    let made: HashSet<_> = made.into_iter().collect();
    let mut seen = HashSet::new();
    for identifier in &written {
        if names.contains(identifier.0.as_str()) {
            assert!(made.contains(identifier), "{identifier:?} is lost");
            seen.insert(identifier.0.as_str());
        }
    }
    assert_eq!(seen, names);
}
