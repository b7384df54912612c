//! Springs and dampers between two points: a zigzag that keeps its coils while it stretches, a piston in
//! its cylinder, or both side by side.

use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

use super::boxes::Box2;
use super::plan::Spring;
use super::scene::{Scene, range};
use super::style::{BLOCK, DAMPER, Palette, WALL, ZIGZAG};
use super::svg::{Timing, Transform, View, filled, fine, rigid, short};

/// A spring on the page: the frame has its origin at the first end and its x towards the second.
#[derive(Clone, Debug)]
pub(super) struct Coil {
    spring: Spring,
    pub seats: Vec<Option<Transform>>,
    /// From end to end along x: negative where the ends have passed each other.
    pub lengths: Vec<Option<f64>>,
    coils: usize,
    /// The straight part at either end.
    lead: f64,
    /// Where the cylinder begins and ends, and how far the piston is from the second end.
    damper: [f64; 3],
}

/// All springs between points.
pub(super) fn springs(scene: &Scene, view: View) -> Vec<Coil> {
    scene.plan.springs.iter().map(|&spring| Coil::new(scene, view, spring)).collect()
}

impl Coil {
    fn new(scene: &Scene, view: View, spring: Spring) -> Self {
        let ends = |frame: usize| {
            let [a, b] = spring.ends.map(|end| scene.point(frame, end));
            Some([view.pixels(a?), view.pixels(b?)])
        };
        let (mut seats, mut lengths) = (Vec::new(), Vec::new());
        let mut last: Option<[f64; 2]> = None;
        for frame in scene.frames() {
            let along = ends(frame).map(|[from, to]| {
                let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
                let length = dx.hypot(dy);
                // Ends that pass each other turn nothing about: the spring is turned inside out.
                let is_back = last.is_some_and(|last| dx * last[0] + dy * last[1] < 0.0);
                let sign = if is_back { -1.0 } else { 1.0 };
                if length > 1e-6 {
                    last = Some([sign * dx / length, sign * dy / length]);
                }
                let [x, y] = last.unwrap_or([1.0, 0.0]);
                (Transform { at: from, degrees: y.atan2(x).to_degrees() }, sign * length)
            });
            seats.push(along.map(|(seat, _)| seat));
            lengths.push(along.map(|(_, length)| length));
        }
        let [least, most] = range(lengths.iter().copied()).unwrap_or_default();
        let passes = least < 0.0 && most > 0.0;
        let shortest = if passes { 0.0 } else { least.abs().min(most.abs()) };
        let longest = least.abs().max(most.abs());
        let lead = (0.15 * shortest).min(LEAD);
        let coils = (0.5 * (shortest + longest) / PITCH).round().clamp(4.0, 10.0) as usize;
        Self { spring, seats, lengths, coils, lead, damper: damper(shortest, longest) }
    }

    /// Half of what it takes across.
    pub(super) fn half_width(&self) -> f64 {
        match self.spring.kinds {
            [true, true] => BESIDE + ZIGZAG,
            [true, false] => ZIGZAG,
            [false, _] => DAMPER,
        }
    }

    /// From end to end.
    pub(super) fn line(&self, frame: usize) -> Option<[[f64; 2]; 2]> {
        let (seat, length) = (self.seats[frame]?, self.lengths[frame]?);
        Some([seat.at, seat.place([length, 0.0])])
    }

    /// The same lines in every pose, at other places.
    fn path(&self, length: f64) -> String {
        let sign = way(length);
        let end = fine(length);
        match self.spring.kinds {
            [true, true] => {
                let [near, far] = [self.lead, length.abs() - self.lead].map(|x| fine(sign * x));
                let [above, below] = [-BESIDE, BESIDE].map(fine);
                format!(
                    "{}{}M0 0H{near}M{near} {above}V{below}M{far} {above}V{below}M{far} 0H{end}",
                    self.zigzag(length, -BESIDE, self.lead),
                    self.piston(length, BESIDE, self.lead)
                )
            }
            [true, false] => self.zigzag(length, 0.0, 0.0),
            [false, _] => self.piston(length, 0.0, 0.0),
        }
    }

