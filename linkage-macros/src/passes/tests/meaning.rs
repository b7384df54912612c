//! A program means the same before and after every pass, in 55 digits.

use crate::equations;
use crate::equations::tests::declarations::VARIANTS;
use crate::ir::construct::{Rule, rebuild};
use crate::ir::interpret::Given;
use crate::ir::program::Program;
use crate::oracle::{Digits, defaults, mechanism, values};
use crate::passes::{RULES, affine, contract, fold, optimise, simplify};

#[test]
fn no_pass_changes_a_value() {
    type Pass = fn(&Program) -> Program;
    let passes: [(&str, Pass); 6] = [
        ("fold", |program| rebuild(program, &[fold::fold_constants as Rule])),
        ("simplify", |program| rebuild(program, &[simplify::simplify as Rule])),
        ("both", |program| rebuild(program, RULES)),
        ("affine", affine::square_distances),
        ("fuse", contract::fuse_products),
        ("all", optimise),
    ];
    for variant in VARIANTS {
        let mechanism = mechanism(variant.source);
        let given = Given {
            inputs: variant.inputs.iter().map(|q| q.map(Digits::float)).collect(),
            params: defaults(&mechanism),
        };
        let raw = equations::derive(&mechanism, &[]);
        let expected = values(&raw, "motion", &given);
        for (name, pass) in passes {
            let passed = pass(&raw);
            assert!(passed.graph.len() <= raw.graph.len(), "{name} made {} larger", variant.name);
            let found = values(&passed, "motion", &given);
            for (found, expected) in found.iter().zip(&expected) {
                // Both are good to about 120 digits less the conditioning of the pose.
                assert!(found.apart(expected) < 1e-55, "{name} changed {}", variant.name);
            }
        }
    }
}
