//! Machines that come as another drawing than they went: what was changed stands in a comment, and the numbers are right.

use std::process::Command;

use crate::declarations::{pmks::*, pylinkage::*};
use crate::program::{fixture, given, run};

/// Checks that lines stand in the declaration of a fixture.
fn holds(name: &str, lines: &[&str]) {
    let printed = run(&fixture(name), &[]).expect("it is a machine");
    for line in lines {
        assert!(printed.lines().any(|own| own.trim() == *line), "{line}\n{printed}");
    }
}

/// A yoke that is welded to its block on the ground: the crank's cosine is its way.
#[test]
fn a_welded_yoke_is_one_link_with_its_block() {
    holds(
        "pmks/welded_yoke.txt",
        &[
            "// `CF` is welded to `CD` at `C`: both are `CD`.",
            "link CD(C, D) on guide_F;",
            "link BE(B) on guide_E;",
        ],
    );
    for turn in [0.0_f64, 0.5, 1.0, 2.0, 4.0] {
        let at = PmksWeldedYoke::new().position(PmksWeldedYoke::DRAWN[0] + turn).expect("it turns");
        let x = 0.03 * turn.cos();
        assert!((at.C.x - x).abs() < 1e-15 && (at.D.x - x).abs() < 1e-15, "{turn}");
    }
}

/// Blocks without records of their own: one is pinned to its crank, one is welded to the yoke.
#[test]
fn a_prismatic_joint_may_be_the_block() {
    holds(
        "pmks/blocks_of_joints.txt",
        &[
            "// Left out: the speed of the input at `A`, 4 rpm.",
            "// `block_C` is welded to `CD` at `C`: both are `CD`.",
            "pin B(3cm, 0), C(3cm, -5cm), D(3cm, 5cm);",
            "link CD(C, D) on guide_C;",
            "link block_B(B) on guide_B;",
            "mass 0.5g on block_B at (0, 0) inertia 0(kg*cm^2);",
            "mass 3g on CD at (5cm, 0) inertia 4(kg*cm^2);",
        ],
    );
    let solver = PmksBlocksOfJoints::new();
    for turn in [0.5_f64, 2.0, 4.0] {
        let at = solver.position(PmksBlocksOfJoints::DRAWN[0] + turn).expect("it turns");
        let x = 0.03 * turn.cos();
        assert!((at.C.x - x).abs() < 1e-15 && (at.D.x - x).abs() < 1e-15, "{turn}");
    }
}

/// A boom that a cylinder raises: its sides are 5 cm and 4 cm, and the law of cosines gives the angle between them.
#[test]
fn the_rod_of_a_cylinder_is_one_link_with_its_block() {
    holds("pmks/welded_cylinder.txt", &["link PC(P, C) on guide_S;", "drive PC.slide = s;"]);
    for out in [0.0, 0.0025, 0.005, 0.01] {
        let way = PmksWeldedCylinder::DRAWN[0] + out;
        let at = PmksWeldedCylinder::new().position(way).expect("it reaches");
        let [side, base, long] = [0.05, 0.04, 0.05_f64.hypot(0.04) + out];
        let cosine = (side * side + base * base - long * long) / (2.0 * side * base);
        assert!((at.C.x - side * cosine).abs() < 1e-15, "{out}: {}", at.C.x);
        assert!((at.C.y - side * (1.0 - cosine * cosine).sqrt()).abs() < 1e-15, "{out}");
    }
}

/// The weld of two parts of one link does not hold the block at their joint.
#[test]
fn parts_of_one_link_are_welded_to_nothing_else() {
    holds("pmks/welded_parts.txt", &["link ABT(A, B, T);", "link block(B) on guide_Z;"]);
    let printed = run(&fixture("pmks/welded_parts.txt"), &[]).expect("it is a machine");
    assert!(!printed.contains("is welded"), "{printed}");
}

