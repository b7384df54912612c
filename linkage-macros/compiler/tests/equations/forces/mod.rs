//! Reactions and efforts against Newton's and Euler's equations of every part in a hundred digits,
//! against the virtual power of all that acts, and against what the ground carries.

pub(crate) mod bearings;
pub(crate) mod carried;
pub(super) mod topologies;

use crate::equations::declarations::{UNKNOWNS, VARIANTS};
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::newton_euler::{Matrix, Motion};
use crate::equations::parallelograms::PARALLELOGRAMS;
use crate::equations::symbol::GraphBuilder;
use crate::exact::Exact;
use crate::interface::entries::EntryPoint;
use crate::ir::graph::{Graph, Id};
use crate::ir::interpret::{Number, ProgramValues, interpret};
use crate::ir::program::{EntryOutputs, Program};
use crate::model::acting::{Effort, RequestedEffort};
use crate::model::mechanism::{
    Body, Carrier, GuideId, InputId, Link, LinkId, Mechanism, PointId, Scalar,
};
use crate::oracle::{Digits, defaults, mechanism};
use crate::passes;
pub(crate) use linkage_compiler::equations::forces::*;

/// The declaration with mass on every link and pin, and with forces and torques everywhere.
pub(crate) fn loaded(source: &str) -> String {
    let plain = mechanism(source);
    let mut added = String::from("gravity (0.7, -9.81);");
    let q = &plain.inputs[0].name;
    let q = if plain.inputs[0].dimension.angle { format!("0.1m * {q}") } else { q.to_string() };
    for (index, link) in plain.links.iter().enumerate() {
        let (x, m) = (0.1 + 0.07 * index as f64, 1.3 + 0.4 * index as f64);
        added += &format!("mass {m} on {0} at ({x}, -0.05) inertia 0.03;", link.name);
        added += &format!("mass 0.6 on {0} at (-0.02, {x}); inertia 0.01 on {0};", link.name);
        added += &format!("torque {} on {};", m - 2.0, link.name);
        added += &format!("mass 0.4 on {} at ({q} - 0.02, 0.03) inertia 0.02;", link.name);
        added += &format!("mass 0.2 on {} at (0.05, 2 * {q});", link.name);
    }
    let points = (0..plain.points.len() as u32).map(PointId);
    let mut previous = None;
    for (index, point) in points.enumerate() {
        let name = &plain.points[point.index()].name;
        match plain.owner(point) {
            Some(Body::Ground) | None => continue,
            Some(Body::Pin(_)) => added += &format!("mass {} on {name};", 0.3 + index as f64),
            Some(Body::Link(_)) => {}
        }
        added += &format!("force ({}, {}) on {name};", 3.0 - index as f64, 1.5 * index as f64);
        added += &format!(
            "force (-0.4(N*s/m) * rate({name}.x + {q}), 0.2(N*s/m) * rate({name}.y - {q})) on {name};"
        );
        let owner = plain.owner(point);
        if let Some((other, before, known)) = previous.replace((name, point, owner))
            && (known != owner || moves_inside(&plain, owner, [before, point]))
        {
            added += &format!("force {} between {other} and {name};", 2.5 + index as f64);
            added += &format!(
                "force -1(N*s/m) * rate(distance({other}, {name}) + 0.1 * ({q})) between {name} and {other};"
            );
            added +=
                &format!("spring s{index} between {name} and {other} {{ {} }}", numbers(index));
        }
    }
    for (index, pair) in plain.links.windows(2).enumerate() {
        added += &on_a_pair(&plain, pair, index);
    }
    let (body, _) = source.rsplit_once('}').expect("a declaration ends with a brace");
    format!("{body} {added} }}")
}

/// True if a point of a link moves in it.
fn moves_inside(plain: &Mechanism, owner: Option<Body>, points: [PointId; 2]) -> bool {
    let Some(Body::Link(link)) = owner else { return false };
    let moves = |point| plain.coordinates_move(Carrier::Link(link), point) != [false; 2];
    points.into_iter().any(moves)
}

/// A spring's numbers: with and without damping and free length.
fn numbers(index: usize) -> &'static str {
    match index % 4 {
        0 => "stiffness: 11, free_length: 0.4, damping: 0.7",
        1 => "stiffness: 7, free_length: 0",
        2 => "damping: 1.3",
        _ => "stiffness: 9, free_length: 0.2",
    }
}

