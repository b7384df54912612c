//! A program as text, one node a line, for tests and for the curious.

use std::fmt::Write;

use crate::interface::entries::EntryPoint;
use crate::ir::graph::{Graph, Id, Node, Path};
use crate::ir::program::Program;

/// The program's nodes and the sinks of its entry points.
pub(crate) fn text(program: &Program) -> String {
    let mut out = String::new();
    for (id, node) in program.graph.iter() {
        let _ = writeln!(out, "{} = {}", name(id), describe(&program.graph, node));
    }
    for answer in &program.answers {
        let sinks: Vec<_> = answer.sinks.iter().map(|&id| name(id)).collect();
        let entry = answer.entry.map_or("drawing", EntryPoint::name);
        let _ = writeln!(out, "{entry}: {}", sinks.join(" "));
    }
    out
}

fn name(id: Id) -> String {
    format!("%{}", id.0)
}

fn describe(graph: &Graph, node: Node) -> String {
    match node {
        Node::Constant(constant) => graph.value(constant).to_string(),
        Node::Low(constant) => format!("low({})", graph.value(constant)),
        Node::Input { input, order } => format!("input {input}{}", "'".repeat(order.into())),
        Node::InputCos(input) => format!("cos(input {input})"),
        Node::InputSin(input) => format!("sin(input {input})"),
        Node::Param(param) => format!("param {param}"),
        Node::Load(load) => format!("load {load}"),
        Node::Drive(input) => format!("drive {input}"),
        Node::Mode(param) => format!("mode {param}"),
        Node::Trial(unknown) => format!("trial of unknown {unknown}"),
        Node::Solved(solve, output, _) => {
            let mut operands = Vec::new();
            graph.for_operands(node, Path::Slow, &mut |id| operands.push(name(id)));
            format!("solved {}.{output} by {}", solve.0, operands.join(" "))
        }
        Node::Guard(value, guard) => {
            let guard = graph.condition(guard);
            format!("{} if {:?} of group {}", name(value), guard.check, guard.group)
        }
        other => {
            let mut operands = Vec::new();
            other.for_operands(&mut |id| operands.push(name(id)));
            format!("{} {}", operation(other), operands.join(" "))
        }
    }
}

fn operation(node: Node) -> &'static str {
    match node {
        Node::Neg(_) => "neg",
        Node::Add(..) => "add",
        Node::Sub(..) => "sub",
        Node::Mul(..) => "mul",
        Node::Div(..) => "div",
        Node::Apply(function, _) | Node::Apply2(function, ..) => function.name(),
        Node::Det(_) => "det",
        Node::Select(_) => "select",
        Node::MulErr(..) => "mul_err",
        Node::AddErr(..) => "add_err",
        Node::Fused(..) => "fused",
        _ => "leaf",
    }
}
