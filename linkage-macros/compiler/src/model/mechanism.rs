//! The resolved mechanism: every name is a typed id, every number an expression whose dimension
//! was checked, every statement a step in solving order.
//!
//! Identifiers keep their spans for the fields and docs of the generated code; nothing else here
//! remembers the source text.

use proc_macro2::Ident;
use syn::{Attribute, Visibility};

use crate::exact::Exact;
use crate::model::acting::Dynamics;
pub use crate::model::as_drawn::AsDrawn;
pub use crate::model::dimension::Dimension;
use crate::model::drawn_bodies::Outline;
pub use crate::model::expr::{AboveZero, AngleSum, Axis, Operator, Scalar};
pub use crate::model::findings::{Known, Rotatability, Touching};
pub use crate::model::ids::{
    GroupId, GuideId, InputId, LawId, LetId, LinkId, LoadId, ParamId, PointId, SpringId, StopId,
    TrackedId, UnknownId,
};
pub use crate::model::incidence::{
    Assembly, Body, Carrier, Drive, Group, Joint, JointKind, Length, Mode, Opposite, Sign, Slideway,
};
pub use crate::model::solved_at_once::{Tracked, TrackedClosing};
pub use crate::model::step::{GuideDirection, Placement, Step, Through};
use crate::syntax::anatomy::Modes;

#[derive(Clone)]
pub struct Mechanism {
    pub docs: Vec<Attribute>,
    pub visibility: Visibility,
    pub name: Ident,
    pub inputs: Vec<Input>,
    pub params: Vec<Param>,
    /// The unknowns that equations fix, in solving order.
    pub unknowns: Vec<Unknown>,
    /// Groups that are solved by all their unknowns at once, in solving order.
    pub tracked: Vec<Tracked>,
    /// Named expressions; a later one may use an earlier one.
    pub lets: Vec<AngleSum>,
    pub points: Vec<Point>,
    pub links: Vec<Link>,
    pub guides: Vec<Guide>,
    /// Drivers and dyads, for messages and docs.
    pub groups: Vec<GroupName>,
    /// The steps that place points, guides and links, in solving order: a step uses only the results
    /// of earlier steps.
    pub steps: Vec<Step>,
    pub outputs: Vec<DeclaredOutput>,
    /// The ranges of the cranks' turns that dyads of constants allow.
    pub rotatabilities: Vec<Rotatability>,
    pub touchings: Vec<Touching>,
    /// Facts that constants fix about groups, for their docs.
    pub known: Vec<Known>,
    /// Masses, and what acts.
    pub dynamics: Dynamics,
    /// For editors.
    pub references: References,
    /// The inputs of the pose in which it is drawn, where it is drawn and they are determined.
    pub drawn: Option<Vec<f64>>,
    /// The bodies of the drawing, where it is one.
    pub outline: Option<Outline>,
    /// Slides, drives and directions that groups have otherwise than the drawing.
    pub as_drawn: AsDrawn,
    /// True if the declaration has mistakes, so that only part of it was understood.
    pub is_stub: bool,
    pub numerics: Numerics,
    /// `crate = path;`, where given.
    pub crate_path: Option<syn::Path>,
    /// `export c;`
    pub export_c: bool,
    /// The word by which lists of assemblies are asked for.
    pub export_assemblies: Option<Ident>,
}

#[derive(Clone)]
pub struct Point {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub part_of: PartOf,
    /// True if nobody has written its name.
    pub is_hidden: bool,
}

/// The part of the mechanism that a point belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartOf {
    Ground,
    /// Placed on a link.
    Link(LinkId),
    /// The pin of a driver, or between the links of a dyad.
    Pin(GroupId),
    /// Driven in ground axes.
    Driven(GroupId),
}

impl Mechanism {
    /// An empty mechanism of this name.
    pub fn empty(docs: Vec<Attribute>, visibility: Visibility, name: Ident) -> Self {
        Self {
            docs,
            visibility,
            name,
            inputs: Vec::new(),
            params: Vec::new(),
            unknowns: Vec::new(),
            tracked: Vec::new(),
            lets: Vec::new(),
            points: Vec::new(),
            links: Vec::new(),
            guides: Vec::new(),
            groups: Vec::new(),
            steps: Vec::new(),
            outputs: Vec::new(),
            rotatabilities: Vec::new(),
            touchings: Vec::new(),
            known: Vec::new(),
            dynamics: Dynamics::default(),
            references: References::default(),
            drawn: None,
            outline: None,
            as_drawn: AsDrawn::default(),
            is_stub: false,
            numerics: Numerics::Plain,
            crate_path: None,
            export_c: false,
            export_assemblies: None,
        }
    }

    pub(crate) fn point_ids(&self) -> impl Iterator<Item = PointId> + use<> {
        (0..self.points.len() as u32).map(PointId)
    }

    pub fn link_ids(&self) -> impl Iterator<Item = LinkId> + use<> {
        (0..self.links.len() as u32).map(LinkId)
    }

    pub(crate) fn guide_ids(&self) -> impl Iterator<Item = GuideId> + use<> {
        (0..self.guides.len() as u32).map(GuideId)
    }

