//! The nodes that cost: what each node's own rounding adds to the worst error of a machine, by its adjoint.

use std::collections::HashMap;

use super::drawn::TOPOLOGIES;
use super::{Trial, Worst, draw_of};
use crate::ir::graph::{Graph, Id};
use crate::prove::adjoint::Adjoints;
use crate::prove::computed::{computed, of_node};
use crate::prove::goal::Goal;
use crate::prove::one_box::OneBox;
use crate::prove::sloped::InputBox;
use crate::prove::width::Precision;

/// A node's name, or its operation by the names of its operands.
fn title(graph: &Graph, id: Id) -> String {
    let name = |id: Id| graph.name_of(id).map(|letter| letter.text.clone());
    let operation = || {
        let mut operands = Vec::new();
        graph.node(id).for_operands(&mut |operand| {
            operands.push(name(operand).unwrap_or_else(|| "…".to_string()));
        });
        let kind = format!("{:?}", graph.node(id));
        format!("{} of {}", kind.split(['(', ' ']).next().unwrap_or_default(), operands.join(", "))
    };
    name(id).unwrap_or_else(operation)
}

/// By the names of nodes, the parts of the worst error of an order in `f32`, in ε, along it: first-order terms, whose
/// sum it is but for what errors do to each other.
fn costs(trial: &Trial, order: usize) -> HashMap<String, f64> {
    let (program, given, sinks) = (&trial.case.program, &trial.case.given, &trial.case.sinks);
    let found = trial.generated::<f32>(Precision::SINGLE, false);
    let Worst { error, pose, numbers, largest } = trial.worst(&found, order);
    let at = [trial.poses[pose]];
    let narrow = Goal::new(&program.graph, (sinks, &[]), given, Precision::SINGLE);
    let wide = Goal::new(&program.graph, (sinks, &[]), given, Precision::DOUBLE);
    let values: Vec<f64> =
        computed::<f32>(&narrow, &at, false, None).into_iter().map(f64::from).collect();
    let point = OneBox::new(&wide, InputBox::new(&[[at[0], at[0]]]));
    let backwards = Adjoints { subject: &wide, frame: &point.frame, values: &point.values };
    let mut costs = HashMap::new();
    for k in numbers {
        let adjoints = backwards.adjoints(sinks[k]);
        let off = (found[pose][k] - trial.truth[pose][k][0]) / largest;
        for (place, adjoint) in adjoints.iter().enumerate() {
            let Some(adjoint) = adjoint else { continue };
            let (id, node) = wide.nodes[place];
            let own = values[place] - of_node::<f64>(&wide, &values, node, &at, false);
            let slope = (adjoint.range().low + adjoint.range().high) / 2.0;
            let cost = own * slope / largest * off / error / f64::from(f32::EPSILON);
            *costs.entry(title(&program.graph, id)).or_insert(0.0) += cost;
        }
    }
    // Errors are small against what makes them: a thousandth where none is multiplied by more than a thousand ε⁻¹.
    let (sum, error) = (costs.values().sum::<f64>(), error / f64::from(f32::EPSILON));
    assert!((sum - error).abs() <= 1e-3 * error, "{sum} of {error}: {}", trial.machine.source());
    costs
}

/// Prints those that cost most over some machines.
#[test]
fn errors_are_what_nodes_cost() {
    const MACHINES: usize = 6;
    for topology in TOPOLOGIES {
        let mut draw = draw_of(topology);
        let trials: Vec<Trial> =
            (0..MACHINES).map(|_| Trial::of(&mut draw, topology, Precision::SINGLE, 100)).collect();
        for (order, name) in ["position", "velocity", "acceleration"].into_iter().enumerate() {
            let mut all: HashMap<String, f64> = HashMap::new();
            for (title, cost) in trials.iter().flat_map(|trial| costs(trial, order)) {
                *all.entry(title).or_default() += cost / MACHINES as f64;
            }
            let mut all: Vec<_> = all.into_iter().collect();
            all.sort_by(|a, b| b.1.total_cmp(&a.1));
            let most: Vec<String> =
                all.iter().take(6).map(|(title, cost)| format!("{title} {cost:.2}")).collect();
            println!("{topology:?}, {name}: {}", most.join("; "));
        }
    }
}
