//! The machine of a drawing: its joints and drives.

use proc_macro2::Ident;

use crate::chain::machine::{Driven, Driving, Footing, GROUND, Machine, RigidBody, Slide};
use crate::chain::plane::Complex;
use crate::syntax::tree::{
    DriveStatement, Expr, ExprKind, GroundStatement, GroupStatement, Statement, StatementKind,
};

use crate::model::drawn::outline::bodies::{Bodies, GuideLine};
use crate::model::drawn::outline::frames::DrawnFrame;
use crate::model::drawn::reading::reader::Reader;
use crate::model::figures::Figure;
use crate::model::references::names_used;

impl<'t> Reader<'t, '_, '_> {
    pub(in crate::model::drawn) fn read_drives(&mut self) -> Vec<(usize, &'t DriveStatement)> {
        let tree = self.tree;
        let mut drives = Vec::new();
        for (index, statement) in tree.statements.iter().enumerate() {
            let StatementKind::Drive(drive) = &statement.kind else { continue };
            self.body(&drive.link);
            if let Some((link, _)) = &drive.to {
                self.body(link);
            }
            let members = [Some(&drive.member), drive.to.as_ref().map(|(_, member)| member)];
            let [first, second] = members.map(|member| member.map(ToString::to_string));
            let is_fine = matches!(
                (first.as_deref(), second.as_deref()),
                (Some("angle"), None | Some("angle")) | (Some("slide"), None)
            );
            if drive.member == "length" {
                let message = "a drive gives an angle or a slide";
                let reason = format!(
                    "the length of a cylinder stands in its braces: `link {}(F, G) {{ length: … }}`",
                    drive.link
                );
                self.report(&drive.member, message.to_string(), reason);
            } else if !is_fine {
                let message = "a drive gives an angle, the difference of two, or a slide";
                let reason = "write `drive AB.angle = …`, `drive BC.angle - AB.angle = …` or `drive \
                              ram.slide = …`";
                self.report(&drive.member, message.to_string(), reason.to_string());
            }
            drives.push((index, drive));
        }
        drives
    }

    /// The machine of all that was read.
    pub fn machine(
        mut self,
        drives: Vec<(usize, &'t DriveStatement)>,
        frames: Vec<DrawnFrame>,
    ) -> Option<Bodies<'t>> {
        let drawn = |at: &[Figure; 2]| Complex::new(at[0].value, at[1].value);
        let mut machine = Machine {
            pins: self.pins.iter().map(|pin| drawn(&pin.at)).collect(),
            ..Machine::default()
        };
        let grounded = self.tree.statements.iter().flat_map(|statement| match &statement.kind {
            StatementKind::Ground(GroundStatement { points }) => &points[..],
            _ => &[],
        });
        let grounded = grounded.filter_map(|(name, _)| self.pin_of.get(&name.to_string()).copied());
        machine.bodies.push(RigidBody { pins: grounded.collect(), ..RigidBody::default() });
        for index in 0..self.links.len() {
            let link = &self.links[index];
            let pins = link.pins.iter().chain(&link.points).copied().collect();
            let statement = &self.tree.statements[link.statement];
            let given = link.is_given.then(|| self.needs(statement));
            let reads = match &link.length {
                Some((length, _)) => self.links_in(length),
                None => Vec::new(),
            };
            machine.bodies.push(RigidBody { pins, given, reads });
        }
        let fixed = self.fixed(&mut machine);
        for (index, link) in self.links.iter().enumerate() {
            for &guide in &link.on {
                let GuideLine { on, line, .. } = &self.guides[guide];
                machine.slides.push(Slide {
                    body: index + 1,
                    carrier: *on,
                    through: drawn(&line.through),
                    along: drawn(&line.along).unit(),
                });
            }
        }
        for (_, drive) in &drives {
            machine.drives.push(self.driving(&machine, drive)?);
        }
        machine.varies = self.varies();
        machine.is_loaded =
            self.tree.statements.iter().any(|s| matches!(s.kind, StatementKind::Action(_)));
        let Self { tree, pins, links, guides, .. } = self;
        let (displacements, driven) = (Vec::new(), Vec::new());
        Some(Bodies {
            tree,
            pins,
            links,
            guides,
            drives,
            frames,
            machine,
            fixed,
            displacements,
            driven,
        })
    }

