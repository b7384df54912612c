//! Code as text, for what is long: formulas, and how results are made of their numbers.
//!
//! Every token that is made one by one is several calls, in a compiler that is built without
//! optimisation a few thousand instructions of them; the compiler that runs it reads text in a few
//! hundred. What is written as text has the span of the whole declaration: nothing that a mistake
//! could be reported at, and no argument under a name of the user's (see `Arguments::with_call_site_spans`).
//!
//! Between two signs stands a space where they are no one operator.

use proc_macro2::TokenStream;
use quote::{ToTokens, TokenStreamExt};

/// Code that is being written.
#[derive(Clone, Debug, Default)]
pub struct Text(String);

impl Text {
    /// Code of which much is to follow.
    pub(super) fn long() -> Self {
        Self(String::with_capacity(1 << 14))
    }

    pub fn put(&mut self, code: &str) -> &mut Self {
        self.0.push_str(code);
        self
    }

    pub(super) fn as_str(&self) -> &str {
        &self.0
    }

    pub(super) fn append(&mut self, code: &Self) {
        self.put(&code.0);
    }

    /// The text of a language that is not Rust.
    pub(super) fn into_string(self) -> String {
        self.0
    }

    /// Writes each item in turn, with commas between.
    pub fn list<I>(
        &mut self,
        items: impl IntoIterator<Item = I>,
        mut write: impl FnMut(&mut Self, I),
    ) -> &mut Self {
        let mut is_first = true;
        for item in items {
            if !is_first {
                self.put(", ");
            }
            is_first = false;
            write(self, item);
        }
        self
    }

    /// A field and what is written as its value, once where both have one name.
    pub fn field(&mut self, name: &str, write: impl FnOnce(&mut Self)) {
        self.put(name);
        let end = self.0.len();
        self.put(": ");
        let value = self.0.len();
        write(self);
        if self.0[value..] == *name {
            self.0.truncate(end);
        }
    }
}

impl From<String> for Text {
    fn from(code: String) -> Self {
        Self(code)
    }
}

impl Text {
    fn stream(&self) -> TokenStream {
        #[cfg(feature = "macro")]
        if proc_macro::is_available() {
            // Asked directly: proc-macro2 would read it itself first, at ten times the cost.
            let stream = self.0.parse::<proc_macro::TokenStream>();
            return stream.expect("what is written is code").into();
        }
        self.0.parse().expect("what is written is code")
    }
}

impl ToTokens for Text {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.append_all(Some(self.stream()));
    }

    fn to_token_stream(&self) -> TokenStream {
        self.stream()
    }
}
