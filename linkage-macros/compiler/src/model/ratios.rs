//! Numbers of rates that belong to the pose: the rate of the only input does not change them, as a quotient of two.

use crate::function::Function;
use crate::syntax::tree::{BinaryOp, Expr, ExprKind};

use crate::model::expr::{Operator, Scalar};
use crate::model::mechanism::Mechanism;
use crate::model::rates::is_rate;
use crate::model::resolved_expr::ResolvedExpr;

/// The growth of a number with the rate of the only input. At k times that rate it is |k|^power times as large, and its
/// sign changes with that of k where it is odd.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Growth {
    power: i32,
    is_odd: bool,
}

/// The growth of what reads no rate.
const NONE: Growth = Growth { power: 0, is_odd: false };
const OF_A_RATE: Growth = Growth { power: 1, is_odd: true };

/// True for a number that reads rates, and is the same at every rate of the only input. What a call gives beside the
/// input is none of a pose.
pub(in crate::model) fn is_of_the_pose(mechanism: &Mechanism, quantity: &ResolvedExpr) -> bool {
    let reads = &quantity.reads;
    let reads_rates_alone = reads.rate && !reads.load && reads.efforts.is_empty();
    reads_rates_alone && mechanism.inputs.len() == 1 && is_steady(mechanism, &quantity.rest)
}

/// True for a number that stays the same where all rates are multiplied by one factor.
pub(in crate::model) fn is_steady(mechanism: &Mechanism, number: &Scalar) -> bool {
    // A law stands on earlier ones: none is walked inside another.
    let mut laws: Vec<Option<Growth>> = Vec::new();
    for law in &mechanism.dynamics.laws {
        laws.push(growth(&law.rest, &laws));
    }
    growth(number, &laws) == Some(NONE)
}

/// The growth of a number, where it has one; `laws` are those of the named expressions that it may stand on.
fn growth(number: &Scalar, laws: &[Option<Growth>]) -> Option<Growth> {
    match number {
        Scalar::Constant(_)
        | Scalar::Input(_)
        | Scalar::Param(_)
        | Scalar::Load(_)
        | Scalar::Pull
        | Scalar::Unknown(_)
        | Scalar::Tracked(..)
        | Scalar::Let(_)
        | Scalar::Slide(_)
        | Scalar::Coordinate(..)
        | Scalar::Distance(_)
        | Scalar::Offset(..)
        | Scalar::Twist(_)
        | Scalar::Effort(..) => Some(NONE),
        Scalar::Rate(_) => Some(OF_A_RATE),
        Scalar::Law(id) => laws[id.index()],
        Scalar::Negate(value) => growth(value, laws),
        Scalar::AboveZero(inner) => growth(&inner.value, laws),
        Scalar::Chain(first, rest) => {
            rest.iter().try_fold(growth(first, laws)?, |left, (operator, operand)| {
                combined(left, *operator, growth(operand, laws)?)
            })
        }
        Scalar::Call(function, arguments) => {
            let arguments: Option<Vec<_>> = arguments.iter().map(|a| growth(a, laws)).collect();
            of_call(*function, &arguments?)
        }
    }
}

fn combined(a: Growth, operator: Operator, b: Growth) -> Option<Growth> {
    let is_odd = a.is_odd != b.is_odd;
    match operator {
        Operator::Add | Operator::Sub => (a == b).then_some(a),
        Operator::Mul => Some(Growth { power: a.power.checked_add(b.power)?, is_odd }),
        Operator::Div => Some(Growth { power: a.power.checked_sub(b.power)?, is_odd }),
    }
}

/// The growth of a function's value: what it does to a factor is known of absolute values and distances alone.
fn of_call(function: Function, arguments: &[Growth]) -> Option<Growth> {
    let (first, last) = (arguments[0], arguments[arguments.len() - 1]);
    if function.is_a_size() && first.power == last.power {
        return Some(Growth { is_odd: false, ..first });
    }
    arguments.iter().all(|argument| *argument == NONE).then_some(NONE)
}

/// True if rates stand on both sides of a division, as far as it shows.
pub(in crate::model) fn is_a_quotient_of_rates(value: &Expr) -> bool {
    fn holds_rate(part: &Expr) -> bool {
        is_rate(part) || part.parts().any(holds_rate)
    }
    let ExprKind::Chain(first, rest) = &value.kind else { return false };
    let divisor = rest.iter().any(|(operator, of)| *operator == BinaryOp::Div && holds_rate(of));
    divisor && holds_rate(first)
}

/// The reason why a number of rates alone stands in no pose.
pub(in crate::model) fn depends_on_rates(
    mechanism: &Mechanism,
    value: &Expr,
    quantity: &ResolvedExpr,
) -> Option<&'static str> {
    if quantity.reads.load || !quantity.reads.efforts.is_empty() {
        return None;
    }
    match mechanism.inputs.len() {
        1 if is_a_quotient_of_rates(value) => Some(
            "this one changes with the input's rate: a number of the pose has as many rates below the line as above, \
             `rate(a) / rate(b)`",
        ),
        2.. if is_steady(mechanism, &quantity.rest) => Some(
            "a quotient of rates belongs to the pose of one input; with several it depends on how they move",
        ),
        _ => None,
    }
}
