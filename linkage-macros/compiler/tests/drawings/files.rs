//! Everything that is asked of each machine of the text files, which is resolved once for all questions: a motion of
//! class III that is followed takes most of the time.

use super::machine::machine;
use super::{cases, following, poses, textbook};

/// The counts of machines of dyads, of those that search, of poses in single precision, and of machines that follow
/// their drawing along a stretch.
#[derive(Debug, Default, PartialEq, Eq)]
struct Counts {
    dyads: usize,
    searched: usize,
    poses: usize,
    following: usize,
}

/// Every machine of dyads, and every nth that searches: its groups and its documentation. The poses of all dyads, and of
/// every third of the others.
fn asked(nth: usize) -> Counts {
    let mut counts = Counts::default();
    for case in cases() {
        if case.expected[0].starts_with("group") {
            counts.searched += 1;
            if counts.searched % nth != 0 {
                continue;
            }
        }
        let found = machine(&case.declaration());
        let mechanism = found.as_ref().map(|machine| &machine.mechanism);
        textbook::the_groups_are_those_expected(&case, mechanism);
        let Ok(machine) = found else { continue };
        textbook::the_documentation_compiles_as_it_stands(&machine.mechanism);
        let searches = !machine.mechanism.unknowns.is_empty();
        counts.dyads += usize::from(!searches);
        if searches && nth > 1 && counts.searched % (3 * nth) != 0 {
            continue;
        }
        let name = case.name;
        counts.poses += poses::single_precision_stands_where_it_is_drawn(name, &machine);
        poses::every_pin_is_where_it_is_drawn_and_every_body_stays_rigid(name, &machine);
        let follows = following::all_of_the_stretch_is_solved(name, &machine);
        counts.following += usize::from(follows);
    }
    println!("{counts:?}");
    assert_eq!([counts.dyads, counts.searched], [25, 22]);
    counts
}

/// Of machines that search, the groups of every second and the poses of every sixth; `.ci/nightly` asks all of them.
#[test]
fn machines_have_the_groups_and_poses_that_are_drawn() {
    let counts = asked(2);
    assert!(counts.poses > 250 && counts.following > 1, "{counts:?}");
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn all_machines_have_the_groups_and_poses_that_are_drawn() {
    let counts = asked(1);
    assert!(counts.poses > 440 && counts.following > 10, "{counts:?}");
}
