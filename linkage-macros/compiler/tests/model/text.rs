//! A resolved mechanism as text: one line a statement, ids as the names they stand for.

use super::mechanism::*;

pub(super) fn text(mechanism: &Mechanism) -> String {
    let names = Names(mechanism);
    let mut lines = Vec::new();
    for input in &mechanism.inputs {
        lines.push(format!("input {}: {}", input.name, input.dimension.words()));
    }
    for param in &mechanism.params {
        let default = match &param.kind {
            ParamKind::Number { dimension, default, .. } => {
                format!("{} {}", dimension.words(), default.to_f64())
            }
            ParamKind::Mode { of, default } => {
                format!("{} {}", format!("{of:?}").to_lowercase(), sign(*default))
            }
        };
        lines.push(format!("param {}: {default}", param.name));
    }
    for (i, turn) in mechanism.lets.iter().enumerate() {
        lines.push(format!("let {i} = {}", names.turn(turn)));
    }
    lines.extend(mechanism.steps.iter().map(|step| names.step(step)));
    lines.extend(mechanism.outputs.iter().map(|output| names.output(output)));
    lines.join("\n")
}

fn sign(sign: Sign) -> char {
    if sign == Sign::Plus { '+' } else { '-' }
}

struct Names<'m>(&'m Mechanism);

