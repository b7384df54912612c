//! Reports against numbers that are known otherwise.

use core::f64::consts::{FRAC_PI_2, PI};

use super::{EntryReport, Report, ReportOptions};
use crate::pipeline;

fn report(source: &str, change: impl FnOnce(&mut ReportOptions)) -> Result<Report, Vec<String>> {
    let mut options = ReportOptions::default();
    change(&mut options);
    let tokens = source.parse().expect("these are tokens");
    pipeline::report(tokens, &options)
        .map_err(|mistakes| mistakes.into_iter().map(|mistake| mistake.message).collect())
}

fn pair(name: &str, value: &str) -> (String, String) {
    (name.to_string(), value.to_string())
}

const SHEAR: &str = "struct Shear { input theta: angle; ground A(0, 0), D(665.7mm, 0);
    crank AB(A) -> B { length: 80mm, angle: theta }
    rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
    point blade on BC at (500mm, -60mm); }";

/// Crank 43 mm, rod 136 mm, 100 mm beside the crank: dead points where 43 sin θ + 100 = 136 and −136.
const LIMITED: &str = "struct Press { input theta: angle; param beside: length = -100mm;
    ground A(0, 0); guide rail through (0, 0) along 0deg;
    crank AB(A) -> B { length: 43mm, angle: theta }
    rrp rod(B), ram(rail) -> C { length: 136mm, offset: beside, mode: ahead } }";

/// Near the numbers of a prototype that read printed C, which shares no line with this: 0.19 µm and 4.2e-16 m at 146.2°.
/// In that C d² was a cosine. Made of d's coordinates, as now, it takes a tenth off the first, and a fifth off the second.
#[test]
fn a_turning_machine_is_proved_over_the_whole_turn() {
    let report = report(SHEAR, |_| {}).expect("there is no mistake");
    let motion = &report.entries[0];
    assert!(motion.is_straight && motion.limits.is_empty() && motion.open.is_empty());
    assert_eq!(motion.largest_rate, Some([1_048_576.0, 51_471.0]));
    let named = |name: &str| {
        motion.results.iter().find(|result| result.name == name).expect("it is a result")
    };
    let x = named("position.blade.x");
    let [double, single] = x.bounds.as_ref().expect("it is proved");
    assert!((1.6e-7..1.8e-7).contains(&single.within), "{single:?}");
    assert!((3.1e-16..3.6e-16).contains(&double.within), "{double:?}");
    assert!((single.at[0].to_degrees() - 146.2).abs() < 1.0, "{single:?}");
    assert!((0.463..0.466).contains(&single.largest), "{single:?}");
    // Slopes by the names of the dimensions.
    let slope = |name: &str| {
        x.sensitivities.iter().find(|(own, _)| own == name).expect("it is a dimension").1
    };
    for (name, expected) in
        [("AB, 80mm", 1.06), ("BC, 632mm", 0.25), ("DC, 374mm", 0.62), ("D, 665.7mm", 0.30)]
    {
        assert!((slope(name) - expected).abs() < 0.08, "{name}: {}", slope(name));
    }
    let omega = named("velocity.DC.omega");
    assert_eq!((omega.rates, &omega.unit[..]), (1, "rad/s"));
    assert!((1.35e-7..1.5e-7).contains(&omega.bounds.as_ref().expect("it is proved")[1].within));
    let alpha = named("acceleration.blade.x").bounds.as_ref().expect("it is proved");
    assert!((9.0e-8..9.5e-8).contains(&alpha[1].within) && alpha[1].with_acceleration > 7e-8);
    // The angle between coupler and rocker, by the cosine theorem: d from 585.7 to 745.7 mm.
    let angle =
        |d: f64| ((0.632f64.powi(2) + 0.374f64.powi(2) - d * d) / (2.0 * 0.632 * 0.374)).acos();
    assert_transmission(motion, ("BC, DC", 1e-3), [0.5857, 0.7457].map(angle), [0.0, PI]);
}

