//! Poses that printed C carries over from one set of inputs to another: the numbers of Rust to the last bit, in both widths.

#[path = "transfers/caller.rs"]
mod caller;
#[allow(unreachable_pub, reason = "other tests have it in the interface of their crate")]
#[path = "../../../tests/src/random.rs"]
mod random;
#[path = "../../../tests/skipped.rs"]
mod skipped;

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use caller::source;
use linkage_core::private::{CarriesOver, Solver};
use linkage_core::{Real, Record, Transfer, TransferError, mechanism};
use random::{Random, cases};
use skipped::skipped;

include!("data/both_ways.rs");

const MACHINES: &str = include_str!("data/both_ways.rs");

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("transfers").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    fs::write(folder.join("machines.rs"), MACHINES).expect("a file can be written");
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

/// The printed sources in a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("it is there").flatten();
    let paths = entries.map(|entry| entry.path());
    paths.filter(|path| path.extension().is_some_and(|ending| ending == "c")).collect()
}

/// All programs in C behind one strict compiler, with these flags, and optimised with `LINKAGE_WHOLE`; nothing without one.
fn program(name: &str, more: &[&str]) -> Option<PathBuf> {
    let folder = folder(name);
    printed(&folder, &["export", "c", "machines.rs", "-o", "."]);
    let has_double = !more.contains(&WITHOUT_DOUBLE);
    fs::write(folder.join("caller.c"), source(has_double)).expect("a file can be written");
    let strict = [
        "-std=c99",
        "-pedantic",
        "-Wall",
        "-Wextra",
        "-Wshadow",
        "-Wconversion",
        "-Wredundant-decls",
        "-Wmissing-prototypes",
        "-Werror",
        ["-O0", "-O2"][cases(0, 1)],
    ];
    let mut command = Command::new("cc");
    command.args(strict).args(more).args(sources(&folder)).current_dir(&folder);
    command.args(["-lm", "-o", "caller"]);
    let Ok(output) = command.output() else {
        skipped("poses carried over in C: no cc");
        return None;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(folder.join("caller"))
}

const WITHOUT_DOUBLE: &str = "-DLINKAGE_NO_DOUBLE";

fn around(random: &mut Random, center: f64, reach: f64) -> f64 {
    center + reach * (2.0 * random.unit() - 1.0)
}

const POSES: usize = 1_000;

/// The numbers in Rust, the bytes for C, and the count of poses that were carried over.
fn in_rust<A, B, T, const N: usize>(
    from: A,
    drawn: [f64; N],
    reach: f64,
    bytes: impl Fn(T) -> Vec<u8>,
) -> (Vec<u8>, Vec<f64>, usize)
where
    T: Real,
    A: CarriesOver<B, N> + Solver<Scalar = T>,
    B: Solver<Scalar = T>,
    A::Input: Record<Number = T, Array = [T; N]>,
    B::Input: Record<Number = T, Array = [T; N]>,
    A::Position: Record<Number = T>,
{
    let mut random = Random::new(57);
    let (mut given, mut told, mut carried) = (Vec::new(), Vec::new(), 0);
    for pose in 0..POSES {
        let share = if pose % 2 == 0 { 0.1 } else { 1.0 };
        let mut list =
            |center: [f64; N], reach: f64| center.map(|at| T::num(around(&mut random, at, reach)));
        let q = list(drawn, share * reach);
        let [rates, accelerations, efforts] = [2.0, 3.0, 4.0].map(|reach| list([0.0; N], reach));
        let inertia: [[T; N]; N] = std::array::from_fn(|_| list([1.0; N], 1.0));
        for number in
            [q, rates, accelerations, efforts].as_flattened().iter().chain(inertia.as_flattened())
        {
            given.extend(bytes(*number));
        }
        let mut put = |numbers: &[T]| {
            told.push(0.0);
            told.extend(numbers.iter().map(|number| number.value()));
        };
        let of = <A::Input as Record>::from_array;
        let transfer = match Transfer::<A, B, N>::new(from, of(q)) {
            Ok(transfer) => transfer,
            Err(TransferError::OtherAssembly { .. }) => {
                told.push(11.0);
                continue;
            }
            Err(_) => {
                told.push(1.0);
                continue;
            }
        };
        carried += 1;
        put(&transfer.coordinates.into_array());
        put(&transfer.rates(of(rates)).expect("it has rates").into_array());
        let motion = transfer.motion(of(rates), of(accelerations)).expect("it has a motion");
        put(motion.map(Record::into_array).as_flattened());
        put(transfer.ratios().expect("it has ratios").as_flattened());
        let efforts = transfer.efforts(<B::Input as Record>::from_array(efforts));
        put(&efforts.expect("it has ratios").into_array());
        put(transfer.inertia(inertia).expect("it has ratios").as_flattened());
    }
    (given, told, carried)
}

fn in_c(program: &Path, name: &str, given: Vec<u8>) -> Vec<f64> {
    let mut child = Command::new(program)
        .args([name, &POSES.to_string()])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut to = child.stdin.take().expect("it is piped");
    let writer = std::thread::spawn(move || to.write_all(&given).expect("it reads"));
    let output = child.wait_with_output().expect("it ends");
    writer.join().expect("nothing panics");
    assert!(output.status.success(), "{name}");
    let number = |bytes: &[u8]| f64::from_ne_bytes(bytes.try_into().expect("eight bytes"));
    output.stdout.chunks(8).map(number).collect()
}

/// Refusals other than that of another assembly have one code here.
fn compared(name: &str, rust: &[f64], c: &[f64]) {
    assert_eq!(rust.len(), c.len(), "{name}");
    let is_refusal = |x: f64| (1.0..11.0).contains(&x) && x.fract() == 0.0;
    for (at, (rust, c)) in rust.iter().zip(c).enumerate() {
        let is_same = rust.to_bits() == c.to_bits() || *rust == 1.0 && is_refusal(*c);
        assert!(is_same, "{name}: number {at} is {rust} in Rust and {c} in C");
    }
}

macro_rules! compare {
    ($program:expr; $($machine:ident $from:ident $to:ident $set:ident $reach:literal $name:literal;)*) => {$({
        let drawn = $from::<f64>::DRAWN;
        let machine = $machine::new();
        let (given, rust, carried) =
            in_rust::<_, $to, f64, { $from::<f64>::INPUTS.len() }>(machine.$set(), drawn.into(), $reach, |x| x.to_ne_bytes().to_vec());
        assert!(carried * 4 > POSES, "{} {carried}", $name);
        compared($name, &rust, &in_c($program, concat!($name, "_all_f64"), given));
        let machine = $machine::<f32>::default();
        let (given, rust, carried) =
            in_rust::<_, $to<f32>, f32, { $from::<f64>::INPUTS.len() }>(machine.$set(), drawn.into(), $reach, |x| x.to_ne_bytes().to_vec());
        assert!(carried * 4 > POSES, "{} {carried}", $name);
        compared($name, &rust, &in_c($program, concat!($name, "_all_f32"), given));
    })*};
}

#[test]
fn c_has_the_bits_of_rust() {
    let Some(program) = program("bits", &[]) else { return };
    compare! { &program;
        Arm ArmMotors ArmHand motors 2.0 "arm_motors_to_hand";
        Arm ArmHand ArmMotors hand 0.2 "arm_hand_to_motors";
        Slider SliderCrankSide SliderPress crank_side 3.0 "slider_crank_side_to_press";
        Slider SliderPress SliderCrankSide press 0.2 "slider_press_to_crank_side";
        Bicycle BicycleShock BicycleWheel shock 0.1 "bicycle_shock_to_wheel";
        Bicycle BicycleShock BicycleLever shock 0.1 "bicycle_shock_to_lever";
        Bicycle BicycleWheel BicycleShock wheel 0.2 "bicycle_wheel_to_shock";
        Bicycle BicycleWheel BicycleLever wheel 0.2 "bicycle_wheel_to_lever";
        Bicycle BicycleLever BicycleShock lever 2.0 "bicycle_lever_to_shock";
        Bicycle BicycleLever BicycleWheel lever 2.0 "bicycle_lever_to_wheel";
    }
}

macro_rules! compare_without_double {
    ($both:expr, $single:expr; $($machine:ident $from:ident $to:ident $set:ident $reach:literal $name:literal;)*) => {$({
        let machine = $machine::<f32>::default();
        let (given, ..) = in_rust::<_, $to<f32>, f32, { $from::<f64>::INPUTS.len() }>(
            machine.$set(), $from::<f64>::DRAWN.into(), $reach, |x| x.to_ne_bytes().to_vec());
        let name = concat!($name, "_all_f32");
        let [with, without] = [$both, $single].map(|program| in_c(program, name, given.clone()));
        // A refusal is a number alone, so that as many numbers are as many answers.
        assert_eq!(with.len(), without.len(), "{name}");
        let other = with.iter().zip(&without).filter(|(a, b)| a.to_bits() != b.to_bits()).count();
        assert!(other * 200 <= with.len(), "{name}: {other} of {}", with.len());
    })*};
}

/// Groups have the same sides without double precision, which no object asks for.
#[test]
fn poses_are_carried_over_without_double() {
    let Some(both) = program("both", &[]) else { return };
    let single = program("single", &[WITHOUT_DOUBLE]);
    let single = single.expect("there is a compiler");
    compare_without_double! { &both, &single;
        Arm ArmMotors ArmHand motors 2.0 "arm_motors_to_hand";
        Arm ArmHand ArmMotors hand 0.2 "arm_hand_to_motors";
        Slider SliderCrankSide SliderPress crank_side 3.0 "slider_crank_side_to_press";
        Slider SliderPress SliderCrankSide press 0.2 "slider_press_to_crank_side";
        Bicycle BicycleShock BicycleWheel shock 0.1 "bicycle_shock_to_wheel";
        Bicycle BicycleLever BicycleShock lever 2.0 "bicycle_lever_to_shock";
    }
    let folder = single.parent().expect("it stands in a folder");
    let target = ["-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"];
    for source in sources(folder).iter().filter(|path| !path.ends_with("caller.c")) {
        let compiler = Command::new("arm-none-eabi-gcc")
            .args(target)
            .args(["-std=c99", "-O2", WITHOUT_DOUBLE, "-Wdouble-promotion", "-Werror", "-c"])
            .arg(source)
            .args(["-o", "object.o"])
            .current_dir(folder)
            .output();
        let Ok(output) = compiler else {
            return skipped("objects without software double: no arm-none-eabi-gcc");
        };
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let mut names = Command::new("arm-none-eabi-nm");
        let names = names.args(["-u", "object.o"]).current_dir(folder).output();
        let names = names.expect("it comes with the compiler");
        let names = String::from_utf8_lossy(&names.stdout).into_owned();
        let of_double = ["__aeabi_d", "__aeabi_f2d", "__aeabi_i2d", "__aeabi_cd"];
        let is_asked = of_double.iter().any(|name| names.contains(name));
        assert!(!is_asked, "{}: {names}", source.display());
    }
}

/// The function's text where there is double precision.
fn with_double(text: &str) -> String {
    let Some((before, rest)) = text.split_once("#ifdef LINKAGE_NO_DOUBLE") else {
        return text.to_string();
    };
    let (_, rest) = rest.split_once("#else").expect("there is another way");
    format!("{before}{rest}")
}

/// The bodies of the functions of this name.
fn body<'t>(source: &'t str, function: &str) -> &'t str {
    let start = source.find(&format!("{function}(")).expect("it is printed");
    let end = source[start..].find("\n}\n").expect("it ends");
    &source[start..start + end]
}

