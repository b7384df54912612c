//! Where the places of points are written, for an editor that moves them: read from the tree alone, so that a text with
//! mistakes has them too.

use std::ops::Range;

use proc_macro2::{Ident, TokenStream};

use crate::diagnostics::Diagnostics;
use crate::syntax;
use crate::syntax::tree::{Expr, PointPlace, StatementKind};

/// A place that is written in a declaration.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct WrittenPlace {
    /// The point's name.
    pub name: String,
    /// The link whose frame its numbers are in; none for those of the drawing.
    pub on: Option<String>,
    /// The bytes of x and y in the source.
    pub numbers: [Range<usize>; 2],
}

/// The places that a declaration writes as two numbers each: those of `ground` and `pin`, and of points `at (x, y)`.
///
/// ```
/// let source = "pub struct Crank { input t: angle; ground A(2m, 0); crank AB(A) -> B { length: 2, angle: t } }";
/// let places = linkage_compiler::places(source.parse().expect("these are tokens"));
/// assert_eq!(places[0].name, "A");
/// assert_eq!(&source[places[0].numbers[0].clone()], "2m");
/// ```
pub fn places(source: TokenStream) -> Vec<WrittenPlace> {
    let mut diagnostics = Diagnostics::new();
    let declaration = syntax::parse(source, &mut diagnostics);
    // Mistakes are told by whoever compiles the text.
    drop(diagnostics.finish());
    let mut places = Vec::new();
    for statement in declaration.iter().flat_map(|declaration| &declaration.statements) {
        match &statement.kind {
            StatementKind::Ground(ground) => {
                places.extend(ground.points.iter().map(|(name, at)| place(name, None, at)));
            }
            StatementKind::Pin(pin) => {
                places.extend(pin.points.iter().map(|(name, at)| place(name, None, at)));
            }
            StatementKind::Point(point) => {
                if let PointPlace::Cartesian(at) = &point.place {
                    places.push(place(&point.name, point.on.as_ref(), at));
                }
            }
            _ => {}
        }
    }
    places
}

fn place(name: &Ident, on: Option<&Ident>, at: &[Expr; 2]) -> WrittenPlace {
    let numbers = [0, 1].map(|axis| at[axis].span.bytes());
    WrittenPlace { name: name.to_string(), on: on.map(Ident::to_string), numbers }
}
