//! Models of MuJoCo: written from drawings as they are stored, and read back as the same machines.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const MACHINES: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/both_ways/heavy_machines.rs");

fn linkage(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_linkage"))
        .args(arguments)
        .output()
        .expect("the program starts")
}

fn printed(arguments: &[&str]) -> String {
    let output = linkage(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("it is UTF-8")
}

fn refused(arguments: &[&str]) -> String {
    let output = linkage(arguments);
    assert!(!output.status.success(), "{arguments:?}");
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mjcf");
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

fn written(name: &str, text: &str) -> String {
    let path = folder().join(name);
    fs::write(&path, text).expect("a file can be written");
    path.to_string_lossy().into_owned()
}

const SETS: [(&str, &str); 8] = [
    ("HeavyExcavator", "cylinders"),
    ("HeavyExcavator", "joints"),
    ("HeavyFiveBar", "motors"),
    ("HeavyFiveBar", "hand"),
    ("HeavyHorst", "shock"),
    ("HeavyToggle", "crank_side"),
    ("HeavyToggle", "press"),
    ("HeavyAnkle", "joints"),
];

fn exported(machine: &str, set: &str) -> String {
    printed(&["export", "mjcf", MACHINES, "--machine", machine, "--inputs", set, "--plane", "xz"])
}

#[test]
fn models_are_as_stored() {
    let stored = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/mjcf");
    for (machine, set) in SETS {
        let (text, path) = (exported(machine, set), stored.join(format!("{machine}_{set}.xml")));
        if std::env::var_os("LINKAGE_RENEW").is_some() {
            fs::create_dir_all(&stored).expect("a folder can be made");
            fs::write(&path, &text).expect("a file can be written");
        }
        let own = fs::read_to_string(&path).unwrap_or_default();
        assert!(text == own, "{machine} by {set} is another model:\n{text}");
    }
}

/// A drawing that is read of a model is written as that model again, and is solved by the same groups.
#[test]
fn a_model_that_is_read_is_the_same_machine() {
    for (machine, set) in SETS {
        let once = written(&format!("{machine}_{set}.xml"), &exported(machine, set));
        let read = printed(&["import", &once]);
        let source = written(&format!("{machine}_{set}.rs"), &read);
        let again =
            written(&format!("{machine}_{set}_again.xml"), &printed(&["export", "mjcf", &source]));
        let read_again = printed(&["import", &again]);
        assert!(read == read_again, "{machine} by {set}:\n{read}\n{read_again}");
        let groups = |arguments: &[&str]| {
            let all = [&["export", "rust"][..], arguments].concat();
            let text = printed(&all);
            let lines = text.lines().map(str::trim).filter(|line| line.starts_with("///"));
            let statements = lines.filter_map(|line| {
                let words =
                    ["crank", "rrr", "rrp", "rpr", "prp", "rpp", "slider", "point", "unknown"];
                let line = line.trim_start_matches('/').trim();
                words.iter().find(|word| line.starts_with(**word)).map(|word| word.to_string())
            });
            let mut statements: Vec<_> = statements.collect();
            statements.sort();
            statements
        };
        let own = groups(&[MACHINES, "--machine", machine, "--inputs", set]);
        assert!(!own.is_empty(), "{machine} by {set} tells no groups");
        assert_eq!(groups(&[&source]), own, "{machine} by {set}: {read}");
    }
}

/// A declaration in the order of a model: what is read of it expands to the same code.
#[test]
fn a_drawing_comes_back_to_the_token() {
    let drawing = "mechanism! {
    pub struct Robot {
        input a = AB.angle;
        input b = ED.angle;
        ground A(-0.05m, 0), E(0.05m, 0);
        pin B(-0.12m, 0.09m), tool(0, 0.2m), D(0.12m, 0.09m);
        link AB(A, B);
        link BC(B, tool);
        link ED(E, D);
        link CD(D, tool);
        gravity (0.0, -9.81);
        mass 0.2kg on BC at (0.08m, 0.01m) inertia 0.001(kg*m^2);
    }
}
";
    let source = written("robot.rs", drawing);
    let model = written("robot.xml", &printed(&["export", "mjcf", &source]));
    let read = written("robot_again.rs", &printed(&["import", &model]));
    let [own, again] = [&source, &read].map(|path| printed(&["export", "rust", path]));
    assert!(own == again, "{}", fs::read_to_string(read).expect("it is there"));
}

/// Without loops each joint follows the driven one, and the error of its polynomial is told.
#[test]
fn a_tree_follows_its_input() {
    let tree = |range: &str| {
        [
            "export",
            "mjcf",
            MACHINES,
            "--machine",
            "HeavyToggle",
            "--inputs",
            "crank_side",
            "--tree",
            "--between",
        ]
        .into_iter()
        .map(str::to_string)
        .chain([range.to_string()])
        .collect::<Vec<_>>()
    };
    let arguments = tree("theta=20deg..40deg");
    let text = printed(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(!text.contains("<connect") && text.matches("polycoef=").count() == 4, "{text}");
    for worst in text.split("off by at most ").skip(1) {
        let worst: f64 = worst.split(' ').next().unwrap_or_default().parse().expect("a number");
        // The error of degree four goes with the fifth power of the range.
        assert!(worst > 1e-9 && worst < 1e-4, "{worst}");
    }
    let arguments = tree("theta=-20deg..100deg");
    let told = refused(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(
        told.contains("is off by") || told.contains("reach") || told.contains("limit"),
        "{told}"
    );
    let told = refused(&[
        "export",
        "mjcf",
        MACHINES,
        "--machine",
        "HeavyFiveBar",
        "--inputs",
        "motors",
        "--tree",
    ]);
    assert!(told.contains("follows one input"), "{told}");
}

const BODY: &str =
    "<body name=\"a\"><joint name=\"a.angle\" axis=\"0 1 0\"/><site name=\"a.P\" pos=\"1 0 0\"/>";

#[test]
fn what_is_not_planar_is_told() {
    let model = |inside: &str, beside: &str| {
        let text = format!("<mujoco model=\"m\"><worldbody>{inside}</worldbody>{beside}</mujoco>");
        refused(&["import", &written("mistake.xml", &text)])
    };
    let second =
        |joint: &str| format!("{BODY}<body name=\"b\" pos=\"1 0 0\">{joint}</body></body>");
    for (inside, beside, expected) in [
        (second("<joint axis=\"0 0 1\"/>"), "", "the axes of `a.angle` and `b.joint` differ"),
        (second("<joint type=\"ball\"/>"), "", "the joint of `b` is a `ball`"),
        (second("<joint axis=\"0 1 0\"/><joint axis=\"0 1 0\"/>"), "", "`b` has several joints"),
        (second("<freejoint/>"), "", "`b` moves freely"),
        (second("<joint type=\"slide\" axis=\"0 1 0\"/>"), "", "slides out of the plane"),
        (
            second("<joint name=\"b.angle\" axis=\"0 1 0\"/>"),
            "<equality><joint joint1=\"b.angle\" joint2=\"a.angle\" polycoef=\"0 1 1 0 0\"/></equality>",
            "is a polynomial over degree one",
        ),
        (
            format!("{BODY}</body>"),
            "<tendon><spatial name=\"t\"><site site=\"a.P\"/></spatial></tendon><actuator><motor tendon=\"t\"/></actuator>",
            "goes through other than two sites",
        ),
        (
            format!("{BODY}</body>"),
            "<actuator><motor name=\"m\" joint=\"b\"/></actuator>",
            "`m` moves no joint `b`",
        ),
        (BODY.to_string(), "", "`</worldbody>` closes nothing"),
        (
            "<body name=\"a\"><joint axis=\"x y z\"/></body>".to_string(),
            "",
            "is no list of numbers",
        ),
        ("<body name=\"a\"><joint type=\"slide\"/></body>".to_string(), "", "there is no hinge"),
    ] {
        let told = model(&inside, beside);
        assert!(told.contains(expected), "{inside}: {told}");
    }
}

/// A gripper of two fingers, each held by a spring, in degrees and by classes, welded parts and a `connect` of bodies.
#[test]
fn a_gripper_of_others_is_read() {
    let text = "<?xml version=\"1.0\"?>
<mujoco model=\"gripper\">
  <default><default class=\"finger\"><joint axis=\"0 1 0\" damping=\"0.1\"/></default></default>
  <worldbody>
    <body name=\"base\">
      <body name=\"driver\" pos=\"0.03 0 0\" childclass=\"finger\">
        <joint name=\"driver_joint\" range=\"0 50\"/>
        <inertial pos=\"0.01 0 0.01\" mass=\"0.01\" diaginertia=\"1e-5 2e-5 3e-5\"/>
        <body name=\"coupler\" pos=\"0.02 0 0.03\"><joint name=\"coupler_joint\"/>
          <inertial pos=\"0 0 0.02\" mass=\"0.01\" diaginertia=\"1e-5 1e-5 1e-5\"/>
          <body name=\"pad\" pos=\"0 0 0.05\"><inertial pos=\"0 0 0\" mass=\"0.005\" diaginertia=\"1e-6 1e-6 1e-6\"/></body>
        </body>
      </body>
      <body name=\"spring_link\" pos=\"0.01 0 0.02\" childclass=\"finger\">
        <joint name=\"spring_link_joint\" stiffness=\"0.05\" springref=\"15\"/>
        <inertial pos=\"0.01 0 0.01\" mass=\"0.01\" diaginertia=\"1e-5 1e-5 1e-5\"/>
        <body name=\"follower\" pos=\"0.02 0 0.03\"><joint name=\"follower_joint\"/>
          <inertial pos=\"0 0 0.01\" mass=\"0.01\" diaginertia=\"1e-5 1e-5 1e-5\"/></body>
      </body>
    </body>
  </worldbody>
  <equality><connect body1=\"coupler\" body2=\"follower\" anchor=\"0 0 0.04\"/></equality>
  <actuator><position name=\"close\" joint=\"driver_joint\"/></actuator>
</mujoco>";
    let read = printed(&["import", &written("gripper.xml", text)]);
    // The axis is −y of the drawing, so that angles count the other way.
    assert!(read.contains("input close = -driver.angle;"), "{read}");
    assert!(read.contains("input spring_link_joint = -spring_link.angle;"), "{read}");
    assert!(read.contains("Left out: the range of driver_joint."), "{read}");
    assert!(read.contains("mass 0.005kg on coupler"), "{read}");
    assert!(read.contains("on driver at") && read.contains("inertia 0.00002(kg*m^2)"), "{read}");
    let source = written("gripper.rs", &read);
    assert!(
        printed(&["check", &source]).is_empty() || linkage(&["check", &source]).status.success()
    );
}
