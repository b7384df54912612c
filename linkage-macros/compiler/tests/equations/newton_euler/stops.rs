//! Stops, one end after the other, from absolute positions, velocities and unit vectors.

use super::friction::under;
use super::{Applied, Part, acting, ids};
use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::{Sym, Vector};
use crate::function::Function;
use crate::ir::graph::Id;
use crate::model::acting::{Stop, Stopped};
use crate::model::mechanism::{AngleSum, Carrier, LinkId};

pub(super) fn stops(kinematics: &Kinematics<'_>) -> Vec<Applied<Id>> {
    let stops = kinematics.mechanism.dynamics.stops.iter();
    stops.flat_map(|stop| of(kinematics, stop)).collect()
}

fn of(kinematics: &Kinematics<'_>, stop: &Stop) -> Vec<Applied<Id>> {
    match &stop.of {
        Stopped::Angle(sum) => {
            let (angle, rate) = angle(kinematics, sum);
            let push = push(kinematics, stop, angle, rate);
            let couple = |&(link, times): &(LinkId, i32)| {
                let couple = kinematics.builder.integer(i64::from(times)) * push;
                acting::turn(kinematics, Carrier::Link(link), couple)
            };
            // The ground has the opposite of what an absolute angle is pushed by.
            let total: i64 = sum.links.iter().map(|&(_, times)| i64::from(times)).sum();
            let opposite = -(kinematics.builder.integer(total) * push);
            let ground = acting::turn(kinematics, Carrier::Ground, opposite);
            sum.links.iter().map(couple).chain([ground]).collect()
        }
        Stopped::Distance([p, q]) => {
            let [a, b] = [p, q].map(|point| kinematics.point(*point));
            let (d, v) = (b.position() - a.position(), b.velocity - a.velocity);
            let length = (d.x * d.x + d.y * d.y).sqrt();
            let push = push(kinematics, stop, length, (d.x * v.x + d.y * v.y) / length);
            let on_q = (push / length) * d;
            vec![acting::force(kinematics, *p, -on_q), acting::force(kinematics, *q, on_q)]
        }
        Stopped::Slide(link) => {
            let slide = kinematics.link(*link).slide.expect("it slides");
            let push = push(kinematics, stop, slide.value, slide.rate);
            let frame = kinematics.link(*link).frame;
            let force = push * frame.direction.u;
            let [own, other] = [Part::Link(*link), under(kinematics, *link)];
            let zero = kinematics.builder.zero().id;
            let acts = |part, force: Vector<'_>, velocity: Vector<'_>| Applied {
                part,
                at: ids(frame.origin.position()),
                force: ids(force),
                couple: zero,
                velocity: ids(velocity),
                omega: zero,
            };
            // The other body's place under the origin is as fast but for the slide.
            let under = frame.origin.velocity - slide.rate * frame.direction.u;
            vec![acts(own, force, frame.origin.velocity), acts(other, -force, under)]
        }
    }
}

/// The pushes of both ends, each where the motion is beyond it.
fn push<'s>(kinematics: &Kinematics<'s>, stop: &Stop, x: Sym<'s>, rate: Sym<'s>) -> Sym<'s> {
    let [k, c] = [&stop.stiffness, &stop.damping].map(|number| kinematics.jet(&number.value).value);
    let [from, to] = kinematics.jets(&stop.ends).map(|end| end.value);
    let zero = kinematics.builder.zero();
    let at_end = |beyond: Sym<'s>, rate: Sym<'s>| {
        let push = k * beyond + c * rate;
        zero.at_least(beyond, zero, zero.at_least(push, zero, push))
    };
    at_end(from - x, -rate) - at_end(x - to, rate)
}

/// The angle of the only link, or of the first against the second.
fn angle<'s>(kinematics: &Kinematics<'s>, sum: &AngleSum) -> (Sym<'s>, Sym<'s>) {
    let direction = |link: LinkId| kinematics.link(link).frame.direction;
    match sum.links[..] {
        [(link, 1)] => {
            let own = direction(link);
            (own.u.y.apply2(Function::Atan2, own.u.x), own.omega)
        }
        [(first, 1), (second, -1)] => {
            let [a, b] = [first, second].map(direction);
            let sine = a.u.y * b.u.x - a.u.x * b.u.y;
            (sine.apply2(Function::Atan2, a.u.x * b.u.x + a.u.y * b.u.y), a.omega - b.omega)
        }
        _ => unreachable!("no test stops another sum"),
    }
}
