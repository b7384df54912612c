//! Named sets of inputs, `input hand { x = tool.x, y = tool.y }`: one declaration a set. In it the coordinates of the set
//! are its inputs, and those of the others are outputs.

use proc_macro2::Ident;

use crate::blocks::driven_by;
use crate::diagnostics::{Diagnostics, Extent};
use crate::syntax::tree::{
    Declaration, Expr, ExprKind, InputSetStatement, InputStatement, LetStatement, OutputItem,
    OutputStatement, PinStatement, SetCoordinate, Statement, StatementKind,
};

use crate::model::as_written::text;
use crate::model::driven::coordinate::Coordinate;
use crate::model::references::names_used;
use crate::model::statements::declared_by;

/// A set of inputs, and the declaration in which these are the inputs.
pub(crate) struct DrivenBySet {
    pub set: Ident,
    /// From the name of the set to its last token.
    pub written: Extent,
    pub tree: Declaration,
}

/// The sets of a declaration; none where it has no named sets.
pub(crate) fn drivings(tree: &Declaration, diagnostics: &mut Diagnostics) -> Vec<DrivenBySet> {
    let sets: Vec<_> = sets(tree).collect();
    if sets.is_empty() {
        return Vec::new();
    }
    let reported = diagnostics.count();
    names_differ(tree, &sets, diagnostics);
    let known = Meanings::of(&sets, diagnostics);
    let is_damaged = tree.is_damaged || diagnostics.count() > reported;
    let driving = |set: &&InputSetStatement| {
        let statements = known.statements(tree, set);
        let name = driven_by(&tree.name, &set.name);
        let mut unwritten = tree.unwritten.clone();
        unwritten.set = Some(set.name.clone());
        let tree = Declaration { name, statements, is_damaged, unwritten, ..tree.clone() };
        let own = set.coordinates.last();
        let end = own.map(|last| last.of.as_ref().map_or(last.name.span().into(), |of| of.span));
        let start = Extent::from(set.name.span());
        let written = end.map_or(start, |end| start.to(end));
        DrivenBySet { set: set.name.clone(), written, tree }
    };
    sets.iter().map(driving).collect()
}

fn sets(tree: &Declaration) -> impl Iterator<Item = &InputSetStatement> {
    tree.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::InputSet(set) => Some(set),
        _ => None,
    })
}

/// The functions of the struct of parameters, beside one for each set.
const OF_MACHINES: [&str; 2] = ["new", "page"];

/// Every set has a name of its own, and names each coordinate once, by a name that nothing else has.
fn names_differ(tree: &Declaration, sets: &[&InputSetStatement], diagnostics: &mut Diagnostics) {
    let declared: Vec<_> = tree.statements.iter().flat_map(declared_by).collect();
    for (index, set) in sets.iter().enumerate() {
        if sets[..index]
            .iter()
            .any(|other| driven_by(&tree.name, &other.name) == driven_by(&tree.name, &set.name))
        {
            let message = format!("the name `{}` is taken; choose another", set.name);
            diagnostics.error_because(set.name.span(), message, "another set is called so");
        }
        if OF_MACHINES.iter().any(|taken| set.name == taken) {
            let message = format!("the name `{}` is taken; choose another", set.name);
            let reason = format!("each machine has a function `{}`", set.name);
            diagnostics.error_because(set.name.span(), message, reason);
        }
        for (place, SetCoordinate { name, .. }) in set.coordinates.iter().enumerate() {
            if let Some((_, kind)) = declared.iter().find(|(other, _)| *other == name) {
                let message = format!("the name `{name}` is taken; choose another");
                let reason = format!("`{name}` is {}", kind.one());
                diagnostics.error_because(name.span(), message, reason);
            }
            if set.coordinates[..place].iter().any(|other| other.name == *name) {
                let message = format!("`{name}` is named twice; remove one");
                let reason = format!("`{}` drives it once", set.name);
                diagnostics.error_because(name.span(), message, reason);
            }
        }
    }
}

/// The quantities that coordinates are.
struct Meanings<'t>(Vec<(&'t Ident, &'t Expr)>);

impl<'t> Meanings<'t> {
    /// A coordinate is one quantity, which one of its sets says.
    fn of(sets: &[&'t InputSetStatement], diagnostics: &mut Diagnostics) -> Self {
        let mut known: Vec<(&Ident, &Expr, &Ident)> = Vec::new();
        for set in sets {
            for (place, SetCoordinate { name, of }) in set.coordinates.iter().enumerate() {
                let Some(of) = of else { continue };
                if set.coordinates[..place].iter().any(|other| other.name == *name) {
                    continue;
                }
                match known.iter().find(|(other, ..)| *other == name) {
                    Some((_, same, _)) if text(same) == text(of) => {}
                    Some((_, other, by)) => {
                        let message =
                            format!("`{name}` is `{}` in `{by}`; choose another name", text(other));
                        let reason = "a coordinate of several sets is one quantity";
                        diagnostics.error_because(name.span(), message, reason);
                    }
                    None => known.push((name, of, &set.name)),
                }
            }
        }
        for SetCoordinate { name, of } in sets.iter().flat_map(|set| &set.coordinates) {
            if of.is_none() && !known.iter().any(|(other, ..)| *other == name) {
                let message = format!("say what `{name}` is: `{name} = tool.x`");
                let reason = "one of the sets that a coordinate is in says what it is";
                diagnostics.error_because(name.span(), message, reason);
            }
        }
        Self(known.into_iter().map(|(name, of, _)| (name, of)).collect())
    }

    fn meaning(&self, name: &Ident) -> Option<&'t Expr> {
        self.0.iter().find(|(known, _)| *known == name).map(|(_, of)| *of)
    }

