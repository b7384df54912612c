//! Groups that are solved by all their unknowns at once: at the pins that close their loops two points are one.
//!
//! With F the vectors between these points, x the unknowns and J = ∂F/∂x, four steps x − J⁻¹ F lead from a fit of x over the drive
//! to the root. J is had from the rates that the group's drivers have anyway, one unknown moving at a unit rate after the
//! other. It is never exchanged by rows, whose pivots may be zero in one pose or another: its columns are made square to
//! each other (Gram and Schmidt), and what a column is divided by is zero at a dead point alone.
//!
//! With R = J⁻¹ at the fit, η the largest number of R F and K the largest of the sums |R| B by rows, where B bounds the
//! second derivatives of F, the theorem of Newton and Kantorovich says that there is one root near the fit, and that the
//! steps lead there, where h = K η ≤ 1/2. At most 1/32 is asked for: see `chain::tracked`. Slides count in units of
//! the machine's size.
//!
//! The rates follow from F = 0, which holds at all times: J ẋ = −Ḟ at ẋ = 0, and J ẍ = −F̈ at ẍ = 0.
//!
//! # Source
//! L. V. Kantorovich and G. P. Akilov, Functional Analysis, ch. XVIII; the bound h < 1/2 as in J. M. Ortega, The
//! Newton–Kantorovich theorem, Amer. Math. Monthly 75 (1968).

use std::cell::OnceCell;

use crate::chain::tracked::LIMIT;
use crate::equations::jet::Jet;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::motion::Direction;
use crate::equations::symbol::{GraphBuilder, Sym, Vector};
use crate::exact::Exact;
use crate::function::Function;
use crate::ir::graph::Check;
use crate::model::mechanism::{Tracked, TrackedId};

/// The count of Newton's steps.
const STEPS: usize = 4;
/// The share of the stretch by which the drive may be beyond it: rounding of an `f32` in a turn.
const BEYOND: f64 = 1e-6;

impl<'s> Kinematics<'s> {
    /// Solves the groups before a step.
    pub(super) fn solve_tracked_until(&mut self, end: usize) {
        let mechanism = self.mechanism;
        while let Some(tracked) = mechanism.tracked.get(self.tracked.len())
            && tracked.steps[0] < end
        {
            self.take_until(tracked.steps[0]);
            self.name_lets();
            let jets = solved(self, TrackedId(self.tracked.len() as u32));
            self.tracked.push(jets);
            self.name_lets();
        }
    }

    /// Takes over the unknowns that another state knows, at rest where nothing moves here.
    pub(super) fn take_over_tracked(&mut self, known: &Self) {
        let stands_still = self.inputs.iter().all(|source| source.jet.is_fixed());
        let at_rest = |jet: &Jet<'s>| if stands_still { Jet::constant(jet.value) } else { *jet };
        self.tracked =
            known.tracked.iter().map(|jets| jets.iter().map(at_rest).collect()).collect();
    }

    /// The state in front of a group, at other rates of the inputs.
    fn in_front_of(inputs: Vec<InputMotion<'s>>, known: &Self) -> Self {
        let mut state = Self::before(known.builder, known.mechanism, inputs);
        state.unknowns = known.unknowns.iter().map(|jet| Jet::constant(jet.value)).collect();
        state.take_over_tracked(known);
        state.take_until(known.taken);
        state.name_lets();
        state
    }

