//! Distance of an equation from having no root, for following a motion and for limits.
//!
//! Roots of one trend lie between two ends: those of the interval, or dead points, where the slope by
//! the unknown is zero. At each end e the difference f = left − right, with the sign that it has to
//! have there for a root, is a distance: at a dead point two roots meet where it is zero, and there is
//! none where it is negative. Unlike the root itself it goes on smoothly there. Where it touches zero
//! and turns back, a motion goes on along the other root, which is the other trend; at an end of the
//! interval it is the interval that ends.
//!
//! # Rates
//! The inputs alone moving, ḟ = f_t and f̈ = f_tt. A dead point moves with them, so that f_θ stays
//! zero: ė = −f_θt/f_θθ. Hence d/dt f(e) = f_t, as f_θ is zero or ė is, and
//! d²/dt² f(e) = f_tt − f_θt²/f_θθ at a dead point and f_tt at an end of the interval. With the unknown
//! at a unit rate the second rate is f_θθ, and with both moving f_θθ + 2 f_θt + f_tt.

use crate::equations::jet::Jet;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::symbol::Sym;
use crate::equations::unknown::{Sides, sides, trend};
use crate::ir::graph::{Node, RootSearch, Target};
use crate::ir::implicit::Implicit;
use crate::ir::program::Clearance;
use crate::model::mechanism::{Mode, UnknownId};

/// One end: the distance with its rates, its scale, and a flag that is one at a dead point and zero at an
/// end of the interval.
struct End<'s> {
    distance: Jet<'s>,
    scale: Sym<'s>,
    is_dead_point: Sym<'s>,
}

/// Clearances of both ends, given everything in front of the unknown.
pub(super) fn of_ends<'s>(known: &Kinematics<'s>, id: UnknownId) -> Vec<Clearance> {
    let unknown = &known.mechanism.unknowns[id.index()];
    let ends = [0, 1].map(|at| end(known, id, at));
    let entry = |param, distance: Jet<'s>, scale: Sym<'s>| Clearance {
        group: unknown.group.0,
        param,
        value: distance.value.id,
        scale: scale.id,
        rates: Some([distance.rate.id, distance.accel.id]),
    };
    let Mode::Param(param) = unknown.mode else {
        return ends.map(|end| entry(None, end.distance, end.scale)).into();
    };
    // A trend that can change does so at both dead points, and at no end of the interval.
    let [at_dead_points, at_edges] =
        [true, false].map(|wants| ends.each_ref().map(|end| end.or_clear(wants)));
    let [lower, upper] = at_dead_points;
    let both = entry(Some(param.0), lower * upper, ends[0].scale * ends[1].scale);
    let [lower, upper] = at_edges;
    vec![both, entry(None, lower, ends[0].scale), entry(None, upper, ends[1].scale)]
}

/// Entry of the known root. It is never near zero, but on a stretch it has to agree with the stretch's ends.
pub(super) fn of_root<'s>(known: &Kinematics<'s>, id: UnknownId) -> Clearance {
    let unknown = &known.mechanism.unknowns[id.index()];
    let [from, to] = unknown.between.each_ref().map(|end| known.jet(end).value);
    let (Jet { value, rate, accel }, width) = (known.unknowns[id.index()], to - from);
    Clearance {
        group: unknown.group.0,
        param: None,
        value: (value - from + width).id,
        scale: width.id,
        rates: Some([rate.id, accel.id]),
    }
}

fn end<'s>(known: &Kinematics<'s>, id: UnknownId, at: u8) -> End<'s> {
    let (builder, unknown) = (known.builder, &known.mechanism.unknowns[id.index()]);
    let (zero, one) = (builder.zero(), builder.integer(1));
    let at_rest = || InputMotion::at_rest(&known.inputs, builder);
    let difference = |[left, right]: Sides<'s>| left - right;
    let jet = |value, rate| Jet { value, rate, accel: zero };
    let of_trial = |trial, inputs| sides(known, trial, inputs, true);
    let tried = difference(of_trial(jet(builder.node(Node::Trial(id.0)), one), at_rest()));
    let between = unknown.between.each_ref().map(|end| known.jet(end).value);
    let search = builder.implicit(Implicit::Root(RootSearch {
        unknown: id.0,
        wanted: Target::End(at),
        trend: trend(unknown),
        between: between.map(|end| end.id),
        near: None,
        sides: [tried.value.id, tried.rate.id, tried.accel.id],
    }));
    let place = builder.node(Node::Solved(search, 0, None));
    let is_dead_point = builder.node(Node::Solved(search, 1, Some(place.id)));
    let standing = of_trial(jet(place, zero), known.inputs.clone());
    let turning = difference(of_trial(jet(place, one), at_rest()));
    let moving = difference(of_trial(jet(place, one), known.inputs.clone()));
    let (by_inputs, bend) = (difference(standing), turning.accel);
    let mixed = (moving.accel - bend - by_inputs.accel).half();
    let carried = if mixed.is_zero() {
        zero
    } else {
        // One in place of a curvature that nothing is divided by.
        is_dead_point * mixed.squared() / (is_dead_point * bend + (one - is_dead_point))
    };
    let sign = known.mode(unknown.mode);
    let sign = if at == 0 { -sign } else { sign };
    let distance = Jet { accel: by_inputs.accel - carried, ..by_inputs }.times(sign);
    // The scale: the size of both sides and their change over a quarter of the interval.
    let quarter = (between[1] - between[0]).half().half();
    let [left, right] = standing.map(|side| side.value);
    let changes = (turning.rate * quarter).hypot(bend * quarter.squared());
    End { distance, scale: left.hypot(right).hypot(changes), is_dead_point }
}

impl<'s> End<'s> {
    /// The distance at a dead point, or at an end of the interval; elsewhere it is as large as the scale.
    fn or_clear(&self, at_dead_points: bool) -> Jet<'s> {
        let one = self.scale.builder().integer(1);
        let (here, elsewhere) = match at_dead_points {
            true => (self.is_dead_point, one - self.is_dead_point),
            false => (one - self.is_dead_point, self.is_dead_point),
        };
        self.distance.times(here) + Jet::constant(self.scale * elsewhere)
    }
}
