//! The effect of a dimension: the declaration with each of its lengths made a parameter, whose adjoints are slopes.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::quote;
use syn::ext::IdentExt;

use crate::diagnostics::{Diagnostics, Failure};
use crate::interface::entries::EntryPoint;
use crate::ir::graph::{Id, Node};
use crate::ir::program::Program;
use crate::model::mechanism::{Mechanism, ParamKind};
use crate::prove::adjoint::Adjoints;
use crate::prove::goal::Goal;
use crate::prove::one_box::OneBox;
use crate::prove::premises::{Leaf, Premises};
use crate::prove::sloped::InputBox;
use crate::prove::width::Precision;
use crate::syntax::anatomy::KEYWORDS;
use crate::{equations, model, passes, syntax};

/// Boxes over which bounds are proved.
pub(super) struct ProvedBoxes<'a> {
    pub given: &'a Premises,
    pub boxes: Vec<Vec<[f64; 2]>>,
}

/// The mechanism whose lengths are parameters.
pub(super) struct Sensitive {
    mechanism: Mechanism,
    program: Program,
    /// The lengths that were numbers: the first parameters.
    lengths: Vec<String>,
}

/// A length that is written as a number.
struct WrittenLength {
    /// Whose it is, and the number.
    label: String,
    literal: TokenTree,
}

/// Statements beside those of groups whose numbers are dimensions.
const PLACES: [&str; 5] = ["ground", "point", "guide", "pin", "link"];

const LENGTHS: [&str; 6] = ["um", "mm", "cm", "in", "ft", "m"];

/// Nobody reads the slopes of a declaration with more lengths.
const MOST: usize = 40;

impl Sensitive {
    /// None where the numbers of a declaration cannot stand in parameters.
    pub(super) fn of(source: &TokenStream) -> Option<Self> {
        let mut left_out: Vec<(usize, usize)> = Vec::new();
        // A number that has to be one is left out.
        for _ in 0..4 {
            let mut found = Vec::new();
            let tokens = declaration(source, &left_out, &mut found)?;
            if found.len() > MOST {
                return None;
            }
            let mut diagnostics = Diagnostics::new();
            let tree = syntax::parse(tokens, &mut diagnostics);
            let mechanism = tree.and_then(|tree| model::resolve(&tree, &mut diagnostics).ok());
            match (mechanism, diagnostics.finish()) {
                (Some(mechanism), Ok(())) => {
                    let derived = equations::derive(&mechanism, passes::RULES);
                    let program = passes::optimise(&derived);
                    let lengths = found.into_iter().map(|written| written.label).collect();
                    return Some(Self { mechanism, program, lengths });
                }
                (_, Err(Failure(mistakes))) => {
                    let places = mistakes.iter().map(|mistake| place(mistake.first));
                    left_out.extend(places);
                }
                (None, Ok(())) => return None,
            }
        }
        None
    }

    /// By result, what a change of each length and of each parameter by one changes at most.
    pub(super) fn at(
        &self,
        point: EntryPoint,
        looked: &ProvedBoxes<'_>,
    ) -> Vec<Vec<(String, f64)>> {
        let answer = self.program.answers.iter().find(|answer| answer.entry == Some(point));
        let sinks: &[Id] = answer.map_or(&[], |answer| &answer.sinks);
        let lengths = self.mechanism.params.iter().take(self.lengths.len());
        let decimals = lengths.map(|param| match &param.kind {
            ParamKind::Number { default, .. } => Leaf::Decimal(default.clone()),
            ParamKind::Mode { .. } => unreachable!("lengths are numbers"),
        });
        let params = decimals.chain(looked.given.params.iter().cloned()).collect();
        let given = Premises { params, ..looked.given.clone() };
        let subject = Goal::new(&self.program.graph, (sinks, &[]), &given, Precision::DOUBLE);
        let own = self.mechanism.params.iter().skip(self.lengths.len());
        let own = own.map(|param| param.name.unraw().to_string());
        let names: Vec<String> = self.lengths.iter().cloned().chain(own).collect();
        let mut slopes = vec![vec![0.0f64; names.len()]; sinks.len()];
        for sides in &looked.boxes {
            let values = OneBox::new(&subject, InputBox::new(sides));
            let backwards =
                Adjoints { subject: &subject, frame: &values.frame, values: &values.values };
            for (sink, slopes) in sinks.iter().zip(&mut slopes) {
                if subject.unproved(*sink).is_some() {
                    continue;
                }
                let adjoints = backwards.adjoints(*sink);
                for (place, adjoint) in adjoints.iter().enumerate() {
                    if let (Node::Param(param), Some(adjoint)) = (subject.nodes[place].1, adjoint) {
                        let slope = &mut slopes[param as usize];
                        *slope = slope.max(adjoint.range().magnitude());
                    }
                }
            }
        }
        let named = |slopes: Vec<f64>| names.iter().cloned().zip(slopes).collect();
        slopes.into_iter().map(named).collect()
    }
}

/// Where a token begins.
fn place(span: Span) -> (usize, usize) {
    let start = span.start();
    (start.line, start.column)
}

