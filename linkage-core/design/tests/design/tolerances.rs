//! Reactions to a unit load against exact sensitivities, and tolerances against random machines.

use std::f64::consts::TAU;

use linkage_core::mechanism;
use linkage_design::{DesignError, Reactions, Tolerance};

mechanism! {
    /// A flying shear, every dimension and every play of a pin a parameter.
    struct PlayedShear {
        input theta: angle;
        load fx, fy: force;
        param crank = 80mm;
        param coupler = 632mm;
        param rocker = 374mm;
        param base = 665.7mm;
        param px = 500mm;
        param py: length = -60mm;
        param ax: length = 0mm;
        param ay: length = 0mm;
        param bx: length = 0mm;
        param by: length = 0mm;
        param dx: length = 0mm;
        param dy: length = 0mm;
        param zero: angle = 0deg;
        ground A(ax, ay), D(base + dx, dy);
        crank AB(A) { angle: theta + zero }
        point B on AB at (crank + bx, by);
        rrr BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: right }
        point blade on BC at (px, py);
        gravity (0, -9.81);
        mass 5kg on BC uniform;
        force (fx, fy) on blade;
    }
}

mechanism! {
    /// A press: a crank, a rod and a ram on a tilted guide.
    struct PlayedPress {
        input theta: angle;
        load push: force;
        param crank = 80mm;
        param rod = 250mm;
        param height = 30mm;
        param tilt = 20deg;
        param offset = 5mm;
        ground A(0, 0);
        guide bed through (0, height) along tilt;
        crank AB(A) -> B { length: crank, angle: theta }
        rrp BC(B), ram(bed) -> C { length: rod, offset: offset, mode: ahead }
        force (push, 0) in ram on C;
    }
}

mechanism! {
    /// A quick return: a block on a swinging bar.
    struct PlayedReturn {
        input theta: angle;
        load turn: torque;
        param crank = 100mm;
        param pivot = 250mm;
        param offset = 20mm;
        ground A(0, 0), D(0, -pivot);
        crank AB(A) -> B { length: crank, angle: theta }
        rpr block(B), bar(D) { offset: offset, mode: ahead }
        torque turn on bar;
    }
}

mechanism! {
    /// Two blocks on two guides, one of which a crank carries.
    struct PlayedCross {
        input theta: angle;
        load up: force;
        param crank = 100mm;
        param lower = 10mm;
        param upper = 20mm;
        param leaning = 70deg;
        ground A(0, 0);
        crank AB(A) -> B { length: crank, angle: theta }
        guide tower on AB through B along leaning;
        guide beam through (0, 200mm) along 10deg;
        prp p(tower), q(beam) -> C { offsets: (lower, upper) }
        force (0, up) on C;
    }
}

mechanism! {
    /// A Scotch yoke with a leaning slot.
    struct PlayedYoke {
        input theta: angle;
        load pull: force;
        param crank = 100mm;
        param height = 15mm;
        param slot = 75deg;
        param first = 10mm;
        param second = 7mm;
        ground A(0, 0);
        guide rail through (0, height) along 0deg;
        crank AB(A) -> B { length: crank, angle: theta }
        rpp block(B), yoke(rail) { slot: slot, offsets: (first, second) }
        point end on yoke at (0, 0);
        force (pull, 0) on end;
    }
}

/// Slopes are of sizes around one, and either way of computing them rounds some hundred times.
const EXACT: f64 = 1e-12;

fn assert_exact(name: &str, by_reactions: f64, by_parameters: f64) {
    let off = (by_reactions - by_parameters).abs();
    assert!(off < EXACT * (1.0 + by_parameters.abs()), "{name}: {by_reactions} {by_parameters}");
}