    /// The links that two pins hold to the ground: they are parts of it.
    fn fixed(&self, machine: &mut Machine) -> Vec<usize> {
        let mut resting = machine.bodies[GROUND].pins.clone();
        let mut fixed: Vec<usize> = Vec::new();
        loop {
            let held = |body: usize| {
                let link = &self.links[body - 1];
                let pins: Vec<_> =
                    link.pins.iter().copied().filter(|pin| resting.contains(pin)).collect();
                let is_free = !link.is_given && link.length.is_none() && !fixed.contains(&body);
                (is_free && pins.len() > 1).then_some((body, pins))
            };
            let Some((body, pins)) = (1..machine.bodies.len()).find_map(held) else { return fixed };
            let of = &mut machine.bodies[body];
            resting.extend(&of.pins);
            of.given = Some(Footing { bodies: Vec::new(), pins });
            fixed.push(body);
        }
    }

    /// True if a dimension of the drawing is not a constant.
    fn varies(&self) -> bool {
        let is_constant = |place: &[Figure; 2]| place.iter().all(|number| number.exact().is_some());
        let lengths = self.links.iter().filter_map(|link| link.length.as_ref());
        let mut lengths = lengths.map(|(_, length)| length.as_ref());
        let is_drawn = self.pins.iter().all(|pin| pin.on.is_some() || is_constant(&pin.at))
            && self.guides.iter().all(|guide| is_constant(&guide.line.along));
        !is_drawn || lengths.any(|length| length.is_none_or(|length| length.exact().is_none()))
    }

    fn driving(&mut self, machine: &Machine, drive: &DriveStatement) -> Option<Driving> {
        let body = self.body(&drive.link)?;
        let to = match &drive.to {
            Some((link, _)) => self.body(link)?,
            None => GROUND,
        };
        let reads = self.links_in(&drive.value);
        let slide =
            |slide: &Slide| slide.body == body && (drive.member == "slide" || slide.carrier == to);
        let slide = machine.slides.iter().position(slide);
        let link = &drive.link;
        if drive.member == "slide" {
            let Some(slide) = slide else {
                let message = format!("`{link}` slides on no guide");
                let pins: Vec<_> = machine.bodies[body].pins.iter().collect();
                let reason = match pins[..] {
                    [&p, &q] => {
                        let [p, q] = [p, q].map(|pin| &self.pins[pin].name);
                        format!(
                            "a cylinder has a length: `link {link}({p}, {q}) {{ length: … }}`; what slides is \
                             declared as `link {link}(…) on GUIDE;`"
                        )
                    }
                    _ => format!("declare it as `link {link}(…) on GUIDE;`"),
                };
                self.report(&drive.member, message, reason);
                return None;
            };
            let bodies = [body, machine.slides[slide].carrier];
            return Some(Driving { kind: Driven::Slide(slide), bodies, reads });
        }
        if slide.is_some() {
            let message = format!("`{link}` slides without turning; drive its slide");
            self.report(&drive.member, message, format!("write `drive {link}.slide = …`"));
            return None;
        }
        Some(Driving { kind: Driven::Angle, bodies: [body, to], reads })
    }

    /// The bodies whose links an expression names, and what they slide on where it names their slides.
    fn links_in(&self, expr: &Expr) -> Vec<usize> {
        let mut found = Vec::new();
        expr.each_name(&mut |name| {
            found.extend(self.link_of.get(&name.to_string()).map(|link| link + 1));
        });
        expr.each_part(&mut |part| {
            let ExprKind::Member(link, member) = &part.kind else { return };
            let link = self.link_of.get(&link.to_string()).filter(|_| member == "slide");
            let guide = link.and_then(|&link| self.links[link].on.first());
            let carrier = guide.map(|&guide| self.guides[guide].on);
            found.extend(carrier.filter(|&carrier| carrier != GROUND));
        });
        found
    }

    /// The bodies and pins that a declared group stands on.
    fn needs(&self, statement: &Statement) -> Footing {
        let own = |name: &Ident| match &statement.kind {
            StatementKind::Group(GroupStatement { legs, pin, .. }) => {
                legs.iter().any(|leg| leg.link == *name) || pin.as_ref() == Some(name)
            }
            _ => false,
        };
        let mut needs = Footing::default();
        for name in names_used(statement).iter().filter(|name| !own(name)) {
            let text = name.to_string();
            needs.pins.extend(self.pin_of.get(&text));
            needs.bodies.extend(self.link_of.get(&text).map(|link| link + 1));
            let guide = self.guide_of.get(&text).map(|&guide| self.guides[guide].on);
            needs.bodies.extend(guide);
        }
        needs
    }
}
