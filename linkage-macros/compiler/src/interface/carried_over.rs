//! A pose of one set of inputs as one of another: where the numbers of the other stand, and by what its assembly is told.

use proc_macro2::Ident;

use crate::exact::Exact;
use crate::interface::labels;
use crate::model::mechanism::{
    Assembly, Carrier, DeclaredOutput, Group, GuideDirection, GuideId, Mechanism, Mode, OutputKind,
    PointId, Sign, Step, Through,
};

/// Where a number is found in the pose.
pub(crate) enum PlaceInPose {
    /// Among the inputs.
    Input(usize),
    /// In a row of the outputs; of an angle with its value in the drawing.
    Row(usize, Option<f64>),
    Fixed(f64),
}

/// The line that tells a side.
pub(crate) enum SideLine {
    Towards([PlaceInPose; 2]),
    Along([f64; 2]),
}

/// A group of the other, and the side that it has in the drawing.
pub(crate) struct Assembled {
    pub group: String,
    pub from: [PlaceInPose; 2],
    pub line: SideLine,
    pub pin: [PlaceInPose; 2],
    pub is_positive: bool,
}

/// The way from one set of inputs to another.
pub(crate) struct CarriedOver {
    pub coordinates: Vec<PlaceInPose>,
    pub sides: Vec<Assembled>,
    /// Rows of numbers of both, and the group that places them there: where a side has no sign, the other solver is asked
    /// and its points are compared.
    pub compared: Vec<(usize, usize, String)>,
}

impl CarriedOver {
    pub(crate) fn between(from: &Mechanism, to: &Mechanism) -> Self {
        let rows = Rows(from);
        let drawn = |input: usize| to.drawn.as_ref().map_or(0.0, |drawn| drawn[input]);
        let inputs = to.inputs.iter().enumerate();
        let coordinates = inputs.map(|(index, input)| rows.coordinate(&input.name, drawn(index)));
        let mut told = Vec::new();
        let mut is_told = to.unknowns.is_empty();
        for step in &to.steps {
            let Step::Group(group) = step else { continue };
            let Assembly::Signed(mode) = group.assembly else { continue };
            match rows.side(to, group, mode) {
                Some(side) => told.push(side),
                None => is_told = false,
            }
        }
        let compared = if is_told { Vec::new() } else { rows.compared(to) };
        Self { coordinates: coordinates.collect(), sides: told, compared }
    }
}

/// The rows of a mechanism's outputs.
struct Rows<'a>(&'a Mechanism);

impl Rows<'_> {
    /// The first row of an output.
    fn of(&self, is_it: impl Fn(&DeclaredOutput) -> bool) -> Option<(usize, &DeclaredOutput)> {
        let mut row = 0;
        for output in &self.0.outputs {
            if is_it(output) {
                return Some((row, output));
            }
            row += labels::rows(self.0, output).len();
        }
        None
    }

    fn coordinate(&self, name: &Ident, drawn: f64) -> PlaceInPose {
        if let Some(input) = self.0.inputs.iter().position(|input| input.name == *name) {
            return PlaceInPose::Input(input);
        }
        match self.of(|output| output.field == *name) {
            Some((row, output)) => {
                let is_angle = matches!(output.kind, OutputKind::Angle(_));
                PlaceInPose::Row(row, is_angle.then_some(drawn))
            }
            // A stub lacks results.
            None => PlaceInPose::Fixed(f64::NAN),
        }
    }

    /// Where a point of the other mechanism is in this one.
    fn place(&self, to: &Mechanism, point: PointId) -> Option<[PlaceInPose; 2]> {
        let name = &to.points[point.index()].name;
        let is_it = |output: &DeclaredOutput| {
            matches!(output.kind, OutputKind::Point(_)) && output.field == *name
        };
        if let Some((row, _)) = self.of(is_it) {
            return Some([PlaceInPose::Row(row, None), PlaceInPose::Row(row + 1, None)]);
        }
        let at = ground(to, point)?;
        Some(at.map(|at| PlaceInPose::Fixed(at.to_f64())))
    }

    fn side(&self, to: &Mechanism, group: &Group, mode: Mode) -> Option<Assembled> {
        let Mode::Fixed(sign) = mode else { return None };
        let (from, pin) = (self.place(to, group.outer[0].point()?)?, self.place(to, group.pin?)?);
        // A pin between a bar and another, or a bar and a block on a guide.
        let second = &group.outer[1];
        let line = match (second.point(), second.guide()) {
            (Some(point), _) => SideLine::Towards(self.place(to, point)?),
            (None, Some(guide)) => SideLine::Along(direction(to, guide)?),
            (None, None) => return None,
        };
        let group = to.groups[group.id.index()].title.clone();
        Some(Assembled { group, from, line, pin, is_positive: sign == Sign::Plus })
    }

    /// The points that both solvers place.
    fn compared(&self, to: &Mechanism) -> Vec<(usize, usize, String)> {
        let mut compared = Vec::new();
        let theirs = Rows(to);
        for output in &to.outputs {
            let OutputKind::Point(point) = output.kind else { continue };
            let is_it = |own: &DeclaredOutput| {
                matches!(own.kind, OutputKind::Point(_)) && own.field == output.field
            };
            let (Some((here, _)), Some((there, _))) = (self.of(is_it), theirs.of(is_it)) else {
                continue;
            };
            let group = placed_by(to, point);
            compared.extend([0, 1].map(|axis| (here + axis, there + axis, group.clone())));
        }
        compared
    }
}

/// The links of the group that places a point.
fn placed_by(mechanism: &Mechanism, point: PointId) -> String {
    use crate::model::mechanism::PartOf;
    let group = match mechanism.points[point.index()].part_of {
        PartOf::Ground => return "ground".to_string(),
        PartOf::Link(link) => mechanism.links[link.index()].made_by,
        PartOf::Pin(group) | PartOf::Driven(group) => group,
    };
    mechanism.groups[group.index()].title.clone()
}

/// The place of a point of the ground, where it is constant.
fn ground(mechanism: &Mechanism, wanted: PointId) -> Option<[Exact; 2]> {
    let [x, y] = mechanism.ground_place(wanted)?;
    Some([x.constant()?.clone(), y.constant()?.clone()])
}

/// The direction of a guide of the ground, where it is constant.
fn direction(mechanism: &Mechanism, wanted: GuideId) -> Option<[f64; 2]> {
    mechanism.steps.iter().find_map(|step| match step {
        Step::Guide { guide, carrier: Carrier::Ground, through, course } if *guide == wanted => {
            match course {
                GuideDirection::Along(angle) => {
                    let angle = angle.constant()?;
                    Some([angle.cos().to_f64(), angle.sin().to_f64()])
                }
                GuideDirection::Towards(to) => {
                    let Through::Point(from) = through else { return None };
                    let [from, to] = [ground(mechanism, *from)?, ground(mechanism, *to)?];
                    Some([0, 1].map(|axis| to[axis].to_f64() - from[axis].to_f64()))
                }
            }
        }
        _ => None,
    })
}