    /// The vectors between the points that are to be one, with these unknowns, behind this state.
    fn missed(&self, tracked: &Tracked, unknowns: Vec<Jet<'s>>) -> Vec<Jet<'s>> {
        let mut trial = Self { by_input: OnceCell::new(), ..self.clone() };
        trial.tracked.push(unknowns);
        trial.name_lets();
        self.builder.set_guards_ignored(true);
        trial.take_until(tracked.steps[1]);
        self.builder.set_guards_ignored(false);
        let apart = |[made, met]: [_; 2]| trial.point(made).jets_to(trial.point(met));
        tracked.closings.iter().flat_map(|closing| apart(closing.points)).collect()
    }
}

/// The unknowns of a group, everything in front of it being known.
fn solved<'s>(known: &Kinematics<'s>, id: TrackedId) -> Vec<Jet<'s>> {
    let (builder, tracked) = (known.builder, &known.mechanism.tracked[id.index()]);
    let resting = InputMotion::at_rest(&known.inputs, builder);
    let resting = Kinematics::in_front_of(resting, known);
    let (mut at, room) = fit(&resting, tracked);
    for step in 0..STEPS {
        let (missed, slopes) = equations(&resting, tracked, &at);
        let change = slopes.solve(&missed);
        let mut next: Vec<_> = at.iter().zip(&change).map(|(at, change)| *at - *change).collect();
        if step == 0 {
            let sure = sure(tracked, &slopes, &change, builder);
            let sure = room.map_or(sure, |room| sure.at_least(room, room, sure));
            let sure = sure.guarded_by(Check::Certified, tracked.group.0, &[]);
            builder.name(sure, format!("{} certified", tracked.fit.unknowns[0].name));
            // All later steps stand on this one.
            next[0] = sure.at_least(builder.zero(), next[0], at[0]);
        }
        at = next;
    }
    for (at, unknown) in at.iter().zip(&tracked.fit.unknowns) {
        builder.name(*at, unknown.name.clone());
    }
    let (_, slopes) = equations(&resting, tracked, &at);
    rates(known, tracked, &at, &slopes)
}

/// The rates at the root.
fn rates<'s>(
    known: &Kinematics<'s>,
    tracked: &Tracked,
    at: &[Sym<'s>],
    slopes: &Squared<'s>,
) -> Vec<Jet<'s>> {
    let zero = known.builder.zero();
    let opposite = |changes: Vec<Sym<'s>>| changes.into_iter().map(|change| -change);
    let still = at.iter().map(|&value| Jet { value, rate: zero, accel: zero }).collect();
    let missed: Vec<_> = known.missed(tracked, still).iter().map(|jet| jet.rate).collect();
    let rates = opposite(slopes.solve(&missed));
    let steady = at.iter().zip(rates).map(|(&value, rate)| Jet { value, rate, accel: zero });
    let steady: Vec<_> = steady.collect();
    let missed: Vec<_> =
        known.missed(tracked, steady.clone()).iter().map(|jet| jet.accel).collect();
    let accels = opposite(slopes.solve(&missed));
    steady.into_iter().zip(accels).map(|(jet, accel)| Jet { accel, ..jet }).collect()
}

/// The equations and their slopes.
fn equations<'s>(
    resting: &Kinematics<'s>,
    tracked: &Tracked,
    at: &[Sym<'s>],
) -> (Vec<Sym<'s>>, Squared<'s>) {
    let builder = resting.builder;
    let moving = |moving: usize| {
        let jet = |(index, &value): (usize, &Sym<'s>)| {
            let rate = builder.integer(i64::from(index == moving));
            Jet { value, rate, accel: builder.zero() }
        };
        resting.missed(tracked, at.iter().enumerate().map(jet).collect())
    };
    let all: Vec<_> = (0..at.len()).map(moving).collect();
    let missed = all[0].iter().map(|jet| jet.value).collect();
    let columns = all.iter().map(|column| column.iter().map(|jet| jet.rate).collect());
    (missed, Squared::of(columns.collect(), builder))
}

/// The distance of the product of Newton and Kantorovich from its limit.
fn sure<'s>(
    tracked: &Tracked,
    slopes: &Squared<'s>,
    change: &[Sym<'s>],
    builder: &'s GraphBuilder<'s>,
) -> Sym<'s> {
    let number = |value: f64| number(builder, value);
    let unit = |row: usize, value: Sym<'s>| match tracked.fit.unknowns[row].is_angle {
        true => value,
        false => value * number(1.0 / tracked.fit.size),
    };
    let most = |a: Sym<'s>, b: Sym<'s>| a.at_least(b, a, b);
    let inverse = slopes.inverse();
    let bent = inverse.iter().enumerate().map(|(row, entries)| {
        let pairs = entries.chunks(2).zip(&tracked.closings);
        let sizes = pairs.map(|(pair, closing)| {
            number(closing.bend) * pair.iter().fold(builder.zero(), |sum, x| sum + x.magnitude())
        });
        unit(row, sizes.fold(builder.zero(), |sum, size| sum + size))
    });
    let bent = bent.reduce(most);
    let step = change.iter().enumerate().map(|(row, change)| unit(row, change.magnitude()));
    let product = bent.zip(step.reduce(most)).map(|(bent, step)| bent * step);
    number(LIMIT) - product.unwrap_or(builder.zero())
}

