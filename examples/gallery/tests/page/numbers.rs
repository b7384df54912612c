//! The script of every machine's page against its solver: the same numbers and the same refusals.

#[path = "../../../../tests/skipped.rs"]
pub(super) mod skipped;

use std::fmt::Write;
use std::process::Command;

use gallery::declarations::*;
use linkage_core::Solver;
use linkage_core::find::Crossing;
use linkage_core::sketch::{Drawn, Film, Paged, SketchError, shortened};
use linkage_core::{Record, SolveError};

use super::cases::cases;
use super::{contents, hard, program};

/// On a target with fused operations the solver rounds otherwise than a script can: then numbers may differ by
/// four units in the last place of the pose's largest.
const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

/// Poses of each machine.
const POSES: usize = 1000;

/// Compares the answers of a page's script with those of a file, number by number.
const COMPARE: &str = include_str!("compare.js");

/// Random numbers by a multiplicative congruence.
pub(crate) struct Random(u64);

impl Random {
    /// From one number to another.
    pub(super) fn from(&mut self, [least, most]: [f64; 2]) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        least + (most - least) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }

    /// The number, up to a fifth more or less.
    pub(super) fn about(&mut self, x: f64) -> f64 {
        x * self.from([0.8, 1.2])
    }
}

fn list(numbers: &[f64]) -> String {
    numbers.iter().fold("-".to_string(), |mut text, x| {
        write!(text, ",{:016x}", x.to_bits()).unwrap();
        text
    })
}

/// A refusal by its kind, whose it is, the name or the unit, and the missing distance; of an equation also where
/// it is solved the other way.
fn said(answer: Result<Vec<f64>, SolveError>) -> String {
    let bits = |x: f64| format!("{:016x}", x.to_bits());
    match answer {
        Ok(numbers) => list(&numbers),
        Err(SolveError::OutOfReach { group, by }) => format!("OutOfReach|{group}||{}||", bits(by)),
        Err(SolveError::Singular { group }) => format!("Singular|{group}||||"),
        Err(SolveError::Invalid { group, name }) => format!("Invalid|{group}|{name}|||"),
        Err(SolveError::Jams { joint }) => format!("Jams|{joint}||||"),
        Err(SolveError::NotFinite { name }) => format!("NotFinite|{name}||||"),
        Err(SolveError::SeveralDeadPoints { unknown }) => {
            format!("SeveralDeadPoints|{unknown}||||")
        }
        Err(SolveError::NoSolution { unknown, by, unit, other }) => {
            let other = other.map(|Crossing { trend, at }| (trend.sign::<f64>(), bits(at)));
            let (trend, at) =
                other.map_or_else(Default::default, |(sign, at)| (sign.to_string(), at));
            format!("NoSolution|{unknown}|{unit}|{}|{trend}|{at}", bits(by))
        }
        Err(other) => panic!("{other:?}"),
    }
}

/// One for each point, then for each link, that is drawn at these inputs; zero for the others.
fn standing<S: Drawn + 'static>(solver: S, q: S::Input) -> String
where
    S::Input: 'static,
{
    let film = Film::of(solver, [q]);
    let points = S::PLAN.points.iter().map(|name| film.point(0, name).is_ok());
    let links = S::PLAN.links.iter().map(|name| film.link(0, name).is_ok());
    points.chain(links).map(|stands| if stands { '1' } else { '0' }).collect()
}

/// A machine's page, and the answers of its solver at random poses.
pub(super) struct Asked {
    name: &'static str,
    html: String,
    pub(super) lines: String,
}

