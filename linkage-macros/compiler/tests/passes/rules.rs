//! The rules one by one, on text.

use crate::exact::Exact;
use crate::function::Function;
use crate::interface::entries::EntryPoint;
use crate::ir::construct::{Maker, Rule, rebuild};
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::program::{EntryOutputs, Program};
use crate::ir::text::text;
use crate::passes::{RULES, contract, fold, simplify};

/// A program of one sink, made without rules.
fn program(build: impl FnOnce(&mut Graph) -> Id) -> Program {
    let mut graph = Graph::new();
    let sink = build(&mut graph);
    let answers =
        vec![EntryOutputs { entry: Some(EntryPoint::named("position")), sinks: vec![sink] }];
    Program {
        graph,
        answers,
        clearances: Vec::new(),
        closures: Vec::new(),
        groups: vec!["AB".into()],
    }
}

pub(super) fn x(graph: &mut Graph) -> Id {
    graph.push(Node::Param(0))
}

pub(super) fn y(graph: &mut Graph) -> Id {
    graph.push(Node::Param(1))
}

pub(super) fn c(graph: &mut Graph, digits: &str) -> Id {
    let value = match digits.strip_prefix('-') {
        Some(digits) => Exact::decimal(digits).map(|value| value.neg()),
        None => Exact::decimal(digits),
    };
    graph.constant(value.expect("a decimal literal"))
}

/// The sink as nested text after the rules.
fn after(rules: &[Rule], build: impl FnOnce(&mut Graph) -> Id) -> String {
    let program = rebuild(&program(build), rules);
    nested(&program.graph, program.answers[0].sinks[0])
}

pub(super) fn nested(graph: &Graph, id: Id) -> String {
    let n = |id: Id| nested(graph, id);
    match graph.node(id) {
        Node::Constant(constant) => graph.value(constant).to_string(),
        Node::Param(0) => "x".into(),
        Node::Param(_) => "y".into(),
        Node::Mode(_) => "m".into(),
        Node::Neg(a) => format!("-{}", n(a)),
        Node::Add(a, b) => format!("({} + {})", n(a), n(b)),
        Node::Sub(a, b) => format!("({} - {})", n(a), n(b)),
        Node::Mul(a, b) => format!("{}*{}", n(a), n(b)),
        Node::Div(a, b) => format!("{}/{}", n(a), n(b)),
        Node::Fused(a, b, c) => format!("fused({}, {}, {})", n(a), n(b), n(c)),
        Node::Det([a, b, c, d]) => format!("det({}, {}, {}, {})", n(a), n(b), n(c), n(d)),
        Node::Select([a, b, x, y]) => format!("({} if {} ≥ {} else {})", n(x), n(a), n(b), n(y)),
        Node::MulErr(a, b) => format!("mul_err({}, {})", n(a), n(b)),
        Node::AddErr(a, b) => format!("add_err({}, {})", n(a), n(b)),
        Node::Apply(Function::Sqrt, a) => format!("sqrt({})", n(a)),
        Node::Guard(a, _) => n(a),
        other => format!("{other:?}"),
    }
}

macro_rules! rewrites {
    ($($name:ident: $rules:expr, |$g:ident| $build:expr => $expected:literal;)*) => {$(
        #[test]
        fn $name() {
            assert_eq!(after($rules, |$g| $build), $expected);
        }
    )*};
}

const FOLD: &[Rule] = &[fold::fold_constants];
const SIMPLIFY: &[Rule] = &[simplify::simplify];

