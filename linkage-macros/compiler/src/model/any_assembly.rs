//! The machine of any assembly: the sides of its dyads and the place of its unknown are parameters.

use proc_macro2::{Ident, Span};
use syn::{Attribute, parse_quote};

use crate::diagnostics::Diagnostics;
use crate::exact::Exact;
use crate::syntax::anatomy::Modes;

use super::mechanism::{
    Assembly, Dimension, Equation, Mechanism, Mode, Operator, Param, ParamId, ParamKind, Scalar,
    Sign, Step,
};

/// A machine whose first unknown is near a parameter.
pub(crate) struct AnyAssembly {
    pub mechanism: Mechanism,
    /// The unknown.
    pub near: ParamId,
    /// Half the width of the interval about it.
    pub room: ParamId,
    pub trend: ParamId,
    /// True if the distance is on the left of its equation.
    pub is_left: bool,
    /// By dyad, the parameter of its side.
    pub sides: Vec<ParamId>,
}

/// The machine of any assembly, from a mechanism whose assemblies can be listed.
pub(crate) fn any_assembly(mut mechanism: Mechanism) -> AnyAssembly {
    let (unknown, [first, last]) = (&mechanism.unknowns[0], mechanism.unknowns[0].steps);
    let (name, span) = (unknown.name.to_string(), mechanism.name.span());
    let is_left = matches!(unknown.equation, Equation::Distance { is_left: true, .. });
    let title = format!("{}Assembly", mechanism.name);
    mechanism.docs = docs(&format!(" The solver of one assembly of [`{}`].", mechanism.name));
    mechanism.name = Ident::new(&title, span);
    (mechanism.export_c, mechanism.export_assemblies) = (false, None);
    // They tell of the interval about the drawing.
    mechanism.as_drawn.searches.clear();
    let angle = |default: Exact| ParamKind::Number {
        dimension: Dimension::ANGLE,
        default,
        written_in: None,
    };
    let mode = |of: Modes| ParamKind::Mode { of, default: Sign::Plus };
    let near = put(&mut mechanism, (&name, "near"), " The unknown.", angle(Exact::integer(0)));
    let room_docs = " Half the width of the interval about it.";
    let room = put(&mut mechanism, (&name, "room"), room_docs, angle(Exact::integer(1)));
    let trend_docs = " The trend of its equation.";
    let trend = put(&mut mechanism, (&name, "trend"), trend_docs, mode(Modes::Trend));
    let mut sides = Vec::new();
    for index in first..last {
        let Step::Group(group) = &mechanism.steps[index] else { continue };
        if !group.is_of_bars() {
            continue;
        }
        let link = mechanism.links[group.links[0].index()].name.to_string();
        let side_docs = format!(" The side of the pin of `{link}`.");
        let side = put(&mut mechanism, (&link, "side"), &side_docs, mode(Modes::Side));
        sides.push(side);
        if let Step::Group(group) = &mut mechanism.steps[index] {
            group.assembly = Assembly::Signed(Mode::Param(side));
        }
    }
    let unknown = &mut mechanism.unknowns[0];
    unknown.mode = Mode::Param(trend);
    unknown.near = Some(Scalar::Param(near));
    unknown.between = [Operator::Sub, Operator::Add].map(|sign| {
        Scalar::Chain(Box::new(Scalar::Param(near)), vec![(sign, Scalar::Param(room))])
    });
    AnyAssembly { mechanism, near, room, trend, is_left, sides }
}

/// Why a machine's assemblies cannot be listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unlisted {
    /// There is no unknown.
    NoUnknown,
    /// The unknown is not added to the angle of a single crank about what stands still.
    NoCrank,
    /// A group behind the unknown is no pair of bars with a mode of its own.
    OtherGroup,
    /// The equation is no distance of two points.
    OtherEquation,
    /// A group hangs on a point that depends on the unknown by other means than a link.
    OtherPoint,
    /// The assemblies may be more than sixty.
    TooMany,
}

impl Unlisted {
    fn reason(self) -> &'static str {
        match self {
            Self::NoUnknown => {
                "nothing is searched here: each group has the assembly that its mode says"
            }
            Self::NoCrank => {
                "the unknown must be added to the angle of one crank, whose pivot stands still"
            }
            Self::OtherGroup => {
                "between `unknown` and `solve` only a crank and pairs of bars with a mode of their own may stand, four at most"
            }
            Self::OtherEquation => "its equation must be the `distance` of two points",
            Self::OtherPoint => {
                "a bar hangs on a point that moves with the unknown and is on no link"
            }
            Self::TooMany => "this group may have more than sixty assemblies",
        }
    }
}

/// Reports a list that was asked for and cannot be made.
pub(crate) fn assemblies_cannot_be_listed(
    word: &Ident,
    cause: Unlisted,
    diagnostics: &mut Diagnostics,
) {
    let message = "`export assemblies` needs a group of pins that one unknown solves";
    diagnostics.error_because(word.span(), message, cause.reason());
}

fn docs(line: &str) -> Vec<Attribute> {
    vec![parse_quote!(#[doc = #line])]
}

/// A parameter under a name that nothing has.
fn put(
    mechanism: &mut Mechanism,
    (of, what): (&str, &str),
    line: &str,
    kind: ParamKind,
) -> ParamId {
    let mut name = format!("{of}_{what}");
    let is_taken = |name: &String, mechanism: &Mechanism| {
        let params = mechanism.params.iter().map(|param| &param.name);
        let inputs = mechanism.inputs.iter().map(|input| &input.name);
        let outputs = mechanism.outputs.iter().map(|output| &output.field);
        let unknowns = mechanism.unknowns.iter().map(|unknown| &unknown.name);
        let links = mechanism.links.iter().map(|link| &link.name);
        let points = mechanism.points.iter().map(|point| &point.name);
        let all = params.chain(inputs).chain(outputs).chain(unknowns).chain(links).chain(points);
        all.into_iter().any(|other| *other == *name)
    };
    while is_taken(&name, mechanism) {
        name.push('_');
    }
    let name = Ident::new(&name, Span::call_site());
    mechanism.params.push(Param { name, docs: docs(line), kind });
    ParamId(mechanism.params.len() as u32 - 1)
}
