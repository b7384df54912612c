//! What every driver and dyad is made of: its joints, whether it makes a pin, its fields, its
//! modes, and which of its links slide.

pub(super) struct Anatomy {
    pub keyword: &'static str,
    pub class: Class,
    /// The outer joints, one a link.
    pub joints: &'static [Joint],
    pub pin: Pin,
    pub fields: &'static [FieldRule],
    pub modes: Option<Modes>,
    /// Whether the first and the second link slide.
    pub slides: [bool; 2],
    /// The statement in full, for messages.
    pub form: &'static str,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    Crank,
    Slider,
    Rrr,
    Rrp,
    Rpr,
    Prp,
    Rpp,
    /// No group at all, but its fields are read like one's.
    Spring,
}

/// An outer joint: what it stands on, and what says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Joint {
    /// Stands on a point.
    Revolute(Reason),
    /// Stands on a guide.
    Prismatic(Reason),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reason {
    /// The letter of the keyword that names the joint.
    Letter(&'static str),
    /// What the driver does.
    Driver(&'static str),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Pin {
    Needed,
    Optional,
    /// With the reason why there is none.
    None(&'static str),
}

pub(super) struct FieldRule {
    pub name: &'static str,
    pub pair: bool,
    pub needed: Needed,
    /// What the field says, for a message that misses it.
    pub meaning: &'static str,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Needed {
    Always,
    /// Needed where the statement makes a pin, and refused where it does not.
    WithPin,
    Never,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Modes {
    /// `left` or `right`.
    Side,
    /// `ahead` or `behind`.
    Sense,
}

const fn needed(name: &'static str, meaning: &'static str) -> FieldRule {
    FieldRule { name, pair: false, needed: Needed::Always, meaning }
}

pub(super) const fn optional(name: &'static str, meaning: &'static str) -> FieldRule {
    FieldRule { name, pair: false, needed: Needed::Never, meaning }
}

const OFFSET: FieldRule = optional("offset", "the distance from the guide, along its normal");
const OFFSETS: FieldRule = FieldRule {
    pair: true,
    ..optional("offsets", "the distances from the two lines, along their normals")
};

/// Why an inner prismatic joint makes no pin.
const INNER_P: Pin = Pin::None("its inner joint is prismatic and has no point");

const ANATOMIES: [Anatomy; 7] = [
    Anatomy {
        keyword: "crank",
        class: Class::Crank,
        joints: &[Joint::Revolute(Reason::Driver("turns about a point"))],
        pin: Pin::Optional,
        fields: &[
            FieldRule {
                needed: Needed::WithPin,
                ..needed("length", "the distance from the pivot to the pin")
            },
            needed("angle", "the angle from the x axis of what it is relative to"),
            optional("relative_to", "`ground` or a link"),
        ],
        modes: None,
        slides: [false; 2],
        form: "crank AB(A) -> B { length: 80mm, angle: theta }",
    },
    Anatomy {
        keyword: "slider",
        class: Class::Slider,
        joints: &[Joint::Prismatic(Reason::Driver("slides on a guide"))],
        pin: Pin::Optional,
        fields: &[
            needed("slide", "the distance from the guide's point, along its direction"),
            OFFSET,
        ],
        modes: None,
        slides: [true, false],
        form: "slider ram(rail) -> P { slide: s }",
    },
    Anatomy {
        keyword: "rrr",
        class: Class::Rrr,
        joints: &[
            Joint::Revolute(Reason::Letter("first")),
            Joint::Revolute(Reason::Letter("third")),
        ],
        pin: Pin::Needed,
        fields: &[FieldRule {
            pair: true,
            ..needed("lengths", "the distances from each outer joint to the pin")
        }],
        modes: Some(Modes::Side),
        slides: [false; 2],
        form: "rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }",
    },
    Anatomy {
        keyword: "rrp",
        class: Class::Rrp,
        joints: &[
            Joint::Revolute(Reason::Letter("first")),
            Joint::Prismatic(Reason::Letter("third")),
        ],
        pin: Pin::Needed,
        fields: &[needed("length", "the distance from the outer joint to the pin"), OFFSET],
        modes: Some(Modes::Sense),
        slides: [false, true],
        form: "rrp BC(B), piston(rail) -> C { length: 300mm, mode: ahead }",
    },
    Anatomy {
        keyword: "rpr",
        class: Class::Rpr,
        joints: &[
            Joint::Revolute(Reason::Letter("first")),
            Joint::Revolute(Reason::Letter("third")),
        ],
        pin: INNER_P,
        fields: &[OFFSET],
        modes: Some(Modes::Sense),
        slides: [true, false],
        form: "rpr block(B), bar(D) { offset: 0 }",
    },
    Anatomy {
        keyword: "prp",
        class: Class::Prp,
        joints: &[
            Joint::Prismatic(Reason::Letter("first")),
            Joint::Prismatic(Reason::Letter("third")),
        ],
        pin: Pin::Needed,
        fields: &[OFFSETS],
        modes: None,
        slides: [true; 2],
        form: "prp p(rail1), q(rail2) -> C { offsets: (0, 0) }",
    },
    Anatomy {
        keyword: "rpp",
        class: Class::Rpp,
        joints: &[
            Joint::Revolute(Reason::Letter("first")),
            Joint::Prismatic(Reason::Letter("third")),
        ],
        pin: INNER_P,
        fields: &[needed("slot", "the angle of the slot to the rail"), OFFSETS],
        modes: None,
        slides: [true; 2],
        form: "rpp block(B), yoke(rail) { slot: 90deg }",
    },
];

impl Anatomy {
    pub(super) fn of(keyword: &str) -> Option<&'static Self> {
        ANATOMIES.iter().find(|anatomy| anatomy.keyword == keyword)
    }

    /// All drivers and dyads.
    pub(super) fn keywords() -> impl Iterator<Item = &'static str> {
        ANATOMIES.iter().map(|anatomy| anatomy.keyword)
    }

    /// The names of its fields, the mode included.
    pub(super) fn field_names(&self) -> Vec<&'static str> {
        let mut names: Vec<_> = self.fields.iter().map(|field| field.name).collect();
        names.extend(self.modes.map(|_| "mode"));
        names
    }
}

impl Modes {
    pub(super) fn words(self) -> [&'static str; 2] {
        match self {
            Self::Side => ["left", "right"],
            Self::Sense => ["ahead", "behind"],
        }
    }
}
