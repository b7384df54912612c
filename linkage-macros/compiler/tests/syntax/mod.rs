//! The parser on tiny declarations: trees in text form, and mistakes with their tokens.

pub(crate) mod actions;
pub(crate) mod expression_mistakes;
pub(crate) mod group_mistakes;
pub(crate) mod inputs;
pub(crate) mod links;
pub(crate) mod number;
pub(crate) mod recovery;
pub(crate) mod solve;
pub(crate) mod statement_mistakes;
pub(crate) mod trees;

use std::fmt::Write;
use std::ops::Range;

use self::tree::*;
use crate::diagnostics::{Diagnostics, told};
use crate::mistakes::proposals_are_read;
use crate::syntax::tree::{
    CrateStatement, ExportStatement, ForceBetweenStatement, ForceStatement, GravityStatement,
    GroundStatement, GuideStatement, InertiaStatement, InputStatement, LetStatement, LoadStatement,
    MassStatement, NumericsStatement, OutputStatement, ParamStatement, PointStatement,
    SpringStatement, TorqueBetweenStatement, TorqueStatement, UnknownStatement,
};
pub(crate) use linkage_compiler::syntax::*;

/// The mistakes of a source text, as `told` writes them.
fn mistakes(source: &str) -> String {
    parsed(source).1
}

/// The tree of a declaration with these statements, and its mistakes.
fn body(statements: &str) -> (String, String) {
    let (start, source) = ("pub struct M { ", format!("pub struct M {{ {statements} }}"));
    let row = start.len()..start.len() + statements.len();
    let (tree, mistakes) = parsed_row(&source, row);
    (tree.expect("the declaration has a name").replacen("pub M\n", "", 1), mistakes)
}

fn parsed(source: &str) -> (Option<String>, String) {
    parsed_row(source, 0..source.len())
}

fn parsed_row(source: &str, row: Range<usize>) -> (Option<String>, String) {
    let mut diagnostics = Diagnostics::new();
    let tokens = source.parse().expect("the source is made of Rust's tokens");
    let tree = parse(tokens, &mut diagnostics).map(|declaration| text(&declaration));
    (tree, told(&diagnostics.into_mistakes(), source, row))
}

/// Compares the mistakes of each source text; the rows are `(source, mistakes)`.
fn check(rows: &[(&str, &str)], mistakes: impl Fn(&str) -> String) {
    let mut other = String::new();
    for (source, expected) in rows {
        let found = mistakes(source);
        proposals_are_read(&found);
        if found != *expected {
            other += &format!("{source}\nexpected:\n{expected}\nfound:\n{found}\n\n");
        }
    }
    assert!(other.is_empty(), "{other}");
}

fn check_statements(rows: &[(&str, &str)]) {
    check(rows, |statements| body(statements).1);
}

/// One line per statement; expressions with every operator in parentheses.
fn text(declaration: &Declaration) -> String {
    let visibility = match declaration.visibility {
        syn::Visibility::Public(_) => "pub ",
        syn::Visibility::Restricted(_) => "restricted ",
        syn::Visibility::Inherited => "",
    };
    let mut text = format!("{visibility}{}\n", declaration.name);
    for statement in &declaration.statements {
        let docs = "/// ".repeat(statement.docs.len());
        writeln!(text, "{docs}{}", kind(&statement.kind)).expect("a string takes everything");
    }
    text.trim_end().to_string()
}

