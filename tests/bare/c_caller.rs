//! The C functions of `export c;`: the same bits as from Rust, for every kind of entry point, and a
//! status for every mistake of the caller's.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use super::build::{directory, library, sources, text};
use super::mechanisms::{
    self, Excavator, FlyingShear, HeavyPress, HeavyRobot, SearchedPress, TunedFourBar, WattSixBar,
};
use linkage_core::{Side, SolveError};

/// Compiles a C program against the library and runs it.
fn run_c(library: &Path, source: &Path) -> Output {
    let program = library.with_extension("program");
    let output = Command::new("gcc")
        .args(["-std=c11", "-Wall", "-Wextra", "-pedantic", "-Werror", "-O1", "-I"])
        .arg(&*INCLUDES)
        .arg(source)
        .arg(library)
        .args(["-Wl,--gc-sections", "-o"])
        .arg(&program)
        .output()
        .expect("gcc starts");
    assert!(output.status.success(), "{}", text(&output.stderr));
    Command::new(&program).output().expect("the program starts")
}

/// The file name and the text of every header.
const HEADERS: [(&str, &str); 12] = [
    ("flying_shear.h", FlyingShear::C_HEADER),
    ("watt_six_bar.h", WattSixBar::C_HEADER),
    ("tuned_four_bar.h", TunedFourBar::C_HEADER),
    ("slider_crank.h", mechanisms::SliderCrank::C_HEADER),
    ("six_bar.h", mechanisms::SixBar::C_HEADER),
    ("crossed_guides.h", mechanisms::CrossedGuides::C_HEADER),
    ("excavator.h", Excavator::C_HEADER),
    ("everything.h", mechanisms::Everything::C_HEADER),
    ("heavy_press.h", HeavyPress::C_HEADER),
    ("heavy_robot.h", HeavyRobot::C_HEADER),
    ("driven_four_bar.h", mechanisms::DrivenFourBar::C_HEADER),
    ("searched_press.h", SearchedPress::C_HEADER),
];

/// Where the headers are, written once: tests run side by side.
static INCLUDES: LazyLock<PathBuf> = LazyLock::new(|| {
    let directory = directory();
    for (name, header) in HEADERS {
        fs::write(directory.join(name), header).expect("the tests' directory can be written");
    }
    directory
});

/// The program's lines, as Rust computes them.
#[derive(Default)]
struct Report(String);

impl Report {
    /// An answer, or an untouched one of the same size and the reason.
    fn add<A: Copy>(&mut self, function: &str, result: Result<A, SolveError>) {
        let (status, by, group, name) = match result {
            Ok(_) => (0, 0.0, "", ""),
            Err(SolveError::OutOfReach { group, by }) => (1, by, group, ""),
            Err(SolveError::Singular { group }) => (2, 0.0, group, ""),
            Err(SolveError::Invalid { group, name }) => (3, 0.0, group, name),
            Err(SolveError::NotFinite { name }) => (4, 0.0, "", name),
            Err(SolveError::OffCircle { name, .. }) => (7, 0.0, "", name),
            Err(SolveError::NoSolution { unknown, by, .. }) => (8, by, "", unknown),
            Err(SolveError::SeveralDeadPoints { unknown }) => (9, 0.0, "", unknown),
            Err(SolveError::Jams { joint }) => (10, 0.0, "", joint),
            Err(error) => panic!("{error} has no status"),
        };
        let bytes = match &result {
            Ok(answer) => hexadecimal(bytes(answer)),
            Err(_) => "a5".repeat(size_of::<A>()),
        };
        let by = hexadecimal(&by.to_ne_bytes());
        let _ = writeln!(self.0, "{function} {status} {status} {by} [{group}] [{name}] {bytes}");
    }
}

