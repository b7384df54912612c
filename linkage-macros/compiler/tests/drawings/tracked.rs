//! Machines of which one group is solved by all its unknowns at once.

use super::chains_of_eight::{Driven, all, drawing};
use super::eight_bars::{class, kinematic};
use super::freely_placed::{Coordinates, Links};
use super::machine::{Machine, machine};
use super::variants::Random;

/// The public gripper that a cylinder drives, in millimetres.
pub(super) const GRIPPER: &str = "input s: length; ground A(-46.84mm, 7.47mm), K(0mm, 96.96mm), L(0.9mm, -73.71mm), O(65.19mm, 98.62mm), \
    P(66.82mm, -101.05mm); pin B(-0.81mm, 7.46mm), C(-17.01mm, 7.46mm), D(29.02mm, 7.45mm), G(43.11mm, 30.04mm), H(82.46mm, 30.04mm), \
    I(43.11mm, -10.11mm), J(82.46mm, -10.11mm), M(0.2mm, 59.03mm), Q(65.52mm, 57.86mm), S(148.51mm, 43.2mm), T(0.7mm, -35.73mm), \
    V(66.3mm, -37.16mm), X(148.51mm, -22.23mm); guide bore on AB through A towards B; guide left_bar through K towards L; \
    guide right_bar through O towards P; link AB(A, B), CD(C, D) on bore, plate(D, G, H, I, J); \
    link GM(G, M), HQ(H, Q), upper(M, Q, S), IT(I, T), JV(J, V), lower(T, V, X); \
    link block_M(M) on left_bar, block_Q(Q) on right_bar, block_T(T) on left_bar, block_V(V) on right_bar; \
    drive CD.slide = s;";

/// The way of the cylinder out of the drawing, and the places of S, X and D there, by Newton's method on numbers of another
/// program.
const RIGHT: [[f64; 7]; 4] = [
    [0.5, 148.739291, 39.324834, 148.397944, -26.407577, 29.147207, -0.066206],
    [1.0, 148.879788, 39.071359, 148.366003, -27.095933, 29.364394, -2.547499],
    [2.0, 149.165302, 57.78403, 148.629141, -11.615846, 30.952455, 10.712523],
    [4.0, 149.17747, 73.281595, 148.684102, 2.264195, 31.37037, 23.618006],
];

/// Half a unit of the last printed digit, and the rounding of the sum.
const PRINTED: f64 = 0.51e-9;

#[test]
fn a_gripper_is_where_another_program_has_it() {
    let machine = machine(&format!("pub struct M {{ {GRIPPER} }}")).expect("it is a machine");
    let drawn = machine.drawn_inputs()[0];
    for [out, right @ ..] in RIGHT {
        let at = [drawn + out * 1e-3];
        assert!(machine.is_certified(&at), "{out}");
        let pins = machine.pins::<f64>(&at);
        for (pin, right) in ["S", "X", "D"].into_iter().zip(right.chunks(2)) {
            let at = pins.iter().find(|(name, _)| name == pin).expect("it is an output").1;
            for (at, right) in at.iter().zip(right) {
                assert!((at - right * 1e-3).abs() < PRINTED, "{pin} at {out} mm: {at} for {right}");
            }
        }
    }
    // The cylinder is in by no more than 0.006 mm, and out by no more than the links are long.
    for beyond in [-0.01, 300.0] {
        assert!(!machine.is_certified(&[drawn + beyond * 1e-3]), "{beyond}");
    }
}

/// An eight-bar of the list with its index there.
#[derive(Clone)]
pub(super) struct EightBar {
    pub index: usize,
    pub driven: Driven,
    pub places: Vec<[f64; 2]>,
}

/// Those that no single unknown solves.
pub(super) fn of_several_unknowns() -> Vec<EightBar> {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let drawn = all().iter().enumerate().map(|(index, driven)| EightBar {
        index,
        driven: driven.clone(),
        places: drawing(&mut random),
    });
    drawn.filter(|bar| !class(&kinematic(&bar.driven, &bar.places)).1).collect()
}

/// The one of them that is driven at the ground.
pub(super) const AT_THE_GROUND: usize = 115;

/// Rounding of some units in the last place over the smallest slope of a root that is certified.
const OFF: f64 = 1e-12;
/// Two ways to assemble a group that are certified are farther apart than this.
const SAME: f64 = 1e-7;

