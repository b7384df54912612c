//! Symbols that stand still: supports, rails, circles of cranks, arrows, the scale.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::boxes::Box2;

use super::style::{FONT, Palette, SMALL, SUPPORT, Unit, text_width};
use super::svg::{Timing, Transform, fine, pair, path, short};

/// Which way a support stands: the angles by which the upright one is turned.
pub(super) const WAYS: [f64; 4] = [0.0, 90.0, -90.0, 180.0];

/// The box covered by a support.
pub(super) fn support_box(at: [f64; 2], way: f64) -> Box2 {
    let seat = Transform { at, degrees: way };
    let [_, height, half] = SUPPORT;
    Box2::around([[-half - 3.0, -2.0], [half + 1.0, height + 8.0]].map(|spot| seat.place(spot)))
}

/// A support below a joint, turned.
pub(super) fn support(at: [f64; 2], way: f64, palette: &Palette) -> String {
    let (paper, ink) = (palette.paper, palette.ink);
    format!(
        r#"<g {} stroke="{ink}" stroke-linecap="round" stroke-linejoin="round" fill="none"><path d="M0 0L-10 17H10Z" fill="{paper}" stroke-width="1.6"/><path d="M-17 17H17" stroke-width="1.6"/><path d="M-11 17l-6 7M-4 17l-6 7M3 17l-6 7M10 17l-6 7M17 17l-6 7" stroke-width="1"/></g>"#,
        Transform { at, degrees: way }.transform()
    )
}

/// A guide of the ground, hatched on the side away from its normal.
pub(super) fn rail(seat: Transform, [start, end]: [f64; 2], palette: &Palette) -> String {
    let hatches: String =
        hatches([start, end]).into_iter().map(|x| format!("M{} 0l-6 7", short(x))).collect();
    format!(
        r#"<g {} stroke="{}" stroke-linecap="round" fill="none"><path d="M{} 0H{}" stroke-width="1.6"/><path d="{hatches}" stroke-width="1"/></g>"#,
        seat.transform(),
        palette.ink,
        short(start),
        short(end),
    )
}

/// Four at both ends.
fn hatches([start, end]: [f64; 2]) -> Vec<f64> {
    let steps = [0.0, 6.0, 12.0, 18.0];
    let left = steps.iter().map(|step| start + 6.0 + step);
    let right = steps.iter().map(|step| end - step);
    left.chain(right).collect()
}

/// The boxes covered by the ends of a rail.
pub(super) fn rail_boxes(seat: Transform, [start, end]: [f64; 2]) -> [Box2; 2] {
    [[start, start + 26.0], [end - 26.0, end]]
        .map(|[a, b]| Box2::around([[a, -1.0], [b, 8.0]].map(|spot| seat.place(spot))))
}

