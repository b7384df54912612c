//! Parts of statements as text.

use proc_macro2::Ident;

use crate::syntax::tree::{BinaryOp, Expr, ExprKind, GroupFieldValue, GroupStatement};

/// `A, B`
pub(in crate::model) fn names(names: &[Ident]) -> String {
    names.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// `: angle`
pub(in crate::model) fn kind(kind: &Option<Ident>) -> String {
    kind.as_ref().map(|kind| format!(": {kind}")).unwrap_or_default()
}

/// ` on BC`
pub(in crate::model) fn on(on: &Option<Ident>) -> String {
    on.as_ref().map(|on| format!(" on {on}")).unwrap_or_default()
}

/// ` shock`
pub(in crate::model) fn own_name(name: &Option<Ident>) -> String {
    name.as_ref().map(|name| format!(" {name}")).unwrap_or_default()
}

/// `ground A(0, 0);`
pub(in crate::model) fn ground(points: &[(Ident, [Expr; 2])]) -> String {
    let points = points.iter().map(|(name, at)| format!("{name}{}", pair(at)));
    format!("ground {};", points.collect::<Vec<_>>().join(", "))
}

/// `{ length: 1m, angle: theta }`
pub(in crate::model) fn braces(group: &GroupStatement) -> String {
    let fields = group.fields.iter().map(|field| match &field.value {
        GroupFieldValue::One(value) => format!("{}: {}", field.name, text(value)),
        GroupFieldValue::Pair(values) => format!("{}: {}", field.name, pair(values)),
    });
    match fields.collect::<Vec<_>>() {
        fields if fields.is_empty() => "{ }".to_string(),
        fields => format!("{{ {} }}", fields.join(", ")),
    }
}

/// `(x, y)`
pub(in crate::model) fn pair([first, second]: &[Expr; 2]) -> String {
    format!("({}, {})", text(first), text(second))
}

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
