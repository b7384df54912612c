//! Colours and sizes: everything about the look that is not a shape.

use std::format;
use std::string::String;
use std::vec::Vec;

/// On which paper a picture is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Light, and dark in a browser whose reader prefers a dark scheme.
    #[default]
    Auto,
    /// Dark ink on white.
    Light,
    /// Light ink on near black.
    Dark,
}

/// The unit of the scale bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Millimetres.
    Mm,
    /// Centimetres.
    Cm,
    /// Metres.
    M,
}

impl Unit {
    /// The name, and how many there are in a metre.
    pub(super) fn of(self) -> (&'static str, f64) {
        match self {
            Self::Mm => ("mm", 1e3),
            Self::Cm => ("cm", 1e2),
            Self::M => ("m", 1.0),
        }
    }
}

/// The colours of a theme, as SVG writes them: for what is written beside a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Palette {
    /// The background.
    pub paper: &'static str,
    /// Joints, supports, texts.
    pub ink: &'static str,
    /// For what only explains.
    pub quiet: &'static str,
    /// Forces, couples, and what is missing in a pose.
    pub accent: &'static str,
    /// Reactions of joints.
    pub push: &'static str,
    /// The links', by their declaration: told apart without colour vision too (Okabe and Ito).
    pub links: [&'static str; 6],
}

impl Palette {
    fn all(&self) -> impl Iterator<Item = &'static str> {
        [self.paper, self.ink, self.quiet, self.accent, self.push].into_iter().chain(self.links)
    }
}

impl Theme {
    /// Its colours; those of paper that is light at first.
    #[must_use]
    pub const fn palette(self) -> Palette {
        match self {
            Self::Auto | Self::Light => Palette {
                paper: "#ffffff",
                ink: "#222222",
                quiet: "#667079",
                accent: "#b8123c",
                push: "#6f42c1",
                links: ["#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"],
            },
            Self::Dark => Palette {
                paper: "#0d1117",
                ink: "#e6edf3",
                quiet: "#7d8590",
                accent: "#ff7d95",
                push: "#b99aff",
                links: ["#f08a3c", "#4ea1e0", "#2fc99b", "#e39cc4", "#f2b53b", "#7cc7f2"],
            },
        }
    }

    /// The text of a picture in the colours of [`palette`](Self::palette); of `Auto` with rules by which
    /// a browser replaces them where its reader prefers a dark scheme.
    #[must_use]
    pub fn applied_to(self, svg: &str) -> String {
        let parts = svg.split_once('>').filter(|_| self == Self::Auto);
        let Some((head, rest)) = parts else { return svg.into() };
        let [day, night] = [Self::Light, Self::Dark].map(Self::palette);
        let mut rules = String::new();
        for (from, to) in day.all().zip(night.all()) {
            for property in ["fill", "stroke"] {
                let attribute = format!(r#"{property}="{from}""#);
                if rest.contains(&attribute) {
                    // Pictures of other themes may stand on the same page.
                    rules += &format!(".auto [{attribute}]{{{property}:{to}}}");
                }
            }
        }
        format!(
            r#"{head} class="auto"><style>@media (prefers-color-scheme:dark){{{rules}}}</style>{rest}"#
        )
    }
}

/// Around everything.
pub(super) const MARGIN: f64 = 46.0;
/// The largest page. On a higher one the straight lines between 120 poses of a turn would part joints
/// by more than a tenth of a pixel.
pub(super) const WIDTH: f64 = 720.0;
pub(super) const HEIGHT: f64 = 608.0;
/// A joint's circle.
pub(super) const JOINT: f64 = 4.6;
/// A block, along its guide and across.
pub(super) const BLOCK: [f64; 2] = [26.0, 17.0];
/// Height of a tube.
pub(super) const TUBE: f64 = 14.0;
/// Half of what a spring's coils and a damper's cylinder take across.
pub(super) const ZIGZAG: f64 = 6.0;
pub(super) const DAMPER: f64 = 6.0;
/// A wall that a spring stands on.
pub(super) const WALL: f64 = 34.0;
/// A support: half the base of its triangle, its height, half the base line.
pub(super) const SUPPORT: [f64; 3] = [10.0, 17.0, 17.0];
/// The length by which a guide exceeds the travel of its blocks' middles, at both ends.
pub(super) const OVERRUN: f64 = 27.0;
/// Size of labels, and of what explains.
pub(super) const LABEL: f64 = 13.0;
pub(super) const SMALL: f64 = 12.0;
/// Size of a heading, and from line to line of it.
pub(super) const HEADING: f64 = 15.0;
pub(super) const HEADING_LINE: f64 = 20.0;
pub(super) const FONT: &str = "Helvetica Neue,Arial,Liberation Sans,sans-serif";

/// The text in lines so wide at most, but for words that are wider.
pub(super) fn wrapped(text: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line)
                if size * text_width(line) + size * text_width(word) + 0.3 * size <= width =>
            {
                *line += " ";
                *line += word;
            }
            _ => lines.push(word.into()),
        }
    }
    lines
}

/// True if a letter of the text reaches below its line.
pub(super) fn has_descender(text: &str) -> bool {
    text.contains(['g', 'j', 'p', 'q', 'y', 'Q', '_', ',', '(', ')', 'f'])
}

/// The width of a text at size one in the fonts above, or a little more.
pub(super) fn text_width(text: &str) -> f64 {
    let width = |letter: char| match letter {
        'i' | 'j' | 'l' | 'I' | '.' | ',' | ':' | ' ' | '\'' => 0.3,
        'f' | 't' | 'r' | '-' | '(' | ')' => 0.36,
        'm' | 'w' | 'M' => 0.86,
        'W' => 0.96,
        'G' | 'O' | 'Q' => 0.79,
        'A'..='Z' => 0.73,
        _ => 0.58,
    };
    text.chars().map(width).sum()
}