fn number<'s>(builder: &'s GraphBuilder<'s>, value: f64) -> Sym<'s> {
    builder.constant(Exact::float(value).expect("what was fitted is finite"))
}

/// The unknowns where the search begins, and how far the drive is inside the stretch where they are fitted; none where
/// that is all of a turn.
fn fit<'s>(resting: &Kinematics<'s>, tracked: &Tracked) -> (Vec<Sym<'s>>, Option<Sym<'s>>) {
    let builder = resting.builder;
    let number = |value: f64| number(builder, value);
    let from_drawing = from_drawing(resting, tracked);
    let chosen = |of: &dyn Fn(usize) -> f64| {
        let pieces = tracked.fit.pieces.iter().enumerate().skip(1);
        pieces.fold(number(of(0)), |before, (index, piece)| {
            from_drawing.at_least(number(piece.ends[0]), number(of(index)), before)
        })
    };
    let ends = |index: usize| tracked.fit.pieces[index].ends;
    let middle = chosen(&|index| (ends(index)[0] + ends(index)[1]) / 2.0);
    let scale = chosen(&|index| 2.0 / (ends(index)[1] - ends(index)[0]));
    let place = (from_drawing - middle) * scale;
    let unknowns = tracked.fit.unknowns.iter().enumerate().map(|(unknown, of)| {
        let count = tracked.fit.pieces[0].powers[unknown].len();
        let power = |power: usize| {
            let own = if power == 0 { of.drawn } else { 0.0 };
            chosen(&|index| tracked.fit.pieces[index].powers[unknown][power] + own)
        };
        let highest = power(count - 1);
        (0..count - 1).rev().fold(highest, |sum, next| sum * place + power(next))
    });
    let unknowns = unknowns.collect();
    let [from, to] = tracked.fit.stretch();
    let beyond = BEYOND * (to - from);
    let room = [from_drawing - number(from - beyond), number(to + beyond) - from_drawing];
    let room = room[0].at_least(room[1], room[1], room[0]);
    (unknowns, (!tracked.fit.closes).then_some(room))
}

/// The drive from its value in the drawing, an angle within half a turn.
fn from_drawing<'s>(resting: &Kinematics<'s>, tracked: &Tracked) -> Sym<'s> {
    let builder = resting.builder;
    if !tracked.fit.is_turned {
        return resting.jet(&tracked.drive.rest).value - number(builder, tracked.fit.drawn);
    }
    let Direction { u, .. } = resting.turned(Direction::ground(builder), &tracked.drive);
    let u = u.turned(back_by(builder, tracked.fit.drawn));
    u.y.apply2(Function::Atan2, u.x)
}

/// The direction that turns another one back by an angle.
fn back_by<'s>(builder: &'s GraphBuilder<'s>, angle: f64) -> Vector<'s> {
    let (sin, cos) = angle.sin_cos();
    Vector { x: number(builder, cos), y: number(builder, -sin) }
}

/// A matrix whose columns were made square to each other: column k of it is the sum of `square` columns j with the factors
/// `shares[j][k]`, one for its own.
struct Squared<'s> {
    builder: &'s GraphBuilder<'s>,
    /// The columns in the order in which they were taken: those with more zeros first, so that few numbers arise.
    order: Vec<usize>,
    square: Vec<Vec<Sym<'s>>>,
    /// One over the square of each length.
    inverse: Vec<Sym<'s>>,
    shares: Vec<Vec<Sym<'s>>>,
}

