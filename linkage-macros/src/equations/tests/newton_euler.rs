//! The full matrix: Newton's and Euler's equations of every rigid part, with every joint force and
//! every drive unknown, in a hundred digits. It knows nothing of groups, of the order in which they
//! are solved, or of moments about joints; what it shares with the formulas is the motion.

mod readings;

use std::collections::HashMap;

use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::{Sym, Vector};
use crate::exact::Exact;
use crate::ir::graph::Id;
use crate::ir::interpret::Number;
use crate::model::dynamics::{Axes, Effort, Force, MassPlace, Owner};
use crate::model::mechanism::{
    AngleSum, Carrier, Expr, GuideDirection, GuideId, LinkId, Mechanism, PointId, Step, Through,
};
use crate::oracle::Digits;
use readings::{readings, slope};

/// A vector of two nodes, or of their values.
pub(super) type Pair<T> = [T; 2];

/// A rigid part: a link, the rod of a link whose length is driven, or a pin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Part {
    Ground,
    Link(LinkId),
    Rod(LinkId),
    Pin(PointId),
}

/// What acts on a part from outside: a force at a point and a couple.
pub(super) struct Applied<T> {
    part: Part,
    pub at: Pair<T>,
    pub force: Pair<T>,
    pub couple: T,
    /// For virtual power: how the point moves, and the body.
    pub velocity: Pair<T>,
    pub omega: T,
}

/// The motion, as nodes of the graph or as numbers.
pub(super) struct Motion<T> {
    points: Vec<Pair<T>>,
    origins: Vec<Pair<T>>,
    directions: Vec<Pair<T>>,
    slides: Vec<Option<T>>,
    guides: Vec<(Pair<T>, Pair<T>)>,
    pub applied: Vec<Applied<T>>,
}

fn ids(vector: Vector<'_>) -> Pair<Id> {
    [vector.x.id, vector.y.id]
}

impl Motion<Id> {
    /// The state's nodes, and all that acts on it, each mass for itself at its own centre.
    pub(super) fn of(kinematics: &Kinematics<'_>) -> Self {
        let mechanism = kinematics.mechanism;
        let points = (0..mechanism.points.len() as u32).map(PointId);
        let links: Vec<_> = (0..mechanism.links.len() as u32).map(LinkId).collect();
        let guides = (0..mechanism.guides.len() as u32).map(GuideId);
        let frame = |link: &LinkId| kinematics.link(*link).frame;
        Self {
            points: points.map(|point| ids(kinematics.point(point).position())).collect(),
            origins: links.iter().map(|link| ids(frame(link).origin.position())).collect(),
            directions: links.iter().map(|link| ids(frame(link).direction.u)).collect(),
            slides: links
                .iter()
                .map(|link| kinematics.link(*link).slide.map(|slide| slide.value.id))
                .collect(),
            guides: guides
                .map(|guide| kinematics.guide(guide))
                .map(|frame| (ids(frame.origin.position()), ids(frame.direction.u)))
                .collect(),
            applied: masses(kinematics).into_iter().chain(applied(kinematics)).collect(),
        }
    }

    pub(super) fn values(&self, values: &[Digits]) -> Motion<Digits> {
        let one = |id: &Id| values[id.index()].clone();
        let two = |pair: &Pair<Id>| [one(&pair[0]), one(&pair[1])];
        Motion {
            points: self.points.iter().map(two).collect(),
            origins: self.origins.iter().map(two).collect(),
            directions: self.directions.iter().map(two).collect(),
            slides: self.slides.iter().map(|slide| slide.as_ref().map(one)).collect(),
            guides: self.guides.iter().map(|(k, u)| (two(k), two(u))).collect(),
            applied: (self.applied.iter())
                .map(|applied| Applied {
                    part: applied.part,
                    at: two(&applied.at),
                    force: two(&applied.force),
                    couple: one(&applied.couple),
                    velocity: two(&applied.velocity),
                    omega: one(&applied.omega),
                })
                .collect(),
        }
    }
}

