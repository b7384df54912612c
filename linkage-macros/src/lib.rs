//! `linkage-core`'s `mechanism!`; the compiler is `linkage-compiler`. Users depend on `linkage-core`.

use linkage_compiler::Options;
use proc_macro::TokenStream;

/// Declares a planar mechanism and generates its solver.
///
/// ```text
/// mechanism! {
///     /// Strip-mill flying shear, as it is drawn.
///     pub struct FlyingShear {
///         input theta: angle;
///         ground A(0, 0), D(665.7mm, 0);
///         pin  B(80mm, 0), C(600mm, 360mm), blade(570mm, 90mm);
///         link AB(A, B), BC(B, C, blade), DC(D, C);
///         drive AB.angle = theta;
///     }
/// }
///
/// mechanism! {
///     /// The same kind of machine, cut into a driver and a dyad.
///     pub struct ByHand {
///         input theta: angle;
///         ground A(0, 0), D(665.7mm, 0);
///         crank AB(A) -> B        { length: 80mm, angle: theta }
///         rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
///         point blade on BC at (500mm, -60mm);
///     }
/// }
/// ```
///
/// A dyad has two links, two outer joints and one inner joint; its letters name them in order, and
/// so does its statement: `link(outer joint), link(outer joint) -> inner pin`. An R outer joint
/// takes a point, a P outer joint takes a guide, and an inner P joint makes no pin. The module
/// `linkage_core::reference` has every statement, what is generated, and machines to copy from.
///
/// Mistakes are reported at the tokens that made them, all of one declaration together.
///
/// The code relies on nothing of the module it stands in, and meets no name of the user's, as long
/// as none in scope ends in an underscore: such names are the generated code's own.
/// `linkage export rust` prints all of it.
#[proc_macro]
pub fn mechanism(source: TokenStream) -> TokenStream {
    let mut options = Options::default();
    options.sketch = cfg!(feature = "sketch");
    options.page = cfg!(feature = "page");
    options.serde = cfg!(feature = "serde");
    linkage_compiler::compile(source.into(), &options).tokens.into()
}
