//! Rewrites that make a program smaller without changing its meaning.
//!
//! A rewrite is an identity of real numbers wherever both sides are defined, and never adds a
//! rounding: x·0, x + 0, x·1, x − x and −(−x) are rewritten; x/x, reassociation and distribution
//! are not, except among constants, which are exact, and where a pass says why and what it costs.
//! Nothing here knows a mechanism.

pub mod affine;
pub mod collect;
pub mod conditions;
pub mod contract;
pub mod fold;
pub mod product_sums;
pub mod simplify;

use crate::interface::entries::EntryPoint;
use crate::ir::construct::{Rule, rebuild};
use crate::ir::graph::{Graph, Id};
use crate::ir::program::Program;

/// The rules under which the equations are written down. Afterwards no operation has only
/// constants as operands, and no operand is a neutral or annihilating one.
pub const RULES: &[Rule] = &[fold::fold_constants, simplify::simplify];

/// The passes in order.
pub fn optimise(program: &Program) -> Program {
    // Among two products that are added, the one that is known last is added last.
    let chained = product_sums::negate_within(&product_sums::chain_products(&shortened(program)));
    // A product that only a sum uses is part of a fused operation.
    contract::fuse_products(&chained)
}

/// The passes before products are contracted into sums.
pub fn shortened(program: &Program) -> Program {
    // Nothing is left that no entry needs.
    let needed = rebuild(program, RULES);
    // Distances of cranks' pins are affine in the angle's cosine and sine.
    let needed = affine::square_distances(&needed);
    // Groups on the same triangle share what they compute in the equations of motion,
    let needed = conditions::ask_once(&needed);
    // and links that move alike are one term there.
    collect::collect_multiples(&needed)
}

/// The program with the sinks of its equations of motion made anew, behind everything else, which stands
/// where it stood: for these, formulas of many groups are put together, and what they have in common is
/// worth looking for.
fn in_dynamics(program: &Program, mut remake: impl FnMut(&mut Graph, &[Id]) -> Vec<Id>) -> Program {
    let mut new = program.clone();
    for answer in &mut new.answers {
        if answer.entry.is_some_and(EntryPoint::is_about_dynamics) {
            answer.sinks = remake(&mut new.graph, &answer.sinks);
        }
    }
    new
}
