//! The texts of the example `plc`, and the program's arguments.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use super::evaluator::Machine;
use super::poses::told;
use super::reader::Project;
use super::{folder, root};

/// Arguments behind `export st`.
fn linkage(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command
        .args(["export", "st"])
        .args(arguments)
        .current_dir(root())
        .output()
        .expect("the program starts")
}

/// The commands by which the example was printed, each as its head says.
const EXAMPLES: [[&str; 5]; 2] = [
    ["examples/c_controller/shear.rs", "-o", "examples/plc", "--only", "motion"],
    [
        "linkage-macros/command/tests/data/press.rs",
        "-o",
        "examples/plc",
        "--only",
        "motion,forces,f64",
    ],
];

#[test]
fn the_example_is_what_is_printed_today() {
    for arguments in EXAMPLES {
        let output = linkage(&[&arguments[..], &["--stale"]].concat());
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{told}: `linkage export st {}`", arguments.join(" "));
    }
    let place = folder("stale");
    fs::create_dir_all(&place).expect("a folder can be made");
    let stale =
        linkage(&["examples/c_controller/shear.rs", "-o", &place.display().to_string(), "--stale"]);
    assert_eq!(stale.status.code(), Some(1));
    assert!(fs::read_dir(&place).expect("it is there").next().is_none(), "nothing is written");
}

fn example(name: &str) -> Project {
    let read = |name: &str| {
        fs::read_to_string(root().join("examples/plc").join(name)).expect("it is there")
    };
    let mut project = Project::default();
    project.read(&read("linkage_run.st"));
    project.read(&read(name));
    project
}

/// The numbers of the manual's example, by the function blocks of the example.
#[test]
fn the_shear_moves_as_the_manual_says() {
    let project = example("flying_shear.st");
    let machine = Machine { project: &project };
    let block = &project.units["FLYING_SHEAR_MOTION"];
    let answer = told(&machine, block, &[4.7, 12.0, 0.0]).expect("it goes on");
    assert_eq!(answer.status, 0);
    let [x, y] = [answer.numbers[0], answer.numbers[1]];
    assert!((x - 0.4205).abs() < 5e-5 && (y + 0.3555).abs() < 5e-5, "{x} {y}");
    let none = told(&machine, block, &[f64::NAN, 12.0, 0.0]).expect("it goes on");
    assert_eq!((none.status, &none.refused[..]), (-1, "theta"));
    let narrow = told(&machine, &project.units["FLYING_SHEAR_MOTION_F32"], &[4.7, 12.0, 0.0]);
    let narrow = narrow.expect("it goes on").numbers;
    assert!((narrow[0] - x).abs() < 1e-6, "{narrow:?}");
}

/// A rod that is shorter than the crank reaches the guide in some poses alone, and the group is named.
#[test]
fn a_group_without_a_pose_is_named_by_its_number() {
    let project = example("press.st");
    let machine = Machine { project: &project };
    let block = &project.units["PRESS_MOTION"];
    let at = |theta, rod| told(&machine, block, &[2.0, rod, theta, 1.0, 0.0]).expect("it goes on");
    let answer = at(0.0, 0.05);
    assert_eq!((answer.status, &answer.refused[..]), (2, "BC, ram"));
    assert!(answer.numbers.iter().all(|number| *number == 0.0));
    assert_eq!((at(0.0, 0.4).status, at(0.0, -0.4).status), (0, 2));
}

fn printed(name: &str, more: &[&str]) -> Vec<(String, String)> {
    let place = folder(name);
    let _ = fs::remove_dir_all(&place);
    let place_text = place.display().to_string();
    let output = linkage(&[&["examples/c_controller/shear.rs", "-o", &place_text], more].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let entries =
        fs::read_dir(&place).expect("it was made").map(|entry| entry.expect("a file").path());
    let name = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mut files: Vec<_> =
        entries.map(|path| (name(&path), fs::read_to_string(&path).expect("a text"))).collect();
    files.sort();
    files
}

#[test]
fn a_prefix_stands_in_front_of_all_that_a_project_shares() {
    let files = printed("prefix", &["--prefix", "acme", "--only", "motion"]);
    let names: Vec<&str> = files.iter().map(|(name, _)| &name[..]).collect();
    assert_eq!(names, ["acme_flying_shear.st", "acme_linkage_run.st"]);
    for (name, text) in &files {
        let mut project = Project::default();
        if name == names[0] {
            project.read(&files[1].1);
        }
        project.read(text);
        let shared = project.units.keys().all(|unit| unit.starts_with("ACME_"));
        assert!(shared && !text.contains(" LinkagePoint"), "{name}");
        assert!(text.contains("AcmeLinkagePoint"), "{name}");
    }
}

#[test]
fn sines_are_the_controllers_where_that_is_asked_for() {
    let files = printed("sines", &["--sines", "controller", "--only", "position,f64"]);
    let text = &files[0].1;
    assert!(text.contains("a_sine := SIN((theta));") && text.contains("a_cosine := COS((theta));"));
    assert!(!text.contains("linkage_sin_cos") && text.contains("are the controller's"));
    assert!(!text.contains("REAL;\n") || !text.contains(": REAL;"), "one width alone");
    let own = printed("own_sines", &["--sines", "printed", "--only", "position,f64"]);
    assert!(
        own[0].1.contains("linkage_sin_cos(x := theta, to_sine := a_sine, to_cosine := a_cosine)")
    );
}

/// The origin and what the statuses mean stand in the head.
#[test]
fn the_head_tells_the_origin_and_every_status() {
    let files = printed("head", &["--only", "position,f64"]);
    let text = &files[0].1;
    let c = Command::new(env!("CARGO_BIN_EXE_linkage"))
        .args(["export", "c", "examples/c_controller/shear.rs", "-o"])
        .arg(folder("head_c"))
        .current_dir(root())
        .output();
    assert!(c.expect("the program starts").status.success());
    let header =
        fs::read_to_string(folder("head_c").join("flying_shear.h")).expect("it was written");
    let hash = header
        .split("#define FLYING_SHEAR_DECLARATION \"")
        .nth(1)
        .and_then(|rest| rest.split('"').next());
    assert!(text.contains(hash.expect("the header has a hash")), "{text}");
    for part in [
        concat!("printed by linkage ", env!("CARGO_PKG_VERSION")),
        "\n      0  there is an answer\n     -1  the input, ",
        "Next to a limit a block answers or refuses as the fast path of the solver does",
    ] {
        assert!(text.contains(part), "no `{part}` in\n{text}");
    }
}

#[test]
fn flags_of_structured_text_belong_to_it() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command
        .args(["export", "c", "examples/c_controller/shear.rs", "--sines", "controller"])
        .current_dir(root());
    let output = command.output().expect("the program starts");
    assert_eq!(output.status.code(), Some(2));
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(told.contains("`--sines` belongs to `export st`"), "{told}");
}
