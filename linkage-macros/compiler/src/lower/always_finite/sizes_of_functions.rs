//! The questions in front of functions: their arguments are within their domains, and their values within the width.

use super::{SLACK, SizeCheck, SizeWalk, Unbounded};
use crate::function::Function;
use crate::ir::graph::Id;
use crate::lower::interval::Interval;

impl SizeWalk<'_> {
    pub(super) fn function(&mut self, function: Function, a: Id) -> Result<Interval, Unbounded> {
        let x = self.range(a)?;
        let largest = function.largest();
        match function {
            Function::Sqrt => {
                if x.low < 0.0 {
                    self.ask(SizeCheck::AtLeast(a, 0.0));
                }
                Ok(Interval::of(x.low.max(0.0).sqrt(), x.high.max(0.0).sqrt()))
            }
            Function::Asin | Function::Acos => {
                if x.largest() > 1.0 {
                    self.ask(SizeCheck::AtMost(a, 1.0));
                }
                Ok(Interval::about(largest.expect("an angle is bounded")))
            }
            Function::Atan => Ok(Interval::about(largest.expect("an angle is bounded"))),
            Function::Tan => {
                if x.largest() > self.room.near {
                    self.ask(SizeCheck::AtMost(a, self.room.near));
                }
                // No number of double precision is nearer to a pole.
                Ok(Interval::about(1e20))
            }
            Function::Exp => {
                if x.largest() > self.room.exponent {
                    self.ask(SizeCheck::AtMost(a, self.room.exponent));
                }
                Ok(Interval::of(0.0, self.room.exponent.exp()))
            }
            Function::Ln => {
                if x.low < self.room.normal {
                    self.ask(SizeCheck::AtLeast(a, self.room.normal));
                }
                Ok(Interval::about(largest.expect("a logarithm is bounded")))
            }
            Function::Sin | Function::Cos => unreachable!("a statement of its own kind"),
            Function::Hypot
            | Function::Atan2
            | Function::Abs
            | Function::Sign
            | Function::Min
            | Function::Max
            | Function::Tanh
            | Function::Pow => Err(Unbounded::Function(function)),
        }
    }

    /// A power, of what is above zero.
    pub(super) fn power(&mut self, base: Id, exponent: Id) -> Result<Interval, Unbounded> {
        const MOST: f64 = 8.0;
        let mut power = self.range(exponent)?.largest();
        if power > MOST {
            self.ask(SizeCheck::AtMost(exponent, MOST));
            power = MOST;
        }
        let limit = self.room.asked.powf(1.0 / power.max(1.0));
        let x = self.range(base)?;
        if x.low < 1.0 / limit {
            self.ask(SizeCheck::AtLeast(base, 1.0 / limit));
        }
        if x.high > limit {
            self.ask(SizeCheck::AtMost(base, limit));
        }
        Ok(Interval::of(0.0, self.room.asked * (1.0 + SLACK)))
    }
}
