//! Springs and dampers.
//!
//! # Between two points
//! With d from the first to the second, L = |d|, and what pushes the ends apart
//!
//! ```text
//! S = −k (L − L₀) − c L̇      L̇ = (d·ḋ)/L
//! ```
//!
//! the force on the second is (S/L) d, its opposite on the first. Where the ends meet there is no
//! direction, unless L₀ = 0 and c = 0: then the force is −k d, without a root. Energy: ½ k (L − L₀)².
//!
//! # Between two bodies
//! φ is the angle of the second against the first and the free angle; on the second acts −k φ − c φ̇,
//! its opposite on the first. Energy: ½ k φ². Where cranks turn both, or guides that inputs turn, or where they differ by
//! what such turn, φ is the sum of their angles. In a drawing that is taken to within half a turn where a drive, as one
//! against a crank, says that its link has turned farther than it is drawn. Elsewhere φ lies in (−π, π]: it comes from the
//! two unit vectors, or is a sum of angles that stand still.
//!
//! # Source
//! Norton, Design of Machinery, ch. 10 and 15.

use std::f64::consts::{PI, TAU};

use crate::equations::forces::provided::{Line, not_negative, vector};
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::{Sym, Vector};
use crate::exact::Exact;
use crate::function::Function;
use crate::model::acting::{Elastic, Ends, Spring};
use crate::model::mechanism::{AngleSum, Carrier, LinkId, PointId, SpringId};

/// Stiffness, damping, and the length or angle at which it is slack.
struct Numbers<'s> {
    stiffness: Sym<'s>,
    damping: Sym<'s>,
    free: Sym<'s>,
}

fn numbers<'s>(kinematics: &Kinematics<'s>, index: usize) -> Numbers<'s> {
    let mechanism = kinematics.mechanism;
    let Spring { stiffness, damping, free, ends, .. } = &mechanism.dynamics.springs[index];
    let title = mechanism.title_of(Elastic::Spring(index));
    Numbers {
        stiffness: not_negative(kinematics, stiffness, title),
        damping: not_negative(kinematics, damping, title),
        free: match ends {
            Ends::Points(_) => not_negative(kinematics, free, title),
            Ends::Bodies([first, second]) => {
                let turn = |body| turn_of(kinematics, body);
                kinematics.jet(&free.value).value + (turn(*first) - turn(*second))
            }
        },
    }
}

/// The angle of a body's frame, as it is drawn, against that of its group.
fn turn_of<'s>(kinematics: &Kinematics<'s>, body: Carrier) -> Sym<'s> {
    let turn = match body {
        Carrier::Ground => None,
        Carrier::Link(link) => kinematics.mechanism.turn_of(link),
    };
    turn.map_or(kinematics.builder.zero(), |turn| kinematics.jet(turn).value)
}

/// The springs between points, with their numbers in the declaration.
fn between_points<'k>(
    kinematics: &'k Kinematics<'_>,
) -> impl Iterator<Item = (usize, [PointId; 2])> + 'k {
    let springs = kinematics.mechanism.dynamics.springs.iter().enumerate();
    springs.filter_map(|(index, spring)| match spring.ends {
        Ends::Points(points) => Some((index, points)),
        Ends::Bodies(_) => None,
    })
}

fn between_bodies<'k>(
    kinematics: &'k Kinematics<'_>,
) -> impl Iterator<Item = (usize, [Carrier; 2])> + 'k {
    let springs = kinematics.mechanism.dynamics.springs.iter().enumerate();
    springs.filter_map(|(index, spring)| match spring.ends {
        Ends::Bodies(bodies) => Some((index, bodies)),
        Ends::Points(_) => None,
    })
}

/// Forces of the springs on their end points.
pub(super) fn forces<'s>(kinematics: &Kinematics<'s>) -> Vec<(PointId, Vector<'s>)> {
    let forces = between_points(kinematics).flat_map(|(index, points)| {
        let force = force(kinematics, index, points);
        [(points[0], -force), (points[1], force)]
    });
    forces.collect()
}

/// The force on the second point.
fn force<'s>(kinematics: &Kinematics<'s>, index: usize, points: [PointId; 2]) -> Vector<'s> {
    let Numbers { stiffness, damping, free } = numbers(kinematics, index);
    if free.is_zero() && damping.is_zero() {
        return -(stiffness * vector(kinematics, points));
    }
    let line = line(kinematics, index, points);
    (push(kinematics, index, points) * line.inverse) * line.vector
}

