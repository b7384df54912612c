//! Animated transforms, read back from the text.

use gallery::pieces;
use linkage_core::sketch::{Film, View};

use super::sample;
use super::xml::{Element, numbers, parse};

/// Where a body is in every frame: x, y, degrees.
pub(super) struct Moving {
    pub link: String,
    pub seats: Vec<[f64; 3]>,
}

impl Moving {
    fn of(element: &Element, frames: usize) -> Option<Self> {
        let link = element.attribute("data-link")?.to_string();
        let base = element.attribute("transform")?;
        let base = numbers(&base.replace("translate", " ").replace("rotate", " "));
        let base = [base[0], base[1], base.get(2).copied().unwrap_or(0.0)];
        let values = |kind: &str| {
            let mut animations = element.children.iter();
            let own = animations.find(|child| child.attribute("type") == Some(kind))?;
            Some(numbers(own.attribute("values")?))
        };
        let places = values("translate").unwrap_or_default();
        let turns = values("rotate").unwrap_or_default();
        let moves = !places.is_empty();
        let seat = |frame: usize| {
            let at = |list: &[f64], width: usize, nth: usize, base: f64| match list.len() {
                0 => base,
                // Two equal values stand for all.
                len if len == 2 * width => list[nth],
                _ => list[width * frame + nth],
            };
            // An animated transform replaces the base altogether.
            let degrees = if moves && turns.is_empty() { 0.0 } else { at(&turns, 1, 0, base[2]) };
            [at(&places, 2, 0, base[0]), at(&places, 2, 1, base[1]), degrees]
        };
        Some(Self { link, seats: (0..frames).map(seat).collect() })
    }

    pub(super) fn all(film: &Film) -> Vec<Self> {
        let root = parse(&film.to_svg().unwrap());
        let bodies = root.all();
        bodies.into_iter().filter_map(|element| Self::of(element, film.len())).collect()
    }
}

pub(super) fn place([x, y, degrees]: [f64; 3], [a, b]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [x + cos * a - sin * b, y + sin * a + cos * b]
}

/// Where a point stands on a link, in pixels of its group, if it stands still there.
pub(super) fn local(film: &Film, view: View, link: &str, point: &str) -> Option<[f64; 2]> {
    let seen = (0..film.len()).filter_map(|pose| {
        let (link, point) = (film.link(pose, link).ok()?, film.point(pose, point).ok()?);
        let (x, y) = (point.x - link.origin.x, point.y - link.origin.y);
        let (cos, sin) = (link.direction.cos, link.direction.sin);
        Some([view.scale * (cos * x + sin * y), -view.scale * (cos * y - sin * x)])
    });
    let seen: Vec<[f64; 2]> = seen.collect();
    let first = *seen.first()?;
    let is_near = |other: &[f64; 2]| (other[0] - first[0]).hypot(other[1] - first[1]) < 1e-6;
    seen.iter().all(is_near).then_some(first)
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Whatever stands still on two bodies is in one place on the page, where the solver has it, in
/// every frame; and halfway between two frames, where the browser goes on straight.
#[test]
fn joints_hold_together_in_every_frame_and_halfway() {
    let (mut in_frames, mut halfway) = (0.0_f64, 0.0_f64);
    for piece in sample() {
        let before = halfway;
        let (film, view) = (&piece.film, piece.film.view().unwrap());
        for point in film.points() {
            let mut middles: Vec<Vec<Option<[f64; 2]>>> = Vec::new();
            for body in Moving::all(film) {
                let Some(on_body) = local(film, view, &body.link, point) else { continue };
                let first = film.link(0, &body.link).ok();
                // A rod of a cylinder has another origin than its link.
                let origin = first.map(|link| view.pixels([link.origin.x, link.origin.y]));
                let seat = body.seats[0];
                if origin.is_none_or(|origin| distance(origin, [seat[0], seat[1]]) > 0.5) {
                    continue;
                }
                let shown = |pose: usize| place(body.seats[pose], on_body);
                for pose in 0..film.len() {
                    // A body in a gap is hidden.
                    let (Ok(at), Ok(_)) = (film.point(pose, point), film.link(pose, &body.link))
                    else {
                        continue;
                    };
                    let off = distance(shown(pose), view.pixels([at.x, at.y]));
                    in_frames = in_frames.max(off);
                }
                let middle = |pose: usize| {
                    // Next to a limit of assembly links are infinitely fast.
                    let near = pose.saturating_sub(4)..(pose + 6).min(film.len());
                    near.into_iter()
                        .try_for_each(|pose| film.link(pose, &body.link).map(|_| ()))
                        .ok()?;
                    let (a, b) = (body.seats[pose], body.seats[pose + 1]);
                    let half = [0, 1, 2].map(|nth| 0.5 * (a[nth] + b[nth]));
                    Some(place(half, on_body))
                };
                middles.push((0..film.len() - 1).map(middle).collect());
            }
            for pair in middles.windows(2) {
                for (a, b) in pair[0].iter().zip(&pair[1]) {
                    if let (Some(a), Some(b)) = (a, b) {
                        halfway = halfway.max(distance(*a, *b));
                    }
                }
            }
        }
        if halfway > before {
            println!("{}: halfway {halfway:.4} px", piece.name);
        }
    }
    println!("in frames {in_frames:.4} px, halfway {halfway:.4} px");
    // Half of 0.01 px in both directions, and of 0.001° at no more than 640 px.
    assert!(in_frames < 0.02, "{in_frames}");
    assert!(halfway < 0.1, "{halfway}");
}

/// The motions that end elsewhere than they began.
const OPEN: [&str; 7] = [
    "vibration::TwoMasses",
    "andrews_squeezer::Squeezer",
    "crane::Crane",
    "toggle_clamp::ToggleClamp",
    "scissor_lift::ScissorLift",
    "stick_slip::DryBlock",
    "stick_slip::CreepingBlock",
];

#[test]
fn angles_never_jump_and_closed_motions_end_where_they_began() {
    for piece in pieces() {
        for body in Moving::all(&piece.film) {
            for pair in body.seats.windows(2) {
                assert!((pair[1][2] - pair[0][2]).abs() <= 180.0, "{} {}", piece.name, body.link);
            }
            let is_closed = !OPEN.contains(&piece.name);
            let (first, last) = (body.seats[0], body.seats[body.seats.len() - 1]);
            if is_closed {
                let turns = (last[2] - first[2]) / 360.0;
                assert!((turns - turns.round()).abs() < 1e-5, "{} {}", piece.name, body.link);
                assert!(distance([first[0], first[1]], [last[0], last[1]]) < 0.011);
            }
        }
    }
}
