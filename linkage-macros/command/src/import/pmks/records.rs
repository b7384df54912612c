//! The records of an address, in whichever form they were written.

/// The mass and the inertia that a link has unless a user changes them; a piston has no inertia.
pub(super) const MASS_AND_INERTIA: [f64; 2] = [1.0, 1.0];

/// Newtons of a pound's weight.
pub(super) const POUND: f64 = 4.448_221_615_260_5;

/// An address, read and not yet drawn.
pub(super) struct Records<'a> {
    pub unit: &'static str,
    /// The speed of the inputs, in turns a minute.
    pub speed: f64,
    /// Newtons of the unit of forces, where it is known.
    pub newtons: Option<f64>,
    pub has_gravity: bool,
    /// True if a weld of parts of a link is one of the block at their joint.
    pub welds_blocks: bool,
    pub joints: Vec<Joint<'a>>,
    pub members: Vec<Member<'a>>,
    /// The links that are welded together to others.
    pub parts: Vec<Member<'a>>,
    pub forces: Vec<Arrow<'a>>,
    /// The parts of the address that mean nothing here.
    pub left_out: Vec<String>,
}

impl Records<'_> {
    /// True if a prismatic joint has no piston: it is the pin, the block and the guide in one.
    pub(super) fn is_slider(&self, joint: &Joint<'_>) -> bool {
        let is_through =
            |member: &Member<'_>| !member.is_piston && member.joints.contains(&joint.id);
        joint.is_prismatic && self.members.iter().any(is_through)
    }
}

/// The name of the link that a slider's block is.
pub(super) fn block(joint: &Joint<'_>) -> String {
    format!("block_{}", joint.id)
}

pub(super) struct Joint<'a> {
    pub id: &'a str,
    pub title: &'a str,
    pub at: [f64; 2],
    pub angle: f64,
    pub is_prismatic: bool,
    pub is_input: bool,
    pub is_ground: bool,
    /// True if the links through it are one, unless they are parts of one link already.
    pub is_welded: bool,
    /// The link that carries a slot, and the joints through which it goes.
    pub slot: Option<[&'a str; 3]>,
    /// The speed of an input that has one of its own.
    pub speed: Option<f64>,
    /// The mass of the block where it has no record of its own.
    pub mass: f64,
    /// True if there is friction.
    pub rubs: bool,
}

pub(super) struct Member<'a> {
    pub id: &'a str,
    pub title: &'a str,
    pub is_piston: bool,
    pub mass: f64,
    pub inertia: f64,
    pub centre: [f64; 2],
    pub colour: &'a str,
    pub joints: Vec<&'a str>,
    /// The links that are welded together to it.
    pub parts: Vec<&'a str>,
}

/// A force: an arrow between two places of a link.
pub(super) struct Arrow<'a> {
    pub id: &'a str,
    pub link: &'a str,
    pub ends: [[f64; 2]; 2],
    pub magnitude: f64,
    /// True if it turns with the link.
    pub turns: bool,
    /// True if it pulls along the arrow from the first place, instead of pushing on it.
    pub is_outward: bool,
}
