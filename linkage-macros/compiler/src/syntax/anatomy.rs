//! The anatomy of every driver and dyad: its joints, its pin, its fields, its modes, and the links
//! that slide.

pub struct GroupSpec {
    pub keyword: &'static str,
    /// None of a spring, which is no group, but has fields like one.
    pub class: Option<Class>,
    /// The outer joints, one a link.
    pub joints: &'static [JointRule],
    pub pin: Pin,
    pub fields: &'static [FieldRule],
    pub modes: Option<Modes>,
    /// The statement in full, for messages.
    pub form: &'static str,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    Crank,
    Slider,
    Rrr,
    Rrp,
    Rpr,
    Prp,
    Rpp,
}

/// An outer joint: what it stands on, and what says so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointRule {
    /// Stands on a point.
    Revolute(Reason),
    /// Stands on a guide.
    Prismatic(Reason),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reason {
    /// The letter of the keyword that names the joint.
    Letter(&'static str),
    /// A driver's own joint, with the driver's motion in words.
    Driver(&'static str),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pin {
    Needed,
    Optional,
    /// With the reason why there is none.
    None(&'static str),
}

pub struct FieldRule {
    pub name: &'static str,
    pub pair: bool,
    pub needed: Needed,
    /// The meaning of the field, for the message that it is missing.
    pub meaning: &'static str,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needed {
    Always,
    /// Needed where the statement makes a pin, and refused where it does not.
    WithPin,
    Never,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Modes {
    /// `left` or `right`.
    Side,
    /// `ahead` or `behind`.
    Sense,
    /// `rising` or `falling`, of equations.
    Trend,
}

/// The properties of a kind of mode.
pub(crate) struct ModeRow {
    /// The word for +1, and that for −1.
    pub words: [&'static str; 2],
    /// The type, whose variants are the words.
    pub type_name: &'static str,
    /// The function that makes one of the number that C gives.
    pub from_c: &'static str,
    /// The numbers that C gives.
    pub in_c: &'static str,
}

pub(crate) const fn needed(name: &'static str, meaning: &'static str) -> FieldRule {
    FieldRule { name, pair: false, needed: Needed::Always, meaning }
}

pub(crate) const fn optional(name: &'static str, meaning: &'static str) -> FieldRule {
    FieldRule { name, pair: false, needed: Needed::Never, meaning }
}

const OFFSET: FieldRule = optional("offset", "the distance from the guide, along its normal");
const OFFSETS: FieldRule = FieldRule {
    pair: true,
    ..optional("offsets", "the distances from the two lines, along their normals")
};

/// Why an inner prismatic joint makes no pin.
const INNER_P: Pin = Pin::None("its inner joint is prismatic and has no point");

const ANATOMIES: [GroupSpec; 7] = [
    GroupSpec {
        keyword: "crank",
        class: Some(Class::Crank),
        joints: &[JointRule::Revolute(Reason::Driver("turns about a point"))],
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
        form: "crank AB(A) -> B { length: 80mm, angle: theta }",
    },
    GroupSpec {
        keyword: "slider",
        class: Some(Class::Slider),
        joints: &[JointRule::Prismatic(Reason::Driver("slides on a guide"))],
        pin: Pin::Optional,
        fields: &[
            needed("slide", "the distance from the guide's point, along its direction"),
            OFFSET,
        ],
        modes: None,
        form: "slider ram(rail) -> P { slide: s }",
    },
    GroupSpec {
        keyword: "rrr",
        class: Some(Class::Rrr),
        joints: &[
            JointRule::Revolute(Reason::Letter("first")),
            JointRule::Revolute(Reason::Letter("third")),
        ],
        pin: Pin::Needed,
        fields: &[FieldRule {
            pair: true,
            ..needed("lengths", "the distances from each outer joint to the pin")
        }],
        modes: Some(Modes::Side),
        form: "rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }",
    },
    GroupSpec {
        keyword: "rrp",
        class: Some(Class::Rrp),
        joints: &[
            JointRule::Revolute(Reason::Letter("first")),
            JointRule::Prismatic(Reason::Letter("third")),
        ],
        pin: Pin::Needed,
        fields: &[needed("length", "the distance from the outer joint to the pin"), OFFSET],
        modes: Some(Modes::Sense),
        form: "rrp BC(B), piston(rail) -> C { length: 300mm, mode: ahead }",
    },
    GroupSpec {
        keyword: "rpr",
        class: Some(Class::Rpr),
        joints: &[
            JointRule::Revolute(Reason::Letter("first")),
            JointRule::Revolute(Reason::Letter("third")),
        ],
        pin: INNER_P,
        fields: &[OFFSET],
        modes: Some(Modes::Sense),
        form: "rpr block(B), bar(D) { offset: 0 }",
    },
    GroupSpec {
        keyword: "prp",
        class: Some(Class::Prp),
        joints: &[
            JointRule::Prismatic(Reason::Letter("first")),
            JointRule::Prismatic(Reason::Letter("third")),
        ],
        pin: Pin::Needed,
        fields: &[OFFSETS],
        modes: None,
        form: "prp p(rail1), q(rail2) -> C { offsets: (0, 0) }",
    },
    GroupSpec {
        keyword: "rpp",
        class: Some(Class::Rpp),
        joints: &[
            JointRule::Revolute(Reason::Letter("first")),
            JointRule::Prismatic(Reason::Letter("third")),
        ],
        pin: INNER_P,
        fields: &[needed("slot", "the angle of the slot to the rail"), OFFSETS],
        modes: None,
        form: "rpp block(B), yoke(rail) { slot: 90deg }",
    },
];

/// The words that begin the statement of a driver or of a dyad.
pub const KEYWORDS: [&str; ANATOMIES.len()] = {
    let mut words = [""; ANATOMIES.len()];
    let mut i = 0;
    while i < words.len() {
        words[i] = ANATOMIES[i].keyword;
        i += 1;
    }
    words
};

impl GroupSpec {
    pub fn of(keyword: &str) -> Option<&'static Self> {
        ANATOMIES.iter().find(|anatomy| anatomy.keyword == keyword)
    }

    /// Tells of the first and the second link whether they slide: on a guide, or the first in the second.
    pub(crate) fn slides(&self) -> [bool; 2] {
        [0, 1].map(|index| match self.joints.get(index) {
            Some(JointRule::Prismatic(_)) => true,
            Some(JointRule::Revolute(_)) => index == 0 && self.has_inner_slide(),
            None => false,
        })
    }

    /// Tells whether its inner joint is prismatic, and so makes no pin.
    pub(crate) fn has_inner_slide(&self) -> bool {
        matches!(self.pin, Pin::None(_))
    }

    /// True for a dyad, which has a transmission angle; false for a driver.
    pub(crate) fn is_dyad(&self) -> bool {
        self.joints.len() == 2
    }

    /// True if its bars can be opposite sides of a parallelogram.
    pub(crate) fn can_be_parallel(&self) -> bool {
        self.class == Some(Class::Rrr)
    }

    /// True if it can be out of reach: its two modes meet at the limit.
    pub(crate) fn has_a_limit(&self) -> bool {
        self.modes.is_some()
    }

    /// True if it has bars, whose lengths are given.
    pub(crate) fn has_length(&self) -> bool {
        self.fields.iter().any(|field| ["length", "lengths"].contains(&field.name))
    }

    /// The fields that must be written, as an example: `{ length: …, angle: … }`.
    pub(super) fn braces(&self) -> String {
        let needed = self.fields.iter().filter(|field| field.needed != Needed::Never);
        let mut fields: Vec<String> = needed
            .map(|field| format!("{}: {}", field.name, if field.pair { "(…, …)" } else { "…" }))
            .collect();
        fields.extend(self.mode_is_needed().then(|| "mode: …".to_string()));
        match fields.is_empty() {
            true => "{ }".to_string(),
            false => format!("{{ {} }}", fields.join(", ")),
        }
    }

    /// Only of a block on a bar one mode is almost always meant: it has a default.
    pub(crate) fn mode_is_needed(&self) -> bool {
        self.modes.is_some() && !self.has_inner_slide()
    }

    /// The head of a dyad, for messages: `rrr BC(B), DC(D) -> C { … }`.
    pub(super) fn dyad_in_short() -> String {
        let form = ANATOMIES.iter().find(|anatomy| anatomy.is_dyad()).map_or("", |dyad| dyad.form);
        let head = form.split('{').next().unwrap_or_default();
        format!("{head}{{ … }}")
    }

    /// The keywords of the groups that have these modes: `rrp` and `rpr`.
    pub(crate) fn keywords_with(modes: Modes) -> String {
        let those = ANATOMIES.iter().filter(|anatomy| anatomy.modes == Some(modes));
        those.map(|anatomy| format!("`{}`", anatomy.keyword)).collect::<Vec<_>>().join(" and ")
    }

    /// The names of its fields, the mode included.
    pub(crate) fn field_names(&self) -> Vec<&'static str> {
        let mut names: Vec<_> = self.fields.iter().map(|field| field.name).collect();
        names.extend(self.modes.map(|_| "mode"));
        names
    }
}

impl Modes {
    pub(crate) const ALL: [Self; 3] = [Self::Side, Self::Sense, Self::Trend];

    pub(crate) const fn row(self) -> ModeRow {
        match self {
            Self::Side => ModeRow {
                words: ["left", "right"],
                type_name: "Side",
                from_c: "c_side",
                in_c: "LINKAGE_LEFT or LINKAGE_RIGHT",
            },
            Self::Sense => ModeRow {
                words: ["ahead", "behind"],
                type_name: "Sense",
                from_c: "c_sense",
                in_c: "LINKAGE_AHEAD or LINKAGE_BEHIND",
            },
            Self::Trend => ModeRow {
                words: ["rising", "falling"],
                type_name: "Trend",
                from_c: "c_trend",
                in_c: "1 where the equation rises, or -1",
            },
        }
    }

    pub const fn words(self) -> [&'static str; 2] {
        self.row().words
    }

    /// The variant of the type that a word names.
    pub(crate) fn variant(word: &str) -> String {
        format!("{}{}", word[..1].to_uppercase(), &word[1..])
    }
}