/// Three decimals of a right angle.
#[test]
fn a_rounded_angle_is_a_whole_number_of_degrees() {
    holds(
        "pmks/upright_slider.txt",
        &[
            "// `guide_Z` is along 90deg, which PMKS+ wrote as 1.571 rad.",
            "guide guide_Z through (1cm, 20cm) along 90deg;",
        ],
    );
    for turn in [0.5, 1.5, 3.0] {
        let drawn = PmksUprightSlider::DRAWN[0];
        let at = PmksUprightSlider::new().position(drawn + turn).expect("it turns");
        assert!((at.C.x - 0.01).abs() < 1e-15, "{turn}: {}", at.C.x);
    }
}

/// An angle between whole degrees stays as it came.
#[test]
fn an_angle_that_is_no_whole_number_of_degrees_is_kept() {
    let older = std::fs::read_to_string(fixture("pmks/older.txt")).expect("it is there");
    for (radians, degrees) in [("0.7858", "0.7858rad"), ("0.3", "0.3rad"), ("-0.175", "-10deg")] {
        let text = older.replace("0.7853981633974483", radians);
        let printed = given(&text, &[]).expect("it is a machine");
        assert!(printed.contains(&format!("along {degrees};")), "{printed}");
        assert_eq!(printed.contains("which PMKS+ wrote as"), degrees.ends_with("deg"), "{printed}");
    }
}

/// Two sides that differ by a thousandth.
#[test]
fn a_rounded_parallelogram_is_one_to_the_last_digit() {
    holds(
        "pmks/rounded_parallelogram.txt",
        &[
            "// `C` was at (50.607, 10.606): `AB` and `DC` are made parallel and equal.",
            "pin B(10.606cm, 10.607cm), C(50.606cm, 10.607cm);",
        ],
    );
    for turn in [0.5, 1.5, 2.0] {
        let drawn = PmksRoundedParallelogram::DRAWN[0];
        let at = PmksRoundedParallelogram::new().position(drawn + turn).expect("it turns");
        // The sine of the angle at C is above a third here.
        let off = (at.C.x - at.B.x - 0.4).hypot(at.C.y - at.B.y);
        assert!(off < 1e-15, "{turn}: {off:e}");
    }
}

/// Sides that differ by more than rounding does, or are exact, are left alone; computed coordinates are rounded.
#[test]
fn other_sides_are_left_alone() {
    let machine = |c: &str| {
        format!(
            "M[J[R, P[0, 0], L[ground, AB]], J[R, P[0.3, 100.1], L[AB, BC]], J[R, P[{c}], L[BC, DC]], \
             J[R, P[200.2, 0], L[ground, DC]]]"
        )
    };
    for (c, place, is_changed) in [
        ("200.5, 100.1", "J2(200.5mm, 100.1mm)", false),
        ("200.51, 100.1", "J2(200.51mm, 100.1mm)", false),
        ("200.5, 100.099", "J2(200.5mm, 100.1mm)", true),
        ("200.50000000000003, 100.1", "J2(200.5mm, 100.1mm)", true),
    ] {
        let printed = given(&machine(c), &["--drive", "0,1"]).expect("it is a machine");
        assert!(printed.contains(place), "{printed}");
        assert_eq!(printed.contains("parallel and equal"), is_changed, "{c}: {printed}");
    }
}

/// Three bars, and two more that hold a pin on them.
#[test]
fn bars_that_are_triangles_are_one_link() {
    holds(
        "pylinkage/triangle.json",
        &[
            "// Left out: `angular_velocity` of `AB`, 0.1.",
            "// `BC`, `BP` and `CP` are a triangle: all are `BC`.",
            "// `BC`, `CQ` and `PQ` are a triangle: all are `BC`.",
            "link BC(B, C, P, Q);",
        ],
    );
    let at =
        PylinkageTriangle::new().position(PylinkageTriangle::DRAWN[0] + 1.0).expect("it turns");
    let away = |x: f64, y: f64| (at.B.x - x).hypot(at.B.y - y);
    let [p, q] = [110.0_f64.hypot(200.0), 190.0_f64.hypot(240.0)].map(|long| long / 1e3);
    assert!((away(at.P.x, at.P.y) - p).abs() < 1e-15 && (away(at.Q.x, at.Q.y) - q).abs() < 1e-15);
}

