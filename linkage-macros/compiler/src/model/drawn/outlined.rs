//! The outline of a drawing, for whatever moves its bodies by other means than groups.

use crate::chain::machine::GROUND;
use crate::chain::plane::Complex;
use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn_bodies::{Outline, OutlinedBody, OutlinedGuide};
use crate::model::figures::Figure;
use crate::syntax::tree::{ExprKind, StatementKind};

impl Bodies<'_> {
    pub(super) fn outline(&self) -> Outline {
        let is_ground = |name: &proc_macro2::Ident| {
            self.tree.statements.iter().any(|statement| match &statement.kind {
                StatementKind::Ground(ground) => ground.points.iter().any(|(own, _)| own == name),
                _ => false,
            })
        };
        let grounded = self.pins.iter().filter(|pin| is_ground(&pin.name));
        let ground = grounded.map(|pin| (pin.name.clone(), self.drawn_place(GROUND, &pin.at)));
        let written: Vec<usize> =
            (1..=self.links.len()).filter(|&body| self.is_drawn(body)).collect();
        let place_of = |body: usize| written.iter().position(|&other| other == body);
        let guides = self.guides.iter().map(|guide| {
            let body = guide.on;
            let [x, y] = &guide.line.along;
            let turn = self.displacements.get(body).map_or(0.0, |moved| moved.turn);
            OutlinedGuide {
                name: guide.name.clone(),
                on: place_of(body),
                through: self.drawn_place(body, &guide.line.through),
                along: Complex::new(x.value, y.value).angle() + turn,
            }
        });
        Outline {
            ground: ground.collect(),
            guides: guides.collect(),
            bodies: written.iter().map(|&body| self.outlined(body)).collect(),
        }
    }

    fn outlined(&self, body: usize) -> OutlinedBody {
        let link = self.link(body);
        let pins = link.pins.iter().chain(&link.points).map(|&pin| {
            let pin = &self.pins[pin];
            (pin.name.clone(), self.drawn_place(body, &pin.at))
        });
        let origin = self.drawn_origin(body);
        let length = link.length.as_ref().and_then(|(length, _)| match &length.kind {
            ExprKind::Name(name) => Some(name.clone()),
            _ => None,
        });
        OutlinedBody {
            name: link.name.clone(),
            pins: pins.collect(),
            on: link.on.clone(),
            origin: [origin.x, origin.y],
            angle: self.drawn_angle(body),
            length,
        }
    }

    /// A place on a body in the pose with the declared lengths.
    fn drawn_place(&self, body: usize, [x, y]: &[Figure; 2]) -> [f64; 2] {
        let drawn = Complex::new(x.value, y.value);
        let place = self.displacements.get(body).map_or(drawn, |moved| moved.of(drawn));
        [place.x, place.y]
    }
}
