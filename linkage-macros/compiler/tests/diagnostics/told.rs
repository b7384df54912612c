//! Mistakes as the rows of tests write them: `place: message / reason`, one a line.
//!
//! A place is the source from its first token to its last. Where the row holds these tokens more
//! than once, a number says which: `B#2` is the second `B`. Outside the row it is `before B` or
//! `after }`, and it is `the call` where the whole `mechanism!` is meant.

use std::ops::Range;

use super::{Diagnostic, Diagnostics, Extent};
use proc_macro2::{Span, TokenStream, TokenTree};

/// The mistakes of a source, of which the row of a test is the part in `row`.
pub(crate) fn told(mistakes: &[Diagnostic], source: &str, row: Range<usize>) -> String {
    let mut tokens = Vec::new();
    flatten(source.parse().expect("the source is made of Rust's tokens"), &mut tokens);
    let told = mistakes.iter().map(|mistake| {
        let place = place(mistake, source, &tokens, &row);
        format!("{place}: {}", mistake.text().replace('\n', " / "))
    });
    told.collect::<Vec<_>>().join("\n")
}

/// Where the tokens lie in the source, delimiters among them.
fn flatten(stream: TokenStream, tokens: &mut Vec<Range<usize>>) {
    for tree in stream {
        let at = tree.span().byte_range();
        // All parts of a doc comment lie where it does.
        if tokens.last().is_some_and(|before| at.start < before.end) {
            continue;
        }
        match tree {
            TokenTree::Group(group) => {
                tokens.push(group.span_open().byte_range());
                flatten(group.stream(), tokens);
                tokens.push(group.span_close().byte_range());
            }
            _ => tokens.push(at),
        }
    }
}

fn place(
    mistake: &Diagnostic,
    source: &str,
    tokens: &[Range<usize>],
    row: &Range<usize>,
) -> String {
    let ends = [mistake.first, mistake.last].map(|span| span.byte_range());
    // No token is empty, and the span of the call is.
    if ends.iter().all(Range::is_empty) {
        return "the call".to_string();
    }
    assert!(!ends.iter().any(Range::is_empty), "half a call: {}", mistake.message);
    let at = ends[0].start..ends[1].end;
    let first = tokens.iter().position(|token| token.start == at.start);
    let last = tokens.iter().position(|token| token.end == at.end);
    let (Some(first), Some(last)) = (first, last) else {
        panic!("no tokens lie at {at:?} of `{source}`: {}", mistake.message);
    };
    let row_first = tokens.iter().filter(|token| token.end <= row.start).count();
    let row_end = tokens.iter().filter(|token| token.start < row.end).count();
    let (side, part) = if last < row_first {
        ("before ", 0..row_first)
    } else if first >= row_end {
        ("after ", row_end..tokens.len())
    } else {
        ("", row_first..row_end)
    };
    assert!(part.start <= first && first <= last && last < part.end, "{}", mistake.message);
    let text = |token: &Range<usize>| &source[token.clone()];
    let is_alike = |start: usize| {
        let (alike, meant) = (&tokens[start..], &tokens[first..=last]);
        alike.iter().zip(meant).all(|(alike, meant)| text(alike) == text(meant))
    };
    let alike = |starts: Range<usize>| starts.filter(|&start| is_alike(start)).count();
    // Tokens that would reach beyond the part begin too late in it.
    let (index, count) = (alike(part.start..first), alike(part.start..part.end - (last - first)));
    let number = if count > 1 { format!("#{}", index + 1) } else { String::new() };
    format!("{side}{}{number}", &source[at])
}

#[test]
fn a_place_is_told_apart_from_all_others() {
    const SOURCE: &str = "x { B C(B) /// c\n C; } B";
    let row = SOURCE.find("B C").expect("it is there")..SOURCE.len() - " } B".len();
    let trees: Vec<_> =
        SOURCE.parse::<TokenStream>().expect("these are tokens").into_iter().collect();
    let [x, TokenTree::Group(braces), outer] = &trees[..] else { panic!("{trees:?}") };
    let inner: Vec<_> = braces.stream().into_iter().collect();
    let [b, c, TokenTree::Group(joint), hash, doc, again, _] = &inner[..] else {
        panic!("{inner:?}")
    };
    let in_joint = joint.stream().into_iter().next().expect("it is `B`");
    for (first, last, place) in [
        (b.span(), b.span(), "B#1"),
        (in_joint.span(), in_joint.span(), "B#2"),
        (c.span(), joint.span(), "C(B)"),
        (joint.span(), joint.span_open(), "("),
        (hash.span(), doc.span(), "/// c"),
        (again.span(), again.span(), "C#2"),
        (x.span(), x.span(), "before x"),
        (braces.span_close(), braces.span_close(), "after }"),
        (outer.span(), outer.span(), "after B"),
        (Span::call_site(), Span::call_site(), "the call"),
    ] {
        let mut diagnostics = Diagnostics::new();
        diagnostics.error_because(Extent::between(first, last), "here", "why");
        assert_eq!(
            told(&diagnostics.into_mistakes(), SOURCE, row.clone()),
            format!("{place}: here / why")
        );
    }
}
