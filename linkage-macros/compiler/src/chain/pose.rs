//! Poses of the groups that were found, from the drawing on.

mod two_bars;

use super::cutting::{Dyad, Found, Pair, SearchedGroup};
use super::limits::sine;
use super::machine::{GROUND, Held, Machine};
use super::plane::{Complex, Displaced, root};

thread_local! {
    /// The count of residuals that were computed, by which tests bound the work of a cut.
    pub static RESIDUALS: std::cell::Cell<usize> = const { std::cell::Cell::new(0) };
}

/// Two bodies, and the drive that holds them together.
type HeldBodies = ([usize; 2], Held);

/// The changes of drives, lengths and unknowns from the drawing.
#[derive(Default)]
pub struct PoseChanges {
    pub drives: Vec<f64>,
    /// The lengths of bars, by body, where any changes.
    pub lengths: Vec<f64>,
    /// The angles and the places of bodies that are given, where they move.
    pub turns: Vec<f64>,
    pub shifts: Vec<Complex>,
    /// The unknowns of the searches so far; each begins where it was.
    pub unknowns: Vec<f64>,
}

/// Bodies as far as they are placed.
#[derive(Clone)]
pub struct Posed<'m> {
    pub machine: &'m Machine,
    pub of: Vec<Option<Displaced>>,
}

impl<'m> Posed<'m> {
    pub fn new(machine: &'m Machine) -> Self {
        let mut of = vec![None; machine.bodies.len()];
        of[GROUND] =
            Some(Displaced { shift: Complex::new(0.0, 0.0), turn: Complex::new(1.0, 0.0) });
        Self { machine, of }
    }

    /// A body seen from the drawing, where it is placed.
    pub(super) fn displaced(&self, body: usize) -> Option<Displaced> {
        self.of[body]
    }

    fn pin(&self, pin: usize, given: &PoseChanges) -> Option<Complex> {
        let mut bodies = self.of.iter().zip(&self.machine.bodies).enumerate();
        let (body, displaced) = bodies.find_map(|(body, (known, drawn))| {
            let displaced = (*known)?;
            drawn.pins.contains(&pin).then_some((body, displaced))
        })?;
        Some(displaced.of(self.place(body, pin, given)))
    }

    /// The place of a pin on a body, in the drawing but for the change of the body's length.
    fn place(&self, body: usize, pin: usize, given: &PoseChanges) -> Complex {
        let place = self.machine.pins[pin];
        let change = given.lengths.get(body).copied().unwrap_or(0.0);
        match self.machine.bodies[body].pins[..] {
            [first, second, ..] if second == pin && change != 0.0 => {
                place + (place - self.machine.pins[first]).unit().times(change)
            }
            _ => place,
        }
    }

    /// Places bodies; `None` where a dyad does not assemble or a search has no root nearby.
    pub fn run(&mut self, steps: &[Found], given: &mut PoseChanges, unknown: f64) -> Option<()> {
        self.follow_given(given);
        let mut searches = 0;
        for step in steps {
            match step {
                Found::Crank { drive, body, reference, pivot } => {
                    let change = self.change(*drive, *body, given, unknown);
                    let turn = self.of[*reference]?.turn * Complex::turned(change);
                    let drawn = self.place(*body, *pivot, given);
                    let place = Displaced::taking(drawn, self.pin(*pivot, given)?, turn);
                    self.of[*body] = Some(place);
                }
                Found::Slider { drive, body, slide } => {
                    let slide = self.machine.slides[*slide];
                    let is_body = slide.body == *body;
                    let other = self.of[if is_body { slide.carrier } else { slide.body }]?;
                    let change = self.change(*drive, *body, given, unknown);
                    let sign = if is_body || drive.is_some() { 1.0 } else { -1.0 };
                    let way = other.turn * slide.along.times(sign * change);
                    self.of[*body] = Some(Displaced { shift: other.shift + way, turn: other.turn });
                }
                Found::Dyad(dyad) => self.dyad(dyad, given)?,
                // It stands last, since nothing is followed behind it.
                Found::Tracked(_) => return None,
                Found::Search(search) => {
                    let start = given.unknowns.get(searches).copied().unwrap_or(0.0);
                    let root = self.solve(search, given, start)?;
                    if let Some(unknown) = given.unknowns.get_mut(searches) {
                        *unknown = root;
                    }
                    searches += 1;
                }
            }
        }
        Some(())
    }

    /// Places the bodies that are given: where they are drawn, but for what is known of their motion.
    fn follow_given(&mut self, given: &PoseChanges) {
        for (body, of) in self.machine.bodies.iter().enumerate() {
            let Some(footing) = of.given.as_ref().filter(|_| self.of[body].is_none()) else {
                continue;
            };
            let turn = Complex::turned(given.turns.get(body).copied().unwrap_or(0.0));
            let shift = given.shifts.get(body).copied().unwrap_or(Complex::new(0.0, 0.0));
            let pivot = footing.pins.first().map_or(shift, |&pin| self.machine.pins[pin]);
            self.of[body] = Some(Displaced::taking(pivot, pivot + shift, turn));
        }
    }

