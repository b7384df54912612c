//! The files that name one fact of the domain: what somebody who adds another of its kind has to
//! touch, at most.
//!
//! A file names a fact if an identifier or a string holds its words, however they are joined: `rrr`,
//! `leave_rrr`, `Rrr`, "an `rrr`". Calls of a function are formulas like others and do not count as
//! naming it; nor do docs and comments.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use syn::visit::Visit;
use syn::{Attribute, Expr, ExprCall, ExprMethodCall, ExprPath, File, LitStr, Macro};

use crate::sources::crates;

/// The words of an identifier or a text, in small letters.
fn words(text: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut was_small = false;
    for letter in text.chars() {
        if !letter.is_alphanumeric() || letter.is_uppercase() && was_small {
            words.push(String::new());
        }
        if letter.is_alphanumeric() {
            words.last_mut().expect("there is one").extend(letter.to_lowercase());
        }
        was_small = letter.is_lowercase() || letter.is_numeric();
    }
    words.retain(|word| !word.is_empty());
    words
}

/// What a file says outside its docs.
#[derive(Default)]
struct Said {
    names: BTreeSet<String>,
    texts: BTreeSet<String>,
    words: BTreeSet<Vec<String>>,
}

fn said(file: &File) -> Said {
    let mut said = Said::default();
    said.visit_file(file);
    said
}

impl Said {
    fn tokens(&mut self, tokens: TokenStream) {
        let mut is_method = false;
        for token in tokens {
            match &token {
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(name) if !is_method => self.name(name),
                TokenTree::Literal(literal) => self.literal(literal),
                _ => {}
            }
            is_method = matches!(&token, TokenTree::Punct(sign) if sign.as_char() == '.');
        }
    }

    fn literal(&mut self, literal: &Literal) {
        if let Ok(text) = syn::parse_str::<LitStr>(&literal.to_string()) {
            self.text(&text.value());
        }
    }

    fn name(&mut self, name: &Ident) {
        self.words.insert(words(&name.to_string()));
        self.names.insert(name.to_string());
    }

    fn text(&mut self, text: &str) {
        self.words.insert(words(text));
        self.texts.insert(text.to_string());
    }

    fn names(&self, fact: Spelled) -> bool {
        match fact {
            Words(fact) => {
                let fact = words(fact);
                let mut said = self.words.iter().flat_map(|words| words.windows(fact.len()));
                said.any(|words| *words == *fact)
            }
            Name(fact) => self.names.contains(fact) || self.texts.contains(fact),
            Text(fact) => self.texts.contains(fact),
        }
    }
}