impl Names<'_> {
    fn point(&self, id: PointId) -> String {
        self.0.points[id.index()].name.to_string()
    }

    fn link(&self, id: LinkId) -> String {
        self.0.links[id.index()].name.to_string()
    }

    fn guide(&self, id: GuideId) -> String {
        self.0.guides[id.index()].name.to_string()
    }

    fn carrier(&self, carrier: Carrier) -> String {
        match carrier {
            Carrier::Ground => "ground".to_string(),
            Carrier::Link(link) => self.link(link),
        }
    }

    /// The keyword and the links of a group, which its title names.
    fn made(&self, id: GroupId, links: &[LinkId]) -> String {
        let links: Vec<_> = links.iter().map(|&link| self.link(link)).collect();
        assert_eq!(links.join(", "), self.0.groups[id.index()].title);
        self.title(id)
    }

    fn title(&self, id: GroupId) -> String {
        let group = &self.0.groups[id.index()];
        format!("{} {}", group.keyword, group.title)
    }

    fn mode(&self, mode: Mode) -> String {
        match mode {
            Mode::Fixed(fixed) => sign(fixed).to_string(),
            Mode::Param(id) => self.0.params[id.index()].name.to_string(),
        }
    }

    fn expr(&self, expr: &Scalar) -> String {
        match expr {
            Scalar::Constant(value) => value.to_f64().to_string(),
            Scalar::Input(id) => self.0.inputs[id.index()].name.to_string(),
            Scalar::Load(id) => self.0.dynamics.loads[id.index()].name.to_string(),
            Scalar::Pull => "pull".to_string(),
            Scalar::Param(id) => self.0.params[id.index()].name.to_string(),
            Scalar::Let(id) => format!("let{}", id.0),
            Scalar::Law(id) => format!("law{}", id.0),
            Scalar::Effort(effort, part) => format!("{effort:?}[{part}]"),
            Scalar::Slide(link) => format!("{}.slide", self.link(*link)),
            Scalar::Coordinate(point, axis) => {
                format!("{}.{axis:?}", self.point(*point)).to_lowercase()
            }
            Scalar::Twist(id) => format!("twist {}", id.index()),
            Scalar::Rate(turn) => format!("rate({})", self.turn(turn)),
            Scalar::Distance([p, q]) => format!("distance({}, {})", self.point(*p), self.point(*q)),
            Scalar::Offset(point, guide) => {
                format!("offset({}, {})", self.point(*point), self.guide(*guide))
            }
            Scalar::Unknown(id) => self.0.unknowns[id.index()].name.to_string(),
            Scalar::Tracked(id, index) => {
                self.0.tracked[id.index()].fit.unknowns[*index].name.clone()
            }
            Scalar::AboveZero(inner) => self.expr(&inner.value),
            Scalar::Negate(value) => format!("(-{})", self.expr(value)),
            Scalar::Chain(first, rest) => {
                rest.iter().fold(self.expr(first), |left, (operator, right)| {
                    let operator = match operator {
                        Operator::Add => '+',
                        Operator::Sub => '-',
                        Operator::Mul => '*',
                        Operator::Div => '/',
                    };
                    format!("({left} {operator} {})", self.expr(right))
                })
            }
            Scalar::Call(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|a| self.expr(a)).collect();
                format!("{function:?}({})", arguments.join(", ")).to_lowercase()
            }
        }
    }

    fn pair(&self, [first, second]: &[Scalar; 2]) -> String {
        format!("({}, {})", self.expr(first), self.expr(second))
    }

    fn turn(&self, turn: &AngleSum) -> String {
        let links = turn.links.iter().map(|(link, k)| format!("{k}*{}.angle", self.link(*link)));
        links.chain([self.expr(&turn.rest)]).collect::<Vec<_>>().join(" + ")
    }

    /// The value, and the name that run-time errors give it.
    fn length(&self, length: &Length) -> String {
        format!("{} `{}`", self.expr(&length.value), length.name)
    }

    fn step(&self, step: &Step) -> String {
        match step {
            Step::Ground { point, at } => format!("ground {}{}", self.point(*point), self.pair(at)),
            Step::Guide { guide, carrier, through, course } => {
                let through = match through {
                    Through::At(at) => self.pair(at),
                    Through::Point(point) => self.point(*point),
                };
                let course = match course {
                    GuideDirection::Along(turn) => format!("along {}", self.turn(turn)),
                    GuideDirection::Towards(point) => format!("towards {}", self.point(*point)),
                };
                let (guide, carrier) = (self.guide(*guide), self.carrier(*carrier));
                format!("guide {guide} on {carrier} through {through} {course}")
            }
            Step::Point { point, carrier, place, group } => {
                let place = match place {
                    Placement::Cartesian(at) => self.pair(at),
                    Placement::Polar(radius, angle) => {
                        format!("polar ({}, {})", self.expr(radius), self.expr(angle))
                    }
                    Placement::Distances { distances, length, side } => format!(
                        "distances ({}, {}) of {} {}",
                        self.length(&distances[0]),
                        self.length(&distances[1]),
                        self.expr(length),
                        sign(*side)
                    ),
                };
                let (point, carrier) = (self.point(*point), self.carrier(*carrier));
                format!("point {point} on {carrier} at {place} by {}", self.title(*group))
            }
            Step::Group(group) => match &group.outer[0].drive {
                Some(drive) => self.driver(group, drive),
                None => self.dyad(group),
            },
        }
    }

    fn driver(&self, group: &Group, drive: &Drive) -> String {
        let made = self.made(group.id, &group.links);
        let pin = group.pin.map_or(String::new(), |pin| format!(" -> {}", self.point(pin)));
        let length = group.lengths[0].as_ref().map(|length| format!(" at {}", self.length(length)));
        let pin = pin + &length.unwrap_or_default();
        match drive {
            Drive::Angle { angle, relative_to } => {
                let (pivot, angle) = (self.point(group.stands_on(0)), self.turn(angle));
                format!("{made}({pivot}){pin} turned {angle} from {}", self.carrier(*relative_to))
            }
            Drive::Slide(slide) => {
                let (guide, slide) = (self.guide(group.slides_on(0)), self.expr(slide));
                let offset = self.expr(group.outer[0].offset().unwrap());
                format!("{made}({guide}){pin} {slide} offset {offset}")
            }
        }
    }

    fn dyad(&self, group: &Group) -> String {
        let made = self.made(group.id, &group.links);
        let outer = group.outer.iter().map(|joint| match joint.point() {
            Some(point) => self.point(point),
            None => self.guide(joint.guide().unwrap()),
        });
        let outer = outer.collect::<Vec<_>>().join(", ");
        let pin = group.pin.map_or(String::new(), |pin| format!(" -> {}", self.point(pin)));
        let lengths = group.lengths.iter().flatten().map(|length| self.length(length));
        let lengths = match &lengths.collect::<Vec<_>>()[..] {
            [] => String::new(),
            [only] => format!(" length {only}"),
            several => format!(" lengths {}", several.join(", ")),
        };
        let slot = group.inner[0].slideway().and_then(|slideway| match slideway {
            Slideway::Slot { angle, .. } => Some(format!(" slot {}", self.turn(angle))),
            Slideway::Guide(_) | Slideway::Bar(_) => None,
        });
        let slot = slot.unwrap_or_default();
        let offsets = match group.offsets()[..] {
            [] => String::new(),
            [only] => format!(" offset {}", self.expr(only)),
            [first, second] => format!(" offsets ({}, {})", self.expr(first), self.expr(second)),
            _ => unreachable!("no statement has three"),
        };
        let mode = group.mode().map_or(String::new(), |mode| format!(" mode {}", self.mode(mode)));
        format!("{made} on {outer}{pin}{lengths}{slot}{offsets}{mode}")
    }

    fn output(&self, output: &DeclaredOutput) -> String {
        let what = match &output.kind {
            OutputKind::CentreOfMass => "centre of mass".to_string(),
            OutputKind::Point(point) => format!("point {}", self.point(*point)),
            OutputKind::Link { link, direction, slide } => {
                let link = self.link(*link);
                let parts = [direction.then_some("angle"), slide.then_some("slide")];
                let parts: Vec<_> = parts.into_iter().flatten().collect();
                format!("{link}.{}", parts.join("+"))
            }
            OutputKind::Value { value, dimension } => {
                format!("{} {}", dimension.words(), self.expr(value))
            }
            OutputKind::Ratio { value, dimension } => {
                format!("ratio {} {}", dimension.words(), self.expr(value))
            }
            OutputKind::Pole(links) => {
                let links: Vec<_> = links.iter().map(|(link, _)| self.link(*link)).collect();
                format!("pole of {}", links.join(" against "))
            }
            OutputKind::Angle(turn) => format!("turn {}", self.turn(turn)),
            OutputKind::Margin(group) => format!("margin of {}", self.title(*group)),
            OutputKind::Transmission(group) => format!("transmission of {}", self.title(*group)),
        };
        format!("output {} = {what}", output.field)
    }
}
