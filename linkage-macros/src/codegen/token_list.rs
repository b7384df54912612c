//! Tokens on their way into larger code.
//!
//! Inside the compiler every stream of tokens that is put into another is cloned, joined and
//! dropped by calls across the macro's border; single tokens are handed over together. What is put
//! into code in thousands of places is therefore kept as a list of tokens, which spares a
//! twentieth of the time of checking many mechanisms.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, TokenStreamExt};

/// A few tokens.
#[derive(Clone, Default)]
pub(super) struct Tokens(Vec<TokenTree>);

impl Tokens {
    /// These and the others.
    pub(super) fn followed_by(mut self, others: Self) -> Self {
        self.0.extend(others.0);
        self
    }

    /// `function(first, second)`
    pub(super) fn call(function: Self, operands: impl IntoIterator<Item = Self>) -> Self {
        let mut list = Vec::new();
        for operand in operands {
            if !list.is_empty() {
                list.push(Punct::new(',', Spacing::Alone).into());
            }
            list.extend(operand.0);
        }
        let operands = Group::new(Delimiter::Parenthesis, list.into_iter().collect());
        function.followed_by(Self(vec![operands.into()]))
    }

    /// `first::second`
    pub(super) fn path(first: Ident, second: Ident) -> Self {
        let colon = |spacing| TokenTree::from(Punct::new(':', spacing));
        Self(vec![first.into(), colon(Spacing::Joint), colon(Spacing::Alone), second.into()])
    }
}

impl From<Ident> for Tokens {
    fn from(name: Ident) -> Self {
        Self(vec![name.into()])
    }
}

impl From<Literal> for Tokens {
    fn from(literal: Literal) -> Self {
        Self(vec![literal.into()])
    }
}

impl From<TokenStream> for Tokens {
    fn from(stream: TokenStream) -> Self {
        Self(stream.into_iter().collect())
    }
}

impl ToTokens for Tokens {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.append_all(&self.0);
    }
}
