//! Statements in an order in which each uses only what earlier ones make.

use std::collections::HashMap;

use crate::model::names::declared_by;
use crate::model::references::names_used;
use crate::syntax::tree::Statement;

/// The statements, each behind those that it needs and else as they stand. What stands in a circle
/// keeps its place: that is reported where names are resolved.
pub(super) fn ordered(statements: Vec<Statement>) -> Vec<Statement> {
    let mut makers = HashMap::new();
    for (index, statement) in statements.iter().enumerate() {
        for (name, _) in declared_by(statement) {
            makers.entry(name.to_string()).or_insert(index);
        }
    }
    let needs: Vec<Vec<usize>> = statements
        .iter()
        .enumerate()
        .map(|(index, statement)| {
            let used = names_used(statement).into_iter();
            let made = used.filter_map(|name| makers.get(&name.to_string()).copied());
            made.filter(|&maker| maker != index).collect()
        })
        .collect();
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
