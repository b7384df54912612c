//! The verb `draw`: a pose as SVG.

use linkage_compiler::{DrawnPose, PageParts, PlanMember, PlanParts, PlanStatement, drawing, page};
use linkage_core::sketch::{Element, Member, Plan, Sketch, Spring};

use crate::arguments::Draw;
use crate::output::{self, Failure};
use crate::pose::{PoseConditions, lasting};
use crate::program::Program;
use crate::values::{FlagValue, known};

pub(crate) fn run(arguments: &Draw) -> Result<(), Failure> {
    let program = Program::read(&arguments.file, &arguments.chosen)?;
    let parts = program.all(page)?;
    let at = parts.iter().map(|parts| inputs(parts, arguments));
    let at: Vec<Vec<f64>> = at.collect::<Result<_, _>>()?;
    let placed = program.declarations()?.into_iter().zip(&at).map(|(declaration, at)| {
        let mut conditions = PoseConditions::new();
        let pose = drawing(declaration.tokens, at, &mut conditions);
        (pose.expect("its page has been made"), conditions)
    });
    let mut drawn = Vec::new();
    for (pose, conditions) in placed {
        let name = pose.plan.name.clone();
        let svg = drawn_pose(pose, conditions, arguments)
            .map_err(|why| Failure::Unusable(format!("`{name}` cannot be drawn: {why}")))?;
        drawn.push((format!("{name}.svg"), svg));
    }
    output::texts(&arguments.target, &arguments.file, drawn)
}

fn drawn_pose(
    pose: DrawnPose,
    conditions: PoseConditions,
    arguments: &Draw,
) -> Result<String, String> {
    conditions.first().map_err(|error| error.to_string())?;
    if pose.numbers.iter().any(|number| !number.is_finite()) {
        return Err("a place is not finite".to_string());
    }
    let sketch = Sketch::placed(plan(pose.plan), pose.numbers);
    let sketch = match &arguments.title {
        Some(title) => sketch.title(title),
        None => sketch,
    };
    sketch.to_svg().map_err(|error| error.to_string())
}

/// The inputs that are drawn: those that are given, those of the declared drawing, and an angle of one radian.
fn inputs(parts: &PageParts, arguments: &Draw) -> Result<Vec<f64>, Failure> {
    let inputs = known(&parts.inputs);
    let mut at: Vec<Option<f64>> = inputs.iter().map(|input| input.first()).collect();
    for text in &arguments.at {
        let setting = FlagValue::read("at", text)?;
        let nth = setting.of(&inputs, "input")?;
        let value = setting.value(inputs[nth])?;
        at[nth] = Some(value).filter(|value| value.is_finite());
    }
    let given = at.into_iter().zip(&inputs).map(|(at, input)| {
        let name = input.name;
        let why = || format!("`{}` is not drawn: say where, `--at {name}=…`", parts.name);
        at.ok_or_else(|| Failure::Unusable(why()))
    });
    given.collect()
}

/// The plan for as long as the program runs.
fn plan(parts: PlanParts) -> &'static Plan {
    let texts = |list: Vec<String>| leaked(list.iter().map(|text| lasting(text)));
    let springs = parts.springs.into_iter();
    let springs =
        springs.map(|spring| Spring { ends: spring.ends.map(place), kinds: spring.kinds });
    Box::leak(Box::new(Plan {
        name: lasting(&parts.name),
        docs: lasting(&parts.docs),
        points: texts(parts.points),
        links: texts(parts.links),
        guides: texts(parts.guides),
        statements: leaked(parts.statements.iter().map(element)),
        springs: leaked(springs),
    }))
}

fn leaked<T>(list: impl Iterator<Item = T>) -> &'static [T] {
    Box::leak(list.collect())
}

fn place(id: u32) -> usize {
    id as usize
}

fn element(statement: &PlanStatement) -> Element {
    match statement {
        PlanStatement::Ground(point) => Element::Ground(place(*point)),
        PlanStatement::Guide(guide, on) => Element::Guide(place(*guide), on.map(place)),
        PlanStatement::Point(point, on) => Element::Point(place(*point), on.map(place)),
        PlanStatement::Group(members, pin) => {
            Element::Group(leaked(members.iter().map(member)), pin.map(place))
        }
    }
}

fn member(member: &PlanMember) -> Member {
    let PlanMember { link, pivot, guide, shape, is_turned } = *member;
    let make = match shape {
        "bar" => Member::bar,
        "cylinder" => Member::cylinder,
        "block" => Member::block,
        "sleeve" => Member::sleeve,
        "slotted_bar" => Member::slotted_bar,
        "yoke" => Member::yoke,
        _ => Member::body,
    };
    let made = make(place(link), pivot.or(guide).map_or(0, place));
    if is_turned { made.turned() } else { made }
}