fn kind(kind: &StatementKind) -> String {
    match kind {
        StatementKind::Input(InputStatement { names, of, .. }) if !of.is_empty() => {
            let items = names.iter().zip(of).map(|(name, of)| format!("{name} = {}", expr(of)));
            format!("input {}", items.collect::<Vec<_>>().join(", "))
        }
        StatementKind::InputSet(InputSetStatement { name, coordinates }) => {
            let items = coordinates.iter().map(|SetCoordinate { name, of }| match of {
                Some(of) => format!("{name} = {}", expr(of)),
                None => name.to_string(),
            });
            format!("input {name} {{ {} }}", items.collect::<Vec<_>>().join(", "))
        }
        StatementKind::Input(InputStatement { names, kind, .. }) => {
            let kind = kind.as_ref().map_or("?".to_string(), ToString::to_string);
            format!("input {}: {kind}", list(names))
        }
        StatementKind::Param(ParamStatement { name, kind: None, default }) => {
            format!("param {name} = {}", expr(default))
        }
        StatementKind::Param(ParamStatement { name, kind: Some(kind), default }) => {
            format!("param {name}: {kind} = {}", expr(default))
        }
        StatementKind::Let(LetStatement { name, value }) => format!("let {name} = {}", expr(value)),
        StatementKind::Ground(GroundStatement { points }) => {
            let points = points.iter().map(|(name, at)| format!("{name}{}", pair(at)));
            format!("ground {}", points.collect::<Vec<_>>().join(", "))
        }
        StatementKind::Pin(_)
        | StatementKind::Link(_)
        | StatementKind::Drive(_)
        | StatementKind::DriveBy(_) => links::drawn(kind),
        StatementKind::Guide(GuideStatement { name, on, through, course }) => {
            let through = match through {
                GuideAnchor::At(at) => pair(at),
                GuideAnchor::Point(point) => point.to_string(),
                GuideAnchor::Mistake => "?".to_string(),
            };
            let course = match course {
                Course::Along(angle) => format!("along {}", expr(angle)),
                Course::Towards(point) => format!("towards {point}"),
                Course::Mistake => "?".to_string(),
            };
            format!("guide {name}{} through {through} {course}", carrier(on))
        }
        StatementKind::Point(PointStatement { name, on, place }) => {
            let place = match place {
                PointPlace::Cartesian(at) => pair(at),
                PointPlace::Polar(at) => format!("polar {}", pair(at)),
                PointPlace::Distances(at, side) => format!("distances {} {side}", pair(at)),
                PointPlace::Mistake => "?".to_string(),
            };
            format!("point {name}{} at {place}", carrier(on))
        }
        StatementKind::Group(group) => self::group(group),
        StatementKind::Output(OutputStatement { items, .. }) => {
            let items = items.iter().map(|item| match &item.name {
                Some(name) => format!("{name} = {}", expr(&item.value)),
                None => expr(&item.value),
            });
            format!("output {}", items.collect::<Vec<_>>().join(", "))
        }
        StatementKind::Numerics(NumericsStatement { mode }) => format!("numerics {mode}"),
        StatementKind::Crate(CrateStatement { path }) => {
            format!(
                "crate = {}",
                quote::ToTokens::to_token_stream(path).to_string().replace(' ', "")
            )
        }
        StatementKind::Export(ExportStatement { what }) => format!("export {what}"),
        StatementKind::Load(LoadStatement { names, kind }) => {
            let kind = kind.as_ref().map_or("?".to_string(), ToString::to_string);
            format!("load {}: {kind}", list(names))
        }
        StatementKind::Action(action) => self::action(action),
        StatementKind::Unknown(UnknownStatement { name, kind, between }) => {
            let kind = kind.as_ref().map_or("?".to_string(), ToString::to_string);
            let between = between.as_ref().map_or("?".to_string(), pair);
            format!("unknown {name}: {kind} between {between}")
        }
        StatementKind::Solve(Solve { unknown, equation, mode, near, .. }) => {
            let sides = |[left, right]: &[Expr; 2]| format!("{} = {}", expr(left), expr(right));
            let equation = equation.as_ref().map_or("?".to_string(), sides);
            let mode = mode.as_ref().map_or("?".to_string(), ToString::to_string);
            let near = near.as_ref().map(|near| format!(", near: {}", expr(near)));
            format!("solve {unknown} {{ {equation}, mode: {mode}{} }}", near.unwrap_or_default())
        }
    }
}

