//! The documentation of every group: its dimensions, its mode, and where it can be assembled.

use proc_macro2::Ident;

use super::searches_in_words;
use crate::codegen::identifiers::text;
use crate::exact::Exact;
use crate::model::mechanism::{
    AngleSum, Carrier, Drive, Group, GroupName, Known, LinkId, Mechanism, Mode, Opposite, PointId,
    Scalar, Sign, Slideway,
};
use crate::reach::absolute;
use crate::syntax::anatomy::Class;

/// The group with this index: `rrr BC, DC: lengths 632 mm and 374 mm, …`.
pub(super) fn in_words(mechanism: &Mechanism, index: usize) -> String {
    let GroupName { keyword, title, .. } = &mechanism.groups[index];
    let words = Words { mechanism };
    let group = mechanism.group_steps().find(|group| group.id.index() == index);
    let said = group.map(|group| words.group(group)).or_else(|| words.unknown(index));
    match said {
        Some(said) => format!("{keyword} {title}: {said}"),
        None => format!("{keyword} {title}"),
    }
}

struct Words<'a> {
    mechanism: &'a Mechanism,
}

impl Words<'_> {
    /// The interval and the trend of the unknown that is solved in the group of this index, if there is one.
    fn unknown(&self, index: usize) -> Option<String> {
        let unknowns = &self.mechanism.unknowns;
        let unknown = unknowns.iter().find(|unknown| unknown.group.index() == index)?;
        let constant = if unknown.dimension.angle { degrees } else { metres };
        let [from, to] = unknown.between.each_ref().map(|end| self.number(end, constant));
        let trend = searches_in_words::mode(self.mechanism, unknown);
        Some(format!("between {from} and {to}, fixed by its equation, {trend}"))
    }

    /// The group in words.
    fn group(&self, group: &Group) -> String {
        let outer = || [0, 1].map(|index| group.stands_on(index));
        let offsets = group.offsets();
        match group.kind {
            Class::Crank => self.crank(group),
            Class::Slider => {
                let Some(Drive::Slide(slide)) = &group.outer[0].drive else { return String::new() };
                format!("slide {}{}", self.length(slide), self.offset(offsets[0]))
            }
            Class::Rrr => self.rrr(group, outer()),
            Class::Rrp => self.rrp(group, offsets[0]),
            Class::Rpr => self.rpr(group, outer(), offsets[0]),
            Class::Prp => {
                format!("{}assembles where the guides are not parallel", self.offsets(&offsets))
            }
            Class::Rpp => self.rpp(group, &offsets),
        }
    }

    fn crank(&self, group: &Group) -> String {
        let Some(Drive::Angle { angle, relative_to }) = &group.outer[0].drive else {
            return String::new();
        };
        let length = group.lengths[0].as_ref();
        let length = length.map(|length| format!("length {}, ", self.length(&length.value)));
        let from = match relative_to {
            Carrier::Ground => String::new(),
            Carrier::Link(link) => format!(" from `{}`", self.link(*link)),
        };
        format!("{}angle {}{from}", length.unwrap_or_default(), self.angle(angle))
    }

    fn rpp(&self, group: &Group, offsets: &[&Scalar]) -> String {
        let Some(Slideway::Slot { angle, .. }) = group.inner[0].slideway() else {
            return String::new();
        };
        let range = match angle.constant() {
            Some(_) => "assembles everywhere",
            None => "assembles where the slot is not along the rail",
        };
        format!("slot at {}, {}{range}", self.angle(angle), self.offsets(offsets))
    }

    fn rrr(&self, group: &Group, outer: [PointId; 2]) -> String {
        let [b, d] = outer.map(|point| self.point(point));
        let pin = self.pin(group);
        let lengths = [0, 1].map(|bar| &group.length(bar).value);
        let [first, second] = lengths.map(|length| self.length(length));
        if let Some(Opposite { corner, .. }) = group.opposite() {
            let corner = self.point(corner);
            return format!(
                "lengths {first} and {second}, parallel: `{pin}` is opposite to `{corner}`; assembles everywhere, \
                 and forces in its joints are `Singular` where `{corner}`, `{b}`, `{pin}` and `{d}` are in one line"
            );
        }
        let side = match group.mode() {
            Some(Mode::Fixed(Sign::Plus)) | None => "on the left".to_string(),
            Some(Mode::Fixed(Sign::Minus)) => "on the right".to_string(),
            Some(Mode::Param(param)) => format!(
                "on the side that `{}` says",
                text(&self.mechanism.params[param.index()].name)
            ),
        };
        let known = self.mechanism.known.iter().find(|known| known.group == group.id);
        let range = self.range_of_rrr([b, d], lengths, known.and_then(|known| known.span.as_ref()));
        let mut words = format!(
            "lengths {first} and {second}, `{pin}` {side} seen from `{b}` to `{d}`; \
             assembles while {range}"
        );
        if let Some(Known { coincides_with: Some(point), .. }) = known {
            let point = self.point(*point);
            words += &format!(
                ". `{point}` is as far from `{b}` and `{d}` as `{pin}`: one of the modes puts `{pin}` onto \
                 `{point}`, and the machine is the other"
            );
        }
        words
    }

    /// Between which lengths of what: of a cylinder, its own; of anything else, the distance between
    /// the outer joints.
    fn range_of_rrr(
        &self,
        [b, d]: [&Ident; 2],
        [first, second]: [&Scalar; 2],
        span: Option<&Exact>,
    ) -> String {
        let driven = match (first, second) {
            (Scalar::Input(input), other) | (other, Scalar::Input(input)) => {
                other.constant().zip(span).map(|(other, span)| (*input, other, span))
            }
            _ => None,
        };
        if let Some((input, other, span)) = driven {
            let input = text(&self.mechanism.inputs[input.index()].name);
            return format!("`{input}` is {}", between(other, span));
        }
        match (first.constant(), second.constant()) {
            (Some(first), Some(second)) => format!("|{b}{d}| is {}", between(first, second)),
            _ => format!("|{b}{d}| is between the difference of the lengths and their sum"),
        }
    }

    fn rrp(&self, group: &Group, offset: &Scalar) -> String {
        let (outer, pin) = (self.point(group.stands_on(0)), self.pin(group));
        let length = self.length(&group.length(0).value);
        let (sense, offset) = (self.sense(group, "ahead of", "behind"), self.offset(offset));
        format!(
            "length {length}{offset}, `{pin}` {sense} the foot of `{outer}`; assembles while `{outer}` is no \
             farther than {length} from the line on which `{pin}` slides"
        )
    }

    fn rpr(&self, group: &Group, outer: [PointId; 2], offset: &Scalar) -> String {
        let ([b, d], bar) = (outer.map(|point| self.point(point)), self.link(group.links[1]));
        let sense = self.sense(group, "positive", "negative");
        let range = match offset.constant() {
            Some(offset) if offset.is_zero() => format!("assembles while `{b}` is not on `{d}`"),
            Some(offset) => {
                format!("assembles while |{b}{d}| is at least {}", metres(&absolute(offset)))
            }
            None => format!("assembles while |{b}{d}| is at least the offset"),
        };
        let offset = self.offset(offset);
        let offset = offset.strip_prefix(", ").map(|offset| format!("{offset}, "));
        let offset = offset.unwrap_or_default();
        format!("{offset}block on the {sense} side of `{bar}`; {range}")
    }

    fn sense(&self, group: &Group, plus: &str, minus: &str) -> String {
        match group.mode() {
            Some(Mode::Fixed(Sign::Plus)) | None => plus.to_string(),
            Some(Mode::Fixed(Sign::Minus)) => minus.to_string(),
            Some(Mode::Param(param)) => {
                let name = text(&self.mechanism.params[param.index()].name);
                format!("{plus} or {minus}, as `{name}` says,")
            }
        }
    }

    /// `, offset 5 mm`; nothing where there is none.
    fn offset(&self, offset: &Scalar) -> String {
        match offset.constant() {
            Some(offset) if offset.is_zero() => String::new(),
            _ => format!(", offset {}", self.length(offset)),
        }
    }

    /// `offsets 5 mm and 0 m; `; nothing where there are none.
    fn offsets(&self, offsets: &[&Scalar]) -> String {
        let is_zero = |offset: &&Scalar| offset.constant().is_some_and(Exact::is_zero);
        if offsets.iter().all(is_zero) {
            return String::new();
        }
        let [first, second] = [0, 1].map(|index| self.length(offsets[index]));
        format!("offsets {first} and {second}; ")
    }

    fn length(&self, value: &Scalar) -> String {
        self.number(value, metres)
    }

    fn angle(&self, angle: &AngleSum) -> String {
        match &angle.links[..] {
            [] => self.number(&angle.rest, degrees),
            _ => "as driven".to_string(),
        }
    }

    /// A constant as a number, what has a name by it.
    fn number(&self, value: &Scalar, constant: fn(&Exact) -> String) -> String {
        match value {
            Scalar::Constant(value) => constant(value),
            Scalar::Input(input) => {
                format!("`{}`", text(&self.mechanism.inputs[input.index()].name))
            }
            Scalar::Param(param) => {
                format!("`{}`", text(&self.mechanism.params[param.index()].name))
            }
            Scalar::Unknown(unknown) => {
                format!("`{}`", text(&self.mechanism.unknowns[unknown.index()].name))
            }
            _ => "as computed".to_string(),
        }
    }

    fn pin(&self, group: &Group) -> &Ident {
        self.point(group.pin.expect("its row has a pin"))
    }

    fn point(&self, point: PointId) -> &Ident {
        &self.mechanism.points[point.index()].name
    }

    fn link(&self, link: LinkId) -> &Ident {
        &self.mechanism.links[link.index()].name
    }
}

/// From the difference of two lengths to their sum.
fn between(first: &Exact, second: &Exact) -> String {
    format!("from {} to {}", metres(&absolute(&first.sub(second))), metres(&first.add(second)))
}

/// A length in millimetres below a metre, else in metres, to six digits.
fn metres(value: &Exact) -> String {
    let metres = value.to_f64();
    match metres.abs() {
        size if size > 0.0 && size < 1.0 => format!("{} mm", short(metres * 1e3)),
        _ => format!("{} m", short(metres)),
    }
}

fn degrees(value: &Exact) -> String {
    format!("{}°", short(value.to_f64().to_degrees()))
}

/// Six digits, without the zeros behind them.
fn short(value: f64) -> String {
    let text = format!("{value:.5e}");
    // Adding zero takes the sign off minus zero.
    text.parse::<f64>().map_or(text, |rounded| (rounded + 0.0).to_string())
}