/// Weight and inertia of every mass: m (g − a_G) at G and −J α.
fn masses(kinematics: &Kinematics<'_>) -> Vec<Applied<Id>> {
    let (sheet, mechanism) = (kinematics.sheet, kinematics.mechanism);
    let value = |expr: &Expr| kinematics.jet(expr).value;
    let g = match &mechanism.dynamics.gravity {
        Some([x, y]) => Vector { x: value(x), y: value(y) },
        None => sheet.zero_vector(),
    };
    let of = |declared: &crate::model::dynamics::Mass| {
        let mass = value(&declared.mass.value);
        let (link, at, inertia, moves) = match &declared.place {
            MassPlace::Pin(point) => {
                let motion = kinematics.point(*point);
                return Applied {
                    part: Part::Pin(*point),
                    at: ids(motion.position()),
                    force: ids(mass * (g - motion.acceleration)),
                    couple: sheet.zero().id,
                    velocity: ids(motion.velocity),
                    omega: sheet.zero().id,
                };
            }
            MassPlace::Point(link, point) => {
                let carrier = Carrier::Link(*link);
                let at = kinematics.coordinates(carrier, *point);
                let moves = mechanism.coordinates_move(carrier, *point)[0];
                (*link, at, value(&declared.inertia.value), moves)
            }
            MassPlace::At(link, at) => {
                let moves = mechanism.moves(&at[0]);
                (*link, kinematics.jets(at), value(&declared.inertia.value), moves)
            }
            MassPlace::Uniform(link, length) => {
                let length = kinematics.jet(length);
                let zero = kinematics.jet(&Expr::zero());
                let inertia = mass * length.value * length.value / sheet.integer(12);
                (*link, [length.times(sheet.integer(1).half()), zero], inertia, false)
            }
        };
        let frame = kinematics.link(link).frame;
        let motion = frame.place(at[0], at[1]);
        Applied {
            part: part(mechanism, link, moves),
            at: ids(motion.position()),
            force: ids(mass * (g - motion.acceleration)),
            couple: (-(inertia * frame.direction.alpha)).id,
            velocity: ids(motion.velocity),
            omega: frame.direction.omega.id,
        }
    };
    mechanism.dynamics.masses.iter().map(of).collect()
}

/// What moves along the axis of a link of driven length lies on its rod. Not where the length is made
/// of what other links do: what moves by an expression of its own then goes another way than the pin.
fn part(mechanism: &Mechanism, link: LinkId, moves: bool) -> Part {
    match moves && driven_length(mechanism, link).is_some_and(|l| !has_readings(mechanism, l)) {
        true => Part::Rod(link),
        false => Part::Link(link),
    }
}

fn driven_length(mechanism: &Mechanism, link: LinkId) -> Option<&Expr> {
    let length = mechanism.steps.iter().find_map(|step| match step {
        Step::Crank { link: own, pin: Some((_, length)), .. } if *own == link => Some(length),
        Step::Rrr { links, lengths, .. } => {
            let place = links.iter().position(|own| *own == link)?;
            Some(&lengths[place])
        }
        Step::Rrp { links, length, .. } if links[0] == link => Some(length),
        _ => None,
    });
    length.map(|length| &length.value).filter(|length| mechanism.moves(length))
}

fn has_readings(mechanism: &Mechanism, length: &Expr) -> bool {
    let mut leaves = Vec::new();
    readings(mechanism, length, &mut leaves);
    !leaves.is_empty()
}

/// The part that a point of a link is fixed to.
fn part_of_point(kinematics: &Kinematics<'_>, carrier: Carrier, point: PointId) -> Part {
    match carrier {
        Carrier::Ground => Part::Ground,
        Carrier::Link(link) => {
            let moves = kinematics.mechanism.coordinates_move(carrier, point)[0];
            let is_pin = kinematics.bar(link).is_some_and(|(_, _, pin)| pin == point);
            match is_pin && moves {
                true => Part::Rod(link),
                false => part(kinematics.mechanism, link, moves),
            }
        }
    }
}

fn part_of(kinematics: &Kinematics<'_>, point: PointId) -> Part {
    match kinematics.mechanism.owner(point).expect("every point has a step") {
        Owner::Ground => Part::Ground,
        Owner::Link(link) => part_of_point(kinematics, Carrier::Link(link), point),
        Owner::Point(point) => Part::Pin(point),
    }
}