    /// At this distance from the line, and shorter by so much at either end.
    fn zigzag(&self, length: f64, beside: f64, inset: f64) -> String {
        let sign = way(length);
        let (from, to) = (self.lead * sign, length - self.lead * sign);
        let corners = 2 * self.coils;
        let step = (to - from) / corners as f64;
        let mut path = format!("M{} {}H{}", fine(inset * sign), fine(beside), short(from));
        for corner in 0..corners {
            let side = if corner % 2 == 0 { -ZIGZAG } else { ZIGZAG };
            let x = from + (corner as f64 + 0.5) * step;
            path += &format!("L{} {}", short(x), short(beside + side));
        }
        path + &format!("L{} {}H{}", short(to), fine(beside), fine(length - inset * sign))
    }

    fn piston(&self, length: f64, beside: f64, inset: f64) -> String {
        let sign = way(length);
        let [bottom, top, rod] = self.damper;
        // A stroke longer than any cylinder: then everything is stretched.
        let [bottom, top, piston] = match rod {
            rod if rod > 0.0 => [bottom, top, length.abs() - rod],
            _ => [0.25, 0.7, 0.5].map(|share| share * length.abs()),
        };
        let [bottom, top, piston] = [bottom, top, piston].map(|x| fine(sign * x));
        let [start, end] = [inset * sign, length - inset * sign].map(fine);
        let [middle, above, below, head, foot] =
            [0.0, -DAMPER, DAMPER, 1.5 - DAMPER, DAMPER - 1.5].map(|y| fine(beside + y));
        format!(
            "M{start} {middle}H{bottom}M{top} {above}H{bottom}V{below}H{top}M{piston} {head}V{foot}M{piston} {middle}H{end}"
        )
    }

