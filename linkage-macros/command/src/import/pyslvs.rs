//! Expressions of pyslvs: `M[J[R, color[Green], P[0.0, 0.0], L[ground, L1]], …]`.
//!
//! | there | here |
//! |---|---|
//! | `J[R, …]` | a pin of the links that it names |
//! | `J[RP, A[angle], …]` | a guide on its first link, and a block on it that is pinned to the others |
//! | `J[P, A[angle], …]` | a guide on its first link, on which the others slide |
//! | a pair of inputs | the link through both joints is turned about the first; a joint twice: its block is slid |

use super::Mistake;
use super::drawing::{Angle, Drawing, Drive, Guide, Line, Link, Pin};

/// A joint of the expression.
struct Joint {
    kind: String,
    angle: f64,
    at: [f64; 2],
    links: Vec<String>,
}

/// True if a text begins as an expression, behind comments.
pub(crate) fn is_expression(text: &str) -> bool {
    uncommented(text).trim_start().starts_with("M[")
}

/// The text without `# comments`.
fn uncommented(text: &str) -> String {
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

pub(crate) fn read(text: &str, drives: &[String]) -> Result<Drawing, Mistake> {
    let text = uncommented(text);
    let joints = Cursor { text: &text, at: 0 }.expression()?;
    let mut drawing = Drawing::new("Machine", "mm");
    if text.contains("color[") {
        drawing.left_out.push("colours".to_string());
    }
    for (index, joint) in joints.iter().enumerate() {
        draw(&mut drawing, index, joint)?;
    }
    for drive in drives {
        let drive = driven(&drawing, &joints, drive)?;
        drawing.drives.push(drive);
    }
    Ok(drawing)
}

fn is_ground(link: &str) -> bool {
    link == "ground"
}

fn draw(drawing: &mut Drawing, index: usize, joint: &Joint) -> Result<(), Mistake> {
    let (name, block) = (format!("J{index}"), format!("B{index}"));
    let is_pin = joint.kind != "P";
    let pinned =
        if joint.kind == "R" { &joint.links[..] } else { joint.links.get(1..).unwrap_or(&[]) };
    if is_pin {
        let is_ground = pinned.iter().any(|link| is_ground(link));
        drawing.pins.push(Pin { id: name.clone(), at: joint.at, is_ground });
        for link in pinned.iter().filter(|link| !self::is_ground(link)) {
            drawing.link_named(link).pins.push(name.clone());
        }
    }
    if joint.kind == "R" {
        return Ok(());
    }
    let [carrier, others @ ..] = &joint.links[..] else {
        return Err(format!("`J{index}` slides on no link: it names none"));
    };
    let guide = format!("guide_{name}");
    let on = (!is_ground(carrier)).then(|| carrier.clone());
    let line = Line::Along { through: joint.at, angle: Angle::Degrees(joint.angle) };
    drawing.guides.push(Guide { id: guide.clone(), on, line });
    if is_pin {
        drawing.links.push(Link { id: block, pins: vec![name], on: vec![guide] });
        return Ok(());
    }
    if let Some(link) = others.iter().find(|link| is_ground(link)) {
        return Err(format!("`J{index}` lets `{link}` slide on `{carrier}`: name `{link}` first"));
    }
    others.iter().for_each(|link| drawing.link_named(link).on.push(guide.clone()));
    Ok(())
}

/// The drive of a pair of joints.
fn driven(drawing: &Drawing, joints: &[Joint], pair: &str) -> Result<Drive, Mistake> {
    let index = |text: &str| text.trim().parse().ok().filter(|&index: &usize| index < joints.len());
    let Some((pivot, tip)) = pair.split_once(',').and_then(|(a, b)| Some((index(a)?, index(b)?)))
    else {
        return Err(format!(
            "`--drive {pair}` is no pair of joints: there are J0 to J{}",
            joints.len().saturating_sub(1)
        ));
    };
    if pivot == tip {
        return match joints[pivot].kind == "RP" {
            true => Ok(Drive::Slide { link: format!("B{pivot}") }),
            false => {
                Err(format!("`J{pivot}` is driven by itself, and it is no `RP`: it has no block"))
            }
        };
    }
    let [from, to] = [pivot, tip].map(|index| format!("J{index}"));
    let through = |link: &&Link| link.pins.contains(&from) && link.pins.contains(&to);
    let Some(link) = drawing.links.iter().find(through) else {
        return Err(format!("no link goes through both `{from}` and `{to}`"));
    };
    let link = link.id.clone();
    if drawing.pin(&from).is_some_and(|pin| pin.is_ground) {
        return Ok(Drive::Angle { link, against: None });
    }
    let other = drawing.at(&from).find(|other| other.id != link);
    let other = other.ok_or_else(|| {
        format!("`{link}` is turned against nothing: `{from}` is its joint alone")
    })?;
    Ok(Drive::Angle { link, against: Some(other.id.clone()) })
}

struct Cursor<'t> {
    text: &'t str,
    at: usize,
}

