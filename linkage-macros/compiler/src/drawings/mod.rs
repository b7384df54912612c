//! Machines as links and joints: the groups that are found, and the poses of what is generated.
//!
//! The groups are those that another program found in the same machines. Poses are judged by the drawing
//! and by the bodies alone, in a hundred digits: at the drawn inputs every pin is where it is drawn,
//! and beside them every body keeps the distances of its pins and the side on which each lies.

mod answers;
mod as_drawn;
mod carried_links;
mod certified_reach;
mod certified_refusals;
mod certified_variants;
mod chains_of_eight;
mod declared_by_hand;
mod declared_points;
mod drawn_inputs;
mod drawn_parallelograms;
mod eight_bars;
mod files;
mod following;
mod found_groups;
mod freely_placed;
mod full_turns;
mod guides_through_pins;
mod held_plates;
mod hidden_names;
mod interval_ends;
pub(crate) mod lorry;
mod machine;
mod named_expressions;
mod parts_of_the_ground;
mod poses;
mod random;
mod scales;
mod several_inputs;
mod textbook;
mod touched_limits;
mod tracked;
mod turned_round;
mod two_drives;
mod variants;
mod whole_turns;

/// A machine of the text files beside this.
struct Case {
    name: &'static str,
    statements: &'static str,
    expected: Vec<&'static str>,
}

fn cases() -> Vec<Case> {
    let texts = [include_str!("classical.txt"), include_str!("eight_bars.txt")];
    let blocks = texts.into_iter().flat_map(|text| text.split("\n# ").skip(1));
    let case = |block: &'static str| {
        let (name, rest) = block.split_once('\n').expect("a machine has a name");
        let (statements, expected) = rest.split_once("=> ").expect("groups are expected");
        let expected = expected.trim().split("; ").collect();
        Case { name, statements, expected }
    };
    blocks.map(case).collect()
}

impl Case {
    fn declaration(&self) -> String {
        format!("pub struct M {{ {} }}", self.statements)
    }
}