fn action(action: &Action) -> String {
    match action {
        Action::Gravity(GravityStatement { value, .. }) => format!("gravity {}", pair(value)),
        Action::Mass(MassStatement { value, on, place, inertia }) => {
            let place = match place {
                MassSite::Here => String::new(),
                MassSite::At(at) => format!(" at {}", pair(at)),
                MassSite::Point(point) => format!(" at {point}"),
                MassSite::Uniform(_) => " uniform".to_string(),
            };
            let inertia = inertia.as_ref().map(|value| format!(" inertia {}", expr(value)));
            format!("mass {} on {on}{place}{}", expr(value), inertia.unwrap_or_default())
        }
        Action::Inertia(InertiaStatement { value, on }) => {
            format!("inertia {} on {on}", expr(value))
        }
        Action::Force(ForceStatement { value, axes, on }) => {
            let axes = axes.as_ref().map(|axes| format!(" in {axes}")).unwrap_or_default();
            format!("force {}{axes} on {on}", pair(value))
        }
        Action::ForceBetween(ForceBetweenStatement { value, points: [p, q] }) => {
            format!("force {} between {p} and {q}", expr(value))
        }
        Action::Torque(TorqueStatement { value, on }) => format!("torque {} on {on}", expr(value)),
        Action::TorqueBetween(TorqueBetweenStatement { value, bodies: [a, b] }) => {
            format!("torque {} between {a} and {b}", expr(value))
        }
        Action::Spring(SpringStatement { name, ends: [a, b], fields }) => {
            let name = name.as_ref().map(|name| format!("{name} ")).unwrap_or_default();
            format!("spring {name}between {a} and {b} {{ {} }}", self::fields(fields))
        }
        Action::Stop(StopStatement { name, of, ends: [from, to], fields }) => {
            let name = name.iter().map(|name| format!("{name} ")).collect::<String>();
            let [of, from, to] = [of, from, to].map(expr);
            format!("stop {name}{of} between ({from}, {to}) {{ {} }}", self::fields(fields))
        }
        Action::Friction(friction) => {
            let site = match &friction.site {
                FrictionSite::Pin(pin) => format!("at {pin}"),
                FrictionSite::LinkAtPin(link, pin) => format!("on {link} at {pin}"),
                FrictionSite::Slider(link) => format!("on {link}"),
                FrictionSite::Between([a, b], pin) => format!("between {a} and {b} at {pin}"),
            };
            let FrictionStatement { radius, length, smooth, .. } = friction;
            let parts = [("radius", radius), ("length", length), ("smooth", smooth)];
            let parts = parts.iter().filter_map(|(word, part)| {
                part.as_ref().map(|part| format!(" {word} {}", expr(part)))
            });
            let parts: String = parts.collect();
            format!("friction {} {site}{parts}", expr(&friction.coefficient))
        }
    }
}

fn group(group: &GroupStatement) -> String {
    let legs = group.legs.iter().map(|leg| match &leg.joint {
        Some(joint) => format!("{}({joint})", leg.link),
        None => format!("{}(?)", leg.link),
    });
    let pin = group.pin.as_ref().map(|pin| format!(" -> {pin}")).unwrap_or_default();
    let legs = legs.collect::<Vec<_>>().join(", ");
    format!("{} {legs}{pin} {{ {} }}", group.keyword, fields(group))
}

fn fields(group: &GroupStatement) -> String {
    let fields = group.fields.iter().map(|field| match &field.value {
        GroupFieldValue::One(value) => format!("{}: {}", field.name, expr(value)),
        GroupFieldValue::Pair(values) => format!("{}: {}", field.name, pair(values)),
    });
    fields.collect::<Vec<_>>().join(", ")
}

fn carrier(on: &Option<proc_macro2::Ident>) -> String {
    on.as_ref().map(|link| format!(" on {link}")).unwrap_or_default()
}

fn list(names: &[proc_macro2::Ident]) -> String {
    names.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

fn pair(values: &[Expr; 2]) -> String {
    format!("({}, {})", expr(&values[0]), expr(&values[1]))
}

fn expr(value: &Expr) -> String {
    match &value.kind {
        ExprKind::Number { digits, units } => match &units[..] {
            [] => digits.clone(),
            [(unit, 1)] => format!("{digits}{unit}"),
            units => {
                let units: Vec<_> = units.iter().map(|(u, power)| format!("{u}^{power}")).collect();
                format!("{digits}({})", units.join(" "))
            }
        },
        ExprKind::Name(name) => name.to_string(),
        ExprKind::Part(path) => path.each_ref().map(ToString::to_string).join("."),
        ExprKind::Member(link, member) => format!("{link}.{member}"),
        ExprKind::Negate(operand) => format!("(-{})", expr(operand)),
        ExprKind::Chain(first, rest) => rest.iter().fold(expr(first), |left, (operator, right)| {
            let sign = match operator {
                BinaryOp::Add => '+',
                BinaryOp::Sub => '-',
                BinaryOp::Mul => '*',
                BinaryOp::Div => '/',
            };
            format!("({left} {sign} {})", expr(right))
        }),
        ExprKind::Call(name, arguments) => {
            format!("{name}({})", arguments.iter().map(expr).collect::<Vec<_>>().join(", "))
        }
        ExprKind::Mistake => "?".to_string(),
    }
}