fn part_of_carrier(carrier: Carrier) -> Part {
    match carrier {
        Carrier::Ground => Part::Ground,
        Carrier::Link(link) => Part::Link(link),
    }
}

/// The declaration's forces and torques.
fn applied(kinematics: &Kinematics<'_>) -> Vec<Applied<Id>> {
    let (sheet, dynamics) = (kinematics.sheet, &kinematics.mechanism.dynamics);
    let value = |expr: &Expr| kinematics.jet(expr).value;
    let zero = sheet.zero().id;
    let force = |point: PointId, force: Vector<'_>| {
        let motion = kinematics.point(point);
        Applied {
            part: part_of(kinematics, point),
            at: ids(motion.position()),
            force: ids(force),
            couple: zero,
            velocity: ids(motion.velocity),
            omega: zero,
        }
    };
    let mut all = Vec::new();
    for declared in &dynamics.forces {
        match declared {
            Force::At { point, value: [x, y], axes } => {
                let (x, y) = (value(x), value(y));
                let u = match axes {
                    Axes::Body(carrier) => kinematics.carrier(*carrier).direction.u,
                    Axes::Guide(guide) => kinematics.guide(*guide).direction.u,
                };
                all.push(force(*point, x * u + y * u.normal()));
            }
            Force::Between { points: [p, q], value: push } => {
                let d = kinematics.point(*q).position() - kinematics.point(*p).position();
                let along = value(push) / (d.x * d.x + d.y * d.y).sqrt();
                all.push(force(*p, -(along * d)));
                all.push(force(*q, along * d));
            }
        }
    }
    for torque in &dynamics.torques {
        let couple = value(&torque.value);
        let mut turn = |carrier: Carrier, couple: Sym<'_>| {
            all.push(Applied {
                part: part_of_carrier(carrier),
                at: [zero; 2],
                force: [zero; 2],
                couple: couple.id,
                velocity: [zero; 2],
                omega: kinematics.carrier(carrier).direction.omega.id,
            });
        };
        turn(torque.on, couple);
        torque.against.into_iter().for_each(|against| turn(against, -couple));
    }
    all
}

fn whole(n: i64) -> Digits {
    Digits::exact(&Exact::integer(n))
}

fn cross(a: &Pair<Digits>, b: &Pair<Digits>) -> Digits {
    a[0].mul(&b[1]).sub(&a[1].mul(&b[0]))
}

fn negative(a: &Pair<Digits>) -> Pair<Digits> {
    [a[0].neg(), a[1].neg()]
}

fn normal(u: &Pair<Digits>) -> Pair<Digits> {
    [u[1].neg(), u[0].clone()]
}

/// One unknown: what one unit of it puts on every part's equations.
type Column = HashMap<usize, Digits>;

pub(super) struct Matrix<'k, 's> {
    kinematics: &'k Kinematics<'s>,
    motion: &'k Motion<Digits>,
    given: &'k dyn Fn(&Expr) -> Digits,
    /// Where the equations of a part begin: two of forces, and of what turns one of moments.
    rows: HashMap<Part, usize>,
    count: usize,
    columns: Vec<Column>,
    /// Which unknowns are the components of which effort.
    names: Vec<(Effort, usize)>,
}

impl<'k, 's> Matrix<'k, 's> {
    /// Every reaction and drive, from one system of linear equations.
    pub(super) fn solved(
        kinematics: &'k Kinematics<'s>,
        motion: &'k Motion<Digits>,
        given: &'k dyn Fn(&Expr) -> Digits,
    ) -> Vec<(Effort, Vec<Digits>)> {
        let mut matrix = Self {
            kinematics,
            motion,
            given,
            rows: HashMap::new(),
            count: 0,
            columns: Vec::new(),
            names: Vec::new(),
        };
        matrix.number_rows();
        for step in &kinematics.mechanism.steps {
            matrix.joints(step);
        }
        assert_eq!(matrix.columns.len(), matrix.count, "as many unknowns as equations");
        matrix.solve()
    }