/// A torsion spring where no driver says the angle, and dampers between the two links.
fn on_a_pair(plain: &Mechanism, pair: &[Link], index: usize) -> String {
    let [a, b] = [&pair[0], &pair[1]];
    let mut added =
        format!("torque -0.3(N*m*s) * rate({0}.angle - 2 * {1}.angle) on {0};", a.name, b.name);
    if a.slides {
        added +=
            &format!("torque 0.2(N*s) * rate({}.slide) between {} and {};", a.name, a.name, b.name);
    }
    // Where drivers say an angle, it may be turns away from what two unit vectors enclose.
    let is_free = |link: &Link| {
        let keyword = &plain.groups[link.made_by.index()].keyword;
        !link.slides && keyword != "crank" && keyword != "slider"
    };
    let first = match (is_free(a), is_free(b)) {
        (true, true) if a.made_by != b.made_by => a.name.to_string(),
        (false, true) => "ground".to_string(),
        _ => return added,
    };
    let free = 0.2 * index as f64;
    added += &format!(
        "spring between {first} and {} {{ stiffness: 2.5, free_angle: {free}, damping: 0.4 }}",
        b.name
    );
    added
}

/// Everything that the tests compare, as nodes.
struct Nodes {
    motion: Motion<Id>,
    /// At a unit rate of each input.
    units: Vec<Motion<Id>>,
    found: Vec<(Effort, Vec<Id>)>,
    inputs: Vec<Id>,
    by_power: Vec<Id>,
    ground: [Id; 3],
    /// By point, what all links that stand on it put on it.
    bearings: Vec<(PointId, [Id; 2])>,
    readings: Vec<(String, Id)>,
}

pub(super) fn with_every_input_asked(mut mechanism: Mechanism) -> Mechanism {
    let inputs = mechanism.inputs.iter().enumerate();
    let asked = inputs.map(|(index, input)| RequestedEffort {
        owner: input.name.clone(),
        field: input.name.clone(),
        docs: Vec::new(),
        effort: Effort::Input(InputId(index as u32)),
    });
    mechanism.dynamics.asked = asked.collect();
    mechanism
}

fn nodes<'s>(kinematics: &Kinematics<'s>) -> Nodes {
    let (builder, mechanism) = (kinematics.builder, kinematics.mechanism);
    let walk = Walk::of(kinematics);
    let units = (0..mechanism.inputs.len()).map(|moving| {
        let mut inputs = InputMotion::free(mechanism, builder);
        for (index, source) in inputs.iter_mut().enumerate() {
            source.jet.rate = builder.integer(i64::from(index == moving));
            source.jet.accel = builder.zero();
        }
        Motion::of(&Kinematics::of(builder, mechanism, inputs))
    });
    let readings = readings(mechanism, kinematics);
    let found = walk
        .found()
        .map(|(effort, numbers)| (effort, numbers.iter().map(|number| number.id).collect()));
    let efforts = walk.input_efforts().iter();
    let ground = walk.ground;
    Nodes {
        motion: Motion::of(kinematics),
        units: units.collect(),
        found: found.collect(),
        inputs: efforts.map(|effort| effort.id).collect(),
        by_power: in_motion(kinematics),
        ground: [ground.force.x.id, ground.force.y.id, ground.moment.id],
        bearings: bearings::found(mechanism, &walk),
        readings,
    }
}

/// All that a dimension may read, as text, and its node.
pub(super) fn readings(mechanism: &Mechanism, kinematics: &Kinematics<'_>) -> Vec<(String, Id)> {
    let id = |expr: Scalar| (format!("{expr:?}"), kinematics.jet(&expr).value.id);
    let inputs = (0..mechanism.inputs.len() as u32).map(|input| Scalar::Input(InputId(input)));
    let mut readings: Vec<_> = inputs.map(id).collect();
    let mut leaves = Vec::new();
    leaves_of(mechanism, &mut leaves);
    readings.extend(leaves.into_iter().map(id));
    readings
}

/// Every slide, coordinate and distance that may be read.
fn leaves_of(mechanism: &Mechanism, leaves: &mut Vec<Scalar>) {
    use crate::model::mechanism::{Axis, UnknownId};
    let links = mechanism.links.iter().enumerate().filter(|(_, link)| link.slides);
    leaves.extend(links.map(|(index, _)| Scalar::Slide(LinkId(index as u32))));
    leaves.extend((0..mechanism.unknowns.len() as u32).map(|id| Scalar::Unknown(UnknownId(id))));
    let points: Vec<_> = (0..mechanism.points.len() as u32).map(PointId).collect();
    for &p in &points {
        leaves.extend([Axis::X, Axis::Y].map(|axis| Scalar::Coordinate(p, axis)));
        leaves.extend(points.iter().filter(|&&q| q != p).map(|&q| Scalar::Distance([p, q])));
        let guides = (0..mechanism.guides.len() as u32).map(GuideId);
        leaves.extend(guides.map(|guide| Scalar::Offset(p, guide)));
    }
}