/// Every sixth of them, that at the ground among these; `.ci/nightly` takes all.
#[test]
fn eight_bars_of_several_unknowns_are_right_as_far_as_they_move() {
    let all = of_several_unknowns();
    let at_the_ground = all.iter().position(|bar| bar.index == AT_THE_GROUND).expect("it is one");
    are_right(&all, |nth| nth % 6 == at_the_ground % 6);
}

#[test]
#[ignore = "ten seconds: `.ci/nightly` takes it"]
fn all_eight_bars_of_several_unknowns_are_right_as_far_as_they_move() {
    are_right(&of_several_unknowns(), |_| true);
}

fn are_right(all: &[EightBar], is_chosen: impl Fn(usize) -> bool) {
    assert_eq!(all.len(), 33);
    for (_, bar) in all.iter().enumerate().filter(|(nth, _)| is_chosen(*nth)) {
        let found = machine(&format!("pub struct M {{ {} }}", bar.driven.statements(&bar.places)));
        let machine = found.unwrap_or_else(|told| panic!("{}: {told:?}", bar.index));
        assert_eq!(bar.driven.is_at_the_ground(), bar.index == AT_THE_GROUND);
        is_right(bar, &machine);
    }
}

/// At its drawing and ten poses beside it every link is as rigid as drawn. Of a hundred poses along its motion more than 95
/// are certified, and these are the motion's; so are all that are certified at random drives.
fn is_right(bar: &EightBar, machine: &Machine) {
    let EightBar { index, driven, places } = bar;
    let links = Links::of(driven, places);
    let mut poses = links.followed(-0.01);
    poses.reverse();
    poses.extend(links.followed(0.01).into_iter().skip(1));
    let drawn = machine.drawn_inputs()[0];
    let (first, last) = (poses[0].0, poses[poses.len() - 1].0);
    for part in 0..=10 {
        let share = f64::from(part - 5) / 100.0;
        let beside = share * if share < 0.0 { -first } else { last };
        assert!(machine.is_certified(&[drawn + beside]), "{index} at {beside}");
        assert!(machine.rigid(&[drawn + beside], OFF).is_some(), "{index} at {beside}");
    }
    let mut certified = 0;
    for part in 0..=100 {
        let drive = first + (last - first) * f64::from(part) / 100.0;
        certified += usize::from(is_the_motions(bar, machine, (&links, &poses), drive));
    }
    println!("{index}: {certified} of 101 poses from {first} to {last}");
    assert!(certified > 95, "{index}: {certified}");
    let mut random = Random(0x1234_5678_9abc_def1 + *index as u64);
    for _ in 0..100 {
        let drive = random.below(40_000) as f64 / 1000.0 - 20.0;
        is_the_motions(bar, machine, (&links, &poses), drive);
    }
}

/// True if the pose at a drive from the drawing is certified; it is one of the motion then.
fn is_the_motions(
    EightBar { index, driven, .. }: &EightBar,
    machine: &Machine,
    (links, poses): (&Links<'_>, &[(f64, Coordinates)]),
    drive: f64,
) -> bool {
    let drawn = machine.drawn_inputs()[0];
    if !machine.is_certified(&[drawn + drive]) {
        return false;
    }
    // Half a turn ahead is where it was followed to, not half a turn back.
    let turns = (drive / std::f64::consts::TAU - 1e-9).round();
    let within = drive - turns * std::f64::consts::TAU;
    let away = |pose: &&(f64, Coordinates)| (pose.0 - within).abs();
    let nearest = poses.iter().min_by(|a, b| away(a).total_cmp(&away(b))).expect("the drawing");
    let at = links.beside(within, &nearest.1);
    let at = at.unwrap_or_else(|| panic!("{index} is certified at {drive}, where nothing is"));
    let pins = machine.pins::<f64>(&[drawn + drive]);
    for (joint, &[a, b]) in driven.joints.iter().enumerate() {
        let name = format!("P{a}{b}");
        let found = pins.iter().find(|(pin, _)| *pin == name).expect("every pin is an output").1;
        let right = links.place(a, joint, &at);
        let off = (found[0] - right[0]).hypot(found[1] - right[1]);
        assert!(off < SAME, "{index} at {drive}: {name} is off by {off:e}");
    }
    true
}