/// The ends are bounds of the true ones and this far off at most, at the corners of boxes where these are. The boxes are a
/// 64th of a turn.
fn assert_transmission(
    motion: &EntryReport,
    (group, within): (&str, f64),
    [least, largest]: [f64; 2],
    at: [f64; 2],
) {
    let told = motion.transmissions.iter().find(|of| of.group == group).expect("it is told");
    assert!(told.least <= least && told.largest >= largest, "{told:?} {least} {largest}");
    let off = (least - told.least).max(told.largest - largest);
    assert!(off < within, "{told:?} {least} {largest}");
    for (found, at) in [(&told.least_at, at[0]), (&told.largest_at, at[1])] {
        let off = (found[0] - at).abs();
        assert!(off.min(2.0 * PI - off) < 0.1, "{told:?} {at}");
    }
}

/// A bar that leans back over the guide's normal and a block beside its bar are told from their mirror images: 40° is
/// not 140°.
#[test]
fn transmission_angles_of_blocks_know_their_side() {
    let guided =
        |beside: &str| report(LIMITED, |options| options.set = vec![pair("beside", beside)]);
    // The joint is from −43 to 43 mm above the guide: the way up to it, less the offset, over the rod.
    let angle = |t: f64| (t / 136.0).acos();
    let over = guided("-60mm").expect("there is no mistake");
    let ends = [-17.0, -103.0].map(angle);
    assert_transmission(&over.entries[0], ("rod, ram", 1e-3), ends, [-FRAC_PI_2, FRAC_PI_2]);
    let under = guided("60mm").expect("there is no mistake");
    let ends = [103.0, 17.0].map(angle);
    assert_transmission(&under.entries[0], ("rod, ram", 1e-3), ends, [-FRAC_PI_2, FRAC_PI_2]);
    // Its pivot is from 60 to 140 mm from the crank's pin.
    for (offset, sign) in [("30mm", 1.0), ("-30mm", -1.0)] {
        let source = format!(
            "struct M {{ input theta: angle; ground A(0, 0), D(100mm, 0);
             crank AB(A) -> B {{ length: 40mm, angle: theta }}
             rpr block(B), bar(D) {{ offset: {offset}, mode: ahead }} }}"
        );
        let report = report(&source, |_| {}).expect("there is no mistake");
        let [near, far] = [60.0, 140.0].map(|b: f64| (sign * 30.0 / b).acos());
        let (ends, at) = match sign > 0.0 {
            true => ([near, far], [0.0, PI]),
            false => ([far, near], [PI, 0.0]),
        };
        // Over a box the angle bends by 0.64 w²/2.
        assert_transmission(&report.entries[0], ("block, bar", 5e-3), ends, at);
    }
}

/// A dead point is where trigonometry says, and bounds grow by the powers of its distance that Taylor's series
/// gives: d^−1/2, d^−3/2, d^−5/2.
#[test]
fn next_to_a_limit_bounds_grow_by_its_distance() {
    let report = report(LIMITED, |_| {}).expect("there is no mistake");
    let motion = &report.entries[0];
    assert!(!motion.is_straight);
    let dead = (36.0_f64 / 43.0).asin();
    let expected = [dead, PI - dead];
    assert_eq!(motion.limits.len(), 2);
    for limit in &motion.limits {
        let off = expected.iter().map(|at| (limit.at - at).abs()).fold(1.0, f64::min);
        assert!(off < 1e-9, "{} is off by {off:e}", limit.at);
        assert_eq!(limit.group, "rod, ram");
        for (result, power) in [
            ("position.ram.slide", -0.5),
            ("velocity.ram.slide", -1.5),
            ("acceleration.ram.slide", -2.5),
        ] {
            let at = motion.results.iter().position(|own| own.name == result).expect("a result");
            let near = limit.distances.iter().position(|d| *d == 1e-3).expect("it is told");
            let bound = |at_distance: usize| limit.bounds[at][at_distance][0].expect("proved");
            let growth = (bound(near) / bound(near - 1)).log10();
            assert!((growth + power).abs() < 0.05, "{result}: {growth}");
        }
    }
    // Proved up to a hundredth of the range from it.
    let [_, single] = motion.results[0].bounds.as_ref().expect("proved away from limits");
    assert!(single.within < 2e-7);
    assert_eq!(motion.stretches.len(), 2);
}

