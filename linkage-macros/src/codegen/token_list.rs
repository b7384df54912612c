//! Tokens on their way into larger code.
//!
//! Inside the compiler every stream of tokens that is put into another is cloned, joined and
//! dropped by calls across the macro's border; single tokens are handed over together. What is put
//! into code in thousands of places is therefore kept as a list of tokens, which spares a
//! twentieth of the time of checking many mechanisms.

use proc_macro2::{Ident, Punct, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, TokenStreamExt};

/// A few tokens.
#[derive(Clone)]
pub(super) struct Tokens(Vec<TokenTree>);

impl Tokens {
    /// `first::second`
    pub(super) fn path(first: Ident, second: Ident) -> Self {
        let colon = |spacing| TokenTree::from(Punct::new(':', spacing));
        Self(vec![first.into(), colon(Spacing::Joint), colon(Spacing::Alone), second.into()])
    }

    /// The same behind a sign.
    pub(super) fn negated(mut self) -> Self {
        self.0.insert(0, Punct::new('-', Spacing::Alone).into());
        self
    }

    /// Whether they are this identifier alone.
    pub(super) fn is(&self, name: &str) -> bool {
        matches!(&self.0[..], [TokenTree::Ident(ident)] if ident == name)
    }
}

impl From<Ident> for Tokens {
    fn from(name: Ident) -> Self {
        Self(vec![name.into()])
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
