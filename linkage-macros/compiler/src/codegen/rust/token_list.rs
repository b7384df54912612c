//! Tokens on their way into larger code.
//!
//! Inside the compiler every stream of tokens that is put into another is cloned, joined and
//! dropped by calls across the macro's border; single tokens are handed over together. What is put
//! into code in many places and is not text (`text.rs`) is therefore kept as a list of tokens.

use proc_macro2::{Ident, Punct, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, TokenStreamExt};

/// A few tokens.
#[derive(Clone)]
pub(in crate::codegen) struct Tokens(Vec<TokenTree>);

impl Tokens {
    /// `first::second`
    pub(in crate::codegen) fn path(first: Ident, second: Ident) -> Self {
        let colon = |spacing| TokenTree::from(Punct::new(':', spacing));
        Self(vec![first.into(), colon(Spacing::Joint), colon(Spacing::Alone), second.into()])
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
