//! Masses, couples and wheels where a page draws them. They are a program of their own: the one that places bodies is the
//! same with them and without.

use crate::equations::forces;
use crate::equations::jet::Jet;
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::symbol::{GraphBuilder, Sym};
use crate::ir::construct::Rule;
use crate::ir::program::{EntryOutputs, Program};
use crate::model::acting::MassPlace;
use crate::model::mechanism::{Mechanism, PointId};
use crate::model::wheels::{Wheels, wheels};

/// Both parts of gravity, where there is any; mass after mass x and y of its centre, and its size; couple after couple of
/// the declaration on a link; pair after pair of wheels the radii of both. None where nothing of this is drawn.
pub(crate) fn derive(mechanism: &Mechanism, rules: &[Rule]) -> Option<Program> {
    let wheels = wheels(mechanism);
    let dynamics = &mechanism.dynamics;
    if dynamics.masses.is_empty() && dynamics.torques.is_empty() && wheels.is_empty() {
        return None;
    }
    let builder = GraphBuilder::new(rules);
    let kinematics = Kinematics::of(&builder, mechanism, InputMotion::free(mechanism, &builder));
    let gravity = dynamics.gravity.as_ref().filter(|_| !dynamics.masses.is_empty());
    let gravity = gravity.map(|gravity| kinematics.jets(gravity).map(|part| part.value));
    let mut marked: Vec<Sym<'_>> = gravity.into_iter().flatten().collect();
    marked.extend(masses(&kinematics));
    marked.extend(forces::couples_on_links(&kinematics).into_iter().map(|(_, couple)| couple));
    marked.extend(wheels.iter().flat_map(|wheels| radii(&kinematics, wheels)));
    let sinks = marked.into_iter().map(|symbol| symbol.id).collect();
    let closures = kinematics.closures.clone();
    drop(kinematics);
    Some(Program {
        graph: builder.into_graph(),
        answers: vec![EntryOutputs { entry: None, sinks }],
        clearances: Vec::new(),
        closures,
        groups: mechanism.titles(),
    })
}

fn masses<'s>(kinematics: &Kinematics<'s>) -> Vec<Sym<'s>> {
    let dynamics = &kinematics.mechanism.dynamics;
    let masses = dynamics.masses.iter().flat_map(|mass| {
        let centre = match &mass.place {
            MassPlace::Pin(point) | MassPlace::Point(_, point) => kinematics.point(*point),
            MassPlace::At(link, at) => {
                let [x, y] = kinematics.jets(at);
                kinematics.link(*link).frame.place(x, y)
            }
            MassPlace::Uniform(link, length) => {
                let (half, zero) = (kinematics.jet(length).value.half(), kinematics.builder.zero());
                let frame = kinematics.link(*link).frame;
                frame.place(Jet::constant(half), Jet::constant(zero))
            }
        };
        let at = centre.position();
        [at.x, at.y, kinematics.jet(&mass.mass.value).value]
    });
    masses.collect()
}

/// At the ratio k the second wheel is d/(k − 1) large and the first k times that, for centres that are d apart: both
/// have one velocity where they touch, ω s = k ω (s − d). They are on one side of it where both have one sign.
fn radii<'s>(kinematics: &Kinematics<'s>, wheels: &Wheels) -> [Sym<'s>; 2] {
    let at = |point: PointId| kinematics.point(point);
    let apart = at(wheels.centres[0]).to(at(wheels.centres[1]));
    let ratio = kinematics.jet(&wheels.ratio).value;
    let own = apart.x.hypot(apart.y) / (ratio - kinematics.builder.integer(1));
    [ratio * own, own]
}
