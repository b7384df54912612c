//! Machines as links and joints: the groups that are found, and the poses of what is generated.
//!
//! The groups are those that another program found in the same machines. Poses are judged by the drawing
//! and by the bodies alone, in a hundred digits: at the drawn inputs every pin is where it is drawn,
//! and beside them every body keeps the distances of its pins and the side on which each lies.

pub(crate) mod answers;
pub(crate) mod as_drawn;
pub(crate) mod carried_links;
pub(crate) mod certified_reach;
pub(crate) mod certified_refusals;
pub(crate) mod certified_variants;
pub(crate) mod chains_of_eight;
pub(crate) mod declared_by_hand;
pub(crate) mod declared_points;
pub(crate) mod drawn_inputs;
pub(crate) mod drawn_parallelograms;
pub(crate) mod eight_bars;
pub(crate) mod files;
pub(crate) mod following;
pub(crate) mod found_groups;
pub(crate) mod freely_placed;
pub(crate) mod full_turns;
pub(crate) mod guides_through_pins;
pub(crate) mod held_plates;
pub(crate) mod hidden_names;
pub(crate) mod interval_ends;
pub(crate) mod lorry;
pub(crate) mod machine;
pub(crate) mod named_expressions;
pub(crate) mod parts_of_the_ground;
pub(crate) mod poses;
pub(crate) mod random;
pub(crate) mod scales;
pub(crate) mod several_inputs;
pub(crate) mod textbook;
pub(crate) mod touched_limits;
pub(crate) mod tracked;
pub(crate) mod turned_round;
pub(crate) mod two_drives;
pub(crate) mod variants;
pub(crate) mod whole_turns;

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
