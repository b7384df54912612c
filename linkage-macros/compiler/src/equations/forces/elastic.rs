//! Springs and stops: what acts between points or bodies by how far they are apart, and stores energy.
//!
//! Each of them has a file, and a row in [`EVERY`]. What asks for all that acts knows none by itself.

pub mod springs;
pub mod stops;

use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::{Sym, Vector};
use crate::model::mechanism::{Carrier, PointId};

/// One kind of them.
pub(super) struct ElasticLaw {
    /// The forces on points, in ground axes.
    pub forces: for<'s> fn(&Kinematics<'s>) -> Vec<(PointId, Vector<'s>)>,
    /// The couples on bodies.
    pub couples: for<'s> fn(&Kinematics<'s>) -> Vec<(Carrier, Sym<'s>)>,
    /// The energy that all of this kind store.
    pub energy: for<'s> fn(&Kinematics<'s>) -> Sym<'s>,
}

/// Every kind.
pub(super) const EVERY: [ElasticLaw; 2] = [
    ElasticLaw { forces: springs::forces, couples: springs::couples, energy: springs::energy },
    ElasticLaw { forces: stops::forces, couples: stops::couples, energy: stops::energy },
];
