//! Titles of groups, springs, forces and inputs in errors.

use proc_macro2::Ident;
use syn::ext::IdentExt;

use crate::function::Function;

use super::acting::{Contact, Elastic, Ends, Force};
use super::mechanism::{Carrier, LinkId, Mechanism, OutputKind, PointId, Unknown};

/// `BC`, or `BC against DE`.
fn pole_title(links: &[(LinkId, Ident)]) -> String {
    let names: Vec<_> = links.iter().map(|(_, name)| name.unraw().to_string()).collect();
    names.join(" against ")
}

impl Mechanism {
    /// Titles for errors, in this order: groups, what is elastic, forces, inputs, functions, the load that drives, poles.
    /// A spring, a stop or a force between two points has no direction where they meet; an input may move no mass; a
    /// function may need a number above zero; a load may do no work on the input that it drives; a link may not turn, and
    /// has no pole.
    pub fn titles(&self) -> Vec<String> {
        let groups = self.groups.iter().map(|group| group.title.clone());
        let elastic = self.dynamics.elastic_titles().map(str::to_string);
        let forces = self.dynamics.forces.iter().map(|force| match force {
            Force::Between { points, .. } => format!("force {}", self.pair(*points)),
            Force::At { .. } => String::new(),
        });
        let inputs = self.inputs.iter().map(|input| input.name.to_string());
        let functions = Function::names().map(str::to_string);
        let acting = elastic.chain(forces);
        let driving = self.dynamics.driven().map(|(input, load)| {
            format!("drive {} by {}", self.inputs[input.index()].name, load.name)
        });
        groups
            .chain(acting)
            .chain(inputs)
            .chain(functions)
            .chain(driving)
            .chain(self.poles().map(pole_title))
            .collect()
    }

    /// The links of each pole among the outputs.
    pub(crate) fn poles(&self) -> impl Iterator<Item = &[(LinkId, Ident)]> {
        self.outputs.iter().filter_map(|output| match &output.kind {
            OutputKind::Pole(links) => Some(&links[..]),
            _ => None,
        })
    }

    /// The number of a pole's title among [`Self::titles`].
    pub(crate) fn title_of_pole(&self, links: &[(LinkId, Ident)]) -> u32 {
        let is_it =
            |other: &[(LinkId, Ident)]| other.iter().map(|it| it.0).eq(links.iter().map(|it| it.0));
        let place = self.poles().position(is_it).expect("it is an output");
        self.title_of_pull() + u32::from(self.dynamics.driven().is_some()) + place as u32
    }

    /// The number of a function's title among [`Self::titles`].
    pub(crate) fn title_of_function(&self, function: Function) -> u32 {
        self.title_of_input(self.inputs.len()) + function as u32
    }

    /// The number of the title of the load that drives among [`Self::titles`].
    pub(crate) fn title_of_pull(&self) -> u32 {
        self.title_of_input(self.inputs.len()) + Function::names().count() as u32
    }

    /// The title of what fails where an unknown is not found: its name, or the links of a drawing for which it was put.
    pub fn title_of_unknown(&self, unknown: &Unknown) -> &str {
        let title = &self.groups[unknown.group.index()].title;
        title.strip_prefix("r#").unwrap_or(title)
    }

    /// The number of an input's title among [`Self::titles`].
    pub(crate) fn title_of_input(&self, input: usize) -> u32 {
        let forces = self.dynamics.forces.len() as u32;
        self.title_of_force(0) + forces + input as u32
    }

    /// The ends of a spring: `B, C`.
    pub(super) fn both(&self, ends: Ends) -> String {
        match ends {
            Ends::Points(points) => self.pair(points),
            Ends::Bodies(bodies) => bodies.map(|body| self.body_name(body)).join(", "),
        }
    }

    fn pair(&self, points: [PointId; 2]) -> String {
        let [p, q] = points.map(|point| &self.points[point.index()].name);
        format!("{p}, {q}")
    }

    /// The joint at which two bodies rub: `BC.C`, `ram`.
    pub(crate) fn contact_name(&self, contact: Contact) -> String {
        let link = match contact {
            Contact::Guide(by) => self.sliding(by),
            Contact::Pin { link, .. } => link,
        };
        let link = &self.links[link.index()].name;
        match contact {
            Contact::Pin { pin, .. } => format!("{link}.{}", self.points[pin.index()].name),
            Contact::Guide(_) => link.to_string(),
        }
    }

    /// `ground` or the link.
    pub fn body_name(&self, body: Carrier) -> String {
        match body {
            Carrier::Ground => "ground".to_string(),
            Carrier::Link(link) => self.links[link.index()].name.to_string(),
        }
    }

    /// The number of the title of a spring or a stop among [`Self::titles`].
    pub(crate) fn title_of(&self, elastic: Elastic) -> u32 {
        (self.groups.len() + self.dynamics.elastic_place(elastic)) as u32
    }

    /// The number of a force's title among [`Self::titles`].
    pub(crate) fn title_of_force(&self, force: usize) -> u32 {
        (self.groups.len() + self.dynamics.elastic_titles().count() + force) as u32
    }
}