    fn number_rows(&mut self) {
        let mechanism = self.kinematics.mechanism;
        for index in 0..mechanism.links.len() as u32 {
            let link = LinkId(index);
            self.add_part(Part::Link(link), 3);
            if driven_length(mechanism, link).is_some() {
                self.add_part(Part::Rod(link), 3);
            }
        }
        for index in 0..mechanism.points.len() as u32 {
            if mechanism.owner(PointId(index)) == Some(Owner::Point(PointId(index))) {
                self.add_part(Part::Pin(PointId(index)), 2);
            }
        }
    }

    fn add_part(&mut self, part: Part, equations: usize) {
        self.rows.insert(part, self.count);
        self.count += equations;
    }

    fn act(
        &self,
        column: &mut Column,
        part: Part,
        at: &Pair<Digits>,
        force: &Pair<Digits>,
        couple: &Digits,
    ) {
        let Some(&row) = self.rows.get(&part) else { return };
        let mut add = |row: usize, value: Digits| {
            let sum = column.get(&row).map_or(value.clone(), |known| known.add(&value));
            column.insert(row, sum);
        };
        add(row, force[0].clone());
        add(row + 1, force[1].clone());
        if !matches!(part, Part::Pin(_)) {
            add(row + 2, cross(at, force).add(couple));
        }
    }

    /// A pair of opposite forces at a point and opposite couples.
    fn pair(
        &self,
        [on, by]: [Part; 2],
        at: &Pair<Digits>,
        force: &Pair<Digits>,
        couple: i64,
    ) -> Column {
        let mut column = Column::new();
        self.act(&mut column, on, at, force, &whole(couple));
        self.act(&mut column, by, at, &negative(force), &whole(-couple));
        column
    }

    fn axes() -> [Pair<Digits>; 2] {
        [[whole(1), whole(0)], [whole(0), whole(1)]]
    }

    fn revolute(&mut self, link: LinkId, on: Part, by: Part, point: PointId) {
        let at = &self.motion.points[point.index()];
        self.names.push((Effort::Pin(link, point), self.columns.len()));
        for axis in Self::axes() {
            let column = self.pair([on, by], at, &axis, 0);
            self.columns.push(column);
        }
    }

    /// A normal force at a point, and a couple. What the offset does is the normal force's.
    fn prismatic(
        &mut self,
        name: Option<LinkId>,
        parts: [Part; 2],
        at: &Pair<Digits>,
        n: &Pair<Digits>,
    ) -> [usize; 2] {
        let zero = [whole(0), whole(0)];
        let first = self.columns.len();
        self.names.extend(name.map(|link| (Effort::Guide(link), first)));
        let columns = [self.pair(parts, at, n, 0), self.pair(parts, at, &zero, 1)];
        self.columns.extend(columns);
        [first, first + 1]
    }

    fn drive(&mut self, effort: Effort, column: Column) -> usize {
        self.names.push((effort, self.columns.len()));
        self.columns.push(column);
        self.columns.len() - 1
    }

    /// A bar, and its rod where its length is driven.
    fn bar(&mut self, link: LinkId, outer: PointId, pin: PointId, length: &Expr) {
        self.revolute(link, Part::Link(link), part_of(self.kinematics, outer), outer);
        let part = match self.kinematics.mechanism.moves(length) {
            true => Part::Rod(link),
            false => Part::Link(link),
        };
        self.revolute(link, part, Part::Pin(pin), pin);
        self.rod(link, pin, length);
    }

    /// The rod slides in the bar at the pin.
    fn rod(&mut self, link: LinkId, pin: PointId, length: &Expr) {
        if !self.kinematics.mechanism.moves(length) {
            return;
        }
        let (u, at) = (&self.motion.directions[link.index()], &self.motion.points[pin.index()]);
        let parts = [Part::Rod(link), Part::Link(link)];
        self.prismatic(None, parts, at, &normal(u));
        let column = self.pair(parts, at, u, 0);
        let drive = self.columns.len();
        self.columns.push(column);
        if !has_readings(self.kinematics.mechanism, length) {
            self.names.push((Effort::Push(link), drive));
        }
        self.transmit(length, &[(drive, whole(1))]);
    }

