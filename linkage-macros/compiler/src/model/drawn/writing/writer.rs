//! The steps of a cut as statements of drivers and groups.

use proc_macro2::Ident;

use crate::chain::cutting::{Dyad, Found, Pair};
use crate::chain::limits::sine;
use crate::chain::machine::GROUND;
use crate::syntax::tree::{Expr, GroupFieldValue, Statement, StatementKind};

use crate::model::as_drawn::SearchFollowed;
use crate::model::drawn::group_frames::GroupFrames;
use crate::model::drawn::is_point_of;
use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::figures::{Figure, Pen};
use crate::model::drawn::writing::bars::DrawnBar;
use crate::model::drawn::writing::free_names::FreeNames;
use crate::model::drawn::writing::group_statement::{group_of, named};
use crate::model::drawn::writing::modes_as_drawn::{corners_of_group, mode_as_drawn, parallel};
use crate::model::drawn::writing::sorted::{Written, ordered};
use crate::model::drawn_links::DrawnLinks;

/// The statements that a drawing became.
pub(in crate::model::drawn) struct Translated {
    pub statements: Vec<Statement>,
    pub links: DrawnLinks,
    pub searches: Vec<SearchFollowed>,
    /// True if drives hold links together.
    pub holds_links: bool,
    /// Points declared on links that other statements make, though their place is not known before the link's.
    pub misplaced: Vec<Ident>,
}

/// Writes statements in solving order.
pub(in crate::model::drawn) struct Writer<'b, 't> {
    pub(in crate::model::drawn) bodies: &'b Bodies<'t>,
    /// True for the pins that statements have made so far.
    pub(in crate::model::drawn) made: Vec<bool>,
    /// Points declared on links, which were reached before their link: another statement makes them.
    pub(in crate::model::drawn) replaced: Vec<Ident>,
    /// Those of them whose place is not known before the link's.
    pub(in crate::model::drawn) misplaced: Vec<Ident>,
    pub(in crate::model::drawn) frames: GroupFrames<'b, 't>,
    pub(in crate::model::drawn) written: Vec<Written>,
    /// The bodies whose unknowns are solved at once, with these, while their group is written.
    pub(in crate::model::drawn) together: Vec<(usize, Ident)>,
    /// The count of groups so far that are solved by unknowns.
    keys: usize,
    /// The searches so far.
    pub(in crate::model::drawn) searches: Vec<SearchFollowed>,
    pub(in crate::model::drawn) names: FreeNames,
    /// Links that groups have as bars between the first two pins of their statements.
    pub(in crate::model::drawn) bars: Vec<usize>,
    /// The links as groups make them.
    pub(in crate::model::drawn) links: DrawnLinks,
    /// True if drives hold links together.
    pub(in crate::model::drawn) holds_links: bool,
}

impl<'b, 't> Writer<'b, 't> {
    pub(in crate::model::drawn) fn new(bodies: &'b Bodies<'t>, pen: &Pen) -> Self {
        let mut made = vec![false; bodies.pins.len()];
        let machine = &bodies.machine;
        let makes = |&body: &usize| machine.is_given(body) && !bodies.fixed.contains(&body);
        for body in (0..machine.bodies.len()).filter(makes) {
            machine.bodies[body].made().for_each(|pin| made[pin] = true);
        }
        Self {
            bodies,
            made,
            replaced: Vec::new(),
            misplaced: Vec::new(),
            frames: GroupFrames::new(bodies, pen),
            written: Vec::new(),
            together: Vec::new(),
            keys: 0,
            searches: Vec::new(),
            names: FreeNames::of(bodies.tree),
            bars: Vec::new(),
            links: DrawnLinks::default(),
            holds_links: false,
        }
    }

