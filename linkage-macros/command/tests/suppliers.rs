//! Printed C in a project: mechanisms of one name from two suppliers in one program, a folder with another version's
//! run-time, and a build that fails where what stands there is stale.

#[path = "../../../tests/skipped.rs"]
mod skipped;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use skipped::skipped;

/// An arm of this length.
fn arm(length: &str) -> String {
    format!(
        "mechanism! {{ /// An arm.\n pub struct Arm {{ input theta: angle; ground A(0, 0);
         crank AB(A) -> B {{ length: {length}, angle: theta }} output B, AB; }} }}"
    )
}

fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("suppliers").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    for (name, text) in files {
        fs::write(folder.join(name), text).expect("a file can be written");
    }
    folder
}

fn linkage(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command.args(arguments).current_dir(folder).output().expect("the program starts")
}

fn printed(folder: &Path, arguments: &[&str]) {
    let output = linkage(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Messages of a strict compiler about sources; none without one.
fn compiled(folder: &Path, sources: &[&str], program: &str) -> Option<Output> {
    let strict =
        ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Werror"];
    let more = ["-Wredundant-decls", "-Wmissing-prototypes", "-O2", "-Iout"];
    let mut command = Command::new("cc");
    command.args(strict).args(more).args(sources).args(["-lm", "-o", program]).current_dir(folder);
    let output = command.output().ok();
    if output.is_none() {
        skipped("two suppliers in one program: no cc");
    }
    output
}

const BOTH: &str = "\
#include <stdio.h>
#include \"left_arm.h\"
#include \"right_hand_arm.h\"

int main(void)
{
    LeftArmPosition left;
    RightHandArmPosition right;
    const int status = left_arm_position(6.0, &left, NULL) | right_hand_arm_position(6.0, &right, NULL);
    printf(\"%d %.17g %.17g %s|%s\\n\", (int)status, left.B.x, right.B.x, left_arm_origin, right_hand_arm_origin);
    printf(\"%s %s %s %d\\n\", left_arm_input_labels[0], left_arm_output_labels[1],
           left_arm_output_labels[LEFT_ARM_OUTPUTS - 1], left_arm_output_labels[LEFT_ARM_OUTPUTS] == NULL);
    printf(\"%.17g %s\\n\", left_linkage_angle_near(left.AB.cos, left.AB.sin, 100.0),
           right_hand_linkage_status_text(LINKAGE_OUT_OF_REACH));
    printf(\"%s %s %s\\n\", LINKAGE_VERSION, LEFT_ARM_DECLARATION, RIGHT_HAND_ARM_DECLARATION);
    return 0;
}
";

/// One of them has the run-time of another version, whose functions would not do for the other's sources.
#[test]
fn two_suppliers_stand_in_one_program() {
    let (left, right) = (arm("500mm"), arm("300mm"));
    let folder = folder("both", &[("left.rs", &left), ("right.rs", &right), ("main.c", BOTH)]);
    printed(&folder, &["export", "c", "left.rs", "-o", "out", "--prefix", "left"]);
    printed(&folder, &["export", "c", "right.rs", "-o", "out", "--prefix", "Right_Hand"]);
    for name in ["right_hand_arm.c", "right_hand_linkage_run.h", "right_hand_linkage_run.c"] {
        of_another_version(&folder.join("out").join(name));
    }
    let own = ["arm", "linkage_run"];
    let sources = ["left", "right_hand"].map(|prefix| own.map(|of| format!("out/{prefix}_{of}.c")));
    let sources = sources.concat();
    let sources: Vec<&str> = sources.iter().map(String::as_str).chain(["main.c"]).collect();
    let Some(output) = compiled(&folder, &sources, "both") else { return };
    assert!(output.status.success(), "{}", errors(&output));
    let output = Command::new(folder.join("both")).output().expect("it starts");
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    let lines: Vec<&str> = told.lines().collect();
    let hash = |prefix: &str| {
        let header =
            fs::read_to_string(folder.join(format!("out/{prefix}_arm.h"))).expect("it is there");
        let line = header.lines().find(|line| line.contains("_ARM_DECLARATION "));
        line.and_then(|line| line.split('"').nth(1)).expect("it has a hash").to_string()
    };
    let [left, right] = ["left", "right_hand"].map(hash);
    assert_ne!(left, right);
    let version = env!("CARGO_PKG_VERSION");
    let cos = 6.0_f64.cos();
    let origins =
        format!("linkage {version} LeftArm {left}|linkage {version} RightHandArm {right}");
    let first: Vec<&str> = lines[0].splitn(4, ' ').collect();
    assert_eq!([first[0], first[3]], ["0", &origins]);
    for (word, length) in [(first[1], 0.5), (first[2], 0.3)] {
        let x: f64 = word.parse().expect("a number");
        assert!((x - length * cos).abs() < 1e-15, "{told}");
    }
    assert_eq!(lines[1], "theta B.y AB.angle 1");
    // 100 rad is 15 turns and 5.752 rad: the nearest is 6 rad and 15 turns.
    let (near, words) = lines[2].split_once(' ').expect("two words");
    let turned = 6.0 + 15.0 * std::f64::consts::TAU;
    assert!((near.parse::<f64>().expect("a number") - turned).abs() < 1e-13, "{told}");
    assert!(words.starts_with("out of reach: "), "{told}");
    assert_eq!(lines[3], format!("{version} {left} {right}"));
}

/// The run-time, or a source, as another version would have printed it.
fn of_another_version(path: &Path) {
    let text = fs::read_to_string(path).expect("it was printed");
    let hash = text.find("LINKAGE_RUN_TIME").and_then(|at| text[at..].find("0x").map(|by| at + by));
    let at = hash.expect("it has the run-time's hash");
    let other = text.replace(&text[at..at + 11], "0x00000001u");
    assert_ne!(other, text);
    fs::write(path, other).expect("it can be written");
}

#[test]
fn a_run_time_of_another_version_is_not_overwritten() {
    let folder = folder(
        "versions",
        &[("old.rs", &arm("500mm").replace("Arm", "Old")), ("arm.rs", &arm("1m"))],
    );
    printed(&folder, &["export", "c", "old.rs", "-o", "out"]);
    printed(&folder, &["export", "c", "arm.rs", "-o", "out"]);
    let old = ["old.c", "linkage_run.h", "linkage_run.c"].map(|name| folder.join("out").join(name));
    old.iter().for_each(|path| of_another_version(path));
    let before = old.each_ref().map(|path| fs::read(path).expect("it is there"));
    // As it stands the source of this version and the run-time of the other are refused by the compiler.
    if let Some(output) = compiled(&folder, &["-c", "out/arm.c"], "arm.o") {
        let errors = errors(&output);
        assert!(
            !output.status.success() && errors.contains("by another version than this file"),
            "{errors}"
        );
    }
    let output = linkage(&folder, &["export", "c", "arm.rs", "-o", "out"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        errors(&output).contains("`out/old.c` was printed by another version"),
        "{}",
        errors(&output)
    );
    assert_eq!(old.each_ref().map(|path| fs::read(path).expect("it is there")), before);
    // Names of its own, another folder, or both of them anew.
    printed(&folder, &["export", "c", "arm.rs", "-o", "out", "--prefix", "new"]);
    printed(&folder, &["export", "c", "arm.rs", "-o", "other"]);
    assert_eq!(old.each_ref().map(|path| fs::read(path).expect("it is there")), before);
    fs::remove_file(&old[0]).expect("it is there");
    printed(&folder, &["export", "c", "arm.rs", "-o", "out"]);
    printed(&folder, &["export", "c", "old.rs", "-o", "out"]);
}

#[test]
fn a_prefix_is_words_of_letters() {
    let folder = folder("prefix", &[("arm.rs", &arm("500mm"))]);
    for (arguments, status, words) in [
        (["export", "c", "arm.rs", "--prefix", "2x"], 1, "`2x` is no prefix"),
        (["export", "c", "arm.rs", "--prefix", ""], 1, "`` is no prefix"),
        (["export", "fmu", "arm.rs", "--prefix", "a"], 2, "`--prefix` belongs to `export c`"),
    ] {
        let output = linkage(&folder, &arguments);
        assert_eq!(output.status.code(), Some(status));
        assert!(errors(&output).contains(words), "{}", errors(&output));
    }
    assert!(!folder.join("arm.c").exists());
}

/// The rule of the manual: objects wait for a comparison of what is printed with the declaration.
const MAKEFILE: &str = "\
arm.o: fresh
\tcc -std=c99 -O2 -c out/arm.c -o arm.o
.PHONY: fresh
fresh:
\t$(LINKAGE) export c arm.rs -o out --stale
";

#[test]
fn a_build_fails_on_a_stale_file() {
    let folder = folder("build", &[("arm.rs", &arm("500mm")), ("Makefile", MAKEFILE)]);
    let built = || {
        let mut command = Command::new("make");
        command.env("LINKAGE", env!("CARGO_BIN_EXE_linkage")).current_dir(&folder).output().ok()
    };
    let Some(output) = built() else {
        return skipped("a build that fails on a stale file: no make");
    };
    assert!(
        !output.status.success()
            && errors(&output).contains("`out/arm.c` is stale: it is not there")
    );
    printed(&folder, &["export", "c", "arm.rs", "-o", "out"]);
    let output = built().expect("it started before");
    assert!(output.status.success(), "{}", errors(&output));
    // Layout changes nothing, a dimension does.
    fs::write(folder.join("arm.rs"), arm("500mm").replace("; ", ";\n\n")).expect("it is written");
    assert!(built().expect("it started before").status.success());
    fs::write(folder.join("arm.rs"), arm("501mm")).expect("it is written");
    fs::remove_file(folder.join("arm.o")).expect("it was built");
    let output = built().expect("it started before");
    let errors = errors(&output);
    assert!(
        !output.status.success() && errors.contains("`out/arm.c` is stale: it is not what"),
        "{errors}"
    );
    assert!(!folder.join("arm.o").exists());
}
