//! Statements about forces: what has mass, what acts, and what a call is given of that.
//!
//! ```text
//! action       `gravity` pair `;` | `load` NAME,* `:` KIND `;`
//!            | `mass` expression `on` NAME (`at` (pair | POINT) | `uniform`)?
//!                                            (`inertia` expression)? `;`
//!            | `inertia` expression `on` LINK `;`
//!            | `force` (pair (`in` NAME)? `on` POINT | expression `between` POINT `and` POINT) `;`
//!            | `torque` expression (`on` LINK | `between` LINK `and` LINK) `;`
//!            | `spring` NAME? `between` NAME `and` NAME `{` (FIELD `:` expression),* `}`
//!            | `stop` NAME? expression `between` pair `{` (FIELD `:` expression),* `}`
//!            | `friction` expression (`at` PIN | `on` LINK (`at` PIN)? | `between` NAME `and` NAME `at` PIN)
//!                                    ((`radius` | `length` | `smooth`) expression)* `;`
//! ```
//!
//! The quantity comes first, then its place; none of these statements declares a name but `load`, `spring` and `stop`.

use proc_macro2::{Delimiter, Ident, Span, TokenTree};

use super::tokens::{Parse, Parser, Reported};
use super::tree::{
    Action, ForceBetweenStatement, ForceStatement, FrictionSite, FrictionStatement,
    GravityStatement, GroupStatement, InertiaStatement, LoadStatement, MassSite, MassStatement,
    SpringStatement, StatementKind, StopStatement, TorqueBetweenStatement, TorqueStatement,
};

const MASS_FORMS: &str = "a mass is `mass 2kg on BC at G`, `… on BC at (x, y)`, \
                          `… on BC uniform` or, on a pin or point, `mass 2kg on C`";
const FORCE_FORMS: &str = "a force is `force (fx, fy) on P` or `force f between P and Q`";
const AXES: &str = "a force f across a link is `force (0, f) in LINK on P`: behind `in` stands the body \
                    along whose axes the components lie";
const SPRING_FORM: &str = "a spring is `spring between P and Q { stiffness: 15(N/m), free_length: \
                           0.3m }`, between two points or two links, and may have a name";
const FRICTION_FORMS: &str = "friction is `friction 0.1 at C radius 8mm` of a pin, \
                              `friction 0.1 on BC at C radius 8mm` where more links meet, or \
                              `friction 0.1 on ram` of what slides";
const STOP_FORM: &str = "a stop is `stop DC.angle between (20deg, 110deg) { stiffness: 2e4(N*m/rad) }`, \
                         of an angle, a slide or a distance, and may have a name";
const TORQUE_FORMS: &str = "a torque is `torque t on BC` or `torque t between BC and DC`";