    fn carrier_of(&self, guide: GuideId) -> Part {
        let mut steps = self.kinematics.mechanism.steps.iter();
        let found = steps.find_map(|step| match step {
            Step::Guide { guide: made, carrier, through, .. } if *made == guide => {
                Some(match through {
                    Through::Point(point) => part_of_point(self.kinematics, *carrier, *point),
                    Through::At(_) => part_of_carrier(*carrier),
                })
            }
            _ => None,
        });
        found.expect("every guide has a step")
    }

    /// A link on a guide, and what turns the guide.
    fn on_guide(
        &mut self,
        link: LinkId,
        guide: GuideId,
        [on, by]: [Part; 2],
        along: Option<usize>,
    ) -> [usize; 2] {
        let (k, u) = &self.motion.guides[guide.index()];
        let at = self.motion.origins[link.index()].clone();
        let unknowns = self.prismatic(Some(link), [on, by], &at, &normal(u));
        let steps = self.kinematics.mechanism.steps.iter();
        let turn = steps.filter_map(|step| match step {
            Step::Guide { guide: made, course: GuideDirection::Along(turn), .. }
                if *made == guide =>
            {
                Some(turn)
            }
            _ => None,
        });
        let arm = [at[0].sub(&k[0]), at[1].sub(&k[1])];
        for turn in turn {
            let mut effort = vec![(unknowns[0], cross(&arm, &normal(u))), (unknowns[1], whole(1))];
            effort.extend(along.map(|along| (along, cross(&arm, u))));
            self.transmit_turn(turn, &effort);
        }
        unknowns
    }

    fn joints(&mut self, step: &'k Step) {
        match step {
            Step::Ground { .. } | Step::Guide { .. } => {}
            Step::Point { point, carrier: Carrier::Ground, place, .. } => {
                // Held by the ground: two unknowns that nobody asks for.
                let at = &self.motion.points[point.index()];
                let first = self.columns.len();
                for axis in Self::axes() {
                    let column = self.pair([Part::Pin(*point), Part::Ground], at, &axis, 0);
                    self.columns.push(column);
                }
                if let crate::model::mechanism::Placement::Cartesian(place) = place {
                    self.transmit(&place[0], &[(first, whole(1))]);
                    self.transmit(&place[1], &[(first + 1, whole(1))]);
                }
            }
            Step::Point { .. } => {}
            Step::Crank { link, pivot, pin, angle, relative_to, .. } => {
                let own = Part::Link(*link);
                self.revolute(*link, own, part_of(self.kinematics, *pivot), *pivot);
                let zero = [whole(0), whole(0)];
                let column = self.pair([own, part_of_carrier(*relative_to)], &zero, &zero, 1);
                let drive = self.drive(Effort::Drive(*link), column);
                self.transmit_turn(angle, &[(drive, whole(1))]);
                if let Some((pin, length)) = pin {
                    self.rod(*link, *pin, &length.value);
                }
            }
            Step::Slider { link, guide, slide, offset, .. } => {
                let parts = [Part::Link(*link), self.carrier_of(*guide)];
                let (at, u) =
                    (&self.motion.origins[link.index()], &self.motion.guides[guide.index()].1);
                let column = self.pair(parts, at, u, 0);
                let drive = self.drive(Effort::Drive(*link), column);
                let [normal, _] = self.on_guide(*link, *guide, parts, Some(drive));
                self.transmit(slide, &[(drive, whole(1))]);
                self.transmit(offset, &[(normal, whole(1))]);
            }
            _ => self.dyad(step),
        }
    }

