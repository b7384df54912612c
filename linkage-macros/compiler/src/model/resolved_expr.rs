//! A resolved expression: a sum of link angles and a number, with its measure and its readings.

use proc_macro2::Ident;

use crate::exact::Exact;
use crate::syntax::tree::{self, ExprKind};

use crate::model::dimension::Measure;
use crate::model::expr::{AngleSum, Scalar};
use crate::model::mechanism::LinkId;
use crate::model::reads::{Allowed, Reads};
use crate::model::scope::Scope;

/// Resolves an expression: handed to what an expression is made of.
pub(in crate::model) type Resolve =
    fn(&mut Scope<'_>, &tree::Expr, Allowed) -> Option<ResolvedExpr>;

/// A resolved expression: Σ kᵢ·linkᵢ.angle + rest.
pub(in crate::model) struct ResolvedExpr {
    pub measure: Measure,
    pub links: Vec<(LinkId, i32)>,
    pub rest: Scalar,
    pub reads: Reads,
}

/// Why a link's angle stands only in sums, times an integer.
pub(in crate::model) const ANGLE_REASON: &str = "a link's angle is known up to whole turns: it stands in \
     sums of angles, times an integer, because other ratios jump at ±π";

/// "3 are", "1 is"
pub(in crate::model) fn counted(count: usize) -> String {
    match count {
        0 => "none is".into(),
        1 => "one is".into(),
        _ => format!("{count} are"),
    }
}

/// The name of an expression that is a bare name.
pub(in crate::model) fn bare_name(expr: &tree::Expr) -> Option<&Ident> {
    match &expr.kind {
        ExprKind::Name(name) => Some(name),
        _ => None,
    }
}

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
    pub(super) fn scale_links(&mut self, factor: i32) -> Option<()> {
        for (_, k) in &mut self.links {
            *k = k.checked_mul(factor).filter(|&k| k != i32::MIN)?;
        }
        self.links.retain(|&(_, k)| k != 0);
        Some(())
    }

    /// Divides every multiple of a link angle, if that leaves integers.
    pub(super) fn divide_links(&mut self, divisor: &Exact) -> Option<()> {
        for (_, k) in &mut self.links {
            let ratio = Exact::integer(i64::from(*k)).div(divisor)?.to_integer()?;
            *k = i32::try_from(ratio).ok().filter(|&k| k != i32::MIN)?;
        }
        Some(())
    }

    pub(super) fn add_links(&mut self, links: &[(LinkId, i32)], sign: i32) -> Option<()> {
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
