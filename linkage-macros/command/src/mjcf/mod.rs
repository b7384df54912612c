//! `export mjcf`: a drawing as a model of MuJoCo.
//!
//! [`tree`] hangs the bodies on joints and finds what closes loops, [`printed`] writes them, [`followed`] fits what the
//! other joints do with the one that is driven.

mod acting;
mod driven;
mod followed;
mod plane;
mod printed;
mod tree;

use linkage_compiler::planar_bodies;

use crate::arguments::Export;
use crate::output::{self, Failure};
use crate::pose::PoseConditions;
use crate::program::{Declaration, Program};
pub(crate) use plane::Plane;

pub(crate) fn export(arguments: &Export, program: &Program) -> Result<(), Failure> {
    let mut made = Vec::new();
    for declaration in program.declarations()? {
        let bodies = program.each(vec![declaration.clone()], |declaration| {
            let mut conditions = PoseConditions::new();
            planar_bodies(declaration.tokens.clone(), &mut conditions)
        })?;
        for bodies in bodies {
            let name = bodies.name.clone();
            let text = model(bodies, &declaration, arguments).map_err(|why| {
                Failure::Unusable(format!("`{name}` is no model of MuJoCo: {why}"))
            })?;
            made.push((format!("{name}.xml"), text));
        }
    }
    output::texts(&arguments.target, &arguments.file, made)
}

fn model(
    bodies: linkage_compiler::PlanarBodies,
    declaration: &Declaration,
    arguments: &Export,
) -> Result<String, String> {
    let machine = tree::Machine::of(bodies)?;
    let followed = match arguments.tree {
        true => Some(followed::fitted(&machine, declaration, &arguments.between)?),
        false => None,
    };
    Ok(printed::Printer::of(&machine, arguments.plane.unwrap_or_default()).text(followed.as_ref()))
}
