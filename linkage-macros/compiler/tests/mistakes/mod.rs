//! Mistakes as newcomers make them, and what mends them: the first message stands at the wrong token, and the text that
//! it proposes compiles, to the machine that was meant.

pub(crate) mod drives;
pub(crate) mod forces;
pub(crate) mod friction;
pub(crate) mod groups;
pub(crate) mod links;
pub(crate) mod outputs;
pub(crate) mod pins;

use crate::diagnostics::{Diagnostic, Diagnostics, told};
use crate::pipeline::{self, Options};
use crate::syntax::anatomy::KEYWORDS;
use crate::syntax::openings::OPENINGS;
use proc_macro2::{Group, TokenStream, TokenTree};

/// A four-bar whose coupler drives a block, as it is drawn.
pub(super) const LEVERS: &str = "pub struct M {
    input theta: angle;
    ground A(0, 0), D(300mm, 0);
    guide bed through (300mm, 0) along -90deg;
    pin B(60mm, 40mm), C(330mm, 180mm), E(300mm, -200mm);
    link AB(A, B);
    link BC(B, C);
    link DC(D, C);
    link CE(C, E);
    link ram(E) on bed;
    drive AB.angle = theta;
    load work: force;
    gravity (0, -9.81);
    mass 4kg on E;
    mass 1kg on BC uniform;
    force (0, -work) on E;
    friction 0.1 at A radius 10mm;
}";

/// The same in groups.
pub(super) const PRESS: &str = "pub struct M {
    input theta: angle;
    ground A(0, 0), D(400mm, 100mm);
    guide bed through (400mm, 0) along -90deg;
    crank AB(A) -> B { length: 60mm, angle: theta }
    rrr BC(B), DC(D) -> C { lengths: (390mm, 180mm), mode: left }
    rrp CE(C), ram(bed) -> E { length: 300mm, mode: ahead }
    load work: force;
    mass 4kg on E;
    force (0, work) on E;
    friction 0.12 on ram length 120mm;
}";

/// Texts, each with what is written in its place.
type Changes = &'static [(&'static str, &'static str)];

/// A mistake in a machine, and what mends it.
pub(super) struct Slip {
    /// The text of the machine that is meant, and what stands in its place.
    wrong: (&'static str, &'static str),
    /// The other changes by which the mistake is made.
    also: Changes,
    /// The place of the first message, as `told` writes it.
    at: &'static str,
    /// The text that the message proposes; none where it leaves the choice to the reader.
    proposed: &'static str,
    /// In place of the wrong text.
    mended: &'static str,
    /// The other changes that the message asks for.
    and: Changes,
    /// The changes of the machine, where another one is meant.
    means: Changes,
    /// The number of messages.
    count: usize,
}

/// `right` was to be written, `wrong` was; the message stands at `at` and proposes `proposed`, which `mended` holds.
pub(super) const fn slip(
    right: &'static str,
    wrong: &'static str,
    at: &'static str,
    proposed: &'static str,
    mended: &'static str,
) -> Slip {
    let (also, and, means): (Changes, Changes, Changes) = (&[], &[], &[]);
    Slip { wrong: (right, wrong), also, at, proposed, mended, and, means, count: 1 }
}

impl Slip {
    /// Where more than one change makes the mistake.
    const fn also(self, also: Changes) -> Self {
        Self { also, ..self }
    }

    /// Where more than one change mends it.
    const fn and(self, and: Changes) -> Self {
        Self { and, ..self }
    }

    /// Where what is meant is not the machine itself.
    const fn means(self, means: Changes) -> Self {
        Self { means, ..self }
    }

    /// Where there are several mistakes, each with its own message.
    const fn messages(self, count: usize) -> Self {
        Self { count, ..self }
    }

    /// The fault of this mistake's messages; none where all is as it should be.
    fn is_bad(&self, machine: &str) -> Option<String> {
        let (right, wrong) = self.wrong;
        let source = changed(&changed(machine, &[(right, wrong)])?, self.also)?;
        let start = source.find(wrong)?;
        let mistakes = mistakes(&source);
        let told = told(&mistakes, &source, start..start + wrong.len());
        mistakes.iter().for_each(|mistake| proposals_are_read(&mistake.text()));
        let Some(first) = mistakes.first() else { return Some("nothing is told".to_string()) };
        if !told.starts_with(&format!("{}: ", self.at)) || mistakes.len() != self.count {
            return Some(told);
        }
        if !self.proposed.is_empty() && !first.text().contains(&format!("`{}`", self.proposed)) {
            return Some(format!("`{}` is not proposed: {told}", self.proposed));
        }
        let held = without_spaces(&self.texts_of_mending());
        // Dots stand for what is there already.
        if !self.proposed.split('…').all(|part| held.contains(&without_spaces(part))) {
            return Some(format!("`{}` is not what mends it", self.proposed));
        }
        let mended = changed(&changed(&source, &[(wrong, self.mended)])?, self.and)?;
        let left = self::mistakes(&mended);
        if let Some(left) = left.first() {
            return Some(format!("mended, it is told: {}", left.text()));
        }
        let meant = changed(machine, self.means)?;
        (code(&mended) != code(&meant)).then(|| "mended, it is another machine".to_string())
    }

