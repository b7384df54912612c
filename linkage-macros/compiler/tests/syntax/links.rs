//! `pin`, `link` and `drive`: the trees they make, and their mistakes.

use super::*;
use crate::syntax::tree::{DrawnLink, DriveByStatement, LinkStatement, PinStatement};

/// A statement of a drawing.
pub(super) fn drawn(kind: &StatementKind) -> String {
    match kind {
        StatementKind::Pin(PinStatement { points }) => {
            let points = points.iter().map(|(name, at)| format!("{name}{}", pair(at)));
            format!("pin {}", points.collect::<Vec<_>>().join(", "))
        }
        StatementKind::Link(LinkStatement { links, fields: own }) => {
            let links: Vec<_> = links.iter().map(link).collect();
            let own = own.as_ref().map(|own| format!(" {{ {} }}", fields(own)));
            format!("link {}{}", links.join(", "), own.unwrap_or_default())
        }
        StatementKind::Drive(drive) => {
            let to = drive.to.as_ref().map(|(link, member)| format!(" - {link}.{member}"));
            let (link, member, to) = (&drive.link, &drive.member, to.unwrap_or_default());
            format!("drive {link}.{member}{to} = {}", expr(&drive.value))
        }
        StatementKind::DriveBy(DriveByStatement { input, load }) => {
            format!("drive {input} by {load}")
        }
        _ => String::new(),
    }
}

fn link(link: &DrawnLink) -> String {
    let on = match &link.on[..] {
        [] => String::new(),
        on => format!(" on {}", list(on)),
    };
    format!("{}({}){on}", link.name, list(&link.pins))
}