/// The memory of an answer.
fn bytes<A: Copy>(answer: &A) -> &[u8] {
    // SAFETY: answers are records and lists of numbers of one width, without padding.
    unsafe { core::slice::from_raw_parts(core::ptr::from_ref(answer).cast(), size_of::<A>()) }
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// Every entry point of the flying shear in one width.
macro_rules! shear {
    ($report:ident, $number:ident, $suffix:literal, $theta:expr) => {{
        let (shear, theta) = (FlyingShear::<$number>::default(), $theta);
        let (cos, sin, rate, acceleration) = (0.28, 0.96, 12.0, -3.0);
        let add = |name: &str| format!("flying_shear_{name}{}", $suffix);
        $report.add(&add("position"), shear.position(theta));
        $report.add(&add("velocity"), shear.velocity(theta, rate));
        $report.add(&add("motion"), shear.motion(theta, rate, acceleration));
        $report.add(&add("position_at"), shear.position_at(cos, sin));
        $report.add(&add("velocity_at"), shear.velocity_at(cos, sin, rate));
        $report.add(&add("motion_at"), shear.motion_at(cos, sin, rate, acceleration));
        $report.add(&add("margins"), shear.margins(theta));
        $report.add(&add("coefficients"), shear.coefficients(theta));
    }};
}

/// One angle within the reach of the sine's kernel, and one beyond it.
fn six_bar(report: &mut Report, theta: f64) {
    let (wide, narrow) = (WattSixBar::new(), WattSixBar::<f32>::default());
    report.add("watt_six_bar_motion", wide.motion(theta, 12.0, -3.0));
    report.add("watt_six_bar_motion", wide.motion(theta + 3e6, 12.0, -3.0));
    report.add("watt_six_bar_motion_f32", narrow.motion(theta as f32, 12.0, -3.0));
    report.add("watt_six_bar_margins", wide.margins(theta));
}

fn four_bar(report: &mut Report, theta: f64, coupler: f64, elbow: Side) {
    let wide = TunedFourBar { coupler, elbow, ..TunedFourBar::new() };
    let narrow = TunedFourBar { coupler: coupler as f32, elbow, ..TunedFourBar::<f32>::default() };
    report.add("tuned_four_bar_motion", wide.motion(theta, 2.0, 0.5));
    report.add("tuned_four_bar_motion_f32", narrow.motion(theta as f32, 2.0, 0.5));
}

fn press(report: &mut Report, theta: f64, loads: [f64; 2]) {
    let (wide, narrow) = (HeavyPress::new(), HeavyPress::<f32>::default());
    report.add("heavy_press_forces", wide.forces(theta, 3.0, -2.0, loads));
    report.add("heavy_press_statics", wide.statics(theta, loads));
    report.add("heavy_press_energy", wide.energy(theta, 3.0));
    let narrow = narrow.forces(theta as f32, 3.0, -2.0, loads.map(|load| load as f32));
    report.add("heavy_press_forces_f32", narrow);
    report.add("heavy_press_forward_dynamics", wide.forward_dynamics(theta, 3.0, 1.5, loads));
    report.add("heavy_press_equations_of_motion", wide.equations_of_motion(theta, 3.0, loads));
}

fn robot(report: &mut Report, inputs: [f64; 2]) {
    let (wide, narrow) = (HeavyRobot::new(), HeavyRobot::<f32>::default());
    let (rates, drive) = ([0.5, -0.25], [2.0, -1.0]);
    report.add("heavy_robot_forward_dynamics", wide.forward_dynamics(inputs, rates, drive));
    report.add("heavy_robot_equations_of_motion", wide.equations_of_motion(inputs, rates));
    let inputs = inputs.map(|angle| angle as f32);
    let found = narrow.forward_dynamics(inputs, [0.5, -0.25], [2.0, -1.0]);
    report.add("heavy_robot_forward_dynamics_f32", found);
    let found = narrow.equations_of_motion(inputs, [0.5, -0.25]);
    report.add("heavy_robot_equations_of_motion_f32", found);
}

fn search(report: &mut Report, inputs: [f64; 2], seed: f64) {
    let (wide, narrow) = (SearchedPress { seed }, SearchedPress::<f32> { seed: seed as f32 });
    let (rates, accelerations) = ([0.5, -0.25], [2.0, 1.0]);
    report.add("searched_press_position", wide.position(inputs));
    report.add("searched_press_motion", wide.motion(inputs, rates, accelerations));
    report.add("searched_press_forces", wide.forces(inputs, rates, accelerations));
    let velocity = narrow.velocity(inputs.map(|input| input as f32), [0.5, -0.25]);
    report.add("searched_press_velocity_f32", velocity);
    report.add("searched_press_coefficients", wide.coefficients(inputs));
}

fn excavator(report: &mut Report, inputs: [f64; 3]) {
    let (wide, narrow) = (Excavator::new(), Excavator::<f32>::default());
    let motion = wide.motion(inputs, [0.1, -0.2, 0.3], [0.01, 0.02, -0.03]);
    report.add("excavator_motion", motion);
    let velocity = narrow.velocity(inputs.map(|length| length as f32), [0.1, -0.2, 0.3]);
    report.add("excavator_velocity_f32", velocity);
    report.add("excavator_coefficients", wide.coefficients(inputs));
}

/// The caller's mistakes and their statuses. Only C can cause statuses 5 and 6.
fn mistakes() -> String {
    let mut report = Report::default();
    let position = |coupler: f64, theta| {
        TunedFourBar { coupler, elbow: Side::Right, ..TunedFourBar::new() }.position(theta)
    };
    report.add("tuned_four_bar_position", position(-0.25, 1.0));
    report.add("tuned_four_bar_position", position(f64::NAN, 1.0));
    report.add("tuned_four_bar_position", position(0.05, 3.0));
    let stretched =
        TunedFourBar { coupler: 0.2285999999999999, elbow: Side::Right, ..TunedFourBar::new() };
    report.add("tuned_four_bar_velocity", stretched.velocity(core::f64::consts::PI, 1.0));
    report.add("flying_shear_position", FlyingShear::new().position(f64::NAN));
    let shear = FlyingShear::<f32>::default();
    report.add("flying_shear_motion_f32", shear.motion(1.0, f32::INFINITY, 0.0));
    report.add("flying_shear_position_at", FlyingShear::new().position_at(0.0, 0.0));
    report.add("flying_shear_motion_at_f32", shear.motion_at(-2.0, -2.0, 1.0, 0.0));
    for part in
        [" 1 1 ", " 2 2 ", " 3 3 ", " 4 4 ", " 7 7 ", " [BC, DC] [coupler] ", " [] [theta] "]
    {
        assert!(report.0.contains(part), "no `{part}` in {}", report.0);
    }
    let caller = |function: &str, status: u8, name: &str, answer: usize| {
        let (by, answer) = ("00".repeat(8), "a5".repeat(answer));
        format!("{function} {status} {status} {by} [] [{name}] {answer}\n")
    };
    let bar = size_of_val(&TunedFourBar::new().position(1.0).expect("a pose"));
    let arm = size_of::<mechanisms::ExcavatorVelocity<f64>>();
    let before = [
        caller("tuned_four_bar_position", 5, "mechanism", bar),
        caller("excavator_velocity", 5, "inputs", arm),
        caller("excavator_velocity", 5, "rates", arm),
        caller("no_answer", 5, "position", 0),
        caller("tuned_four_bar_position", 6, "elbow", bar),
    ];
    format!("{}{}silent 5\n", before.concat(), report.0)
}

/// The expected output of the C program.
fn expected() -> String {
    let mut report = Report::default();
    for i in -12..=12_i8 {
        shear!(report, f64, "", 0.25 * f64::from(i));
        shear!(report, f32, "_f32", 0.25 * f32::from(i));
        six_bar(&mut report, 0.25 * f64::from(i));
        four_bar(&mut report, 0.25 * f64::from(i), 0.254, Side::Left);
        four_bar(&mut report, 0.25 * f64::from(i), 0.125, Side::Right);
        let by = f64::from(i);
        excavator(&mut report, [2.3125 + 0.0625 * by, 2.25 + 0.03125 * by, 1.90625 + 0.03125 * by]);
        press(&mut report, 0.25 * by, [100.0 * by, 2.5]);
        robot(&mut report, [2.0 + 0.125 * by, 1.0 - 0.0625 * by]);
        search(&mut report, [0.25 + 0.0078125 * by, 1.125 + 0.015625 * by], 1.5 + 0.25 * by);
    }
    search(&mut report, [0.25, f64::NAN], 1.0);
    search(&mut report, [0.25, 1.0], f64::NAN);
    press(&mut report, 0.5, [f64::NAN, 1.0]);
    for part in [
        "four_bar_motion 0 ",
        "four_bar_motion 1 ",
        "motion_f32 1 ",
        "excavator_motion 0 ",
        "robot_forward_dynamics 0 ",
        "searched_press_motion 0 ",
        "searched_press_forces 0 ",
        "searched_press_position 8 ",
        "searched_press_position 4 ",
    ] {
        assert!(report.0.contains(part), "the poses are all of one kind: no `{part}`");
    }
    report.0 + &mistakes()
}

#[test]
#[ignore = "release builds of all solvers: `.ci/nightly` makes them"]
fn c_and_rust_compute_the_same_bits() {
    let library = library("all", "3").unwrap_or_else(|error| panic!("{error}"));
    let output = run_c(&library, &sources().join("caller.c"));
    assert!(output.status.success(), "{}", text(&output.stderr));
    let (found, expected) = (text(&output.stdout), expected());
    // With a fused operation at hand, the standard library's numbers use it and the bare ones do
    // not; the statuses are the same then too.
    let fused = cfg!(all(target_arch = "x86_64", target_feature = "fma"));
    assert_eq!(found.lines().count(), expected.lines().count());
    for (found, expected) in found.lines().zip(expected.lines()) {
        let compared = |line: &str| match fused {
            true => line.splitn(4, ' ').take(3).collect(),
            false => line.to_owned(),
        };
        assert_eq!(compared(found), compared(expected));
    }
}

#[test]
fn every_header_compiles_without_a_warning_as_c_and_as_cpp() {
    for (language, standard) in [("c", "-std=c99"), ("c", "-std=c17"), ("c++", "-std=c++17")] {
        let mut all = String::new();
        for (name, _) in HEADERS {
            // Once more has to be harmless.
            let _ = write!(all, "#include \"{name}\"\n#include \"{name}\"\n");
            compile(language, standard, name, &format!("#include \"{name}\"\n"));
        }
        compile(language, standard, "all", &all);
    }
}

/// Checks a source text, which may be nothing but a header.
fn compile(language: &str, standard: &str, name: &str, source: &str) {
    let file = INCLUDES.join(format!("{name}.check"));
    fs::write(&file, source).expect("the tests' directory can be written");
    let output = Command::new("gcc")
        .args(["-Wall", "-Wextra", "-pedantic", "-Werror", "-fsyntax-only", standard, "-x"])
        .arg(language)
        .arg(&file)
        .output()
        .expect("gcc starts");
    let error = text(&output.stderr);
    // A machine may have gcc without its C++.
    let no_such_compiler = language == "c++" && error.contains("cc1plus");
    assert!(output.status.success() || no_such_compiler, "{name} as {standard}: {error}");
}
