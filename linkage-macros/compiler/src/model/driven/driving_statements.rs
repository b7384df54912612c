//! The statements that drive quantities.

use proc_macro2::{Ident, Span};

use crate::diagnostics::{Diagnostics, nearest};
use crate::syntax::tree::{
    Course, Declaration, DrawnLink, DriveStatement, Expr, ExprKind, GroundStatement, GroupField,
    GroupFieldValue, GroupStatement, GuideAnchor, GuideStatement, LinkStatement, PointPlace,
    PointStatement, Statement, StatementKind, Unwritten,
};

use crate::model::drawn::writing::free_names::FreeNames;
use crate::model::driven::coordinate::{Coordinate, Moves};
use crate::model::names::Kind;
use crate::model::statements::declared_by;

/// A point that inputs move, and the input of each of its coordinates.
struct MovedPoint<'t> {
    point: &'t Ident,
    by: [Option<Coordinate<'t>>; 2],
}

/// The statements that drive the quantities that were read so far.
pub(super) struct DrivingStatements<'t> {
    tree: &'t Declaration,
    names: FreeNames,
    statements: Vec<StatementKind>,
    points: Vec<MovedPoint<'t>>,
    seen: Vec<(&'t Ident, Moves<'t>)>,
    /// Links that have their length by an input.
    lengths: Vec<([&'t Ident; 2], Expr)>,
    unwritten: Unwritten,
}

impl<'t> DrivingStatements<'t> {
    pub(super) fn of(tree: &'t Declaration) -> Self {
        Self {
            tree,
            names: FreeNames::of(tree),
            statements: Vec::new(),
            points: Vec::new(),
            seen: Vec::new(),
            lengths: Vec::new(),
            unwritten: tree.unwritten.clone(),
        }
    }

    /// Drives what an input is.
    pub(super) fn drive(&mut self, coordinate: Coordinate<'t>, diagnostics: &mut Diagnostics) {
        if let Some((name, _)) = self.seen.iter().find(|(_, known)| known.is(&coordinate.moves)) {
            let message = format!("`{name}` and `{}` are one quantity", coordinate.name);
            let reason = format!("leave out `{} = {}`", coordinate.name, coordinate.written);
            diagnostics.error_because(coordinate.at, message, reason);
            return;
        }
        self.seen.push((coordinate.name, coordinate.moves.clone()));
        let value = coordinate.value.clone();
        match coordinate.moves {
            Moves::Link([link, member], to) => {
                let to = to.map(|to| to.map(Ident::clone).into());
                let of = format!("{link}.{member}");
                self.drive_is_told(&of, &coordinate);
                let (link, member) = (link.clone(), member.clone());
                self.statements.push(StatementKind::Drive(DriveStatement {
                    link,
                    member,
                    to,
                    value,
                    written: None,
                }));
            }
            Moves::Length(own @ [link, member]) => {
                let is_link = |(name, kind): &(&Ident, Kind)| *name == link && *kind == Kind::Link;
                let mut declared = self.tree.statements.iter().flat_map(declared_by);
                if !declared.any(|declared| is_link(&declared)) {
                    // The model has a message for a link that is not there.
                    let (link, member) = (link.clone(), Ident::new("angle", member.span()));
                    let drive = DriveStatement { link, member, to: None, value, written: None };
                    self.statements.push(StatementKind::Drive(drive));
                    return;
                }
                self.lengths.push((own, value));
            }
            Moves::Place(point, axis) => {
                if self.is_a_point_that_moves(point, diagnostics) {
                    self.place(point, axis, coordinate);
                }
            }
            Moves::Distance(ends) => self.distance(ends, &coordinate, diagnostics),
        }
    }

    fn place(&mut self, point: &'t Ident, axis: usize, coordinate: Coordinate<'t>) {
        let at = self.points.iter().position(|moved| moved.point == point);
        let at = at.unwrap_or_else(|| {
            self.points.push(MovedPoint { point, by: [None, None] });
            self.points.len() - 1
        });
        self.points[at].by[axis] = Some(coordinate);
    }

    /// The statements with what drives their quantities, and what of it nobody has written.
    pub(super) fn finish(
        mut self,
        statements: &mut Vec<Statement>,
        diagnostics: &mut Diagnostics,
    ) -> Unwritten {
        for MovedPoint { point, by } in std::mem::take(&mut self.points) {
            match by {
                [Some(x), Some(y)] if !self.is_on_a_link(point) => self.moved([x, y], point),
                by => {
                    for (axis, coordinate) in by.iter().enumerate() {
                        coordinate.iter().for_each(|by| self.carried(point, axis, by));
                    }
                }
            }
        }
        for (link, value) in std::mem::take(&mut self.lengths) {
            lengthen(statements, link, value, diagnostics);
        }
        let driven = self.statements.into_iter();
        statements.extend(driven.map(|kind| Statement { docs: Vec::new(), kind }));
        self.unwritten
    }

    /// A point of which both coordinates are inputs.
    fn moved(&mut self, by: [Coordinate<'t>; 2], point: &Ident) {
        self.told(&format!("`link {point}`"), self.statement(&by[0]));
        let place = PointPlace::Cartesian(by.map(|coordinate| coordinate.value));
        let point = PointStatement { name: point.clone(), on: None, place };
        self.statements.push(StatementKind::Point(point));
    }

    /// A carriage that slides along an axis, and across it the point whose coordinate is its slide.
    fn carried(&mut self, point: &Ident, axis: usize, coordinate: &Coordinate<'_>) {
        let span = point.span();
        let number = |digits: &str, units: &[&str]| {
            let units = units.iter().map(|unit| (unit.to_string(), 1)).collect();
            let kind = ExprKind::Number { digits: digits.to_string(), units };
            Expr { kind, span: span.into() }
        };
        let right = number("90", &["deg"]);
        let (along, across) = if axis == 0 {
            (number("0", &["deg"]), right)
        } else {
            (right.clone(), right.negated())
        };
        let [rail, carriage, way, block] = ["rail", "carriage", "way", "block"].map(|part| {
            let letter = ["x", "y"][axis];
            self.named(format!("{point}_{letter}_{part}"), coordinate)
        });
        let link = |name: &Ident, pins: Vec<Ident>, guide: &Ident| {
            let link = DrawnLink { name: name.clone(), pins, on: vec![guide.clone()] };
            StatementKind::Link(LinkStatement { links: vec![link], fields: None })
        };
        let guide = |name: &Ident, on, through, course| {
            StatementKind::Guide(GuideStatement {
                name: name.clone(),
                on,
                through,
                course: Course::Along(course),
            })
        };
        let drive = DriveStatement {
            link: carriage.clone(),
            member: Ident::new("slide", span),
            to: None,
            value: coordinate.value.clone(),
            written: None,
        };
        let origin = GuideAnchor::At([number("0", &[]), number("0", &[])]);
        self.statements.extend([
            guide(&rail, None, origin, along),
            link(&carriage, Vec::new(), &rail),
            guide(&way, Some(carriage), GuideAnchor::Point(point.clone()), across),
            link(&block, vec![point.clone()], &way),
            StatementKind::Drive(drive),
        ]);
    }

    /// A link whose length is the distance of two points.
    fn distance(
        &mut self,
        ends: [&'t Ident; 2],
        coordinate: &Coordinate<'t>,
        diagnostics: &mut Diagnostics,
    ) {
        let [first, second] = ends;
        if let Some(reason) = self.rigid(ends) {
            let message = format!("`distance({first}, {second})` does not change");
            diagnostics.error_because(coordinate.at, message, reason);
            return;
        }
        let name = self.named(format!("{first}_{second}"), coordinate);
        let mut fields =
            GroupStatement::without_links(Ident::new("link", first.span()), first.span());
        fields.fields.push(length(first.span(), coordinate.value.clone()));
        let link = DrawnLink { name, pins: ends.map(Ident::clone).to_vec(), on: Vec::new() };
        let link = LinkStatement { links: vec![link], fields: Some(fields) };
        self.statements.push(StatementKind::Link(link));
    }

    /// The reason why two points keep their distance.
    fn rigid(&self, [first, second]: [&Ident; 2]) -> Option<String> {
        let is_on = |pins: &[Ident]| [first, second].iter().all(|end| pins.contains(end));
        for statement in &self.tree.statements {
            match &statement.kind {
                StatementKind::Link(LinkStatement { links, .. }) => {
                    if let Some(link) = links.iter().find(|link| is_on(&link.pins)) {
                        let name = &link.name;
                        return Some(match link.pins.len() {
                            2 => format!(
                                "`{name}` joins the two: leave it out, or write `{name}.length`"
                            ),
                            _ => format!("both are pins of `{name}`"),
                        });
                    }
                }
                StatementKind::Ground(GroundStatement { points }) => {
                    let points: Vec<_> = points.iter().map(|(name, _)| name.clone()).collect();
                    if is_on(&points) {
                        return Some("both points stand still".to_string());
                    }
                }
                _ => {}
            }
        }
        None
    }

    /// True if there is such a point, and it moves; what is wrong is reported.
    fn is_a_point_that_moves(&self, point: &Ident, diagnostics: &mut Diagnostics) -> bool {
        let names: Vec<_> = self.tree.statements.iter().flat_map(declared_by).collect();
        let (message, reason) = match names.iter().find(|(name, _)| *name == point) {
            Some((_, Kind::Point)) => {
                let stands = self.tree.statements.iter().any(|statement| match &statement.kind {
                    StatementKind::Ground(GroundStatement { points }) => {
                        points.iter().any(|(name, _)| name == point)
                    }
                    _ => false,
                });
                if !stands {
                    return true;
                }
                let reason = "an input moves a `pin` of the drawing, or a point on a link";
                (format!("`{point}` stands still"), reason.to_string())
            }
            Some((_, kind)) => {
                let reason = "a coordinate is that of a point: `tool.x`".to_string();
                (format!("`{point}` is {}, not a point", kind.one()), reason)
            }
            None if self.tree.unread.may_hold(&point.to_string()) => return false,
            None => {
                let points = names.iter().filter(|(_, kind)| *kind == Kind::Point);
                let points: Vec<_> = points.map(|(name, _)| name.to_string()).collect();
                let near = nearest(&point.to_string(), points.iter().map(|name| &name[..]));
                let near = near.map(|near| format!("; one with a similar name exists: `{near}`"));
                let message = format!("no pin named `{point}`{}", near.unwrap_or_default());
                (message, format!("say where it is drawn: `pin {point}(…, …);`"))
            }
        };
        diagnostics.error_because(point.span(), message, reason);
        false
    }

    fn is_on_a_link(&self, point: &Ident) -> bool {
        self.tree.statements.iter().any(|statement| match &statement.kind {
            StatementKind::Point(PointStatement { name, on, .. }) => name == point && on.is_some(),
            _ => false,
        })
    }

    /// A name that nobody has written, and how messages tell what it stands for.
    fn named(&mut self, name: String, coordinate: &Coordinate<'_>) -> Ident {
        let name = self.names.made(name, "_", coordinate.name.span());
        self.told(&format!("`link {name}`"), self.statement(coordinate));
        self.drive_is_told(&format!("{name}.slide"), coordinate);
        self.told(&name.to_string(), coordinate.written.clone());
        self.unwritten.names.push(name.clone());
        name
    }

    /// The part of a statement that makes it an input, in quotes.
    fn statement(&self, coordinate: &Coordinate<'_>) -> String {
        let word = if self.unwritten.set.is_some() { "" } else { "input " };
        format!("`{word}{} = {}`", coordinate.name, coordinate.written)
    }

    fn drive_is_told(&mut self, of: &str, coordinate: &Coordinate<'_>) {
        self.told(&format!("`drive {of}`"), self.statement(coordinate));
    }

    fn told(&mut self, text: &str, instead: String) {
        self.unwritten.told.push([text.to_string(), instead]);
    }
}

fn length(at: Span, value: Expr) -> GroupField {
    GroupField { name: Ident::new("length", at), value: GroupFieldValue::One(value) }
}

/// Gives a link that is drawn a length.
fn lengthen(
    statements: &mut Vec<Statement>,
    [name, member]: [&Ident; 2],
    value: Expr,
    diagnostics: &mut Diagnostics,
) {
    let mut found = None;
    for (index, statement) in statements.iter_mut().enumerate() {
        let StatementKind::Link(LinkStatement { links, fields }) = &mut statement.kind else {
            continue;
        };
        let Some(place) = links.iter().position(|link| link.name == *name) else { continue };
        if fields.is_some() {
            let message = format!("`{name}` has a length already; leave out its braces");
            let reason = format!("`{name}.length` is an input");
            diagnostics.error_because(member.span(), message, reason);
            return;
        }
        found = Some((index, links.remove(place), links.is_empty(), statement.docs.clone()));
        break;
    }
    let Some((index, link, is_alone, docs)) = found else { return };
    let mut fields = GroupStatement::without_links(Ident::new("link", name.span()), name.span());
    fields.fields.push(length(member.span(), value));
    let kind = StatementKind::Link(LinkStatement { links: vec![link], fields: Some(fields) });
    let statement = Statement { docs, kind };
    if is_alone {
        statements[index] = statement;
    } else {
        statements.insert(index, statement);
    }
}
