//! Machines drawn for this project, written in the formats of PMKS+, pyslvs and pylinkage: what the program prints of
//! them compiles, and stands where it is drawn.
//!
//! The printed declarations are in `declarations`, which `LINKAGE_RENEW=1 cargo test -p linkage-command --test machines`
//! writes.

mod attacked;
mod changes;
mod declarations;
mod mistakes;
mod newer;
mod program;

use declarations::{pmks::*, pylinkage::*, pyslvs::*};
use program::{declarations, fixture, run};

/// The pins of a fixture as they are printed, in metres.
fn pins(fixture_name: &str) -> Vec<(String, [f64; 2])> {
    let text = run(&fixture(fixture_name), &[]).expect("it is a machine");
    let line = text.lines().find_map(|line| line.trim().strip_prefix("pin "));
    let places = line.expect("it has pins").trim_end_matches(';').split("), ");
    let pin = |place: &str| {
        let (name, at) = place.trim_end_matches(')').split_once('(').expect("a place");
        let (x, y) = at.split_once(", ").expect("two coordinates");
        (name.to_string(), [x, y].map(metres))
    };
    places.map(pin).collect()
}

fn metres(text: &str) -> f64 {
    let units = [("mm", 1e-3), ("cm", 1e-2), ("m", 1.0)];
    let unit = units.iter().find_map(|(unit, factor)| Some((text.strip_suffix(unit)?, factor)));
    let (number, factor) = unit.unwrap_or((text, &1.0));
    number.parse::<f64>().expect("a number") * factor
}

/// Compares a pose with the pins of a fixture.
fn stands(fixture: &str, outputs: &[&str], rows: &[f64]) {
    // A dyad errs by some units in the last place over the sine of its angle, a search by as much over its
    // slope, and none of these drawings has one below a hundredth.
    let pins = pins(fixture);
    let size = pins.iter().flat_map(|(_, at)| at).fold(0.0_f64, |size, x| size.max(x.abs()));
    for (name, at) in pins {
        for (axis, wanted) in ["x", "y"].iter().zip(at) {
            let row = outputs.iter().position(|output| *output == format!("{name}.{axis}"));
            let found = rows[row.unwrap_or_else(|| panic!("{fixture}: `{name}` is no output"))];
            let off = (found - wanted).abs();
            assert!(off <= 1e-12 * size, "{fixture}: {name}.{axis} is off by {off:e} m");
        }
    }
}

macro_rules! stand {
    ($($test:ident $machine:ident $fixture:literal)+) => {
        $(#[test]
        fn $test() {
            let rows = $machine::new().position($machine::DRAWN[0]).expect("it is drawn").rows();
            stands($fixture, &$machine::OUTPUTS, &rows);
        })+

        /// The fixtures that these tests name.
        const STANDING: &[&str] = &[$($fixture),+];
    };
}