fn jets<'s>(
    mechanism: &Mechanism,
    builder: &'s GraphBuilder<'s>,
    at_rest: bool,
) -> Vec<InputMotion<'s>> {
    let mut inputs = InputMotion::free(mechanism, builder);
    for source in inputs.iter_mut().filter(|_| at_rest) {
        (source.jet.rate, source.jet.accel) = (builder.zero(), builder.zero());
    }
    inputs
}

fn whole(n: i64) -> Digits {
    Digits::exact(&Exact::integer(n))
}

/// Compares everything in one pose; 1e-40 of the largest force.
pub(super) fn check(name: &str, source: &str, inputs: &[[f64; 3]]) {
    check_moving(name, source, inputs);
    check_at_rest(name, source, inputs);
}

fn check_moving(name: &str, source: &str, inputs: &[[f64; 3]]) {
    compare(name, source, inputs, [Against::Matrix, Against::Power], false);
}

fn check_at_rest(name: &str, source: &str, inputs: &[[f64; 3]]) {
    compare(&format!("{name}, at rest"), source, inputs, [Against::Matrix, Against::Power], true);
}

/// Reference that a pose is compared against.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Against {
    Matrix,
    /// Virtual power, and what the ground carries.
    Power,
}

/// The numbers given in a pose, and the values of all nodes.
pub(super) fn evaluated(
    mechanism: &Mechanism,
    graph: Graph,
    inputs: &[[f64; 3]],
) -> (ProgramValues<Digits>, Vec<Digits>) {
    let groups = mechanism.titles();
    let answers =
        vec![EntryOutputs { entry: Some(EntryPoint::named("forces")), sinks: Vec::new() }];
    let program = Program { graph, answers, clearances: Vec::new(), closures: Vec::new(), groups };
    let given = ProgramValues {
        inputs: inputs.iter().map(|q| q.map(Digits::float)).collect(),
        params: defaults(mechanism),
        loads: vec![Digits::float(1.75); mechanism.dynamics.loads.len()],
        drives: vec![Digits::float(0.65); mechanism.inputs.len()],
        unit: None,
    };
    let values = interpret(&program, &given);
    (given, values)
}

/// The value that a leaf of an expression has in a pose.
pub(super) fn read(
    expr: &Scalar,
    given: &ProgramValues<Digits>,
    readings: &[(String, Id)],
    values: &[Digits],
) -> Digits {
    match expr {
        Scalar::Param(id) => given.params[id.index()].clone(),
        Scalar::Load(id) => given.loads[id.index()].clone(),
        leaf => {
            let text = format!("{leaf:?}");
            let found = readings.iter().find(|(known, _)| *known == text);
            values[found.expect("every reading has a node").1.index()].clone()
        }
    }
}

