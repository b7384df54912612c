//! Pages that the program writes: those of Rust, byte for byte.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

include!("data/shear.rs");
include!("data/five_bar.rs");
include!("data/one_set.rs");

fn linkage(arguments: &[&str]) -> Output {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command.args(arguments).current_dir(data).output().expect("the program starts")
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

fn told(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// `page` with these flags, into a file of its own.
fn page(name: &str, flags: &[&str]) -> Result<String, String> {
    let file = folder(name).join("page.html");
    let file_name = file.to_str().expect("it is a text");
    let fixed = ["page", "shear.rs", "-o", file_name, "--machine", "Shear"];
    let output = linkage(&[&fixed, flags].concat());
    match output.status.code() {
        Some(0) => Ok(fs::read_to_string(file).expect("it was written")),
        code => {
            assert!(!file.exists(), "a mistake leaves a page: {flags:?}");
            assert_eq!(code, Some(2), "{flags:?}");
            Err(told(&output.stderr))
        }
    }
}

#[test]
fn a_page_is_the_one_that_rust_writes() {
    let folder = folder("both");
    let output = linkage(&["page", "shear.rs", "-o", folder.to_str().expect("it is a text")]);
    assert!(output.status.success(), "{}", told(&output.stderr));
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect("it is there");
    assert_eq!(read("Shear.html"), Shear::new().page().to_html().expect("it can be drawn"));
    assert_eq!(read("Lift.html"), Lift::new().page().to_html().expect("it can be drawn"));
    // The text is the call, with its comments.
    assert!(read("Shear.html").contains("/* and } here */\\u000a}\""));
    let stale = linkage(&["page", "shear.rs", "-o", folder.to_str().unwrap(), "--stale"]);
    assert!(stale.status.success(), "{}", told(&stale.stderr));
    fs::write(folder.join("Lift.html"), "old").expect("it can be written");
    let stale = linkage(&["page", "shear.rs", "-o", folder.to_str().unwrap(), "--stale"]);
    assert_eq!(stale.status.code(), Some(1));
    assert!(told(&stale.stderr).contains("Lift.html` is stale"), "{}", told(&stale.stderr));
    assert_eq!(read("Lift.html"), "old");
}

/// One page has all sets of inputs of a machine, and flags name what any of them has.
#[test]
fn sets_of_inputs_share_a_page() {
    let file = folder("sets").join("page.html");
    let page = |flags: &[&str]| {
        let fixed = ["page", "five_bar.rs", "-o", file.to_str().expect("it is a text")];
        let output = linkage(&[&fixed, flags].concat());
        match output.status.success() {
            true => Ok(fs::read_to_string(&file).expect("it was written")),
            false => Err(told(&output.stderr)),
        }
    };
    let robot = FiveBar::new();
    assert_eq!(page(&[]), Ok(robot.page().to_html().expect("it can be drawn")));
    let flags = ["--between", "x=-3cm..3cm", "--between", "a=90deg..180deg", "--rate", "y=0.1"];
    let half = std::f64::consts::FRAC_PI_2;
    let wished = robot.page().range("x", -0.03..=0.03).range("a", half..=2.0 * half).rate("y", 0.1);
    assert_eq!(page(&flags), Ok(wished.to_html().expect("it can be drawn")));
    // One set alone is a page as before.
    let one = robot.hand().page().to_html().expect("it can be drawn");
    let sets = linkage_core::sketch::shortened("const SETS = [");
    assert!(wished.to_html().is_ok_and(|page| page.contains(&sets)) && !one.contains(&sets));
    assert_eq!(page(&["--inputs", "hand"]), Ok(one));
    let one_set = linkage(&["page", "one_set.rs", "-o", file.to_str().expect("it is a text")]);
    assert!(one_set.status.success(), "{}", told(&one_set.stderr));
    let page_of_arm = Arm::new().page().to_html().expect("it can be drawn");
    assert_eq!(fs::read_to_string(&file).expect("it was written"), page_of_arm);
    let mistake = page(&["--between", "z=1mm..2mm"]).expect_err("none has it");
    assert!(mistake.contains("is named `z`: `a`, `b`, `x`, `y`, `upper`"), "{mistake}");
    let mistake = robot.page().range("z", 0.0..=1.0).to_html().expect_err("none has it");
    assert!(mistake.to_string().contains("`z`"), "{mistake}");
}

#[test]
fn flags_say_what_rust_says() {
    let flags = ["--title", "A <shear>", "--set", "crank=2 * 4.5cm", "--set", "side=left"];
    let more =
        ["--between", "theta=-90deg..1.5", "--rate", "theta=12(rad/s)", "--load", "cut=10kN"];
    let curves = ["--curves", "blade,theta.drive", "--between", "crank=5cm..0.2"];
    let found = page("flags", &[&flags[..], &more, &curves].concat()).expect("all is well");
    let quarter = std::f64::consts::FRAC_PI_2;
    let shear = Shear { crank: 0.09, side: linkage_core::Side::Left };
    let page = shear.page().title("A <shear>").range("theta", -quarter..=1.5).rate("theta", 12.0);
    let page = page.load("cut", 1e4).curves(["blade", "theta.drive"]).range("crank", 0.05..=0.2);
    assert_eq!(found, page.to_html().expect("it can be drawn"));
}

/// Each mistake ends with 2, writes nothing, and says what is wrong with which flag.
#[test]
fn mistaken_flags_are_told() {
    for (flags, said) in [
        (["--load", "cut"], "`--load cut` sets nothing: write `--load NAME=VALUE`"),
        (["--load", "cat=9N"], "no load is named `cat`: `cut`"),
        (["--set", "cran=9mm"], "no parameter is named `cran`; there are crank, side"),
        (["--load", "cut=9N; ground Z(0, 0)"], "is no value"),
        (["--load", "cut=1 }"], "is no value"),
        (["--load", "cut=9 furlong"], "`--load cut=9 furlong`"),
        (["--load", "cut=theta"], "`--load cut=theta`"),
        (["--between", "side=0..1"], "write `FROM..TO`"),
        (["--rate", "theta=90deg"], "`--rate theta=90deg`: this is in rad, and `theta` is in 1/s"),
        (["--rate", "cut=1"], "no input is named `cut`: `theta`"),
        (["--load", "cut=1m"], "this is in m, and `cut` is in N"),
        (["--between", "theta=1"], "write `FROM..TO`"),
        (["--between", "theta=1..1"], "the first end is not below the second"),
        (["--between", "theta=0..1m"], "this is in m, and `theta` is in rad"),
        (["--curves", "blad"], "no output named `blad`; the nearest name is `blade`"),
    ] {
        let found = page("mistaken", &flags).expect_err(flags[1]);
        assert!(found.contains(said), "{flags:?}: {found}");
    }
}
