//! The JSON of pylinkage's mechanisms.
//!
//! | there | here |
//! |---|---|
//! | a joint `ground`, `revolute` | a pin |
//! | a joint `prismatic` | a pin, and a block through it on a guide of the ground |
//! | a joint `tracker` | one more pin of the link that has both of its references |
//! | a link `ground`; `link` | the ground; a link |
//! | a link `driver`, `arc_driver` | a link and its drive |
//!
//! `slide_distance` is a coordinate, not a dimension: the drawing says where the block is. Bars that make a triangle are
//! one link.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value;

use super::Mistake;
use super::drawing::{Angle, Drawing, Drive, Guide, Line, Link, Pin};
use super::triangles;

#[derive(Deserialize)]
struct Mechanism {
    #[serde(default)]
    name: String,
    joints: Vec<Joint>,
    links: Option<Vec<Member>>,
}

#[derive(Deserialize)]
struct Joint {
    id: Option<String>,
    name: Option<String>,
    #[serde(rename = "type", default = "revolute")]
    kind: String,
    position: Option<[Option<f64>; 2]>,
    axis: Option<[f64; 2]>,
    line_point: Option<[f64; 2]>,
    ref_joint1_id: Option<String>,
    ref_joint2_id: Option<String>,
}

#[derive(Deserialize)]
struct Member {
    id: String,
    name: Option<String>,
    #[serde(rename = "type", default = "link")]
    kind: String,
    #[serde(default)]
    joints: Vec<String>,
    /// The ground joint about which a driver turns.
    motor_joint: Option<String>,
    /// The speed and the arc of a driver.
    #[serde(flatten)]
    more: BTreeMap<String, Value>,
}

fn revolute() -> String {
    "revolute".into()
}

fn link() -> String {
    "link".into()
}

pub(crate) fn read(text: &str) -> Result<Drawing, Mistake> {
    let mechanism: Mechanism = serde_json::from_str(text)
        .map_err(|error| format!("this is no mechanism of pylinkage: {error}"))?;
    let Some(links) = &mechanism.links else {
        return Err("there are no `links`: an older linkage lists groups, not joints; convert it by pylinkage".into());
    };
    let mut drawing = Drawing::new(&mechanism.name, "mm");
    let grounds = links.iter().filter(|link| link.kind == "ground");
    let motors = links.iter().filter_map(|link| link.motor_joint.as_ref());
    let on_ground: Vec<_> = grounds.flat_map(|link| &link.joints).chain(motors).collect();
    for joint in &mechanism.joints {
        draw_joint(&mut drawing, joint, &on_ground)?;
    }
    let names = mechanism.joints.iter().map(|joint| (joint.id.as_ref(), &joint.name));
    for (id, name) in names.chain(links.iter().map(|link| (Some(&link.id), &link.name))) {
        if let (Some(id), Some(name)) = (id, name)
            && id != name
        {
            drawing.left_out.push(format!("the name of `{id}`, {name}"));
        }
    }
    for link in links.iter().filter(|link| link.kind != "ground") {
        draw_link(&mut drawing, link)?;
    }
    for joint in mechanism.joints.iter().filter(|joint| joint.kind == "tracker") {
        track(&mut drawing, joint)?;
    }
    triangles::join(&mut drawing);
    Ok(drawing)
}

fn id(joint: &Joint) -> Result<&str, Mistake> {
    joint.id.as_deref().ok_or_else(|| "a joint has no `id`".into())
}

fn draw_joint(drawing: &mut Drawing, joint: &Joint, on_ground: &[&String]) -> Result<(), Mistake> {
    let id = id(joint)?;
    let Some([Some(x), Some(y)]) = joint.position else {
        return Err(format!(
            "`{id}` has no position; let pylinkage compute one pose, then export it"
        ));
    };
    let is_ground = joint.kind == "ground" || on_ground.iter().any(|own| *own == id);
    match &joint.kind[..] {
        "ground" | "revolute" | "tracker" => {}
        "prismatic" => {
            let (guide, block) = (format!("guide_{id}"), format!("block_{id}"));
            let through = joint.line_point.unwrap_or([x, y]);
            let angle = Angle::Vector(joint.axis.unwrap_or([1.0, 0.0]));
            let line = Line::Along { through, angle };
            drawing.guides.push(Guide { id: guide.clone(), on: None, line });
            drawing.links.push(Link { id: block, pins: vec![id.to_string()], on: vec![guide] });
        }
        kind => return Err(format!("`{id}` is a joint of type `{kind}`, which is not known here")),
    }
    drawing.pins.push(Pin { id: id.to_string(), at: [x, y], is_ground });
    Ok(())
}

fn draw_link(drawing: &mut Drawing, link: &Member) -> Result<(), Mistake> {
    let is_driver = match &link.kind[..] {
        "link" => false,
        "driver" | "arc_driver" => true,
        kind => {
            return Err(format!(
                "`{}` is a link of type `{kind}`, which is not known here",
                link.id
            ));
        }
    };
    if is_driver {
        let is_ground = |joint: &String| drawing.pin(joint).is_some_and(|pin| pin.is_ground);
        if !link.joints.iter().any(is_ground) {
            return Err(format!("the driver `{}` has no joint on the ground", link.id));
        }
        drawing.drives.push(Drive::Angle { link: link.id.clone(), against: None });
        let drawn = drawn_angle(drawing, link);
        // Where the drawing is at the initial angle, nothing is lost.
        let begins_elsewhere = |value: &Value| {
            let turn = value.as_f64().zip(drawn).map(|(angle, drawn)| (angle - drawn).sin_cos());
            turn.is_none_or(|(sin, cos)| sin.abs() > EXACT || cos < 0.0)
        };
        let motion = link.more.iter().filter(|(name, value)| match &name[..] {
            "angular_velocity" => value.is_number(),
            "initial_angle" => value.is_number() && begins_elsewhere(value),
            name => value.is_number() && name.starts_with("arc"),
        });
        let motion = motion.map(|(name, value)| format!("`{name}` of `{}`, {value}", link.id));
        drawing.left_out.extend(motion);
    }
    drawing.links.push(Link { id: link.id.clone(), pins: link.joints.clone(), on: Vec::new() });
    Ok(())
}

/// The rounding of an angle that was computed in double precision.
const EXACT: f64 = 1e-9;

/// The angle at which a driver is drawn, from the joint about which it turns.
fn drawn_angle(drawing: &Drawing, link: &Member) -> Option<f64> {
    let motor = link.motor_joint.as_ref().or(link.joints.first())?;
    let other = link.joints.iter().find(|joint| *joint != motor)?;
    let [[u, v], [x, y]] = [drawing.pin(motor)?.at, drawing.pin(other)?.at];
    Some((y - v).atan2(x - u))
}

/// Lets a tracker be a pin of its link.
fn track(drawing: &mut Drawing, joint: &Joint) -> Result<(), Mistake> {
    let id = id(joint)?;
    let (Some(from), Some(to)) = (&joint.ref_joint1_id, &joint.ref_joint2_id) else {
        return Err(format!("the tracker `{id}` has no two references"));
    };
    let has_both = |link: &&mut Link| link.pins.contains(from) && link.pins.contains(to);
    let link = drawing.links.iter_mut().find(has_both);
    let link = link.ok_or_else(|| {
        format!("no link has both references of the tracker `{id}`, `{from}` and `{to}`")
    })?;
    if !link.pins.iter().any(|pin| pin == id) {
        link.pins.push(id.to_string());
    }
    Ok(())
}