#[test]
fn reactions_of_a_shear_are_its_sensitivities() {
    let shear = PlayedShear::new();
    for theta in [0.4, 1.0, 2.0, 3.5, 5.0] {
        let position = shear.position(theta).unwrap();
        for (output, load) in [("x", [1.0, 0.0]), ("y", [0.0, 1.0])] {
            let [rest, loaded] = [[0.0; 2], load].map(|load| shear.statics(theta, load).unwrap());
            let by = Reactions::of(position, rest, loaded).loaded("BC", "blade", load);
            let of = |parameter: &str| {
                let output = format!("blade.{output}");
                let row = PlayedShear::<f64>::OUTPUTS.iter().position(|name| *name == output);
                let column = PlayedShear::<f64>::PARAMS.iter().position(|name| *name == parameter);
                shear.sensitivity(theta).unwrap()[(row.unwrap(), column.unwrap())]
            };
            assert_exact("crank", by.place("AB", "B").unwrap()[0], of("crank"));
            assert_exact("coupler", by.place("BC", "C").unwrap()[0], of("coupler"));
            assert_exact("rocker", by.place("DC", "C").unwrap()[0], of("rocker"));
            let blade = by.place("BC", "blade").unwrap();
            assert_exact("px", blade[0], of("px"));
            assert_exact("py", blade[1], of("py"));
            let [a, b, d] = [by.ground("AB", "A"), by.place("AB", "B"), by.ground("DC", "D")];
            for (name, [x, y]) in [("a", a.unwrap()), ("b", b.unwrap()), ("d", d.unwrap())] {
                assert_exact(name, x, of(&format!("{name}x")));
                assert_exact(name, y, of(&format!("{name}y")));
            }
            assert_exact("zero", by.drive("theta").unwrap(), of("zero"));
            // Play: in B as in A, since the crank hands the force on, and in C as in D.
            let pins = by.pins();
            let names: Vec<&str> = pins.iter().map(|pin| pin.0.as_str()).collect();
            assert_eq!(names, ["AB.A", "AB.B", "BC.C", "DC.D"]);
            assert_exact("A", pins[0].1, of("ax").hypot(of("ay")));
            assert_exact("B", pins[1].1, of("bx").hypot(of("by")));
            assert_exact("C", pins[2].1, of("dx").hypot(of("dy")));
            assert_exact("D", pins[3].1, of("dx").hypot(of("dy")));
        }
    }
}

/// The sensitivity of an output to a parameter, by their names.
macro_rules! sensitivity {
    ($machine:ident, $solver:expr, $input:expr, $output:literal) => {
        |parameter: &str| {
            let row = $machine::<f64>::OUTPUTS.iter().position(|name| *name == $output);
            let column = $machine::<f64>::PARAMS.iter().position(|name| *name == parameter);
            $solver.sensitivity($input).unwrap()[(row.unwrap(), column.unwrap())]
        }
    };
}

/// The reactions to a load, the only one.
macro_rules! reactions {
    ($solver:expr, $input:expr) => {{
        let [rest, loaded] = [0.0, 1.0].map(|load| $solver.statics($input, load).unwrap());
        Reactions::of($solver.position($input).unwrap(), rest, loaded)
    }};
}