    /// The statements of the declaration that a set drives.
    fn statements(&self, tree: &Declaration, set: &InputSetStatement) -> Vec<Statement> {
        let is_own = |name: &Ident| set.coordinates.iter().any(|own| own.name == *name);
        let mut statements = Vec::new();
        for statement in &tree.statements {
            let kind = match &statement.kind {
                StatementKind::InputSet(other) if std::ptr::eq(other, set) => self.inputs(other),
                StatementKind::InputSet(_) => continue,
                StatementKind::Output(output) => {
                    // The effort of an input is known where it is one.
                    let is_known = |item: &&OutputItem| match &item.value.kind {
                        ExprKind::Member(name, member) if member == "drive" => {
                            is_own(name) || self.meaning(name).is_none()
                        }
                        _ => true,
                    };
                    let items = output.items.iter().filter(is_known).cloned().collect();
                    StatementKind::Output(OutputStatement { items, ..output.clone() })
                }
                kind => kind.clone(),
            };
            statements.push(Statement { docs: statement.docs.clone(), kind });
        }
        let others = self.others(tree, is_own);
        let lets = others.iter().filter(|(name, _)| is_used(tree, name));
        statements.extend(lets.map(|(name, of)| {
            let kind = LetStatement { name: (*name).clone(), value: (*of).clone() };
            Statement { docs: Vec::new(), kind: StatementKind::Let(kind) }
        }));
        let items = beside(tree, &others);
        let kind = StatementKind::Output(OutputStatement { items, is_beside: true });
        statements.push(Statement { docs: Vec::new(), kind });
        statements
    }

    /// The coordinates of the other sets that are quantities of what is declared.
    fn others(
        &self,
        tree: &Declaration,
        is_own: impl Fn(&Ident) -> bool,
    ) -> Vec<(&'t Ident, &'t Expr)> {
        let declared: Vec<_> = tree.statements.iter().flat_map(declared_by).collect();
        let is_known = |(name, of): &(&Ident, &Expr)| {
            let mut is_declared = true;
            of.each_name(&mut |used| {
                is_declared &= declared.iter().any(|(name, _)| *name == used);
            });
            is_declared && !is_own(name) && Coordinate::of(name, of).is_some()
        };
        self.0.iter().copied().filter(is_known).collect()
    }

    /// The inputs of a set with their quantities, those that another set says at their names here.
    fn inputs(&self, set: &InputSetStatement) -> StatementKind {
        let (mut names, mut of): (Vec<Ident>, Vec<Expr>) = (Vec::new(), Vec::new());
        for SetCoordinate { name, of: own } in &set.coordinates {
            if names.contains(name) {
                continue;
            }
            let elsewhere = || {
                let meaning = self.meaning(name)?.clone();
                Some(Expr { span: name.span().into(), ..meaning })
            };
            let meaning = own.clone().or_else(elsewhere);
            names.push(name.clone());
            of.push(meaning.unwrap_or_else(|| Expr::mistake(name.span())));
        }
        StatementKind::Input(InputStatement { names, kind: None, of })
    }
}

/// True if a statement that all sets share reads a coordinate by its name.
fn is_used(tree: &Declaration, name: &Ident) -> bool {
    tree.statements.iter().any(|statement| match &statement.kind {
        StatementKind::Output(output) => output.items.iter().any(|item| {
            let mut is_used = false;
            item.value.each_part(&mut |part| {
                is_used |= matches!(&part.kind, ExprKind::Name(used) if used == name);
            });
            is_used
        }),
        _ => names_used(statement).contains(name),
    })
}

/// The results beside those that are asked for: the coordinates of the other sets, and the pins by which the sides of
/// their groups are told.
fn beside(tree: &Declaration, others: &[(&Ident, &Expr)]) -> Vec<OutputItem> {
    let bare = |name: &Ident| Expr { kind: ExprKind::Name(name.clone()), span: name.span().into() };
    let item = |(name, of): &(&Ident, &Expr)| match is_used(tree, name) {
        true => OutputItem { name: None, renamed_at: None, value: bare(name) },
        false => OutputItem { name: Some((*name).clone()), renamed_at: None, value: (*of).clone() },
    };
    let mut items: Vec<_> = others.iter().map(item).collect();
    let is_output = |statement: &Statement| matches!(statement.kind, StatementKind::Output(_));
    if !tree.statements.iter().any(is_output) {
        return items;
    }
    for statement in &tree.statements {
        let StatementKind::Pin(PinStatement { points }) = &statement.kind else { continue };
        let pins = points.iter().map(|(pin, _)| bare(pin));
        items.extend(pins.map(|value| OutputItem { name: None, renamed_at: None, value }));
    }
    items
}
