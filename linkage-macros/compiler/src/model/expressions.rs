//! An expression as written into a sum of link angles and a number, with its measure.

use proc_macro2::Ident;

use crate::diagnostics::{Extent, nearest};
use crate::exact::Exact;
use crate::function::Function;
use crate::syntax::tree::{self, BinaryOp, ExprKind};

use super::Resolver;
use super::dimension::Measure;
use super::facts::Reads;
use super::folding::shown;
use super::mechanism::{AngleSum, Dimension, LinkId, Operator, ParamKind, Scalar};
use super::names::{Entity, Kind, NUMBERS};

/// A resolved expression: Σ kᵢ·linkᵢ.angle + rest.
pub(super) struct ResolvedExpr {
    pub measure: Measure,
    pub links: Vec<(LinkId, i32)>,
    pub rest: Scalar,
    pub reads: Reads,
}

/// Readings that may stand where an expression does.
#[derive(Clone, Copy)]
pub(super) struct Allowed {
    /// Loads, rates, and laws of them.
    pub forces: bool,
    /// Functions with a corner.
    pub corners: bool,
    /// Efforts and reactions.
    pub efforts: bool,
}

impl Allowed {
    /// In what a machine is made of, and how it moves.
    pub(super) const IN_DIMENSIONS: Self = Self { forces: false, corners: false, efforts: false };
    /// In forces and torques, and in what is named: that is refused where it is used.
    pub(super) const IN_FORCES: Self = Self { forces: true, corners: true, efforts: false };
    pub(super) const IN_OUTPUTS: Self = Self { efforts: true, ..Self::IN_FORCES };
}

/// Why a link's angle stands only in sums, times an integer.
pub(super) const ANGLE_REASON: &str = "a link's angle is known up to whole turns: it stands in \
     sums of angles, times an integer, because other ratios jump at ±π";

/// The function of two points.
const DISTANCE: &str = "distance";

/// The function of a point and a guide.
const OFFSET: &str = "offset";

/// The function that forces alone may depend on.
pub(super) const RATE: &str = "rate";

impl ResolvedExpr {
    pub(super) fn plain(measure: Measure, rest: Scalar) -> Self {
        Self { measure, links: Vec::new(), rest, reads: Reads::default() }
    }

    pub(super) fn constant(measure: Measure, value: Exact) -> Self {
        Self::plain(measure, Scalar::Constant(value))
    }

    pub(super) fn turn(self) -> AngleSum {
        AngleSum { links: self.links, rest: self.rest }
    }

    /// Keeps every multiple within ±(2³¹ − 1), so that a sign can always be changed.
    fn scale_links(&mut self, factor: i32) -> Option<()> {
        for (_, k) in &mut self.links {
            *k = k.checked_mul(factor).filter(|&k| k != i32::MIN)?;
        }
        self.links.retain(|&(_, k)| k != 0);
        Some(())
    }

    /// Divides every multiple of a link angle, if that leaves integers.
    fn divide_links(&mut self, divisor: &Exact) -> Option<()> {
        for (_, k) in &mut self.links {
            let ratio = Exact::integer(i64::from(*k)).div(divisor)?.to_integer()?;
            *k = i32::try_from(ratio).ok().filter(|&k| k != i32::MIN)?;
        }
        Some(())
    }

    fn add_links(&mut self, links: &[(LinkId, i32)], sign: i32) -> Option<()> {
        for &(link, k) in links {
            let k = k.checked_mul(sign)?;
            match self.links.iter_mut().find(|(known, _)| *known == link) {
                Some((_, sum)) => *sum = sum.checked_add(k).filter(|&k| k != i32::MIN)?,
                None => self.links.push((link, k)),
            }
        }
        self.links.retain(|&(_, k)| k != 0);
        Some(())
    }
}

