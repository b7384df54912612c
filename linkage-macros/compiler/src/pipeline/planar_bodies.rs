//! A drawing as bodies with masses, for simulators that know no groups.

use proc_macro2::{Ident, TokenStream};
use syn::ext::IdentExt;

use super::parsed::{Parsed, parsed};
use super::{at_defaults, placing, resolved, unknown_words};
use crate::diagnostics::{Diagnostic, Diagnostics, Failure};
use crate::exact::AtomScope;
use crate::ir::posing::{Conditions, Placing};
use crate::model::acting::{Ends, Magnitude, MassPlace, Stopped};
use crate::model::mechanism::{Carrier, LinkId, Mechanism, Param, PointId, Scalar};
use crate::model::{DrivenQuantity, PlanarQuantity, driven_quantities, value_at_defaults};

/// A drawing as bodies, in the drawn pose and in SI.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PlanarBodies {
    /// The mechanism's name.
    pub name: String,
    /// The points of the ground.
    pub ground: Vec<(String, [f64; 2])>,
    /// The links that are written.
    pub bodies: Vec<PlanarBody>,
    /// The guides.
    pub guides: Vec<PlanarGuide>,
    /// In ground axes; zero where none is written.
    pub gravity: [f64; 2],
    /// The inputs, and what they drive.
    pub inputs: Vec<PlanarInput>,
    /// Springs and dampers.
    pub springs: Vec<PlanarSpring>,
    /// Stops.
    pub stops: Vec<PlanarStop>,
    /// Parts of the declaration that are not here, in words.
    pub left_out: Vec<String>,
}

/// A link.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PlanarBody {
    /// The link's name.
    pub name: String,
    /// The points on it.
    pub pins: Vec<(String, [f64; 2])>,
    /// The guides on which it slides without turning, by their places.
    pub on: Vec<usize>,
    /// The frame of its statement: origin and angle.
    pub frame: ([f64; 2], f64),
    /// Its masses: mass, centre and inertia about that.
    pub masses: Vec<(f64, [f64; 2], f64)>,
    /// True of a cylinder, whose length is an input.
    pub is_cylinder: bool,
}

/// A guide.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PlanarGuide {
    /// The guide's name.
    pub name: String,
    /// The body that carries it; the ground where there is none.
    pub on: Option<usize>,
    /// A point of it.
    pub through: [f64; 2],
    /// The angle of its direction.
    pub along: f64,
}

/// An input.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PlanarInput {
    /// The input's name.
    pub name: String,
    /// The quantity that it is, and the factor before that.
    pub of: Option<(PlanarQuantity, f64)>,
    /// Its value in the drawing.
    pub drawn: f64,
}

/// A spring, a damper, or both: between points, or between bodies, of which nothing is the ground.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PlanarSpring {
    /// The points at its ends.
    pub points: Option<[String; 2]>,
    /// The bodies of a torsion spring: its angle is that of the second against the first.
    pub bodies: [Option<String>; 2],
    /// In N/m or N·m/rad.
    pub stiffness: f64,
    /// In N·s/m or N·m·s/rad.
    pub damping: f64,
    /// The length or the angle at which it is slack.
    pub free: f64,
}

/// A stop of a quantity.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PlanarStop {
    /// The quantity that it ends.
    pub of: PlanarQuantity,
    /// Its lower end and its upper one.
    pub ends: [f64; 2],
}

/// Reads a drawing as bodies, with parameters at their defaults. `conditions` are the run-time's, for the drawn pose.
///
/// # Errors
/// The mistakes in the declaration, in the order of the source, and a mechanism that is not drawn.
pub fn planar_bodies(
    source: TokenStream,
    conditions: &mut dyn Conditions,
) -> Result<PlanarBodies, Vec<Diagnostic>> {
    let _atoms = AtomScope::begin();
    let mut diagnostics = Diagnostics::new();
    let declaration = parsed(source, &mut diagnostics).map(Parsed::driven);
    let mechanism = declaration.as_ref().map(|tree| resolved(tree, &mut diagnostics));
    drop(diagnostics.take_notes());
    let (Some(tree), Some(Ok(mechanism))) = (&declaration, mechanism) else {
        return Err(diagnostics.finish().err().map_or(Vec::new(), |Failure(found)| found));
    };
    let made = Made::of(&mechanism, conditions).map(|made| made.bodies(driven_quantities(tree)));
    if made.is_none() {
        let message = format!("`{}` is not drawn, so that it has no bodies", mechanism.name);
        let reason = "write it by `pin`, `link` and inputs that are quantities of the drawing";
        diagnostics.error_because(mechanism.name.span(), message, reason);
    }
    diagnostics.finish().map_err(|Failure(found)| found)?;
    Ok(made.expect("what is missing has been reported"))
}

