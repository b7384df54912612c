//! Machines of six topologies, drawn by a seed, as they are declared and as a hand solves them.

use super::forms::{Form, Straightforward};
use super::plane::{Crank, Dyad, Link, Moving, Rail, Slide, Vector};
use crate::prove::computed::Float;

#[derive(Clone, Copy, Debug)]
pub(super) enum Topology {
    FourBar,
    SliderCrank,
    InvertedSlider,
    SixBar,
    Stephenson,
    TenLinks,
}

pub(super) const TOPOLOGIES: [Topology; 6] = [
    Topology::FourBar,
    Topology::SliderCrank,
    Topology::InvertedSlider,
    Topology::SixBar,
    Topology::Stephenson,
    Topology::TenLinks,
];

/// A machine behind a crank at the origin. Places `at` are in a link's axes.
pub(super) enum Machine {
    FourBar { crank: f64, dyad: Dyad, at: [f64; 2] },
    SliderCrank { crank: f64, height: f64, slope: i32, rod: [f64; 2], at: [f64; 2] },
    InvertedSlider { crank: f64, pivot: [f64; 2], offset: f64, at: [f64; 2] },
    SixBar { crank: f64, pivot: [f64; 2], reach: f64, height: f64 },
    Stephenson { crank: f64, dyads: [Dyad; 2], at: [f64; 2] },
    TenLinks { crank: f64, dyads: [Dyad; 4], at: [f64; 2] },
}

/// Quantities of each order, of one component or of two; and the smallest of the distances from limits, as shares.
pub(super) struct Answer {
    pub orders: [Vec<Vec<f64>>; 3],
    pub clear: f64,
}

impl Answer {
    fn new() -> Self {
        Self { orders: [Vec::new(), Vec::new(), Vec::new()], clear: 1.0 }
    }

    fn point<T: Float>(&mut self, point: Moving<T>) {
        let all = [point.position, point.velocity, point.acceleration];
        for (order, Vector { x, y }) in self.orders.iter_mut().zip(all) {
            order.push(vec![x.wide(), y.wide()]);
        }
    }

    fn link<T: Float>(&mut self, form: &impl Form<T>, link: Link<T>) {
        let Vector { x, y } = form.direction(link);
        self.orders[0].push(vec![x.wide(), y.wide()]);
        self.orders[1].push(vec![link.omega.wide()]);
        self.orders[2].push(vec![link.alpha.wide()]);
    }

    fn slide<T: Float>(&mut self, slide: Slide<T>) {
        self.orders.iter_mut().zip(slide).for_each(|(order, value)| order.push(vec![value.wide()]));
    }

    fn keeps_off(&mut self, share: f64) {
        // NaN is out of reach.
        self.clear = if share >= self.clear { self.clear } else { share };
    }

    /// By the sine of the angle between the bars.
    fn dyad<T: Float>(&mut self, [second, third]: [Link<T>; 2]) {
        let [[x2, y2], [x3, y3]] = [second.r, third.r].map(|r| [r.x.wide(), r.y.wide()]);
        self.keeps_off((x2 * y3 - y2 * x3).abs() / (second.length * third.length));
    }
}

impl Machine {
    /// The hand's answer.
    pub(super) fn solve<T: Float>(&self, form: &impl Form<T>, input: [T; 3]) -> Answer {
        let mut answer = Answer::new();
        match *self {
            Self::FourBar { crank: length, dyad, at } => {
                let (pin, bars) = form.crank_dyad(Crank { length, input }, dyad);
                answer.point(form.point(pin, bars[0], at));
                bars.into_iter().for_each(|bar| answer.link(form, bar));
                answer.dyad(bars);
            }
            Self::SliderCrank { crank: length, height, slope, rod, at } => {
                let (sin, cos) = f64::from(slope).to_radians().sin_cos();
                let rail = Rail { origin: [0.0, height], direction: [cos, sin] };
                let (pin, bar, slide) = form.rod(Crank { length, input }, rail, rod);
                answer.point(form.point(pin, bar, at));
                answer.link(form, bar);
                answer.slide(slide);
                let across = bar.r.x.wide() * cos + bar.r.y.wide() * sin;
                answer.keeps_off(across.abs() / rod[0]);
            }
            Self::InvertedSlider { crank: length, pivot, offset, at } => {
                let (bar, slide) = form.block(Crank { length, input }, pivot, offset);
                answer.point(form.point(Moving::still(pivot), bar, at));
                answer.link(form, bar);
                answer.slide(slide);
                answer.keeps_off(slide[0].wide() / (length + pivot[0].hypot(pivot[1])));
            }
            Self::SixBar { crank: length, pivot, reach, height } => {
                let (bar, slide) = form.block(Crank { length, input }, pivot, 0.0);
                let Moving { position: at, velocity: v, acceleration: a } =
                    form.point(Moving::still(pivot), bar, [reach, 0.0]);
                answer.link(form, bar);
                answer.slide(slide);
                answer.slide([at.x, v.x, a.x]);
                answer.slide([at.y - T::of(height), v.y, a.y]);
                answer.keeps_off(slide[0].wide() / (length + pivot[0].hypot(pivot[1])));
            }
            Self::Stephenson { crank: length, dyads: [first, second], at } => {
                let (pin, bars) = form.crank_dyad(Crank { length, input }, first);
                let point = form.point(pin, bars[0], at);
                let next = form.dyad(point, second);
                let pivot = Moving::still(second.pivot);
                answer.point(point);
                answer.point(form.point(pivot, next[1], [second.lengths[1], 0.0]));
                answer.link(form, next[1]);
                [bars, next].into_iter().for_each(|bars| answer.dyad(bars));
            }
            Self::TenLinks { crank: length, ref dyads, at } => {
                let (_, mut bars) = form.crank_dyad(Crank { length, input }, dyads[0]);
                answer.dyad(bars);
                for pair in dyads.windows(2) {
                    let point = form.point(Moving::still(pair[0].pivot), bars[1], at);
                    bars = form.dyad(point, pair[1]);
                    answer.dyad(bars);
                }
                let pivot = Moving::still(dyads[3].pivot);
                answer.point(form.point(pivot, bars[1], [dyads[3].lengths[1], 0.0]));
                answer.link(form, bars[1]);
            }
        }
        answer
    }

