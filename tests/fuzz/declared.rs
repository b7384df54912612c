//! The mechanisms: every driver, group, point and guide form, with constant and with variable
//! dimensions, plain, compensated and fast.

use linkage_core::private::{OfMotion, OfPosition, OfVelocity};
use linkage_core::{Scalar, SolveError, Tracker, mechanism};
use linkage_tests::mechanisms::driven_groups::*;
use linkage_tests::mechanisms::drivers::*;
use linkage_tests::mechanisms::margins::*;
use linkage_tests::mechanisms::near_limits::*;
use linkage_tests::mechanisms::single_groups::*;
use linkage_tests::mechanisms::stacked_sliders::*;
use linkage_tests::mechanisms::twins::*;
use linkage_tests::mechanisms::unknowns::{
    Press, PressPosition, RamAndFollower, RamAndFollowerPosition,
};
use linkage_tests::mechanisms::variable_dimensions::*;

use super::calls::{At, Calls};
use super::mechanism::{Found, Fuzzed, fuzz};
use super::numbers::{Number, Source};
use super::state::State;
use super::truth::Motion;

mechanism! {
    /// What no other has: a guide towards a point on the ground and on a link, every function,
    /// points of blocks and yokes, coordinates and distances.
    pub struct Everything {
        input theta, psi: angle;
        input s: length;
        param swing = 0.25rad;
        param reach = 2.4m;
        param side: mode = ahead;
        param elbow: mode = left;

        ground A(0, 0);
        ground D(A.x + 2m, 0.3m);
        guide bed through (-2m, -1m) towards A;

        crank  AB(A) -> B      { length: 0.5m + 0.01m * tan(psi / 4), angle: theta }
        guide  slot on AB through (0.3m, 0.1m) along psi + atan(theta);
        slider ram(bed) -> R   { slide: s, offset: 0.1m * asin(psi / 4) }
        crank  arm(R) -> T     { length: 0.2m, relative_to: AB, angle: 2 * AB.angle + acos(psi / 4) }
        rrr    BC(B), DC(D) -> C { lengths: (reach, 1.9m), mode: elbow }
        point  E on BC at distances (1.4m, 1.5m) left;
        guide  beam on BC through B towards E;
        point  P at (0.4 * s - 0.7m, 0.4m + s * s / 2m);
        rrp    PF(P), block(slot) -> F
            { length: sqrt(1.1m * 1.1m + s * s), offset: s / 4, mode: side }
        point  Q on PF at (0.5 * s, hypot(s, 0.3m));
        rpr    sleeve(T), bar(Q) { offset: 0.01m * sin(swing) }
        rpp    pin(F), yoke(bed) { slot: 60deg + swing * cos(theta), offsets: (s / 8, 0) }
        prp    shoe(beam), die(bed) -> G {}
        let rope = distance(E, T);

        output Q, T, E, G, PF, block, bar, yoke.slide, shoe.slide, rope, E.y, DC.margin,
               lead = atan2(s, 1m + s);
    }
}

mechanism! {
    /// Parallelograms in a row, whose modes may change, and a rocker behind them.
    pub struct Cranks {
        input theta: angle;
        param crank = 1m;
        param base = 2m;
        param coupler = 2m;
        param rocker = 1m;
        param rod = 2m;
        param follower = 1m;
        param lever = 2.5m;
        param first: mode = left;
        param second: mode = left;
        param third: mode = left;

        ground A(0, 0), D(base, 0), F(base * 2, 0), G(base * 3, crank);
        crank AB(A) -> B        { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: first }
        rrr   CE(C), FE(F) -> E { lengths: (rod, follower), mode: second }
        rrr   EH(E), GH(G) -> H { lengths: (3m, lever), mode: third }

        output C, E, H, GH;
    }
}

/// Numbers of twice the width search nothing. What is right is told by the equations of a pose: what
/// each misses is no more than a place of half a last place, and the rounding of a dozen operations, of
/// what its sides are made of.
fn is_closed<T: Number>(state: &State<T, 2, 3>, p: &RamAndFollowerPosition<T>) -> bool {
    let [x, h] = state.q.map(|q| q.value());
    let sizes = [state.params[0].value().abs() + state.params[1].value().abs(), 5.0];
    let missed = [(p.C.x.value() - x, x.abs() + sizes[0]), (p.F.y.value() - h, h.abs() + sizes[1])];
    missed.iter().all(|(miss, size)| miss.abs() <= 64.0 * T::HALF_UNIT * size)
}

/// The same of a press whose ends are parameters: its root lies between them.
fn is_pressed<T: Number>(state: &State<T, 1, 6>, p: &PressPosition<T>) -> bool {
    let [from, to, _, r, l, _] = state.params.map(|param| param.value());
    let (x, theta) = (state.q[0].value(), p.theta.value());
    let size = x.abs() + r.abs() + l.abs();
    let is_between = from <= theta && theta <= to && to - from <= 6.3;
    is_between && (p.ram.slide.value() - x).abs() <= 64.0 * T::HALF_UNIT * size
}

fuzzed! {
    CouplerFourBar: 1 one, 0(), modes(elbow), units(BC DC), margins();
    InclinedSliderCrank: 1 one, 0(), modes(side), units(BC block), margins(), circle;
    OffsetQuickReturn: 1 one, 0(), modes(side), units(block bar), margins(), circle;
    CrossedGuides: 1 one, 0(), modes(), units(AB shoe), margins(), circle;
    ObliqueYoke: 1 one, 0(), modes(), units(AB), margins(), circle;
    VariableFourBar: 2 many, 0(), modes(), units(BC DC), margins();
    VariableRod: 2 many, 0(), modes(), units(BC), margins();
    PolarArm: 2 many, 0(), modes(), units(wrist), margins();
    ParamFourBar: 1 one, 4(crank base rocker coupler), modes(elbow), units(BC DC), margins(), circle;
    DrivenRrr: 4 many, 2(l1 l2), modes(elbow), units(BC DC), margins();
    DrivenRrp: 5 many, 2(l e), modes(side), units(BC block), margins();
    DrivenRpr: 4 many, 1(e), modes(side), units(bar), margins();
    DrivenPrp: 6 many, 2(e1 e2), modes(), units(), margins();
    DrivenRpp: 5 many, 3(slot e1 e2), modes(), units(block), margins();
    CompensatedRrr: 4 many, 2(l1 l2), modes(elbow), units(BC DC), margins();
    CompensatedRrp: 2 many, 2(l e), modes(), units(BC), margins();
    MarginRpr: 4 many, 1(e), modes(), units(bar), margins(bar_margin bar_transmission);
    Cranks: 1 one, 7(crank base coupler rocker rod follower lever), modes(first second third), units(GH), margins(), circle;
    Everything: 3 many, 2(swing reach), modes(side elbow), units(PF block bar),
        margins(DC_margin);
    ConstantBars: 2 many, 0(), modes(), units(BC DC), margins() as TunedBars;
    ConstantReach: 1 one, 0(), modes(), units(BC DC), margins(), circle as TunedReach;
    ConstantWatt: 1 one, 0(), modes(), units(BC DC PE QE), margins(), circle;
    TunedCranks: 2 many, 1(l), modes(), units(BC), margins();
    RamAndFollower: 2 many, 3(r rod seed), modes(), units(AB BC), margins(BC_margin) => is_closed;
    Press: 1 one, 6(from to seed r l e), modes(), units(AB), margins() => is_pressed;
}
