//! The fields of a group, checked against its anatomy.

use proc_macro2::Span;

use crate::diagnostics::nearest;
use crate::syntax::anatomy::{FieldRule, GroupSpec, Needed};
use crate::syntax::tree::{GroupField, GroupFieldValue, GroupStatement};

use crate::model::as_written::text;
use crate::model::names::listed;
use crate::model::parts_of_groups::Fields;
use crate::model::scope::Scope;
use crate::model::{drawn_sliding, modes, uses};

pub(super) fn fields<'t>(
    scope: &mut Scope<'_>,
    group: &'t GroupStatement,
    anatomy: &'static GroupSpec,
) -> Fields<'t> {
    let (known, present) = (Vec::new(), Vec::new());
    let mut fields = Fields { known, present, all_are_read: group.fields_are_read };
    for field in &group.fields {
        let Some(name) = field_exists(scope, field, group, anatomy, &mut fields.present) else {
            continue;
        };
        if fields.present.contains(&name) {
            // A damaged field of this name may have been half of this one.
            if !group.fields.iter().any(|other| other.name == name && is_damaged(other)) {
                let message = format!("the field `{name}` is given twice; remove one");
                scope.diagnostics.error(field.name.span(), message);
            }
            continue;
        }
        fields.present.push(name);
        if field_has_its_shape(scope, field, anatomy).is_some()
            && field_has_its_pin(scope, field, group, anatomy).is_some()
        {
            fields.known.push((name, &field.value));
        }
    }
    if group.fields_are_read {
        no_field_is_missing(scope, group, anatomy, &fields);
    }
    fields
}

/// Reports a field that the group does not have. A misspelt field counts as present, and so does
/// the first missing field where no name is near: neither is reported as missing, too.
fn field_exists(
    scope: &mut Scope<'_>,
    field: &GroupField,
    group: &GroupStatement,
    anatomy: &'static GroupSpec,
    present: &mut Vec<&'static str>,
) -> Option<&'static str> {
    let name = field.name.to_string();
    let names = anatomy.field_names();
    if let Some(known) = names.iter().find(|known| **known == name) {
        return Some(known);
    }
    let keyword = anatomy.keyword;
    let mut message = format!("`{keyword}` has no field `{name}`");
    // A field that is given elsewhere by its right name was not meant here.
    let given = |known: &&str| group.fields.iter().any(|field| field.name == known);
    let free = names.iter().copied().filter(|known| !given(known));
    let reason = if let Some(near) = nearest(&name, free) {
        present.push(near);
        message += &format!("; a field with a similar name exists: `{near}`");
        one_for_two(field, near, anatomy)
    } else if name == "mode" {
        Some(format!("`{keyword}` can be assembled in one way only"))
    } else if is_damaged(field) {
        return None;
    } else if let Some((missing, meaning)) = first_missing(scope, group, anatomy, present) {
        present.push(missing);
        scope.names.use_is_hidden = true;
        Some(format!("what is missing is `{missing}`: {meaning}"))
    } else {
        let names: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
        Some(format!("its fields are {}", listed(&names, "and")))
    };
    uses::report(scope, field.name.span(), message, reason);
    None
}

/// Where two values are given to a field of another name: that it takes one, and what the second may be.
fn one_for_two(field: &GroupField, near: &str, anatomy: &GroupSpec) -> Option<String> {
    let rule = anatomy.fields.iter().find(|rule| rule.name == near && !rule.pair)?;
    let GroupFieldValue::Pair(values) = &field.value else { return None };
    let mut others = anatomy.fields.iter().filter(|rule| rule.name != near && !rule.pair);
    let [first, second] = values.each_ref().map(text);
    Some(match others.next() {
        Some(other) => format!(
            "write `{near}: {first}, {}: {second}`: {} is {}",
            other.name, other.name, other.meaning
        ),
        None => format!("it takes one value: {}", rule.meaning),
    })
}