    /// All statements of the declaration, in solving order.
    pub(in crate::model::drawn) fn declaration(self) -> Translated {
        let (bars, joints) = (self.frames.bars_between_pins(&self.bars), self.frames.joints());
        let angles = self.frames.counted_angles();
        let Self {
            bodies,
            frames,
            mut written,
            searches,
            mut links,
            names,
            holds_links,
            replaced,
            misplaced,
            ..
        } = self;
        for (index, statement) in bodies.other_statements() {
            if is_point_of(&replaced, &statement.kind) {
                continue;
            }
            let mut statement = statement.clone();
            match &mut statement.kind {
                StatementKind::Group(group) => {
                    if let Some(mode) = mode_as_drawn(bodies, group) {
                        links.parallels.extend(corners_of_group(bodies, group));
                        group.fields.push(mode);
                    }
                }
                StatementKind::Guide(guide) => frames.turns.tell_places_in(guide),
                _ => {}
            }
            written.push(Written { behind: index, search: None, statement });
        }
        written.sort_by_key(|written| written.behind);
        let drawn = bodies.links.iter().filter(|link| !link.is_given);
        let hidden = links.hidden.iter().map(|(name, _)| name);
        links.made = drawn.map(|link| link.name).chain(hidden).cloned().collect();
        (links.bars, links.joints, links.angles) = (bars, joints, angles);
        (links.names, links.frames) = (names.made, frames.turns.found());
        let statements = ordered(written, &links.slides);
        Translated { statements, links, searches, holds_links, misplaced }
    }

    /// The number of the next group that is solved by unknowns.
    pub(in crate::model::drawn) fn next_key(&mut self) -> usize {
        self.keys += 1;
        self.keys - 1
    }

    /// Remembers the joint of a group that is a slide of the drawing: see [`GroupFrames::slide_found`].
    pub(in crate::model::drawn) fn slide_is_made(
        &mut self,
        slide: usize,
        by: usize,
        from: Option<[Figure; 2]>,
    ) {
        let found = self.frames.slide_found(slide, by, from);
        self.links.slides.push(found);
    }

    /// Remembers where a pin of a link is that its group makes elsewhere.
    pub(in crate::model::drawn) fn pin_is_elsewhere(&mut self, body: usize, pin: usize) {
        self.links.pins.extend(self.frames.pin_elsewhere(body, pin));
    }

    /// Remembers a driver that has a drive the other way round than the drawing.
    pub(in crate::model::drawn) fn is_driven_by(&mut self, drive: Option<usize>, by: usize) {
        let Some(drive) = drive else { return };
        let drives = &self.bodies.machine.drives;
        let [driven, _] = drives[drive].bodies;
        // A link that two drives name has an effort of its own by the first.
        let named = drives.iter().filter(|drive| drive.bodies[0] == driven).count();
        if driven != by && driven != GROUND && named == 1 {
            self.links.drives.push([driven, by].map(|body| self.frames.name(body).clone()));
        }
    }

    /// Puts a statement behind one of the drawing.
    pub(in crate::model::drawn) fn put(&mut self, behind: usize, kind: StatementKind) {
        self.written.push(Written {
            behind,
            search: None,
            statement: Statement { docs: Vec::new(), kind },
        });
    }

    /// The last statement of links and a drive.
    pub(super) fn behind(
        &self,
        links: impl IntoIterator<Item = usize>,
        drive: Option<usize>,
    ) -> usize {
        let links = links.into_iter().map(|body| self.bodies.link(body).statement);
        links.chain(drive.map(|drive| self.bodies.drives[drive].0)).max().unwrap_or(0)
    }

    pub(in crate::model::drawn) fn step(&mut self, step: &Found) {
        match step {
            Found::Crank { drive, body, reference, pivot } => {
                self.crank(*drive, *body, *reference, *pivot);
            }
            Found::Slider { drive, body, slide } => self.slider(*drive, *body, *slide),
            Found::Dyad(dyad) if !dyad.carried.is_empty() => self.carried_dyad(dyad),
            Found::Dyad(dyad) => self.dyad(dyad),
            Found::Search(search) => self.search(search),
            Found::Tracked(tracked) => self.together(tracked),
        }
    }

    /// The value of a drive, negative where the body is the one that it is driven against; without a
    /// drive the unknown.
    pub(in crate::model::drawn) fn value(&self, drive: Option<usize>, body: usize) -> Expr {
        let Some(drive) = drive else { return self.unknown(body) };
        let value = self.bodies.drives[drive].1.value.clone();
        match self.bodies.machine.drives[drive].bodies[0] == body {
            true => value,
            false => value.negated(),
        }
    }

