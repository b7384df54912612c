//! Drawn machines of class III along their motions.

use linkage_core::SolveError;
use linkage_core::assemblies::{Budget, Outcome};

linkage_core::mechanism! {
    /// Its crank turns fully, and its unknown is measured from a fit of it.
    pub struct Turning {
        input theta: angle;
        export assemblies;
        ground P01(0.705, 0.057), P04(0.975, 0.023);
        pin P15(0.75, 0.845), P24(0.018, 0.788), P25(0.366, 0.579), P34(0.009, 0.047), P35(0.181, 0.955);
        link L1(P01, P15), L2(P24, P25), L3(P34, P35), L4(P04, P24, P34), L5(P15, P25, P35);
        drive L1.angle = theta;
    }
}

include!("../../linkage-macros/command/tests/data/seven.rs");

/// The pins of links, by their numbers, in the order of the outputs' points.
type Links = &'static [&'static [usize]];

/// The most by which a link is longer or shorter in one pose than in another.
fn misfit(links: Links, [one, other]: [&[[f64; 2]]; 2]) -> f64 {
    let pairs = links
        .iter()
        .flat_map(|pins| pins.iter().flat_map(move |&a| pins.iter().map(move |&b| (a, b))));
    let distance = |pins: &[[f64; 2]], a: usize, b: usize| {
        (pins[a][0] - pins[b][0]).hypot(pins[a][1] - pins[b][1])
    };
    pairs.fold(0.0, |most, (a, b)| {
        f64::max(most, (distance(one, a, b) - distance(other, a, b)).abs())
    })
}

const TURNING: Links = &[&[5, 0], &[1, 2], &[3, 4], &[6, 1, 3], &[0, 2, 4]];

/// The pins of `Turning`, those of its ground last.
macro_rules! of_turning {
    ($pose:expr) => {{
        let p = $pose;
        let pins = [p.P15, p.P24, p.P25, p.P34, p.P35].map(|pin| [pin.x, pin.y]);
        let [a, b, c, d, e] = pins;
        [a, b, c, d, e, [0.705, 0.057], [0.975, 0.023]]
    }};
}

fn apart(one: &[[f64; 2]], other: &[[f64; 2]]) -> f64 {
    let pairs = one.iter().zip(other);
    pairs.fold(0.0, |most, (a, b)| f64::max(most, (a[0] - b[0]).hypot(a[1] - b[1])))
}

/// Roundings of a few operations on numbers up to two, times what a dyad near its limit grows them by.
const CLOSED: f64 = 1e-11;

/// Around a turn of the crank every list is proved, each of its poses is the machine's, no two are the same, and one of them is what
/// `position` answers.
#[test]
fn the_pose_is_in_its_list_all_around() -> Result<(), SolveError> {
    let machine = Turning::new();
    let [drawn] = Turning::DRAWN;
    let drawing = of_turning!(machine.position(drawn)?);
    let (mut most, mut counts) = (0, [0; 4]);
    for step in 0..180 {
        let theta = drawn + std::f64::consts::TAU * f64::from(step) / 180.0;
        let list = machine.assemblies(theta, Budget::default())?;
        assert_eq!(list.outcome, Outcome::Proved, "{theta}");
        assert!(list.len().is_multiple_of(2) && list.len() <= Turning::ASSEMBLIES);
        counts[list.len() / 2] += 1;
        most = most.max(list.samples);
        let own = of_turning!(machine.position(theta)?);
        let mut poses: Vec<[[f64; 2]; 7]> = Vec::new();
        for at in &list {
            let pose = of_turning!(machine.with(at).position(theta)?);
            let off = misfit(TURNING, [&pose, &drawing]);
            assert!(off < CLOSED, "{off:e} in {at:?} at {theta}");
            assert!(poses.iter().all(|other| apart(&pose, other) > 1e-6), "{at:?} at {theta}");
            poses.push(pose);
        }
        let same = poses.iter().filter(|pose| apart(*pose, &own) < CLOSED).count();
        assert_eq!(same, 1, "{theta}");
    }
    println!("{counts:?}, {most} samples at most");
    assert!(counts[0] == 0 && counts[1] < 180 && most < 5000, "{counts:?} {most}");
    Ok(())
}

