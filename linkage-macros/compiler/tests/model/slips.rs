//! Random slips: a word or a number of a legal declaration replaced by another one of it.
//!
//! Most of them are mistakes and some are not; what resolves can be solved.

use super::*;
use crate::{equations, passes};
use proc_macro2::{Group, TokenStream, TokenTree};

const ROUNDS: usize = 400;

const DECLARATIONS: [&str; 4] = [
    "input theta: angle; input s, x: length; ground A(0, 0), D(1in, 2cm);
     guide rail through A along 90deg; guide up through (0, s) along 0.5turn;
     crank AB(A) -> B { length: 80mm, angle: theta }
     crank body(D) { angle: -2 * theta + AB.angle, relative_to: AB }
     slider ram(rail) -> P { slide: x, offset: 5mm }
     rrp BC(B), piston(rail) -> C { length: 1m, mode: behind }
     rpr block(B), bar(D) { }
     prp p(rail), q(up) -> Q { offsets: (1mm, 2mm) }
     guide axis through A towards D;
     rpp pin(B), yoke(axis) { slot: 90deg }",
    "input t: angle; ground A(0, 0), D(4m, 0); crank AB(A) -> B { length: 1m, angle: t }
     rrr BC(B), DC(D) -> C { lengths: (3m, 3m), mode: right }
     point P on BC at polar (2m, 30deg); point Q on DC at distances (2m, 1.5m) right;
     point R on ground at (1m * cos(t), 0); point S at polar (1m, 0);
     guide slot on BC through P towards C; guide fixed through S towards D;
     guide tilted on BC through (0, 1mm) along 10deg + DC.angle;
     rpr e(R), f(P) { } rrp g(Q), h(slot) -> T { length: 2m, mode: ahead }
     output P, T, DC.angle, BC.margin, fold = BC.angle - 2 * DC.angle;",
    "input t: angle; param l = 632mm; param k = 2; param tilt: angle = 0.5;
     param elbow: mode = right; param reach: mode = ahead;
     ground A(0, 0), D(k, 0); guide rail through D along tilt;
     crank AB(A) -> B { length: l, angle: t / k }
     rrr BC(B), DC(D) -> C { lengths: (l * 2, k), mode: elbow }
     rrp CE(C), block(rail) -> E { length: 5m, mode: reach }",
    "input t: angle; input s: length; let half = s / 2; let two = 1m + 1m;
     ground A(0, 0); guide rail through A along 0deg;
     crank AB(A) -> B { length: two, angle: t } slider ram(rail) { slide: half }
     let fold = 2 * AB.angle - (AB.angle - ram.slide / 20mm); let gone = fold - AB.angle;
     crank gear(A) { angle: -2 * fold + 15deg }
     output fold, gone, turned = 3 * gear.angle - 1rad, length = hypot(s, 2) + sqrt(s * 1m);",
];

/// Knuth's linear congruential generator: the same slips in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        ((self.0 >> 33) as usize) % sides
    }
}

/// All words and numbers of the stream.
fn words(stream: TokenStream, found: &mut Vec<TokenTree>) {
    for tree in stream {
        match tree {
            TokenTree::Group(group) => words(group.stream(), found),
            TokenTree::Punct(_) => {}
            word => found.push(word),
        }
    }
}

/// The stream with its word at position `at`, counted down, replaced.
fn replaced(stream: TokenStream, at: &mut usize, new: &TokenTree) -> TokenStream {
    let replace = |tree| match tree {
        TokenTree::Group(group) => {
            let inner = replaced(group.stream(), at, new);
            TokenTree::Group(Group::new(group.delimiter(), inner))
        }
        TokenTree::Punct(_) => tree,
        word => {
            *at = at.wrapping_sub(1);
            if *at == usize::MAX { new.clone() } else { word }
        }
    };
    stream.into_iter().map(replace).collect()
}

fn slip(stream: TokenStream, dice: &mut Dice) -> TokenStream {
    let mut found = Vec::new();
    words(stream.clone(), &mut found);
    let mut at = dice.roll(found.len());
    let kind = std::mem::discriminant(&found[at]);
    found.retain(|word| std::mem::discriminant(word) == kind);
    let new = &found[dice.roll(found.len())];
    replaced(stream, &mut at, new)
}

#[test]
fn what_resolves_can_be_solved() {
    let mut dice = Dice(2);
    let (mut legal, mut illegal) = (0, 0);
    for _ in 0..ROUNDS {
        proc_macro2::extra::invalidate_current_thread_spans();
        let declaration = DECLARATIONS[dice.roll(DECLARATIONS.len())];
        let mut stream: TokenStream = declaration.parse().expect("these are tokens");
        for _ in 0..=dice.roll(2) {
            stream = slip(stream, &mut dice);
        }
        let mut diagnostics = Diagnostics::new();
        let tree = parse(quote::quote!(pub struct M { #stream }), &mut diagnostics);
        let is_parsed = diagnostics.count() == 0;
        let mechanism = match &tree {
            Some(tree) if is_parsed => resolve(tree, &mut diagnostics).ok(),
            _ => None,
        };
        // Nothing is refused without a message.
        assert_eq!(mechanism.is_none(), !diagnostics.into_mistakes().is_empty(), "{stream}");
        match mechanism {
            Some(mechanism) => {
                equations::derive(&mechanism, passes::RULES);
                legal += 1;
            }
            None => illegal += usize::from(is_parsed),
        }
    }
    // Slips that are all refused by the parser, or all legal, would try nothing.
    assert!(legal > ROUNDS / 50 && illegal > ROUNDS / 4, "{legal} legal, {illegal} illegal");
}
