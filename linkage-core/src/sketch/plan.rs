//! The interface between generated code and drawings of a mechanism: names, dependencies, and the
//! position of every part.

use std::string::String;
use std::vec::Vec;

use super::member::Member;
use crate::checks::{Checks, FirstError};
use crate::diagnosis::finite_result;
use crate::roots::FindError;
use crate::slow_path::conditions_met;
use crate::solver::Solver;
use crate::{Scalar, SolveError, Tracker};

/// A solver that can be drawn; implemented by generated code.
pub trait Drawn: Copy {
    /// Its input: a number, or a record of several.
    type Input: Copy;

    /// The plan of the declaration.
    const PLAN: Plan;

    /// Where everything stands, in the order of `Layout`.
    ///
    /// # Errors
    /// The first group that cannot be assembled.
    fn place(&self, q: Self::Input) -> Result<Vec<f64>, SolveError>;

    /// The same without errors: dependents of a failed group are NaN, and so are those of the unknown
    /// of this name.
    fn place_open(&self, q: Self::Input, without: &'static str) -> Vec<f64>;

    /// The solver of each pose of a path, its modes following the motion, and what refuses the pose.
    fn followed(self, path: &[Self::Input]) -> Vec<(Self, Option<SolveError>)>;
}

/// The declaration, every name a place in the lists of names.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// The mechanism's name.
    pub name: &'static str,
    /// Its doc comment, in one line.
    pub docs: &'static str,
    /// The points' names.
    pub points: &'static [&'static str],
    /// The links' names.
    pub links: &'static [&'static str],
    /// The guides' names.
    pub guides: &'static [&'static str],
    /// The statements that place them, in solving order.
    pub statements: &'static [Element],
    /// Springs and dampers between two points.
    pub springs: &'static [Spring],
}

/// The plan as a constant in memory.
pub(super) struct PlanOf<S>(core::marker::PhantomData<S>);

impl<S: Drawn> PlanOf<S> {
    pub(super) const PLAN: Plan = S::PLAN;
}

/// A spring, a damper, or both, between two points.
#[derive(Clone, Copy, Debug)]
pub struct Spring {
    /// Its ends.
    pub ends: [usize; 2],
    /// Two flags: it has a stiffness, and it has a damping.
    pub kinds: [bool; 2],
}

/// A statement.
#[derive(Clone, Copy, Debug)]
pub enum Element {
    /// A fixed point.
    Ground(usize),
    /// A guide, and the link that carries it.
    Guide(usize, Option<usize>),
    /// A point, and the link that carries it; none for a driven point.
    Point(usize, Option<usize>),
    /// The links of a driver or a dyad, and its pin.
    Group(&'static [Member], Option<usize>),
}

impl Element {
    /// The links that it makes, each with the place of its first length or offset.
    pub(super) fn members(self) -> impl Iterator<Item = (usize, Member)> {
        let members = match self {
            Self::Group(members, _) => members,
            Self::Ground(_) | Self::Guide(..) | Self::Point(..) => &[],
        };
        members.iter().scan(0, |before, &member| {
            let first = *before;
            *before += member.shape.dimensions();
            Some((first, member))
        })
    }

    /// The number of its lengths and offsets.
    pub(super) fn dimensions(self) -> usize {
        self.members().map(|(_, member)| member.shape.dimensions()).sum()
    }

    /// The links that it makes.
    pub(super) fn links(self) -> Vec<usize> {
        self.members().map(|(_, member)| member.link).collect()
    }

    /// The point that it makes.
    pub(super) fn point(self) -> Option<usize> {
        match self {
            Self::Ground(point) | Self::Point(point, _) => Some(point),
            Self::Group(_, pin) => pin,
            Self::Guide(..) => None,
        }
    }

    /// The points that its links turn about.
    pub(super) fn outer(self) -> Vec<usize> {
        self.members().filter_map(|(_, member)| member.pivot()).collect()
    }

    /// The crank that an input turns against the ground.
    pub(super) fn turned(self) -> Option<Member> {
        self.members().map(|(_, member)| member).find(|member| member.is_turned)
    }

    /// The guides that its links slide on, and which link does.
    pub(super) fn slides(self) -> Vec<(usize, usize)> {
        self.members().filter_map(|(_, member)| Some((member.link, member.guide()?))).collect()
    }

    /// The link that carries what it makes.
    pub(super) fn carrier(self) -> Option<usize> {
        match self {
            Self::Guide(_, carrier) | Self::Point(_, carrier) => carrier,
            _ => None,
        }
    }

