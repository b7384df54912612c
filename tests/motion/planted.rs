//! Plan a pose, a velocity and an acceleration of a group, derive the dimensions and the motion
//! of its joints from the plan, and let the solver find the plan again.
//!
//! Tolerances: every dimension and input is rounded once on its way into the solver, and the
//! solver rounds some 60 times on the way to an acceleration. Roundings of either sign, n of them
//! up to half ε, add up to √(n/12) ε; let κ be twice that, 4.5 ε · size / |sin|, for a pose, where size is the sum of the lengths and coordinates over
//! the shortest length and sin that of the angle at the inner joint (of the guides, of bar and
//! guide). A velocity solves equations whose matrix has the condition 1/|sin| and is perturbed by
//! κ: its error is κ · W / |sin|, W the sum of all rates. An acceleration solves them once more
//! with a right side that holds squares of velocities: κ · (A + 2 W² / |sin|) / |sin|.

use linkage_core::{Direction, Point, Real, Sense, Side};
use linkage_tests::in_both_widths;
use linkage_tests::mechanisms::driven_groups::*;
use linkage_tests::random::Random;
use linkage_tests::rigid_motion::{Jet, Moving};
use linkage_tests::widths::{list, number};

const POSES: usize = 2000;

/// The quantities that determine the tolerances.
struct Scale {
    /// Lengths and coordinates over the shortest length.
    size: f64,
    /// 1/|sin| of the group.
    lever: f64,
    rates: f64,
    seconds: f64,
}

impl Scale {
    fn tolerance<T: Real>(&self, order: usize) -> f64 {
        let pose = 4.5 * T::EPSILON * self.size * self.lever;
        match order {
            0 => pose,
            1 => pose * self.rates * self.lever,
            _ => pose * (self.seconds + 2.0 * self.rates * self.rates * self.lever) * self.lever,
        }
    }

    fn check<T: Real>(&self, what: &str, order: usize, found: T, planned: f64) {
        let error = (found.value() - planned).abs();
        let allowed = self.tolerance::<T>(order);
        assert!(error <= allowed, "{what}, order {order}: {found:?} for {planned}: {error:e}");
    }

    fn jet<T: Real>(&self, what: &str, found: [T; 3], planned: Jet) {
        self.check(what, 0, found[0], planned.value);
        self.check(what, 1, found[1], planned.rate);
        self.check(what, 2, found[2], planned.second);
    }

    fn point<T: Real>(&self, found: [Point<T>; 3], planned: &Moving) {
        for (order, [x, y]) in planned.orders().into_iter().enumerate() {
            self.check("C.x", order, found[order].x, x);
            self.check("C.y", order, found[order].y, y);
        }
    }
}

fn any_jet(random: &mut Random, low: f64, high: f64) -> Jet {
    Jet {
        value: random.between(low, high),
        rate: random.between(-2.0, 2.0),
        second: random.between(-4.0, 4.0),
    }
}

fn any_point(random: &mut Random) -> Moving {
    let mut pair = |reach: f64| [random.between(-reach, reach), random.between(-reach, reach)];
    Moving { position: pair(2.0), velocity: pair(2.0), acceleration: pair(4.0) }
}

/// The three orders of several points' coordinates and of angles behind them.
fn inputs<T: Real, const N: usize>(points: &[Moving], angles: &[Jet]) -> [[T; N]; 3] {
    let mut lists = [[T::lit(0.0, 0.0); N]; 3];
    for order in 0..3 {
        let coordinates = points.iter().flat_map(|point| point.orders()[order]);
        let turns = angles.iter().map(|jet| [jet.value, jet.rate, jet.second][order]);
        for (place, value) in coordinates.chain(turns).enumerate() {
            lists[order][place] = number(value);
        }
    }
    lists
}

/// An angle's difference to the planned one, in (−π, π].
fn away<T: Real>(direction: Direction<T>, planned: f64) -> T {
    direction
        .angle_from(Direction { cos: number::<T>(planned.cos()), sin: number::<T>(planned.sin()) })
}

/// Sums of rates over all that moves, per shortest length.
fn pace(points: &[Moving], jets: &[Jet], shortest: f64) -> (f64, f64) {
    let size = |v: [f64; 2]| v[0].hypot(v[1]) / shortest;
    let rates = points.iter().map(|p| size(p.velocity)).sum::<f64>();
    let seconds = points.iter().map(|p| size(p.acceleration)).sum::<f64>();
    let turning = jets.iter().map(|j| j.rate.abs()).sum::<f64>();
    let spinning = jets.iter().map(|j| j.second.abs()).sum::<f64>();
    (rates + turning / shortest.min(1.0), seconds + spinning / shortest.min(1.0))
}

