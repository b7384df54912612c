//! A page on which a mechanism is dragged: one file, its formulas a script that the macro has printed, and a
//! run-time of a few files without libraries.
//!
//! `kernels.js`, `limit.js` and `checks.js` compute and decide as the crate does, `roots.js` and `survey.js`
//! search and `friction.js` solves for friction as it does, `pose.js` reads the results, `drag.js` finds the
//! inputs of a dragged point; nothing of this touches the document. `picture.js`, `symbols.js`, `curves.js`,
//! `acts.js`, `controls.js` and `page.js` do. What only some machines have stands in files that only their pages
//! have, `slides.js`, `springs.js`, `forces.js`, `marks.js`, `held.js`, `run.js`, `tolerance.js`, `defaults.js`,
//! `modes.js`, `wanted.js`, `sets.js` and `ranges.js`: `page_files.rs` says when. `squeeze.rs` strips all of them, and
//! `names.rs` gives their words short names.

mod assembled;
mod declared;
mod json;
mod names;
mod page_files;
mod settings;
mod squeeze;
#[cfg(test)]
mod tests;

use core::ops::RangeInclusive;
use std::path::Path;
use std::string::{String, ToString};
use std::vec::Vec;

pub use assembled::{Machine, html, html_of_sets};
use declared::PageOf;
pub use declared::{Declared, Paged};
pub use names::shortened;
pub use settings::Wishes;

use super::plan::PlanOf;
use super::sketch_error::SketchError;
use super::traces::point;
use crate::Record;

/// A page on which the mechanism is dragged. Its parameters are the solver's at first.
///
/// ```
/// # use linkage_core::mechanism;
/// # mechanism! {
/// #     struct Rocker {
/// #         input theta: angle;
/// #         param crank = 80mm;
/// #         ground A(0, 0), D(665.7mm, 0);
/// #         crank AB(A) -> B        { length: crank, angle: theta }
/// #         rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
/// #         point blade on BC at (500mm, -60mm);
/// #     }
/// # }
/// let page = Rocker::new().page().title("A rocker").range("crank", 0.05..=0.2).rate("theta", 12.0);
/// let html = page.traces(["blade"]).curves(["blade", "DC"]).to_html()?;
/// assert!(html.contains("<title>A rocker</title>") && !html.contains(" src="));
/// # Ok::<(), linkage_core::sketch::SketchError>(())
/// ```
///
/// It is one HTML file: the macro prints the formulas as JavaScript, and the page's own script needs no
/// library and nothing of the network. A crank's pin turns its crank, also into a pose that cannot be
/// assembled, which shows what is missing; any other point takes the inputs with it that bring it nearest, and
/// stays where the machine ends. Arrow keys move the input, with Shift ten times as far; space plays. The
/// address holds the state, so that it can be sent. A length input without a `range` or a `path` goes as far as the
/// machine can be assembled, which the page finds. Velocities,
/// accelerations and forces are those at a constant rate of the input that curves are drawn over. Reactions, loads,
/// weights and the drives that are outputs are arrows to one scale, couples arcs to another; both stand at the foot of
/// the picture. Where the largest force is more than twice what a tenth of the poses exceeds, arrows that are longer than
/// this are cut and have two heads. Masses have the symbol of a centre of mass, and cranks that are coupled by a ratio
/// their pitch circles. The numbers are the solver's to the last bit, but for `tan`, `exp`, `ln`, `tanh` and `pow`: those
/// are the browser's, whose last bits may differ. On targets with fused operations the solver itself rounds otherwise. An
/// `unknown` is searched as the solver searches it. Of a machine with several sets of inputs a reader chooses which one
/// drives; the pose stays, unless it is another assembly of the other set, which the page says.
#[derive(Clone, Debug)]
pub struct Page<S> {
    solver: S,
    wishes: Wishes,
    /// The sets of inputs of a machine that has several, and the machine's name.
    sets: Option<(&'static str, Vec<SetOfPage>)>,
}

/// A set of inputs by its name, and the mechanism that it drives.
#[derive(Clone, Debug)]
struct SetOfPage {
    set: &'static str,
    machine: Machine<'static>,
    values: Vec<f64>,
}

impl SetOfPage {
    fn of<S: Paged>(set: &'static str, solver: &S) -> Self {
        let plan = &PlanOf::<S>::PLAN;
        let (name, docs, declared) = (plan.name, plan.docs, PageOf::<S>::PAGE);
        Self {
            set,
            machine: Machine { name, docs, declared, values: &[] },
            values: solver.params(),
        }
    }
}

impl<S: Paged> Page<S> {
    /// The page of a solver; generated code calls it.
    #[doc(hidden)]
    #[must_use]
    pub fn of(solver: &S) -> Self {
        Self { solver: *solver, wishes: Wishes::default(), sets: None }
    }