/// An address of before 2023, with a mass, a force and gravity.
#[test]
fn an_older_address_is_read() {
    holds(
        "pmks/older.txt",
        &[
            "// Left out: the speed of the input at `a`, 10 rpm.",
            "// Left out: gravity.",
            "ground a(0, 0);",
            "pin b(6cm, 5cm), c(26cm, 1cm);",
            "guide guide_d through (26cm, 1cm) along 45deg;",
            "link cd(c) on guide_d;",
            "drive ab.angle = theta;",
            "force (3N, 4N) on F1;",
        ],
    );
    let told = given("https://app.pmksplus.com/?j=a,0,0,ab,R,t,Null,t%0A&l=", &[]);
    let told = told.expect_err("it is cut off");
    assert!(told.contains("behind `&s=` stand speed, direction, gravity and unit"), "{told}");
}

/// One address as mailers, search engines and hasty hands leave it.
#[test]
fn an_address_survives_its_way() {
    let whole = std::fs::read_to_string(fixture("pmks/four_bar.txt")).expect("it is there");
    let whole = whole.trim();
    let printed = given(whole, &[]).expect("it is a machine");
    let bare = whole.trim_start_matches("https://");
    for text in [
        format!("{whole}#results"),
        format!("{whole}&utm_source=news&utm_medium=mail"),
        format!("{whole}&fbclid=x.y#top"),
        whole.replace(',', "%2C"),
        whole.replace(',', "%2c"),
        bare.to_string(),
        bare.replace("app.pmksplus.com/", ""),
    ] {
        assert_eq!(given(&text, &[]).as_ref(), Ok(&printed), "{text}");
        let mut program = Command::new(env!("CARGO_BIN_EXE_linkage"));
        let output = program.args(["import", &text]).output().expect("the program starts");
        assert_eq!(String::from_utf8_lossy(&output.stdout), printed, "{text}");
    }
    let older = std::fs::read_to_string(fixture("pmks/older.txt")).expect("it is there");
    let text = format!("{}&utm_source=news#top", older.trim());
    assert_eq!(given(&text, &[]), given(&older, &[]));
}

/// A title goes into a comment, whatever is in it, and counts by its characters.
#[test]
fn titles_are_told() {
    let joints = "KA,A,0,0,0.GB,B,Fe,0,0";
    let text = format!("2P.Fe.K,0.1011.{joints}..YRAB,Bügel 1,Fe,Fe,0,0,,A,B,,....N_");
    let digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    let last = digits.as_bytes()[text.chars().count() % 62] as char;
    let text = format!("app.pmksplus.com/?{}{last}", text.replace(' ', "%20"));
    let printed = given(&text.replace('ü', "%C3%BC"), &[]).expect("it is a machine");
    assert!(printed.contains("// Left out: the title of `AB`, Bügel 1.\n"), "{printed}");
}

/// Names beside identifiers, and joints on the ground because a driver turns about them.
#[test]
fn names_and_motors_of_pylinkage_are_read() {
    let text = r#"{"name": "m", "joints": [
        {"id": "a", "name": "shaft", "type": "revolute", "position": [0, 0]},
        {"id": "b", "type": "revolute", "position": [10, 0]}], "links": [
        {"id": "ab", "name": "the crank", "type": "driver", "joints": ["b", "a"], "motor_joint": "a",
         "initial_angle": 6.283185307179586, "arc_end": 2.5}]}"#;
    let other = text.replace("6.283185307179586", "0.5");
    let other = given(&other, &[]).expect("it is a machine");
    assert!(other.contains("// Left out: `initial_angle` of `ab`, 0.5.\n"), "{other}");
    let printed = given(text, &[]).expect("it is a machine");
    for line in [
        "// Left out: the name of `a`, shaft.",
        "// Left out: the name of `ab`, the crank.",
        "ground a(0, 0);",
        "// Left out: `arc_end` of `ab`, 2.5.",
        "drive ab.angle = theta;",
    ] {
        assert!(printed.lines().any(|own| own.trim() == line), "{line}: {printed}");
    }
    assert!(!printed.contains("initial_angle"), "{printed}");
}