/// A crank longer than its coupler: four dead points, where 200 sin θ is 130 or −130, and three stretches between them.
#[test]
fn limits_of_several_stretches_are_all_told() {
    const LONG: &str =
        "struct Long { input theta: angle; ground A(0, 0); guide rail through (0, 0) along 0deg;
        crank AB(A) -> B { length: 200mm, angle: theta }
        rrp BC(B), block(rail) -> C { length: 130mm, mode: ahead } }";
    let report = report(LONG, |_| {}).expect("there is no mistake");
    let limits = &report.entries[0].limits;
    let dead = (0.65_f64).asin();
    // The first stretch ends, two stand on both sides, the last begins.
    let expected = [(dead - PI, false), (-dead, true), (dead, false), (PI - dead, true)];
    assert_eq!(limits.len(), expected.len());
    for (limit, (at, is_lower)) in limits.iter().zip(expected) {
        assert!((limit.at - at).abs() < 1e-9, "{} for {at}", limit.at);
        assert_eq!((limit.is_lower, &limit.group[..]), (is_lower, "BC, block"));
    }
}

/// A target's root or sine that errs by more raises the bounds; one that is rounded correctly does not.
#[test]
fn functions_of_the_target_err_by_what_is_said() {
    let within = |change: &dyn Fn(&mut ReportOptions)| {
        let report = report(SHEAR, change).expect("there is no mistake");
        let angle = report.entries[0].results.iter().find(|own| own.name == "velocity.DC.omega");
        angle.and_then(|own| own.bounds.as_ref().ok()).expect("it is proved")[1].within
    };
    let own = within(&|_| {});
    let root = |places: &'static str| {
        within(&move |options: &mut ReportOptions| options.root_error = Some(places.into()))
    };
    assert_eq!(root("0.5"), own);
    // Three halves of a last place more, of one of some fifty roundings.
    let more = root("2") - own;
    assert!(more > 0.005 * own && more < 0.5 * own, "{more:e} of {own:e}");
    // Twice the surplus, twice the change, but for boxes that are halved until their bounds are a tenth too large.
    let twice = (root("3.5") - own) / more;
    assert!((1.5..2.5).contains(&twice), "{twice}");
    // A sine that is off by 2^-20, in place of 2^-24.
    let sine = within(&|options: &mut ReportOptions| options.sine_error = Some("2^-20".into()));
    assert!(sine > 3.0 * own, "{sine:e} of {own:e}");
}

/// A range of a parameter is a range like an input's; a parameter that is set has another default.
#[test]
fn parameters_are_ranged_over_or_set() {
    let within = |change: &dyn Fn(&mut ReportOptions)| {
        let report = report(LIMITED, |options| change(options)).expect("there is no mistake");
        let motion = &report.entries[0];
        let slide = motion.results.iter().find(|own| own.name == "position.ram.slide");
        let [_, single] = slide.expect("it is a result").bounds.clone().expect("it is proved");
        (single.within, motion.is_straight)
    };
    let (set, is_straight) = within(&|options| options.set = vec![pair("beside", "12mm")]);
    assert!(is_straight && set < 5e-8, "{set:e}");
    let (ranged, is_straight) =
        within(&|options| options.between = vec![pair("beside", "10mm..14mm")]);
    assert!(is_straight && ranged < 2.0 * set && ranged > 0.5 * set, "{ranged:e} {set:e}");
}

#[test]
fn what_is_not_proved_is_said_by_name() {
    let report = report(
        "struct M { input x: length; unknown theta: angle between (10deg, 150deg);
         ground A(0, 0); guide rail through (0, 30mm) along 0deg;
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrp BC(B), ram(rail) -> C { length: 250mm, mode: ahead }
         solve theta { ram.slide = x, mode: falling } }",
        |options| options.between = vec![pair("x", "200mm..300mm")],
    );
    let report = report.expect("there is no mistake");
    let why = report.entries[0].results[0].bounds.as_ref().expect_err("a search is not proved");
    assert_eq!(why, "a search finds the unknown `theta`");
    let beside = &report.entries[0].beside;
    assert!(beside[0].contains("at most 61 evaluations in f64 and 32 in f32"), "{beside:?}");
}

