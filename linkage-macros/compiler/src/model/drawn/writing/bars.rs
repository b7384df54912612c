//! The bars of dyads: links, and pairs of links that a drive holds together.

use proc_macro2::Ident;

use crate::syntax::tree::Expr;

/// The bar of a dyad: a link, or what stands for two.
pub(in crate::model::drawn) enum DrawnBar {
    Link { body: usize, pins: [usize; 2], length: Expr },
    Held(Box<HeldBar>),
}

impl DrawnBar {
    pub(in crate::model::drawn) fn length(&self) -> Expr {
        match self {
            Self::Link { length, .. } => length.clone(),
            Self::Held(bar) => bar.length.clone(),
        }
    }
}

/// A bar that stands for two links, the first from its own pin to the pivot, the second from there.
pub(in crate::model::drawn) struct HeldBar {
    pub name: Ident,
    pub length: Expr,
    pub links: [usize; 2],
    /// The pins at both ends, and the pivot between the links.
    pub pins: [usize; 2],
    pub pivot: usize,
    /// The pivot in the bar's frame.
    pub place: [Expr; 2],
}