#[test]
fn reactions_of_guides_are_sensitivities() {
    let (press, back) = (PlayedPress::new(), PlayedReturn::new());
    let (cross, yoke) = (PlayedCross::new(), PlayedYoke::new());
    for theta in [0.3, 1.2, 2.5, 4.0, 5.5] {
        let (by, of) =
            (reactions!(press, theta), sensitivity!(PlayedPress, press, theta, "ram.slide"));
        assert_exact("crank", by.place("AB", "B").unwrap()[0], of("crank"));
        assert_exact("rod", by.place("BC", "C").unwrap()[0], of("rod"));
        let [shift, turn] = by.guide("ram", "bed").unwrap();
        assert_exact("offset", shift, of("offset"));
        // The guide goes through (0, height): its shift along the normal is height times the tilt's cosine. The
        // slide, which is the output, is measured along the guide from that point.
        let (sin, cos) = press.tilt.sin_cos();
        assert_exact("height", shift * cos - sin, of("height"));
        // A turn takes the offset's end back along the guide, too.
        let slide = press.position(theta).unwrap().ram.slide;
        assert_exact("tilt", turn + shift * slide + press.offset, of("tilt"));

        let (by, of) =
            (reactions!(back, theta), sensitivity!(PlayedReturn, back, theta, "bar.angle"));
        assert_exact("crank", by.place("AB", "B").unwrap()[0], of("crank"));
        assert_exact("pivot", -by.ground("bar", "D").unwrap()[1], of("pivot"));
        assert_exact("offset", by.guide("block", "bar").unwrap()[0], of("offset"));

        let (by, of) =
            (reactions!(yoke, theta), sensitivity!(PlayedYoke, yoke, theta, "yoke.slide"));
        assert_exact("crank", by.place("AB", "B").unwrap()[0], of("crank"));
        assert_exact("first", by.guide("yoke", "rail").unwrap()[0], of("first"));
        assert_exact("height", by.guide("yoke", "rail").unwrap()[0], of("height"));
        let [shift, turn] = by.guide("block", "yoke").unwrap();
        assert_exact("second", shift, of("second"));
        let slide = yoke.position(theta).unwrap().block.slide;
        assert_exact("slot", turn + shift * slide, of("slot"));
    }
    for theta in [-0.3, 0.2] {
        let (by, of) = (reactions!(cross, theta), sensitivity!(PlayedCross, cross, theta, "C.y"));
        let [shift, turn] = by.guide("p", "tower").unwrap();
        assert_exact("lower", shift, of("lower"));
        let slide = cross.position(theta).unwrap().p.slide;
        assert_exact("leaning", turn + shift * slide, of("leaning"));
        assert_exact("upper", by.guide("q", "beam").unwrap()[0], of("upper"));
    }
}

#[test]
fn a_name_that_is_none_is_told_with_those_that_are() {
    let by = reactions!(PlayedReturn::new(), 1.0);
    let error = by.place("bar", "E").unwrap_err();
    assert!(
        error.to_string().starts_with("there is no `bar.E.x`; there are `theta.drive`"),
        "{error}"
    );
    assert!(matches!(by.guide("ram", "bed"), Err(DesignError::Unknown { .. })));
}

/// Every draw, or fewer without `LINKAGE_WHOLE`, and four deviations of a deviation, 1/√(2n) each, or 0.3 %.
fn draws() -> (usize, f64) {
    let whole = std::env::var_os("LINKAGE_WHOLE").is_some();
    if whole { (1_000_000, 3e-3) } else { (20_000, 4.0 / f64::sqrt(40_000.0)) }
}

/// The shear's blade at 115°: dimensions within 0.1 mm, 0.05 mm of play in four pins.
fn of_shear(theta: f64) -> Result<Tolerance, DesignError> {
    let shear = PlayedShear::new();
    let statics = |up| shear.statics(theta, [0.0, up]).unwrap();
    let position = shear.position(theta).unwrap();
    let by = Reactions::of(position, statics(0.0), statics(1.0)).loaded("BC", "blade", [0.0, 1.0]);
    let blade = by.place("BC", "blade")?;
    Ok(Tolerance::new()
        .dimension("crank", by.place("AB", "B")?[0], 0.1e-3)
        .dimension("coupler", by.place("BC", "C")?[0], 0.1e-3)
        .dimension("rocker", by.place("DC", "C")?[0], 0.1e-3)
        .dimension("base", by.ground("DC", "D")?[0], 0.1e-3)
        .dimension("px", blade[0], 0.1e-3)
        .dimension("py", blade[1], 0.1e-3)
        .play_in_pins(&by, 0.05e-3)
        .margin(0.1665))
}

