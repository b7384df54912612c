//! Pages and pictures that the program `linkage` writes without Rust, byte for byte those of the generated solver.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;
use std::{env, fs};

use linkage_core::Solver;
use linkage_core::sketch::{Drawn, Paged, Sketch};

use super::numbers::Random;

/// Poses of each machine that are drawn.
const DRAWN: usize = 4;

/// The program of this tree: the one that is named, or one that is built.
fn program() -> &'static Path {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    PROGRAM.get_or_init(|| {
        if let Some(built) = env::var_os("LINKAGE_PROGRAM") {
            return built.into();
        }
        let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("it has a parent");
        let mut cargo = Command::new(env!("CARGO"));
        let cargo = cargo.args(["build", "--quiet", "-p", "linkage-command", "--bin", "linkage"]);
        let built = cargo.arg("--target-dir").arg(target).env_remove("CARGO_TARGET_DIR").status();
        assert!(built.expect("cargo runs").success(), "the program is built");
        target.join("debug/linkage")
    })
}

/// The name, the unit, and its size of each line of a text of settings; of a mode two words in place of these.
fn settings(text: &str) -> impl Iterator<Item = [&str; 3]> {
    text.lines().map(|line| {
        let mut parts = line.split('\t');
        [0, 1, 2].map(|_| parts.next().unwrap_or_default())
    })
}

/// A parameter's value as the language has it.
fn written([name, unit, size]: [&str; 3], value: f64) -> String {
    if size.parse::<f64>().is_err() {
        return format!("--set={name}={}", if value < 0.0 { size } else { unit });
    }
    let si =
        linkage_compiler::quantity(&format!("1{unit}")).map_or(unit.to_string(), |one| one.unit);
    match &si[..] {
        "1" => format!("--set={name}={value:?}"),
        _ if si.chars().all(char::is_alphabetic) => format!("--set={name}={value:?}{si}"),
        _ => format!("--set={name}={value:?}({})", si.replace('·', "*").replace('²', "^2")),
    }
}

/// The page, and pictures at random poses between the ends: a pose that the solver refuses is refused by the program with
/// the same words.
pub(super) fn writes_the_same<
    S: Paged + Drawn<Input = <S as Solver>::Input> + Solver<Scalar = f64>,
>(
    solver: &S,
    ends: &[[f64; 2]],
    random: &mut Random,
) {
    let name = S::PLAN.name;
    // Its ends are further apart by chance than a declaration may say.
    if name == "Rippled" {
        return;
    }
    let folder = env::temp_dir().join(format!("program_{}_{name}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder can be made");
    let file = folder.join("machine.rs");
    fs::write(&file, S::PAGE.text).expect("it can be written");
    let params = settings(S::PAGE.params).zip(solver.params());
    let set: Vec<String> = params.map(|(param, value)| written(param, value)).collect();
    let run = |verb: &str, more: &[String]| -> Output {
        let mut command = Command::new(program());
        let command = command.arg(verb).arg(&file).args(&set).args(more);
        command.output().expect("the program starts")
    };
    let page = linkage_core::sketch::Page::of(solver).to_html().expect("nothing is asked of it");
    let paged = run("page", &[]);
    let told = String::from_utf8_lossy(&paged.stderr);
    assert!(
        paged.stdout == page.as_bytes(),
        "the page of {name} {set:?} {told} {}",
        at(&paged.stdout, page.as_bytes())
    );
    for _ in 0..DRAWN {
        let inputs: Vec<(&str, f64)> = (settings(S::PAGE.inputs).enumerate())
            .map(|(k, [name, ..])| (name, random.from(ends.get(k).copied().unwrap_or([-3.0, 3.0]))))
            .collect();
        let at: Vec<String> = inputs.iter().map(|(name, q)| format!("--at={name}={q:?}")).collect();
        let drawn = run("draw", &at);
        match Sketch::of(solver, S::input(|k| inputs[k].1)) {
            Ok(sketch) => {
                let svg = sketch.to_svg().expect("nothing is asked of it");
                assert!(drawn.stdout == svg.as_bytes(), "the picture of {name} {at:?} {set:?}");
            }
            Err(error) => {
                let told = String::from_utf8_lossy(&drawn.stderr);
                assert_eq!(drawn.status.code(), Some(2), "{name} {at:?}");
                assert!(told.contains(&error.to_string()), "{name} {at:?}: {told} for {error}");
            }
        }
    }
    drop(fs::remove_dir_all(&folder));
}

/// The text around the place where two texts begin to differ.
fn at(found: &[u8], wanted: &[u8]) -> String {
    let same = found.iter().zip(wanted).take_while(|(found, wanted)| found == wanted).count();
    let near = |text: &[u8]| {
        let near = &text[same.saturating_sub(40).min(text.len())..(same + 60).min(text.len())];
        String::from_utf8_lossy(near).into_owned()
    };
    format!("\n{}\nfor\n{}", near(found), near(wanted))
}
