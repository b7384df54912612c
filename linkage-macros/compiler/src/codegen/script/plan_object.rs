//! The plan of a mechanism as an object of JavaScript.

use super::in_script::{list, quoted};
use crate::codegen::drawn_plan::{self, PlanMember, PlanSpring, PlanStatement};
use crate::codegen::identifiers::text;
use crate::model::mechanism::Mechanism;

pub(super) fn object(mechanism: &Mechanism) -> String {
    let [points, links, guides] = drawn_plan::names(mechanism).map(list);
    let statements: Vec<String> = drawn_plan::statements(mechanism).map(statement).collect();
    let springs: Vec<String> = drawn_plan::springs(mechanism).map(spring).collect();
    let name = quoted(&text(&mechanism.name));
    format!(
        "{{name:{name},points:{points},links:{links},guides:{guides},statements:[{}],springs:[{}]}}",
        statements.join(","),
        springs.join(",")
    )
}

fn statement(placed: PlanStatement) -> String {
    match placed {
        PlanStatement::Ground(point) => format!("{{ground:{point}}}"),
        PlanStatement::Guide(guide, on) => format!("{{guide:{guide},on:{}}}", option(on)),
        PlanStatement::Point(point, on) => format!("{{point:{point},on:{}}}", option(on)),
        PlanStatement::Group(members, pin) => {
            let members: Vec<String> = members.iter().map(member).collect();
            format!("{{members:[{}],pin:{}}}", members.join(","), option(pin))
        }
    }
}

fn member(PlanMember { link, pivot, guide, shape, is_turned }: &PlanMember) -> String {
    let [pivot, guide] = [*pivot, *guide].map(option);
    format!("{{link:{link},pivot:{pivot},guide:{guide},shape:\"{shape}\",turned:{is_turned}}}")
}

fn spring(PlanSpring { ends: [a, b], kinds: [stiffness, damping] }: PlanSpring) -> String {
    format!("{{ends:[{a},{b}],kinds:[{stiffness},{damping}]}}")
}

/// A place, or `null`.
fn option(place: Option<u32>) -> String {
    place.map_or("null".to_string(), |place| place.to_string())
}