const SEVEN: Links = &[&[9, 0], &[2, 3], &[0, 2, 4], &[4, 5, 6], &[1, 5, 7], &[3, 6, 8], &[7, 8]];

macro_rules! of_seven {
    ($pose:expr) => {{
        let p = $pose;
        [
            [p.P0.x, p.P0.y],
            [0.689, 0.524],
            [p.P2.x, p.P2.y],
            [p.P3.x, p.P3.y],
            [p.P4.x, p.P4.y],
            [p.P5.x, p.P5.y],
            [p.P6.x, p.P6.y],
            [p.P7.x, p.P7.y],
            [p.P8.x, p.P8.y],
            [0.05, 0.3],
        ]
    }};
}

/// Seven links have the count of assemblies that homotopy finds, all of which close, and the drawing is one. Beside the drawing the
/// count changes by pairs.
#[test]
fn seven_links_have_as_many_as_homotopy_counts() -> Result<(), SolveError> {
    let machine = Seven::new();
    let [drawn] = Seven::DRAWN;
    assert_eq!(Seven::ASSEMBLIES, 14);
    let drawing = of_seven!(machine.position(drawn)?);
    for step in -10..=10 {
        let t = drawn + 0.002 * f64::from(step);
        let list = machine.assemblies(t, Budget::default())?;
        assert_eq!(list.outcome, Outcome::Proved, "{t}");
        assert!(list.len().is_multiple_of(2), "{t}: {}", list.len());
        if step == 0 {
            assert_eq!(list.len(), 10);
        }
        let own = of_seven!(machine.position(t)?);
        let mut same = 0;
        for at in &list {
            let pose = of_seven!(machine.with(at).position(t)?);
            let off = misfit(SEVEN, [&pose, &drawing]);
            assert!(off < CLOSED, "{off:e} in {at:?} at {t}");
            same += usize::from(apart(&pose, &own) < 1e-9);
        }
        assert_eq!(same, 1, "{t}");
    }
    Ok(())
}

/// A budget that is too small is said to be so, and numbers that are none are refused.
#[test]
fn lists_keep_to_their_budget() -> Result<(), SolveError> {
    let machine = Turning::new();
    let [theta] = Turning::DRAWN;
    let whole = machine.assemblies(theta, Budget::default())?;
    let small = Budget { samples: whole.samples / 2, pieces: 4000 };
    let part = machine.assemblies(theta, small)?;
    assert_eq!(part.outcome, Outcome::OutOfBudget);
    assert!(part.samples <= small.samples && part.len() <= whole.len());
    let refused = machine.assemblies(f64::NAN, Budget::default());
    assert!(matches!(refused, Err(SolveError::NotFinite { name: "theta" })), "{refused:?}");
    Ok(())
}

/// The list of a machine in `f32` is that of the machine in `f64`, but for its rounded lengths, and its solvers answer.
#[test]
fn lists_in_single_width_lose_nothing() -> Result<(), SolveError> {
    let (wide, narrow) = (Turning::new(), Turning::<f32>::default());
    for step in 0..90 {
        let theta = 0.07 * step as f32;
        let list = wide.assemblies(f64::from(theta), Budget::default())?;
        let single = narrow.assemblies(theta, Budget::default())?;
        // Lengths are off by 6e-8 of themselves, and two assemblies as near as this root of it may come together.
        if list.iter().any(|at| at.room < 1e-3) {
            continue;
        }
        assert_eq!((single.outcome, single.len()), (Outcome::Proved, list.len()), "{theta}");
        for (one, other) in single.iter().zip(&list) {
            let a = narrow.with(one).position(theta)?.P25;
            let b = wide.with(other).position(f64::from(theta))?.P25;
            let off = (f64::from(a.x) - b.x).hypot(f64::from(a.y) - b.y);
            // Roundings of lengths over the least slope that is left above.
            assert!(off < 1e-3, "{off} in {one:?} at {theta}");
        }
    }
    Ok(())
}
