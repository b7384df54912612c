//! The text of a model.

use super::followed::Followed;
use super::plane::Plane;
use super::tree::{Joint, Machine, Node};

/// A mass and an inertia that count as none: MuJoCo asks for some of every body that moves.
const LEAST: f64 = 1e-12;

/// The step in seconds.
const STEP: &str = "0.0005";

/// The stiffness of a loop: MuJoCo's own opens one by some millimetres in a second of falling, this one at this step by
/// a thousandth of that.
const STIFF: &str = "solref=\"0.001 1\" solimp=\"0.9999 0.9999 0.001\"";

pub(super) struct Printer<'m> {
    pub machine: &'m Machine,
    plane: Plane,
    lines: Vec<String>,
    pub tendons: Vec<String>,
    pub motors: Vec<String>,
    pub sensors: Vec<String>,
    /// The attributes of joints, by the joint.
    pub of_joints: Vec<(String, String)>,
    pub left_out: Vec<String>,
}

impl<'m> Printer<'m> {
    pub(super) fn of(machine: &'m Machine, plane: Plane) -> Self {
        Self {
            machine,
            plane,
            lines: Vec::new(),
            tendons: Vec::new(),
            motors: Vec::new(),
            sensors: Vec::new(),
            of_joints: Vec::new(),
            left_out: machine.parts.left_out.clone(),
        }
    }

    /// The whole model; as a tree without loops where it is known what the joints do with the one that is driven.
    pub(super) fn text(mut self, followed: Option<&Followed>) -> String {
        let parts = &self.machine.parts;
        parts.inputs.iter().for_each(|input| self.input(input));
        parts.springs.iter().enumerate().for_each(|(nth, spring)| self.spring(nth, spring));
        parts.stops.iter().enumerate().for_each(|(nth, stop)| self.stop(nth, stop));
        let gravity = numbers(&self.plane.space(parts.gravity));
        self.head();
        self.put(0, format!("<mujoco model=\"{}\">", parts.name));
        self.put(1, "<compiler angle=\"radian\" autolimits=\"true\"/>".to_string());
        self.put(
            1,
            format!(
                "<option gravity=\"{gravity}\" timestep=\"{STEP}\" integrator=\"implicitfast\"/>"
            ),
        );
        self.world();
        match followed {
            Some(followed) => self.polynomials(followed),
            None => self.loops(),
        }
        let lists = [
            ("tendon", std::mem::take(&mut self.tendons)),
            ("actuator", std::mem::take(&mut self.motors)),
            ("sensor", std::mem::take(&mut self.sensors)),
        ];
        for (name, lines) in lists {
            self.list(name, lines);
        }
        self.keyframe();
        self.put(0, "</mujoco>".to_string());
        self.lines.join("\n") + "\n"
    }

    fn put(&mut self, depth: usize, line: String) {
        self.lines.push(format!("{}{line}", "  ".repeat(depth)));
    }

    fn list(&mut self, name: &str, lines: Vec<String>) {
        if lines.is_empty() {
            return;
        }
        self.put(1, format!("<{name}>"));
        lines.into_iter().for_each(|line| self.put(2, line));
        self.put(1, format!("</{name}>"));
    }

    fn head(&mut self) {
        let name = &self.machine.parts.name;
        let mut about = vec![
            format!("{name}, printed by linkage from its drawing; do not edit."),
            "Numbers are those of the solver: an angle is counter-clockwise in the drawing, a slide along its guide."
                .to_string(),
        ];
        if !self.machine.closures.is_empty() {
            about.push(format!(
                "Loops are held by constraints that give way: at a step of {STEP} s by less than a tenth of a millimetre."
            ));
        }
        about.extend(self.left_out.iter().map(|what| format!("Left out: {what}.")));
        // Two hyphens would end a comment.
        let about = about.join("\n     ").replace("--", "- -");
        self.put(0, format!("<!-- {about} -->"));
    }

    fn space(&self, place: [f64; 2]) -> String {
        numbers(&self.plane.space(place))
    }