/// A mechanism, and where everything stands in its drawn pose.
struct Made<'a> {
    mechanism: &'a Mechanism,
    inputs: &'a [f64],
    numbers: Vec<f64>,
}

impl<'a> Made<'a> {
    fn of(mechanism: &'a Mechanism, conditions: &mut dyn Conditions) -> Option<Self> {
        mechanism.outline.as_ref()?;
        let inputs = mechanism.drawn.as_deref()?;
        let (given, unknowns) = (at_defaults(mechanism, inputs), unknown_words(mechanism));
        let numbers = Placing::new(&placing(mechanism)).numbers(&given, &unknowns, conditions);
        Some(Self { mechanism, inputs, numbers })
    }

    fn value(&self, scalar: &Scalar) -> Option<f64> {
        value_at_defaults(scalar, self.mechanism, self.inputs)
    }

    fn magnitude(&self, of: &Magnitude) -> f64 {
        self.value(&of.value).unwrap_or(0.0)
    }

    fn point(&self, point: PointId) -> [f64; 2] {
        [0, 1].map(|axis| self.numbers[2 * point.index() + axis])
    }

    /// The place of coordinates of a link's frame.
    fn on_link(&self, link: LinkId, [x, y]: [f64; 2]) -> [f64; 2] {
        let first = 2 * self.mechanism.points.len() + 5 * link.index();
        let [left, up, cos, sin] = [0, 1, 2, 3].map(|at| self.numbers[first + at]);
        [left + cos * x - sin * y, up + sin * x + cos * y]
    }

    fn name_of(&self, link: LinkId) -> String {
        text(self.mechanism.links[link.index()].known_as())
    }

    fn carrier(&self, carrier: Carrier) -> Option<String> {
        match carrier {
            Carrier::Ground => None,
            Carrier::Link(link) => Some(self.name_of(link)),
        }
    }

    fn point_name(&self, point: PointId) -> String {
        text(&self.mechanism.points[point.index()].name)
    }

    fn bodies(&self, quantities: Vec<(Ident, DrivenQuantity)>) -> PlanarBodies {
        let outline = self.mechanism.outline.as_ref().expect("there is one");
        let named = |list: &[(Ident, [f64; 2])]| -> Vec<(String, [f64; 2])> {
            list.iter().map(|(name, at)| (text(name), *at)).collect()
        };
        let is_input = |name: &Ident| self.mechanism.inputs.iter().any(|input| input.name == *name);
        let bodies = outline.bodies.iter().map(|body| PlanarBody {
            name: text(&body.name),
            pins: named(&body.pins),
            on: body.on.clone(),
            frame: (body.origin, body.angle),
            masses: Vec::new(),
            is_cylinder: body.length.as_ref().is_some_and(is_input),
        });
        let guides = outline.guides.iter().map(|guide| PlanarGuide {
            name: text(&guide.name),
            on: guide.on,
            through: guide.through,
            along: guide.along,
        });
        let gravity = self.mechanism.dynamics.gravity.as_ref();
        let gravity =
            gravity.map_or([0.0; 2], |at| at.each_ref().map(|g| self.value(g).unwrap_or(0.0)));
        let mut made = PlanarBodies {
            name: text(&self.mechanism.name),
            ground: named(&outline.ground),
            bodies: bodies.collect(),
            guides: guides.collect(),
            gravity,
            inputs: self.inputs(&quantities),
            springs: self.springs(),
            stops: Vec::new(),
            left_out: self.left_out(),
        };
        self.put_masses(&mut made);
        self.put_stops(&mut made);
        made
    }

    fn inputs(&self, quantities: &[(Ident, DrivenQuantity)]) -> Vec<PlanarInput> {
        let inputs = self.mechanism.inputs.iter().zip(self.inputs);
        let inputs = inputs.map(|(input, &drawn)| {
            let own = quantities.iter().find(|(name, _)| *name == input.name);
            PlanarInput {
                name: text(&input.name),
                of: own.and_then(|(_, quantity)| {
                    let factor = self.factor(quantity)?;
                    Some((quantity.of.clone(), factor))
                }),
                drawn,
            }
        });
        inputs.collect()
    }