    /// The statement that makes a group, as errors and docs call it: `rrr BC, DC`.
    pub(crate) fn statement(&self, group: GroupId) -> String {
        let GroupName { keyword, title, .. } = &self.groups[group.index()];
        format!("{keyword} {title}")
    }

    /// The statement that made a point: `ground`, `crank AB`, `rrr BC, DC`, `point on BC`.
    pub fn maker(&self, point: PointId) -> String {
        match self.points[point.index()].part_of {
            PartOf::Ground => "ground".to_string(),
            PartOf::Link(link) => format!("point on {}", self.links[link.index()].name),
            PartOf::Pin(group) => self.statement(group),
            PartOf::Driven(_) => "driven point".to_string(),
        }
    }
}

#[derive(Clone)]
pub struct Guide {
    pub name: Ident,
}

/// Where a declaration makes its names and where it uses them, for editors.
#[derive(Clone, Default)]
pub struct References {
    /// Every name where it is made, and the statement that makes it.
    pub made: Vec<(Ident, String)>,
    /// Every place where one of them is used.
    pub used: Vec<Ident>,
}

#[derive(Clone)]
pub struct Input {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub dimension: Dimension,
}

/// A number that an equation fixes.
#[derive(Clone)]
pub struct Unknown {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub dimension: Dimension,
    /// Its title is the unknown's name: what fails with it.
    pub group: GroupId,
    /// Where it is looked for, lower end first.
    pub between: [Scalar; 2],
    /// The number of steps before `unknown`, and before `solve`. The steps between depend on the
    /// trial.
    pub steps: [usize; 2],
    pub equation: Equation,
    /// The dimension of both sides.
    pub measure: Dimension,
    /// The sign of the slope of left − right at the wanted root: plus where it rises.
    pub mode: Mode,
    /// Where the root is expected.
    pub near: Option<Scalar>,
}

/// The expression that is zero at the root.
#[derive(Clone)]
pub enum Equation {
    /// left − right
    Difference([Scalar; 2]),
    /// An angle, within half a turn.
    Turn(AngleSum),
    /// The distance of two points is a length.
    Distance { points: [PointId; 2], length: Length, is_left: bool },
}

#[derive(Clone)]
pub struct Param {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub kind: ParamKind,
}

#[derive(Clone)]
pub enum ParamKind {
    Number {
        dimension: Dimension,
        default: Exact,
        /// The unit in which the default is written, and its value in SI; none for anything but a number
        /// with one unit.
        written_in: Option<(String, Exact)>,
    },
    Mode {
        of: Modes,
        default: Sign,
    },
}

#[derive(Clone)]
pub struct Link {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub made_by: GroupId,
    /// True if it slides on a guide and so has a `slide`.
    pub slides: bool,
    pub stands_for: StandsFor,
}

/// The parts of a drawing that something stands for whose name nobody may have written.
#[derive(Clone, Default)]
pub enum StandsFor {
    /// Itself: it is declared.
    #[default]
    Itself,
    /// A link at one of its joints, where it is a block that holds that in place.
    EndOf(Ident),
    /// Links of which it is a part, or that it moves.
    Links(Vec<Ident>),
}

impl Param {
    /// The declared value; of a mode +1 or −1.
    pub(crate) fn default_value(&self) -> f64 {
        match &self.kind {
            ParamKind::Number { default, .. } => default.to_f64(),
            ParamKind::Mode { default: Sign::Plus, .. } => 1.0,
            ParamKind::Mode { default: Sign::Minus, .. } => -1.0,
        }
    }
}

impl Link {
    /// Its name, or that of the link at whose joint it is.
    pub fn known_as(&self) -> &Ident {
        match &self.stands_for {
            StandsFor::EndOf(link) => link,
            StandsFor::Itself | StandsFor::Links(_) => &self.name,
        }
    }
}

/// The name of a driver or a dyad, or of a driven point, which is a group of its own.
#[derive(Clone)]
pub struct GroupName {
    /// `crank`, `slider`, `rrr`, …, where it is written.
    pub keyword: Ident,
    /// The links, as run-time errors name them: `"BC, DC"`.
    pub title: String,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numerics {
    Plain,
    Compensated,
}

#[derive(Clone)]
pub struct DeclaredOutput {
    /// The field of the result.
    pub field: Ident,
    pub docs: Vec<Attribute>,
    pub kind: OutputKind,
}

#[derive(Clone)]
pub enum OutputKind {
    Point(PointId),
    /// A link's direction, its slide, or both.
    Link {
        link: LinkId,
        direction: bool,
        slide: bool,
    },
    /// A named expression.
    Value {
        value: Scalar,
        dimension: Dimension,
    },
    /// A named number that reads rates and depends on none of them: that of the only input is left out.
    Ratio {
        value: Scalar,
        dimension: Dimension,
    },
    /// The instant centre of a link against the ground, or of two, as they are written. None in a stub.
    Pole(Vec<(LinkId, Ident)>),
    /// A named angle that contains link angles: given by its direction.
    Angle(AngleSum),
    /// Signed distance of the group from its limit.
    Margin(GroupId),
    /// Transmission angle of the group, from 0 to π.
    Transmission(GroupId),
    /// The centre of all masses.
    CentreOfMass,
}
