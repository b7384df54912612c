//! Assembly modes: which a group has, what they mean, and the parameters that hold one.

use proc_macro2::Ident;

use crate::diagnostics::nearest;
use crate::syntax::anatomy::{GroupSpec, Modes};
use crate::syntax::tree::{Expr, GroupStatement};

use crate::model::mechanism::{Mode, ParamKind, Sign};
use crate::model::names::{Entity, Kind};
use crate::model::parts_of_groups::Fields;
use crate::model::resolved_expr::bare_name;
use crate::model::scope::Scope;
use crate::model::{drawn_sliding, uses};

impl Modes {
    fn sign(self, word: &str) -> Option<Sign> {
        let [plus, minus] = self.words();
        match word {
            _ if word == plus => Some(Sign::Plus),
            _ if word == minus => Some(Sign::Minus),
            _ => None,
        }
    }
}

/// The kind of mode parameter that the word is a value of, and its sign.
pub(super) fn mode_word(word: &Ident) -> Option<ParamKind> {
    let word = word.to_string();
    let mode = |of: Modes| Some(ParamKind::Mode { of, default: of.sign(&word)? });
    Modes::ALL.into_iter().find_map(mode)
}

/// The trend of an equation at its root: the sign of its slope.
pub(super) fn trend_word(word: &str) -> Option<Sign> {
    Modes::Trend.sign(word)
}

/// Both words of a mode parameter.
pub(super) fn words_of(kind: &ParamKind) -> [&'static str; 2] {
    match kind {
        ParamKind::Mode { of, .. } => of.words(),
        ParamKind::Number { .. } => Modes::Side.words(),
    }
}

/// The side that the word names.
fn side_word(word: &Ident) -> Option<Sign> {
    Modes::Side.sign(&word.to_string())
}

/// The group's links slide on each other.
fn is_slide(group: &GroupStatement) -> bool {
    GroupSpec::of(&group.keyword.to_string()).is_some_and(GroupSpec::has_inner_slide)
}

/// The mode of two bars that stay opposite sides of a parallelogram. No parameter has it.
pub(crate) const PARALLEL: &str = "parallel";

/// The word `parallel`, where it is the mode of a group that can have it.
pub(super) fn parallel<'t>(
    scope: &Scope<'_>,
    anatomy: &GroupSpec,
    fields: &Fields<'t>,
) -> Option<&'t Expr> {
    let value = fields.one("mode").filter(|_| anatomy.can_be_parallel())?;
    let word = bare_name(value).filter(|word| *word == PARALLEL)?;
    // A parameter may have had this name before it was a word.
    (scope.names.kind(word) != Some(Kind::Param)).then_some(value)
}

/// The mode of a group that has modes.
pub(super) fn mode(
    scope: &mut Scope<'_>,
    group: &GroupStatement,
    anatomy: &GroupSpec,
    fields: &Fields,
) -> Option<Mode> {
    let modes = anatomy.modes?;
    let Some(value) = fields.one("mode") else {
        let is_default = !anatomy.mode_is_needed() && fields.is_left_out("mode");
        let drawn = drawn_sliding::mode_as_drawn(scope, group);
        return drawn.or(is_default.then_some(Sign::Plus)).map(Mode::Fixed);
    };
    let Some(word) = bare_name(value) else {
        let message = "a mode is one word";
        let reason = modes_explained(modes, group);
        scope.diagnostics.error_because(value.span, message, reason);
        return None;
    };
    if let Some(sign) = modes.sign(&word.to_string()) {
        return Some(Mode::Fixed(sign));
    }
    let is_another = |other: &Modes| *other != modes && other.sign(&word.to_string()).is_some();
    let is_parallel = word == PARALLEL && scope.names.kind(word) != Some(Kind::Param);
    if is_parallel || [Modes::Side, Modes::Sense].iter().any(is_another) {
        let message = format!("`{word}` is no mode of `{}`", group.keyword);
        let reason = modes_explained(modes, group);
        scope.diagnostics.error_because(word.span(), message, reason);
        return None;
    }
    mode_param(scope, word, modes, group)
}