    /// The product of the factors in front of a quantity.
    fn factor(&self, quantity: &DrivenQuantity) -> Option<f64> {
        let known = |name: &Ident| {
            let params = self.mechanism.params.iter();
            params.clone().find(|param| param.name == *name).map(Param::default_value)
        };
        quantity.factor(&known)
    }

    fn put_masses(&self, made: &mut PlanarBodies) {
        for mass in &self.mechanism.dynamics.masses {
            let (value, inertia) = (self.magnitude(&mass.mass), self.magnitude(&mass.inertia));
            let (body, at, inertia) = match &mass.place {
                MassPlace::Pin(point) => {
                    let name = self.point_name(*point);
                    let holds = |body: &&PlanarBody| {
                        !body.is_cylinder && body.pins.iter().any(|(pin, _)| *pin == name)
                    };
                    let body = made.bodies.iter().find(holds).map(|body| body.name.clone());
                    (body.unwrap_or_default(), self.point(*point), inertia)
                }
                MassPlace::Point(link, point) => (self.name_of(*link), self.point(*point), inertia),
                MassPlace::At(link, at) => {
                    let at = at.each_ref().map(|x| self.value(x).unwrap_or(0.0));
                    (self.name_of(*link), self.on_link(*link, at), inertia)
                }
                MassPlace::Uniform(link, length) => {
                    let length = self.value(length).unwrap_or(0.0);
                    let at = self.on_link(*link, [length / 2.0, 0.0]);
                    (self.name_of(*link), at, value * length * length / 12.0)
                }
            };
            match made.bodies.iter_mut().find(|other| other.name == body) {
                Some(body) => body.masses.push((value, at, inertia)),
                None => made.left_out.push(format!("{value} kg on {body}")),
            }
        }
    }

    fn springs(&self) -> Vec<PlanarSpring> {
        let springs = self.mechanism.dynamics.springs.iter().map(|spring| {
            let (points, bodies) = match spring.ends {
                Ends::Points(ends) => (Some(ends.map(|end| self.point_name(end))), [None, None]),
                Ends::Bodies(ends) => (None, ends.map(|end| self.carrier(end))),
            };
            PlanarSpring {
                points,
                bodies,
                stiffness: self.magnitude(&spring.stiffness),
                damping: self.magnitude(&spring.damping),
                free: self.magnitude(&spring.free),
            }
        });
        springs.collect()
    }

    fn put_stops(&self, made: &mut PlanarBodies) {
        for stop in &self.mechanism.dynamics.stops {
            let ends = stop.ends.each_ref().map(|end| self.value(end));
            let [Some(low), Some(high)] = ends else { continue };
            let (of, constant, factor) = match &stop.of {
                Stopped::Slide(link) => (Some(PlanarQuantity::Slide(self.name_of(*link))), 0.0, 1),
                Stopped::Distance(points) => {
                    let points = points.map(|point| self.point_name(point));
                    (Some(PlanarQuantity::Distance(points)), 0.0, 1)
                }
                Stopped::Angle(sum) => {
                    let constant = self.value(&sum.rest).unwrap_or(0.0);
                    let of = |link| self.name_of(link);
                    match sum.links[..] {
                        [(link, factor @ (1 | -1))] => {
                            (Some(PlanarQuantity::Angle(of(link), None)), constant, factor)
                        }
                        [(link, 1), (other, -1)] => {
                            let angle = PlanarQuantity::Angle(of(link), Some(of(other)));
                            (Some(angle), constant, 1)
                        }
                        _ => (None, 0.0, 1),
                    }
                }
            };
            let Some(of) = of else {
                made.left_out.push("a stop of a sum of angles".to_string());
                continue;
            };
            let mut ends = [low, high].map(|end| (end - constant) * f64::from(factor));
            ends.sort_by(f64::total_cmp);
            made.stops.push(PlanarStop { of, ends });
        }
    }

    /// The statements that say what no body has.
    fn left_out(&self) -> Vec<String> {
        let counts = self.mechanism.dynamics.beside_bodies().into_iter();
        let told = counts.filter(|(count, _)| *count > 0);
        told.map(|(count, what)| format!("{count} × {what}")).collect()
    }
}

/// A name without `r#`.
fn text(name: &Ident) -> String {
    name.unraw().to_string()
}