    pub(super) fn drawn(&self, name: &str, timing: Option<Timing>, palette: &Palette) -> String {
        let Some(lengths) = filled(&self.lengths) else { return String::new() };
        let paths: Vec<String> = lengths.into_iter().map(|length| self.path(length)).collect();
        let moves = timing.map(|timing| timing.animate("d", &paths)).unwrap_or_default();
        let path = format!(
            r#"<path d="{}" stroke="{}" stroke-width="1.6">{moves}</path>"#,
            paths[0], palette.ink
        );
        rigid(&self.seats, timing, &format!(r#" data-spring="{name}""#), &path)
    }

    /// The way of a wall at an end that stands still, if the spring does not turn there: the angle by
    /// which a plate that looks upwards is turned to look along it.
    pub(super) fn wall(&self, end: usize) -> Option<f64> {
        let mut seats = self.seats.iter().flatten();
        let first = seats.next()?.degrees;
        let is_straight = seats.all(|seat| {
            let off = (seat.degrees - first + 540.0).rem_euclid(360.0) - 180.0;
            off.abs() < STRAIGHT
        });
        let end = self.spring.ends.iter().position(|&own| own == end)?;
        let outwards = self.lengths.iter().flatten().next()?.signum();
        let turned = if (end == 0) == (outwards > 0.0) { 90.0 } else { -90.0 };
        is_straight.then_some(first + turned)
    }

    pub(super) fn extent(&self) -> Box2 {
        let lines = (0..self.seats.len()).filter_map(|frame| self.line(frame));
        let half = self.half_width();
        lines.map(|line| Box2::around(line).grown(half)).fold(Box2::NOTHING, Box2::with)
    }
}

/// The distance below a guide at which its rail clears the blocks and springs on the guide, and the range
/// of these springs along it; none if no spring lies on the guide.
pub(super) fn below(springs: &[Coil], guide: Transform) -> Option<(f64, [f64; 2])> {
    let (sin, cos) = guide.degrees.to_radians().sin_cos();
    let seen = |[x, y]: [f64; 2]| {
        let (x, y) = (x - guide.at[0], y - guide.at[1]);
        [cos * x + sin * y, cos * y - sin * x]
    };
    let spots = |coil: &Coil| -> Vec<[f64; 2]> {
        let lines = (0..coil.seats.len()).filter_map(|frame| coil.line(frame));
        lines.flatten().map(seen).collect()
    };
    let on_it = springs.iter().filter_map(|coil| {
        let spots = spots(coil);
        let is_on_it = !spots.is_empty() && spots.iter().all(|[_, y]| y.abs() < 1.0);
        let reach = range(spots.iter().map(|[x, _]| Some(*x)))?;
        let low = (coil.half_width() + 2.0).max(0.5 * BLOCK[1] + 1.8);
        is_on_it.then_some((low, reach))
    });
    on_it.reduce(|(low, [a, b]), (other, [c, d])| (low.max(other), [a.min(c), b.max(d)]))
}

/// Along the spring's x or against it.
fn way(length: f64) -> f64 {
    if length < 0.0 { -1.0 } else { 1.0 }
}

/// Beginning and end of a cylinder and the length of its piston's rod; no rod where no cylinder is long
/// enough.
fn damper(shortest: f64, longest: f64) -> [f64; 3] {
    let stroke = longest - shortest;
    let top = 0.72 * shortest;
    let bottom = top - stroke - 2.0 * SPARE;
    match bottom > SPARE {
        // At the longest the piston is just inside.
        true => {
            let slack = (bottom - 0.25 * shortest).max(0.0);
            [bottom - slack, top, longest - top + SPARE + 0.5 * slack]
        }
        false => [0.0; 3],
    }
}

/// A plate with hatches behind it, upwards along the y of its seat's page.
pub(super) fn wall(at: [f64; 2], way: f64, palette: &Palette) -> String {
    let half = WALL / 2.0;
    let hatches = [-11, -4, 3, 10, 17].map(|x| format!("M{x} 0l-6 7")).concat();
    format!(
        r#"<g {} stroke="{}" stroke-linecap="round" fill="none"><path d="M-{half} 0H{half}" stroke-width="1.6"/><path d="{hatches}" stroke-width="1"/></g>"#,
        Transform { at, degrees: way }.transform(),
        palette.ink
    )
}

/// The box covered by a wall.
pub(super) fn wall_box(at: [f64; 2], way: f64) -> Box2 {
    let (seat, half) = (Transform { at, degrees: way }, WALL / 2.0 + 1.0);
    let corners = vec![[-half, -1.0], [half, -1.0], [half, 8.0], [-half - 1.0, 8.0]];
    Box2::around(corners.into_iter().map(|spot| seat.place(spot)))
}

/// From coil to coil at the middle length.
const PITCH: f64 = 13.0;
/// The longest straight part at an end.
const LEAD: f64 = 14.0;
/// From the line of both ends to a spring and to a damper beside it.
const BESIDE: f64 = 9.0;
/// The length by which a cylinder exceeds the stroke at either end.
const SPARE: f64 = 5.0;
/// By how many degrees a spring on a wall may turn.
const STRAIGHT: f64 = 0.1;

#[cfg(test)]
mod tests {
    use super::*;

    fn coil(kinds: [bool; 2], [shortest, longest]: [f64; 2]) -> Coil {
        let seat = Transform { at: [0.0; 2], degrees: 0.0 };
        Coil {
            spring: Spring { ends: [3, 4], kinds },
            seats: vec![Some(seat); 2],
            lengths: vec![Some(shortest), Some(longest)],
            coils: 5,
            lead: 10.0,
            damper: damper(shortest, longest),
        }
    }

    /// The corners of a path.
    fn corners(path: &str) -> Vec<[f64; 2]> {
        let (mut corners, mut at) = (Vec::new(), [0.0; 2]);
        let starts = path.char_indices().filter(|(_, c)| c.is_ascii_alphabetic());
        let starts: Vec<usize> = starts.map(|(start, _)| start).collect();
        for (nth, &start) in starts.iter().enumerate() {
            let end = starts.get(nth + 1).copied().unwrap_or(path.len());
            let numbers = path[start + 1..end].split_whitespace();
            let numbers: Vec<f64> = numbers.map(|n| n.parse().expect("a number")).collect();
            match (&path[start..=start], &numbers[..]) {
                ("H", [x]) => at[0] = *x,
                ("V", [y]) => at[1] = *y,
                (_, [x, y]) => at = [*x, *y],
                _ => panic!("{path}"),
            }
            corners.push(at);
        }
        corners
    }

    const KINDS: [[bool; 2]; 3] = [[true, true], [true, false], [false, true]];

    /// Turned inside out a spring is its own mirror image, and it takes no more across than it says.
    #[test]
    fn ends_that_have_passed_each_other_mirror_the_lines() {
        // With a cylinder, and with a stroke that is longer than any.
        for lengths in [[90.0, 120.0], [10.0, 120.0]] {
            for kinds in KINDS {
                let coil = coil(kinds, lengths);
                let ahead = corners(&coil.path(100.0));
                let back = corners(&coil.path(-100.0));
                assert_eq!(ahead.len(), back.len());
                for (a, b) in ahead.iter().zip(&back) {
                    assert!(a[0] == -b[0] && a[1] == b[1], "{kinds:?}: {a:?} {b:?}");
                }
                let most = ahead.iter().map(|spot| spot[1].abs()).fold(0.0, f64::max);
                assert_eq!(most, coil.half_width(), "{kinds:?}");
                assert!(ahead.iter().all(|spot| (0.0..=100.0).contains(&spot[0])), "{ahead:?}");
            }
        }
    }

    /// As far from the bottom at the shortest as from the mouth at the longest; where no cylinder holds the
    /// stroke, everything is stretched, and the piston still stays inside.
    #[test]
    fn a_piston_has_the_same_room_at_either_end_of_its_stroke() {
        for [shortest, longest] in [[90.0, 120.0], [200.0, 205.0], [60.0, 64.0]] {
            let [bottom, top, rod] = damper(shortest, longest);
            let [low, high] = [shortest - rod - bottom, top - (longest - rod)];
            assert!((low - high).abs() < 1e-9 && low > 0.99 * SPARE, "{low} {high}");
            assert!(bottom > SPARE && top < shortest);
        }
        let coil = coil([false, true], [20.0, 300.0]);
        assert_eq!(coil.damper, [0.0; 3]);
        for length in [20.0, 100.0, 300.0] {
            // From the joint to the bottom, the cylinder's three sides, the piston, and its rod.
            let spots = corners(&coil.path(length));
            let [_, bottom, top, _, _, _, piston, ..] = spots[..] else { panic!("{spots:?}") };
            assert!(bottom[0] + 2.0 < piston[0] && piston[0] + 2.0 < top[0], "{spots:?}");
        }
    }

    /// A plate looks along the spring that it holds, which goes to the right from its first end.
    #[test]
    fn a_wall_looks_towards_its_spring() {
        let plain = coil([true, false], [90.0, 120.0]);
        assert_eq!([3, 4, 5].map(|end| plain.wall(end)), [Some(90.0), Some(-90.0), None]);
        let passed = coil([true, false], [-120.0, -90.0]);
        assert_eq!([3, 4].map(|end| passed.wall(end)), [Some(-90.0), Some(90.0)]);
        // Half a turn has two names; what is less than a tenth of a degree off is straight.
        let turned = |degrees: [f64; 2]| {
            let seats = degrees.map(|degrees| Some(Transform { at: [0.0; 2], degrees }));
            Coil { seats: seats.into(), ..plain.clone() }.wall(3)
        };
        assert_eq!(turned([180.0, -179.96]), Some(270.0));
        assert_eq!(turned([-180.0, 179.96]), Some(-90.0));
        assert_eq!(turned([30.0, 30.09]), Some(120.0));
        for degrees in [[30.0, 30.11], [30.0, -30.0], [180.0, -179.8], [0.0, 180.0]] {
            assert_eq!(turned(degrees), None, "{degrees:?}");
        }
        // The plate and the ends of its hatches, 7 below it.
        let covered = wall_box([0.0; 2], 0.0);
        for spot in [[-17.0, 0.0], [17.0, 0.0], [-17.0, 7.0], [11.0, 7.0]] {
            assert!(covered.holds(spot), "{covered:?}");
        }
    }
}
