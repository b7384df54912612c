//! Mechanisms and programs built by hand: what the phases before this one would make of them.

use crate::exact::Exact;
use crate::function::Function;
use crate::interface::entries::EntryPoint;
use crate::ir::graph::{Check, Graph, Guard, Id, Node};
use crate::ir::program::{EntryOutputs, Program};
use crate::model::mechanism::*;
use crate::syntax::anatomy::Modes;
use proc_macro2::{Ident, Span};
use syn::{Attribute, Visibility};

pub(super) const LENGTH: Dimension = Dimension::LENGTH;
pub(super) const ANGLE: Dimension = Dimension::ANGLE;

pub(super) fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

pub(super) fn docs(text: &str) -> Vec<Attribute> {
    vec![syn::parse_quote!(#[doc = #text])]
}

pub(super) fn exact(digits: &str) -> Exact {
    Exact::decimal(digits).expect("a decimal literal")
}

pub(super) fn input(name: &str, dimension: Dimension) -> Input {
    Input { name: ident(name), docs: Vec::new(), dimension }
}

pub(super) fn number(name: &str, default: &str) -> Param {
    let kind = ParamKind::Number { dimension: LENGTH, default: exact(default), written_in: None };
    Param { name: ident(name), docs: Vec::new(), kind }
}

pub(super) fn output(field: &str, kind: OutputKind) -> DeclaredOutput {
    DeclaredOutput { field: ident(field), docs: Vec::new(), kind }
}

fn group(keyword: &str, title: &str) -> GroupName {
    GroupName { keyword: ident(keyword), title: title.to_string() }
}

pub(super) fn mechanism(name: &str, inputs: Vec<Input>, outputs: Vec<DeclaredOutput>) -> Mechanism {
    let empty = Mechanism::empty(Vec::new(), syn::parse_quote!(pub), ident(name));
    Mechanism { inputs, outputs, ..empty }
}

/// One input `theta` and one output, the value `y`, which a single entry computes.
pub(super) fn one_value(build: impl FnOnce(&mut Graph) -> Id) -> (Mechanism, Program) {
    let kind = OutputKind::Value { value: Scalar::Input(InputId(0)), dimension: LENGTH };
    let mechanism = mechanism("Tiny", vec![input("theta", ANGLE)], vec![output("y", kind)]);
    let mut graph = Graph::new();
    let sinks = vec![build(&mut graph)];
    let answers = vec![EntryOutputs { entry: Some(EntryPoint::named("position")), sinks }];
    (
        mechanism,
        Program {
            graph,
            answers,
            clearances: Vec::new(),
            closures: Vec::new(),
            groups: vec!["BC, DC".to_string(), "E".to_string()],
        },
    )
}

/// A crank-rocker with a tunable crank and mode: A at the origin, D at (0.6657, 0).
pub(super) fn four_bar() -> (Mechanism, Program) {
    let link = |name: &str, made_by| Link {
        name: ident(name),
        docs: Vec::new(),
        made_by: GroupId(made_by),
        slides: false,
        stands_for: StandsFor::Itself,
    };
    let direction = |link| OutputKind::Link { link: LinkId(link), direction: true, slide: false };
    let outputs = vec![
        output("C", OutputKind::Point(PointId(0))),
        output("BC", direction(1)),
        output("DC", direction(2)),
        output("DC_margin", OutputKind::Margin(GroupId(1))),
    ];
    let mut shear = mechanism("FourBar", vec![input("theta", ANGLE)], outputs);
    shear.docs = docs(" A crank-rocker.");
    shear.inputs[0].docs = docs(" The crank's angle.");
    let side = ParamKind::Mode { of: Modes::Side, default: Sign::Plus };
    let mode = Param { name: ident("elbow"), docs: Vec::new(), kind: side };
    shear.params = vec![number("crank", "0.08"), mode];
    let part_of = PartOf::Pin(GroupId(1));
    shear.points = vec![Point {
        name: ident("C"),
        docs: docs(" The coupler's pin."),
        part_of,
        is_hidden: false,
    }];
    shear.links = vec![link("AB", 0), link("BC", 1), link("DC", 1)];
    shear.groups = vec![group("crank", "AB"), group("rrr", "BC, DC")];
    (shear, four_bar_program())
}

fn four_bar_program() -> Program {
    let mut graph = Graph::new();
    let angle = graph.push(Node::Input { input: 0, order: 0 });
    let rate = graph.push(Node::Input { input: 0, order: 1 });
    let second = graph.push(Node::Input { input: 0, order: 2 });
    let unit = graph.constant(exact("1"));
    let turned = [
        graph.push(Node::Apply(Function::Cos, angle)),
        graph.push(Node::Apply(Function::Sin, angle)),
    ];
    let given = [graph.push(Node::InputCos(0)), graph.push(Node::InputSin(0))];
    let orders = |graph: &mut Graph, direction| {
        let pose = Pose::new(graph, direction);
        let velocity = pose.velocity(graph, rate);
        let acceleration = pose.acceleration(graph, rate, second);
        let motion = [pose.sinks.clone(), velocity.clone(), acceleration].concat();
        (pose, velocity, motion)
    };
    let (pose, velocity, motion) = orders(&mut graph, turned);
    let (pose_at, velocity_at, motion_at) = orders(&mut graph, given);
    let coefficients = pose.velocity(&mut graph, unit);
    let margin = vec![pose.sinks[6]];
    let answers = [
        ("position", pose.sinks),
        ("velocity", velocity),
        ("motion", motion),
        ("coefficients", coefficients),
        ("position_at", pose_at.sinks),
        ("velocity_at", velocity_at),
        ("motion_at", motion_at),
        ("margins", margin),
    ];
    let answers = answers
        .map(|(entry, sinks)| EntryOutputs { entry: Some(EntryPoint::named(entry)), sinks })
        .to_vec();
    Program {
        graph,
        answers,
        clearances: Vec::new(),
        closures: Vec::new(),
        groups: vec!["AB".to_string(), "BC, DC".to_string()],
    }
}

type Vector = [Id; 2];

/// The graph of the position, by the vectors that the rates need.
struct Pose {
    /// A to B, B to C, D to C.
    bars: [Vector; 3],
    /// The cross product of the dyad's bars, not zero.
    jacobian: Id,
    zero: Id,
    sinks: Vec<Id>,
}

impl Pose {
    fn new(g: &mut Graph, [cos, sin]: Vector) -> Self {
        let (l1, l2) = (exact("0.632"), exact("0.374"));
        let crank = g.push(Node::Param(0));
        let mode = g.push(Node::Mode(1));
        let ab = [g.push(Node::Mul(crank, cos)), g.push(Node::Mul(crank, sin))];
        let ad = g.constant(exact("0.6657"));
        let d = [g.push(Node::Sub(ad, ab[0])), g.push(Node::Neg(ab[1]))];
        let reach = dot(g, d, d);
        let check = |check, operands| Guard { check, group: 1, operands };
        let reach = g.guard(reach, check(Check::Square, Vec::new()));
        let (sum, difference) = (l1.add(&l2), l1.sub(&l2));
        let squares = [sum.mul(&sum), difference.mul(&difference), sum.mul(&difference)];
        let [largest, smallest, skew] = squares.map(|value| g.constant(value));
        let outside = g.push(Node::Sub(largest, reach));
        let inside = g.push(Node::Sub(reach, smallest));
        let factors = [outside, inside].map(|factor| g.push(Node::Div(factor, reach)));
        let height = g.push(Node::Mul(factors[0], factors[1]));
        let lengths = [&l1, &l2].map(|length| g.constant(length.clone()));
        let spread = g.constant(exact("2"));
        let operands = vec![d[0], d[1], lengths[0], lengths[1], spread];
        let height = g.guard(height, check(Check::ReachCircles, operands));
        let height = g.push(Node::Apply(Function::Sqrt, height));
        let across = g.push(Node::Mul(mode, height));
        let (one, half) = (g.constant(exact("1")), g.constant(exact("0.5")));
        let skew = g.push(Node::Div(skew, reach));
        let along = g.push(Node::Add(one, skew));
        let [along, across] = [along, across].map(|factor| g.push(Node::Mul(half, factor)));
        let bc = combine(g, [along, across], d);
        let dc = [0, 1].map(|i| g.push(Node::Sub(bc[i], d[i])));
        let c = [0, 1].map(|i| g.push(Node::Add(ab[i], bc[i])));
        let jacobian = g.push(Node::Det([bc[0], dc[1], bc[1], dc[0]]));
        let jacobian = g.guard(jacobian, check(Check::Nonzero, Vec::new()));
        let unit = |g: &mut Graph, v: Vector, length| v.map(|part| g.push(Node::Div(part, length)));
        let (bc_unit, dc_unit) = (unit(g, bc, lengths[0]), unit(g, dc, lengths[1]));
        let sinks = [&c[..], &bc_unit, &dc_unit, &[outside]].concat();
        Self { bars: [ab, bc, dc], jacobian, zero: g.constant(exact("0")), sinks }
    }

    /// ω of the dyad's bars, so that B and D's ends of them move apart by `k`.
    fn rates(&self, g: &mut Graph, k: Vector) -> Vector {
        [self.bars[2], self.bars[1]].map(|bar| {
            let product = dot(g, k, bar);
            let quotient = g.push(Node::Div(product, self.jacobian));
            g.push(Node::Neg(quotient))
        })
    }

    fn velocity(&self, g: &mut Graph, rate: Id) -> Vec<Id> {
        let b = combine(g, [self.zero, rate], self.bars[0]);
        let omega = self.rates(g, b);
        let c = combine(g, [self.zero, omega[1]], self.bars[2]);
        [&c[..], &omega, &[self.zero]].concat()
    }

    fn acceleration(&self, g: &mut Graph, rate: Id, second: Id) -> Vec<Id> {
        let b = combine(g, [self.zero, rate], self.bars[0]);
        let omega = self.rates(g, b);
        let [towards_a, towards_b, towards_d] = [rate, omega[0], omega[1]].map(|omega| {
            let square = g.push(Node::Mul(omega, omega));
            g.push(Node::Neg(square))
        });
        let b = combine(g, [towards_a, second], self.bars[0]);
        let on_bc = combine(g, [towards_b, self.zero], self.bars[1]);
        let on_dc = combine(g, [towards_d, self.zero], self.bars[2]);
        let k = [0, 1].map(|i| {
            let moved = g.push(Node::Add(b[i], on_bc[i]));
            g.push(Node::Sub(moved, on_dc[i]))
        });
        let alpha = self.rates(g, k);
        let c = combine(g, [towards_d, alpha[1]], self.bars[2]);
        [&c[..], &alpha, &[self.zero]].concat()
    }
}

fn dot(g: &mut Graph, a: Vector, b: Vector) -> Id {
    let products = [0, 1].map(|i| g.push(Node::Mul(a[i], b[i])));
    g.push(Node::Add(products[0], products[1]))
}

/// along · v + across · v⊥
fn combine(g: &mut Graph, [along, across]: Vector, v: Vector) -> Vector {
    let minus = g.push(Node::Neg(v[1]));
    [(v[0], minus), (v[1], v[0])].map(|(straight, turned)| {
        let straight = g.push(Node::Mul(along, straight));
        g.push(Node::Fused(across, turned, straight))
    })
}

/// A table of two slides: every shape that the four-bar lacks, and two inputs.
pub(super) fn table() -> (Mechanism, Program) {
    let link = |name: &str| Link {
        name: ident(name),
        docs: Vec::new(),
        made_by: GroupId(0),
        slides: true,
        stands_for: StandsFor::Itself,
    };
    let output_of =
        |link, direction| OutputKind::Link { link: LinkId(link), direction, slide: true };
    let sum = Scalar::Input(InputId(0));
    let area = Dimension { length: 2, ..Dimension::NUMBER };
    let outputs = vec![
        output("ram", output_of(0, true)),
        output("bed", output_of(1, false)),
        output("area", OutputKind::Value { value: sum.clone(), dimension: area }),
        output("turn", OutputKind::Angle(AngleSum { links: Vec::new(), rest: sum })),
    ];
    let mut table = mechanism("Table", vec![input("s", LENGTH), input("X", LENGTH)], outputs);
    table.visibility = Visibility::Inherited;
    let sense = ParamKind::Mode { of: Modes::Sense, default: Sign::Minus };
    table.params = vec![Param { name: ident("way"), docs: Vec::new(), kind: sense }];
    table.links = vec![link("ram"), link("bed")];
    table.groups = vec![group("slider", "ram")];
    let mut g = Graph::new();
    let [s, s1, x, x1] =
        [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(input, order)| g.push(Node::Input { input, order }));
    let way = g.push(Node::Mode(0));
    let [zero, one] = ["0", "1"].map(|digits| g.constant(exact(digits)));
    let slide = g.push(Node::Mul(way, s));
    let area = g.push(Node::Mul(s, x));
    let (cos, sin) = (g.push(Node::Apply(Function::Cos, s)), g.push(Node::Apply(Function::Sin, s)));
    let slide1 = g.push(Node::Mul(way, s1));
    let parts = [g.push(Node::Mul(s1, x)), g.push(Node::Mul(s, x1))];
    let area1 = g.push(Node::Add(parts[0], parts[1]));
    let answers = vec![
        EntryOutputs {
            entry: Some(EntryPoint::named("position")),
            sinks: vec![one, zero, slide, x, area, cos, sin],
        },
        EntryOutputs {
            entry: Some(EntryPoint::named("velocity")),
            sinks: vec![zero, slide1, x1, area1, s1],
        },
        EntryOutputs {
            entry: Some(EntryPoint::named("coefficients")),
            sinks: vec![zero, way, zero, x, one, zero, zero, one, s, zero],
        },
    ];
    (
        table,
        Program {
            graph: g,
            answers,
            clearances: Vec::new(),
            closures: Vec::new(),
            groups: Vec::new(),
        },
    )
}
