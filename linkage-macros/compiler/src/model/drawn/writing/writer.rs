//! The steps of a cut as drivers and groups.

use proc_macro2::Ident;

use crate::chain::cutting::{Dyad, Found, Pair};
use crate::chain::machine::{Driven, GROUND};
use crate::syntax::anatomy::GroupSpec;
use crate::syntax::tree::StatementKind;

use crate::model::drawn::group_frames::GroupFrames;
use crate::model::drawn::is_point_of;
use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::writing::free_names::FreeNames;
use crate::model::drawn::writing::modes_as_drawn::{
    corners_of_group, mode_as_drawn, mode_of, parallel,
};
use crate::model::drawn::writing::sorted::{Source, Written, ordered};
use crate::model::drawn_links::DrawnLinks;
use crate::model::figures::{self, Figure};
use crate::model::mechanism::Dimension;
use crate::model::parts_of_groups::GroupNumbers;
use crate::model::statements::made::MadeItem;
use crate::model::statements::made_groups::made_group;

/// Makes groups in solving order.
pub(in crate::model::drawn) struct Writer<'b, 't> {
    pub(in crate::model::drawn) bodies: &'b Bodies<'t>,
    /// True for the pins that are made so far.
    pub(in crate::model::drawn) made: Vec<bool>,
    /// Points declared on links, which were reached before their link and made elsewhere.
    pub(in crate::model::drawn) replaced: Vec<Ident>,
    pub(in crate::model::drawn) frames: GroupFrames<'b, 't>,
    pub(in crate::model::drawn) written: Vec<Written<'t>>,
    /// The bodies whose unknowns are solved at once, with these, while their group is written.
    pub(in crate::model::drawn) together: Vec<(usize, Ident)>,
    /// The count of groups so far that are solved by unknowns.
    keys: usize,
    pub(in crate::model::drawn) names: FreeNames,
    /// Links that groups have as bars between the first two pins of their statements.
    pub(in crate::model::drawn) bars: Vec<usize>,
    /// The links as groups make them.
    pub(in crate::model::drawn) links: DrawnLinks,
}