    /// Links that are parts of the ground, as cranks that stand still.
    pub(in crate::model::drawn) fn fixed_links(&mut self) {
        for &body in &self.bodies.fixed {
            let axis = &self.bodies.frames[body].axis;
            let pivot = self.bodies.machine.bodies[body].given.as_ref().map(|given| given.pins[0]);
            let Some(pivot) = pivot else { continue };
            let angle = self.frames.pen.at(self.frames.name(body).span()).angle(axis).text;
            let fields = vec![("angle", GroupFieldValue::One(angle))];
            let legs =
                [(body, self.frames.name(body).clone(), self.bodies.pins[pivot].name.clone())];
            self.group("crank", &legs, None, fields, None);
            self.settle_about(body, pivot, self.bodies.drawn_angle(body));
        }
    }

    fn crank(&mut self, drive: Option<usize>, body: usize, reference: usize, pivot: usize) {
        let angle = self.value(drive, body);
        let mut fields = Vec::new();
        let pins = &self.bodies.link(body).pins;
        let tip = match (pins.first() == Some(&pivot), pins.get(1)) {
            (true, Some(&tip)) if !self.made[tip] => Some(tip),
            _ => None,
        };
        if let Some(tip) = tip {
            fields.push(("length", GroupFieldValue::One(self.frames.length(body, pivot, tip))));
        }
        fields.push(("angle", GroupFieldValue::One(angle)));
        if reference != GROUND {
            let name = named(self.frames.name(reference));
            fields.push(("relative_to", GroupFieldValue::One(name)));
        }
        let legs = [(body, self.frames.name(body).clone(), self.bodies.pins[pivot].name.clone())];
        self.group("crank", &legs, tip, fields, drive);
        let counted = match drive {
            Some(drive) => self.frames.counted_by_drives(&[[drive, body]], reference),
            None => self.bodies.drawn_angle(body),
        };
        match tip {
            Some(_) => self.settle(body, self.bodies.frames[body].clone(), counted),
            None => self.settle_about(body, pivot, counted),
        }
        self.bars.extend(tip.map(|_| body));
        match drive {
            Some(_) => self.is_driven_by(drive, body),
            None => self.links.searched.push(self.frames.name(body).clone()),
        }
    }

    fn dyad(&mut self, dyad: &Dyad) {
        let sign = sine(&self.bodies.machine, dyad);
        let joints = (dyad.legs[0].outer, dyad.inner, dyad.legs[1].outer);
        match joints {
            (Pair::Pin(u), Pair::Pin(v), Pair::Pin(w)) => {
                let bars = [(0, u), (1, w)].map(|(leg, pin)| self.bar(&dyad.legs[leg], [pin, v]));
                let lengths = bars.each_ref().map(DrawnBar::length);
                self.links.parallels.extend(parallel(self.bodies, [u, v, w]));
                let mode = self.mode(dyad.legs[0].bodies[0], side(sign));
                let fields = vec![("lengths", GroupFieldValue::Pair(lengths)), mode];
                let names = bars.each_ref().map(|bar| self.bar_name(bar));
                self.write_named(dyad, names, Some(v), fields);
                bars.into_iter().for_each(|bar| self.settle_bar(bar));
            }
            (Pair::Pin(u), Pair::Pin(v), Pair::Slide(s)) => {
                let [body, block] = self.bars(dyad);
                let guide = self.frames.guide_of(s);
                let bar = self.bar(&dyad.legs[0], [u, v]);
                let mut fields = vec![("length", GroupFieldValue::One(bar.length()))];
                let offset = self.frames.offset(guide, v);
                fields.extend(given(offset));
                fields.push(self.mode(body, sense(sign)));
                let names = [self.bar_name(&bar), self.frames.name(block).clone()];
                self.write_named(dyad, names, Some(v), fields);
                self.settle_bar(bar);
                self.block_on_rail(s, block, v);
                self.slide_is_made(s, block, None);
            }
            (Pair::Pin(u), Pair::Slide(s), Pair::Pin(w)) => {
                let [block, bar] = self.bars(dyad);
                let guide = self.frames.guide_of(s);
                let line = &self.bodies.guides[guide].line;
                let from_bar = self.frames.pen.minus(self.frames.place(u), self.frames.place(w));
                let [_, offset] = self.frames.pen.seen_from(&line.along, &from_bar);
                let mut fields = Vec::new();
                fields.extend(given(offset));
                fields.push(self.mode(block, sense(sign)));
                self.write(dyad, None, fields);
                let counted = self.frames.uncounted(bar, &line.along);
                self.block_is_placed(block, u, (guide, counted));
                self.block_is_placed(bar, w, (guide, counted));
                let start = self.frames.start_on_bar(s, bar);
                self.slide_is_made(s, block, start);
            }
            (Pair::Slide(s), Pair::Pin(v), Pair::Slide(t)) => {
                let [a, b] = self.bars(dyad);
                let guides = [self.frames.guide_of(s), self.frames.guide_of(t)];
                let offsets = guides.map(|guide| self.frames.offset(guide, v));
                let fields = self.offsets(offsets);
                self.write(dyad, Some(v), fields);
                self.block_on_rail(s, a, v);
                self.block_on_rail(t, b, v);
                self.slide_is_made(s, a, None);
                self.slide_is_made(t, b, None);
            }
            (Pair::Pin(u), Pair::Slide(s), Pair::Slide(t)) => self.yoke(dyad, u, s, t),
            _ => {}
        }
    }