    fn texts_of_mending(&self) -> String {
        let others = self.and.iter().map(|(_, new)| *new);
        [self.mended].into_iter().chain(others).collect::<Vec<_>>().join(" ")
    }
}

fn without_spaces(text: &str) -> String {
    text.split_whitespace().collect()
}

/// A text with some parts replaced, each of which is there once.
fn changed(text: &str, changes: &[(&str, &str)]) -> Option<String> {
    changes.iter().try_fold(text.to_string(), |text, (old, new)| {
        assert_eq!(text.matches(old).count(), 1, "`{old}` is there once in\n{text}");
        Some(text.replacen(old, new, 1))
    })
}

fn tokens(source: &str) -> TokenStream {
    source.parse().expect("the source is made of Rust's tokens")
}

fn mistakes(source: &str) -> Vec<Diagnostic> {
    let mut diagnostics = Diagnostics::new();
    let (_, resolved) = pipeline::read(tokens(source), &mut diagnostics);
    drop(resolved);
    match diagnostics.finish() {
        Ok(()) => Vec::new(),
        Err(failure) => failure.0,
    }
}

/// The code that a machine expands to, without its documentation.
fn code(source: &str) -> String {
    without_docs(pipeline::compile(tokens(source), &Options::NONE).tokens).to_string()
}

fn without_docs(code: TokenStream) -> TokenStream {
    let is_doc = |tree: &TokenTree| match tree {
        TokenTree::Group(group) => group.stream().to_string().starts_with("doc"),
        _ => false,
    };
    let trees: Vec<_> = code.into_iter().collect();
    let kept = trees.iter().enumerate().filter_map(|(index, tree)| {
        let is_of_a_doc = is_doc(tree) || trees.get(index + 1).is_some_and(is_doc);
        match tree {
            TokenTree::Group(_) | TokenTree::Punct(_) if is_of_a_doc => None,
            TokenTree::Group(group) => {
                let own = Group::new(group.delimiter(), without_docs(group.stream()));
                Some(TokenTree::Group(own))
            }
            tree => Some(tree.clone()),
        }
    });
    kept.collect()
}

/// Looks at every mistake of a table.
pub(super) fn check(machine: &str, slips: &[Slip]) {
    let bad = slips.iter().filter_map(|slip| {
        let bad = slip.is_bad(machine)?;
        Some(format!("{}\n    {bad}\n", slip.wrong.1))
    });
    let bad: Vec<_> = bad.collect();
    assert!(bad.is_empty(), "{} of {} are bad:\n{}", bad.len(), slips.len(), bad.concat());
}

/// The notes on a machine without a mistake, with some changes.
pub(super) fn notes(machine: &str, changes: &[(&str, &str)]) -> String {
    let source = changed(machine, changes).expect("all of them are there");
    let output = pipeline::compile(tokens(&source), &Options::NONE);
    assert!(output.diagnostics.is_empty(), "{:?}", output.diagnostics);
    let told = |notes: &[Diagnostic]| told(notes, &source, 0..source.len());
    assert_eq!(told(&pipeline::check(tokens(&source))), told(&output.notes));
    told(&output.notes)
}

/// The statements that a message proposes are statements: each is read without a mistake, dots standing for a number.
pub(crate) fn proposals_are_read(message: &str) {
    let quoted = message.split('`').skip(1).step_by(2);
    for text in quoted.filter(|text| is_a_statement(text)) {
        let source = format!("struct M {{ {} }}", text.replace("(…)", "(P)").replace('…', "1"));
        let mut diagnostics = Diagnostics::new();
        let _ = crate::syntax::parse(tokens(&source), &mut diagnostics);
        let mistakes: Vec<_> = diagnostics.into_mistakes().iter().map(Diagnostic::text).collect();
        assert!(mistakes.is_empty(), "`{text}` is proposed: {mistakes:?}\n{message}");
    }
}

/// True for a whole statement: it begins with a word that begins one, and ends as one does.
fn is_a_statement(text: &str) -> bool {
    let begins = text.split_once(' ').is_some_and(|(word, _)| {
        KEYWORDS.contains(&word) || OPENINGS.iter().any(|opening| opening.word == word)
    });
    begins && (text.ends_with(';') || text.ends_with('}')) && !text.contains("{ … }")
}
