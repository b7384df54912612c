//! Habits of drawings: pins, links and drives as other programs write them. Each is told the statement that is meant,
//! with the names that were written.

use proc_macro2::{Delimiter, Group, Ident, TokenTree};

use super::anatomy::Modes;
use super::tokens::{Parse, Parser};
use super::tree::DriveStatement;
use crate::function::Function;

/// The parts of a link that moves.
const MOVES: [&str; 2] = ["angle", "slide"];

impl Parser<'_> {
    /// True if pins, links or drives are declared.
    pub(super) fn is_of_a_drawing(&self) -> bool {
        let of_a_drawing = |tree: &TokenTree| matches!(tree, TokenTree::Ident(word) if ["pin", "link", "drive"].iter().any(|own| word == own));
        self.trees.iter().any(of_a_drawing)
    }

    /// Some tokens from the next one on as they are written.
    pub(super) fn as_written(&self, from: usize, is_end: impl Fn(&TokenTree) -> bool) -> String {
        let rest = self.trees.iter().skip(self.next + from);
        written(rest.take_while(|tree| !is_end(tree)).cloned())
    }

    /// The rest of the statement as it is written.
    pub(super) fn rest_of_statement(&self, from: usize) -> String {
        self.as_written(from, |tree| matches!(tree, TokenTree::Punct(end) if end.as_char() == ';'))
    }

    /// `link B-C;`: the name and the pins that are meant.
    pub(super) fn link_of_hyphens(&mut self) -> Option<(Ident, Vec<Ident>)> {
        let mut pins = vec![self.peek_ident(0)?.clone()];
        while self.is_punct(2 * pins.len() - 1, '-') {
            pins.push(self.peek_ident(2 * pins.len())?.clone());
        }
        let goes_on = self.is_group(2 * pins.len() - 1, Delimiter::Parenthesis);
        if pins.len() < 2 || goes_on {
            return None;
        }
        let first = self.here();
        self.next += 2 * pins.len() - 1;
        let name: String = pins.iter().map(ToString::to_string).collect();
        let message = format!("write `link {name}({})`", listed(&pins));
        let reason = "a link has a name, and its pins stand in parentheses";
        self.diagnostics.error_because(self.since(first), message, reason);
        Some((Ident::new(&name, first), pins))
    }

    /// `link BC: B, C;`: the pins.
    pub(super) fn pins_behind_a_colon(&mut self, name: &Ident) -> Option<Vec<Ident>> {
        let mut pins = Vec::new();
        while self.is_punct(2 * pins.len(), if pins.is_empty() { ':' } else { ',' }) {
            pins.push(self.peek_ident(2 * pins.len() + 1)?.clone());
        }
        if pins.is_empty() {
            return None;
        }
        let message = format!("write `link {name}({})`", listed(&pins));
        let _ = self.refuse_because::<()>(&message, "the pins of a link stand in parentheses");
        self.next += 2 * pins.len();
        Some(pins)
    }

    /// `link BC(B) -> C;`: the arrow and its pin.
    pub(super) fn pin_behind_an_arrow(&mut self, name: &Ident, pins: &mut Vec<Ident>) {
        let Some(pin) = self.peek_ident(2).cloned().filter(|_| self.is_sign(['-', '>'])) else {
            return;
        };
        pins.push(pin);
        let message = format!("write `link {name}({})`", listed(pins));
        let reason = "a link makes no pin: it goes through those that are drawn";
        let _ = self.refuse_because::<()>(&message, reason);
        self.next += 3;
    }

    /// `link DC(D, C) left;`
    pub(super) fn leave_out_mode(&mut self) {
        if Modes::ALL.iter().flat_map(|modes| modes.words()).any(|mode| self.is_word(0, mode)) {
            let message = format!("leave out {}", self.found());
            let _ = self.refuse_because::<()>(&message, "a link assembles as it is drawn");
            self.take();
        }
    }

    /// `drive theta = AB.angle;`, and `drive AB = theta;`, which is given up.
    pub(super) fn drive_without_its_part(&mut self) -> Option<Parse<DriveStatement>> {
        let first = self.peek_ident(0)?.clone();
        if !self.is_punct(1, '=') {
            return None;
        }
        let reason = "a drive turns a link by its `angle`, or moves what slides by its `slide`";
        let moves = |member: &Ident| MOVES.iter().any(|known| member == known);
        match (self.peek_ident(2).cloned(), self.peek_ident(4).cloned().filter(moves)) {
            (Some(link), Some(member)) if self.is_punct(3, '.') && self.is_punct(5, ';') => {
                let message = format!("write `drive {link}.{member} = {first};`");
                let _ = self.refuse_because::<()>(&message, reason);
                self.next += 2;
                let value = super::tree::Expr {
                    kind: super::tree::ExprKind::Name(first.clone()),
                    span: first.span().into(),
                };
                self.next += 3;
                Some(Ok(DriveStatement { link, member, to: None, value, written: None }))
            }
            _ => {
                let member = if self.slides(&first) { "slide" } else { "angle" };
                let value = self.rest_of_statement(2);
                let message = format!("write `drive {first}.{member} = {value};`");
                Some(self.refuse_because(&message, reason))
            }
        }
    }

    /// `drive tool.x = x;`, `drive distance(F, G) = s;`, behind the first word: the statement that is meant.
    pub(super) fn quantity_of_an_input(&self) -> Option<String> {
        let is_coordinate =
            self.is_punct(1, '.') && ["x", "y"].iter().any(|it| self.is_word(2, it));
        let is_distance = self.is_word(0, "distance") && self.is_group(1, Delimiter::Parenthesis);
        let long = if is_coordinate { 3 } else { 2 };
        let goes_on = self.is_punct(long, '=') && (is_coordinate || is_distance);
        let quantity = goes_on.then(|| {
            self.as_written(
                0,
                |tree| matches!(tree, TokenTree::Punct(sign) if sign.as_char() == '='),
            )
        })?;
        let input = self.peek_ident(long + 1).filter(|_| self.is_punct(long + 2, ';'));
        let input = input.map_or("q".to_string(), ToString::to_string);
        Some(format!("write `input {input} = {quantity};`"))
    }

    /// True if a link slides by its statement: `ram(E) on bed`.
    fn slides(&self, link: &Ident) -> bool {
        self.trees.windows(3).any(|part| match part {
            [TokenTree::Ident(name), TokenTree::Group(_), TokenTree::Ident(on)] => {
                name == link && on == "on"
            }
            _ => false,
        })
    }

    /// True if a link of this name is declared: `BC(B, C)`.
    pub(super) fn is_a_link(&self, name: &Ident) -> bool {
        let is_pin = |tree: TokenTree| match tree {
            TokenTree::Ident(_) => true,
            TokenTree::Punct(comma) => comma.as_char() == ',',
            _ => false,
        };
        self.trees.windows(2).any(|part| match part {
            [TokenTree::Ident(own), TokenTree::Group(pins)] => {
                own == name && pins.stream().into_iter().all(is_pin)
            }
            _ => false,
        })
    }

    /// The statement of a drawing that is meant by a word of other programs, which was taken.
    pub(super) fn meant_in_a_drawing(&self, word: &str) -> Option<String> {
        Some(match word {
            "motor" | "driver" | "actuator" => {
                format!("what is meant may be `{}`", self.drive_that_is_meant())
            }
            "joint" | "hinge" | "revolute" => {
                "leave this out: links turn at each pin that they share".to_string()
            }
            "prismatic" | "piston" => {
                "what slides is a link on a guide: `link ram(E) on bed;`".to_string()
            }
            "bar" | "rod" | "rocker" | "coupler" | "lever" | "arm" => {
                "every body is a `link`, with the pins through it: `link BC(B, C);`".to_string()
            }
            "cylinder" | "strut" => {
                "a cylinder is a link whose length is an input: `link lift(F, G) { length: s }`"
                    .to_string()
            }
            _ => return None,
        })
    }

    /// `motor A = theta;`, behind its first word: the drive that is meant. A motor at a pin turns the first link
    /// through it.
    pub(super) fn drive_that_is_meant(&self) -> String {
        let through = |pin: &Ident| {
            self.trees.windows(3).find_map(|part| match part {
                [TokenTree::Ident(word), TokenTree::Ident(link), TokenTree::Group(pins)]
                    if word == "link" && *link != *pin =>
                {
                    let is_it = |tree| matches!(tree, TokenTree::Ident(own) if own == *pin);
                    pins.stream().into_iter().any(is_it).then(|| link.clone())
                }
                _ => None,
            })
        };
        let link = self.peek_ident(0).map(|name| through(name).unwrap_or(name.clone()));
        match link {
            Some(link) if self.is_punct(1, '=') => {
                let member = if self.slides(&link) { "slide" } else { "angle" };
                format!("drive {link}.{member} = {};", self.rest_of_statement(2))
            }
            _ => "drive AB.angle = theta;".to_string(),
        }
    }

    /// `ground base(A(0, 0), D(1m, 0));`: the points in the parentheses behind the name.
    pub(super) fn points_of_a_frame(&mut self, word: &str, name: &Ident) -> Option<Group> {
        let Some(TokenTree::Group(group)) = self.peek(0) else { return None };
        let trees: Vec<_> = group.stream().into_iter().collect();
        let is_point = match &trees[..] {
            [TokenTree::Ident(first), TokenTree::Group(at), ..] => {
                let is_call = Function::named(&first.to_string()).is_some()
                    || ["distance", "offset"].iter().any(|call| first == call);
                !is_call && parts(at).len() == 2
            }
            _ => false,
        };
        let content = written(trees);
        if !is_point {
            return None;
        }
        let group = group.clone();
        let message = format!("write `{word} {content};`");
        let reason = format!("`{name}` would be the name of a point");
        self.diagnostics.error_because(name.span(), message, reason);
        self.take();
        Some(group)
    }

    /// `C(B + (270mm, 140mm))` and `B polar(72mm, 34deg)`, behind the name: the coordinates that are meant.
    pub(super) fn coordinates_that_are_meant(&mut self, word: &str, name: &Ident) -> bool {
        if let (true, Some(TokenTree::Group(group))) = (self.is_word(0, "polar"), self.peek(1)) {
            let [radius, angle] = &parts(group)[..] else { return false };
            let message =
                format!("write `{name}({radius} * cos({angle}), {radius} * sin({angle}))`");
            let _ = self.refuse_because::<()>(&message, "a place is two coordinates");
            self.next += 2;
            return true;
        }
        let Some(TokenTree::Group(group)) = self.peek(0) else { return false };
        let trees: Vec<_> = group.stream().into_iter().collect();
        let [TokenTree::Ident(from), TokenTree::Punct(sign), TokenTree::Group(by)] = &trees[..]
        else {
            return false;
        };
        let ([x, y], '+' | '-') = (&parts(by)[..], sign.as_char()) else { return false };
        let place = format!("{name}({from}.x {sign} {x}, {from}.y {sign} {y})");
        let message = format!("write `{word} {place};` behind the statement of `{from}`");
        let at = crate::diagnostics::Extent::between(from.span(), by.span());
        self.diagnostics.error_because(at, message, "a place is two coordinates");
        self.take();
        true
    }
}