impl<'t> Cursor<'t> {
    fn rest(&mut self) -> &'t str {
        let rest = &self.text[self.at..];
        let trimmed = rest.trim_start();
        self.at += rest.len() - trimmed.len();
        trimmed
    }

    fn takes(&mut self, word: &str) -> bool {
        let is_next = self.rest().starts_with(word);
        self.at += if is_next { word.len() } else { 0 };
        is_next
    }

    fn expect(&mut self, word: &str) -> Result<(), Mistake> {
        match self.takes(word) {
            true => Ok(()),
            false => Err(self.missing(&format!("`{word}`"))),
        }
    }

    fn missing(&mut self, what: &str) -> Mistake {
        let rest: String = self.rest().chars().take(20).collect();
        let line = self.text[..self.at].lines().count().max(1);
        match rest.is_empty() {
            true => format!("the expression ends where {what} belongs"),
            false => format!("line {line}: {what} belongs in front of `{rest}`"),
        }
    }

    /// The longest piece of such characters.
    fn piece(&mut self, what: &str, is_part: impl Fn(char) -> bool) -> Result<&'t str, Mistake> {
        let rest = self.rest();
        let length = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        if length == 0 {
            return Err(self.missing(what));
        }
        self.at += length;
        Ok(&rest[..length])
    }

    fn number(&mut self) -> Result<f64, Mistake> {
        let digits = |c: char| c.is_ascii_digit() || "+-.eE".contains(c);
        let text = self.piece("a number", digits)?;
        let number = text.parse().ok().filter(|number: &f64| number.is_finite());
        number.ok_or_else(|| format!("`{text}` is no number"))
    }

    fn expression(&mut self) -> Result<Vec<Joint>, Mistake> {
        self.expect("M[")?;
        let mut joints = Vec::new();
        while !self.takes("]") {
            joints.push(self.joint()?);
            if !self.takes(",") {
                self.expect("]")?;
                break;
            }
        }
        match self.rest().is_empty() {
            true => Ok(joints),
            false => Err(self.missing("nothing")),
        }
    }

    fn joint(&mut self) -> Result<Joint, Mistake> {
        self.expect("J[")?;
        let kind = self.piece("a joint's type", char::is_alphanumeric)?.to_string();
        if !["R", "P", "RP"].contains(&&kind[..]) {
            return Err(format!("`{kind}` is no type of joint; there are R, P and RP"));
        }
        self.expect(",")?;
        let mut angle = 0.0;
        if self.takes("A[") {
            angle = self.number()?;
            self.expect("]")?;
            self.expect(",")?;
        } else if kind != "R" {
            return Err(self.missing(&format!("the angle `A[…]` of a joint {kind}")));
        }
        if self.takes("color[") {
            self.piece("a colour", |c| c != ']')?;
            self.expect("]")?;
            self.expect(",")?;
        }
        self.expect("P[")?;
        let x = self.number()?;
        self.expect(",")?;
        let y = self.number()?;
        self.expect("]")?;
        self.expect(",")?;
        let links = self.links()?;
        self.expect("]")?;
        Ok(Joint { kind, angle, at: [x, y], links })
    }

    fn links(&mut self) -> Result<Vec<String>, Mistake> {
        self.expect("L[")?;
        let mut links = Vec::new();
        while !self.takes("]") {
            links.push(
                self.piece("a link's name", |c| c.is_alphanumeric() || c == '_')?.to_string(),
            );
            if !self.takes(",") {
                self.expect("]")?;
                break;
            }
        }
        Ok(links)
    }
}