    /// The declaration.
    pub(super) fn source(&self) -> String {
        let rrr =
            |nth: usize, from: &str, Dyad { pivot: [x, y], lengths: [l2, l3], side }: Dyad| {
                let mode = if side > 0.0 { "left" } else { "right" };
                format!(
                    "ground D{nth}({x}, {y}); rrr L{nth}({from}), R{nth}(D{nth}) -> C{nth} \
                 {{ lengths: ({l2}, {l3}), mode: {mode} }} "
                )
            };
        let point = |name: &str, link: &str, [x, y]: [f64; 2]| {
            format!("point {name} on {link} at ({x}, {y}); ")
        };
        let (crank, rest) = match *self {
            Self::FourBar { crank, dyad, at } => {
                let dyad = rrr(1, "B", dyad) + &point("P", "L1", at);
                (crank, dyad + "output P, L1, R1;")
            }
            Self::SliderCrank { crank, height, slope, rod: [length, offset], at } => {
                let group = format!(
                    "guide g through (0, {height}) along {slope}deg; \
                     rrp rod(B), block(g) -> C {{ length: {length}, offset: {offset}, mode: ahead }} "
                );
                (crank, group + &point("P", "rod", at) + "output P, rod, block.slide;")
            }
            Self::InvertedSlider { crank, pivot: [x, y], offset, at } => {
                let offset = match offset == 0.0 {
                    true => String::new(),
                    false => format!("offset: {offset}, "),
                };
                let group =
                    format!("ground D({x}, {y}); rpr block(B), rod(D) {{ {offset}mode: ahead }} ");
                (crank, group + &point("P", "rod", at) + "output P, rod, block.slide;")
            }
            Self::SixBar { crank, pivot: [x, y], reach, height } => {
                let groups = format!(
                    "ground D({x}, {y}); guide g through (0, {height}) along 0deg; \
                     rpr block(B), rod(D) {{ mode: ahead }} point E on rod at ({reach}, 0); \
                     rpp pin(E), ram(g) {{ slot: 90deg }} "
                );
                (crank, groups + "output rod, block.slide, ram.slide, pin.slide;")
            }
            Self::Stephenson { crank, dyads: [first, second], at } => {
                let first = rrr(1, "B", first) + &point("P", "L1", at);
                (crank, first + &rrr(2, "P", second) + "output P, C2, R2;")
            }
            Self::TenLinks { crank, ref dyads, at } => {
                let mut text = rrr(1, "B", dyads[0]);
                for (nth, &dyad) in dyads.iter().enumerate().skip(1) {
                    text += &point(&format!("P{nth}"), &format!("R{nth}"), at);
                    text += &rrr(nth + 1, &format!("P{nth}"), dyad);
                }
                (crank, text + "output C4, R4;")
            }
        };
        format!(
            "struct M {{ input q: angle; ground A(0, 0); \
             crank AB(A) -> B {{ length: {crank}, angle: q }} {rest} }}"
        )
    }