/// The texts between the commas of a group.
pub(super) fn parts(group: &Group) -> Vec<String> {
    let trees: Vec<_> = group.stream().into_iter().collect();
    let is_comma =
        |tree: &TokenTree| matches!(tree, TokenTree::Punct(comma) if comma.as_char() == ',');
    trees.split(is_comma).map(|part| written(part.to_vec())).collect()
}

/// Tokens as they are written: `2 * AB.angle`.
pub(super) fn written(trees: impl IntoIterator<Item = TokenTree>) -> String {
    let (mut text, mut is_tight) = (String::new(), true);
    for tree in trees {
        let is_called = matches!(&tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis)
            && text.ends_with(|last: char| last.is_alphanumeric());
        let own = match &tree {
            TokenTree::Group(group) => group.span().source_text().unwrap_or(group.to_string()),
            tree => tree.to_string(),
        };
        let is_behind = [".", ",", ":"].contains(&&own[..]);
        if !is_tight && !is_called && !is_behind {
            text.push(' ');
        }
        // A sign in front of a number belongs to it.
        let is_sign =
            own == "-" && (text.is_empty() || text.trim_end().ends_with(['*', '/', ',', '=']));
        is_tight = own == "." || is_sign;
        text += &own;
    }
    text
}

fn listed(names: &[Ident]) -> String {
    names.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}