    /// The joints of its links: link and point.
    pub(super) fn joints(self) -> Vec<(usize, usize)> {
        match self {
            Self::Ground(_) | Self::Guide(..) => Vec::new(),
            Self::Point(point, carrier) => carrier.into_iter().map(|link| (link, point)).collect(),
            Self::Group(members, pin) => {
                let points = |member: &Member| [member.pivot(), pin].map(|at| (member.link, at));
                let joints = members.iter().flat_map(points);
                joints.filter_map(|(link, point)| Some((link, point?))).collect()
            }
        }
    }
}

impl Plan {
    /// The name that errors give to the group of a statement.
    pub(super) fn title(&self, made: Element) -> String {
        match (made, &made.links()[..]) {
            (Element::Point(point, None), _) => self.points[point].into(),
            (_, links) => {
                let names: Vec<&str> = links.iter().map(|&link| self.links[link]).collect();
                names.join(", ")
            }
        }
    }

    /// The name of the part that the number at this place belongs to.
    fn name_of(&self, place: usize) -> &'static str {
        let layout = Layout::of(self);
        match place {
            _ if place < layout.links => self.points[place / 2],
            _ if place < layout.guides => self.links[(place - layout.links) / 5],
            _ if place < layout.dimensions => self.guides[(place - layout.guides) / 4],
            _ => self.name,
        }
    }
}

/// Where the numbers of each kind begin: two a point, five a link (origin, cosine, sine, slide),
/// four a guide (origin, cosine, sine), then the statements' dimensions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub links: usize,
    pub guides: usize,
    pub dimensions: usize,
}

impl Layout {
    pub(super) fn of(plan: &Plan) -> Self {
        let links = 2 * plan.points.len();
        let guides = links + 5 * plan.links.len();
        Self { links, guides, dimensions: guides + 4 * plan.guides.len() }
    }
}

/// Goes on whatever a condition says.
#[derive(Clone, Copy, Debug)]
pub struct Regardless {
    /// An unknown that counts as not found: where its equation jumps there is a place, but no root.
    without: &'static str,
}

impl Checks<f64> for Regardless {
    fn root(
        &mut self,
        found: Result<[f64; 2], FindError>,
        unknown: &'static str,
        _: &'static str,
    ) -> (f64, f64) {
        match found {
            Ok([at, size]) if unknown != self.without => (at, size),
            _ => (f64::NAN, f64::NAN),
        }
    }

    fn closed(&mut self, _: f64, _: f64, _: &'static str, _: &'static str) {}

    fn sin_cos(&mut self, angle: f64) -> (f64, f64) {
        Scalar::sin_cos(angle)
    }
}

/// The implementation of [`Drawn::place`] from the formulas.
///
/// # Errors
/// An input or parameter that is not finite, the first condition that is not met, or a result that is
/// not finite.
pub fn place<const N: usize>(
    plan: &Plan,
    given: &[(f64, &'static str)],
    formulas: impl FnOnce(&mut FirstError) -> [f64; N],
) -> Result<Vec<f64>, SolveError> {
    let placed = conditions_met(given, formulas)?;
    let mut numbers = placed.iter().enumerate();
    numbers.try_for_each(|(place, &value)| finite_result(value, plan.name_of(place), given))?;
    Ok(placed.into())
}

/// The implementation of [`Drawn::followed`], with a [`Tracker`].
pub fn followed<S: Solver<Scalar = f64>>(
    solver: S,
    path: &[S::Input],
) -> Vec<(S, Option<SolveError>)> {
    let mut tracker = Tracker::new(solver);
    let poses = path.iter().map(|&q| {
        let error = tracker.position(q).err();
        (*tracker.solver(), error)
    });
    poses.collect()
}

/// The forces that a declaration puts on points: what a solver's `applied` gives, and a film's draws.
#[derive(Clone, Debug, PartialEq)]
pub struct Applied {
    pub(super) forces: Vec<(&'static str, [f64; 2])>,
}

impl Applied {
    /// Each with its point, in newtons in ground axes, in the order of the declaration.
    #[must_use]
    pub fn forces(&self) -> &[(&'static str, [f64; 2])] {
        &self.forces
    }
}

/// The implementation of a solver's `applied` from the formulas, which give x and y of one force after
/// the other. `points` are the points that they act on.
///
/// # Errors
/// Those of [`place`].
pub fn applied<const N: usize>(
    plan: &Plan,
    points: &[usize],
    given: &[(f64, &'static str)],
    formulas: impl FnOnce(&mut FirstError) -> [f64; N],
) -> Result<Applied, SolveError> {
    let numbers = conditions_met(given, formulas)?;
    let names = points.iter().map(|&point| plan.points[point]);
    let forces = names.zip(numbers.chunks_exact(2)).map(|(name, force)| {
        force.iter().try_for_each(|&number| finite_result(number, name, given))?;
        Ok((name, [force[0], force[1]]))
    });
    Ok(Applied { forces: forces.collect::<Result<_, _>>()? })
}

/// The implementation of [`Drawn::place_open`] from the formulas.
pub fn place_open<const N: usize>(
    without: &'static str,
    formulas: impl FnOnce(&mut Regardless) -> [f64; N],
) -> Vec<f64> {
    formulas(&mut Regardless { without }).into()
}