/// Additions, multiplications and divisions that are written.
fn operations(text: &str) -> usize {
    [" + ", " - ", " * ", " / "].iter().map(|sign| text.matches(sign).count()).sum()
}

/// Beside the position, a pose that is carried over costs ten operations a group and one arc tangent an angle.
#[test]
fn what_is_carried_over_costs_little() {
    let folder = folder("cost");
    printed(&folder, &["export", "c", "machines.rs", "-o", ".", "--only", "f64,position"]);
    let read = |name: &str| fs::read_to_string(folder.join(name)).expect("it is printed");
    let (arm, slider) = (read("arm.c"), read("slider.c"));
    for (source, function) in
        [(&arm, "LinkageWide arm_larger"), (&slider, "LinkageWide slider_larger")]
    {
        assert_eq!(operations(body(source, function)), 0);
    }
    let across = operations(&with_double(body(&arm, "LinkageStatus arm_across")));
    let along = operations(body(&slider, "LinkageStatus slider_along"));
    // The rounding is a constant.
    assert_eq!([across, along], [9, 6]);
    for (source, name, groups, angles) in [
        (&arm, "arm_motors_to_hand", 2, 0),
        (&arm, "arm_hand_to_motors", 1, 2),
        (&slider, "slider_press_to_crank_side", 1, 1),
    ] {
        let text = body(source, &format!("LinkageStatus {name}"));
        let checks = text.matches("_across(").count() + text.matches("_along(").count();
        assert_eq!(
            [checks, text.matches("linkage_angle_near(").count()],
            [groups, angles],
            "{name}"
        );
        // Nothing else is computed but the constant of each check.
        assert_eq!(operations(text), checks, "{name}");
        assert_eq!(text.matches("_position(").count(), 1, "{name}");
    }
    // Without an entry point what needs it is not offered.
    assert!(!arm.contains("_rates(") && !arm.contains("_inertia("));
}