fn compare(
    name: &str,
    source: &str,
    inputs: &[[f64; 3]],
    truths: impl AsRef<[Against]>,
    inputs_rest: bool,
) {
    let truths = truths.as_ref();
    let mechanism = with_every_input_asked(mechanism(source));
    let builder = GraphBuilder::new(passes::RULES);
    let nodes =
        nodes(&Kinematics::of(&builder, &mechanism, jets(&mechanism, &builder, inputs_rest)));
    let (given, values) = evaluated(&mechanism, builder.into_graph(), inputs);
    let motion = nodes.motion.values(&values);
    let reading = |expr: &Scalar| read(expr, &given, &nodes.readings, &values);
    let again = GraphBuilder::new(passes::RULES);
    let kinematics = Kinematics::of(&again, &mechanism, jets(&mechanism, &again, inputs_rest));
    let expected = match truths.contains(&Against::Matrix) {
        true => Matrix::solved(&kinematics, &motion, &reading),
        false => Vec::new(),
    };
    let largest = expected.iter().flat_map(|(_, numbers)| numbers).map(|n| n.to_f64().abs());
    let scale = largest.fold(1.0, f64::max);
    let close = |what: String, found: &Digits, truth: &Digits| {
        let apart = found.sub(truth).to_f64().abs() / scale;
        let (found, truth) = (found.to_f64(), truth.to_f64());
        assert!(apart < 1e-40, "{name}: {what} is {found} and should be {truth}\n{source}");
    };
    for (effort, numbers) in &expected {
        let known = nodes.found.iter().find(|(known, _)| known == effort);
        let (_, found) = known.unwrap_or_else(|| panic!("{name}: no {effort:?}"));
        assert_eq!(found.len(), numbers.len(), "{name}: {effort:?}");
        for (id, truth) in found.iter().zip(numbers) {
            close(format!("{effort:?}"), &values[id.index()], truth);
        }
    }
    assert!(
        expected.len() >= mechanism.links.len() || !truths.contains(&Against::Matrix),
        "{name}"
    );
    if truths.contains(&Against::Matrix) {
        for (point, truth) in bearings::truths(&mechanism, &expected) {
            let (_, found) = nodes.bearings.iter().find(|(at, _)| *at == point).expect("asked");
            for (id, truth) in found.iter().zip(&truth) {
                close(format!("the bearing of {point:?}"), &values[id.index()], truth);
            }
        }
    }
    for (input, unit) in nodes.units.iter().enumerate() {
        let unit = unit.values(&values);
        let pairs = motion.applied.iter().zip(&unit.applied);
        let power = pairs.fold(whole(0), |sum, (now, unit)| sum.add(&now.power_at(unit)));
        let truth = power.neg();
        let by_walk = &values[nodes.inputs[input].index()];
        close(format!("effort of input {input}"), by_walk, &truth);
        close(format!("power of input {input}"), &values[nodes.by_power[input].index()], &truth);
    }
    let mut total = [whole(0), whole(0), whole(0)];
    for applied in &motion.applied {
        let [x, y] = &applied.force;
        let moment = applied.at[0].mul(y).sub(&applied.at[1].mul(x)).add(&applied.couple);
        total = [total[0].add(x), total[1].add(y), total[2].add(&moment)];
    }
    for (id, truth) in nodes.ground.iter().zip(&total) {
        close("the ground's share".to_string(), &values[id.index()], truth);
    }
}

/// Each in motion, and every fourth at rest as well; `.ci/nightly` takes all of them at rest.
#[test]
fn every_variant_agrees_with_newton_and_euler() {
    for (nth, variant) in VARIANTS.iter().chain(PARALLELOGRAMS).enumerate() {
        let source = loaded(variant.source);
        check_moving(variant.name, &source, variant.inputs);
        if nth % 4 == 0 {
            check_at_rest(variant.name, &source, variant.inputs);
        }
    }
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn every_variant_agrees_at_rest() {
    for variant in VARIANTS.iter().chain(PARALLELOGRAMS) {
        check_at_rest(variant.name, &loaded(variant.source), variant.inputs);
    }
}

/// The effort that holds an equation does no work: power alone gives the efforts of the inputs.
/// What holds an equation pushes on what it reads, whatever that is.
#[test]
fn reactions_beside_an_unknown_agree_with_newton_and_euler() {
    for variant in UNKNOWNS {
        check(variant.name, &loaded(variant.source), variant.inputs);
    }
}

/// The pin at the end of a rod, a point of its bar, and one that moves along both axes.
#[test]
fn a_rod_takes_what_acts_between_it_and_its_bar() {
    const RODS: &str = "struct M { input q: angle; input s: length; ground A(0, 0);
        crank AB(A) -> B { length: 0.3, angle: q }
        crank BE(B) -> E { length: 0.2 + s, angle: 2 * q, relative_to: AB }
        point W on BE at (0.1, 0.05); point V on BE at (0.3 + 0.5 * s, 0.1m * q); }";
    let source = loaded(RODS);
    assert!(source.contains("between E and W") && source.contains("between W and V"), "{source}");
    check("rods", &source, &[[0.7, 1.3, -0.6], [0.21, -0.4, 0.9]]);
}

/// A spring inside a body acts on whatever moves one of its ends there.
#[test]
fn a_sought_coordinate_takes_what_acts_inside_its_body() {
    const SOUGHT: &str = "struct M { input q: angle; input x: length; ground A(0, 0), D(0.9, 0.15);
        crank AB(A) -> B { length: 0.3, angle: q } unknown u: length between (0.1, 0.6);
        point T on AB at (u, 0.1); solve u { distance(D, T) = x, mode: falling, near: 0.3 } }";
    let source = loaded(SOUGHT);
    assert!(source.contains("between B and T"), "{source}");
    let inputs = [[0.7, 1.3, -0.6], [0.71, -0.4, 0.9]];
    compare("sought", &source, &inputs, [Against::Power], false);
}
