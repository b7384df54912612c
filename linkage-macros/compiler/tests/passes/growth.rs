//! Growth of the program: no faster than the number of groups.

use std::fmt::Write;

use crate::lower::lower;
use crate::oracle::mechanism;
use crate::{equations, passes};
use proc_macro2::{TokenStream, TokenTree};

/// Dyads on dyads: each stands on the ground and on the pin of the one before.
fn chain(groups: usize) -> String {
    let mut source = String::from(
        "pub struct Chain { input theta: angle; ground A(0, 0);
         crank AB(A) -> P0 { length: 100mm, angle: theta }\n",
    );
    for i in 1..=groups {
        let (x, before) = (i * 600, i - 1);
        writeln!(
            source,
            "ground D{i}({x}mm, 0); rrr a{i}(P{before}), b{i}(D{i}) -> P{i}
             {{ lengths: (605mm, 300mm), mode: left }}"
        )
        .expect("a string takes everything");
    }
    source + "}"
}

fn tokens(stream: TokenStream) -> usize {
    let count = |tree| match tree {
        TokenTree::Group(group) => 2 + tokens(group.stream()),
        _ => 1,
    };
    stream.into_iter().map(count).sum()
}

/// The nodes of the graph as it is written down and as it is left, and the tokens of the code.
fn sizes(groups: usize) -> [usize; 3] {
    let mechanism = mechanism(&chain(groups));
    let written = equations::derive(&mechanism, passes::RULES);
    let left = passes::optimise(&written);
    let code = linkage_compiler::codegen::generate(
        &mechanism,
        &lower(&mechanism, &left),
        (None, None),
        false,
    );
    [written.graph.len(), left.graph.len(), tokens(code)]
}

#[test]
fn twice_the_groups_make_a_little_more_than_twice_the_graph_at_most() {
    let (fifty, hundred) = (sizes(50), sizes(100));
    println!("nodes written, nodes left, tokens: {fifty:?} of 50 groups, {hundred:?} of 100");
    for (fifty, hundred) in fifty.into_iter().zip(hundred) {
        assert!(hundred * 10 <= fifty * 2 * 12, "{hundred} of 100 groups, {fifty} of 50");
    }
}
