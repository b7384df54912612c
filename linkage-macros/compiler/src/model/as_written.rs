//! Expressions as they are written, for messages.

use crate::syntax::tree::{BinaryOp, Expr, ExprKind};

/// An expression as it is written.
pub(in crate::model) fn text(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Number { digits, units } => match &units[..] {
            [] => digits.clone(),
            [(unit, 1)] => format!("{digits}{unit}"),
            units => {
                let units = units.iter().map(|(unit, power)| format!("{unit}^{power}"));
                format!("{digits}({})", units.collect::<Vec<_>>().join("*"))
            }
        },
        ExprKind::Name(name) => name.to_string(),
        ExprKind::Member(owner, member) => format!("{owner}.{member}"),
        ExprKind::Part(path) => path.each_ref().map(ToString::to_string).join("."),
        ExprKind::Negate(inner) => format!("-{}", operand(inner)),
        ExprKind::Chain(first, rest) => {
            let mut text = operand(first);
            for (operator, operand_of) in rest {
                let sign = match operator {
                    BinaryOp::Add => '+',
                    BinaryOp::Sub => '-',
                    BinaryOp::Mul => '*',
                    BinaryOp::Div => '/',
                };
                text += &format!(" {sign} {}", operand(operand_of));
            }
            text
        }
        ExprKind::Call(function, arguments) => {
            let arguments: Vec<_> = arguments.iter().map(text).collect();
            format!("{function}({})", arguments.join(", "))
        }
        ExprKind::Mistake => "…".to_string(),
    }
}

/// An operand, in parentheses where it is a chain itself.
fn operand(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Chain(..) => format!("({})", text(expr)),
        _ => text(expr),
    }
}