    fn world(&mut self) {
        self.put(1, "<worldbody>".to_string());
        for (pin, at) in &self.machine.parts.ground {
            let at = self.space(*at);
            self.put(2, format!("<site name=\"ground.{pin}\" pos=\"{at}\"/>"));
        }
        if self.motors.iter().any(|motor| motor.contains("refsite")) {
            self.put(
                2,
                format!("<site name=\"ground\" quat=\"{}\"/>", numbers(&self.ground_turn())),
            );
        }
        let machine = self.machine;
        machine
            .nodes
            .iter()
            .filter(|node| node.parent.is_none())
            .for_each(|node| self.body(node, 2));
        self.put(1, "</worldbody>".to_string());
    }

    /// The axes of a site whose x and y are those of the drawing.
    fn ground_turn(&self) -> [f64; 4] {
        let half = 0.5_f64.sqrt();
        match self.plane {
            Plane::Xy => [1.0, 0.0, 0.0, 0.0],
            Plane::Xz => [half, half, 0.0, 0.0],
            Plane::Yz => [0.5, 0.5, 0.5, 0.5],
        }
    }

    fn body(&mut self, node: &Node, depth: usize) {
        let machine = self.machine;
        let own = machine.body(node.body);
        let (at, turn) =
            (machine.local(node.parent, own.frame.0), self.plane.turn(machine.turn(node)));
        self.put(
            depth,
            format!(
                "<body name=\"{}\" pos=\"{}\" quat=\"{}\">",
                own.name,
                self.space(at),
                numbers(&turn)
            ),
        );
        self.joint(node, depth + 1);
        self.inertial(node, depth + 1);
        let thick = 0.015 * machine.size();
        let local = |at: &[f64; 2]| self.space(machine.local(Some(node.body), *at));
        let mut lines = Vec::new();
        for pins in own.pins.windows(2) {
            let [from, to] = [&pins[0], &pins[1]].map(|(_, at)| local(at));
            lines.push(format!(
                "<geom type=\"capsule\" fromto=\"{from} {to}\" size=\"{thick:.3e}\" contype=\"0\" conaffinity=\"0\" mass=\"0\"/>"
            ));
        }
        for (pin, at) in &own.pins {
            lines.push(format!("<site name=\"{}.{pin}\" pos=\"{}\"/>", own.name, local(at)));
        }
        lines.into_iter().for_each(|line| self.put(depth + 1, line));
        let children = machine.nodes.iter().filter(|child| child.parent == Some(node.body));
        children.for_each(|child| self.body(child, depth + 1));
        self.put(depth, "</body>".to_string());
    }

    fn joint(&mut self, node: &Node, depth: usize) {
        let machine = self.machine;
        let name = machine.joint_name(node);
        let own = machine.body(node.body);
        let (kind, place, axis) = match &node.joint {
            Joint::Hinge(pin) => {
                let at =
                    own.pins.iter().find(|(other, _)| other == pin).map_or([0.0; 2], |(_, at)| *at);
                let at = self.space(machine.local(Some(node.body), at));
                ("", format!(" pos=\"{at}\""), self.plane.axis())
            }
            Joint::Slide(guide) => {
                let (sin, cos) = (machine.parts.guides[*guide].along - own.frame.1).sin_cos();
                (" type=\"slide\"", String::new(), self.plane.space([cos, sin]))
            }
        };
        let more = self.of_joints.iter().filter(|(joint, _)| *joint == name);
        let more: String = more.map(|(_, attributes)| format!(" {attributes}")).collect();
        let rotor = match self.rotor(node) {
            Some(inertia) => format!(" armature=\"{inertia:?}\""),
            None => String::new(),
        };
        let line = format!(
            "<joint name=\"{name}\"{kind}{place} axis=\"{}\" ref=\"{}\"{rotor}{more}/>",
            numbers(&axis),
            numbers(&[machine.drawn(node)])
        );
        self.put(depth, line);
    }