/// Six links of an eight-bar that are solved at once.
#[test]
fn what_is_solved_at_once_is_not_proved() {
    let report = report(
        "struct M { input theta: angle; ground P26(0.885, 0.043), P67(0.743, 0.312);
         pin P01(0.102, 0.069), P02(0.935, 0.827), P13(0.6, 0.124), P04(0.09, 0.631), P34(0.207, 0.988),
             P15(0.884, 0.368), P25(0.535, 0.864), P37(0.703, 0.282);
         link L0(P01, P02, P04), L1(P01, P13, P15), L2(P02, P25, P26), L3(P13, P34, P37);
         link L4(P04, P34), L5(P15, P25), L7(P37, P67); drive L7.angle = theta; }",
        |_| {},
    );
    let report = report.expect("there is no mistake");
    let motion = &report.entries[0];
    for result in &motion.results {
        let why = result.bounds.as_ref().expect_err("steps of Newton's method are not proved");
        let told = "steps of Newton's method find the unknowns of L0, L1, L2, L3, L4, L5 together";
        assert_eq!(why, told, "{}", result.name);
    }
    assert!(motion.stretches.is_empty() && motion.limits.is_empty() && !motion.is_straight);
}

#[test]
fn a_mistake_in_what_is_asked_is_named() {
    let refused = |change: &dyn Fn(&mut ReportOptions)| {
        report(LIMITED, |options| change(options)).expect_err("it is refused").remove(0)
    };
    type Case = (&'static dyn Fn(&mut ReportOptions), &'static str);
    let cases: [Case; 6] = [
        (&|o| o.between = vec![pair("thetta", "0..1")], "`thetta` is not an input or a parameter"),
        (
            &|o| o.between = vec![pair("theta", "0deg")],
            "write the range of `theta` as `theta=FROM..TO`",
        ),
        (
            &|o| o.between = vec![pair("theta", "1..0")],
            "write the lower end of the range of `theta` first",
        ),
        (&|o| o.set = vec![pair("beside", "3kg")], "write a value of `beside` in place of `3kg`"),
        (&|o| o.only = vec!["motoin".into()], "`motoin` is no entry point that a report tells of"),
        (&|o| o.within = Some("um".into()), "write an error with its unit in place of `um`"),
    ];
    for (change, expected) in cases {
        assert_eq!(refused(change), expected);
    }
    let no_range = report(
        "struct M { input s: length; ground A(0, 0), D(1, 0);
        rrr AC(A), DC(D) -> C { lengths: (s, 0.7), mode: left } }",
        |_| {},
    );
    assert_eq!(
        no_range.expect_err("it has no range"),
        ["say over which range `s` goes: `--between s=0mm..100mm`"]
    );
}

/// Forces at the rate that is given, and the acceleration under no load.
#[test]
fn forces_and_dynamics_are_proved() {
    let source = "struct M { input theta: angle; ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        gravity (0, -9.81(m/s^2)); mass 0.5kg on AB uniform; mass 1.2kg on BC uniform; mass 0.8kg on DC uniform;
        load M: torque; torque M on DC;
        output AB.drive, AB.A, BC.C; }";
    let report = report(source, |options| {
        options.rate = vec![pair("theta", "12")];
        options.set = vec![pair("M", "3(N*m)")];
    });
    let report = report.expect("there is no mistake");
    let names: Vec<&str> = report.entries.iter().map(|entry| &entry.name[..]).collect();
    assert!(names.contains(&"forces") && names.contains(&"forward_dynamics"), "{names:?}");
    for entry in &report.entries {
        for result in &entry.results {
            let [double, single] = result.bounds.as_ref().expect("it is proved");
            assert!(single.within <= 1e-3 * single.largest.max(1.0), "{} {single:?}", result.name);
            let ratio = single.within / double.within;
            assert!(
                single.within == 0.0 || (1e8..2e9).contains(&ratio),
                "{}: {ratio:e}",
                result.name
            );
        }
    }
}