fn rrr<T: Real>() {
    let mut random = Random::new(1);
    let mut poses = 0;
    while poses < POSES {
        let (c, one) = (any_point(&mut random), any_jet(&mut random, -3.0, 3.0));
        let two = any_jet(&mut random, -3.0, 3.0);
        let (l1, l2) = (random.between(0.3, 2.0), random.between(0.3, 2.0));
        let sin = (two.value - one.value).sin();
        if sin.abs() < 0.2 {
            continue;
        }
        poses += 1;
        // The bars point towards C: their outer joints are behind it.
        let zero = Jet::constant(0.0);
        let b = c.carry(one, Jet::constant(-l1), zero);
        let d = c.carry(two, Jet::constant(-l2), zero);
        // C is left of BD where the bars, seen from outside, turn left from first to second.
        let elbow = if sin > 0.0 { Side::Left } else { Side::Right };
        let bars = DrivenRrr { l1: number::<T>(l1), l2: number(l2), elbow };
        let [q, rate, second] = inputs::<T, 4>(&[b, d], &[]);
        let found = bars.motion(q, rate, second).unwrap();

        let shortest = l1.min(l2);
        let reach = [b, c, d].iter().map(|p| p.position[0].hypot(p.position[1])).sum::<f64>();
        let (rates, seconds) = pace(&[b, c, d], &[one, two], shortest);
        let size = (l1 + l2 + reach) / shortest;
        let scale = Scale { size, lever: sin.abs().recip(), rates, seconds };
        let (p, v, a) = (found.position, found.velocity, found.acceleration);
        scale.point([p.C, v.C, a.C], &c);
        scale.jet("BC", [away(p.BC, one.value), v.BC.omega, a.BC.alpha], one.relative());
        scale.jet("DC", [away(p.DC, two.value), v.DC.omega, a.DC.alpha], two.relative());
    }
}

fn rrp<T: Real>() {
    let mut random = Random::new(2);
    let mut poses = 0;
    while poses < POSES {
        let (k, frame) = (any_point(&mut random), any_jet(&mut random, -3.0, 3.0));
        let (slide, e) = (any_jet(&mut random, -2.0, 2.0), random.between(-1.0, 1.0));
        let (bar, l) = (any_jet(&mut random, -3.0, 3.0), random.between(0.3, 2.0));
        let cos = (bar.value - frame.value).cos();
        if cos.abs() < 0.2 {
            continue;
        }
        poses += 1;
        let c = k.carry(frame, slide, Jet::constant(e));
        let b = c.carry(bar, Jet::constant(-l), Jet::constant(0.0));
        let side = if cos > 0.0 { Sense::Ahead } else { Sense::Behind };
        let group = DrivenRrp { l: number::<T>(l), e: number(e), side };
        let [q, rate, second] = inputs::<T, 5>(&[b, k], &[frame]);
        let found = group.motion(q, rate, second).unwrap();

        let reach = [b, c, k].iter().map(|p| p.position[0].hypot(p.position[1])).sum::<f64>();
        let (rates, seconds) = pace(&[b, c, k], &[frame, slide, bar], l);
        // The guide's angle is rounded too, and turns everything up to 3 rad · size.
        let size = 3.0 * (l + e.abs() + slide.value.abs() + reach) / l;
        let scale = Scale { size, lever: cos.abs().recip(), rates, seconds };
        let (p, v, a) = (found.position, found.velocity, found.acceleration);
        scale.point([p.C, v.C, a.C], &c);
        scale.jet("BC", [away(p.BC, bar.value), v.BC.omega, a.BC.alpha], bar.relative());
        scale.jet("slide", [p.block.slide, v.block.slide, a.block.slide], slide);
        scale.jet(
            "block",
            [away(p.block.into(), frame.value), v.block.omega, a.block.alpha],
            frame.relative(),
        );
    }
}

fn rpr<T: Real>() {
    let mut random = Random::new(3);
    for _ in 0..POSES {
        let (d, bar) = (any_point(&mut random), any_jet(&mut random, -3.0, 3.0));
        let e = random.between(-1.0, 1.0);
        let mut slide = any_jet(&mut random, 0.3, 2.0);
        let side = if random.between(-1.0, 1.0) < 0.0 { Sense::Ahead } else { Sense::Behind };
        if side == Sense::Behind {
            slide.value = -slide.value;
        }
        let b = d.carry(bar, slide, Jet::constant(e));
        let group = DrivenRpr { e: number::<T>(e), side };
        let [q, rate, second] = inputs::<T, 4>(&[b, d], &[]);
        let found = group.motion(q, rate, second).unwrap();

        let shortest = slide.value.abs();
        let reach = [b, d].iter().map(|p| p.position[0].hypot(p.position[1])).sum::<f64>();
        let (rates, seconds) = pace(&[b, d], &[bar, slide], shortest);
        // Square to BD the slide changes by |BD|/slide per length: the sine is slide/|BD|.
        let lever = shortest.hypot(e) / shortest;
        let size = (shortest + e.abs() + reach) / shortest;
        let scale = Scale { size, lever, rates, seconds };
        let (p, v, a) = (found.position, found.velocity, found.acceleration);
        scale.jet("bar", [away(p.bar, bar.value), v.bar.omega, a.bar.alpha], bar.relative());
        scale.jet("slide", [p.block.slide, v.block.slide, a.block.slide], slide);
    }
}