    /// The inertia of a body without mass that turns on the ground: that of a rotor on its joint.
    fn rotor(&self, node: &Node) -> Option<f64> {
        let own = self.machine.body(node.body);
        let is_hinged = matches!(node.joint, Joint::Hinge(_)) && node.parent.is_none();
        let has_mass = own.masses.iter().any(|(mass, ..)| *mass > 0.0);
        let sum: f64 = own.masses.iter().map(|(.., inertia)| inertia).sum();
        (is_hinged && !has_mass && sum > 0.0).then_some(sum)
    }

    fn inertial(&mut self, node: &Node, depth: usize) {
        let own = self.machine.body(node.body);
        let mass: f64 = own.masses.iter().map(|(mass, ..)| mass).sum();
        let mut center = own.frame.0;
        if mass > 0.0 {
            center = [0, 1]
                .map(|axis| own.masses.iter().map(|(m, at, _)| m * at[axis]).sum::<f64>() / mass);
        }
        let about = |(m, at, inertia): &(f64, [f64; 2], f64)| {
            let [x, y] = [at[0] - center[0], at[1] - center[1]];
            inertia + m * (x * x + y * y)
        };
        let inertia: f64 =
            if self.rotor(node).is_some() { 0.0 } else { own.masses.iter().map(about).sum() };
        let is_without = mass <= 0.0;
        let (mass, inertia) = (mass.max(LEAST), inertia.max(LEAST));
        let at = self.space(self.machine.local(Some(node.body), center));
        let note = if is_without { "<!-- without mass -->" } else { "" };
        self.put(
            depth,
            format!(
                "<inertial pos=\"{at}\" mass=\"{}\" diaginertia=\"{}\"/>{note}",
                numbers(&[mass]),
                numbers(&[inertia; 3])
            ),
        );
    }

    fn loops(&mut self) {
        let machine = self.machine;
        let tied = machine.closures.iter().map(|closure| {
            let own = machine.body(closure.body);
            let at = own
                .pins
                .iter()
                .find(|(pin, _)| *pin == closure.pin)
                .map_or([0.0; 2], |(_, at)| *at);
            let other =
                closure.other.map(|other| format!(" body2=\"{}\"", machine.body(other).name));
            // Other programs read bodies and an anchor, not sites.
            format!(
                "<connect name=\"{}.{}\" body1=\"{}\"{} anchor=\"{}\" {STIFF}/>",
                closure.pin,
                closure.other.map_or("ground", |other| &machine.body(other).name),
                own.name,
                other.unwrap_or_default(),
                self.space(machine.local(Some(closure.body), at))
            )
        });
        let tied = tied.collect();
        self.list("equality", tied);
    }

    fn polynomials(&mut self, followed: &Followed) {
        let lines = followed.joints.iter().map(|(joint, coefficients, worst)| {
            format!(
                "<joint joint1=\"{joint}\" joint2=\"{}\" polycoef=\"{}\"/><!-- off by at most {worst:.1e} -->",
                followed.driver,
                numbers(coefficients)
            )
        });
        let lines = lines.collect();
        self.list("equality", lines);
    }

    fn keyframe(&mut self) {
        let machine = self.machine;
        // Joints are numbered as bodies are, depth first.
        let mut drawn = Vec::new();
        let mut open: Vec<&Node> =
            machine.nodes.iter().filter(|node| node.parent.is_none()).rev().collect();
        while let Some(node) = open.pop() {
            drawn.push(machine.drawn(node));
            open.extend(machine.nodes.iter().filter(|child| child.parent == Some(node.body)).rev());
        }
        let line = format!("<key name=\"drawn\" qpos=\"{}\"/>", numbers(&drawn));
        self.list("keyframe", vec![line]);
    }
}

/// Numbers with all their digits; zero has no sign.
pub(super) fn numbers(list: &[f64]) -> String {
    list.iter().map(|number| format!("{:?}", number + 0.0)).collect::<Vec<_>>().join(" ")
}
