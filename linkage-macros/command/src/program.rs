//! A file with declarations.

use std::fs;
use std::path::{Path, PathBuf};

use linkage_compiler::{Diagnostic, declarations};
use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::messages;
use crate::output::Failure;

/// A Rust program, or a declaration alone.
pub(crate) struct Program {
    path: PathBuf,
    text: String,
}

impl Program {
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        let text = fs::read_to_string(path).map_err(Failure::of(path))?;
        Ok(Self { path: path.to_path_buf(), text })
    }

    /// The declarations, or the one of this name. There is at least one.
    pub(crate) fn declarations(&self, machine: Option<&str>) -> Result<Vec<TokenStream>, Failure> {
        let tokens: TokenStream = self.text.parse().map_err(|error: proc_macro2::LexError| {
            let at = error.span().start();
            let place = format!("{}:{}:{}", self.path.display(), at.line, at.column + 1);
            Failure::Unusable(format!("{place}: this is not a Rust program: {error}"))
        })?;
        let mut found = declarations(tokens.clone());
        if found.is_empty() && is_declaration(&tokens) {
            found.push(tokens);
        }
        if found.is_empty() {
            let why = format!(
                "`{}` holds no `mechanism! {{ … }}`, and is not what stands between its braces",
                self.path.display()
            );
            return Err(Failure::Unusable(why));
        }
        let Some(machine) = machine else { return Ok(found) };
        let names: Vec<String> = found.iter().filter_map(name).collect();
        found.retain(|declaration| name(declaration).is_some_and(|name| name == machine));
        match found.is_empty() {
            false => Ok(found),
            true => Err(Failure::Unusable(format!(
                "`{}` holds no mechanism `{machine}`; there are {}",
                self.path.display(),
                names.join(", ")
            ))),
        }
    }

    /// The results of the declarations where none has a mistake; otherwise all mistakes are reported.
    pub(crate) fn all<T>(
        &self,
        machine: Option<&str>,
        make: impl Fn(TokenStream) -> Result<T, Vec<Diagnostic>>,
    ) -> Result<Vec<T>, Failure> {
        let (mut made, mut is_clean) = (Vec::new(), true);
        for declaration in self.declarations(machine)? {
            match make(declaration) {
                Ok(one) => made.push(one),
                Err(found) => {
                    is_clean = false;
                    self.report(&found);
                }
            }
        }
        if is_clean { Ok(made) } else { Err(Failure::Told) }
    }

    /// Writes mistakes to the standard error output.
    pub(crate) fn report(&self, mistakes: &[Diagnostic]) {
        for mistake in mistakes {
            eprintln!("{}", messages::text(mistake, &self.path, &self.text));
        }
    }
}

/// True if a file is what stands between the braces of `mechanism! { … }`: a struct with its docs, and nothing behind it.
fn is_declaration(tokens: &TokenStream) -> bool {
    let is_brace = |tree: &TokenTree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    let mut trees = tokens.clone().into_iter().skip_while(|tree| match tree {
        TokenTree::Ident(word) => word == "pub",
        TokenTree::Punct(sign) => sign.as_char() == '#',
        TokenTree::Group(group) => group.delimiter() != Delimiter::Brace,
        TokenTree::Literal(_) => false,
    });
    let is_struct = trees.next().is_some_and(|tree| tree.to_string() == "struct");
    is_struct && trees.by_ref().any(|tree| is_brace(&tree)) && trees.next().is_none()
}

/// The name of a declaration: the word behind `struct`.
fn name(declaration: &TokenStream) -> Option<String> {
    let mut trees = declaration.clone().into_iter();
    trees.by_ref().find(|tree| matches!(tree, TokenTree::Ident(word) if word == "struct"))?;
    trees.next().map(|tree| tree.to_string())
}