impl<'ast> Visit<'ast> for Said {
    fn visit_attribute(&mut self, _: &'ast Attribute) {}

    fn visit_ident(&mut self, name: &'ast Ident) {
        self.name(name);
    }

    fn visit_lit_str(&mut self, text: &'ast LitStr) {
        self.text(&text.value());
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        self.tokens(call.tokens.clone());
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        self.visit_expr(&call.receiver);
        call.args.iter().for_each(|argument| self.visit_expr(argument));
    }

    fn visit_expr_call(&mut self, call: &'ast ExprCall) {
        match &*call.func {
            Expr::Path(ExprPath { path, .. })
                if path
                    .segments
                    .last()
                    .is_some_and(|name| name.ident.to_string().starts_with(char::is_lowercase)) => {
            }
            function => self.visit_expr(function),
        }
        call.args.iter().for_each(|argument| self.visit_expr(argument));
    }
}

/// How a fact is spelled.
#[derive(Clone, Copy, Debug)]
enum Spelled {
    /// By these words, next to one another.
    Words(&'static str),
    /// By this name alone, for facts whose name is a word of every day.
    Name(&'static str),
    /// By a string of this name alone.
    Text(&'static str),
}
use Spelled::{Name, Text, Words};

/// A fact, and how many files name it at most: this number only goes down.
struct Fact {
    spelled: &'static [Spelled],
    most: usize,
}

const fn fact(most: usize, spelled: &'static [Spelled]) -> Fact {
    Fact { spelled, most }
}

/// Facts of one kind, and how many files one more of them should touch.
struct Kind {
    name: &'static str,
    aim: usize,
    facts: &'static [Fact],
}

const KINDS: [Kind; 5] = [
    Kind {
        name: "groups",
        aim: 5,
        facts: &[
            fact(5, &[Words("rrr")]),
            fact(4, &[Words("rrp")]),
            fact(5, &[Words("rpr")]),
            fact(4, &[Words("prp")]),
            fact(5, &[Words("rpp")]),
        ],
    },
    Kind {
        name: "functions",
        aim: 8,
        facts: &[
            fact(32, &[Name("Sqrt"), Name("sqrt")]),
            fact(20, &[Name("Hypot"), Name("hypot")]),
            // `sin` and `cos` are what the sine and cosine of an angle are called everywhere.
            fact(18, &[Name("Sin"), Text("sin")]),
            fact(18, &[Name("Cos"), Text("cos")]),
            fact(9, &[Words("tan")]),
            fact(12, &[Words("asin")]),
            fact(11, &[Words("acos")]),
            fact(12, &[Words("atan")]),
            fact(13, &[Words("atan2")]),
        ],
    },
    Kind {
        name: "modes",
        aim: 6,
        facts: &[
            fact(7, &[Name("Side")]),
            fact(5, &[Text("left"), Text("right")]),
            fact(6, &[Name("Sense")]),
            fact(5, &[Text("ahead"), Text("behind")]),
            fact(18, &[Name("Trend")]),
            fact(3, &[Text("rising"), Text("falling")]),
        ],
    },
    Kind {
        name: "entry points",
        aim: 4,
        facts: &[
            fact(3, &[Text("position")]),
            fact(5, &[Text("velocity")]),
            fact(2, &[Text("motion")]),
            fact(11, &[Words("coefficients")]),
            fact(10, &[Words("margins")]),
            fact(2, &[Text("forces")]),
            fact(7, &[Words("statics")]),
            fact(4, &[Text("energy")]),
            fact(8, &[Words("forward_dynamics")]),
            fact(6, &[Words("equations_of_motion")]),
        ],
    },
    Kind {
        name: "conditions",
        aim: 3,
        facts: &[
            fact(3, &[Words("reach_circles")]),
            fact(3, &[Words("share_of_centres")]),
            fact(3, &[Words("reach_distances")]),
            fact(3, &[Words("square_of_centres")]),
            fact(3, &[Words("reach_line")]),
            fact(7, &[Words("not_negative")]),
            fact(2, &[Words("no_root")]),
            fact(4, &[Text("positive"), Name("Positive")]),
            fact(10, &[Text("nonzero"), Name("Nonzero"), Name("NonZero")]),
            fact(5, &[Text("moving"), Name("Moving")]),
            fact(3, &[Text("closed"), Name("Closed")]),
        ],
    },
];

#[test]
fn a_fact_stands_in_few_files() {
    let sources = crates().into_iter().flat_map(|of| of.sources);
    let files: Vec<(String, Said)> =
        sources.map(|source| (source.path, said(&source.file))).collect();
    let mut spread = Vec::new();
    for Kind { name, aim, facts } in KINDS {
        for Fact { spelled, most } in facts {
            let naming =
                files.iter().filter(|(_, said)| spelled.iter().any(|&how| said.names(how)));
            let naming: Vec<&str> = naming.map(|(path, _)| path.as_str()).collect();
            let line =
                format!("{name}: {spelled:?} in {} files, at most {most}, aim {aim}", naming.len());
            println!("{line}\n    {}", naming.join("\n    "));
            assert!(!naming.is_empty(), "{line}");
            if naming.len() > *most {
                spread.push(format!("{line}:\n    {}", naming.join("\n    ")));
            }
        }
    }
    assert!(spread.is_empty(), "facts in more files than before:\n{}", spread.join("\n"));
}
