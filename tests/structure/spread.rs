//! The files that tell one fact of the domain: what somebody who adds another of its kind has to
//! touch, at most.
//!
//! A file tells a fact if it defines something of its name (a function, a type, a variant, a field), tells
//! it from others of its kind (in a pattern or a comparison), lists it (in an array), fills or takes apart
//! a record with a field of its name, or spells it in a text or a macro. Each of these wants one more for
//! one more of the kind. A file that only uses a fact goes on as it is: it calls the function, makes a
//! value of the variant, has one as an argument, reads the field or imports the name. So formulas do not
//! count, nor do docs and comments. A name counts by its words, however they are joined: `rrr`,
//! `leave_rrr`, `Rrr`, "an `rrr`".

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream, TokenTree};
use syn::visit::{self, Visit};
use syn::{
    Attribute, BinOp, Expr, ExprArray, ExprBinary, Field, FieldPat, FieldValue, File, Generics,
    ImplItemConst, Item, ItemUse, LitStr, Macro, Member, Pat, Path, Signature, TraitItemConst,
    Variant,
};

use super::sources::crates;

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

/// Names and texts outside the docs of a file.
#[derive(Default)]
pub(crate) struct Said {
    names: BTreeSet<String>,
    texts: BTreeSet<String>,
    words: BTreeSet<Vec<String>>,
}

/// The names and texts of a file.
pub(crate) fn said(file: &File) -> Said {
    let mut said = Said::default();
    said.visit_file(file);
    said
}

