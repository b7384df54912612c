//! A drawing as the text of a declaration.

use super::Mistake;
use super::drawing::{
    Angle, Drawing, Drive, Force, Guide, Line, Link, Mass, Pin, Quantity, Spring,
};
use super::names::{self, Kind, Names};

/// The declaration, a statement a line.
pub(crate) fn declaration(drawing: &Drawing) -> Result<String, Mistake> {
    let mut printer = Printer { drawing, names: Names::default() };
    let lines = printer.lines()?;
    let solver = names::of_solver(&drawing.name);
    let mut text = format!("mechanism! {{\n    pub struct {solver} {{\n");
    for line in lines {
        text.push_str(&format!("        {line}\n"));
    }
    text.push_str("    }\n}\n");
    Ok(text)
}

struct Printer<'d> {
    drawing: &'d Drawing,
    names: Names,
}

impl Printer<'_> {
    fn lines(&mut self) -> Result<Vec<String>, Mistake> {
        let drawing = self.drawing;
        if drawing.links.is_empty() {
            return Err("the machine has no link".into());
        }
        // Pins and links keep their names; guides and inputs take what is free.
        drawing.pins.iter().for_each(|pin| _ = self.names.of(Kind::Pin, &pin.id));
        drawing.links.iter().for_each(|link| _ = self.names.of(Kind::Link, &link.id));
        let [inputs, drives] = self.driven();
        let [ground, moving] = [true, false].map(|is_ground| {
            let pins = drawing.pins.iter().filter(|pin| pin.is_ground == is_ground);
            pins.collect::<Vec<_>>()
        });
        let left_out = drawing.left_out.iter().map(|what| format!("// Left out: {what}."));
        let remarks = drawing.remarks.iter().map(|remark| format!("// {remark}."));
        // A comment is one line, whatever stands in a title.
        let in_line = |text: String| text.replace(char::is_control, " ");
        let mut lines: Vec<_> = left_out.chain(remarks).map(in_line).collect();
        lines.extend(inputs);
        lines.extend(self.pins("ground", &ground)?);
        lines.extend(self.pins("pin", &moving)?);
        for guide in &drawing.guides {
            lines.push(self.guide(guide)?);
        }
        for link in &drawing.links {
            lines.push(self.link(link)?);
        }
        lines.extend(drives);
        lines.extend(drawing.gravity.map(|[x, y]| format!("gravity ({x:?}, {y:?});")));
        for mass in &drawing.masses {
            lines.push(self.mass(mass)?);
        }
        for (link, inertia) in &drawing.rotors {
            let link = self.names.of(Kind::Link, link);
            lines.push(format!("inertia {inertia}(kg*m^2) on {link};"));
        }
        for spring in &drawing.springs {
            lines.push(self.spring(spring));
        }
        for force in &drawing.forces {
            lines.extend(self.force(force)?);
        }
        Ok(lines)
    }

    /// The inputs, and what they and others drive.
    fn driven(&mut self) -> [Vec<String>; 2] {
        let drawing = self.drawing;
        let mut drives = Vec::new();
        let mut inputs = Vec::new();
        for (index, drive) in drawing.drives.iter().enumerate() {
            match drive {
                Drive::Input { input, of, factor } => {
                    let input = self.names.of(Kind::Input, input);
                    inputs.push(format!("input {input} = {};", self.times(*factor, of)));
                }
                Drive::Coupled { of, by, factor, constant } => {
                    let by = self.times(*factor, by);
                    let unit = if matches!(of, Quantity::Angle(..)) { "rad" } else { "m" };
                    let constant = match constant {
                        0.0 => String::new(),
                        constant => format!(" + {constant}{unit}"),
                    };
                    drives.push(format!("drive {} = {by}{constant};", self.quantity(of)));
                }
                Drive::Angle { .. } | Drive::Slide { .. } => {
                    let (input, kind) = self.input(index, drive);
                    inputs.push(format!("input {input}: {kind};"));
                    drives.push(self.drive(drive, &input));
                }
            }
        }
        [inputs, drives]
    }

    fn input(&mut self, index: usize, drive: &Drive) -> (String, &'static str) {
        let (wanted, kind) = match drive {
            Drive::Angle { .. } => ("theta", "angle"),
            Drive::Slide { .. } | Drive::Input { .. } | Drive::Coupled { .. } => ("s", "length"),
        };
        let number = if index == 0 { String::new() } else { format!("_{}", index + 1) };
        (self.names.of(Kind::Input, &format!("{wanted}{number}")), kind)
    }

    fn drive(&mut self, drive: &Drive, input: &str) -> String {
        match drive {
            Drive::Angle { link, against: None } => {
                format!("drive {}.angle = {input};", self.names.of(Kind::Link, link))
            }
            Drive::Angle { link, against: Some(other) } => {
                let [link, other] = [link, other].map(|link| self.names.of(Kind::Link, link));
                format!("drive {link}.angle - {other}.angle = {input};")
            }
            Drive::Slide { link } => {
                format!("drive {}.slide = {input};", self.names.of(Kind::Link, link))
            }
            Drive::Input { .. } | Drive::Coupled { .. } => String::new(),
        }
    }

    fn quantity(&mut self, of: &Quantity) -> String {
        match of {
            Quantity::Angle(link, None) => format!("{}.angle", self.names.of(Kind::Link, link)),
            Quantity::Angle(link, Some(other)) => {
                let [link, other] = [link, other].map(|link| self.names.of(Kind::Link, link));
                format!("{link}.angle - {other}.angle")
            }
            Quantity::Slide(link) => format!("{}.slide", self.names.of(Kind::Link, link)),
            Quantity::Place(pin, axis) => {
                let axis = if *axis == 0 { "x" } else { "y" };
                format!("{}.{axis}", self.names.of(Kind::Pin, pin))
            }
            Quantity::Distance(pins) => {
                let [p, q] = pins.each_ref().map(|pin| self.names.of(Kind::Pin, pin));
                format!("distance({p}, {q})")
            }
        }
    }

    fn times(&mut self, factor: f64, of: &Quantity) -> String {
        match (factor, of) {
            (1.0, _) => self.quantity(of),
            // The difference the other way round.
            (-1.0, Quantity::Angle(link, Some(other))) => {
                self.quantity(&Quantity::Angle(other.clone(), Some(link.clone())))
            }
            (-1.0, _) => format!("-{}", self.quantity(of)),
            (_, Quantity::Angle(_, Some(_))) => format!("{factor} * ({})", self.quantity(of)),
            _ => format!("{factor} * {}", self.quantity(of)),
        }
    }

    fn spring(&mut self, spring: &Spring) -> String {
        let Spring { of, stiffness, damping, slack } = spring;
        let (ends, units, free) = match of {
            Quantity::Distance(pins) => {
                let [p, q] = pins.each_ref().map(|pin| self.names.of(Kind::Pin, pin));
                (format!("{p} and {q}"), ["N/m", "N*s/m"], format!("free_length: {slack}m"))
            }
            Quantity::Angle(link, against) => {
                let own = self.names.of(Kind::Link, link);
                let other = against.as_ref().map(|other| self.names.of(Kind::Link, other));
                let ends = format!("{} and {own}", other.as_deref().unwrap_or("ground"));
                (ends, ["N*m/rad", "N*m*s/rad"], format!("free_angle: {slack}rad"))
            }
            Quantity::Slide(_) | Quantity::Place(..) => return String::new(),
        };
        let [stiff, slow] = units;
        format!(
            "spring between {ends} {{ stiffness: {stiffness}({stiff}), {free}, damping: {damping}({slow}) }}"
        )
    }

    fn pins(&mut self, word: &str, pins: &[&Pin]) -> Result<Option<String>, Mistake> {
        let mut places = Vec::new();
        for pin in pins {
            let name = self.names.of(Kind::Pin, &pin.id);
            if !pin.at.iter().all(|x| x.is_finite()) {
                return Err(format!("`{}` has no place in the drawing", pin.id));
            }
            places.push(format!("{name}{}", self.place(pin.at)));
        }
        Ok((!places.is_empty()).then(|| format!("{word} {};", places.join(", "))))
    }

    fn place(&self, at: [f64; 2]) -> String {
        let [x, y] = at.map(|number| match number == 0.0 {
            true => "0".to_string(),
            false => format!("{number}{}", self.drawing.unit),
        });
        format!("({x}, {y})")
    }

    fn link(&mut self, link: &Link) -> Result<String, Mistake> {
        if link.pins.is_empty() && link.on.is_empty() {
            return Err(format!("`{}` has no joint", link.id));
        }
        let mut pins = Vec::new();
        for pin in &link.pins {
            if self.drawing.pin(pin).is_none() {
                return Err(format!("`{}` goes through `{pin}`, which is no joint", link.id));
            }
            pins.push(self.names.of(Kind::Pin, pin));
        }
        let name = self.names.of(Kind::Link, &link.id);
        let on: Vec<_> = link.on.iter().map(|guide| self.names.of(Kind::Guide, guide)).collect();
        let on = if on.is_empty() { String::new() } else { format!(" on {}", on.join(", ")) };
        Ok(format!("link {name}({}){on};", pins.join(", ")))
    }

    fn mass(&mut self, mass: &Mass) -> Result<String, Mistake> {
        let place = self.place(place_in(self.drawing.frame(&mass.link)?, mass.at));
        let Mass { value, unit, inertia, unit_of_inertia, .. } = mass;
        let link = self.names.of(Kind::Link, &mass.link);
        Ok(format!("mass {value}{unit} on {link} at {place} inertia {inertia}({unit_of_inertia});"))
    }

    /// The point that a force acts on, and the force.
    fn force(&mut self, force: &Force) -> Result<[String; 2], Mistake> {
        let frame = self.drawing.frame(&force.link)?;
        let place = self.place(place_in(frame, force.at));
        let vector = if force.turns { turned_back(force.vector, frame.1) } else { force.vector };
        let [x, y] = vector.map(|newtons| format!("{}N", rounded(newtons) + 0.0));
        let link = self.names.of(Kind::Link, &force.link);
        let point = self.names.of(Kind::Force, &force.id);
        let axes = if force.turns { format!(" in {link}") } else { String::new() };
        Ok([
            format!("point {point} on {link} at {place};"),
            format!("force ({x}, {y}){axes} on {point};"),
        ])
    }

    fn guide(&mut self, guide: &Guide) -> Result<String, Mistake> {
        let name = self.names.of(Kind::Guide, &guide.id);
        let (on, frame) = match &guide.on {
            Some(link) => (
                format!(" on {}", self.names.of(Kind::Link, link)),
                Some(self.drawing.frame(link)?),
            ),
            None => (String::new(), None),
        };
        match &guide.line {
            Line::Pins(pins) => {
                if let Some(pin) = pins.iter().find(|pin| self.drawing.pin(pin).is_none()) {
                    return Err(format!("a slot goes through `{pin}`, which is no pin"));
                }
                let [from, to] = pins.each_ref().map(|pin| self.names.of(Kind::Pin, pin));
                Ok(format!("guide {name}{on} through {from} towards {to};"))
            }
            Line::Along { through, angle } => {
                let (through, angle) = match frame {
                    Some(frame) => seen_from(frame, *through, *angle),
                    None => (*through, *angle),
                };
                let (place, angle) = (self.place(through), along(angle));
                Ok(format!("guide {name}{on} through {place} along {angle};"))
            }
        }
    }
}