fn line<'s>(kinematics: &Kinematics<'s>, index: usize, points: [PointId; 2]) -> Line<'s> {
    Line::between(kinematics, points, kinematics.mechanism.title_of(Elastic::Spring(index)))
}

/// Force that pushes the ends apart.
fn push<'s>(kinematics: &Kinematics<'s>, index: usize, points: [PointId; 2]) -> Sym<'s> {
    let Numbers { stiffness, damping, free } = numbers(kinematics, index);
    if free.is_zero() && damping.is_zero() {
        return -(stiffness * length(kinematics, points));
    }
    let line = line(kinematics, index, points);
    let [x, y] = points.map(|point| kinematics.point(point).velocity);
    let closing = line.vector.dot(y - x) * line.inverse;
    -(stiffness * (line.length - free) + damping * kinematics.at_rate_scale(closing))
}

/// The square of a length that may be zero.
fn square_of_length<'s>(kinematics: &Kinematics<'s>, points: [PointId; 2]) -> Sym<'s> {
    let vector = vector(kinematics, points);
    vector.dot(vector)
}

fn length<'s>(kinematics: &Kinematics<'s>, points: [PointId; 2]) -> Sym<'s> {
    square_of_length(kinematics, points).sqrt()
}

/// Couples of the torsion springs on their bodies.
pub(super) fn couples<'s>(kinematics: &Kinematics<'s>) -> Vec<(Carrier, Sym<'s>)> {
    let couples = between_bodies(kinematics).flat_map(|(index, [first, second])| {
        let couple = couple(kinematics, index);
        [(first, -couple), (second, couple)]
    });
    couples.collect()
}

/// The couple on the second body.
fn couple<'s>(kinematics: &Kinematics<'s>, index: usize) -> Sym<'s> {
    let Numbers { stiffness, damping, .. } = numbers(kinematics, index);
    let twist = twist(kinematics, SpringId(index as u32));
    -(stiffness * twist.value + damping * kinematics.at_rate_scale(twist.rate))
}

/// Effort of the spring: a push or a couple.
pub(in crate::equations::forces) fn effort<'s>(
    kinematics: &Kinematics<'s>,
    index: usize,
) -> Sym<'s> {
    match kinematics.mechanism.dynamics.springs[index].ends {
        Ends::Points(points) => push(kinematics, index, points),
        Ends::Bodies(_) => couple(kinematics, index),
    }
}

/// Energy stored in all springs: ½ k (L − L₀)² and ½ k φ².
pub(super) fn energy<'s>(kinematics: &Kinematics<'s>) -> Sym<'s> {
    let straight = between_points(kinematics).map(|(index, points)| {
        let Numbers { stiffness, free, .. } = numbers(kinematics, index);
        let square = match free.is_zero() {
            true => square_of_length(kinematics, points),
            false => (length(kinematics, points) - free).squared(),
        };
        stiffness.half() * square
    });
    let twisted = between_bodies(kinematics).map(|(index, _)| {
        let twist = twist(kinematics, SpringId(index as u32)).value;
        numbers(kinematics, index).stiffness.half() * twist.squared()
    });
    straight.chain(twisted).fold(kinematics.builder.zero(), |sum, energy| sum + energy)
}

/// Angle by which a spring between two bodies is turned from its free angle.
pub(in crate::equations) fn twist<'s>(kinematics: &Kinematics<'s>, id: SpringId) -> Jet<'s> {
    let mechanism = kinematics.mechanism;
    let Ends::Bodies([first, second]) = mechanism.dynamics.springs[id.index()].ends else {
        unreachable!("the model asks springs between bodies alone")
    };
    let free = numbers(kinematics, id.index()).free;
    let of = |body, times| match body {
        Carrier::Ground => None,
        Carrier::Link(link) => Some((link, times)),
    };
    let links: Vec<_> = of(second, 1).into_iter().chain(of(first, -1)).collect();
    let mut turned = Turned::by(Jet::constant(-free), whole_turns(kinematics, &links));
    turned.add_body(kinematics, second, 1);
    turned.add_body(kinematics, first, -1);
    if let Some(sum) = turned.sum() {
        return sum;
    }
    let [first, second] = [first, second].map(|body| kinematics.carrier(body).direction);
    let unit = Vector { x: free.cos(), y: free.sin() };
    let (sine, cosine) = first.turned_by(Jet::constant(free), unit).sin_cos_to(second);
    let (rate, accel) = (second.omega - first.omega, second.alpha - first.alpha);
    Jet { value: sine.apply2(Function::Atan2, cosine), rate, accel }
}

