//! The declarations in a program.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::quote;

use crate::syntax::words::in_capitals;

/// Finds the declarations in the tokens of a Rust program: what stands in the braces of each `mechanism! { … }`, at
/// any depth and in the order of the source. One that another macro fills in, with a `$`, is none. A declaration with
/// several sets of inputs is found once for each: `#[inputs(hand)]` in front of it says for which.
///
/// ```
/// let source = "mod arm { mechanism! { struct Arm { input t: angle; } } }";
/// let found = linkage_compiler::declarations(source.parse().expect("these are tokens"));
/// assert_eq!(found.len(), 1);
/// assert!(found[0].to_string().starts_with("struct Arm"));
/// ```
pub fn declarations(source: TokenStream) -> Vec<TokenStream> {
    let mut found = Vec::new();
    add(source, &mut found);
    found
}

fn add(stream: TokenStream, found: &mut Vec<TokenStream>) {
    let mut before = [String::new(), String::new()];
    for tree in stream {
        if let TokenTree::Group(group) = &tree {
            let is_declaration =
                before == ["mechanism", "!"] && group.delimiter() != Delimiter::None;
            match is_declaration && !has_dollar(group.stream()) {
                true => found.extend(by_set(group.stream())),
                false => add(group.stream(), found),
            }
        }
        let [_, last] = before;
        // Brackets are no name, and need no text of all that is in them.
        let is_bracketed =
            matches!(&tree, TokenTree::Group(group) if group.delimiter() != Delimiter::None);
        before = [last, if is_bracketed { String::new() } else { tree.to_string() }];
    }
}

/// The declaration once for each of its named sets of inputs, each marked as that of its set; itself where it has none.
///
/// ```
/// let source = "struct Arm { pin B(1, 0); input motor { a = AB.angle } input hand { x = B.x } }";
/// let found = linkage_compiler::by_set(source.parse().expect("these are tokens"));
/// assert_eq!(found.len(), 2);
/// assert_eq!(linkage_compiler::solver_name(&found[1]).expect("it has a name"), "ArmHand");
/// ```
pub fn by_set(declaration: TokenStream) -> Vec<TokenStream> {
    let Some(TokenTree::Group(body)) = declaration.clone().into_iter().last() else {
        return vec![declaration];
    };
    let body: Vec<_> = body.stream().into_iter().collect();
    let set = |part: &[TokenTree]| match part {
        [TokenTree::Ident(input), TokenTree::Ident(set), TokenTree::Group(group)]
            if input == "input" && group.delimiter() == Delimiter::Brace =>
        {
            Some(set.clone())
        }
        _ => None,
    };
    let sets: Vec<_> = body.windows(3).filter_map(set).collect();
    let marked = sets.iter().map(|set| quote!(#[inputs(#set)] #declaration));
    if sets.is_empty() { vec![declaration] } else { marked.collect() }
}

/// The name of the solver of a declaration: the word behind `struct`, and behind that the name of its set where it is
/// marked as that of one.
pub fn solver_name(declaration: &TokenStream) -> Option<Ident> {
    let (declaration, set) = chosen(declaration.clone());
    let mut trees = declaration.into_iter();
    trees.by_ref().find(|tree| matches!(tree, TokenTree::Ident(word) if word == "struct"))?;
    match (trees.next(), set) {
        (Some(TokenTree::Ident(name)), Some(set)) => Some(driven_by(&name, &set)),
        (Some(TokenTree::Ident(name)), None) => Some(name),
        _ => None,
    }
}

/// The machine and the set of inputs of a declaration that is marked as that of one of several sets.
pub fn machine_and_set(declaration: &TokenStream) -> Option<[Ident; 2]> {
    let (declaration, set) = chosen(declaration.clone());
    Some([solver_name(&declaration)?, set?])
}

/// `FiveBarHand` is the solver of the set `hand`, `FiveBarLeftHand` of `left_hand`.
pub(crate) fn driven_by(machine: &Ident, set: &Ident) -> Ident {
    Ident::new(&format!("{machine}{}", in_capitals(&set.to_string())), machine.span())
}

/// A declaration without the mark of a set, and the set.
pub(crate) fn chosen(declaration: TokenStream) -> (TokenStream, Option<Ident>) {
    let mut trees = declaration.clone().into_iter();
    let (Some(TokenTree::Punct(hash)), Some(TokenTree::Group(mark))) = (trees.next(), trees.next())
    else {
        return (declaration, None);
    };
    let mark: Vec<_> = mark.stream().into_iter().collect();
    match &mark[..] {
        [TokenTree::Ident(inputs), TokenTree::Group(set)]
            if hash.as_char() == '#' && inputs == "inputs" =>
        {
            let set = syn::parse2(set.stream()).ok();
            (trees.collect(), set)
        }
        _ => (declaration, None),
    }
}

fn has_dollar(stream: TokenStream) -> bool {
    stream.into_iter().any(|tree| match tree {
        TokenTree::Group(group) => has_dollar(group.stream()),
        TokenTree::Punct(punct) => punct.as_char() == '$',
        _ => false,
    })
}
