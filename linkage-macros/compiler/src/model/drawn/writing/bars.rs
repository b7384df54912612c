//! The bars of dyads: links, and pairs of links that a drive holds together.

use proc_macro2::Ident;

use crate::model::figures::Figure;

/// The bar of a dyad.
pub(in crate::model::drawn) struct DrawnBar {
    pub name: Ident,
    pub length: Figure,
    pub pins: [usize; 2],
    pub links: LinksOfBar,
}

/// The link that is a bar, or those that it stands for.
pub(in crate::model::drawn) enum LinksOfBar {
    One(usize),
    /// The first goes from its own pin to the pivot, the second from there.
    Held {
        links: [usize; 2],
        pivot: usize,
        /// The pivot in the bar's frame.
        place: [Figure; 2],
    },
}
