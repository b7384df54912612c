//! Lays the statements of a core out in blocks.
//!
//! rustc's work on a block grows faster than its length, and a debug build keeps a stack slot for
//! every local. A long core is therefore cut into blocks that hand on only what is used later.

use std::collections::HashMap;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::locals::Locals;
use crate::ir::graph::Id;

/// A `let` of a core.
#[derive(Default)]
pub(super) struct Statement {
    pub defines: Vec<Id>,
    /// The locals it reads.
    pub uses: Vec<Id>,
    pub code: TokenStream,
}

/// The most statements that stand in one block.
const LONGEST: usize = 64;

/// The statements in blocks. The locals in `kept` stay in scope.
pub(super) fn lay_out(statements: &[Statement], kept: &[Id], locals: &Locals) -> TokenStream {
    let blocks: Vec<&[Statement]> = statements.chunks(LONGEST).collect();
    if let [only] = &blocks[..] {
        return lines(only);
    }
    let last_use = last_uses(&blocks, kept);
    let mut code = TokenStream::new();
    for (index, block) in blocks.iter().enumerate() {
        let handed_on: Vec<Ident> = block
            .iter()
            .flat_map(|statement| &statement.defines)
            .filter(|id| last_use.get(id).is_some_and(|&last| last > index))
            .map(|&id| locals.name(id))
            .collect();
        let (pattern, lines) = (pattern(&handed_on), lines(block));
        code.extend(quote!(let #pattern = { #lines #pattern };));
    }
    code
}

/// The last block in which each local is read.
fn last_uses(blocks: &[&[Statement]], kept: &[Id]) -> HashMap<Id, usize> {
    let mut last = HashMap::new();
    for (index, block) in blocks.iter().enumerate() {
        for id in block.iter().flat_map(|statement| &statement.uses) {
            last.insert(*id, index);
        }
    }
    last.extend(kept.iter().map(|&id| (id, usize::MAX)));
    last
}

fn lines(block: &[Statement]) -> TokenStream {
    block.iter().map(|statement| statement.code.clone()).collect()
}

/// A tuple, or the bare name of a single local.
fn pattern(names: &[Ident]) -> TokenStream {
    match names {
        [only] => quote!(#only),
        _ => quote!((#(#names),*)),
    }
}

#[cfg(test)]
mod tests {
    use super::super::locals::numbered;
    use super::*;

    /// v0, v1, …, each the sum of its predecessor and of v0.
    fn chain(length: u32) -> Vec<Statement> {
        let statement = |i: u32| {
            let (name, before) = (numbered(Id(i)), numbered(Id(i.saturating_sub(1))));
            Statement {
                defines: vec![Id(i)],
                uses: vec![Id(i.saturating_sub(1)), Id(0)],
                code: quote!(let #name = #before + v0_;),
            }
        };
        (0..length).map(statement).collect()
    }

    #[test]
    fn a_short_core_stays_in_one_piece() {
        let code = lay_out(&chain(64), &[Id(63)], &Locals::default());
        assert_eq!(code.to_string().matches('{').count(), 0);
    }

    #[test]
    fn a_block_hands_on_what_later_blocks_and_the_result_use() {
        let code = lay_out(&chain(130), &[Id(5), Id(129)], &Locals::default()).to_string();
        assert!(code.starts_with("let (v0_ , v5_ , v63_) = {"), "{code}");
        assert!(code.contains("let v127_ = { let v64_ ="), "{code}");
        assert!(code.ends_with(
            "let v129_ = { let v128_ = v127_ + v0_ ; let v129_ = v128_ + v0_ ; v129_ } ;"
        ));
    }
}
