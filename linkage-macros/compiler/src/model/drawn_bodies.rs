//! A drawing as bodies: through which pins they go and where they stand, in the pose with the declared lengths.

use proc_macro2::Ident;

/// The bodies of a drawing, in ground axes.
#[derive(Clone)]
pub struct Outline {
    pub ground: Vec<(Ident, [f64; 2])>,
    pub bodies: Vec<OutlinedBody>,
    pub guides: Vec<OutlinedGuide>,
}

/// A link that is written.
#[derive(Clone)]
pub struct OutlinedBody {
    pub name: Ident,
    pub pins: Vec<(Ident, [f64; 2])>,
    /// The guides on which it slides, by their places in the list.
    pub on: Vec<usize>,
    /// The frame that its statement gives it.
    pub origin: [f64; 2],
    pub angle: f64,
    /// The input that is its length, of a cylinder.
    pub length: Option<Ident>,
}

/// A guide, and the body that carries it by its place in the list: the ground where there is none.
#[derive(Clone)]
pub struct OutlinedGuide {
    pub name: Ident,
    pub on: Option<usize>,
    pub through: [f64; 2],
    pub along: f64,
}
