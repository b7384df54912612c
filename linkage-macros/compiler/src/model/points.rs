//! Points of the ground, points of a link, driven points.

use proc_macro2::Ident;
use syn::Attribute;

use crate::exact::Exact;
use crate::reach::{absolute, apex};
use crate::syntax::tree::{self, Expr as Written};

use super::Resolver;
use super::assembly::{constants, polar};
use super::expressions::bare_name;
use super::folding::shown;
use super::mechanism::{Carrier, GroupName, Length, LinkId, PartOf, Placement, Scalar, Sign, Step};

impl Resolver<'_> {
    pub(super) fn ground(&mut self, docs: &[Attribute], points: &[(Ident, [Written; 2])]) {
        for (name, place) in points {
            let point = self.add_point(docs, name, PartOf::Ground);
            let at = [0, 1].map(|i| {
                self.depends_on_no_input(&place[i], name)?;
                self.length(&place[i])
            });
            let at = match at {
                [Some(x), Some(y)] => Some([x, y]),
                _ => None,
            };
            let Some(point) = point else {
                continue;
            };
            self.facts.fix(point, Carrier::Ground, at.as_ref().and_then(constants));
            self.mechanism.steps.extend(at.map(|at| Step::Ground { point, at }));
        }
    }

    pub(super) fn placed_point(
        &mut self,
        docs: &[Attribute],
        name: &Ident,
        on: Option<&Ident>,
        place: &tree::PointPlace,
        moves: bool,
    ) {
        let carrier = self.carrier(on);
        let damaged = matches!(place, tree::PointPlace::Mistake);
        let place = self.place(name, carrier, place);
        // Where its link is not known, neither is the point.
        let Some(carrier) = carrier.filter(|_| !damaged) else {
            self.name_is_new(name);
            return;
        };
        let (part_of, group) = match carrier {
            Carrier::Ground => (PartOf::Driven(self.next_group()), self.next_group()),
            Carrier::Link(link) => (PartOf::Link(link), self.mechanism.links[link.index()].made_by),
        };
        let Some(point) = self.add_point(docs, name, part_of) else {
            return;
        };
        if carrier == Carrier::Ground {
            self.mechanism.groups.push(GroupName {
                keyword: Ident::new("point", name.span()),
                title: name.to_string(),
            });
        }
        self.facts.points[point.index()] = moves;
        if on.is_none() && !moves && matches!(place, Some(Placement::Cartesian(_))) {
            self.fixed_point_is_ground(name);
        }
        if carrier != Carrier::Ground || !moves {
            let at = place.as_ref().and_then(constant_place);
            self.facts.fix(point, carrier, at);
        }
        if let Some(place) = place {
            self.mechanism.steps.push(Step::Point { point, carrier, place, group });
        }
    }

    fn place(
        &mut self,
        name: &Ident,
        carrier: Option<Carrier>,
        place: &tree::PointPlace,
    ) -> Option<Placement> {
        match place {
            tree::PointPlace::Mistake => None,
            tree::PointPlace::Cartesian(place) => {
                self.place_is_not_polar(place)?;
                self.lengths(place).map(Placement::Cartesian)
            }
            tree::PointPlace::Polar([radius, angle]) => {
                let (radius, angle) = (self.length(radius), self.plain_angle(angle));
                Some(Placement::Polar(radius?, angle?))
            }
            tree::PointPlace::Distances(distances, side) => {
                let which = ["first", "second"];
                let values = [0, 1].map(|i| {
                    let value = self.length(&distances[i])?;
                    let what = format!("the {} distance of `{name}`", which[i]);
                    self.length_is_positive(&distances[i], &value, &what)?;
                    let name = match bare_name(&distances[i]) {
                        Some(name) => name.to_string(),
                        None => format!("{} distance of {name}", which[i]),
                    };
                    Some(Length { value, name })
                });
                let side = self.side_is_left_or_right(side, name);
                let length = self.distances_have_a_bar(name, carrier?)?;
                let [first, second] = values;
                let distances = [first?, second?];
                self.distances_meet(name, carrier?, &distances, &length)?;
                Some(Placement::Distances { distances, length, side: side? })
            }
        }
    }

    /// Reports a point in ground axes that no input moves: its link was forgotten.
    fn fixed_point_is_ground(&mut self, name: &Ident) {
        let message = match self.mechanism.links.last() {
            Some(link) => format!(
                "`{name}` does not move; name its link, as in `point {name} on {} at …`",
                link.name
            ),
            None => format!("`{name}` does not move; write `ground {name}(x, y);`"),
        };
        let reason = format!("a fixed point is declared by `ground {name}(x, y);`");
        self.report(name.span(), message, (!self.mechanism.links.is_empty()).then_some(reason));
    }

    /// A distance and an angle are no coordinates `(x, y)`.
    fn place_is_not_polar(&mut self, [_, second]: &[Written; 2]) -> Option<()> {
        let is_angle = matches!(&second.kind, tree::ExprKind::Number { units, .. }
            if matches!(&units[..], [(unit, 1)] if ["deg", "rad", "turn"].contains(&unit.as_str())));
        if is_angle {
            let message = "an angle where a length belongs";
            let reason = "a distance and an angle are written `at polar (r, 20deg)`";
            self.diagnostics.error_because(second.span, message, reason);
        }
        (!is_angle).then_some(())
    }

    /// Distances are measured from the two joints of a bar. Gives the bar's length.
    fn distances_have_a_bar(&mut self, name: &Ident, carrier: Carrier) -> Option<Scalar> {
        let Carrier::Link(link) = carrier else {
            let message = "distances need a bar; write `point … on BC at distances …`";
            let reason = "they are measured from the bar's outer joint and from its pin";
            self.diagnostics.error_because(name.span(), message, reason);
            return None;
        };
        let facts = &self.facts.links[link.index()];
        if facts.is_bar {
            return facts.length.clone();
        }
        let link = &self.mechanism.links[link.index()].name;
        let message = format!("`{link}` is no bar with two joints; give coordinates instead");
        let reason = format!("write `point {name} on {link} at (x, y);`");
        self.diagnostics.error_because(name.span(), message, reason);
        None
    }

    /// Constant distances from the joints of a bar of constant length meet.
    fn distances_meet(
        &mut self,
        name: &Ident,
        carrier: Carrier,
        distances: &[Length; 2],
        length: &Scalar,
    ) -> Option<()> {
        let [first, second] = distances.each_ref().map(|distance| distance.value.constant());
        let (Some(a), Some(b), Some(l)) = (first, second, length.constant()) else {
            return Some(());
        };
        let difference = absolute(&a.sub(b));
        let (sum, link) = (a.add(b), self.link_name(carrier));
        let (long, a, b) = (shown(l), shown(a), shown(b));
        let reason = if l.cmp_value(&sum).is_gt() {
            format!("`{link}` is {long} m, distances {a} m + {b} m reach {} m", shown(&sum))
        } else if l.cmp_value(&difference).is_lt() {
            let difference = shown(&difference);
            format!("`{link}` is {long} m, distances {a} m and {b} m stay {difference} m apart")
        } else {
            return Some(());
        };
        let message = format!("no point has the distances of `{name}`; change them");
        self.diagnostics.error_because(name.span(), message, reason);
        None
    }

    fn link_name(&self, carrier: Carrier) -> String {
        match carrier {
            Carrier::Ground => "ground".to_string(),
            Carrier::Link(LinkId(id)) => self.mechanism.links[id as usize].name.to_string(),
        }
    }
}

/// The coordinates of a place of constants.
fn constant_place(place: &Placement) -> Option<[Exact; 2]> {
    match place {
        Placement::Cartesian(place) => constants(place),
        Placement::Polar(radius, angle) => polar(radius, angle),
        Placement::Distances { distances, length, side } => {
            let [first, second] = distances;
            let distances = [first.value.constant()?, second.value.constant()?];
            let [x, y] = apex::apex(distances, length.constant()?)?;
            Some([x, if *side == Sign::Plus { y } else { y.neg() }])
        }
    }
}