impl<'s> Squared<'s> {
    fn of(mut columns: Vec<Vec<Sym<'s>>>, builder: &'s GraphBuilder<'s>) -> Self {
        let count = columns.len();
        let filled = |column: &usize| columns[*column].iter().filter(|x| !x.is_zero()).count();
        let mut order: Vec<_> = (0..count).collect();
        order.sort_by_key(filled);
        let (mut inverse, mut shares) = (Vec::new(), Vec::new());
        for (taken, &own) in order.iter().enumerate() {
            let column = columns[own].clone();
            let over = dot(builder, &column, &column).recip();
            let mut of_own = vec![builder.zero(); count];
            for &later in &order[taken + 1..] {
                let share = dot(builder, &column, &columns[later]) * over;
                for (entry, own) in columns[later].iter_mut().zip(&column) {
                    *entry = *entry - share * *own;
                }
                of_own[later] = share;
            }
            inverse.push(over);
            shares.push(of_own);
        }
        let square = order.iter().map(|&own| columns[own].clone()).collect();
        Self { builder, order, square, inverse, shares }
    }

    /// The factors of the columns whose sum is a vector.
    fn solve(&self, vector: &[Sym<'s>]) -> Vec<Sym<'s>> {
        let mut left = vector.to_vec();
        let along = self.square.iter().zip(&self.inverse).map(|(column, over)| {
            let share = dot(self.builder, column, &left) * *over;
            left.iter_mut().zip(column).for_each(|(left, own)| *left = *left - share * *own);
            share
        });
        let along: Vec<_> = along.collect();
        self.back(along)
    }

    /// The factors of the columns from those of the square ones.
    fn back(&self, along: Vec<Sym<'s>>) -> Vec<Sym<'s>> {
        let mut found = vec![self.builder.zero(); along.len()];
        for (taken, &own) in self.order.iter().enumerate().rev() {
            let later = self.order[taken + 1..].iter();
            found[own] = later
                .fold(along[taken], |sum, &later| sum - self.shares[taken][later] * found[later]);
        }
        found
    }

    /// The inverse, a row a column of the matrix.
    fn inverse(&self) -> Vec<Vec<Sym<'s>>> {
        let count = self.order.len();
        let of_unit = |row: usize| {
            let along = self.square.iter().zip(&self.inverse);
            self.back(along.map(|(column, over)| column[row] * *over).collect())
        };
        let columns: Vec<_> = (0..count).map(of_unit).collect();
        (0..count).map(|row| columns.iter().map(|column| column[row]).collect()).collect()
    }
}

/// The sum of products, without those that are zero.
fn dot<'s>(builder: &'s GraphBuilder<'s>, a: &[Sym<'s>], b: &[Sym<'s>]) -> Sym<'s> {
    let products = a.iter().zip(b).filter(|(a, b)| !a.is_zero() && !b.is_zero());
    products.map(|(a, b)| *a * *b).reduce(|sum, next| sum + next).unwrap_or(builder.zero())
}

/// The distance of the drive from the ends of the stretch on which a group is followed, with its rates; none where it turns fully.
pub(super) fn inside<'s>(kinematics: &Kinematics<'s>, tracked: &Tracked) -> Option<Jet<'s>> {
    let builder = kinematics.builder;
    let constant = |value: f64| Jet::constant(number(builder, value));
    let [from, to] = tracked.fit.stretch().map(|end| end + tracked.fit.drawn);
    if tracked.fit.closes {
        return None;
    }
    if !tracked.fit.is_turned {
        let drive = kinematics.jet(&tracked.drive.rest);
        return Some((drive - constant(from)) * (constant(to) - drive));
    }
    // The cosine of the angle from the middle is that of half the stretch at both ends.
    let drive = kinematics.turned(Direction::ground(builder), &tracked.drive);
    let back = back_by(builder, (from + to) / 2.0);
    let (Vector { x, y }, omega, alpha) = (drive.u.turned(back), drive.omega, drive.alpha);
    Some(Jet {
        value: x - number(builder, ((to - from) / 2.0).cos()),
        rate: -(y * omega),
        accel: -(y * alpha) - x * omega.squared(),
    })
}