    /// The page of a machine with several sets of inputs, driven by the set of this name at first; generated code calls it.
    #[doc(hidden)]
    #[must_use]
    pub fn of_set(machine: &'static str, set: &'static str, solver: &S) -> Self {
        Self { sets: Some((machine, [SetOfPage::of(set, solver)].into())), ..Self::of(solver) }
    }

    /// Another set of its inputs; generated code calls it.
    #[doc(hidden)]
    #[must_use]
    pub fn or_set<O: Paged>(mut self, set: &'static str, solver: &O) -> Self {
        if let Some((_, sets)) = &mut self.sets {
            sets.push(SetOfPage::of(set, solver));
        }
        self
    }

    /// A heading in place of the mechanism's name.
    #[must_use]
    pub fn title(mut self, title: &str) -> Self {
        self.wishes.title = Some(title.to_string());
        self
    }

    /// Draws the paths of these points; by default those of points on moving links.
    #[must_use]
    pub fn traces<N: AsRef<str>>(mut self, points: impl IntoIterator<Item = N>) -> Self {
        self.wishes.traces = points.into_iter().map(|name| name.as_ref().to_string()).collect();
        self
    }

    /// Offers curves of these outputs and forces, the first one at first; by default of all.
    #[must_use]
    pub fn curves<N: AsRef<str>>(mut self, outputs: impl IntoIterator<Item = N>) -> Self {
        self.wishes.curves = outputs.into_iter().map(|name| name.as_ref().to_string()).collect();
        self
    }

    /// The ends of the slider of an input, a parameter or a load, in SI units. By default an angle turns fully,
    /// a length input goes as far as the path, or as the machine can be assembled, and a parameter goes from half to
    /// one and a half times its value.
    #[must_use]
    pub fn range(mut self, name: &str, ends: RangeInclusive<f64>) -> Self {
        self.wishes.ranges.push((name.to_string(), ends));
        self
    }

    /// The rate of an input at which velocities, accelerations and forces are shown, in SI units: by default a
    /// turn, or a quarter of a length's range, a second.
    #[must_use]
    pub fn rate(mut self, input: &str, rate: f64) -> Self {
        self.wishes.rates.push((input.to_string(), rate));
        self
    }

    /// The value of a load at first, in SI units; zero by default.
    #[must_use]
    pub fn load(mut self, load: &str, value: f64) -> Self {
        self.wishes.loads.push((load.to_string(), value));
        self
    }

    /// The poses that Play runs through, over and over; by default one input does what its range allows.
    #[must_use]
    pub fn path(mut self, path: impl IntoIterator<Item = impl Into<S::Input>>) -> Self
    where
        S::Input: Record<Number = f64>,
    {
        let listed = |q: S::Input| q.into_array().into_iter().collect();
        self.wishes.path = path.into_iter().map(|q| listed(q.into())).collect();
        self
    }

    /// Begins with the curves of this machine kept, dashed, beside the page's own: the dimensions before a search, and those
    /// after it.
    #[must_use]
    pub fn before(mut self, solver: &S) -> Self {
        self.wishes.before = solver.params();
        self
    }

    /// Marks these places in the picture, in metres: those that a point shall pass.
    #[must_use]
    pub fn points(mut self, points: impl IntoIterator<Item = impl Into<[f64; 2]>>) -> Self {
        self.wishes.points = points.into_iter().map(Into::into).collect();
        self
    }

    /// Marks what an output shall be, in pairs of the first input and its first number, in SI units.
    #[must_use]
    pub fn wanted(mut self, output: &str, pairs: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let pairs = pairs.into_iter().map(<[f64; 2]>::from).collect();
        self.wishes.wanted.push((output.to_string(), pairs));
        self
    }

    /// The page: one file without libraries, which asks for nothing of the network.
    ///
    /// # Errors
    /// `UnknownName` for a trace, a curve, a wanted output, a range, a rate or a load of nothing that is declared.
    pub fn to_html(&self) -> Result<String, SketchError> {
        let plan = &PlanOf::<S>::PLAN;
        self.wishes.traces.iter().try_for_each(|name| point(plan, name).map(drop))?;
        if let Some((name, sets)) = &self.sets {
            let sets: Vec<_> = sets
                .iter()
                .map(|of| (of.set, Machine { values: &of.values, ..of.machine }))
                .collect();
            return html_of_sets(name, &sets, &self.wishes);
        }
        let (name, docs, values) = (plan.name, plan.docs, &self.solver.params());
        html(&Machine { name, docs, declared: PageOf::<S>::PAGE, values }, &self.wishes)
    }

    /// Writes the page.
    ///
    /// # Errors
    /// Those of [`to_html`](Self::to_html), and `Write`.
    pub fn write_html(&self, path: impl AsRef<Path>) -> Result<(), SketchError> {
        Ok(std::fs::write(path, self.to_html()?)?)
    }
}
