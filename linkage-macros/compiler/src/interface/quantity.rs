//! The components of a result: a point has x and y, a direction cosine and sine, a slide a length.
//!
//! One table says of each quantity, position, velocity and acceleration apart, which record of the
//! run-time crate holds it, what its components are called there and in the generated code, which
//! scalar rows it has in `OUTPUTS`, and what it is in words. Whatever lists components follows it.

use crate::model::mechanism::OutputKind;

/// The order of a result's derivative by time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    Position,
    Velocity,
    Acceleration,
}

impl Order {
    pub(crate) const ALL: [Self; 3] = [Self::Position, Self::Velocity, Self::Acceleration];
}

/// The kind of an output, which determines the number and order of its components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    Point,
    /// A link's direction, or a named angle's.
    Direction,
    /// The direction of a link that slides, and its slide.
    SlidingDirection,
    /// The slide alone.
    Slide,
    /// A number: a named expression, a ratio of rates, a margin, a transmission angle.
    Value,
    /// A force in ground axes.
    Force,
    /// The force and couple of a guide on the body that slides on it.
    GuideForce,
    /// The force and couple of inertia on the ground.
    Shaking,
}

/// A component.
#[derive(Debug, PartialEq, Eq)]
pub struct QuantityPart {
    /// Its field in the record; nothing where there is no record.
    pub field: &'static str,
    /// The end of the name of the local that holds it.
    pub local: &'static str,
}

/// The layout of a quantity at one order.
#[derive(Debug, PartialEq, Eq)]
pub struct Layout {
    /// The record of the run-time crate; none for a plain number.
    pub record: Option<&'static str>,
    /// The components, in the order of the record's fields and of an entry point's sinks.
    pub parts: &'static [QuantityPart],
    /// The scalar rows; of a direction the angle, at every order. A number's row has no name of
    /// its own.
    pub rows: &'static [&'static str],
    /// The meaning and the unit in words. The unit of a number depends on the output, so it is left out.
    pub words: &'static str,
}

impl Layout {
    /// True for each scalar row that is an angle, whose components are its cosine and sine.
    pub(crate) fn are_angles(&self) -> impl Iterator<Item = bool> {
        let has_direction = self.parts.len() > self.rows.len();
        (0..self.rows.len()).map(move |row| has_direction && row == 0)
    }
}

impl Quantity {
    /// All of them.
    pub(crate) const EVERY: [Self; 8] = [
        Self::Point,
        Self::Direction,
        Self::SlidingDirection,
        Self::Slide,
        Self::Value,
        Self::Force,
        Self::GuideForce,
        Self::Shaking,
    ];

    /// The quantity of an output.
    pub fn of(kind: &OutputKind) -> Self {
        match kind {
            OutputKind::Point(_) | OutputKind::CentreOfMass | OutputKind::Pole(_) => Self::Point,
            OutputKind::Link { direction: true, slide: true, .. } => Self::SlidingDirection,
            OutputKind::Link { direction: true, slide: false, .. } | OutputKind::Angle(_) => {
                Self::Direction
            }
            OutputKind::Link { direction: false, .. } => Self::Slide,
            OutputKind::Value { .. }
            | OutputKind::Ratio { .. }
            | OutputKind::Margin(_)
            | OutputKind::Transmission(_) => Self::Value,
        }
    }

    pub fn layout(self, order: Order) -> &'static Layout {
        let layouts = match self {
            Self::Point => &POINT,
            Self::Direction => &DIRECTION,
            Self::SlidingDirection => &SLIDING_DIRECTION,
            Self::Slide => &SLIDE,
            Self::Value => &VALUE,
            Self::Force => &FORCE,
            Self::GuideForce => &GUIDE_FORCE,
            Self::Shaking => &SHAKING,
        };
        let [position, velocity, acceleration] = layouts;
        match order {
            Order::Position => position,
            Order::Velocity => velocity,
            Order::Acceleration => acceleration,
        }
    }

    /// The scalar rows, of which there are as many at every order.
    pub fn rows(self) -> &'static [&'static str] {
        self.layout(Order::Position).rows
    }
}

