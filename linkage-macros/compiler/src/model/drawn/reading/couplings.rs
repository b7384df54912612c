//! Couplings that are read the other way round: a gear that its own links move turns what its drive is read from.
//!
//! `drive gear.angle = -2 * pinion.angle;` is an equation between two links. Where all else drives `gear`, it gives
//! `pinion.angle`: half of what drives `gear`, backwards.

use proc_macro2::Ident;

use crate::chain::count;
use crate::chain::machine::Machine;
use crate::diagnostics::Extent;
use crate::syntax::tree::{BinaryOp, Declaration, DriveStatement, Expr, ExprKind, StatementKind};

use crate::model::drawn::reading::framing;
use crate::model::drawn::reading::reader::Reader;
use crate::model::drawn::reading::values::Measured;

/// The most couplings of which all choices are tried.
const TRIED: usize = 6;

/// The declaration with as few couplings as possible turned round, where without that its drives and its freedoms do not
/// match; `None` where they do, or no choice helps.
pub(in crate::model::drawn) fn turned_round(
    tree: &Declaration,
    values: &mut Measured<'_>,
) -> Option<Declaration> {
    let couplings: Vec<_> = (0..tree.statements.len())
        .filter_map(|index| match &tree.statements[index].kind {
            StatementKind::Drive(drive) => Some((index, inverted(tree, drive)?)),
            _ => None,
        })
        .take(TRIED)
        .collect();
    if couplings.is_empty() || are_driven(tree, values) != Some(false) {
        return None;
    }
    let mut choices: Vec<u32> = (1..1 << couplings.len()).collect();
    choices.sort_by_key(|choice| choice.count_ones());
    choices.into_iter().find_map(|choice| {
        let mut other = tree.clone();
        for (place, (index, drive)) in couplings.iter().enumerate() {
            if choice >> place & 1 == 1 {
                other.statements[*index].kind = StatementKind::Drive(drive.clone());
            }
        }
        (are_driven(&other, values) == Some(true)).then_some(other)
    })
}

/// True if drives and freedoms match, and no drive reads what it moves; none where the drawing is in error, which is
/// reported elsewhere.
fn are_driven(tree: &Declaration, values: &mut Measured<'_>) -> Option<bool> {
    let before = values.scope.diagnostics.count();
    let machine = machine(tree, values);
    values.scope.diagnostics.forget_since(before);
    let machine = machine?;
    if !count::troubles(&machine).is_empty() {
        return Some(false);
    }
    let groups = count::groups(&machine);
    Some(machine.drives.iter().all(|drive| {
        let mut own = groups.iter().filter(|group| drive.bodies.iter().any(|b| group.contains(b)));
        own.all(|group| !drive.reads.iter().any(|read| group.contains(read)))
    }))
}

/// The machine that is drawn.
fn machine(tree: &Declaration, values: &mut Measured<'_>) -> Option<Machine> {
    let (mut reader, drives) = Reader::of(tree, values)?;
    let frames = framing::written(&mut reader)?;
    Some(reader.machine(drives, frames)?.machine)
}

/// The drive of the link that another drive reads, where it reads one alone, once, in sums and products. The angle of a
/// link is known up to whole turns: where it would be divided, it has to be what another drive makes it.
fn inverted(tree: &Declaration, drive: &DriveStatement) -> Option<DriveStatement> {
    if reads(&drive.value, &["angle", "slide"]) != 1 {
        return None;
    }
    let span = drive.value.span;
    let member =
        |link: &Ident, of: &Ident| Expr { kind: ExprKind::Member(link.clone(), of.clone()), span };
    let given = match &drive.to {
        Some((to, of)) => {
            let own = member(&drive.link, &drive.member);
            chain(own, BinaryOp::Sub, member(to, of), span)
        }
        None => driven(tree, drive).unwrap_or_else(|| member(&drive.link, &drive.member)),
    };
    let is_divided = is_scaled(&drive.value) && reads(&given, &["angle"]) > 0;
    let turned = if is_divided { None } else { solved(&drive.value, given) };
    let written = Some((drive.link.clone(), drive.member.clone()));
    turned.map(|turned| DriveStatement { written, ..turned })
}

/// The value that another statement gives what a statement drives.
fn driven(tree: &Declaration, drive: &DriveStatement) -> Option<Expr> {
    tree.statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::Drive(DriveStatement { link, member, to: None, value, .. })
            if *link == drive.link
                && *member == drive.member
                && value.span.bytes() != drive.value.span.bytes() =>
        {
            Some(value.clone())
        }
        _ => None,
    })
}

/// True if a link's quantity is multiplied or divided by anything.
fn is_scaled(expr: &Expr) -> bool {
    let mut is_scaled = false;
    expr.each_part(&mut |part| {
        if let ExprKind::Chain(_, rest) = &part.kind
            && matches!(rest[0].0, BinaryOp::Mul | BinaryOp::Div)
        {
            is_scaled |= reads(part, &["angle", "slide"]) > 0;
        }
    });
    is_scaled
}

/// The count of such quantities of links in an expression.
fn reads(expr: &Expr, members: &[&str]) -> usize {
    let is_read = |part: &Expr| matches!(&part.kind, ExprKind::Member(_, of) if members.iter().any(|member| of == member));
    let mut count = 0;
    expr.each_part(&mut |part| count += usize::from(is_read(part)));
    count
}

/// The drive that makes the expression, which holds one quantity of a link, what is given.
fn solved(expr: &Expr, given: Expr) -> Option<DriveStatement> {
    let span = expr.span;
    match &expr.kind {
        ExprKind::Member(link, member) if member == "angle" || member == "slide" => {
            let (link, member) = (link.clone(), member.clone());
            Some(DriveStatement { link, member, to: None, value: given, written: None })
        }
        ExprKind::Negate(inner) => solved(inner, given.negated()),
        ExprKind::Chain(first, rest) => {
            let mut given = given;
            let place =
                rest.iter().position(|(_, operand)| reads(operand, &["angle", "slide"]) == 1);
            for (index, (operator, operand)) in rest.iter().enumerate() {
                if place != Some(index) {
                    given = chain(given, opposite(*operator), operand.clone(), span);
                }
            }
            let Some(index) = place else { return solved(first, given) };
            let first = (**first).clone();
            match rest[index].0 {
                BinaryOp::Add => solved(&rest[index].1, chain(given, BinaryOp::Sub, first, span)),
                BinaryOp::Sub => solved(&rest[index].1, chain(first, BinaryOp::Sub, given, span)),
                BinaryOp::Mul => solved(&rest[index].1, chain(given, BinaryOp::Div, first, span)),
                BinaryOp::Div => None,
            }
        }
        _ => None,
    }
}

fn opposite(operator: BinaryOp) -> BinaryOp {
    match operator {
        BinaryOp::Add => BinaryOp::Sub,
        BinaryOp::Sub => BinaryOp::Add,
        BinaryOp::Mul => BinaryOp::Div,
        BinaryOp::Div => BinaryOp::Mul,
    }
}

fn chain(a: Expr, operator: BinaryOp, b: Expr, span: Extent) -> Expr {
    Expr { kind: ExprKind::Chain(Box::new(a), vec![(operator, b)]), span }
}