    fn dyad(&mut self, step: &'k Step) {
        match step {
            Step::Rrr { links, outer, pin, lengths, .. } => {
                for k in 0..2 {
                    self.bar(links[k], outer[k], *pin, &lengths[k].value);
                }
            }
            Step::Rrp { links, outer, guide, pin, length, offset, .. } => {
                self.bar(links[0], *outer, *pin, &length.value);
                self.revolute(links[1], Part::Link(links[1]), Part::Pin(*pin), *pin);
                let parts = [Part::Link(links[1]), self.carrier_of(*guide)];
                let [normal, _] = self.on_guide(links[1], *guide, parts, None);
                self.transmit(offset, &[(normal, whole(1))]);
            }
            Step::Rpr { links, outer, offset, .. } => {
                for k in 0..2 {
                    let by = part_of(self.kinematics, outer[k]);
                    self.revolute(links[k], Part::Link(links[k]), by, outer[k]);
                }
                let (at, u) = (
                    &self.motion.points[outer[0].index()],
                    &self.motion.directions[links[1].index()],
                );
                let parts = links.map(Part::Link);
                let [normal, _] = self.prismatic(Some(links[0]), parts, at, &normal(u));
                self.transmit(offset, &[(normal, whole(1))]);
            }
            Step::Prp { links, guides, pin, offsets, .. } => {
                for k in 0..2 {
                    let own = Part::Link(links[k]);
                    self.revolute(links[k], own, Part::Pin(*pin), *pin);
                    let parts = [own, self.carrier_of(guides[k])];
                    let [normal, _] = self.on_guide(links[k], guides[k], parts, None);
                    self.transmit(&offsets[k], &[(normal, whole(1))]);
                }
            }
            Step::Rpp { links, outer, guide, slot, offsets, .. } => {
                let by = part_of(self.kinematics, *outer);
                self.revolute(links[0], Part::Link(links[0]), by, *outer);
                let at = &self.motion.points[outer.index()];
                let [u2, u1] = [0, 1].map(|k| &self.motion.directions[links[k].index()]);
                let parts = links.map(Part::Link);
                let [across, couple] = self.prismatic(Some(links[0]), parts, at, &normal(u2));
                let rail = [Part::Link(links[1]), self.carrier_of(*guide)];
                self.on_guide(links[1], *guide, rail, None);
                // The slot moves along n₁ against the yoke with e₁, along n₂ with e₂, and turns.
                let cosine = u1[0].mul(&u2[0]).add(&u1[1].mul(&u2[1]));
                self.transmit(&offsets[0], &[(across, cosine)]);
                self.transmit(&offsets[1], &[(across, whole(1))]);
                let slide = self.motion.slides[links[0].index()].clone().expect("it slides");
                self.transmit_turn(slot, &[(across, slide), (couple, whole(1))]);
            }
            _ => unreachable!("the others are no dyads"),
        }
    }

    /// An effort, a sum of unknowns with factors, of an angle.
    fn transmit_turn(&mut self, turn: &AngleSum, effort: &[(usize, Digits)]) {
        let zero = [whole(0), whole(0)];
        for &(link, times) in &turn.links {
            for (unknown, factor) in effort {
                let couple = factor.mul(&whole(-i64::from(times)));
                let mut column = std::mem::take(&mut self.columns[*unknown]);
                self.act(&mut column, Part::Link(link), &zero, &zero, &couple);
                self.columns[*unknown] = column;
            }
        }
        self.transmit(&turn.rest, effort);
    }

    /// The same of any dimension: what it reads of earlier links is pushed back.
    fn transmit(&mut self, expr: &Expr, effort: &[(usize, Digits)]) {
        let mut leaves = Vec::new();
        readings(self.kinematics.mechanism, expr, &mut leaves);
        for leaf in leaves {
            let slope = slope(self.kinematics.mechanism, expr, &leaf, self.given);
            for (unknown, factor) in effort {
                let push = slope.mul(factor).neg();
                let mut column = std::mem::take(&mut self.columns[*unknown]);
                self.push_reading(&mut column, &leaf, &push);
                self.columns[*unknown] = column;
            }
        }
    }