fn prp<T: Real>() {
    let mut random = Random::new(4);
    let mut poses = 0;
    while poses < POSES {
        let (k, one) = (any_point(&mut random), any_jet(&mut random, -3.0, 3.0));
        let two = any_jet(&mut random, -3.0, 3.0);
        let (s1, s2) = (any_jet(&mut random, -2.0, 2.0), any_jet(&mut random, -2.0, 2.0));
        let (e1, e2) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let sin = (two.value - one.value).sin();
        if sin.abs() < 0.2 {
            continue;
        }
        poses += 1;
        let c = k.carry(one, s1, Jet::constant(e1));
        // The second guide's datum lies back from C by (slide, offset) of its own frame.
        let back = Jet { value: -s2.value, rate: -s2.rate, second: -s2.second };
        let j = c.carry(two, back, Jet::constant(-e2));
        let group = DrivenPrp { e1: number::<T>(e1), e2: number(e2) };
        let flat = |order: usize| {
            let [kx, ky] = k.orders()[order];
            let [jx, jy] = j.orders()[order];
            let turn = |jet: Jet| [jet.value, jet.rate, jet.second][order];
            list::<T, 6>([kx, ky, turn(one), jx, jy, turn(two)])
        };
        let found = group.motion(flat(0), flat(1), flat(2)).unwrap();

        let reach = [c, j, k].iter().map(|p| p.position[0].hypot(p.position[1])).sum::<f64>();
        let (rates, seconds) = pace(&[c, j, k], &[one, two, s1, s2], 1.0);
        let lengths = s1.value.abs() + s2.value.abs() + e1.abs() + e2.abs();
        let size = 3.0 * (1.0 + lengths + reach);
        let scale = Scale { size, lever: sin.abs().recip(), rates, seconds };
        let (p, v, a) = (found.position, found.velocity, found.acceleration);
        scale.point([p.C, v.C, a.C], &c);
        scale.jet("p", [p.p.slide, v.p.slide, a.p.slide], s1);
        scale.jet("q", [p.q.slide, v.q.slide, a.q.slide], s2);
    }
}

fn rpp<T: Real>() {
    let mut random = Random::new(5);
    let mut poses = 0;
    while poses < POSES {
        let (k, frame) = (any_point(&mut random), any_jet(&mut random, -3.0, 3.0));
        let slot = random.between(-3.0, 3.0);
        let (s1, s2) = (any_jet(&mut random, -2.0, 2.0), any_jet(&mut random, -2.0, 2.0));
        let (e1, e2) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        if slot.sin().abs() < 0.2 {
            continue;
        }
        poses += 1;
        let turned = Jet { value: frame.value + slot, ..frame };
        let b = k.carry(frame, s1, Jet::constant(e1)).carry(turned, s2, Jet::constant(e2));
        let group = DrivenRpp { slot: number::<T>(slot), e1: number(e1), e2: number(e2) };
        let [q, rate, second] = inputs::<T, 5>(&[b, k], &[frame]);
        let found = group.motion(q, rate, second).unwrap();

        let reach = [b, k].iter().map(|p| p.position[0].hypot(p.position[1])).sum::<f64>();
        let (rates, seconds) = pace(&[b, k], &[frame, s1, s2], 1.0);
        let lengths = s1.value.abs() + s2.value.abs() + e1.abs() + e2.abs();
        let size = 3.0 * (1.0 + lengths + reach);
        let scale = Scale { size, lever: slot.sin().abs().recip(), rates, seconds };
        let (p, v, a) = (found.position, found.velocity, found.acceleration);
        scale.jet("yoke", [p.yoke.slide, v.yoke.slide, a.yoke.slide], s1);
        scale.jet("slide", [p.block.slide, v.block.slide, a.block.slide], s2);
        scale.jet(
            "block",
            [away(p.block.into(), turned.value), v.block.omega, a.block.alpha],
            frame.relative(),
        );
    }
}

in_both_widths! { rrr rrp rpr prp rpp }