#[test]
fn tolerances_of_a_shear_are_those_of_random_shears() {
    let theta = 115_f64.to_radians();
    let tolerance = of_shear(theta).unwrap();
    println!("{tolerance}");
    let micrometres: Vec<(&str, f64)> = tolerance
        .contributions()
        .iter()
        .map(|of| (of.name.as_str(), (of.worst() * 1e7).round() / 10.0))
        .collect();
    let expected = [
        ("py", 78.9),
        ("px", 61.4),
        ("crank", 60.0),
        ("rocker", 56.9),
        ("base", 30.5),
        ("AB.A", 15.1),
        ("AB.B", 15.1),
        ("BC.C", 14.2),
        ("DC.D", 14.2),
        ("coupler", 5.4),
    ];
    assert_eq!(micrometres, expected);
    assert!((tolerance.worst() * 1e6 - 351.7).abs() < 0.05);
    assert!((tolerance.deviation() * 1e6 - 79.764).abs() < 5e-4);
    assert!(tolerance.is_trusted());

    let (count, digits) = draws();
    let shear = PlayedShear::new();
    let exact = shear.position(theta).unwrap().blade.y;
    let drawn = tolerance.drawn(count, 4, |by, pins| {
        let drawn = PlayedShear {
            crank: shear.crank + by[0],
            coupler: shear.coupler + by[1],
            rocker: shear.rocker + by[2],
            base: shear.base + by[3],
            px: shear.px + by[4],
            py: shear.py + by[5],
            ax: pins[0][0],
            ay: pins[0][1],
            bx: pins[1][0],
            by: pins[1][1],
            dx: pins[2][0] + pins[3][0],
            dy: pins[2][1] + pins[3][1],
            ..shear
        };
        Ok(drawn.position(theta)?.blade.y - exact)
    });
    assert!((drawn.deviation / tolerance.deviation() - 1.0).abs() < digits, "{drawn:?}");
    assert_eq!(drawn.refused, 0);
    assert!(drawn.within(1.0) < tolerance.worst());
    assert!((drawn.within(0.9973) * 1e6 - 221.8).abs() < 5.0, "{}", drawn.within(0.9973));

    let over = (0..36).map(|k| f64::from(k) * TAU / 36.0);
    let (at, worst) = Tolerance::worst_over(over.clone(), of_shear).unwrap().unwrap();
    assert!(over.map(|q| of_shear(q).unwrap().worst()).all(|other| other <= worst.worst()), "{at}");
}

mechanism! {
    /// A toggle press: the ram's height by the crank.
    struct PlayedToggle {
        input theta: angle;
        load up: force;
        param crank = 80mm;
        param rod = 430mm;
        param upper = 280mm;
        param lower = 250mm;
        param ax: length = -500mm;
        param ay = 300mm;
        param dy = 600mm;
        ground A(ax, ay), D(0, dy);
        guide bed through (0, 0) along 90deg;
        crank AB(A) -> B           { length: crank, angle: theta }
        rrr   BC(B), DC(D) -> C    { lengths: (rod, upper), mode: right }
        rrp   CE(C), ram(bed) -> E { length: lower, mode: behind }
        force (0, up) on E;
    }
}

/// At its lowest, at 28.39°, upper and lower bar are in line and the ram is as far off as three lengths are:
/// 100 µm of deviation and 300 µm at the worst.
#[test]
fn a_toggle_press_goes_through_its_toggle() {
    let press = PlayedToggle::new();
    for (degrees, worst, deviation) in
        [(0.0, 300.0, 100.0), (2.0, 303.1, 99.971), (10.0, 316.9, 99.913), (40.0, 373.2, 102.084)]
    {
        let theta = (28.39_f64 + degrees).to_radians();
        let (by, of) =
            (reactions!(press, theta), sensitivity!(PlayedToggle, press, theta, "ram.slide"));
        let [ax, ay] = by.ground("AB", "A").unwrap();
        let found = [
            ("crank", by.place("AB", "B").unwrap()[0]),
            ("rod", by.place("BC", "C").unwrap()[0]),
            ("upper", by.place("DC", "C").unwrap()[0]),
            ("lower", by.place("CE", "E").unwrap()[0]),
            ("ax", ax),
            ("ay", ay),
            ("dy", by.ground("DC", "D").unwrap()[1]),
        ];
        let mut tolerance = Tolerance::new();
        for (name, sensitivity) in found {
            assert_exact(name, sensitivity, of(name));
            tolerance = tolerance.dimension(name, sensitivity, 0.1e-3);
        }
        assert!((tolerance.worst() * 1e6 - worst).abs() < 0.2, "{degrees}: {tolerance}");
        assert!((tolerance.deviation() * 1e6 - deviation).abs() < 0.02, "{degrees}: {tolerance}");
    }
}
