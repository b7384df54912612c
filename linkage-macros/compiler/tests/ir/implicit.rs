//! Tests of `ir/implicit`.

use crate::ir::operations::Operations;
pub(crate) use linkage_compiler::ir::implicit::*;

fn operations_of(joints: &[bool]) -> Operations {
    let joints = joints.iter().map(|&is_guide| (String::new(), is_guide)).collect();
    let none = Contacts { joints, equations: vec![], positive: vec![], small: vec![] };
    Implicit::from(none).cost(0)
}

/// A step on n contacts takes 2n products for reactions, 2n for slopes and one for what is solved, of each contact;
/// its elimination Σ k² and on both sides n (n − 1). Behind four steps come n + 2 products for each of two components
/// of a pin, the elimination once more, and 3n + 1 products of each contact.
#[test]
fn amounts_cost_four_steps_and_a_bound() {
    // One guide: 4 · 5 + 4. Two pins and a guide: 4 · (39 + 5 + 6) + 20 + 5 + 30.
    for (joints, products, divisions, roots) in
        [(&[true][..], 24, 4, 0), (&[false, false, true], 255, 35, 18)]
    {
        let [additions, multiplications] = [products; 2];
        let none = Operations::default();
        let expected = Operations { additions, multiplications, divisions, roots, ..none };
        assert_eq!(operations_of(joints), expected, "{joints:?}");
    }
}