/// A line in the frame of the link that carries it.
fn seen_from(frame: ([f64; 2], f64), through: [f64; 2], angle: Angle) -> ([f64; 2], Angle) {
    let turn = frame.1;
    let angle = if turn == 0.0 { angle } else { Angle::Radians(rounded(angle.radians() - turn)) };
    (place_in(frame, through), angle)
}

/// A place of the drawing in the frame of a link.
fn place_in(([x, y], turn): ([f64; 2], f64), [u, v]: [f64; 2]) -> [f64; 2] {
    turned_back([u - x, v - y], turn)
}

fn turned_back([x, y]: [f64; 2], turn: f64) -> [f64; 2] {
    let (sin, cos) = turn.sin_cos();
    [cos * x + sin * y, cos * y - sin * x].map(rounded)
}

/// A computed number to twelve decimals of its unit, which is as near as its sine and cosine are.
fn rounded(number: f64) -> f64 {
    format!("{number:.12}").parse().unwrap_or(number)
}

fn along(angle: Angle) -> String {
    match angle {
        Angle::Radians(0.0) => "0deg".to_string(),
        Angle::Degrees(angle) => format!("{angle}deg"),
        Angle::Radians(angle) => format!("{angle}rad"),
        Angle::Vector([x, y]) if y == 0.0 && x > 0.0 => "0deg".to_string(),
        Angle::Vector([x, y]) => format!("atan2({y}, {x})"),
    }
}