const fn part(field: &'static str, local: &'static str) -> QuantityPart {
    QuantityPart { field, local }
}

const POINT: [Layout; 3] = [
    Layout {
        record: Some("Point"),
        parts: &[part("x", "x"), part("y", "y")],
        rows: &["x", "y"],
        words: "coordinates in m",
    },
    Layout {
        record: Some("Point"),
        parts: &[part("x", "vx"), part("y", "vy")],
        rows: &["x", "y"],
        words: "velocity in m/s",
    },
    Layout {
        record: Some("Point"),
        parts: &[part("x", "ax"), part("y", "ay")],
        rows: &["x", "y"],
        words: "acceleration in m/s²",
    },
];

const DIRECTION: [Layout; 3] = [
    Layout {
        record: Some("Direction"),
        parts: &[part("cos", "cos"), part("sin", "sin")],
        rows: &["angle"],
        words: "unit direction, counter-clockwise from +x",
    },
    Layout {
        record: Some("AngularVelocity"),
        parts: &[part("omega", "omega")],
        rows: &["angle"],
        words: "angular velocity in rad/s, counter-clockwise",
    },
    Layout {
        record: Some("AngularAcceleration"),
        parts: &[part("alpha", "alpha")],
        rows: &["angle"],
        words: "angular acceleration in rad/s², counter-clockwise",
    },
];

const SLIDING_DIRECTION: [Layout; 3] = [
    Layout {
        record: Some("SlidingDirection"),
        parts: &[part("cos", "cos"), part("sin", "sin"), part("slide", "slide")],
        rows: &["angle", "slide"],
        words: "unit direction, counter-clockwise from +x; slide along its guide in m",
    },
    Layout {
        record: Some("SlidingVelocity"),
        parts: &[part("omega", "omega"), part("slide", "slide_rate")],
        rows: &["angle", "slide"],
        words: "angular velocity in rad/s, counter-clockwise; rate of its slide in m/s",
    },
    Layout {
        record: Some("SlidingAcceleration"),
        parts: &[part("alpha", "alpha"), part("slide", "slide_acceleration")],
        rows: &["angle", "slide"],
        words: "angular acceleration in rad/s², counter-clockwise; acceleration of its slide in m/s²",
    },
];

const SLIDE: [Layout; 3] = [
    Layout {
        record: Some("Slide"),
        parts: &[part("slide", "slide")],
        rows: &["slide"],
        words: "slide along its guide in m",
    },
    Layout {
        record: Some("Slide"),
        parts: &[part("slide", "slide_rate")],
        rows: &["slide"],
        words: "rate of its slide in m/s",
    },
    Layout {
        record: Some("Slide"),
        parts: &[part("slide", "slide_acceleration")],
        rows: &["slide"],
        words: "acceleration of its slide in m/s²",
    },
];

const VALUE: [Layout; 3] = [
    Layout { record: None, parts: &[part("", "value")], rows: &[""], words: "" },
    Layout { record: None, parts: &[part("", "rate")], rows: &[""], words: ", its rate" },
    Layout {
        record: None,
        parts: &[part("", "acceleration")],
        rows: &[""],
        words: ", its acceleration",
    },
];

/// A force is no derivative of anything: it is laid out alike at every order.
const FORCE: [Layout; 3] = [const {
    Layout {
        record: Some("Force"),
        parts: &[part("x", "x"), part("y", "y")],
        rows: &["x", "y"],
        words: "in N",
    }
}; 3];

const GUIDE_FORCE: [Layout; 3] = [const {
    Layout {
        record: Some("GuideForce"),
        parts: &[part("normal", "normal"), part("couple", "couple")],
        rows: &["normal", "couple"],
        words: "normal force in N and couple in N·m",
    }
}; 3];

const SHAKING: [Layout; 3] = [const {
    Layout {
        record: Some("Shaking"),
        parts: &[part("x", "x"), part("y", "y"), part("couple", "couple")],
        rows: &["x", "y", "couple"],
        words: "force in N and couple in N·m",
    }
}; 3];