rewrites! {
    constants_fold_exactly: FOLD, |g| { let (a, b) = (c(g, "0.1"), c(g, "0.2")); g.push(Node::Add(a, b)) } => "0.3";
    roots_of_squares_fold: FOLD, |g| { let a = c(g, "0.09"); g.push(Node::Apply(Function::Sqrt, a)) } => "0.3";
    constants_around_a_sum_become_one: SIMPLIFY, |g| { let (a, b, x) = (c(g, "0.5"), c(g, "2"), x(g)); let s = g.push(Node::Add(b, x)); g.push(Node::Add(a, s)) } => "(2.5 + x)";
    a_division_by_zero_is_left: FOLD, |g| { let (a, b) = (c(g, "1"), c(g, "0")); g.push(Node::Div(a, b)) } => "1/0";
    errors_of_constants_are_zero: FOLD, |g| { let (a, b) = (c(g, "0.1"), c(g, "0.2")); g.push(Node::MulErr(a, b)) } => "0";
    times_zero_is_zero: SIMPLIFY, |g| { let (a, b) = (x(g), c(g, "0")); g.push(Node::Mul(a, b)) } => "0";
    plus_zero_is_nothing: SIMPLIFY, |g| { let (a, b) = (c(g, "0"), x(g)); g.push(Node::Add(a, b)) } => "x";
    minus_zero_is_nothing: SIMPLIFY, |g| { let (a, b) = (x(g), c(g, "0")); g.push(Node::Sub(a, b)) } => "x";
    zero_minus_is_a_sign: SIMPLIFY, |g| { let (a, b) = (c(g, "0"), x(g)); g.push(Node::Sub(a, b)) } => "-x";
    times_one_is_nothing: SIMPLIFY, |g| { let (a, b) = (x(g), c(g, "1")); g.push(Node::Mul(a, b)) } => "x";
    times_minus_one_is_a_sign: SIMPLIFY, |g| { let (a, b) = (x(g), c(g, "-1")); g.push(Node::Mul(a, b)) } => "-x";
    by_one_is_nothing: SIMPLIFY, |g| { let (a, b) = (x(g), c(g, "1")); g.push(Node::Div(a, b)) } => "x";
    a_difference_with_itself_is_zero: SIMPLIFY, |g| { let a = x(g); g.push(Node::Sub(a, a)) } => "0";
    signs_cancel: SIMPLIFY, |g| { let a = x(g); let n = g.push(Node::Neg(a)); g.push(Node::Neg(n)) } => "x";
    a_difference_and_its_negative_are_one: SIMPLIFY, |g| { let (a, b) = (x(g), y(g)); let d = g.push(Node::Sub(a, b)); let e = g.push(Node::Sub(b, a)); g.push(Node::Div(d, e)) } => "-(x - y)/(x - y)";
    a_negative_constant_gives_its_sign_away: SIMPLIFY, |g| { let (a, k) = (x(g), c(g, "-3")); g.push(Node::Mul(k, a)) } => "-3*x";
    adding_a_negative_subtracts: SIMPLIFY, |g| { let (a, b) = (x(g), y(g)); let n = g.push(Node::Neg(b)); g.push(Node::Add(a, n)) } => "(x - y)";
    subtracting_a_negative_adds: SIMPLIFY, |g| { let (a, b) = (x(g), y(g)); let n = g.push(Node::Neg(b)); g.push(Node::Sub(a, n)) } => "(x + y)";
    two_negatives_add_under_one_sign: SIMPLIFY, |g| { let (a, b) = (x(g), y(g)); let n = g.push(Node::Neg(a)); g.push(Node::Sub(n, b)) } => "-(x + y)";
    signs_leave_products: SIMPLIFY, |g| { let (a, b) = (x(g), y(g)); let n = g.push(Node::Neg(a)); g.push(Node::Mul(n, b)) } => "-x*y";
    signs_leave_quotients: SIMPLIFY, |g| { let (a, b) = (x(g), y(g)); let n = g.push(Node::Neg(b)); g.push(Node::Div(a, n)) } => "-x/y";
    constants_meet_in_products: RULES, |g| { let (a, b, k) = (c(g, "0.5"), x(g), c(g, "3")); let p = g.push(Node::Mul(k, b)); g.push(Node::Mul(a, p)) } => "1.5*x";
    constants_meet_in_sums: RULES, |g| { let (a, b, k) = (c(g, "0.5"), x(g), c(g, "3")); let p = g.push(Node::Add(b, k)); g.push(Node::Add(a, p)) } => "(3.5 + x)";
    products_commute_into_one_form: SIMPLIFY, |g| { let (a, b) = (x(g), y(g)); g.push(Node::Mul(b, a)) } => "x*y";
    a_mode_squared_is_one: SIMPLIFY, |g| { let m = g.push(Node::Mode(2)); g.push(Node::Mul(m, m)) } => "1";
    quotients_of_equals_stay: RULES, |g| { let a = x(g); g.push(Node::Div(a, a)) } => "x/x";
    sums_do_not_reassociate: RULES, |g| { let (a, b) = (x(g), y(g)); let s = g.push(Node::Add(a, b)); g.push(Node::Sub(s, a)) } => "((x + y) - x)";
    products_do_not_distribute: RULES, |g| { let (a, b, k) = (x(g), y(g), c(g, "2")); let s = g.push(Node::Add(a, b)); g.push(Node::Mul(k, s)) } => "2*(x + y)";
    divisions_by_constants_stay: RULES, |g| { let (a, k) = (x(g), c(g, "3")); g.push(Node::Div(a, k)) } => "x/3";
    a_determinant_with_one_product_is_it: SIMPLIFY, |g| { let (a, b, o) = (x(g), y(g), c(g, "0")); g.push(Node::Det([a, b, o, b])) } => "x*y";
    a_determinant_with_the_other_product_is_its_negative: SIMPLIFY, |g| { let (a, b, o) = (x(g), y(g), c(g, "0")); g.push(Node::Det([o, b, a, b])) } => "-x*y";
    a_determinant_of_units_is_a_difference: SIMPLIFY, |g| { let (a, b, k) = (x(g), y(g), c(g, "1")); g.push(Node::Det([k, a, b, k])) } => "(x - y)";
    a_determinant_is_opaque: RULES, |g| { let (a, b, k) = (x(g), y(g), c(g, "3")); g.push(Node::Det([a, b, k, b])) } => "det(x, y, 3, y)";
    a_choice_between_constants_is_made: RULES, |g| { let (a, b, k, l) = (c(g, "5"), c(g, "7"), c(g, "2"), c(g, "3")); let far = g.push(Node::Select([l, k, b, a])); let near = g.push(Node::Select([k, l, b, a])); g.push(Node::Sub(far, near)) } => "2";
    the_first_of_equal_numbers_decides: RULES, |g| { let (a, b, k) = (c(g, "5"), c(g, "7"), c(g, "2")); g.push(Node::Select([k, k, a, b])) } => "5";
    a_choice_of_what_is_not_known_stays: RULES, |g| { let (a, b, k) = (x(g), y(g), c(g, "2")); g.push(Node::Select([a, b, k, a])) } => "(2 if x ≥ y else x)";
    a_product_with_one_has_no_error: SIMPLIFY, |g| { let (a, k) = (x(g), c(g, "-1")); g.push(Node::MulErr(a, k)) } => "0";
    an_error_has_its_products_sign: SIMPLIFY, |g| { let (a, b) = (x(g), y(g)); let n = g.push(Node::Neg(a)); g.push(Node::MulErr(n, b)) } => "-mul_err(x, y)";
    a_sum_with_zero_has_no_error: SIMPLIFY, |g| { let (a, k) = (x(g), c(g, "0")); g.push(Node::AddErr(a, k)) } => "0";
}