#[test]
fn sets_are_chosen_by_name() {
    let folder = folder("chosen");
    let files = |arguments: &[&str]| {
        let _ = fs::remove_dir_all(folder.join("out"));
        let all = [&["export", "c", "machines.rs", "-o", "out"], arguments].concat();
        printed(&folder, &all);
        let entries = fs::read_dir(folder.join("out")).expect("it is written").flatten();
        let names = entries.map(|entry| entry.file_name().into_string().expect("it is ASCII"));
        let mut names: Vec<_> = names.filter(|name| !name.starts_with("linkage_")).collect();
        names.sort();
        names.join(" ")
    };
    assert_eq!(files(&["--inputs", "hand"]), "arm_hand.c arm_hand.h");
    assert_eq!(
        files(&["--machine", "Arm"]),
        "arm.c arm.h arm_hand.c arm_hand.h arm_motors.c arm_motors.h"
    );
    assert_eq!(files(&["--machine", "ArmMotors"]), "arm_motors.c arm_motors.h");
    assert_eq!(
        files(&["--inputs", "wheel,shock"]),
        "bicycle.c bicycle.h bicycle_shock.c bicycle_shock.h bicycle_wheel.c bicycle_wheel.h"
    );
    let errors = |arguments: &[&str]| {
        let output = linkage(&folder, arguments);
        assert_eq!(output.status.code(), Some(2));
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let told = errors(&["export", "c", "machines.rs", "--inputs", "hands"]);
    assert!(
        told.contains("has no set of inputs `hands`; there are motors, hand, crank_side"),
        "{told}"
    );
    let told = errors(&["export", "fmu", "machines.rs", "--machine", "Arm"]);
    assert!(told.contains("or its inputs by `--inputs SET`"), "{told}");
    printed(&folder, &["export", "fmu", "machines.rs", "--inputs", "hand", "-o", "hand.fmu"]);
    let header = fs::read_to_string(folder.join("out/bicycle_shock.h")).expect("it is printed");
    assert!(header.contains("extern const double bicycle_shock_drawn[BICYCLE_SHOCK_INPUTS];"));
}

/// A refusal names the group, and the solver that would find another pose.
#[test]
fn another_assembly_is_told() {
    let folder = folder("told");
    printed(
        &folder,
        &["export", "c", "machines.rs", "-o", ".", "--machine", "Arm", "--prefix", "acme"],
    );
    let caller = "#include <stdio.h>\n#include \"acme_arm.h\"\nint main(void)\n{\n\
        const AcmeArm declared = acme_arm_default();\nconst AcmeArmMotors own = acme_arm_motors_of(&declared);\n\
        const AcmeArmMotorsInput q = { acme_arm_motors_drawn[0] - 1.5, acme_arm_motors_drawn[1] };\n\
        AcmeArmMotorsToHand transfer;\nLinkageError error;\n\
        const LinkageStatus status = acme_arm_motors_to_hand(&own, &q, &transfer, &error);\n\
        printf(\"%d %.*s|%.*s|%s\\n\", (int)status, (int)error.group_length, error.group, (int)error.name_length, error.name,\n\
        acme_linkage_status_text(status));\nprintf(\"%d %d %d\\n\", (int)acme_arm_motors_to_hand(NULL, &q, &transfer, NULL),\n\
        (int)acme_arm_motors_to_hand(&own, NULL, &transfer, NULL), (int)acme_arm_motors_to_hand_rates(&transfer, NULL, NULL, NULL));\n\
        return 0;\n}\n";
    fs::write(folder.join("caller.c"), caller).expect("a file can be written");
    let strict =
        ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-O1", "-o", "caller", "caller.c"];
    let sources =
        ["acme_arm.c", "acme_arm_motors.c", "acme_arm_hand.c", "acme_linkage_run.c", "-lm"];
    let Ok(output) = Command::new("cc").args(strict).args(sources).current_dir(&folder).output()
    else {
        skipped("another assembly in C: no cc");
        return;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(folder.join("caller")).output().expect("the program starts");
    let rust = Arm::new().motors().to_hand([ArmMotors::DRAWN[0] - 1.5, ArmMotors::DRAWN[1]]);
    let Err(TransferError::OtherAssembly { group, solver }) = rust else { panic!("{rust:?}") };
    let expected = format!(
        "11 {group}|Acme{solver}|other assembly: the group has another side than for the other set of inputs\n5 5 5\n"
    );
    assert_eq!(String::from_utf8_lossy(&output.stdout), expected);
}
