//! The plan of a mechanism as an object of JavaScript.

use std::string::{String, ToString};

use super::json::{list, object, option, string, strings};
use crate::sketch::member::{LinkShape, Member};
use crate::sketch::plan::{Element, Plan, Spring};

pub(super) fn written(plan: &Plan) -> String {
    object([
        ("name", string(plan.name)),
        ("points", strings(plan.points)),
        ("links", strings(plan.links)),
        ("guides", strings(plan.guides)),
        ("statements", list(plan.statements.iter().map(|&made| statement(made)))),
        ("springs", list(plan.springs.iter().map(spring))),
    ])
}

fn statement(made: Element) -> String {
    match made {
        Element::Ground(point) => object([("ground", point.to_string())]),
        Element::Guide(guide, on) => object([("guide", guide.to_string()), ("on", option(on))]),
        Element::Point(point, on) => object([("point", point.to_string()), ("on", option(on))]),
        Element::Group(members, pin) => {
            let members = members.iter().map(|&own| member(own));
            object([("members", list(members)), ("pin", option(pin))])
        }
    }
}

fn member(member: Member) -> String {
    let shape = match member.shape {
        LinkShape::Bar => "bar",
        LinkShape::Cylinder => "cylinder",
        LinkShape::Body => "body",
        LinkShape::Block => "block",
        LinkShape::Sleeve => "sleeve",
        LinkShape::SlottedBar => "slotted_bar",
        LinkShape::Yoke => "yoke",
    };
    object([
        ("link", member.link.to_string()),
        ("pivot", option(member.pivot())),
        ("guide", option(member.guide())),
        ("shape", string(shape)),
        ("turned", member.is_turned.to_string()),
    ])
}

fn spring(spring: &Spring) -> String {
    object([("ends", list(spring.ends)), ("kinds", list(spring.kinds))])
}
