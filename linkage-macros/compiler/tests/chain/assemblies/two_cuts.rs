//! Triads by two cuts that share neither the driven bar nor the one that is left out.

use super::*;

/// The counts of machines by what two cuts say.
#[derive(Debug, Default)]
struct Compared {
    equal: usize,
    not_proved: usize,
    differing: usize,
    most_pieces: u32,
}

/// Compares two cuts of triads, whose places are multiples of a part of their size, or any.
fn compared(count: usize, grid: Option<f64>) -> Compared {
    let mut numbers = Numbers(11);
    let mut coordinate = move || match grid {
        Some(grid) => (numbers.next() * grid).floor() / grid,
        None => numbers.next(),
    };
    let mut compared = Compared::default();
    while compared.equal + compared.not_proved + compared.differing < count {
        let places = [(); 6].map(|()| [coordinate(), coordinate()]);
        let pairs = [(0, 3), (1, 4), (2, 5), (0, 1), (0, 2), (1, 2), (3, 4), (3, 5), (4, 5)];
        if pairs.iter().any(|&(a, b)| places[a] == places[b]) {
            continue;
        }
        let machine = triad(places);
        let lists = two_that_share_nothing(&machine).map(|search| {
            let (list, pieces) = counted_triad(&machine, &search);
            compared.most_pieces = compared.most_pieces.max(pieces);
            assert!(
                list.outcome != Outcome::Proved || list.list.len().is_multiple_of(2),
                "{places:?}"
            );
            list
        });
        match lists.each_ref().map(|list| list.outcome) {
            [Outcome::Proved, Outcome::Proved] if lists[0].list.len() == lists[1].list.len() => {
                compared.equal += 1;
            }
            [Outcome::Proved, Outcome::Proved] => {
                println!("{places:?}: {} and {}", lists[0].list.len(), lists[1].list.len());
                compared.differing += 1;
            }
            _ => compared.not_proved += 1,
        }
    }
    println!("{count} on {grid:?}: {compared:?}");
    compared
}

fn two_that_share_nothing(machine: &Machine) -> [SearchedGroup; 2] {
    let driven = |search: &SearchedGroup| search.steps[0].bodies();
    let all = cuts(machine);
    let first = &all[0];
    let is_other = |search: &&SearchedGroup| {
        search.left_out != first.left_out && driven(search) != driven(first)
    };
    let second = all.iter().find(is_other).expect("three bars are cut in six ways");
    [first.clone(), second.clone()]
}

/// A part of `a_hundred_thousand_triads`. Where two assemblies come together a list says so: one of a million by another
/// program.
#[test]
fn two_cuts_of_a_triad_have_one_count() {
    let Compared { not_proved, differing, most_pieces, .. } = compared(1500, None);
    assert_eq!((not_proved, differing), (0, 0));
    assert!(most_pieces < 400, "{most_pieces}");
}

/// Places on a grid have bars of equal lengths and points in line, so that some assemblies are double: the list says so.
#[test]
fn special_lengths_lose_no_assembly() {
    let Compared { equal, differing, .. } = compared(1500, Some(10.0));
    assert_eq!(differing, 0);
    assert!(equal > 1200, "{equal}");
}

/// A dyad of equal bars has a base without length in one pose. The interval of the unknown that another program took ended there
/// by a rounding of an arc cosine, and two of the four assemblies were lost.
#[test]
fn a_base_without_length_hides_no_assembly() {
    let machine = triad([[0.4, 0.7], [0.5, 0.3], [0.3, 0.4], [0.7, 0.1], [0.1, 0.4], [0.7, 0.2]]);
    let counts = counts(&machine);
    assert!(counts.iter().filter(|(_, outcome)| *outcome == Outcome::Proved).count() > 1);
    for (count, outcome) in counts {
        assert!(outcome != Outcome::Proved || count == 4, "{count}");
    }
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn a_hundred_thousand_triads() {
    let Compared { not_proved, differing, most_pieces, .. } = compared(100_000, None);
    // Thirteen have two assemblies that are too near to each other for what is enclosed of one of the cuts.
    assert!(not_proved <= 20 && differing == 0, "{not_proved} not proved, {differing} differ");
    assert!(most_pieces < BUDGET.pieces / 4, "{most_pieces}");
    assert_eq!(compared(100_000, Some(10.0)).differing, 0);
}
