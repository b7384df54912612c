//! A drawing as the text of a declaration.

use super::super::variants::Random;
use super::drawing::{Along, Drawing, Drive, Guide, Link, Place, Read, Through, Value};

/// A length in millimetres where it is a whole number of tenths, else in metres.
pub(super) fn length(value: f64) -> String {
    let tenths = (value * 1e4).round();
    match tenths / 1e4 == value {
        true => format!(
            "{}{}.{}mm",
            if tenths < 0.0 { "-" } else { "" },
            tenths.abs() as u64 / 10,
            tenths.abs() as u64 % 10
        ),
        false => format!("{value:?}m"),
    }
}

pub(super) fn pair([x, y]: [f64; 2]) -> String {
    format!("({}, {})", length(x), length(y))
}

/// The items in another order.
pub(super) fn shuffled<T>(random: &mut Random, items: &mut [T]) {
    for last in (1..items.len()).rev() {
        items.swap(last, random.below(last + 1));
    }
}

impl Drawing {
    pub(super) fn read(&self, read: Read) -> String {
        match read {
            Read::Input(input) => self.inputs[input].name.clone(),
            Read::Angle(link) => format!("{}.angle", self.links[link].name),
            Read::Slide(link) => format!("{}.slide", self.links[link].name),
        }
    }

    fn value(&self, Value { factor, of, constant }: Value) -> String {
        let read = self.read(of);
        let is_angle = match of {
            Read::Input(input) => self.inputs[input].is_angle,
            Read::Angle(_) => true,
            Read::Slide(_) => false,
        };
        let unit = if is_angle { "rad" } else { "m" };
        let product = if factor == 1.0 { read } else { format!("{factor:?} * {read}") };
        match constant {
            _ if factor == 0.0 => length(constant),
            0.0 => product,
            _ if constant < 0.0 => format!("{product} - {:?}{unit}", -constant),
            _ => format!("{product} + {constant:?}{unit}"),
        }
    }

    fn pin_statement(&self, pin: usize) -> Option<String> {
        let name = &self.pins[pin].name;
        match self.pins[pin].place {
            Place::Ground(at) => Some(format!("ground {name}{};", pair(at))),
            Place::Drawn(at, None) => Some(format!("pin {name}{};", pair(at))),
            Place::Drawn([x, y], Some(param)) => {
                let param = &self.params[param].name;
                Some(format!("pin {name}({} + {param}, {});", length(x), length(y)))
            }
            Place::OnLink(link, at) => {
                Some(format!("point {name} on {} at {};", self.links[link].name, pair(at)))
            }
        }
    }

    fn guide_statement(&self, Guide { name, of, through, along }: &Guide) -> String {
        let of = of.map_or_else(String::new, |link| format!(" on {}", self.links[link].name));
        let through = match *through {
            Through::At(at) => pair(at),
            Through::Pin(pin) => self.pins[pin].name.clone(),
        };
        let along = match *along {
            Along::Degrees(degrees) => format!("along {degrees:?}deg"),
            Along::Towards(pin) => format!("towards {}", self.pins[pin].name),
        };
        format!("guide {name}{of} through {through} {along};")
    }

    fn link_statement(&self, Link { name, pins, on, length }: &Link) -> String {
        let pins: Vec<_> = pins.iter().map(|&pin| &self.pins[pin].name[..]).collect();
        let guides: Vec<_> = on.iter().map(|&guide| &self.guides[guide].name[..]).collect();
        let on =
            if guides.is_empty() { String::new() } else { format!(" on {}", guides.join(", ")) };
        let end = length.map_or_else(
            || ";".to_string(),
            |length| format!(" {{ length: {} }}", self.value(length)),
        );
        format!("link {name}({}){on}{end}", pins.join(", "))
    }

    fn drive_statement(&self, drive: &Drive) -> String {
        let against = drive
            .against
            .map_or_else(String::new, |link| format!(" - {}.angle", self.links[link].name));
        format!("drive {}{against} = {};", self.read(drive.driven), self.value(drive.value))
    }

    /// The statements of kinematics: first what all others read, then the rest in any order.
    pub(super) fn statements(&self, random: &mut Random) -> String {
        let mut head: Vec<_> = self
            .inputs
            .iter()
            .map(|input| {
                let kind = if input.is_angle { "angle" } else { "length" };
                format!("input {}: {kind};", input.name)
            })
            .collect();
        head.extend(
            self.params
                .iter()
                .map(|param| format!("param {} = {};", param.name, length(param.default))),
        );
        let pins = (0..self.pins.len()).filter_map(|pin| self.pin_statement(pin));
        let (first, mut rest): (Vec<_>, Vec<_>) = pins.partition(|text| !text.starts_with("point"));
        head.extend(first);
        rest.extend(self.guides.iter().map(|guide| self.guide_statement(guide)));
        rest.extend(self.links.iter().map(|link| self.link_statement(link)));
        rest.extend(self.drives.iter().map(|drive| self.drive_statement(drive)));
        shuffled(random, &mut rest);
        head.extend(rest);
        head.join("\n")
    }
}