stand! {
    pmks_blocks_of_joints PmksBlocksOfJoints "pmks/blocks_of_joints.txt"
    pmks_boom PmksBoom "pmks/boom.txt"
    pmks_driven_elbow PmksDrivenElbow "pmks/driven_elbow.txt"
    pmks_four_bar PmksFourBar "pmks/four_bar.txt"
    pmks_loaded_four_bar PmksLoadedFourBar "pmks/loaded_four_bar.txt"
    pmks_older PmksOlder "pmks/older.txt"
    pmks_peaucellier PmksPeaucellier "pmks/peaucellier.txt"
    pmks_rounded_parallelogram PmksRoundedParallelogram "pmks/rounded_parallelogram.txt"
    pmks_slider_crank PmksSliderCrank "pmks/slider_crank.txt"
    pmks_slotted_coupler PmksSlottedCoupler "pmks/slotted_coupler.txt"
    pmks_stephenson_3 PmksStephenson3 "pmks/stephenson_3.txt"
    pmks_triad PmksTriad "pmks/triad.txt"
    pmks_upright_slider PmksUprightSlider "pmks/upright_slider.txt"
    pmks_watt_1 PmksWatt1 "pmks/watt_1.txt"
    pmks_welded_cylinder PmksWeldedCylinder "pmks/welded_cylinder.txt"
    pmks_welded_parts PmksWeldedParts "pmks/welded_parts.txt"
    pmks_welded_yoke PmksWeldedYoke "pmks/welded_yoke.txt"
    pylinkage_coupler_curve PylinkageCouplerCurve "pylinkage/coupler_curve.json"
    pylinkage_four_bar PylinkageFourBar "pylinkage/four_bar.json"
    pylinkage_slider_crank PylinkageSliderCrank "pylinkage/slider_crank.json"
    pylinkage_triangle PylinkageTriangle "pylinkage/triangle.json"
    pylinkage_watt_1 PylinkageWatt1 "pylinkage/watt_1.json"
    pyslvs_eight_bar_01_g0_d01 PyslvsEightBar01G0D01 "pyslvs/eight_bar_01_g0_d01.txt"
    pyslvs_eight_bar_02_g0_d06 PyslvsEightBar02G0D06 "pyslvs/eight_bar_02_g0_d06.txt"
    pyslvs_eight_bar_03_g0_d05 PyslvsEightBar03G0D05 "pyslvs/eight_bar_03_g0_d05.txt"
    pyslvs_eight_bar_04_g0_d05 PyslvsEightBar04G0D05 "pyslvs/eight_bar_04_g0_d05.txt"
    pyslvs_eight_bar_06_g0_d01 PyslvsEightBar06G0D01 "pyslvs/eight_bar_06_g0_d01.txt"
    pyslvs_eight_bar_11_g2_d26 PyslvsEightBar11G2D26 "pyslvs/eight_bar_11_g2_d26.txt"
    pyslvs_eight_bar_13_g4_d04 PyslvsEightBar13G4D04 "pyslvs/eight_bar_13_g4_d04.txt"
    pyslvs_four_bar PyslvsFourBar "pyslvs/four_bar.txt"
    pyslvs_peaucellier PyslvsPeaucellier "pyslvs/peaucellier.txt"
    pyslvs_scissor PyslvsScissor "pyslvs/scissor.txt"
    pyslvs_scotch_yoke PyslvsScotchYoke "pyslvs/scotch_yoke.txt"
    pyslvs_slider_crank PyslvsSliderCrank "pyslvs/slider_crank.txt"
    pyslvs_stephenson_1 PyslvsStephenson1 "pyslvs/stephenson_1.txt"
    pyslvs_stephenson_2 PyslvsStephenson2 "pyslvs/stephenson_2.txt"
    pyslvs_stephenson_3 PyslvsStephenson3 "pyslvs/stephenson_3.txt"
    pyslvs_stephenson_3_other_end PyslvsStephenson3OtherEnd "pyslvs/stephenson_3_other_end.txt"
    pyslvs_stephenson_g0_d01 PyslvsStephensonG0D01 "pyslvs/stephenson_g0_d01.txt"
    pyslvs_triad PyslvsTriad "pyslvs/triad.txt"
    pyslvs_watt_1 PyslvsWatt1 "pyslvs/watt_1.txt"
    pyslvs_watt_2 PyslvsWatt2 "pyslvs/watt_2.txt"
    pyslvs_whitworth PyslvsWhitworth "pyslvs/whitworth.txt"
}

/// A machine of two inputs.
#[test]
fn pyslvs_five_bar() {
    let rows = PyslvsFiveBar::new().position(PyslvsFiveBar::DRAWN).expect("it is drawn").rows();
    stands("pyslvs/five_bar.txt", &PyslvsFiveBar::OUTPUTS, &rows);
}

#[test]
fn every_fixture_stands_where_it_is_drawn() {
    let mut all: Vec<_> = STANDING.to_vec();
    all.push("pyslvs/five_bar.txt");
    all.sort_unstable();
    assert_eq!(all, program::fixtures());
}

