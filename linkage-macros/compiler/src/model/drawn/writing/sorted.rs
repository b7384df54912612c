//! The items that a drawing became, in an order in which each uses only what earlier ones make.

use std::collections::HashMap;

use proc_macro2::Ident;

use crate::syntax::tree::{ExprKind, Statement};

use crate::model::drawn_links::SlideFound;
use crate::model::items::Item;
use crate::model::names::Kind;
use crate::model::statements::Rules;
use crate::model::statements::made::MadeItem;

/// An item of what a drawing became, before they stand in order.
pub(in crate::model::drawn) struct Written<'t> {
    /// The statement of the drawing behind which it stands.
    pub behind: usize,
    /// The search that it is part of.
    pub search: Option<usize>,
    pub source: Source<'t>,
}

/// The place where an item comes from.
pub(in crate::model::drawn) enum Source<'t> {
    Statement(&'t Statement),
    MadeItem(MadeItem),
}

impl Written<'_> {
    /// True if a search begins with it, which declares what is searched.
    fn begins(&self) -> bool {
        let declared = self.item().rules.declares();
        self.search.is_some() && declared.iter().any(|(_, kind)| *kind == Kind::Unknown)
    }

    pub(in crate::model::drawn) fn item(&self) -> Item<'_> {
        match &self.source {
            Source::Statement(statement) => Item::of(statement),
            Source::MadeItem(made) => Item::made(made),
        }
    }
}

/// The items, each behind those that it needs and else as they stand. What uses a part of a search
/// stands behind its `solve`. What stands in a circle keeps its place: that is reported where names
/// are resolved.
pub(in crate::model::drawn) fn ordered<'t>(
    statements: Vec<Written<'t>>,
    slides: &[SlideFound],
) -> Vec<Written<'t>> {
    let mut makers = HashMap::new();
    for (index, written) in statements.iter().enumerate() {
        for (name, _) in written.item().rules.declares() {
            makers.entry(name.to_string()).or_insert(index);
        }
    }
    let solves = solves_of_searches(&statements);
    let uses: Vec<Vec<usize>> = statements
        .iter()
        .enumerate()
        .map(|(index, written)| {
            let rules = written.item().rules;
            let needed = [rules.names_used(), joints_read(rules, slides)].concat();
            let made = needed.iter().filter_map(|name| makers.get(&name.to_string()).copied());
            made.filter(|&maker| maker != index).collect()
        })
        .collect();
    let parts = parts_of_searches(&statements, &uses);
    let mut needs: Vec<Vec<usize>> = uses
        .iter()
        .enumerate()
        .map(|(index, made)| {
            let own = parts[index];
            let searches = made.iter().filter_map(|&maker| parts[maker]);
            let others = searches.filter(|search| Some(*search) != own);
            let mut solved: Vec<_> =
                others.filter_map(|search| solves.get(&search).copied()).collect();
            // The link that was left out follows its equation, unlike all that the equation reads.
            let is_behind = own
                .and_then(|own| solves.get(&own))
                .filter(|&&solve| solve < index && !reached(&uses, &[solve])[index]);
            solved.extend(is_behind);
            [made.clone(), solved].concat()
        })
        .collect();
    // A search begins when all is there that it stands on.
    for (index, written) in statements.iter().enumerate() {
        if written.begins() {
            let own: Vec<_> =
                (0..statements.len()).filter(|&other| parts[other] == written.search).collect();
            let all: Vec<_> = own.iter().flat_map(|&other| needs[other].clone()).collect();
            needs[index].extend(all.into_iter().filter(|need| !own.contains(need)));
        }
    }
    let mut open: Vec<_> = statements.into_iter().map(Some).collect();
    let mut ordered = Vec::new();
    for _ in 0..open.len() {
        let is_free = |index: &usize| {
            open[*index].is_some() && needs[*index].iter().all(|&need| open[need].is_none())
        };
        let next = (0..open.len()).find(is_free).or_else(|| open.iter().position(Option::is_some));
        ordered.extend(next.and_then(|next| open[next].take()));
    }
    ordered
}

/// By search, the statement that solves it.
fn solves_of_searches(statements: &[Written<'_>]) -> HashMap<usize, usize> {
    let solves = statements.iter().enumerate().filter_map(|(index, written)| {
        // It makes nothing, unlike all else in a search.
        let solves = written.item().rules.declares().is_empty();
        Some((written.search.filter(|_| solves)?, index))
    });
    solves.collect()
}

/// The links by whose joints those slide whose slides an item reads.
fn joints_read(rules: &dyn Rules, slides: &[SlideFound]) -> Vec<Ident> {
    let mut joints = Vec::new();
    rules.each_expression(&mut |expr| {
        expr.each_part(&mut |part| {
            let ExprKind::Member(link, member) = &part.kind else { return };
            let own = slides.iter().filter(|slide| slide.is_first && slide.link == *link);
            joints.extend(own.filter(|_| member == "slide").map(|slide| slide.by.clone()));
        });
    });
    joints
}

/// The search that each statement is a part of: its own, or one that needs the statement and makes what it stands
/// on, like a slot on a link that the unknown drives.
fn parts_of_searches(statements: &[Written<'_>], uses: &[Vec<usize>]) -> Vec<Option<usize>> {
    let mut parts: Vec<_> = statements.iter().map(|written| written.search).collect();
    let searches = statements.iter().filter_map(|written| written.search).max();
    for search in 0..searches.map_or(0, |last| last + 1) {
        let own: Vec<_> = (0..uses.len()).filter(|&index| parts[index] == Some(search)).collect();
        let needed = reached(uses, &own);
        for index in (0..uses.len()).filter(|&index| needed[index]) {
            let stands_on = reached(uses, &[index]);
            if parts[index].is_none() && own.iter().any(|&member| stands_on[member]) {
                parts[index] = Some(search);
            }
        }
    }
    parts
}

/// The statements, and all that they need.
fn reached(uses: &[Vec<usize>], from: &[usize]) -> Vec<bool> {
    let mut reached = vec![false; uses.len()];
    let mut open = from.to_vec();
    while let Some(next) = open.pop() {
        if !std::mem::replace(&mut reached[next], true) {
            open.extend(&uses[next]);
        }
    }
    reached
}
