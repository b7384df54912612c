//! Models of MuJoCo whose bodies move in one plane.
//!
//! | there | here |
//! |---|---|
//! | a body with a hinge or a slide; one without a joint is part of its parent | a link |
//! | a hinge, and a `connect` of two bodies | a pin |
//! | a slide | a guide, and a link on it |
//! | an actuator of a joint, a tendon of two sites, or a site against another | an input that is this quantity |
//! | a joint with a spring that no actuator moves, where an input is missing | an input |
//! | `equality/joint` of degree one | a drive |
//! | `inertial`, `armature`, springs, gravity | masses, springs, gravity |
//!
//! Places are rounded to 10⁻¹² m, so that those of a model that was written from a drawing are those of the drawing.

mod classes;
mod model;
mod pins;
mod planar;
mod space;
mod xml;

use super::Mistake;
use super::drawing::Drawing;

pub(super) fn is_model(text: &str) -> bool {
    text.starts_with('<') && text.contains("<mujoco")
}

pub(super) fn read(text: &str) -> Result<Drawing, Mistake> {
    let root = xml::read(text)?;
    if root.name != "mujoco" {
        return Err(format!("this is a `{}`, no model of MuJoCo", root.name));
    }
    let model = model::Model::read(&root)?;
    planar::drawing(&model)
}
