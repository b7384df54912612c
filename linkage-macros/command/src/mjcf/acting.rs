//! Motors of inputs, springs, and ranges of stops, on joints and tendons.

use std::f64::consts::TAU;

use linkage_compiler::{PlanarInput, PlanarSpring, PlanarStop};

use super::driven::InModel;
use super::printed::{Printer, numbers};
use super::tree::Joint;

impl Printer<'_> {
    pub(super) fn input(&mut self, input: &PlanarInput) {
        let found = input.of.as_ref().ok_or_else(|| "is no quantity of the drawing".to_string());
        let found = found.and_then(|(of, factor)| Ok((self.machine.in_model(of)?, *factor)));
        let (of, factor) = match found {
            Ok(found) => found,
            Err(why) => {
                self.left_out.push(format!("the motor of `{}`: {why}", input.name));
                return;
            }
        };
        let name = &input.name;
        let gear = if factor == 1.0 { String::new() } else { format!(" gear=\"{factor:?}\"") };
        let [motor, sensor] = match of {
            InModel::Joint(joint) => [
                format!("joint=\"{joint}\"{gear}/>"),
                format!("<jointpos name=\"{name}\" joint=\"{joint}\"/>"),
            ],
            InModel::Place(site, axis) => {
                let along = if axis == 0 { [factor, 0.0] } else { [0.0, factor] };
                [
                    format!(
                        "site=\"{site}\" refsite=\"ground\" gear=\"{} 0.0 0.0 0.0 0.0\"/>",
                        numbers(&along)
                    ),
                    format!("<framepos name=\"{name}\" objtype=\"site\" objname=\"{site}\"/>"),
                ]
            }
            InModel::Sum(_) | InModel::Distance(_) => {
                let tendon = self.tendon(name, &of, "");
                self.tendons.push(tendon);
                [
                    format!("tendon=\"{name}\"{gear}/>"),
                    format!("<tendonpos name=\"{name}\" tendon=\"{name}\"/>"),
                ]
            }
        };
        self.motors.push(format!("<motor name=\"{name}\" {motor}"));
        self.sensors.push(sensor);
    }

    /// A tendon with these attributes.
    fn tendon(&self, name: &str, of: &InModel, attributes: &str) -> String {
        match of {
            InModel::Distance([p, q]) => format!(
                "<spatial name=\"{name}\"{attributes}><site site=\"{p}\"/><site site=\"{q}\"/></spatial>"
            ),
            InModel::Joint(joint) => format!(
                "<fixed name=\"{name}\"{attributes}><joint joint=\"{joint}\" coef=\"1\"/></fixed>"
            ),
            InModel::Sum(sum) => {
                let joints = sum.iter().map(|(joint, factor)| {
                    format!("<joint joint=\"{joint}\" coef=\"{factor:?}\"/>")
                });
                format!("<fixed name=\"{name}\"{attributes}>{}</fixed>", joints.collect::<String>())
            }
            InModel::Place(..) => String::new(),
        }
    }

    pub(super) fn spring(&mut self, nth: usize, spring: &PlanarSpring) {
        use linkage_compiler::PlanarQuantity::{Angle, Distance};
        let PlanarSpring { points, bodies, stiffness, damping, free, .. } = spring;
        let [first, second] = bodies;
        let (of, sign) = match (points, first, second) {
            (Some(points), ..) => (Distance(points.clone()), 1.0),
            (None, first, Some(second)) => (Angle(second.clone(), first.clone()), 1.0),
            (None, Some(first), None) => (Angle(first.clone(), None), -1.0),
            (None, None, None) => return,
        };
        let of = match self.machine.in_model(&of) {
            Ok(of) => of,
            Err(why) => return self.left_out.push(format!("a spring: {why}")),
        };
        let slack = sign * free;
        let numbers = |slack: f64| {
            format!(
                "stiffness=\"{stiffness:?}\" damping=\"{damping:?}\" {}=\"{slack:?}\"",
                match of {
                    InModel::Joint(_) => "springref",
                    _ => "springlength",
                }
            )
        };
        match &of {
            InModel::Joint(joint) => {
                let slack = self.near_drawn(joint, slack);
                self.of_joints.push((joint.clone(), numbers(slack)));
            }
            _ => {
                let tendon = self.tendon(
                    &format!("spring{}", nth + 1),
                    &of,
                    &format!(" {}", numbers(slack)),
                );
                self.tendons.push(tendon);
            }
        }
    }

    /// An angle whole turns away that is nearest to a joint's drawn one.
    fn near_drawn(&self, joint: &str, angle: f64) -> f64 {
        let node = self.machine.nodes.iter().find(|node| self.machine.joint_name(node) == joint);
        match node.filter(|node| matches!(node.joint, Joint::Hinge(_))) {
            Some(node) => angle + TAU * ((self.machine.drawn(node) - angle) / TAU).round(),
            None => angle,
        }
    }

    pub(super) fn stop(&mut self, nth: usize, stop: &PlanarStop) {
        let of = match self.machine.in_model(&stop.of) {
            Ok(of) => of,
            Err(why) => return self.left_out.push(format!("a stop: {why}")),
        };
        let range = |[low, high]: [f64; 2]| format!("range=\"{}\"", numbers(&[low, high]));
        match &of {
            InModel::Joint(joint) => {
                let [low, high] = stop.ends;
                let middle = (low + high) / 2.0;
                let shift = self.near_drawn(joint, middle) - middle;
                self.of_joints.push((joint.clone(), range([low + shift, high + shift])));
            }
            InModel::Place(..) => self.left_out.push("a stop of a point".to_string()),
            InModel::Sum(_) | InModel::Distance(_) => {
                let tendon = self.tendon(
                    &format!("stop{}", nth + 1),
                    &of,
                    &format!(" {}", range(stop.ends)),
                );
                self.tendons.push(tendon);
            }
        }
    }
}