#[test]
fn what_no_sink_needs_is_left_behind() {
    let program = program(|g| {
        let (a, b) = (x(g), y(g));
        g.push(Node::Mul(a, b));
        g.push(Node::Neg(a))
    });
    assert_eq!(text(&rebuild(&program, &[])), "%0 = param 0\n%1 = neg %0\nposition: %1\n");
}

#[test]
fn a_rule_never_sees_a_node_twice() {
    // Under the rules a second rebuild changes nothing: one pass reaches the fixed point.
    let once = rebuild(
        &program(|g| {
            let (a, b, k) = (x(g), y(g), c(g, "2"));
            let n = g.push(Node::Neg(a));
            let p = g.push(Node::Mul(n, k));
            let q = g.push(Node::Mul(p, b));
            g.push(Node::Sub(b, q))
        }),
        RULES,
    );
    assert_eq!(text(&rebuild(&once, &[])), text(&rebuild(&once, RULES)));
}

fn fused(build: impl FnOnce(&mut Graph) -> Id) -> String {
    let program = contract::fuse_products(&program(build));
    nested(&program.graph, program.answers[0].sinks[0])
}

#[test]
fn a_product_and_a_sum_are_one_fused_operation() {
    let sum = fused(|g| {
        let (a, b) = (x(g), y(g));
        let p = g.push(Node::Mul(a, b));
        g.push(Node::Add(p, a))
    });
    assert_eq!(sum, "fused(x, y, x)");
    let less = fused(|g| {
        let (a, b) = (x(g), y(g));
        let p = g.push(Node::Mul(a, b));
        g.push(Node::Sub(a, p))
    });
    assert_eq!(less, "fused(-x, y, x)");
    let more = fused(|g| {
        let (a, b) = (x(g), y(g));
        let p = g.push(Node::Mul(a, b));
        g.push(Node::Sub(p, a))
    });
    assert_eq!(more, "fused(x, y, -x)");
}

#[test]
fn a_sum_does_not_wait_for_a_product_that_something_else_needs() {
    let kept = fused(|g| {
        let (a, b) = (x(g), y(g));
        let p = g.push(Node::Mul(a, b));
        let s = g.push(Node::Add(p, a));
        g.push(Node::Div(s, p))
    });
    assert_eq!(kept, "fused(x, y, x)/x*y");
}

#[test]
fn a_sum_of_a_product_and_what_is_made_of_it_stays() {
    let kept = fused(|g| {
        let (a, b) = (x(g), y(g));
        let p = g.push(Node::Mul(a, b));
        let square = g.push(Node::Mul(p, p));
        let magnitude = g.push(Node::Apply(Function::Sqrt, square));
        g.push(Node::Add(p, magnitude))
    });
    assert_eq!(kept, "(x*y + sqrt(x*y*x*y))");
}

#[test]
fn a_product_whose_error_is_asked_for_stays() {
    let kept = fused(|g| {
        let (a, b) = (x(g), y(g));
        let p = g.push(Node::Mul(a, b));
        let e = g.push(Node::MulErr(a, b));
        let s = g.push(Node::Add(p, a));
        g.push(Node::Add(s, e))
    });
    assert_eq!(kept, "((x*y + x) + mul_err(x, y))");
}

#[test]
fn a_sum_whose_error_is_asked_for_stays() {
    let kept = fused(|g| {
        let (a, b) = (x(g), y(g));
        let p = g.push(Node::Mul(a, b));
        let n = g.push(Node::Neg(a));
        let s = g.push(Node::Sub(p, a));
        let e = g.push(Node::AddErr(p, n));
        g.push(Node::Add(s, e))
    });
    assert_eq!(kept, "((x*y - x) + add_err(x*y, -x))");
}

#[test]
fn the_maker_gives_equal_nodes_one_id() {
    let mut graph = Graph::new();
    let mut maker = Maker { graph: &mut graph, rules: RULES };
    let (a, b) = (maker.make(Node::Param(0)), maker.make(Node::Param(1)));
    assert_eq!(maker.make(Node::Add(a, b)), maker.make(Node::Add(b, a)));
}
