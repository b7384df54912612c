//! The declaration of the groups as text, for the documentation of the solver.

use syn::Attribute;

use crate::syntax::tree::{
    Action, CrateStatement, DriveByStatement, ExportStatement, ForceBetweenStatement,
    ForceStatement, FrictionSite, FrictionStatement, GravityStatement, GroundStatement,
    GuideStatement, InertiaStatement, InputStatement, LetStatement, LoadStatement, MassSite,
    MassStatement, NumericsStatement, OutputStatement, ParamStatement, PinStatement,
    PointStatement, SpringStatement, StopStatement, TorqueBetweenStatement, TorqueStatement,
    UnknownStatement,
};
use crate::syntax::tree::{
    BinaryOp, Course, Declaration, Expr, ExprKind, GroupFieldValue, GroupStatement, GuideAnchor,
    PointPlace, Statement, StatementKind,
};

use super::writer::Translated;
use super::written::{Sought, Stretch};

/// What was found in the drawing, as documentation of the struct.
pub(super) fn documentation(tree: &Declaration, translated: &Translated) -> Vec<Attribute> {
    let mut lines = vec![
        String::new(),
        " # Groups found in the drawing".to_string(),
        String::new(),
        " The links and joints of the drawing are these drivers and groups:".to_string(),
        String::new(),
        " ```text".to_string(),
        " mechanism! {".to_string(),
        format!("     pub struct {} {{", tree.name),
    ];
    let statements = translated.statements.iter();
    lines.extend(statements.map(|statement| format!("         {}", written(statement))));
    lines.extend(["     }", " }", " ```"].map(String::from));
    for Sought { unknown, traced, stretches } in &translated.searches {
        let goes = stretches.iter().map(goes).collect::<Vec<_>>().join(", and while ");
        let alone = if stretches.len() > 1 { ", the others as drawn" } else { "" };
        lines.push(String::new());
        lines.push(match traced {
            None => format!(
                " `{unknown}` is searched in one interval: it was followed while {goes} about the drawing{alone}."
            ),
            Some(traced) => format!(
                " `{unknown}` is searched beside `{traced}`, which is the motion of the drawing to \
                 within a third of the interval while {goes} about the drawing."
            ),
        });
    }
    lines.iter().map(|line| syn::parse_quote!(#[doc = #line])).collect()
}

fn goes(Stretch { input, ends, is_angle }: &Stretch) -> String {
    let [from, to] = match is_angle {
        true => ends.map(|end| format!("{:.1}°", end.to_degrees() + 0.0)),
        false => ends.map(|end| format!("{:.3} m", end + 0.0)),
    };
    let who = input.as_ref().map_or("the first drive".to_string(), |input| format!("`{input}`"));
    format!("{who} goes from {from} to {to}")
}

/// A statement as it is declared.
pub(super) fn written(statement: &Statement) -> String {
    let named = |names: &[proc_macro2::Ident]| {
        names.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
    };
    let kind_of = |kind: &Option<proc_macro2::Ident>| {
        kind.as_ref().map(|kind| format!(": {kind}")).unwrap_or_default()
    };
    match &statement.kind {
        StatementKind::Input(InputStatement { names, kind }) => {
            format!("input {}{};", named(names), kind_of(kind))
        }
        StatementKind::Load(LoadStatement { names, kind }) => {
            format!("load {}{};", named(names), kind_of(kind))
        }
        StatementKind::DriveBy(DriveByStatement { input, load }) => {
            format!("drive {input} by {load};")
        }
        StatementKind::Param(ParamStatement { name, kind, default }) => {
            format!("param {name}{} = {};", kind_of(kind), text(default))
        }
        StatementKind::Let(LetStatement { name, value }) => {
            format!("let {name} = {};", text(value))
        }
        StatementKind::Unknown(UnknownStatement { name, kind, between }) => {
            let ends = between.as_ref().map(pair).unwrap_or_default();
            format!("unknown {name}{} between {ends};", kind_of(kind))
        }
        StatementKind::Solve(solve) => {
            let [left, right] =
                solve.equation.as_ref().map(|sides| sides.each_ref().map(text)).unwrap_or_default();
            let mode = solve.mode.iter().map(|mode| format!(", mode: {mode}"));
            let near = solve.near.iter().map(|near| format!(", near: {}", text(near)));
            let fields: String = mode.chain(near).collect();
            format!("solve {} {{ {left} = {right}{fields} }}", solve.unknown)
        }
        StatementKind::Ground(GroundStatement { points })
        | StatementKind::Pin(PinStatement { points }) => {
            let points = points.iter().map(|(name, at)| format!("{name}{}", pair(at)));
            format!("ground {};", points.collect::<Vec<_>>().join(", "))
        }
        StatementKind::Guide(GuideStatement { name, on, through, course }) => {
            format!("guide {name}{} {};", on_link(on.as_ref()), line(through, course))
        }
        StatementKind::Point(PointStatement { name, on, place }) => {
            format!("point {name}{} {};", on_link(on.as_ref()), spot(place))
        }
        StatementKind::Group(group) => written_group(group),
        StatementKind::Action(action) => written_action(action),
        StatementKind::Output(OutputStatement { items }) => {
            let items = items.iter().map(|item| match &item.name {
                Some(name) => format!("{name} = {}", text(&item.value)),
                None => text(&item.value),
            });
            format!("output {};", items.collect::<Vec<_>>().join(", "))
        }
        StatementKind::Numerics(NumericsStatement { mode }) => format!("numerics {mode};"),
        StatementKind::Export(ExportStatement { language }) => format!("export {language};"),
        StatementKind::Crate(CrateStatement { path }) => {
            format!("crate = {};", quote::quote!(#path).to_string().replace(' ', ""))
        }
        StatementKind::Link(_) | StatementKind::Drive(_) => String::new(),
    }
}

fn on_link(on: Option<&proc_macro2::Ident>) -> String {
    on.map(|on| format!(" on {on}")).unwrap_or_default()
}

fn line(through: &GuideAnchor, course: &Course) -> String {
    let through = match through {
        GuideAnchor::At(place) => pair(place),
        GuideAnchor::Point(point) => point.to_string(),
        GuideAnchor::Mistake => String::new(),
    };
    match course {
        Course::Along(angle) => format!("through {through} along {}", text(angle)),
        Course::Towards(point) => format!("through {through} towards {point}"),
        Course::Mistake => String::new(),
    }
}

fn spot(place: &PointPlace) -> String {
    match place {
        PointPlace::Cartesian(place) => format!("at {}", pair(place)),
        PointPlace::Polar(place) => format!("at polar {}", pair(place)),
        PointPlace::Distances(distances, side) => {
            format!("at distances {} {side}", pair(distances))
        }
        PointPlace::Mistake => String::new(),
    }
}

fn written_group(group: &GroupStatement) -> String {
    let leg = |leg: &crate::syntax::tree::Leg| match &leg.joint {
        Some(joint) => format!("{}({joint})", leg.link),
        None => leg.link.to_string(),
    };
    let legs: Vec<_> = group.legs.iter().map(leg).collect();
    let pin = group.pin.iter().map(|pin| format!(" -> {pin}")).collect::<String>();
    format!("{} {}{pin} {}", group.keyword, legs.join(", "), braces(group))
}

fn braces(group: &GroupStatement) -> String {
    let fields = group.fields.iter().map(|field| match &field.value {
        GroupFieldValue::One(value) => format!("{}: {}", field.name, text(value)),
        GroupFieldValue::Pair(values) => format!("{}: {}", field.name, pair(values)),
    });
    match fields.collect::<Vec<_>>() {
        fields if fields.is_empty() => "{ }".to_string(),
        fields => format!("{{ {} }}", fields.join(", ")),
    }
}

fn written_action(action: &Action) -> String {
    match action {
        Action::Gravity(GravityStatement { value, .. }) => format!("gravity {};", pair(value)),
        Action::Mass(MassStatement { value, on, place, inertia }) => {
            let place = match place {
                MassSite::Here => String::new(),
                MassSite::At(place) => format!(" at {}", pair(place)),
                MassSite::Point(point) => format!(" at {point}"),
                MassSite::Uniform(_) => " uniform".to_string(),
            };
            let inertia = inertia.iter().map(|inertia| format!(" inertia {}", text(inertia)));
            format!("mass {} on {on}{place}{};", text(value), inertia.collect::<String>())
        }
        Action::Inertia(InertiaStatement { value, on }) => {
            format!("inertia {} on {on};", text(value))
        }
        Action::Force(ForceStatement { value, axes, on }) => {
            let axes = axes.iter().map(|axes| format!(" in {axes}")).collect::<String>();
            format!("force {}{axes} on {on};", pair(value))
        }
        Action::ForceBetween(ForceBetweenStatement { value, points: [a, b] }) => {
            format!("force {} between {a} and {b};", text(value))
        }
        Action::Torque(TorqueStatement { value, on }) => format!("torque {} on {on};", text(value)),
        Action::TorqueBetween(TorqueBetweenStatement { value, bodies: [a, b] }) => {
            format!("torque {} between {a} and {b};", text(value))
        }
        Action::Spring(SpringStatement { name, ends: [a, b], fields }) => {
            let name = name.iter().map(|name| format!(" {name}")).collect::<String>();
            format!("spring{name} between {a} and {b} {}", braces(fields))
        }
        Action::Friction(friction) => written_friction(friction),
        Action::Stop(StopStatement { name, of, ends, fields }) => {
            let name = name.iter().map(|name| format!(" {name}")).collect::<String>();
            format!("stop{name} {} between {} {}", text(of), pair(ends), braces(fields))
        }
    }
}

fn written_friction(friction: &FrictionStatement) -> String {
    let site = match &friction.site {
        FrictionSite::Pin(pin) => format!("at {pin}"),
        FrictionSite::LinkAtPin(link, pin) => format!("on {link} at {pin}"),
        FrictionSite::Slider(link) => format!("on {link}"),
        FrictionSite::Between([a, b], pin) => format!("between {a} and {b} at {pin}"),
    };
    let FrictionStatement { coefficient, radius, length, smooth, .. } = friction;
    let parts = [("radius", radius), ("length", length), ("smooth", smooth)];
    let parts = parts
        .iter()
        .filter_map(|(word, part)| part.as_ref().map(|part| format!(" {word} {}", text(part))));
    format!("friction {} {site}{};", text(coefficient), parts.collect::<String>())
}

fn pair([first, second]: &[Expr; 2]) -> String {
    format!("({}, {})", text(first), text(second))
}

/// An expression as it is written.
pub(in crate::model) fn text(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Number { digits, units } => match &units[..] {
            [] => digits.clone(),
            [(unit, 1)] => format!("{digits}{unit}"),
            units => {
                let units = units.iter().map(|(unit, power)| format!("{unit}^{power}"));
                format!("{digits}({})", units.collect::<Vec<_>>().join("*"))
            }
        },
        ExprKind::Name(name) => name.to_string(),
        ExprKind::Member(owner, member) => format!("{owner}.{member}"),
        ExprKind::Part(path) => path.each_ref().map(ToString::to_string).join("."),
        ExprKind::Negate(inner) => format!("-{}", operand(inner)),
        ExprKind::Chain(first, rest) => {
            let mut text = operand(first);
            for (operator, operand_of) in rest {
                let sign = match operator {
                    BinaryOp::Add => '+',
                    BinaryOp::Sub => '-',
                    BinaryOp::Mul => '*',
                    BinaryOp::Div => '/',
                };
                text += &format!(" {sign} {}", operand(operand_of));
            }
            text
        }
        ExprKind::Call(function, arguments) => {
            let arguments: Vec<_> = arguments.iter().map(text).collect();
            format!("{function}({})", arguments.join(", "))
        }
        ExprKind::Mistake => "…".to_string(),
    }
}

/// An operand, in parentheses where it is a chain itself.
fn operand(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Chain(..) => format!("({})", text(expr)),
        _ => text(expr),
    }
}