    /// True if the machine turns fully, away from its limits: no angle between bars has a sine below 0.3, no
    /// block comes nearer to its pivot than a fifth of its longest distance.
    fn turns(&self) -> bool {
        (0..64).all(|step| {
            let angle = f64::from(step) * (core::f64::consts::TAU / 64.0);
            let least = match self {
                Self::InvertedSlider { .. } | Self::SixBar { .. } => 0.2,
                _ => 0.3,
            };
            self.solve(&Straightforward, [angle, 1.0, 0.0]).clear >= least
        })
    }
}

/// Dimensions in tenths of a millimetre, by Marsaglia's xorshift.
pub(super) struct Draw(pub u64);

impl Draw {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % count as u64) as usize
    }

    fn between(&mut self, [low, high]: [f64; 2]) -> f64 {
        let (low, high) = ((low * 1e4).round(), (high * 1e4).round());
        (low + self.below((high - low) as usize + 1) as f64) / 1e4
    }

    fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    fn side(&mut self) -> f64 {
        if self.one_in(2) { 1.0 } else { -1.0 }
    }

    /// A point at this distance to the right at most, every other on the axis.
    fn pivot(&mut self, x: [f64; 2], y: [f64; 2]) -> [f64; 2] {
        [self.between(x), if self.one_in(2) { 0.0 } else { self.between(y) }]
    }

    fn lengths(&mut self, range: [f64; 2]) -> [f64; 2] {
        [self.between(range), self.between(range)]
    }

    fn candidate(&mut self, topology: Topology) -> Machine {
        match topology {
            Topology::FourBar => {
                let pivot = self.pivot([0.1, 0.5], [-0.2, 0.2]);
                let dyad = Dyad { pivot, lengths: self.lengths([0.1, 0.6]), side: self.side() };
                let at = [self.between([-0.1, 0.6]), self.between([-0.3, 0.3])];
                Machine::FourBar { crank: self.between([0.05, 0.15]), dyad, at }
            }
            Topology::SliderCrank => Machine::SliderCrank {
                crank: self.between([0.05, 0.15]),
                height: if self.one_in(2) { 0.0 } else { self.between([-0.1, 0.1]) },
                slope: if self.one_in(2) { 0 } else { self.below(121) as i32 - 60 },
                rod: [
                    self.between([0.15, 0.6]),
                    if self.one_in(2) { 0.0 } else { self.between([-0.1, 0.1]) },
                ],
                at: [self.between([0.0, 0.5]), self.between([-0.2, 0.2])],
            },
            Topology::InvertedSlider => Machine::InvertedSlider {
                crank: self.between([0.05, 0.3]),
                pivot: self.pivot([-0.4, 0.4], [-0.4, 0.4]),
                offset: if self.one_in(2) { 0.0 } else { self.between([-0.1, 0.1]) },
                at: [self.between([0.1, 0.8]), self.between([-0.2, 0.2])],
            },
            Topology::SixBar => Machine::SixBar {
                crank: self.between([0.1, 0.5]),
                pivot: [
                    if self.one_in(2) { 0.0 } else { self.between([-0.3, 0.3]) },
                    self.between([-1.2, -0.3]),
                ],
                reach: self.between([0.8, 2.0]),
                height: self.between([0.2, 1.0]),
            },
            Topology::Stephenson => {
                let first = [self.pivot([0.06, 0.16], [-0.05, 0.05]), self.lengths([0.06, 0.16])];
                let second = [self.pivot([0.1, 0.3], [-0.1, 0.15]), self.lengths([0.06, 0.2])];
                let dyads = [first, second].map(|[pivot, lengths]| Dyad {
                    pivot,
                    lengths,
                    side: self.side(),
                });
                let at = [self.between([0.02, 0.12]), self.between([-0.08, 0.08])];
                Machine::Stephenson { crank: self.between([0.02, 0.05]), dyads, at }
            }
            Topology::TenLinks => {
                let mut x = 0.0;
                let dyads = [(); 4].map(|()| {
                    x += self.between([0.08, 0.12]);
                    let y = if self.one_in(2) { 0.0 } else { self.between([-0.03, 0.03]) };
                    let pivot = [(x * 1e4_f64).round() / 1e4, y];
                    Dyad { pivot, lengths: self.lengths([0.07, 0.13]), side: 1.0 }
                });
                let at = [self.between([0.04, 0.08]), self.between([-0.03, 0.03])];
                Machine::TenLinks { crank: self.between([0.02, 0.05]), dyads, at }
            }
        }
    }

    /// The next machine of a topology that turns fully.
    pub(super) fn machine(&mut self, topology: Topology) -> Machine {
        loop {
            let machine = self.candidate(topology);
            if machine.turns() {
                return machine;
            }
        }
    }

    /// A share of one.
    pub(super) fn share(&mut self) -> f64 {
        self.below(1 << 20) as f64 / f64::from(1 << 20)
    }
}