/// The declaration with its lengths as parameters; none where it has no braces.
fn declaration(
    source: &TokenStream,
    left_out: &[(usize, usize)],
    found: &mut Vec<WrittenLength>,
) -> Option<TokenStream> {
    let mut trees: Vec<TokenTree> = source.clone().into_iter().collect();
    let TokenTree::Group(body) = trees.pop()? else { return None };
    let mut statement: Vec<TokenTree> = Vec::new();
    let mut rest = TokenStream::new();
    for tree in body.stream() {
        let is_brace = |tree: &TokenTree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
        let ends =
            is_brace(&tree) || matches!(&tree, TokenTree::Punct(sign) if sign.as_char() == ';');
        statement.push(tree);
        if ends {
            rest.extend(of_statement(std::mem::take(&mut statement), left_out, found));
        }
    }
    rest.extend(statement);
    let params = found.iter().enumerate().map(|(at, WrittenLength { literal, .. })| {
        let name = param(at, literal.span());
        quote!(param #name: length = #literal;)
    });
    let stream: TokenStream = params.chain([rest]).collect();
    let before: TokenStream = trees.into_iter().collect();
    Some(
        [before, TokenTree::Group(Group::new(Delimiter::Brace, stream)).into()]
            .into_iter()
            .collect(),
    )
}

fn param(at: usize, span: Span) -> Ident {
    Ident::new(&format!("dimension_{at}"), span)
}

fn of_statement(
    statement: Vec<TokenTree>,
    left_out: &[(usize, usize)],
    found: &mut Vec<WrittenLength>,
) -> TokenStream {
    let words: Vec<String> = (statement.iter())
        .filter_map(|tree| match tree {
            TokenTree::Ident(word) => Some(word.to_string()),
            _ => None,
        })
        .take(2)
        .collect();
    if words.first().is_none_or(|word| !is_of_dimensions(word)) {
        return statement.into_iter().collect();
    }
    // Links stand before their pins, as in `rrr BC(B), DC(D)`.
    let links = statement.windows(2).filter_map(|pair| match pair {
        [TokenTree::Ident(link), TokenTree::Group(pins)]
            if pins.delimiter() == Delimiter::Parenthesis =>
        {
            Some(link.to_string())
        }
        _ => None,
    });
    let links: Vec<String> = links.collect();
    let first = words.get(1).cloned().unwrap_or_default();
    let mut owners = Owners { own: first.clone(), first, links, nth: None };
    replaced(statement.into_iter().collect(), left_out, &mut owners, found)
}

/// True for the first word of a statement whose numbers are dimensions.
fn is_of_dimensions(word: &str) -> bool {
    PLACES.contains(&word) || KEYWORDS.contains(&word)
}

/// Whose a number is.
struct Owners {
    own: String,
    /// The first name of the statement.
    first: String,
    /// The links of a group.
    links: Vec<String>,
    /// Which of the links, in a list with one number for each.
    nth: Option<usize>,
}

impl Owners {
    fn label(&self, number: &str) -> String {
        let link = self.nth.and_then(|nth| self.links.get(nth));
        format!("{}, {number}", link.unwrap_or(&self.own))
    }
}

/// Names of fields, which are no owners.
fn is_field(word: &str) -> bool {
    matches!(
        word,
        "length"
            | "lengths"
            | "offset"
            | "offsets"
            | "slide"
            | "at"
            | "through"
            | "along"
            | "polar"
            | "distances"
            | "on"
            | "angle"
            | "slot"
            | "slots"
            | "mode"
    )
}

fn replaced(
    stream: TokenStream,
    left_out: &[(usize, usize)],
    owners: &mut Owners,
    found: &mut Vec<WrittenLength>,
) -> TokenStream {
    let mut lists = false;
    let one = |tree: TokenTree| match tree {
        TokenTree::Punct(sign) => {
            if let (',', Some(nth)) = (sign.as_char(), &mut owners.nth) {
                *nth += 1;
            }
            TokenTree::Punct(sign)
        }
        TokenTree::Group(group) => {
            owners.nth = lists.then_some(0);
            let inner = replaced(group.stream(), left_out, owners, found);
            owners.nth = None;
            let mut new = Group::new(group.delimiter(), inner);
            new.set_span(group.span());
            TokenTree::Group(new)
        }
        TokenTree::Literal(literal) => {
            let text = literal.to_string();
            let digits = text.trim_end_matches(|letter: char| letter.is_ascii_alphabetic());
            let is_length = LENGTHS.contains(&&text[digits.len()..]);
            if !is_length || left_out.contains(&place(literal.span())) {
                return TokenTree::Literal(literal);
            }
            let name = param(found.len(), literal.span());
            let label = owners.label(&text);
            found.push(WrittenLength { label, literal: TokenTree::Literal(literal) });
            TokenTree::Ident(name)
        }
        TokenTree::Ident(word) => {
            let text = word.to_string();
            lists = matches!(&text[..], "lengths" | "offsets" | "slots");
            owners.own = if is_field(&text) { owners.first.clone() } else { text };
            TokenTree::Ident(word)
        }
    };
    stream.into_iter().map(one).collect()
}