#[test]
fn what_is_compiled_here_is_what_is_printed() {
    for folder in program::FORMATS {
        let printed = declarations(folder);
        let path = fixture(&format!("declarations/{folder}.rs"));
        if std::env::var_os("LINKAGE_RENEW").is_some() {
            std::fs::write(&path, &printed).expect("the file is written");
        }
        let stored = std::fs::read_to_string(&path).expect("it is there");
        assert!(
            stored == printed,
            "LINKAGE_RENEW=1 cargo test -p linkage-command --test machines writes {folder}.rs"
        );
    }
}

/// Masses at their centres, in the frames of links; a force that keeps its direction, and one that turns with its link and
/// whose arrow points at its place.
#[test]
fn masses_and_forces_of_an_address() {
    let printed = run(&fixture("pmks/loaded_four_bar.txt"), &[]).expect("it is a machine");
    let statements: Vec<_> =
        printed.lines().map(str::trim).skip_while(|line| !line.starts_with("mass")).collect();
    // The first arrow goes 30 cm down. The second one goes 50 cm along x and points inward, so that the force is along -x:
    // the rocker goes 80 cm that way and 260 cm up, from D to C.
    let [ab, bc] = [50.0_f64.hypot(90.0), 270.0_f64.hypot(170.0)];
    let [x, y] = [(135.0 * 270.0 + 85.0 * 170.0) / bc, (85.0 * 270.0 - 135.0 * 170.0) / bc];
    let [along, across] = [80.0, 260.0].map(|side| 10.0 * side / 80.0_f64.hypot(260.0));
    let numbers = |line: &str| -> Vec<f64> {
        let is_part = |c: char| c.is_ascii_digit() || c == '.' || c == '-';
        let line = line.split("on F").next().expect("a part");
        let line = line.replace("F1", "").replace("F2", "").replace("cm^2", "");
        line.split(|c| !is_part(c)).filter_map(|number| number.parse().ok()).collect()
    };
    let wanted: [(&str, &[f64]); 6] = [
        ("mass 12.5g on AB at (", &[12.5, ab / 2.0, 0.0, 0.025]),
        (
            "mass 340g on BC at (",
            &[
                340.0,
                (130.0 * 270.0 + 100.0 * 170.0) / bc,
                (100.0 * 270.0 - 130.0 * 170.0) / bc,
                31.25,
            ],
        ),
        ("point F1 on BC at (", &[x, y]),
        ("force (", &[0.0, -42.5]),
        ("point F2 on DC at (", &[80.0_f64.hypot(260.0) / 2.0, 0.0]),
        ("force (", &[along, across]),
    ];
    for (line, (start, numbers_wanted)) in statements.iter().zip(wanted) {
        assert!(line.starts_with(start), "{line}");
        let found = numbers(line);
        assert_eq!(found.len(), numbers_wanted.len(), "{line} {found:?}");
        for (found, wanted) in found.iter().zip(numbers_wanted) {
            assert!((found - wanted).abs() < 1e-9, "{line}: {found} for {wanted}");
        }
    }
    assert!(
        statements[3].ends_with(") on F1;") && statements[5].ends_with(" in DC on F2;"),
        "{printed}"
    );
    assert!(
        printed.contains("inertia 0.025(kg*cm^2);") && !printed.contains("g on DC at ("),
        "{printed}"
    );
}

/// One machine, three formats.
#[test]
fn a_machine_is_the_same_from_everywhere() {
    for machine in ["four_bar", "slider_crank", "watt_1"] {
        let of = |fixture: String| pins(&fixture).into_iter().map(|(_, at)| at).collect::<Vec<_>>();
        // Addresses were drawn in centimetres, the others in as many millimetres.
        let scaled = |places: Vec<[f64; 2]>| -> Vec<[i64; 2]> {
            places.into_iter().map(|at| at.map(|x| (x * 1e7).round() as i64)).collect()
        };
        let wanted = scaled(of(format!("pyslvs/{machine}.txt")));
        assert_eq!(scaled(of(format!("pylinkage/{machine}.json"))), wanted, "{machine}");
        let tenth = of(format!("pmks/{machine}.txt")).into_iter().map(|at| at.map(|x| x / 10.0));
        assert_eq!(scaled(tenth.collect()), wanted, "{machine}");
    }
}
