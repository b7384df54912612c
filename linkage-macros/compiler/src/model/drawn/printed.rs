//! The declaration of the groups as text, for the documentation of the solver.

use syn::Attribute;

use crate::syntax::tree::Declaration;

use crate::model::drawn::written::{Sought, Stretch};
use crate::model::statements::rules;

/// The declaration of the groups that were found in the drawing, as documentation of the struct.
pub(super) fn documentation(tree: &Declaration, searches: &[Sought]) -> Vec<Attribute> {
    let mut lines = vec![
        String::new(),
        " # Groups found in the drawing".to_string(),
        String::new(),
        " The links and joints of the drawing are these drivers and groups:".to_string(),
        String::new(),
        " ```text".to_string(),
        " mechanism! {".to_string(),
        format!("     pub struct {} {{", tree.name),
    ];
    let statements = tree.statements.iter();
    lines.extend(statements.map(|statement| format!("         {}", rules(statement).written())));
    lines.extend(["     }", " }", " ```"].map(String::from));
    for Sought { unknown, traced, stretches } in searches {
        let goes = stretches.iter().map(goes).collect::<Vec<_>>().join(", and while ");
        let alone = if stretches.len() > 1 { ", the others as drawn" } else { "" };
        lines.push(String::new());
        lines.push(match traced {
            None => format!(
                " `{unknown}` is searched in one interval: it was followed while {goes} about the drawing{alone}."
            ),
            Some(traced) => format!(
                " `{unknown}` is searched beside `{traced}`, which is the motion of the drawing to \
                 within a third of the interval while {goes} about the drawing."
            ),
        });
    }
    lines.iter().map(|line| syn::parse_quote!(#[doc = #line])).collect()
}

fn goes(Stretch { input, ends, is_angle }: &Stretch) -> String {
    let [from, to] = match is_angle {
        true => ends.map(|end| format!("{:.1}°", end.to_degrees() + 0.0)),
        false => ends.map(|end| format!("{:.3} m", end + 0.0)),
    };
    let who = input.as_ref().map_or("the first drive".to_string(), |input| format!("`{input}`"));
    format!("{who} goes from {from} to {to}")
}