    /// The body of each leg at its joints.
    pub(in crate::model::drawn) fn bars(&self, dyad: &Dyad) -> [usize; 2] {
        dyad.legs.each_ref().map(|leg| leg.bodies[0])
    }

    pub(in crate::model::drawn) fn mode(
        &self,
        body: usize,
        word: &str,
    ) -> (&'static str, GroupFieldValue) {
        let name = Ident::new(word, self.frames.name(body).span());
        ("mode", GroupFieldValue::One(named(&name)))
    }

    pub(in crate::model::drawn) fn write(
        &mut self,
        dyad: &Dyad,
        pin: Option<usize>,
        fields: Vec<(&str, GroupFieldValue)>,
    ) {
        let names = self.bars(dyad).map(|body| self.frames.name(body).clone());
        self.write_named(dyad, names, pin, fields);
    }

    /// Writes a dyad whose legs have these names.
    fn write_named(
        &mut self,
        dyad: &Dyad,
        names: [Ident; 2],
        pin: Option<usize>,
        fields: Vec<(&str, GroupFieldValue)>,
    ) {
        let mut names = names.into_iter();
        let legs = dyad.legs.each_ref().map(|leg| {
            let joint = match leg.outer {
                Pair::Pin(pin) => self.bodies.pins[pin].name.clone(),
                Pair::Slide(slide) => self.rail(slide, leg.bodies[0]),
            };
            let name = names.next().unwrap_or_else(|| self.frames.name(leg.bodies[0]).clone());
            (leg.bodies[0], name, joint)
        });
        self.group(&dyad.letters(), &legs, pin, fields, None);
    }

    pub(in crate::model::drawn) fn group(
        &mut self,
        keyword: &str,
        legs: &[(usize, Ident, Ident)],
        pin: Option<usize>,
        fields: Vec<(&str, GroupFieldValue)>,
        drive: Option<usize>,
    ) {
        let links = legs.iter().map(|(body, ..)| *body);
        let behind = self.behind(links, drive);
        let legs: Vec<_> =
            legs.iter().map(|(_, name, joint)| (name.clone(), joint.clone())).collect();
        let pin = pin.map(|pin| {
            self.made[pin] = true;
            self.bodies.pins[pin].name.clone()
        });
        for (link, joint) in &legs {
            [Some(joint), pin.as_ref()]
                .into_iter()
                .flatten()
                .for_each(|at| self.frames.turns.join(link, at));
        }
        let group = group_of(keyword, legs, pin, fields);
        self.put(behind, StatementKind::Group(group));
    }
}

/// The field `offset`, none where it is zero.
pub(in crate::model::drawn) fn given(offset: Figure) -> Option<(&'static str, GroupFieldValue)> {
    (!offset.is_zero()).then_some(("offset", GroupFieldValue::One(offset.text)))
}

/// The mode of a group between bars.
pub(in crate::model::drawn) fn side(sign: f64) -> &'static str {
    if sign > 0.0 { "left" } else { "right" }
}

fn sense(sign: f64) -> &'static str {
    if sign > 0.0 { "ahead" } else { "behind" }
}
