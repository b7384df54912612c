//! Where a pose cannot be assembled: how far each link of the failed group reaches, and what is
//! missing between them.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::boxes::Box2;
use super::member::{LinkShape, Member};
use super::plan::Element;
use super::scene::Scene;
use super::style::{Palette, Unit};
use super::svg::{Timing, Transform, View, fine, rigid, three_digits};
use super::symbols::moving_arrow;
use crate::SolveError;
use crate::shown::Measured;

/// A statement that fails in some poses.
pub(super) struct Gap {
    /// In which poses.
    pub fails: Vec<bool>,
    reaches: Vec<SweptReach>,
    /// The missing line from one reach to the other, on the page.
    missing: Vec<Option<[[f64; 2]; 2]>>,
}

/// The reach of a link.
struct SweptReach {
    link: usize,
    /// The middle of a circle, or a place of a line; its radius, none for a line.
    seats: Vec<Option<Transform>>,
    radii: Option<Vec<Option<f64>>>,
}

/// Every statement that fails somewhere.
pub(super) fn gaps(scene: &Scene, view: View) -> Vec<Gap> {
    let statements = scene.plan.statements.iter().enumerate();
    let of = |(statement, &made): (usize, &Element)| {
        let fails: Vec<bool> = scene.frames().map(|f| fails(scene, f, statement)).collect();
        fails.contains(&true).then(|| gap(scene, view, statement, made, fails))
    };
    statements.filter_map(of).collect()
}

fn fails(scene: &Scene, frame: usize, statement: usize) -> bool {
    scene.failure(frame).is_some_and(|failure| {
        failure.statement == Some(statement)
            && matches!(failure.error, SolveError::OutOfReach { .. })
    })
}

fn gap(scene: &Scene, view: View, statement: usize, made: Element, fails: Vec<bool>) -> Gap {
    let circle = |link: usize, point: usize, nth: usize| SweptReach {
        link,
        seats: scene
            .frames()
            .map(|f| Some(Transform { at: view.pixels(scene.point(f, point)?), degrees: 0.0 }))
            .collect(),
        radii: Some(
            scene
                .frames()
                .map(|f| {
                    let radius = view.scale * scene.dimension(f, statement, nth).abs();
                    radius.is_finite().then_some(radius)
                })
                .collect(),
        ),
    };
    let pivot = made.members().find_map(|(_, member)| member.pivot());
    let line = |member: Member, nth: usize| {
        let seat = |f: usize| {
            let pose = scene.guide(f, member.guide()?)?;
            let offset = scene.dimension(f, statement, nth);
            let foot = pose.local(scene.point(f, pivot?)?)[0];
            Some(view.seat(pose.moved_to(pose.place([foot, offset]))))
        };
        SweptReach { link: member.link, seats: scene.frames().map(seat).collect(), radii: None }
    };
    let reach = |(nth, member): (usize, Member)| match member.shape {
        LinkShape::Bar | LinkShape::Cylinder | LinkShape::SlottedBar => {
            Some(circle(member.link, member.pivot()?, nth))
        }
        LinkShape::Sleeve => {
            let mut own = circle(member.link, member.pivot()?, nth);
            if let Some(radii) = &mut own.radii {
                radii.iter_mut().for_each(|radius| *radius = Some(0.0));
            }
            Some(own)
        }
        LinkShape::Block => Some(line(member, nth)),
        LinkShape::Body | LinkShape::Yoke => None,
    };
    let reaches: Vec<SweptReach> = made.members().filter_map(reach).collect();
    let missing =
        scene.frames().map(|f| if fails[f] { between(&reaches, f) } else { None }).collect();
    Gap { fails, reaches, missing }
}

/// The shortest way from what the first link reaches to what the second one does.
fn between(reaches: &[SweptReach], frame: usize) -> Option<[[f64; 2]; 2]> {
    let [first, second] = reaches else { return None };
    let (a, b) = (first.seats[frame]?, second.seats[frame]?);
    let r = first.radii.as_ref()?[frame]?;
    let (dx, dy) = (b.at[0] - a.at[0], b.at[1] - a.at[1]);
    let d = dx.hypot(dy);
    let u = if d > 1e-9 { [dx / d, dy / d] } else { [1.0, 0.0] };
    let from = |at: [f64; 2], along: f64| [at[0] + along * u[0], at[1] + along * u[1]];
    let Some(radii) = &second.radii else {
        // The line through b: its foot below a is b itself.
        return Some([from(a.at, r), b.at]);
    };
    let s = radii[frame]?;
    Some(match () {
        () if d > r + s => [from(a.at, r), from(b.at, -s)],
        () if r > s => [from(a.at, r), from(b.at, s)],
        () => [from(a.at, -r), from(b.at, -s)],
    })
}

