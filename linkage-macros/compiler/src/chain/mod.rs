//! A mechanism as it is drawn, cut into drivers and Assur groups.
//!
//! [`cut`] takes bodies, the joints between them and what is driven, with one pose in which all of
//! it is drawn, and returns the groups in solving order. [`count`] finds them by counting freedoms:
//! every constraint is held by a body or a pin that it leaves one freedom less, and bodies that
//! hold each other's constraints in a circle are one group. [`cutting`] makes drivers and dyads of
//! them, [`carried`] dyads with links of given angle between their bars. A group of class III is solved by one unknown: [`options`] lists what can be left out and what
//! be driven, [`trace`] follows the machine, [`following`] fits intervals to it, bent where [`near_dead`] finds dead points
//! beside it, and [`choice`] chooses. One that no single unknown solves is [`tracked`] by all its angles at once. [`assemblies`] lists all ways to assemble such a group where it is
//! drawn. [`pose`]
//! computes poses, [`redrawn`] one with other lengths, and [`limits`] says how far each group is from its limit.
//!
//! Only numbers in `f64` and indices stand here: no names, no tokens, no exact constants and no
//! messages. A result decides which groups there are and on which side they assemble, and no
//! dimension of them.

pub mod assemblies;
pub mod assembly_list;
mod carried;
pub mod choice;
pub mod count;
pub mod curve;
pub mod cutting;
pub mod fit;
pub mod following;
mod known_parts;
pub mod limits;
pub mod machine;
pub mod near_dead;
pub mod options;
pub mod plane;
pub mod pose;
pub mod redrawn;
pub mod trace;
pub(crate) mod tracked;

use assembly_list::OtherAssembly;
use choice::Unchosen;
use cutting::{Found, SearchedGroup};
use machine::Machine;
use tracked::Untracked;

/// The reasons why a machine cannot be divided into groups. Bodies and drives by their indices.
#[derive(Clone, Debug, PartialEq)]
pub enum Trouble {
    /// The bodies have more constraints than freedoms, whatever the drawing is.
    TooMany {
        bodies: Vec<usize>,
        /// The drives among these constraints.
        drives: Vec<usize>,
        /// The freedoms that the bodies have against each other without these drives.
        freedoms: usize,
    },
    /// The bodies still move when every drive is held.
    Loose { bodies: Vec<usize>, freedoms: usize },
    /// The bodies are one group, which is no driver and no dyad, and which no unknown solves.
    Undecided { bodies: Vec<usize> },
    /// The bodies are one group that all its unknowns solve at once, and something has mass or acts.
    Loaded { bodies: Vec<usize> },
    /// The bodies are one group, and two ways to assemble it come together where it is drawn.
    AtDeadPoint { bodies: Vec<usize> },
    /// The bodies are one group, of which every way to solve it has a dyad at its limit where it is drawn: of
    /// one of these ways, the first links of the dyad's legs.
    AtLimits { bodies: Vec<usize>, dyad: [usize; 2] },
    /// The bodies are one group, and every interval of an unknown that holds the drawing holds another
    /// way to assemble it as well: the nearest, where all ways are known.
    NotAlone { bodies: Vec<usize>, other: Option<OtherAssembly> },
}

/// The groups of a machine in solving order, or all that keeps it from being cut.
pub fn cut(machine: &Machine) -> Result<Vec<Found>, Vec<Trouble>> {
    let troubles = count::troubles(machine);
    if !troubles.is_empty() {
        return Err(troubles);
    }
    let mut steps = Vec::new();
    let mut known = cutting::Placed::at_first(machine);
    for group in count::groups(machine) {
        match cutting::steps(machine, &known, &group) {
            Some(found) => steps.extend(found),
            None => {
                // Nothing is followed behind such a group.
                if steps.iter().any(|step| matches!(step, Found::Tracked(_))) {
                    return Err(vec![Trouble::Undecided { bodies: group }]);
                }
                let options = options::options(machine, &known, &group);
                if options.is_empty() {
                    let found = tracked::tracked(machine, &steps, &known, &group);
                    let found = found.map_err(|cause| vec![untracked(cause, &group)])?;
                    steps.push(Found::Tracked(Box::new(found)));
                    known.add(machine, &group);
                    continue;
                }
                let search = alone(machine, &steps, &group, options);
                steps.push(Found::Search(Box::new(search.map_err(|trouble| vec![trouble])?)));
            }
        }
        known.add(machine, &group);
    }
    Ok(steps)
}

/// The way to solve a group whose interval holds no other assembly of the drawing's modes and trend where it is drawn.
fn alone(
    machine: &Machine,
    before: &[Found],
    group: &[usize],
    mut options: Vec<SearchedGroup>,
) -> Result<SearchedGroup, Trouble> {
    let mut first_other = None;
    loop {
        let chosen = choice::chosen(machine, before, options.clone());
        let mut search = chosen.map_err(|cause| match first_other {
            Some(other) => Trouble::NotAlone { bodies: group.to_vec(), other: Some(other) },
            None => not_chosen(cause, machine, group, &options),
        })?;
        search.assemblies = assemblies::assemblies(machine, &search);
        let Some(other) = search.other_in_its_interval() else {
            if search.assemblies.as_ref().is_some_and(|list| !list.is_proved()) {
                search.assemblies = assemblies::by_another(machine, &options).or(search.assemblies);
            }
            return Ok(search);
        };
        first_other.get_or_insert(other);
        options.retain(|option| !option.is_the_way_of(&search));
    }
}

fn untracked(cause: Untracked, bodies: &[usize]) -> Trouble {
    let bodies = bodies.to_vec();
    match cause {
        Untracked::Other => Trouble::Undecided { bodies },
        Untracked::Loaded => Trouble::Loaded { bodies },
        Untracked::DeadPoint => Trouble::AtDeadPoint { bodies },
    }
}

pub fn not_chosen(
    cause: Unchosen,
    machine: &Machine,
    bodies: &[usize],
    options: &[SearchedGroup],
) -> Trouble {
    let bodies = bodies.to_vec();
    match cause {
        Unchosen::DeadPoint => Trouble::AtDeadPoint { bodies },
        Unchosen::DyadsAtLimits(dyad) => Trouble::AtLimits { bodies, dyad },
        Unchosen::NoInterval => {
            Trouble::NotAlone { bodies, other: assemblies::nearest_other(machine, options) }
        }
    }
}