    fn push_reading(&self, column: &mut Column, leaf: &Expr, push: &Digits) {
        let scaled = |v: &Pair<Digits>, by: &Digits| [v[0].mul(by), v[1].mul(by)];
        let none = whole(0);
        match leaf {
            Expr::Slide(link) => {
                let u = &self.motion.directions[link.index()];
                let at = &self.motion.origins[link.index()];
                let force = scaled(u, push);
                self.act(column, Part::Link(*link), at, &force, &none);
                self.act(column, self.under(*link), at, &negative(&force), &none);
            }
            Expr::Coordinate(point, axis) => {
                let [x, y] = Self::axes();
                let axis = if *axis == crate::model::mechanism::Axis::X { x } else { y };
                let part = part_of(self.kinematics, *point);
                let at = &self.motion.points[point.index()];
                self.act(column, part, at, &scaled(&axis, push), &none);
            }
            Expr::Distance([p, q]) => {
                let [a, b] = [p, q].map(|point| &self.motion.points[point.index()]);
                let d = [b[0].sub(&a[0]), b[1].sub(&a[1])];
                let force = scaled(&d, &push.div(&d[0].hypot(&d[1])));
                let [on_p, on_q] = [p, q].map(|point| part_of(self.kinematics, *point));
                self.act(column, on_q, b, &force, &none);
                self.act(column, on_p, a, &negative(&force), &none);
            }
            Expr::Offset(point, guide) => {
                let u = &self.motion.guides[guide.index()].1;
                let at = &self.motion.points[point.index()];
                let force = scaled(&[u[1].neg(), u[0].clone()], push);
                self.act(column, part_of(self.kinematics, *point), at, &force, &none);
                self.act(column, self.carrier_of(*guide), at, &negative(&force), &none);
            }
            _ => unreachable!("only readings are leaves"),
        }
    }

    /// What a link slides on.
    fn under(&self, link: LinkId) -> Part {
        let mut steps = self.kinematics.mechanism.steps.iter();
        let found = steps.find_map(|step| match step {
            Step::Slider { link: own, guide, .. } if *own == link => Some(self.carrier_of(*guide)),
            Step::Rrp { links, guide, .. } if links[1] == link => Some(self.carrier_of(*guide)),
            Step::Rpr { links, .. } if links[0] == link => Some(Part::Link(links[1])),
            Step::Prp { links, guides, .. } => {
                let place = links.iter().position(|own| *own == link)?;
                Some(self.carrier_of(guides[place]))
            }
            Step::Rpp { links, .. } if links[0] == link => Some(Part::Link(links[1])),
            Step::Rpp { links, guide, .. } if links[1] == link => Some(self.carrier_of(*guide)),
            _ => None,
        });
        found.expect("what slides was made by a step")
    }

    /// Gauss's elimination with the largest pivot of each column.
    fn solve(&self) -> Vec<(Effort, Vec<Digits>)> {
        let n = self.count;
        let zero = whole(0);
        let mut right = Column::new();
        for applied in &self.motion.applied {
            let Applied { part, at, force, couple, .. } = applied;
            self.act(&mut right, *part, at, &negative(force), &couple.neg());
        }
        let entry = |column: &Column, row: usize| column.get(&row).cloned().unwrap_or(zero.clone());
        let mut rows: Vec<Vec<Digits>> = (0..n)
            .map(|row| {
                let columns = self.columns.iter().chain([&right]);
                columns.map(|column| entry(column, row)).collect()
            })
            .collect();
        for k in 0..n {
            let size = |row: &usize| rows[*row][k].to_f64().abs();
            let pivot = (k..n).max_by(|a, b| size(a).total_cmp(&size(b))).expect("rows are left");
            rows.swap(k, pivot);
            let (above, below) = rows.split_at_mut(k + 1);
            let top = &above[k];
            for row in below.iter_mut().filter(|row| row[k].to_f64() != 0.0) {
                let factor = row[k].div(&top[k]);
                for j in k..=n {
                    if top[j].to_f64() != 0.0 {
                        row[j] = row[j].sub(&factor.mul(&top[j]));
                    }
                }
            }
        }
        let mut solution = vec![zero.clone(); n];
        for k in (0..n).rev() {
            let known = (k + 1..n)
                .fold(rows[k][n].clone(), |sum, j| sum.sub(&rows[k][j].mul(&solution[j])));
            solution[k] = known.div(&rows[k][k]);
        }
        let count = |effort: &Effort| match effort {
            Effort::Pin(..) | Effort::Guide(_) => 2,
            _ => 1,
        };
        let found = self.names.iter();
        found.map(|(effort, at)| (*effort, solution[*at..*at + count(effort)].to_vec())).collect()
    }
}
