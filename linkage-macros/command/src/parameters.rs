//! Parameters that have other values than the declaration says: `--set crank=90mm`.

use proc_macro2::{Delimiter, Group, Span, TokenStream, TokenTree};

use crate::output::Failure;
use crate::program::Declaration;

/// A parameter and its value, as in the language.
pub(crate) struct Setting {
    /// The text `crank=90mm`.
    pub text: String,
    name: String,
    value: TokenStream,
    /// The tokens of the value are told from those of the file by it.
    source: String,
}

impl Setting {
    pub(crate) fn read(text: &str) -> Result<Self, Failure> {
        let unusable = |why: &str| Failure::Unusable(format!("`--set {text}`: {why}"));
        let tokens: TokenStream = text
            .parse()
            .map_err(|_| unusable("a value is written as in the language, `crank=90mm`"))?;
        let mut trees = tokens.into_iter();
        let (Some(TokenTree::Ident(name)), Some(TokenTree::Punct(sign))) =
            (trees.next(), trees.next())
        else {
            return Err(unusable("write a parameter and its value, `crank=90mm`"));
        };
        let value: TokenStream = trees.collect();
        let ends =
            |tree: TokenTree| matches!(tree, TokenTree::Punct(sign) if sign.as_char() == ';');
        if sign.as_char() != '=' || value.is_empty() || value.clone().into_iter().any(ends) {
            return Err(unusable("write a parameter and its value, `crank=90mm`"));
        }
        let source = name.span().file();
        Ok(Self { text: text.to_string(), name: name.to_string(), value, source })
    }

    /// True if a token is one of the value.
    pub(crate) fn holds(&self, token: Span) -> bool {
        token.file() == self.source
    }
}

/// Gives the parameters of declarations their values. Each has to be a parameter of one at least.
pub(crate) fn set(declarations: &mut [Declaration], settings: &[Setting]) -> Result<(), Failure> {
    for (at, setting) in settings.iter().enumerate() {
        let name = &setting.name;
        if settings[..at].iter().any(|other| other.name == *name) {
            return Err(Failure::Unusable(format!("`--set` gives `{name}` two values")));
        }
        let mut is_known = false;
        let mut names = Vec::new();
        for declaration in declarations.iter_mut() {
            let mut given = Given { setting, is_known: false, names: Vec::new() };
            declaration.tokens = given.declaration(&declaration.tokens);
            is_known |= given.is_known;
            names.extend(given.names);
        }
        if !is_known {
            let there_are = match names.is_empty() {
                true => "there are none".to_string(),
                false => format!("there are {}", names.join(", ")),
            };
            let why =
                format!("`--set {}`: no parameter is named `{name}`; {there_are}", setting.text);
            return Err(Failure::Unusable(why));
        }
    }
    Ok(())
}

/// A setting on its way through a declaration, and the names of the parameters that it passes.
struct Given<'s> {
    setting: &'s Setting,
    is_known: bool,
    names: Vec<String>,
}

impl Given<'_> {
    /// A declaration: its statements stand in the last braces.
    fn declaration(&mut self, tokens: &TokenStream) -> TokenStream {
        let trees = tokens.clone().into_iter().map(|tree| match tree {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let mut own = Group::new(Delimiter::Brace, self.statements(group.stream()));
                own.set_span(group.span());
                TokenTree::Group(own)
            }
            tree => tree,
        });
        trees.collect()
    }

    /// Statements with another value between `=` and `;` of `param name = value;`.
    fn statements(&mut self, tokens: TokenStream) -> TokenStream {
        let mut given = Vec::new();
        let mut trees = tokens.into_iter().peekable();
        while let Some(tree) = trees.next() {
            let is_param = matches!(&tree, TokenTree::Ident(word) if word == "param");
            given.push(tree);
            let Some(TokenTree::Ident(name)) = trees.peek() else { continue };
            if !is_param {
                continue;
            }
            let name = name.to_string();
            let is_meant = name == self.setting.name;
            self.names.push(name);
            if !is_meant {
                continue;
            }
            let is = |sign| move |tree: &TokenTree| matches!(tree, TokenTree::Punct(own) if own.as_char() == sign);
            while let Some(tree) = trees.next_if(|tree| !is('=')(tree) && !is(';')(tree)) {
                given.push(tree);
            }
            if let Some(equals) = trees.next_if(is('=')) {
                given.push(equals);
                given.extend(self.setting.value.clone());
                while trees.next_if(|tree| !is(';')(tree)).is_some() {}
                self.is_known = true;
            }
        }
        given.into_iter().collect()
    }
}