    /// The change of a driver from the drawing.
    fn change(&self, drive: Option<usize>, body: usize, given: &PoseChanges, unknown: f64) -> f64 {
        match drive {
            None => unknown,
            Some(drive) if self.machine.drives[drive].bodies[0] == body => given.drives[drive],
            Some(drive) => -given.drives[drive],
        }
    }

    /// The residual of a search's equation, as a length.
    pub(super) fn residual(
        &mut self,
        search: &SearchedGroup,
        given: &mut PoseChanges,
        unknown: f64,
    ) -> Option<f64> {
        RESIDUALS.with(|count| count.set(count.get() + 1));
        self.run(&search.steps, given, unknown)?;
        let machine = self.machine;
        let Pair::Pin(first) = search.joints[0] else { return None };
        let at = self.pin(first, given)?;
        let missed = match search.joints[1] {
            Pair::Pin(second) => {
                let held = search.held.map(|(body, held)| ([search.left_out, body], held));
                let from = self.place(search.left_out, first, given);
                let tip = self.tip(search.left_out, held, second, given);
                let drawn = tip - from;
                let now = self.pin(second, given)? - at;
                let turn = (now * drawn.conjugate()).unit();
                self.of[search.left_out] = Some(Displaced::taking(from, at, turn));
                self.follow(held, given);
                now.length() - drawn.length()
            }
            Pair::Slide(slide) => {
                let slide = machine.slides[slide];
                let is_body = slide.body == search.left_out;
                let other = self.of[if is_body { slide.carrier } else { slide.body }]?;
                let drawn = slide.along.cross(machine.pins[first] - slide.through);
                let from = at - other.of(slide.through);
                self.of[search.left_out] =
                    Some(Displaced::taking(machine.pins[first], at, other.turn));
                (other.turn * slide.along).cross(from) - drawn
            }
        };
        missed.is_finite().then_some(missed)
    }

    /// The residual with the bodies that a search places as a trial, which is made of these poses anew.
    pub(super) fn beside(
        &self,
        trial: &mut Self,
        search: &SearchedGroup,
        given: &mut PoseChanges,
        unknown: f64,
    ) -> Option<f64> {
        trial.of.clone_from(&self.of);
        trial.residual(search, given, unknown)
    }

    /// The slope of the equation over the unknown.
    pub fn slope(
        &self,
        search: &SearchedGroup,
        given: &mut PoseChanges,
        unknown: f64,
    ) -> Option<f64> {
        // A part of the unit, so that a scaled drawing is the same.
        let step = 1e-6 * search.unit(self.machine);
        let mut trial = self.clone();
        let mut at = |unknown: f64| self.beside(&mut trial, search, given, unknown);
        Some((at(unknown + step)? - at(unknown - step)?) / (2.0 * step))
    }

    /// Newton's root of a search beside a start; its bodies are placed there.
    pub fn solve(
        &mut self,
        search: &SearchedGroup,
        given: &mut PoseChanges,
        start: f64,
    ) -> Option<f64> {
        const STEPS: usize = 20;
        let mut unknown = start;
        let (mut trial, unit) = (self.clone(), search.unit(self.machine));
        for _ in 0..STEPS {
            let missed = self.beside(&mut trial, search, given, unknown)?;
            let step = missed / self.slope(search, given, unknown)?;
            unknown -= step;
            if !unknown.is_finite() {
                return None;
            }
            if step.abs() < 1e-11 * unit {
                self.residual(search, given, unknown)?;
                return Some(unknown);
            }
        }
        None
    }

    /// The angle by which the drive turns the second of two held bodies against the first.
    fn turned(&self, [_, second]: [usize; 2], held: Held, given: &PoseChanges) -> Complex {
        Complex::turned(self.change(Some(held.drive), second, given, 0.0))
    }

    /// The place of a pin on a body, or on the first of two held bodies where the drive takes a pin of the second.
    fn tip(
        &self,
        body: usize,
        held: Option<([usize; 2], Held)>,
        pin: usize,
        given: &PoseChanges,
    ) -> Complex {
        let Some((bodies, held)) = held else { return self.place(body, pin, given) };
        let place = self.machine.pins[pin];
        let pivot = self.machine.pins[held.pivot];
        pivot + self.turned(bodies, held, given) * (place - pivot)
    }

    /// Places the second of two held bodies behind the first.
    fn follow(&mut self, held: Option<([usize; 2], Held)>, given: &PoseChanges) {
        let Some((bodies, held)) = held else { return };
        let Some(first) = self.of[bodies[0]] else { return };
        let pivot = self.machine.pins[held.pivot];
        let turn = first.turn * self.turned(bodies, held, given);
        self.of[bodies[1]] = Some(Displaced::taking(pivot, first.of(pivot), turn));
    }