/// A pair is given where there are two links to speak of, one value elsewhere.
fn field_has_its_shape(
    scope: &mut Scope<'_>,
    field: &GroupField,
    anatomy: &GroupSpec,
) -> Option<()> {
    let name = &field.name;
    let rule = anatomy.fields.iter().find(|rule| name == rule.name);
    let pair = rule.is_some_and(|rule| rule.pair);
    match (&field.value, pair) {
        (GroupFieldValue::One(value), _) if value.is_mistake() => return None,
        (GroupFieldValue::One(_), false) | (GroupFieldValue::Pair(_), true) => return Some(()),
        (GroupFieldValue::One(_), true) => {
            let message = format!("`{name}` takes two values; write `{name}: (…, …)`");
            let reason = rule.map_or("", |rule| rule.meaning);
            scope.diagnostics.error_because(name.span(), message, reason);
        }
        (GroupFieldValue::Pair(_), false) => {
            let message = format!("`{name}` takes one value; write `{name}: …`");
            uses::report(scope, name.span(), message, rule.map(|rule| rule.meaning));
        }
    }
    None
}

/// The distance to a pin is given only where there is a pin.
fn field_has_its_pin(
    scope: &mut Scope<'_>,
    field: &GroupField,
    group: &GroupStatement,
    anatomy: &GroupSpec,
) -> Option<()> {
    let rule = anatomy.fields.iter().find(|rule| field.name == rule.name);
    let may_have_pin = group.pin.is_some() || !group.head_is_read;
    if may_have_pin || rule.is_none_or(|rule| rule.needed != Needed::WithPin) {
        return Some(());
    }
    let name = &field.name;
    let message =
        format!("a `{}` without a pin has no `{name}`; name the pin, `-> B`", anatomy.keyword);
    let reason = format!("`{name}` is {}", rule.map_or("", |rule| rule.meaning));
    scope.diagnostics.error_because(name.span(), message, reason);
    None
}

/// Every field without a default is given; a missing one is reported at the closing brace.
fn no_field_is_missing(
    scope: &mut Scope<'_>,
    group: &GroupStatement,
    anatomy: &GroupSpec,
    fields: &Fields,
) {
    for (name, meaning) in needed(scope, group, anatomy) {
        if fields.is_left_out(name) {
            missing(scope, group.end, name, &meaning);
        }
    }
}

/// The fields without a default, and what they say.
fn needed(
    scope: &Scope<'_>,
    group: &GroupStatement,
    anatomy: &GroupSpec,
) -> Vec<(&'static str, String)> {
    let is_needed = |rule: &&FieldRule| match rule.needed {
        Needed::Always => true,
        Needed::WithPin => group.pin.is_some(),
        Needed::Never => false,
    };
    let rules = anatomy.fields.iter().filter(is_needed);
    let mut needed: Vec<_> = rules.map(|rule| (rule.name, rule.meaning.to_string())).collect();
    let is_drawn = drawn_sliding::mode_as_drawn(scope, group).is_some();
    let modes = anatomy.modes.filter(|_| anatomy.mode_is_needed() && !is_drawn);
    needed.extend(modes.map(|modes| ("mode", modes::modes_explained(modes, group))));
    needed
}

/// A field without a default that is not given anywhere in the group.
fn first_missing(
    scope: &Scope<'_>,
    group: &GroupStatement,
    anatomy: &GroupSpec,
    present: &[&'static str],
) -> Option<(&'static str, String)> {
    let given = |name| present.contains(&name) || group.fields.iter().any(|f| f.name == name);
    needed(scope, group, anatomy).into_iter().find(|(name, _)| !given(name))
}

fn missing(scope: &mut Scope<'_>, end: Span, name: &str, meaning: &str) {
    scope.names.use_is_hidden |= name != "mode";
    let message = format!("missing field `{name}`");
    scope.diagnostics.error_because(end, message, meaning);
}

/// True if the value of the field could not be read.
fn is_damaged(field: &GroupField) -> bool {
    matches!(&field.value, GroupFieldValue::One(value) if value.is_mistake())
}