impl Parser<'_> {
    pub(super) fn load(&mut self) -> Parse<StatementKind> {
        let mut names = vec![self.new_name("a load")?];
        while self.take_punct(',') {
            if self.peek_ident(0).is_none() {
                break;
            }
            names.extend(self.new_name("a load"));
        }
        let first = names[0].clone();
        let kind = match self.take_punct(':') {
            true => self.word("`force`, `torque` or `number`").map(Some),
            false if self.is_punct(0, '=') => self.refuse_because(
                &format!("write `load {first}: force;`"),
                "a load's value is an argument of each call; one that stays is a `param` or a `let`",
            ),
            false => self.refuse_because(
                &format!("say what `{first}` is: `load {first}: force;`"),
                "a load is a `force`, a `torque` or a `number`",
            ),
        };
        let kind = self.or_skip(kind, None);
        Ok(StatementKind::Load(LoadStatement { names, kind }))
    }

    pub(super) fn gravity(&mut self, at: Span) -> Parse<StatementKind> {
        if !self.is_group(0, Delimiter::Parenthesis) {
            return self.expected_because(
                "`(gx, gy)`",
                "gravity is an acceleration in ground axes: `gravity (0, -9.81);`",
            );
        }
        Ok(StatementKind::Action(Action::Gravity(GravityStatement {
            at,
            value: self.pair("`(gx, gy)`")?,
        })))
    }

    pub(super) fn mass(&mut self) -> Parse<StatementKind> {
        let value = self.expression()?;
        if !self.take_word("on") {
            return self.expected_because("`on`", MASS_FORMS);
        }
        let on = self.name_of("a link or a point")?;
        let place = match () {
            () if self.is_word(0, "uniform") => {
                let at = self.here();
                self.take();
                MassSite::Uniform(at)
            }
            () if self.take_word("at") => match self.is_group(0, Delimiter::Parenthesis) {
                true => MassSite::At(self.pair("`(x, y)`")?),
                false if self.peek_ident(0).is_none() => {
                    return self.expected_because("a point or `(x, y)`", MASS_FORMS);
                }
                false => MassSite::Point(self.name_of("a point")?),
            },
            () => MassSite::Here,
        };
        let inertia = match self.take_word("inertia") {
            true => Some(self.expression()?),
            false => None,
        };
        Ok(StatementKind::Action(Action::Mass(MassStatement { value, on, place, inertia })))
    }

    pub(super) fn inertia(&mut self) -> Parse<StatementKind> {
        let value = self.expression()?;
        if !self.take_word("on") {
            return self.expected_because("`on`", "an inertia is `inertia 0.1(kg*m^2) on AB`");
        }
        Ok(StatementKind::Action(Action::Inertia(InertiaStatement {
            value,
            on: self.name_of("a link")?,
        })))
    }

    pub(super) fn force(&mut self) -> Parse<StatementKind> {
        if self.is_a_vector() {
            let value = self.pair("`(fx, fy)`")?;
            let axes = match self.take_word("in") {
                true => Some(self.name_of("a link or a guide")?),
                false => None,
            };
            if !self.take_word("on") {
                let what = if axes.is_some() { "`on`" } else { "`on` or `in`" };
                return self.expected_because(what, FORCE_FORMS);
            }
            let on = self.name_of("a point")?;
            if let (true, Some(axes)) = (self.is_word(0, "in"), self.peek_ident(1)) {
                let message = format!("write `force (fx, fy) in {axes} on {on}`");
                return self.refuse_because(&message, AXES);
            }
            if self.is_word(0, "at") {
                let place = self.rest_of_statement(1);
                let link = if self.is_a_link(&on) { on.to_string() } else { "LINK".to_string() };
                let message = format!("declare a point: `point P on {link} at {place};`");
                return self
                    .refuse_because(&message, "a force acts on a point, by its name: `… on P`");
            }
            return Ok(StatementKind::Action(Action::Force(ForceStatement { value, axes, on })));
        }
        let shown =
            self.as_written(0, |tree| matches!(tree, TokenTree::Ident(word) if word == "along"));
        let value = self.expression()?;
        if let Some(told) = self.force_along_a_line(&shown) {
            told?;
        }
        if let (true, Some(axes)) = (self.is_word(0, "in"), self.peek_ident(1)) {
            let message =
                format!("write both components in front: `force (fx, fy) in {axes} on P`");
            return self.refuse_because(&message, AXES);
        }
        if self.is_word(0, "on") {
            return self.refuse_because(
                "a force on a point has two components; write `force (fx, fy) on P`",
                FORCE_FORMS,
            );
        }
        let points = self.ends("a point", FORCE_FORMS)?;
        Ok(StatementKind::Action(Action::ForceBetween(ForceBetweenStatement { value, points })))
    }

    /// True if the parentheses that stand next hold two components.
    fn is_a_vector(&self) -> bool {
        let Some(TokenTree::Group(group)) = self.peek(0) else { return false };
        let is_comma = |tree: TokenTree| matches!(tree, TokenTree::Punct(p) if p.as_char() == ',');
        group.delimiter() == Delimiter::Parenthesis
            && (group.stream().into_iter().any(is_comma)
                || self.is_word(1, "on")
                || self.is_word(1, "in"))
    }

    pub(super) fn torque(&mut self) -> Parse<StatementKind> {
        let value = self.expression()?;
        if self.take_word("on") {
            return Ok(StatementKind::Action(Action::Torque(TorqueStatement {
                value,
                on: self.name_of("a link")?,
            })));
        }
        let bodies = self.ends("a link or `ground`", TORQUE_FORMS)?;
        Ok(StatementKind::Action(Action::TorqueBetween(TorqueBetweenStatement { value, bodies })))
    }

    pub(super) fn spring(&mut self, keyword: &Ident) -> Parse<StatementKind> {
        let name = match (self.is_word(0, "between"), self.peek_ident(0).is_some()) {
            (true, _) => None,
            (false, true) => Some(self.new_name("a spring")?),
            (false, false) => return self.expected_because("a name or `between`", SPRING_FORM),
        };
        if !self.is_word(0, "between") {
            return self.expected_because("`between`", SPRING_FORM);
        }
        let ends = self.ends("a point or a link", SPRING_FORM)?;
        let mut fields = GroupStatement::without_links(keyword.clone(), self.end());
        self.fields_in_braces(&mut fields);
        Ok(StatementKind::Action(Action::Spring(SpringStatement { name, ends, fields })))
    }

    pub(super) fn stop(&mut self, keyword: &Ident) -> Parse<StatementKind> {
        // A name stands in front of another one, or of a number.
        let begins = matches!(self.peek(1), Some(TokenTree::Ident(_) | TokenTree::Literal(_)));
        let is_named = self.peek_ident(0).is_some() && begins && !self.is_word(1, "between");
        let name = if is_named { Some(self.new_name("a stop")?) } else { None };
        let of = self.expression()?;
        if !self.take_word("between") {
            return self.expected_because("`between`", STOP_FORM);
        }
        if !self.is_group(0, Delimiter::Parenthesis) {
            return self.expected_because("`(from, to)`", STOP_FORM);
        }
        let ends = self.pair("`(from, to)`")?;
        let mut fields = GroupStatement::without_links(keyword.clone(), self.end());
        self.fields_in_braces(&mut fields);
        Ok(StatementKind::Action(Action::Stop(StopStatement { name, of, ends, fields })))
    }

    pub(super) fn friction(&mut self, at: Span) -> Parse<StatementKind> {
        let coefficient = self.expression()?;
        if let Some(told) = self.percentage() {
            told?;
        }
        let site = match () {
            () if self.take_word("at") => FrictionSite::Pin(self.name_of("a pin")?),
            () if self.take_word("on") => {
                let link = self.name_of("a link")?;
                match self.take_word("at") {
                    true => FrictionSite::LinkAtPin(link, self.name_of("a pin")?),
                    false => FrictionSite::Slider(link),
                }
            }
            () if self.is_word(0, "between") => {
                let bodies = self.ends("a link or `ground`", FRICTION_FORMS)?;
                if !self.take_word("at") {
                    return self.expected_because("`at`", FRICTION_FORMS);
                }
                FrictionSite::Between(bodies, self.name_of("a pin")?)
            }
            () => return self.expected_because("`at`, `on` or `between`", FRICTION_FORMS),
        };
        let mut friction =
            FrictionStatement { at, coefficient, site, radius: None, length: None, smooth: None };
        loop {
            if let Some(told) = self.diameter() {
                told?;
            }
            let part = match () {
                () if self.is_word(0, "radius") => &mut friction.radius,
                () if self.is_word(0, "length") => &mut friction.length,
                () if self.is_word(0, "smooth") => &mut friction.smooth,
                () => return Ok(StatementKind::Action(Action::Friction(friction))),
            };
            let word = self.here();
            self.take();
            let value = self.expression()?;
            if part.replace(value).is_some() {
                self.diagnostics.error(word, "this is given twice; remove one");
            }
        }
    }

    /// `between P and Q`
    fn ends(&mut self, what: &str, forms: &str) -> Parse<[Ident; 2]> {
        if !self.take_word("between") {
            return self.expected_because("`on` or `between`", forms);
        }
        let first = self.end_of_two(what)?;
        if !self.take_word("and") {
            return self.expected_because("`and`", forms);
        }
        Ok([first, self.end_of_two(what)?])
    }

    fn end_of_two(&mut self, what: &str) -> Parse<Ident> {
        if let Some(told) = self.end_without_a_name() {
            told?;
        }
        self.name_of(what)
    }

    /// The parsed value, or `fallback` where the statement is skipped because of a mistake.
    pub(super) fn or_skip<T>(&mut self, parsed: Parse<T>, fallback: T) -> T {
        parsed.unwrap_or_else(|Reported| {
            self.skip_statement();
            fallback
        })
    }
}