    fn dyad(&mut self, dyad: &Dyad, given: &PoseChanges) -> Option<()> {
        let machine = self.machine;
        let sign = sine(machine, dyad).signum();
        let drawn = |pin: usize| machine.pins[pin];
        let [a, b] = dyad.legs.each_ref().map(|leg| leg.bodies[0]);
        let held = dyad.legs.each_ref().map(|leg| Some(([a, *leg.bodies.get(1)?], leg.held?)));
        let held = [held[0], held[1].map(|([_, other], held)| ([b, other], held))];
        match (dyad.legs[0].outer, dyad.inner, dyad.legs[1].outer) {
            (Pair::Pin(u), Pair::Pin(v), Pair::Pin(w)) => {
                self.two_bars(dyad, held, given, [u, v, w])?;
            }
            (Pair::Pin(u), Pair::Pin(v), Pair::Slide(s)) => {
                let (from, rail) = (self.pin(u, given)?, self.rail(s, b)?);
                let (along, through) = (rail.1, rail.0);
                let offset = machine.slides[s].along.cross(drawn(v) - machine.slides[s].through);
                let foot = along.cross(from - through) - offset;
                let outer = self.place(a, u, given);
                let bar = self.tip(a, held[0], v, given) - outer;
                let length = bar.length();
                let way = along.dot(from - through)
                    + sign * real_root((length - foot) * (length + foot))?;
                let tip = through + along * Complex::new(way, offset);
                let turn = ((tip - from) * bar.conjugate()).unit();
                self.of[a] = Some(Displaced::taking(outer, from, turn));
                self.of[b] = Some(Displaced::taking(drawn(v), tip, rail.2));
                self.follow(held[0], given);
            }
            (Pair::Pin(u), Pair::Slide(s), Pair::Pin(w)) => {
                let (from, to) = (self.pin(u, given)?, self.pin(w, given)?);
                let along = machine.slides[s].along;
                let offset = along.cross(drawn(u) - drawn(w));
                let far = (from - to).length();
                let way = sign * real_root((far - offset) * (far + offset))?;
                let turn = ((from - to) * (along * Complex::new(way, offset)).conjugate()).unit();
                self.of[a] = Some(Displaced::taking(drawn(u), from, turn));
                self.of[b] = Some(Displaced::taking(drawn(w), to, turn));
            }
            (Pair::Slide(s), Pair::Pin(v), Pair::Slide(t)) => {
                self.on_two_rails([a, b], [s, t], v)?
            }
            (Pair::Pin(u), Pair::Slide(s), Pair::Slide(t)) => {
                let (through, along, turn) = self.rail(t, b)?;
                let slot = turn * machine.slides[s].along;
                let carried = through + turn * (drawn(u) - machine.slides[t].through);
                let at = self.pin(u, given)?;
                let way = quotient((at - carried).cross(slot), along.cross(slot))?;
                let yoke =
                    Displaced::taking(machine.slides[t].through, through + along.times(way), turn);
                self.of[b] = Some(yoke);
                self.of[a] = Some(Displaced::taking(drawn(u), at, turn));
            }
            _ => return None,
        }
        Some(())
    }

    /// Two bodies on places that are known, whose other ends meet on the side of the sign: where both ends are drawn.
    fn between_two_pins(
        &mut self,
        bodies: [usize; 2],
        [from, to]: [Complex; 2],
        [outer, tips]: [[Complex; 2]; 2],
        sign: f64,
    ) -> Option<()> {
        let bars = [0, 1].map(|leg| tips[leg] - outer[leg]);
        let [first, second] = bars.map(Complex::length);
        let base = to - from;
        let far = base.length();
        let x = (far + (first - second) * (first + second) / far) / 2.0;
        let tip =
            from + base.unit() * Complex::new(x, sign * real_root((first - x) * (first + x))?);
        for (leg, at) in [from, to].into_iter().enumerate() {
            let turn = ((tip - at) * bars[leg].conjugate()).unit();
            self.of[bodies[leg]] = Some(Displaced::taking(outer[leg], at, turn));
        }
        Some(())
    }

    fn on_two_rails(&mut self, [a, b]: [usize; 2], [s, t]: [usize; 2], pin: usize) -> Option<()> {
        let drawn = self.machine.pins[pin];
        let line = |slide: usize, body: usize| {
            let (through, along, turn) = self.rail(slide, body)?;
            let slide = self.machine.slides[slide];
            let offset = slide.along.cross(drawn - slide.through);
            Some((through + along * Complex::new(0.0, offset), along, turn))
        };
        let (first, second) = (line(s, a)?, line(t, b)?);
        let way = quotient((second.0 - first.0).cross(second.1), first.1.cross(second.1))?;
        let tip = first.0 + first.1.times(way);
        self.of[a] = Some(Displaced::taking(drawn, tip, first.2));
        self.of[b] = Some(Displaced::taking(drawn, tip, second.2));
        Some(())
    }

    /// A point, the direction and the turning of the line along which a body slides.
    fn rail(&self, slide: usize, body: usize) -> Option<(Complex, Complex, Complex)> {
        let slide = self.machine.slides[slide];
        let known = self.of[if slide.body == body { slide.carrier } else { slide.body }]?;
        Some((known.of(slide.through), known.turn * slide.along, known.turn))
    }
}

/// The root of a number that is not negative.
fn real_root(square: f64) -> Option<f64> {
    (square >= 0.0).then(|| root(square))
}

fn quotient(above: f64, below: f64) -> Option<f64> {
    (below != 0.0).then(|| above / below)
}
