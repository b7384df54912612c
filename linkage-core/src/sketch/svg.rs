//! Text of SVG: numbers, paths, and groups that move by SMIL. No scripts, no styles, no ids.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::scene::Pose;

/// From metres in ground axes, y up, to pixels of the page, y down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Pixels to the metre.
    pub scale: f64,
    /// Where the ground's origin is on the page, in pixels.
    pub origin: [f64; 2],
}

impl View {
    /// Where a point of the ground is on the page.
    #[must_use]
    pub fn pixels(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.origin[0] + self.scale * x, self.origin[1] - self.scale * y]
    }

    /// A vector of a link's frame, in pixels of its group.
    pub(super) fn local(self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.scale * x, -self.scale * y]
    }

    /// A frame as `translate` and `rotate` say it.
    pub(super) fn seat(self, pose: Pose) -> Transform {
        Transform { at: self.pixels(pose.origin), degrees: -pose.sin.atan2(pose.cos).to_degrees() }
    }
}

/// Where a rigid group is on the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Transform {
    pub at: [f64; 2],
    pub degrees: f64,
}

impl Transform {
    pub(super) fn place(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.degrees.to_radians().sin_cos();
        [self.at[0] + cos * x - sin * y, self.at[1] + sin * x + cos * y]
    }

    /// The attribute of a group that stands there.
    pub(super) fn transform(self) -> String {
        let turned = match number(self.degrees, 3) {
            degrees if degrees == "0" => String::new(),
            degrees => format!(" rotate({degrees})"),
        };
        format!(r#"transform="translate({}){turned}""#, pair(self.at))
    }
}

/// The duration of a film and its number of poses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Timing {
    pub seconds: f64,
    pub frames: usize,
}

/// A number with so many decimals at most; minus zero is zero.
pub(super) fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if text == "-0" { "0".into() } else { text.into() }
}

/// With one decimal.
pub(super) fn short(value: f64) -> String {
    number(value, 1)
}

/// With two.
pub(super) fn fine(value: f64) -> String {
    number(value, 2)
}

/// With three digits, but for zeros at the end, which a picture has no room for.
pub(super) fn three_digits(value: f64) -> String {
    let decimals = (2 - value.abs().max(1e-9).log10().floor() as i32).clamp(0, 9);
    number(value, decimals as usize)
}

/// `x y`.
pub(super) fn pair([x, y]: [f64; 2]) -> String {
    format!("{} {}", fine(x), fine(y))
}

/// A path through points, closed or not.
pub(super) fn path(points: &[[f64; 2]], is_closed: bool) -> String {
    let mut text = String::new();
    for (nth, [x, y]) in points.iter().enumerate() {
        text += if nth == 0 { "M" } else { "L" };
        text += &format!("{} {}", short(*x), short(*y));
    }
    if is_closed {
        text.push('Z');
    }
    text
}

/// The text with what XML would take for its own replaced.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

impl Timing {
    /// An `animate` of an attribute through a value a frame; nothing if they are all one.
    pub(super) fn animate(self, attribute: &str, values: &[String]) -> String {
        if values.windows(2).all(|pair| pair[0] == pair[1]) {
            return String::new();
        }
        let (values, duration) = (values.join(";"), self.duration());
        format!(r#"<animate attributeName="{attribute}" {duration} values="{values}"/>"#)
    }

    fn duration(self) -> String {
        format!(r#"dur="{}s" repeatCount="indefinite""#, number(self.seconds, 3))
    }

    /// Hides a group where a frame is not `seen`. It goes as soon as the last frame before has been
    /// shown and comes with the first behind, so that nothing is ever shown in between.
    pub(super) fn visible(self, seen: &[bool]) -> String {
        let last = (self.frames - 1) as f64;
        let (mut times, mut values) = (Vec::new(), Vec::new());
        for (frame, pair) in seen.windows(2).enumerate() {
            let at = match pair {
                [true, false] => frame as f64 + EDGE,
                [false, true] => frame as f64 + 1.0 - EDGE,
                _ => continue,
            };
            times.push(number(at / last, 6));
            values.push(if pair[1] { "1" } else { "0" });
        }
        if times.is_empty() {
            return String::new();
        }
        let first = if seen[0] { "1" } else { "0" };
        format!(
            r#"<animate attributeName="opacity" calcMode="discrete" {} keyTimes="0;{}" values="{first};{}"/>"#,
            self.duration(),
            times.join(";"),
            values.join(";"),
        )
    }

    /// The two animations of a rigid group, or the attribute alone where it stands still.
    fn transforms(self, seats: &[Transform]) -> String {
        let places: Vec<String> = seats.iter().map(|seat| pair(seat.at)).collect();
        let turns: Vec<String> = unrolled(seats).map(|degrees| number(degrees, 3)).collect();
        let is_still = |values: &[String]| values.windows(2).all(|pair| pair[0] == pair[1]);
        if is_still(&places) && is_still(&turns) {
            return String::new();
        }
        let line = |kind: &str, values: &[String], how: &str| {
            let (duration, values) = (
                self.duration(),
                match is_still(values) {
                    true => values[..2].join(";"),
                    false => values.join(";"),
                },
            );
            format!(
                r#"<animateTransform attributeName="transform" type="{kind}"{how} {duration} values="{values}"/>"#
            )
        };
        let turning = match turns.iter().all(|degrees| degrees == "0") {
            true => String::new(),
            false => line("rotate", &turns, r#" additive="sum""#),
        };
        line("translate", &places, "") + &turning
    }
}

/// The part of a frame's time for which a body that goes is seen still.
const EDGE: f64 = 0.02;

/// The angles, none more than half a turn from the one before.
pub(super) fn unrolled(seats: &[Transform]) -> impl Iterator<Item = f64> {
    let mut last: Option<f64> = None;
    seats.iter().map(move |seat| {
        let degrees = match last {
            Some(last) => seat.degrees - 360.0 * ((seat.degrees - last) / 360.0).round(),
            None => seat.degrees,
        };
        last = Some(degrees);
        degrees
    })
}

/// A group that moves as a rigid body, hidden where it has no seat; none at all without any seat.
pub(super) fn rigid(
    seats: &[Option<Transform>],
    timing: Option<Timing>,
    attributes: &str,
    content: &str,
) -> String {
    let Some(filled) = filled(seats) else { return String::new() };
    let seen: Vec<bool> = seats.iter().map(Option::is_some).collect();
    let hidden = if seen[0] { "" } else { r#" opacity="0""# };
    let (moves, hides) = match timing {
        Some(timing) => (timing.transforms(&filled), timing.visible(&seen)),
        None => Default::default(),
    };
    format!("<g {}{hidden}{attributes}>{moves}{hides}{content}</g>", filled[0].transform())
}

/// Every gap filled with what stands before it, or behind it where nothing does.
pub(super) fn filled<T: Copy>(values: &[Option<T>]) -> Option<Vec<T>> {
    let mut last = values.iter().copied().flatten().next()?;
    let fill = |value: &Option<T>| {
        last = value.unwrap_or(last);
        last
    };
    Some(values.iter().map(fill).collect())
}
