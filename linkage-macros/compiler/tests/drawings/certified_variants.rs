//! Machines of which one group is solved by all its unknowns at once, told in another size, in other units, mirrored, or with
//! pins that are a rounding away: as much of the motion is certified, and it is the same motion.

use super::machine::{Machine, Places, machine};
use super::tracked::{AT_THE_GROUND, EightBar, GRIPPER, of_several_unknowns};
use super::variants::{Random, moved};

/// Two machines that are one and the same motion.
struct Compared<'m> {
    one: &'m Machine,
    other: &'m Machine,
    /// The drive of the other one over that of the one.
    drive: f64,
}

impl Compared<'_> {
    /// The count of certified poses of both, evenly over these drives of the one, and how far their pins are from each other at
    /// most where both are, of the machine's size one.
    fn over(
        &self,
        [from, to]: [f64; 2],
        as_one: impl Fn([f64; 2]) -> [f64; 2],
    ) -> ([usize; 2], f64) {
        let (mut counts, mut off) = ([0; 2], 0.0_f64);
        for part in 0..POSES {
            let drive = from + (to - from) * (part as f64 + 0.5) / POSES as f64;
            let one = self.one.certified::<f64>(&[self.one.drawn_inputs()[0] + drive]);
            let other =
                self.other.certified::<f64>(&[self.other.drawn_inputs()[0] + self.drive * drive]);
            counts[0] += usize::from(one.is_some());
            counts[1] += usize::from(other.is_some());
            if let (Some(mut one), Some(other)) = (one, other) {
                // Those of the ground are read from the text, without its units.
                let ground = self.one.drawn::<f64>(true);
                one.retain(|(name, _)| ground.iter().all(|(pin, _)| pin != name));
                off = off.max(apart(&one, &other, &as_one));
            }
        }
        (counts, off)
    }
}

const POSES: usize = 200;

fn apart(one: &Places<f64>, other: &Places<f64>, as_one: impl Fn([f64; 2]) -> [f64; 2]) -> f64 {
    let pairs = one.iter().zip(other).map(|((name, one), (same, other))| {
        assert_eq!(name, same);
        let other = as_one(*other);
        (one[0] - other[0]).hypot(one[1] - other[1])
    });
    pairs.fold(0.0, f64::max)
}

fn declared(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}"))
        .unwrap_or_else(|told| panic!("{told:?}\n{statements}"))
}

/// Machines of the list, that with a crank at the ground among them.
fn chosen() -> Vec<EightBar> {
    let all = of_several_unknowns().into_iter().enumerate();
    all.filter(|(nth, bar)| nth % 16 == 5 || bar.index == AT_THE_GROUND)
        .map(|(_, bar)| bar)
        .collect()
}

/// Rounding of coordinates about one, over the smallest slope of a root that is certified.
const ROUNDED: f64 = 1e-10;

/// Sizes are rounded in decimals: where a piece ends differs by no more than one pose of two hundred.
#[test]
fn a_machine_of_any_size_is_as_certified_and_moves_the_same() {
    sizes_are_one_motion(&[1e3]);
}

#[test]
#[ignore = "some seconds: `.ci/nightly` takes it"]
fn a_machine_of_more_sizes_is_as_certified_and_moves_the_same() {
    sizes_are_one_motion(&[1e-9, 1e-3, 1e3, 1e9]);
}

fn sizes_are_one_motion(scales: &[f64]) {
    for bar in chosen() {
        let statements = bar.driven.statements(&bar.places);
        let one = declared(&statements);
        let ends = ends(&one);
        for &scale in scales {
            let other = declared(&moved(&statements, |at| at.map(|part| part * scale)));
            let compared = Compared { one: &one, other: &other, drive: 1.0 };
            let (counts, off) = compared.over(ends, |at| at.map(|part| part / scale));
            assert!(counts[0].abs_diff(counts[1]) <= 1 && counts[0] > POSES * 9 / 10, "{counts:?}");
            assert!(off < ROUNDED, "{} at {scale:e}: {off:e}", bar.index);
        }
    }
}