impl Said {
    fn tokens(&mut self, tokens: TokenStream) {
        let (mut is_method, mut is_attribute) = (false, false);
        for token in tokens {
            match &token {
                TokenTree::Group(_) if is_attribute => {}
                TokenTree::Group(group) => self.tokens(group.stream()),
                TokenTree::Ident(name) if !is_method => self.name(name),
                TokenTree::Literal(literal) => self.literal(literal),
                _ => {}
            }
            let is = |sign| matches!(&token, TokenTree::Punct(own) if own.as_char() == sign);
            (is_method, is_attribute) = (is('.'), is('#'));
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

impl Said {
    /// Every name of a path that is told from others or listed.
    fn path(&mut self, path: &Path) {
        path.segments.iter().for_each(|segment| self.name(&segment.ident));
    }

    /// An element of a list, or a side of a comparison.
    fn element(&mut self, element: &Expr) {
        match element {
            Expr::Path(element) => self.path(&element.path),
            Expr::Reference(element) => self.element(&element.expr),
            Expr::Call(call) => self.element(&call.func),
            _ => {}
        }
    }
}

impl<'ast> Visit<'ast> for Said {
    fn visit_attribute(&mut self, _: &'ast Attribute) {}

    fn visit_item_use(&mut self, _: &'ast ItemUse) {}

    fn visit_generics(&mut self, _: &'ast Generics) {}

    fn visit_item(&mut self, item: &'ast Item) {
        match item {
            Item::Const(item) => self.name(&item.ident),
            Item::Enum(item) => self.name(&item.ident),
            Item::Mod(item) => self.name(&item.ident),
            Item::Static(item) => self.name(&item.ident),
            Item::Struct(item) => self.name(&item.ident),
            Item::Trait(item) => self.name(&item.ident),
            Item::Type(item) => self.name(&item.ident),
            _ => {}
        }
        visit::visit_item(self, item);
    }

    fn visit_signature(&mut self, signature: &'ast Signature) {
        self.name(&signature.ident);
    }

    fn visit_impl_item_const(&mut self, item: &'ast ImplItemConst) {
        self.name(&item.ident);
        visit::visit_impl_item_const(self, item);
    }

    fn visit_trait_item_const(&mut self, item: &'ast TraitItemConst) {
        self.name(&item.ident);
        visit::visit_trait_item_const(self, item);
    }

    fn visit_variant(&mut self, variant: &'ast Variant) {
        self.name(&variant.ident);
        visit::visit_variant(self, variant);
    }

    fn visit_field(&mut self, field: &'ast Field) {
        field.ident.iter().for_each(|name| self.name(name));
    }

    fn visit_field_value(&mut self, field: &'ast FieldValue) {
        if let Member::Named(name) = &field.member {
            self.name(name);
        }
        visit::visit_field_value(self, field);
    }

    fn visit_field_pat(&mut self, field: &'ast FieldPat) {
        if let Member::Named(name) = &field.member {
            self.name(name);
        }
        visit::visit_field_pat(self, field);
    }

    /// A small letter begins a name that the pattern itself makes.
    fn visit_pat(&mut self, pattern: &'ast Pat) {
        match pattern {
            Pat::Ident(pattern) if !pattern.ident.to_string().starts_with(char::is_lowercase) => {
                self.name(&pattern.ident);
            }
            Pat::Path(pattern) => self.path(&pattern.path),
            Pat::Struct(pattern) => self.path(&pattern.path),
            Pat::TupleStruct(pattern) => self.path(&pattern.path),
            _ => {}
        }
        visit::visit_pat(self, pattern);
    }

    fn visit_expr_binary(&mut self, comparison: &'ast ExprBinary) {
        if matches!(comparison.op, BinOp::Eq(_) | BinOp::Ne(_)) {
            self.element(&comparison.left);
            self.element(&comparison.right);
        }
        visit::visit_expr_binary(self, comparison);
    }

    fn visit_expr_array(&mut self, list: &'ast ExprArray) {
        list.elems.iter().for_each(|element| self.element(element));
        visit::visit_expr_array(self, list);
    }

    fn visit_lit_str(&mut self, text: &'ast LitStr) {
        self.text(&text.value());
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        self.tokens(call.tokens.clone());
    }
}

/// The spelling of a fact.
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

const KINDS: [Kind; 9] = [
    // Also the texts of an effort, an output or a member of the same name.
    Kind {
        name: "statements",
        aim: 8,
        facts: &[
            fact(20, &[Name("Stop"), Name("StopStatement"), Text("stop")]),
            fact(21, &[Name("Spring"), Name("SpringStatement"), Text("spring")]),
            fact(10, &[Name("Friction"), Name("FrictionStatement"), Text("friction")]),
            fact(5, &[Name("Gravity"), Name("GravityStatement"), Text("gravity")]),
        ],
    },
    Kind {
        name: "outputs",
        aim: 9,
        facts: &[
            fact(6, &[Name("Pole"), Text("pole")]),
            fact(9, &[Name("Ratio")]),
            fact(9, &[Name("Transmission")]),
        ],
    },
    Kind {
        name: "efforts",
        aim: 9,
        facts: &[
            fact(6, &[Name("Losses")]),
            fact(10, &[Name("Shaking")]),
            fact(9, &[Name("Gap")]),
            fact(8, &[Name("PinFriction")]),
        ],
    },
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
            // Each has its interval and its slope in `prove/function_ranges.rs`, where a proof follows it, and its size
            // in `lower/always_finite`, by which structured text meets no infinity: the two are to become one.
            fact(5, &[Name("Abs"), Text("abs")]),
            fact(5, &[Name("Max"), Text("max")]),
            // These four are operations of the formulas, too: what is known of roots and of turned vectors
            // stands where it is used, and a function that expressions alone call has none of it. And `sin`
            // and `cos` are what the sine and cosine of an angle are called everywhere.
            fact(25, &[Name("Sqrt"), Name("sqrt")]),
            fact(20, &[Name("Hypot"), Name("hypot")]),
            fact(19, &[Name("Sin"), Text("sin")]),
            fact(20, &[Name("Cos"), Text("cos")]),
            fact(9, &[Words("tan")]),
            fact(11, &[Words("asin")]),
            fact(10, &[Words("acos")]),
            fact(11, &[Words("atan")]),
            fact(12, &[Words("atan2")]),
            fact(8, &[Name("Tanh"), Words("tanh")]),
            fact(8, &[Name("Ln"), Words("ln")]),
        ],
    },
    Kind {
        name: "modes",
        aim: 6,
        facts: &[
            fact(4, &[Name("Side")]),
            fact(5, &[Text("left"), Text("right")]),
            fact(3, &[Name("Sense")]),
            fact(5, &[Text("ahead"), Text("behind")]),
            fact(6, &[Name("Trend")]),
            fact(3, &[Text("rising"), Text("falling")]),
        ],
    },
    Kind {
        name: "entry points",
        aim: 4,
        facts: &[
            // The run-time crate's traits ask for these four; what implements the traits names them again.
            fact(3, &[Text("position")]),
            fact(5, &[Text("velocity")]),
            fact(2, &[Text("motion")]),
            fact(8, &[Words("coefficients")]),
            fact(5, &[Words("margins")]),
            fact(3, &[Text("forces")]),
            fact(5, &[Words("statics")]),
            fact(5, &[Text("energy")]),
            fact(5, &[Words("forward_dynamics")]),
            fact(
                4,
                &[
                    Name("EquationsOfMotion"),
                    Name("OfEquationsOfMotion"),
                    Name("equations_of_motion"),
                ],
            ),
        ],
    },
    Kind {
        name: "conditions",
        aim: 3,
        facts: &[
            fact(2, &[Words("reach_circles")]),
            fact(2, &[Words("share_of_centres")]),
            fact(2, &[Words("reach_distances")]),
            fact(2, &[Words("square_of_centres")]),
            fact(2, &[Words("reach_line")]),
            fact(2, &[Name("NotNegative")]),
            fact(2, &[Words("no_root")]),
            fact(3, &[Text("positive"), Name("Positive")]),
            fact(3, &[Text("nonzero"), Name("Nonzero"), Name("NonZero")]),
            fact(3, &[Text("moving"), Name("Moving")]),
            fact(2, &[Text("closed"), Name("Closed")]),
        ],
    },
    Kind {
        name: "solved at run time",
        aim: 5,
        facts: &[fact(5, &[Name("Amounts")]), fact(3, &[Name("RootSearch")])],
    },
];

#[test]
fn a_fact_stands_in_few_files() {
    let files: Vec<_> = crates().iter().flat_map(|of| &of.sources).collect();
    let mut spread = Vec::new();
    for Kind { name, aim, facts } in KINDS {
        for Fact { spelled, most } in facts {
            let naming = files.iter().filter(|of| spelled.iter().any(|&how| of.said.names(how)));
            let naming: Vec<&str> = naming.map(|of| of.path.as_str()).collect();
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