impl Resolver<'_> {
    /// Resolves an expression of a dimension, and reports every mistake in it.
    pub(super) fn quantity(&mut self, expr: &tree::Expr) -> Option<ResolvedExpr> {
        self.expression(expr, Allowed::IN_DIMENSIONS)
    }

    /// Resolves an expression, and reports every mistake in it.
    pub(super) fn expression(
        &mut self,
        expr: &tree::Expr,
        allowed: Allowed,
    ) -> Option<ResolvedExpr> {
        match &expr.kind {
            ExprKind::Number { digits, units } => self.literal(expr.span, digits, units),
            ExprKind::Name(name) if name == "pi" => {
                Some(ResolvedExpr::constant(Measure::ANGLE, Exact::pi()))
            }
            ExprKind::Name(name) if name == "losses" && allowed.efforts => self.losses_read(name),
            ExprKind::Name(name) => self.named_number(name, allowed),
            ExprKind::Member(owner, member) => {
                let effort = allowed.efforts.then(|| self.effort_read(owner, member)).flatten();
                effort.unwrap_or_else(|| self.member(owner, member, allowed))
            }
            ExprKind::Part(path) if allowed.efforts => self.part_read(path),
            ExprKind::Part(path) => {
                // Its names are looked at.
                self.part_read(path)?;
                None
            }
            ExprKind::Negate(inner) => {
                let mut quantity = self.expression(inner, allowed)?;
                quantity.scale_links(-1)?;
                quantity.rest = quantity.rest.negated();
                Some(quantity)
            }
            ExprKind::Chain(first, rest) => self.chain(first, rest, allowed),
            ExprKind::Call(function, arguments) => {
                let quantity = match () {
                    () if function == DISTANCE => self.distance(function, arguments),
                    () if function == OFFSET => self.offset_from_guide(function, arguments),
                    () if function == RATE => self.rate(function, arguments, allowed),
                    () => self.call(function, arguments, allowed),
                }?;
                self.number_is_of_a_length(expr.span, quantity.rest.constant())?;
                Some(quantity)
            }
            // The names in it are among what was not read.
            ExprKind::Mistake => None,
        }
    }

    /// One operation after the other, each on what the one before has made.
    fn chain(
        &mut self,
        first: &tree::Expr,
        rest: &[(BinaryOp, tree::Expr)],
        allowed: Allowed,
    ) -> Option<ResolvedExpr> {
        self.units_have_parentheses(first, rest)?;
        let (mut span, mut left) = (first.span, self.expression(first, allowed));
        for (operator, operand) in rest {
            // Operands after a mistake are still checked.
            let right = self.expression(operand, allowed);
            let sides = left.zip(right);
            left = sides.and_then(|(left, right)| {
                self.operation(*operator, (span, left), (operand, right))
            });
            span = span.to(operand.span);
        }
        let left = left?;
        self.no_bare_number_beside_a_unit(first, rest, left.measure)?;
        Some(left)
    }

    fn operation(
        &mut self,
        operator: BinaryOp,
        left: (Extent, ResolvedExpr),
        right: (&tree::Expr, ResolvedExpr),
    ) -> Option<ResolvedExpr> {
        let span = left.0.to(right.0.span);
        let reads = left.1.reads.clone().and(right.1.reads.clone());
        let quantity = match operator {
            BinaryOp::Add => self.sum(Operator::Add, left, right),
            BinaryOp::Sub => self.sum(Operator::Sub, left, right),
            BinaryOp::Mul => self.product(left, (right.0.span, right.1)),
            BinaryOp::Div => self.quotient(left.1, (right.0.span, right.1)),
        }?;
        if let Scalar::Constant(value) = &quantity.rest {
            self.number_can_be_held(span, Some(value))?;
        }
        Some(ResolvedExpr { reads, ..quantity })
    }

    fn named_number(&mut self, name: &Ident, allowed: Allowed) -> Option<ResolvedExpr> {
        if self.names.kind(name) == Some(Kind::Load) {
            return self.value_of_load(name, allowed);
        }
        match self.usable(name, &NUMBERS)? {
            Entity::Input(id) => {
                let measure = Measure::Known(self.mechanism.inputs[id.index()].dimension);
                Some(ResolvedExpr::plain(measure, Scalar::Input(id)))
            }
            Entity::Param(id) => {
                if !matches!(self.mechanism.params[id.index()].kind, ParamKind::Number { .. }) {
                    let message = format!("`{name}` is a mode, not a number");
                    self.diagnostics.error(name.span(), message);
                    return None;
                }
                let measure = self.facts.params[id.index()].measure;
                Some(ResolvedExpr::plain(measure, Scalar::Param(id)))
            }
            entity @ (Entity::Let(_) | Entity::Law(_)) => self.value_of_let(name, entity, allowed),
            Entity::Unknown(id) => {
                let measure = Measure::Known(self.mechanism.unknowns[id.index()].dimension);
                Some(ResolvedExpr::plain(measure, Scalar::Unknown(id)))
            }
            Entity::Point(_)
            | Entity::Link(_)
            | Entity::Guide(_)
            | Entity::Load(_)
            | Entity::Pull
            | Entity::Spring(_)
            | Entity::Stop(_) => None,
        }
    }

    /// The sides of a sum are quantities of one kind.
    pub(super) fn sum(
        &mut self,
        operator: Operator,
        (left, mut a): (Extent, ResolvedExpr),
        (right, b): (&tree::Expr, ResolvedExpr),
    ) -> Option<ResolvedExpr> {
        let Some(measure) = a.measure.sum(b.measure) else {
            let (found, wanted) = (b.measure.dimension(), a.measure.dimension());
            let message = format!("{} where {} belongs", found.words(), wanted.words());
            let sign = if operator == Operator::Add { '+' } else { '-' };
            let left = || format!("what stands left of the `{sign}` is {}", wanted.words());
            let reason = self.name_taken_for_a_unit(right).unwrap_or_else(left);
            self.diagnostics.error_because(right.span, message, reason);
            return None;
        };
        if measure == Measure::ANGLE {
            let left_is_small = self.bare_angle_is_within_a_turn(left, &a);
            self.bare_angle_is_within_a_turn(right.span, &b).and(left_is_small)?;
        }
        a.measure = measure;
        let sign = if operator == Operator::Add { 1 } else { -1 };
        if a.add_links(&b.links, sign).is_none() {
            return self.link_angles_are_whole_multiples(right.span, &b.links);
        }
        a.rest = a.rest.combined(operator, b.rest)?;
        Some(a)
    }

    fn product(
        &mut self,
        (left, a): (Extent, ResolvedExpr),
        (right, b): (Extent, ResolvedExpr),
    ) -> Option<ResolvedExpr> {
        let measure = a.measure.product(b.measure);
        // The factor of a link angle, if there is one, is the other side.
        let (mut turn, factor, span) = match (a.links.is_empty(), b.links.is_empty()) {
            (true, true) => {
                return Some(ResolvedExpr::plain(measure, a.rest.combined(Operator::Mul, b.rest)?));
            }
            (false, _) => (a, b, right),
            (true, false) => (b, a, left),
        };
        let integer = factor.rest.constant().and_then(Exact::to_integer);
        let integer = integer.and_then(|k| i32::try_from(k).ok());
        let whole = factor.links.is_empty() && factor.measure.fits(Dimension::NUMBER);
        let links = turn.links.clone();
        if !whole || integer.and_then(|k| turn.scale_links(k)).is_none() {
            return self.link_angles_are_whole_multiples(span, &links);
        }
        turn.rest = turn.rest.combined(Operator::Mul, factor.rest)?;
        Some(ResolvedExpr { measure, ..turn })
    }

    fn quotient(
        &mut self,
        mut a: ResolvedExpr,
        (right, b): (Extent, ResolvedExpr),
    ) -> Option<ResolvedExpr> {
        if !b.links.is_empty() {
            return self.link_angles_are_whole_multiples(right, &b.links);
        }
        if b.rest.is_zero() {
            self.diagnostics.error(right, "a division by zero");
            return None;
        }
        if !a.links.is_empty() {
            let links = a.links.clone();
            let divided = match b.rest.constant() {
                Some(divisor) if b.measure.fits(Dimension::NUMBER) => a.divide_links(divisor),
                _ => None,
            };
            if divided.is_none() {
                return self.link_angles_are_whole_multiples(right, &links);
            }
        }
        a.measure = a.measure.quotient(b.measure);
        a.rest = a.rest.combined(Operator::Div, b.rest)?;
        Some(a)
    }

    /// Reports a link angle that is multiplied by something other than an integer.
    fn link_angles_are_whole_multiples(
        &mut self,
        span: Extent,
        links: &[(LinkId, i32)],
    ) -> Option<ResolvedExpr> {
        let name = &self.mechanism.links[links[0].0.index()].name;
        let message = format!("`{name}.angle` can be multiplied by an integer only");
        self.diagnostics.error_because(span, message, ANGLE_REASON);
        None
    }

    fn call(
        &mut self,
        name: &Ident,
        arguments: &[tree::Expr],
        allowed: Allowed,
    ) -> Option<ResolvedExpr> {
        let Some(function) = Function::named(&name.to_string()) else {
            if self.member_as_a_function(name, arguments) {
                return None;
            }
            self.function_exists(name);
            // It may be a function of points or guides.
            let numbers = arguments.iter().filter(|argument| !self.is_a_place(argument));
            let numbers: Vec<_> = numbers.collect();
            numbers.into_iter().for_each(|argument| drop(self.expression(argument, allowed)));
            return None;
        };
        let values = arguments.iter().map(|argument| self.expression(argument, allowed));
        let values: Vec<_> = values.collect();
        if arguments.len() != function.arity() {
            let takes = if function.arity() == 1 { "one argument" } else { "two arguments" };
            let message = format!("`{name}` takes {takes}, and {} given", counted(arguments.len()));
            self.diagnostics.error(name.span(), message);
            return None;
        }
        let values: Vec<_> = values.into_iter().collect::<Option<_>>()?;
        for (argument, value) in arguments.iter().zip(&values) {
            self.no_link_angle(argument, value)?;
        }
        let measure = self.measure_of_call(function, arguments, &values)?;
        let mut reads =
            values.iter().fold(Reads::default(), |all, value| all.and(value.reads.clone()));
        let rests = Self::arguments_above_zero(function, arguments, values);
        let constants: Vec<_> =
            rests.iter().filter_map(|rest| rest.constant()).map(shown).collect();
        let called = Scalar::call(function, rests);
        if called.is_none() {
            let call = format!("{name}({})", constants.join(", "));
            self.function_is_defined(function, &arguments[0], &call);
        }
        let called = called?;
        if !function.is_smooth() && !called.is_constant() {
            reads.corner = Some(function.name());
        }
        if !function.is_smooth() && !called.is_constant() && !allowed.corners {
            let message = format!("`{name}` stands in forces, torques and outputs alone");
            let reason = "a dimension is smooth: write `hypot(x, e)` with a small `e` for `abs(x)`";
            self.diagnostics.error_because(name.span(), message, reason);
            return None;
        }
        Some(ResolvedExpr { reads, ..ResolvedExpr::plain(measure, called) })
    }

    /// Reports `angle(BC)` and `x(P)`; whether it was one of these.
    fn member_as_a_function(&mut self, name: &Ident, arguments: &[tree::Expr]) -> bool {
        let [Some(owner)] = arguments.iter().map(bare_name).collect::<Vec<_>>()[..] else {
            return false;
        };
        let members: &[&str] = match self.names.kind(owner) {
            Some(Kind::Link) => &["angle", "slide"],
            Some(Kind::Point) => &["x", "y"],
            _ => return false,
        };
        let is_member = members.iter().any(|member| name == member);
        if is_member {
            let message = format!("write `{owner}.{name}`");
            let reason = "what a link or a point has stands behind its name";
            self.diagnostics.error_because(name.span(), message, reason);
        }
        is_member
    }

    /// Reports a function that does not exist, with the nearest one.
    fn function_exists(&mut self, name: &Ident) {
        let text = name.to_string();
        let mut message = format!("no function named `{text}`");
        let known = Function::names().chain([DISTANCE, OFFSET, RATE]);
        if let Some(near) = nearest(&text, known) {
            message += &format!("; a function with a similar name exists: `{near}`");
        }
        let names: Vec<_> = Function::names().chain([DISTANCE, OFFSET]).collect();
        let reason = format!(
            "the functions are `{}`, and `{RATE}` in forces, torques and outputs",
            names.join(" ")
        );
        self.diagnostics.error_because(name.span(), message, reason);
    }

    /// Reports a function of constants where it has no value.
    fn function_is_defined(&mut self, function: Function, argument: &tree::Expr, call: &str) {
        let message = format!("`{call}` has no value");
        self.diagnostics.error_because(argument.span, message, function.domain());
    }
}

/// "3 are", "1 is"
pub(super) fn counted(count: usize) -> String {
    match count {
        0 => "none is".into(),
        1 => "one is".into(),
        _ => format!("{count} are"),
    }
}

/// The name of an expression that is a bare name.
pub(super) fn bare_name(expr: &tree::Expr) -> Option<&Ident> {
    match &expr.kind {
        ExprKind::Name(name) => Some(name),
        _ => None,
    }
}