/// The drives about the drawing on which a machine is certified, and a little more.
fn ends(machine: &Machine) -> [f64; 2] {
    let [from, to] = machine.mechanism.tracked[0].fit.stretch();
    let more = 0.02 * (to - from);
    [from - more, to + more]
}

/// The gripper is driven by a length.
#[test]
fn a_gripper_of_any_size_is_as_certified_and_moves_the_same() {
    grippers_are_one_motion(&[("in", 25.4)]);
}

#[test]
#[ignore = "some seconds: `.ci/nightly` takes it"]
fn a_gripper_of_more_sizes_is_as_certified_and_moves_the_same() {
    let small = [("e-12m", 1e-9), ("um", 1e-3)];
    grippers_are_one_motion(&[&small[..], &[("cm", 10.0), ("m", 1e3), ("e6m", 1e9)]].concat());
}

fn grippers_are_one_motion(units: &[(&str, f64)]) {
    let one = declared(GRIPPER);
    let ends = ends(&one);
    for &(unit, scale) in units {
        let other = declared(&GRIPPER.replace("mm", unit));
        let compared = Compared { one: &one, other: &other, drive: scale };
        let (counts, off) = compared.over(ends, |at| at.map(|part| part / scale));
        assert!(counts[0].abs_diff(counts[1]) <= 1 && counts[0] > POSES * 9 / 10, "{counts:?}");
        assert!(off < ROUNDED, "{unit}: {off:e}");
    }
}

/// Decimals in metres and in millimetres are one exact number: every bit is the same.
#[test]
fn a_machine_in_millimetres_is_that_in_metres() {
    for bar in chosen() {
        let statements = bar.driven.statements(&bar.places);
        let one = declared(&moved(&statements, |at| at));
        let in_millimetres = moved(&statements, |at| at.map(|part| (part * 1e3).round()));
        let other = declared(&in_millimetres.replace("m, ", "mm, ").replace("m)", "mm)"));
        let compared = Compared { one: &one, other: &other, drive: 1.0 };
        let (counts, off) = compared.over(ends(&one), |at| at);
        assert_eq!(counts[0], counts[1], "{}", bar.index);
        assert!(counts[0] > POSES * 9 / 10 && off == 0.0, "{}: {off:e}", bar.index);
    }
}

#[test]
fn a_mirrored_machine_is_as_certified_and_moves_the_other_way() {
    for bar in chosen() {
        let statements = bar.driven.statements(&bar.places);
        let one = declared(&statements);
        let other = declared(&moved(&statements, |[x, y]| [x, -y]));
        let compared = Compared { one: &one, other: &other, drive: -1.0 };
        let (counts, off) = compared.over(ends(&one), |[x, y]| [x, -y]);
        assert!(counts[0].abs_diff(counts[1]) <= 1 && counts[0] > POSES * 9 / 10, "{counts:?}");
        assert!(off < ROUNDED, "{}: {off:e}", bar.index);
    }
}

/// The slopes of the equations magnify a billionth at most a thousand times where poses are certified.
#[test]
fn pins_a_billionth_away_leave_all_but_as_much_certified() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    for bar in chosen() {
        let statements = bar.driven.statements(&bar.places);
        let one = declared(&statements);
        let mut places = bar.places.clone();
        for part in places.iter_mut().flatten() {
            *part += 1e-12 * (random.below(2001) as f64 - 1000.0);
        }
        let other = declared(&bar.driven.statements(&places));
        let compared = Compared { one: &one, other: &other, drive: 1.0 };
        let (counts, off) = compared.over(ends(&one), |at| at);
        assert!(counts[0].abs_diff(counts[1]) <= 1 && counts[0] > POSES * 9 / 10, "{counts:?}");
        assert!(off > 1e-10 && off < 1e-6, "{}: {off:e}", bar.index);
    }
}
