//! Ends of intervals beside the assemblies that a search there could mistake for the drawing's.

use std::f64::consts::TAU;

use super::chains_of_eight::{all, drawing};
use super::eight_bars::kinematic;
use super::variants::Random;
use crate::chain::cut;
use crate::chain::cutting::{Found, SearchedGroup};

/// By end, the share of the way to the next assembly with the drawing's sides and trend; zero where there is none. `None`
/// where not all assemblies are proved.
fn shares(search: &SearchedGroup) -> Option<[f64; 2]> {
    let list = search.assemblies.as_ref().filter(|list| list.is_proved() && !list.is_by_another)?;
    let drawn = list.list[list.drawn?];
    let like = list.list.iter().filter(|other| {
        (other.sides, other.rises) == (drawn.sides, drawn.rises) && **other != drawn
    });
    let turns: Vec<_> = like.map(|other| (other.unknown - drawn.unknown).rem_euclid(TAU)).collect();
    let from = search.following.as_ref().map_or(0.0, |following| following.at(0.0));
    let [low, high] = search.between.map(|end| from + end);
    let above = turns.iter().map(|turn| high / turn).fold(0.0, f64::max);
    let below = turns.iter().map(|turn| -low / (TAU - turn)).fold(0.0, f64::max);
    Some([below, above])
}

/// The shares of all ends that have such an assembly, over every nth eight-bar that is driven at the ground.
fn ends(nth: usize, drawings: usize) -> Vec<f64> {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut groups, mut ends) = (0, Vec::new());
    let driven: Vec<_> = all().iter().filter(|driven| driven.is_at_the_ground()).collect();
    for driven in driven.into_iter().step_by(nth) {
        for _ in 0..drawings {
            let machine = kinematic(driven, &drawing(&mut random));
            for step in cut(&machine).into_iter().flatten() {
                let Found::Search(search) = step else { continue };
                let shares = shares(&search).expect("pins alone are proved");
                groups += 1;
                ends.extend(shares.into_iter().filter(|share| *share != 0.0));
            }
        }
    }
    ends.sort_by(f64::total_cmp);
    println!("{groups} groups; of {} ends {:?} of the way at most", ends.len(), ends.last());
    ends
}

/// An interval is as wide as its motion needs, and less than half of the way to the next assembly that is like the drawing's: the
/// search there finds the drawing's root. Half of the way would be hundreds of times as wide in the median, and a search
/// takes evaluations by its width.
#[test]
fn some_intervals_end_before_the_next_assembly() {
    let ends = ends(7, 4);
    assert!(ends.len() >= 6 && ends[ends.len() - 1] < 0.5, "{ends:?}");
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn intervals_end_before_the_next_assembly() {
    let ends = ends(1, 8);
    assert!(ends.len() > 300 && ends[ends.len() - 1] < 0.5, "{ends:?}");
    assert!(ends[ends.len() / 2] < 0.01, "{}", ends[ends.len() / 2]);
}