impl<'b, 't> Writer<'b, 't> {
    pub(in crate::model::drawn) fn new(bodies: &'b Bodies<'t>) -> Self {
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
            frames: GroupFrames::new(bodies),
            written: Vec::new(),
            together: Vec::new(),
            keys: 0,
            names: FreeNames::of(bodies.tree),
            bars: Vec::new(),
            links: DrawnLinks::default(),
        }
    }

    /// All that the drawing became, in solving order.
    pub(in crate::model::drawn) fn finish(self) -> (Vec<Written<'t>>, DrawnLinks) {
        let (bars, joints) = (self.frames.bars_between_pins(&self.bars), self.frames.joints());
        let angles = self.frames.counted_angles();
        let Self { bodies, frames, mut written, mut links, replaced, .. } = self;
        for (index, statement) in bodies.other_statements() {
            if is_point_of(&replaced, &statement.kind) {
                continue;
            }
            let mut source = Source::Statement(statement);
            match &statement.kind {
                StatementKind::Group(group) => {
                    if let (Some(mode), [leg, ..]) = (mode_as_drawn(bodies, group), &group.legs[..])
                    {
                        links.parallels.extend(corners_of_group(bodies, group));
                        links.modes.insert(leg.link.clone(), mode);
                    }
                }
                StatementKind::Guide(guide) => {
                    if let Some(told) = frames.told(guide) {
                        source = Source::MadeItem(told);
                    }
                }
                _ => {}
            }
            written.push(Written { behind: index, search: None, source });
        }
        written.sort_by_key(|written| written.behind);
        (links.bars, links.joints, links.angles) = (bars, joints, angles);
        links.frames = frames.found();
        (ordered(written, &links.slides), links)
    }

    /// Makes all items from this one on a group that is solved by unknowns.
    pub(in crate::model::drawn) fn are_one_search(&mut self, begin: usize, behind: usize) {
        for written in &mut self.written[begin..] {
            (written.search, written.behind) = (Some(self.keys), behind);
        }
        self.keys += 1;
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

    /// Puts an item behind a statement of the drawing.
    pub(in crate::model::drawn) fn put(&mut self, behind: usize, made: MadeItem) {
        self.written.push(Written { behind, search: None, source: Source::MadeItem(made) });
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
    pub(in crate::model::drawn) fn value(&self, drive: Option<usize>, body: usize) -> Figure {
        let Some(drive) = drive else { return self.unknown(body) };
        let driving = &self.bodies.machine.drives[drive];
        let dimension = match driving.kind {
            Driven::Angle => Dimension::ANGLE,
            Driven::Slide(_) => Dimension::LENGTH,
        };
        let value = Figure::written(self.bodies.drives[drive].1.value.clone(), Some(dimension));
        match driving.bodies[0] == body {
            true => value,
            false => value.negated(),
        }
    }

    /// Links that are parts of the ground, as cranks that stand still.
    pub(in crate::model::drawn) fn fixed_links(&mut self) {
        for &body in &self.bodies.fixed {
            let pivot = self.bodies.machine.bodies[body].given.as_ref().map(|given| given.pins[0]);
            let Some(pivot) = pivot else { continue };
            let angle = Some(Figure::angle_of(&self.bodies.frames[body].axis));
            let given = GroupNumbers { angle, ..GroupNumbers::default() };
            self.group("crank", (&[body], None), vec![self.leg(body, pivot)], None, given);
            self.settle_about(body, pivot, self.bodies.drawn_angle(body));
        }
    }

    fn crank(&mut self, drive: Option<usize>, body: usize, reference: usize, pivot: usize) {
        let pins = &self.bodies.link(body).pins;
        let tip = match (pins.first() == Some(&pivot), pins.get(1)) {
            (true, Some(&tip)) if !self.made[tip] => Some(tip),
            _ => None,
        };
        let given = GroupNumbers {
            lengths: tip.map(|tip| self.frames.length(body, pivot, tip)).into_iter().collect(),
            angle: Some(self.value(drive, body)),
            relative_to: self.turns_against(reference),
            ..GroupNumbers::default()
        };
        self.group("crank", (&[body], drive), vec![self.leg(body, pivot)], tip, given);
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

    /// The link that an angle is measured from; none for the ground.
    pub(in crate::model::drawn) fn turns_against(&self, reference: usize) -> Option<Ident> {
        (reference != GROUND).then(|| self.frames.name(reference).clone())
    }

    fn dyad(&mut self, dyad: &Dyad) {
        let mode = Some(mode_of(&self.bodies.machine, dyad));
        let joints = (dyad.legs[0].outer, dyad.inner, dyad.legs[1].outer);
        match joints {
            (Pair::Pin(u), Pair::Pin(v), Pair::Pin(w)) => {
                let bars = [(0, u), (1, w)].map(|(leg, pin)| self.bar(&dyad.legs[leg], [pin, v]));
                let lengths = bars.each_ref().map(|bar| bar.length.clone());
                self.links.parallels.extend(parallel(self.bodies, [u, v, w]));
                let given =
                    GroupNumbers { lengths: lengths.into(), mode, ..GroupNumbers::default() };
                let names = bars.each_ref().map(|bar| bar.name.clone());
                self.write_named(dyad, names, Some(v), given);
                bars.into_iter().for_each(|bar| self.settle_bar(bar));
            }
            (Pair::Pin(u), Pair::Pin(v), Pair::Slide(s)) => {
                let [_, block] = self.bars(dyad);
                let guide = self.frames.guide_of(s);
                let bar = self.bar(&dyad.legs[0], [u, v]);
                let (lengths, offsets) =
                    (vec![bar.length.clone()], offsets([self.frames.offset(guide, v)]));
                let given = GroupNumbers { lengths, offsets, mode, ..GroupNumbers::default() };
                let names = [bar.name.clone(), self.frames.name(block).clone()];
                self.write_named(dyad, names, Some(v), given);
                self.settle_bar(bar);
                self.block_on_rail(s, block, v);
                self.slide_is_made(s, block, None);
            }
            (Pair::Pin(u), Pair::Slide(s), Pair::Pin(w)) => {
                let [block, bar] = self.bars(dyad);
                let guide = self.frames.guide_of(s);
                let line = &self.bodies.guides[guide].line;
                let from_bar = figures::minus(self.frames.place(u), self.frames.place(w));
                let [_, offset] = figures::seen_from(&line.along, &from_bar);
                let offsets = offsets([offset]);
                self.write(dyad, None, GroupNumbers { offsets, mode, ..GroupNumbers::default() });
                let counted = self.frames.uncounted(bar, &line.along);
                self.block_is_placed(block, u, (guide, counted));
                self.block_is_placed(bar, w, (guide, counted));
                let start = self.frames.start_on_bar(s, bar);
                self.slide_is_made(s, block, start);
            }
            (Pair::Slide(s), Pair::Pin(v), Pair::Slide(t)) => {
                let [a, b] = self.bars(dyad);
                let guides = [self.frames.guide_of(s), self.frames.guide_of(t)];
                let offsets = offsets(guides.map(|guide| self.frames.offset(guide, v)));
                self.write(dyad, Some(v), GroupNumbers { offsets, ..GroupNumbers::default() });
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

    pub(in crate::model::drawn) fn write(
        &mut self,
        dyad: &Dyad,
        pin: Option<usize>,
        given: GroupNumbers,
    ) {
        let names = self.bars(dyad).map(|body| self.frames.name(body).clone());
        self.write_named(dyad, names, pin, given);
    }

    /// Writes a dyad whose legs have these names.
    fn write_named(
        &mut self,
        dyad: &Dyad,
        names: [Ident; 2],
        pin: Option<usize>,
        given: GroupNumbers,
    ) {
        let joints = dyad.legs.each_ref().map(|leg| match leg.outer {
            Pair::Pin(pin) => self.bodies.pins[pin].name.clone(),
            Pair::Slide(slide) => self.rail(slide, leg.bodies[0]),
        });
        let legs = names.into_iter().zip(joints).map(|(name, joint)| [name, joint]).collect();
        self.group(&dyad.letters(), (&self.bars(dyad), None), legs, pin, given);
    }

    /// A link at a pin.
    pub(super) fn leg(&self, body: usize, pin: usize) -> [Ident; 2] {
        [self.frames.name(body).clone(), self.bodies.pins[pin].name.clone()]
    }

    /// Puts a group behind the statements of its links and its drive.
    pub(super) fn group(
        &mut self,
        keyword: &str,
        (links, drive): (&[usize], Option<usize>),
        legs: Vec<[Ident; 2]>,
        pin: Option<usize>,
        given: GroupNumbers,
    ) {
        let behind = self.behind(links.iter().copied(), drive);
        let pin = pin.map(|pin| {
            self.made[pin] = true;
            self.bodies.pins[pin].name.clone()
        });
        self.put_group(behind, keyword, legs, pin, given);
    }

    /// Puts a group, whose links have their joints and its pin.
    pub(in crate::model::drawn) fn put_group(
        &mut self,
        behind: usize,
        keyword: &str,
        legs: Vec<[Ident; 2]>,
        pin: Option<Ident>,
        given: GroupNumbers,
    ) {
        for [link, joint] in &legs {
            [joint].into_iter().chain(&pin).for_each(|at| self.frames.join(link, at));
        }
        let Some(anatomy) = GroupSpec::of(keyword) else { return };
        self.put(behind, made_group(anatomy, legs, pin, given));
    }
}

/// Offsets, none where all are zero.
pub(in crate::model::drawn) fn offsets<const N: usize>(offsets: [Figure; N]) -> Vec<Figure> {
    match offsets.iter().all(Figure::is_zero) {
        true => Vec::new(),
        false => offsets.into(),
    }
}
