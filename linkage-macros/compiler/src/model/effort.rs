//! Efforts and reactions that may be asked for.

use super::ids::{FormulaId, InputId, LinkId, PointId, SpringId, StopId, UnknownId};

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Effort {
    /// The effort of an input: power put in over its rate.
    Input(InputId),
    /// The load that drives an input.
    Pull,
    /// The effort of an input over the rate of an unknown, where that is driven in place of the only input.
    Unknown(UnknownId),
    /// The effort that drives a crank or a slider.
    Drive(LinkId),
    /// The force that pushes the ends of a driven length apart.
    Push(LinkId),
    /// The force on the link by the pin.
    Pin(LinkId, PointId),
    /// The sum of the forces on the link by the links that stand on a point of its own.
    Bearing(LinkId, PointId),
    /// Normal force and couple on the link by the guide it slides on.
    Guide(LinkId),
    /// The effort of a spring on its ends: positive pushes them apart, or turns the second body
    /// forwards.
    Spring(SpringId),
    /// What a stop exerts: positive makes what it stops larger.
    Stop(StopId),
    /// The way to the nearer end of a stop, negative beyond it.
    Gap(StopId),
    /// The shaking force and moment: the load of inertia on the ground, taken as one body. The moment
    /// is about the origin.
    Shaking,
    /// The power that friction takes.
    Losses,
    /// The couple of friction on the link by all that rub on it at the pin.
    PinFriction(LinkId, PointId),
    /// The force of friction on the link along what it slides on.
    GuideFriction(LinkId),
    /// The value of a formula.
    Formula(FormulaId),
}

impl Effort {
    /// True if it belongs to the whole mechanism, and has no owner.
    pub(crate) fn is_of_the_whole(self) -> bool {
        matches!(self, Self::Pull | Self::Shaking | Self::Losses | Self::Formula(_))
    }
}