/// The circle of a crank's pin, or the part of it that the pin goes through.
pub(super) fn crank_circle(
    at: [f64; 2],
    radius: f64,
    swept: Option<[f64; 2]>,
    quiet: &str,
) -> String {
    let look =
        format!(r#"fill="none" stroke="{quiet}" stroke-width="1" stroke-dasharray="9 3 2 3""#);
    match swept {
        None => format!(
            r#"<circle cx="{}" cy="{}" r="{}" {look}/>"#,
            fine(at[0]),
            fine(at[1]),
            fine(radius)
        ),
        Some([from, to]) => {
            let large = u8::from(to - from > 180.0);
            let [start, end] = [from, to].map(|degrees| on_circle(at, radius, degrees));
            let radius = fine(radius);
            let (start, end) = (pair(start), pair(end));
            format!(r#"<path d="M{start}A{radius} {radius} 0 {large} 1 {end}" {look}/>"#)
        }
    }
}

/// A place on a circle, the angle as the page has it.
pub(super) fn on_circle([x, y]: [f64; 2], radius: f64, degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [x + radius * cos, y + radius * sin]
}

/// Radius and half the angle of the arrow that says how a crank turns.
pub(super) const ARC: f64 = 20.0;
pub(super) const HALF_ARC: f64 = 50.0;

/// Points of that arrow, around the middle angle.
pub(super) fn arc_points(at: [f64; 2], middle: f64) -> Vec<[f64; 2]> {
    (-4..=4).map(|nth| on_circle(at, ARC, middle + f64::from(nth) * HALF_ARC / 4.0)).collect()
}

/// The arrow itself; clockwise on the page is a negative input's way.
pub(super) fn arc_arrow(at: [f64; 2], middle: f64, is_clockwise: bool, ink: &str) -> String {
    let sign = if is_clockwise { 1.0 } else { -1.0 };
    // The head is as long as 22° of the arc.
    let (tail, neck, tip) =
        (middle - sign * HALF_ARC, middle + sign * (HALF_ARC - 20.0), middle + sign * HALF_ARC);
    let [start, end] = [tail, neck].map(|degrees| pair(on_circle(at, ARC, degrees)));
    let head = [
        on_circle(at, ARC, tip + sign * 2.0),
        on_circle(at, ARC - 4.0, neck - sign * 1.0),
        on_circle(at, ARC + 4.0, neck - sign * 1.0),
    ];
    let sweep = u8::from(is_clockwise);
    format!(
        r#"<path d="M{start}A{ARC} {ARC} 0 0 {sweep} {end}" fill="none" stroke="{ink}" stroke-width="1.6" stroke-linecap="round"/><path d="{}" fill="{ink}"/>"#,
        path(&head, true)
    )
}

/// Length of an arrow's head.
const HEAD: f64 = 8.0;

/// The path of an arrow from one place to another, with a head at one end or both.
fn arrow([from, to]: [[f64; 2]; 2], is_double: bool) -> String {
    let back = if is_double { barbs([to, from]) } else { String::new() };
    format!("M{}L{}{}{back}", pair(from), pair(to), barbs([from, to]))
}

/// The head at the end of a line; a short line has a small one.
fn barbs([from, to]: [[f64; 2]; 2]) -> String {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = dx.hypot(dy).max(1e-9);
    let head = HEAD.min(0.45 * length);
    let (ux, uy) = (dx / length * head, dy / length * head);
    let barb = |side: f64| [to[0] - ux - side * 0.4 * uy, to[1] - uy + side * 0.4 * ux];
    format!("M{}L{}L{}", pair(barb(1.0)), pair(to), pair(barb(-1.0)))
}

/// An arrow that moves, hidden where it has no ends; nothing at all without any.
pub(super) fn moving_arrow(
    ends: &[Option<[[f64; 2]; 2]>],
    is_double: bool,
    timing: Option<Timing>,
    look: &str,
) -> String {
    let paths = ends.iter().map(|ends| ends.map(|ends| arrow(ends, is_double)));
    moving_path(&paths.collect::<Vec<_>>(), timing, look)
}

/// A bent line with a head at its end.
pub(super) fn turning_arrow(line: &[[f64; 2]]) -> String {
    let drawn = path(line, false);
    match line {
        // The head of the last side alone would be as short as that side.
        [.., from, to] => {
            let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
            let longer = HEAD / 0.45 / dx.hypot(dy).max(1e-9);
            let tail = [to[0] - longer * dx, to[1] - longer * dy];
            drawn + &barbs([tail, *to])
        }
        _ => drawn,
    }
}

/// A line that moves, hidden where there is none; nothing at all without any. All have the same corners.
pub(super) fn moving_path(paths: &[Option<String>], timing: Option<Timing>, look: &str) -> String {
    let Some(first) = paths.iter().flatten().next() else { return String::new() };
    let mut last = first.clone();
    let fill = |path: &Option<String>| {
        if let Some(path) = path {
            last.clone_from(path);
        }
        last.clone()
    };
    let filled: Vec<String> = paths.iter().map(fill).collect();
    let seen: Vec<bool> = paths.iter().map(Option::is_some).collect();
    let hidden = if seen[0] { "" } else { r#" opacity="0""# };
    let moves = timing
        .map(|timing| timing.animate("d", &filled) + &timing.visible(&seen))
        .unwrap_or_default();
    format!(r#"<path d="{}"{hidden} fill="none" {look}>{moves}</path>"#, filled[0])
}

/// The length of the scale bar, in pixels, and its text.
pub(super) fn scale_bar(scale: f64, width: f64, unit: Option<Unit>) -> (f64, String) {
    let most = 0.2 * width / scale;
    let power = 10_f64.powf(most.log10().floor());
    let steps = [5.0, 2.0, 1.0].map(|step| step * power);
    let length = steps.into_iter().find(|&step| step <= most).unwrap_or(power);
    let unit = unit.unwrap_or(if length < 0.9999 { Unit::Mm } else { Unit::M });
    let (name, per_metre) = unit.of();
    (length * scale, format!("{} {name}", super::svg::number(length * per_metre, 6)))
}

/// The bar with its text behind it; how far both reach.
pub(super) fn drawn_scale(
    (length, text): &(f64, String),
    bottom: f64,
    palette: &Palette,
) -> (String, f64) {
    let (quiet, end, y) = (palette.quiet, short(20.0 + length), short(bottom));
    let reach = 20.0 + length + 8.0 + SMALL * text_width(text);
    let drawn = format!(
        r#"<path d="M20 {y}H{end}M20 {top}v8M{end} {top}v8" fill="none" stroke="{quiet}" stroke-width="1.6"/><text x="{}" y="{}" font-family="{FONT}" font-size="{SMALL}" fill="{quiet}">{text}</text>"#,
        short(28.0 + length),
        short(bottom + 4.0),
        top = short(bottom - 4.0),
    );
    (drawn, reach)
}
