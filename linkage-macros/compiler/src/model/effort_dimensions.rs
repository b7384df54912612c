//! Dimensions of efforts.

use crate::model::acting::{Effort, Ends};
use crate::model::mechanism::{Dimension, Mechanism};

/// The dimension of an effort that is one number.
pub(crate) fn of_effort(mechanism: &Mechanism, effort: Effort) -> Dimension {
    let dynamics = &mechanism.dynamics;
    match effort {
        Effort::Input(id) => effort_along(mechanism.inputs[id.index()].dimension),
        Effort::Unknown(id) => effort_along(mechanism.unknowns[id.index()].dimension),
        Effort::Drive(link) => {
            let is_along = mechanism.is_driven_along(link);
            effort_along(if is_along { Dimension::LENGTH } else { Dimension::ANGLE })
        }
        Effort::Spring(id) => match dynamics.springs[id.index()].ends {
            Ends::Points(_) => Dimension::FORCE,
            Ends::Bodies(_) => Dimension::TORQUE,
        },
        Effort::Stop(id) => effort_along(dynamics.stops[id.index()].of.dimension()),
        Effort::Gap(id) => dynamics.stops[id.index()].of.dimension(),
        Effort::PinFriction(..) => Dimension::TORQUE,
        Effort::Losses => Dimension::POWER,
        Effort::Pull => dynamics.pull.as_ref().map_or(Dimension::NUMBER, |load| load.dimension),
        Effort::Formula(id) => dynamics.formulas[id.index()].dimension,
        Effort::Pin(..)
        | Effort::Bearing(..)
        | Effort::Guide(_)
        | Effort::Shaking
        | Effort::Push(_)
        | Effort::GuideFriction(_) => Dimension::FORCE,
    }
}

/// The dimension whose product with this is a work.
pub(crate) fn effort_along(dimension: Dimension) -> Dimension {
    Dimension::TORQUE.times(dimension, -1)
}