impl Gap {
    /// The extent of its drawing over all poses in which it fails.
    pub(super) fn extent(&self) -> Box2 {
        let mut all = Box2::NOTHING;
        for frame in (0..self.fails.len()).filter(|&frame| self.fails[frame]) {
            for reach in &self.reaches {
                let Some(seat) = reach.seats[frame] else { continue };
                let radius = match &reach.radii {
                    Some(radii) => radii[frame].unwrap_or(0.0),
                    None => HALF_LINE,
                };
                all = all.with(Box2::about(seat.at, [radius; 2]));
            }
        }
        all
    }

    /// The missing line in a pose.
    pub(super) fn line(&self, frame: usize) -> Option<[[f64; 2]; 2]> {
        self.missing[frame]
    }

    pub(super) fn drawn(
        &self,
        timing: Option<Timing>,
        colour: impl Fn(usize) -> &'static str,
        palette: &Palette,
    ) -> String {
        let mut content = String::new();
        for reach in &self.reaches {
            let look = format!(
                r#"fill="none" stroke="{}" stroke-width="1.6" stroke-dasharray="5 4""#,
                colour(reach.link)
            );
            let shape = match &reach.radii {
                Some(radii) => {
                    let Some(radii) = super::svg::filled(radii) else { continue };
                    if radii.iter().all(|&radius| radius == 0.0) {
                        continue;
                    }
                    let radii: Vec<String> = radii.into_iter().map(fine).collect();
                    let grows = timing.map(|timing| timing.animate("r", &radii));
                    format!(
                        r#"<circle r="{}" {look}>{}</circle>"#,
                        radii[0],
                        grows.unwrap_or_default()
                    )
                }
                None => format!(r#"<path d="M-{HALF_LINE} 0H{HALF_LINE}" {look}/>"#),
            };
            content += &rigid(&self.only_failing(&reach.seats), timing, "", &shape);
        }
        content + &self.arrow(timing, palette)
    }

    /// Seats in the poses around a failure: one more at each side, so that nothing starts with a
    /// jump; hidden elsewhere.
    fn only_failing(&self, seats: &[Option<Transform>]) -> Vec<Option<Transform>> {
        seats.iter().zip(&self.fails).map(|(seat, fails)| seat.filter(|_| *fails)).collect()
    }

    fn arrow(&self, timing: Option<Timing>, palette: &Palette) -> String {
        let look = format!(r#"stroke="{}" stroke-width="2""#, palette.accent);
        moving_arrow(&self.missing, true, timing, &look)
    }
}

/// Half of the line along which a pin would slide.
const HALF_LINE: f64 = 120.0;

/// A sentence for each group that fails, and for each other reason.
pub(super) fn messages(scene: &Scene, unit: Option<Unit>) -> Vec<String> {
    let mut found: Vec<(&'static str, SolveError)> = Vec::new();
    for failure in scene.frames().filter_map(|frame| scene.failure(frame)) {
        let culprit = failure.error.culprit();
        let by = |error: &SolveError| match *error {
            SolveError::OutOfReach { by, .. } | SolveError::NoSolution { by, .. } => by,
            _ => 0.0,
        };
        match found.iter_mut().find(|(name, _)| *name == culprit) {
            Some((_, worst)) if by(worst) < by(&failure.error) => *worst = failure.error,
            Some(_) => {}
            None => found.push((culprit, failure.error)),
        }
    }
    let at_worst = if scene.len() > 1 { " at worst" } else { "" };
    let sentence = |(_, error): (_, SolveError)| match error {
        SolveError::OutOfReach { group, by } => {
            format!("{group}: {} out of reach{at_worst}", distance(by, unit))
        }
        SolveError::NoSolution { unknown, by, unit: measure, other: None } => {
            let missing = match measure {
                "m" => distance(by, unit),
                unit => Measured { value: by, unit }.to_string(),
            };
            format!("{unknown}: no solution between its ends, {missing} missing{at_worst}")
        }
        error => error.to_string(),
    };
    found.into_iter().map(sentence).collect()
}

/// In a unit that suits.
fn distance(metres: f64, unit: Option<Unit>) -> String {
    let unit = unit.unwrap_or(if metres < 1.0 { Unit::Mm } else { Unit::M });
    let (name, per_metre) = unit.of();
    format!("{} {name}", three_digits(metres * per_metre))
}