/// The angle by which a sum of links' angles is above another one.
pub(super) fn turned_from<'s>(
    kinematics: &Kinematics<'s>,
    sum: &AngleSum,
    from: Sym<'s>,
) -> Jet<'s> {
    let rest = kinematics.jet(&sum.rest) + Jet::constant(-from);
    let links = sum.links.iter().map(|&(link, times)| (link, i64::from(times)));
    let whole = whole_turns(kinematics, &links.collect::<Vec<_>>());
    let mut turned = Turned::by(rest, whole);
    for &(link, times) in &sum.links {
        turned.add_body(kinematics, Carrier::Link(link), i64::from(times));
    }
    if let Some(sum) = turned.sum() {
        return sum;
    }
    let ground = kinematics.carrier(Carrier::Ground).direction;
    let to = kinematics.turned(ground, sum);
    let unit = Vector { x: from.cos(), y: from.sin() };
    let (sine, cosine) = ground.turned_by(Jet::constant(from), unit).sin_cos_to(to);
    Jet { value: sine.apply2(Function::Atan2, cosine), rate: to.omega, accel: to.alpha }
}

/// An angle as a sum: what drives bodies says by how much they are turned, of the others their own
/// angles remain.
struct Turned<'s> {
    links: Vec<(LinkId, i64)>,
    /// The links among them that cranks turn, as often as they are counted.
    cranks: Vec<(LinkId, i64)>,
    rest: Jet<'s>,
    /// The whole turns by which drives say more than the drawing.
    whole: Option<Sym<'s>>,
}

/// The angle by which drives have turned a sum of links' angles in the drawing beyond half a turn.
fn whole_turns<'s>(kinematics: &Kinematics<'s>, links: &[(LinkId, i64)]) -> Option<Sym<'s>> {
    let turns = kinematics.mechanism.turns_of_drives(links);
    let builder = kinematics.builder;
    (turns != 0).then(|| builder.integer(turns) * builder.constant(Exact::pi()).twice())
}

impl<'s> Turned<'s> {
    fn by(rest: Jet<'s>, whole: Option<Sym<'s>>) -> Self {
        Self { links: Vec::new(), cranks: Vec::new(), rest, whole }
    }

    /// The angle where nothing but drivers and guides says it. One that stands still is no count of turns.
    fn sum(&self) -> Option<Jet<'s>> {
        let is_none = |counted: &[(LinkId, i64)]| counted.iter().all(|(_, times)| *times == 0);
        is_none(&self.links).then(|| match is_none(&self.cranks) && self.rest.is_fixed() {
            true => Jet::constant(within_half_a_turn(self.rest.value)),
            false => self.whole.map_or(self.rest, |whole| self.rest + Jet::constant(whole)),
        })
    }

    fn add_body(&mut self, kinematics: &Kinematics<'s>, body: Carrier, times: i64) {
        let Carrier::Link(link) = body else { return };
        let mechanism = kinematics.mechanism;
        // The turns of an unknown that nobody wrote are a matter of how the machine is solved.
        let carried = mechanism.carried_angle(link).filter(|_| !mechanism.is_searched_for(link));
        let Some((carrier, turn)) = carried else { return add(&mut self.links, link, times) };
        if mechanism.is_crank(link) {
            add(&mut self.cranks, link, times);
        }
        self.add_body(kinematics, carrier, times);
        if let Some(turn) = turn {
            self.add_turn(kinematics, turn, times);
        }
    }

    fn add_turn(&mut self, kinematics: &Kinematics<'s>, turn: &AngleSum, times: i64) {
        for &(link, own) in &turn.links {
            self.add_body(kinematics, Carrier::Link(link), times * i64::from(own));
        }
        let factor = kinematics.builder.integer(times);
        self.rest = self.rest + kinematics.jet(&turn.rest).times(factor);
    }
}

fn add(counted: &mut Vec<(LinkId, i64)>, link: LinkId, times: i64) {
    match counted.iter_mut().find(|(known, _)| *known == link) {
        Some((_, sum)) => *sum += times,
        None => counted.push((link, times)),
    }
}

/// The angle in (−π, π], as it is where it is known to lie there.
fn within_half_a_turn(angle: Sym<'_>) -> Sym<'_> {
    match angle.constant_value() {
        Some(value) if value.abs() < PI => angle,
        Some(value) => {
            let turns = angle.builder().integer((0.5 - value / TAU).floor() as i64);
            angle + turns * angle.builder().constant(Exact::pi()).twice()
        }
        None => angle.sin().apply2(Function::Atan2, angle.cos()),
    }
}
