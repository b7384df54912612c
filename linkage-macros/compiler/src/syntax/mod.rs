//! Tokens and spans into a tree; nothing is resolved here.
//!
//! ```text
//! declaration  docs visibility `struct` NAME `{` statement* `}`
//! statement    `input` NAME,* `:` KIND `;`
//!            | `input` (NAME `=` expression),* `;`
//!            | `input` NAME `{` (NAME (`=` expression)?),* `}`
//!            | `param` NAME (`:` KIND)? `=` expression `;`
//!            | `let` NAME `=` expression `;`
//!            | `unknown` NAME `:` KIND `between` pair `;`
//!            | `solve` NAME `{` expression `=` expression `,` (FIELD `:` expression),* `}`
//!            | `ground` (NAME pair),* `;`
//!            | `pin` (NAME pair),* `;`
//!            | `link` (NAME `(` PIN,* `)` (`on` GUIDE,*)?),* (`;` | `{` FIELD `:` expression `}`)
//!            | `drive` LINK `.` MEMBER (`-` LINK `.` MEMBER)? `=` expression `;`
//!            | `drive` INPUT `by` LOAD `;`
//!            | `guide` NAME (`on` LINK)? `through` (pair | POINT)
//!                                        (`along` expression | `towards` POINT) `;`
//!            | `point` NAME (`on` LINK)? `at` (pair | `polar` pair | `distances` pair SIDE) `;`
//!            | WORD (LINK `(` JOINT `)`),* (`->` PIN)? `{` (FIELD `:` (expression | pair)),* `}`
//!            | action, as `action` has it
//!            | `output` ((NAME `=`)? expression),* `;`
//!            | `numerics` WORD `;` | `crate` `=` path `;` | `export` WORD `;`
//! pair         `(` expression `,` expression `)`
//! expression   `+ - * /`, unary `-`, `(` `)`, NUMBER, NAME, LINK`.`MEMBER, FUNCTION`(`…`)`
//! ```
//!
//! Every list may end in a comma. After a mistake the parser goes on at the next statement (or
//! field, or behind the closing parenthesis), so that all mistakes of a declaration are reported
//! together; a statement that got as far as its name stays in the tree.
//!
//! Which words are kinds, units and functions is not known here; what a group's statement is made of
//! stands in `anatomy`.

mod action;
mod action_slips;
pub mod aftermath;
pub mod anatomy;
mod declaration;
mod drawn_slips;
pub(crate) mod expression;
mod group;
pub mod inputs;
pub mod links;
pub mod number;
pub mod openings;
pub mod recovery;
mod slips;
pub mod solve;
mod statement;
pub mod tokens;
pub mod tree;
mod unit_products;
pub mod words;

use proc_macro2::TokenStream;

use crate::diagnostics::Diagnostics;
use tree::Declaration;

/// Parses a declaration; `None` only where its name could not be found. In a tree with reported
/// mistakes their places are marked, and [`tree::Unread`] holds what may be missing because of
/// them.
pub fn parse(source: TokenStream, diagnostics: &mut Diagnostics) -> Option<Declaration> {
    let mut aftermath = aftermath::Aftermath::default();
    tokens::Parser::new(source, diagnostics, &mut aftermath).declaration()
}
