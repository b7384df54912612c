//! Notes about the other ways to assemble a group of class III where it is drawn.

use crate::chain::assembly_list::Assemblies;
use crate::chain::cutting::{Found, SearchedGroup};
use crate::diagnostics::Diagnostics;

use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::lengths::to_four_digits;

/// Notes how many assemblies each group of class III has where it is drawn, if that is proved.
pub(in crate::model::drawn) fn note_assemblies(
    bodies: &Bodies<'_>,
    steps: &[Found],
    diagnostics: &mut Diagnostics,
) {
    for step in steps {
        let Found::Search(search) = step else { continue };
        let Some(list) = search.assemblies.as_ref().filter(|list| list.is_proved()) else {
            continue;
        };
        note(bodies, search, list, diagnostics);
    }
}

fn note(
    bodies: &Bodies<'_>,
    search: &SearchedGroup,
    list: &Assemblies,
    diagnostics: &mut Diagnostics,
) {
    let those = search.bodies();
    let Some(link) = bodies.last_link(&those) else { return };
    let message = format!(
        "{} can be assembled in {} ways where they are drawn, of at most {}",
        bodies.listed(&those),
        list.list.len(),
        list.at_most
    );
    let nearest = match (list.nearest_other(), &search.steps[0]) {
        (Some(nearest), Found::Crank { body, .. }) => {
            let (name, turned) = (bodies.name(*body), angle_in_words(nearest));
            format!("; in the nearest other {name} is turned by {turned} from there")
        }
        _ => String::new(),
    };
    let reason = format!("the drawing's is searched{nearest}");
    diagnostics.note_because(link.span(), message, reason);
}

/// An angle to four digits.
pub(in crate::model::drawn) fn angle_in_words(radians: f64) -> String {
    format!("{}°", to_four_digits(radians.to_degrees()))
}