/// A mode given by name is a mode parameter of the group's own kind.
fn mode_param(
    scope: &mut Scope<'_>,
    word: &Ident,
    modes: Modes,
    group: &GroupStatement,
) -> Option<Mode> {
    if scope.names.kind(word) != Some(Kind::Param) {
        if !scope.unread.may_hold(&word.to_string()) {
            mode_exists(scope, word, modes, group);
        }
        return None;
    }
    let Entity::Param(id) = uses::usable(scope, word, &[Kind::Param])? else {
        return None;
    };
    match (&scope.mechanism.params[id.index()].kind, modes) {
        (ParamKind::Mode { of, .. }, _) if *of == modes => Some(Mode::Param(id)),
        (ParamKind::Number { .. }, _) => {
            let message = format!("`{word}` is a number, not a mode");
            let [plus, _] = modes.words();
            let reason = format!("write `param {word}: mode = {plus};`");
            scope.diagnostics.error_because(word.span(), message, reason);
            None
        }
        (kind, _) => {
            let [plus, minus] = words_of(kind);
            let message =
                format!("`{word}` is `{plus}` or `{minus}`, no mode of `{}`", group.keyword);
            let reason = modes_explained(modes, group);
            scope.diagnostics.error_because(word.span(), message, reason);
            None
        }
    }
}

/// Reports a word that is no mode at all.
fn mode_exists(scope: &mut Scope<'_>, word: &Ident, modes: Modes, group: &GroupStatement) {
    let text = word.to_string();
    let parallel = (modes == Modes::Side).then_some(PARALLEL);
    let known = modes.words().into_iter().chain(parallel);
    let known = known.chain(scope.names.of_kinds(&[Kind::Param]));
    let message = match nearest(&text, known) {
        Some(near) => {
            format!("no mode named `{text}`; a mode with a similar name exists: `{near}`")
        }
        None => {
            let [plus, minus] = modes.words();
            format!("no mode named `{text}`; write `{plus}` or `{minus}`")
        }
    };
    let reason = modes_explained(modes, group);
    scope.diagnostics.error_because(word.span(), message, reason);
}

/// Both modes in the names of the group at hand.
pub(super) fn modes_explained(modes: Modes, group: &GroupStatement) -> String {
    let joint = |i: usize| {
        let joint = group.legs.get(i).and_then(|leg| leg.joint.as_ref());
        joint.map_or("the outer joint".into(), |joint| format!("`{joint}`"))
    };
    let pin = group.pin.as_ref().map_or("the pin".into(), |pin| format!("`{pin}`"));
    match modes {
        Modes::Side => format!(
            "`left` or `right`: the side of {pin} seen from {} looking to {}",
            joint(0),
            joint(1)
        ),
        Modes::Sense if is_slide(group) => format!(
            "`ahead` or `behind`: whether {} lies on the positive or the negative side of \
             the bar, seen from {}",
            joint(0),
            joint(1)
        ),
        Modes::Sense => format!(
            "`ahead` or `behind`: where {pin} lies against the foot of {} on {}, along its \
             direction",
            joint(0),
            joint(1)
        ),
        Modes::Trend => "`rising` or `falling`: how the equation passes its root".to_string(),
    }
}

/// The side in `at distances (r1, r2) left`.
pub(super) fn side_is_left_or_right(
    scope: &mut Scope<'_>,
    word: &Ident,
    point: &Ident,
) -> Option<Sign> {
    let side = side_word(word);
    if side.is_none() {
        let message = format!("no side named `{word}`; write `left` or `right`");
        let reason = format!("the side of `{point}` seen from the link's first joint to its pin");
        scope.diagnostics.error_because(word.span(), message, reason);
    }
    side
}

/// The value of a mode parameter is one of the six words.
pub(super) fn param_is_a_mode(scope: &mut Scope<'_>, default: &Expr) -> Option<ParamKind> {
    let kind = bare_name(default).and_then(mode_word);
    if bare_name(default).is_some_and(|word| word == PARALLEL) {
        let message = format!(
            "`{PARALLEL}` is no value of a parameter; write `mode: {PARALLEL}` in the braces of the {}",
            GroupSpec::keywords_with(Modes::Side)
        );
        let reason = "a parallelogram stays one in every pose, and nothing is left to choose";
        scope.diagnostics.error_because(default.span, message, reason);
        return None;
    }
    if kind.is_none() && !default.is_mistake() {
        let message = "a mode is `left`, `right`, `ahead`, `behind`, `rising` or `falling`";
        let [side, sense] = [Modes::Side, Modes::Sense].map(GroupSpec::keywords_with);
        let reason = format!(
            "`left` or `right` for an {side}, `ahead` or `behind` for {sense}, `rising` or \
             `falling` for `solve`"
        );
        scope.diagnostics.error_because(default.span, message, reason);
    }
    kind
}