/// Answers by the names of their functions.
pub(super) type Answers = Vec<(&'static str, Result<Vec<f64>, SolveError>)>;

/// The answers of a solver's `forces` and `holding`, where it has any.
pub(super) type Forces<S, I> = fn(&S, [I; 3], &[f64]) -> Answers;

pub(super) fn asked<
    S: Paged + Drawn<Input = <S as Solver>::Input> + Solver<Scalar = f64> + 'static,
>(
    pages: &[(&'static str, String)],
    name: &'static str,
    ends: &[[f64; 2]],
    solver: impl Fn(&mut Random) -> S,
    forces: Forces<S, <S as Solver>::Input>,
) -> Asked
where
    <S as Solver>::Input: 'static,
{
    contents::is_printed_by_the_compiler_alone(&solver(&mut Random(1)));
    program::writes_the_same(&solver(&mut Random(2)), ends, &mut Random(name.len() as u64));
    let (_, html) = pages.iter().find(|(own, _)| *own == name).expect("it has a page").clone();
    let (mut random, mut lines) = (Random(name.len() as u64), String::new());
    for _ in 0..POSES {
        let solver = solver(&mut random);
        let inputs = S::TITLES.inputs.len();
        let mut given = |ends: &dyn Fn(usize) -> [f64; 2]| -> Vec<f64> {
            (0..inputs).map(|k| random.from(ends(k))).collect()
        };
        let q = given(&|k| ends.get(k).copied().unwrap_or([-10.0, 10.0]));
        let (v, a) = (given(&|_| [-9.0, 9.0]), given(&|_| [-9.0, 9.0]));
        let loads: Vec<f64> = S::PAGE.loads.lines().map(|_| random.from([-1e4, 1e4])).collect();
        let input = |list: &[f64]| S::input(|k| list[k]);
        // Drives are other numbers of no meaning.
        let lists =
            [&solver.params(), &q, &v, &a, &loads, &a].map(|numbers| list(numbers)).join(" ");
        let motion = Solver::motion(&solver, input(&q), input(&v), input(&a));
        let motion = motion.map(|motion| motion.into_array().into_iter().collect());
        let placed = Drawn::place(&solver, input(&q));
        if placed.is_err() {
            writeln!(lines, "stands {lists} : {}", standing(solver, input(&q))).unwrap();
        }
        let placed = said(placed);
        writeln!(lines, "place {lists} : {placed}\nmotion {lists} : {}", said(motion)).unwrap();
        for (name, answer) in forces(&solver, [input(&q), input(&v), input(&a)], &loads) {
            writeln!(lines, "{name} {lists} : {}", said(answer)).unwrap();
        }
    }
    Asked { name, html, lines }
}

/// The part of a page that computes.
pub(crate) fn script(html: &str) -> &str {
    let (_, behind) = html.split_once("<script>").expect("a page has a script");
    behind.split_once("</script>").expect("it ends").0
}

/// Whose functions a machine's formulas call.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Functions {
    /// The script's own, which round as the crate's.
    Own,
    /// `exp`, `ln`, `tanh` or `pow`, which are the browser's.
    Browser,
}

/// Compares, and returns the counts of what was compared.
pub(super) fn compare(asked: &Asked) -> String {
    compare_by(asked, Functions::Own)
}

pub(super) fn compare_by(asked: &Asked, functions: Functions) -> String {
    let folder = std::env::temp_dir();
    let stem = format!("page_{}_{}", std::process::id(), asked.name.replace("::", "_"));
    let [script_file, lines] = ["cjs", "txt"].map(|end| folder.join(format!("{stem}.{end}")));
    let foreign = functions == Functions::Browser;
    std::fs::write(
        &script_file,
        format!(
            "const FUSED = {FUSED}, FOREIGN = {foreign};\n{}{}",
            script(&asked.html),
            shortened(COMPARE)
        ),
    )
    .unwrap();
    std::fs::write(&lines, &asked.lines).unwrap();
    let output = Command::new("node").arg(&script_file).arg(&lines).output().expect("node runs");
    [script_file, lines].iter().for_each(|file| drop(std::fs::remove_file(file)));
    let [said, failed] =
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    println!("{:<40} {}", asked.name, said.trim());
    assert!(output.status.success(), "{}: {said}{failed}", asked.name);
    said
}

/// A machine whose answers hold no forces.
macro_rules! no_forces {
    () => {
        |_, _, _| Vec::new()
    };
}

/// A machine with `forces`, which is given loads or none; with `holding` as well.
macro_rules! forces {
    () => {
        |solver, [q, v, a], _| {
            vec![("forces", solver.forces(q, v, a).map(|forces| forces.into_array().into()))]
        }
    };
    (holding) => {
        |solver, [q, v, a], _| {
            vec![
                ("forces", solver.forces(q, v, a).map(|forces| forces.into_array().into())),
                ("holding", solver.holding(q).map(|ends| ends.into())),
            ]
        }
    };
    (load) => {
        |solver, [q, v, a], loads| {
            let forces = solver.forces(q, v, a, loads[0]);
            vec![("forces", forces.map(|forces| forces.into_array().into()))]
        }
    };
    (forward) => {
        |solver, [q, v, a], _| {
            vec![("forward_dynamics", solver.forward_dynamics(q, v, a).map(|found| vec![found]))]
        }
    };
    (load, forward) => {
        |solver, [q, v, a], loads| {
            let found = solver.forward_dynamics(q, v, a, loads[0]);
            vec![("forward_dynamics", found.map(|found| vec![found]))]
        }
    };
    (load, holding) => {
        |solver, [q, v, a], loads| {
            let forces = solver.forces(q, v, a, loads[0]);
            let holding = solver.holding(q, loads[0]);
            vec![
                ("forces", forces.map(|forces| forces.into_array().into())),
                ("holding", holding.map(|ends| ends.into())),
            ]
        }
    };
    (load, holding, forward) => {
        |solver, [q, v, a], loads| {
            let forces = solver.forces(q, v, a, loads[0]);
            let holding = solver.holding(q, loads[0]);
            let found = solver.forward_dynamics(q, v, a, loads[0]);
            vec![
                ("forces", forces.map(|forces| forces.into_array().into())),
                ("holding", holding.map(|ends| ends.into())),
                ("forward_dynamics", found.map(|found| vec![found])),
            ]
        }
    };
}

/// Machines as they are declared, but for what random numbers change.
fn table(pages: &[(&'static str, String)]) -> Vec<Asked> {
    macro_rules! row {
        ($module:ident::$name:ident { $($field:ident),* } $(of [$($ends:expr),*])?; $forces:expr) => {
            asked(
                pages,
                concat!(stringify!($module), "::", stringify!($name)),
                &[$($($ends),*)?],
                |_random| {
                    #[allow(unused_mut)]
                    let mut solver = $module::$name::new();
                    $(solver.$field = _random.about(solver.$field);)*
                    solver
                },
                $forces,
            )
        };
    }
    vec![
        row!(flying_shear::FlyingShear {}; no_forces!()),
        row!(four_bar::FourBar {}; no_forces!()),
        row!(range::FourBar { base }; no_forces!()),
        row!(electronic_cam::FlyingShear {}; no_forces!()),
        row!(function_generator::FunctionGenerator { coupler, rocker }; no_forces!()),
        row!(function_generator::Transmission { coupler, rocker }; no_forces!()),
        row!(dead_point::ByLeft {}; no_forces!()),
        row!(dead_point::ByRight {}; no_forces!()),
        row!(run_up::FourBar { flywheel }; forces!(forward)),
        row!(counterweight::FourBar { crank_x, crank_y, rocker_x, rocker_y }; no_forces!()),
        row!(slider_crank::OffsetSliderCrank { desaxe }; no_forces!()),
        row!(crank_rocker_slider::CrankRockerSlider { crank_length, rod_length }; no_forces!()),
        row!(crank_rpp::CrankYoke {}; no_forces!()),
        row!(whitworth::Shaper { depth }; no_forces!()),
        row!(whitworth::Whitworth { depth }; no_forces!()),
        row!(range::Shaper { depth, rod }; no_forces!()),
        row!(six_bar::SixBar {}; no_forces!()),
        row!(jansen_leg::JansenLeg {}; no_forces!()),
        row!(calibration::SixBar { dx, gx, gy, crank, coupler, rocker, ex, ey, link, lever }; no_forces!()),
        row!(suspension::ByTheArm {}; no_forces!()),
        row!(set_point::Press { seed } of [[0.15, 0.36]]; no_forces!()),
        row!(suspension::ByTheWheel {} of [[0.0, 0.6]]; no_forces!()),
        row!(cart::Steering {}; no_forces!()),
        row!(excavator::Excavator {} of [[1.9, 2.9], [2.3, 3.7], [1.6, 2.6]]; no_forces!()),
        row!(five_bar_robot::Forward {}; no_forces!()),
        row!(five_bar_robot::Inverse {} of [[-0.3, 0.3], [0.0, 0.5]]; no_forces!()),
        row!(transplanter::Transplanter { r1, r2, l1, l2, tip_x, tip_y }; no_forces!()),
        row!(computed_torque::Robot { payload }; no_forces!()),
        row!(computed_torque::Arms {} of [[-0.3, 0.3], [0.0, 0.5]]; no_forces!()),
        row!(crane::Crane {} of [[0.0, 4.0], [-10.0, 10.0]]; no_forces!()),
        row!(driving_torque::FourBar { g }; forces!()),
        row!(driving_torque::AsInTheText {}; forces!()),
        row!(press_friction::CutPress { pins, ways }; forces!(load, holding, forward)),
        row!(toggle_clamp::ToggleClamp { mu } of [[-0.3, 0.9]]; forces!(load, holding)),
        row!(scissor_lift::ScissorLift { pins, thread } of [[0.3, 1.25]]; forces!(load, holding)),
        row!(stick_slip::DryBlock {} of [[-0.1, 0.1]]; forces!(holding)),
        row!(stick_slip::CreepingBlock { smoothing } of [[-0.1, 0.1]]; forces!()),
        row!(shear_bearings::FlyingShear {}; forces!(load)),
        row!(six_bar_reactions::SixBar {}; forces!()),
        row!(andrews_squeezer::Squeezer {}; forces!(forward)),
        row!(parallelograms::TwoParallelograms {}; no_forces!()),
        row!(vibration::Oscillator { k } of [[-0.3, 0.3]]; forces!(load, forward)),
        row!(vibration::TwoMasses { k } of [[-0.3, 0.3], [-0.3, 0.3]]; no_forces!()),
    ]
}

/// Every third page of the gallery, and with `LINKAGE_WHOLE` every one, a thousand poses each.
#[test]
fn a_page_computes_as_its_solver_does() {
    if !has_node() {
        return;
    }
    let pages = gallery::live::pages().unwrap();
    let table = table(&pages);
    let mut named: Vec<&str> = table.iter().map(|asked| asked.name).collect();
    let mut all: Vec<&str> = pages.iter().map(|(name, _)| *name).collect();
    named.sort_unstable();
    all.sort_unstable();
    assert_eq!(named, all);
    table.iter().step_by(cases(3, 1)).for_each(|asked| drop(compare(asked)));
}

/// Names that are words of the language, and every function.
#[test]
fn hard_machines_compute_alike() {
    if !has_node() {
        return;
    }
    let function = hard::Function::new();
    let page = |name, html: Result<String, SketchError>| [(name, html.unwrap())];
    let pages = page("Function", function.page().title("</script>").to_html());
    let solver = |random: &mut Random| {
        let mut solver = hard::Function::new();
        // A length below zero now and then: its group is refused, whatever its numbers.
        solver.class = random.from([-0.02, 0.1]);
        solver.p = random.about(0.632);
        solver
    };
    compare(&asked(&pages, "Function", &[], solver, no_forces!()));
    let pages = page("Carried", hard::Carried::new().page().to_html());
    let solver = |random: &mut Random| hard::Carried { coupler: random.from([-0.2, 0.7]) };
    let asked_of = asked(&pages, "Carried", &[], solver, no_forces!());
    assert!(asked_of.lines.contains("Invalid|BC, DC|"), "no length below zero");
    compare(&asked_of);
    let pages =
        page("Compensated", hard::Compensated::new().page().range("s", 0.0..=0.1).to_html());
    let ends = [[-10.0, 10.0], [-0.05, 0.3]];
    compare(&asked(&pages, "Compensated", &ends, |_| hard::Compensated::new(), no_forces!()));
}

/// Equations with several roots, ends, dead points and trials that cannot be assembled.
#[test]
fn hard_searches_end_alike() {
    if !has_node() {
        return;
    }
    let compared = |name: &'static str, html: Result<String, SketchError>| [(name, html.unwrap())];
    let rippled = hard::Rippled::new();
    let pages = compared("Rippled", rippled.page().range("x", -1.0..=1.0).to_html());
    let solver = |random: &mut Random| {
        let mut solver = rippled;
        if random.from([0.0, 1.0]) < 0.5 {
            solver.way = solver.way.flipped();
        }
        // Out of order now and then, and more than a turn apart.
        (solver.low, solver.high) = (random.from([-4.0, 0.5]), random.from([0.0, 4.0]));
        solver
    };
    compare(&asked(&pages, "Rippled", &[[-1.8, 1.8]], solver, no_forces!()));
    let chained = hard::Chained::new();
    let page = chained.page().range("x", 0.17..=0.33).range("h", -0.1..=0.3);
    let pages = compared("Chained", page.to_html());
    let solver = |random: &mut Random| hard::Chained { rod: random.about(0.25) };
    let ends = [[0.16, 0.34], [-0.2, 0.4]];
    compare(&asked(&pages, "Chained", &ends, solver, forces!()));
    let eight = hard::EightBar::new();
    let pages = compared("EightBar", eight.page().to_html());
    compare(&asked(&pages, "EightBar", &[[-4.0, 4.0]], |_| eight, no_forces!()));
    let jump = hard::Jump::new();
    let pages = compared("Jump", jump.page().to_html());
    compare(&asked(&pages, "Jump", &[[-4.0, 4.0]], |_| jump, no_forces!()));
}

pub(crate) fn has_node() -> bool {
    let is_there = Command::new("node").arg("--version").output().is_ok();
    assert!(is_there || std::env::var_os("LINKAGE_NODE").is_none(), "node is required");
    if !is_there {
        skipped::skipped("pages compute as the crate does: no node");
    }
    is_there
}
