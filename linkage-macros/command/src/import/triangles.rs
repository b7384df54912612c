//! Bars that hold one another: two bars between a link and one more pin are of one piece with it.

use super::drawing::{Drawing, Drive, Link};

/// Makes one link of three bars that are a triangle, and of each link and two bars that hold one more pin on it.
pub(crate) fn join(drawing: &mut Drawing) {
    while let Some([link, first, second]) = triangle(drawing) {
        let remark = format!("`{link}`, `{first}` and `{second}` are a triangle: all are `{link}`");
        drawing.remarks.push(remark);
        drawing.merge(&link, &first);
        drawing.merge(&link, &second);
    }
}

/// A link, and two bars between pins of it and one that it lacks.
fn triangle(drawing: &Drawing) -> Option<[String; 3]> {
    let bars: Vec<&Link> = drawing.links.iter().filter(|link| is_bar(drawing, link)).collect();
    for link in drawing.links.iter().filter(|link| grounds(drawing, link) < 2) {
        let hung: Vec<(&Link, &String)> = bars
            .iter()
            .filter(|bar| bar.id != link.id)
            .filter_map(|bar| match &bar.pins[..] {
                [own, tip] | [tip, own] if link.pins.contains(own) && !link.pins.contains(tip) => {
                    Some((*bar, tip))
                }
                _ => None,
            })
            .collect();
        for (at, (first, tip)) in hung.iter().enumerate() {
            let holds = |(second, other): &&(&Link, &String)| {
                other == tip && second.pins.iter().any(|pin| !first.pins.contains(pin))
            };
            if let Some((second, _)) = hung[at + 1..].iter().find(holds) {
                return Some([&link.id, &first.id, &second.id].map(String::clone));
            }
        }
    }
    None
}

/// True if a link does nothing but keep two pins apart, one of which moves.
fn is_bar(drawing: &Drawing, link: &Link) -> bool {
    let is_driven = drawing.drives.iter().any(|drive| match drive {
        Drive::Angle { link: driven, against } => {
            *driven == link.id || against.as_ref() == Some(&link.id)
        }
        Drive::Slide { link: driven } => *driven == link.id,
        Drive::Input { of, .. } => of.is_of(&link.id),
        Drive::Coupled { of, by, .. } => of.is_of(&link.id) || by.is_of(&link.id),
    });
    let carries = drawing.guides.iter().any(|guide| guide.on.as_ref() == Some(&link.id));
    let is_bare = link.pins.len() == 2 && link.on.is_empty() && !carries && !is_driven;
    is_bare && grounds(drawing, link) < 2
}

/// The count of a link's pins that are on the ground.
fn grounds(drawing: &Drawing, link: &Link) -> usize {
    let is_ground = |pin: &&String| drawing.pin(pin).is_some_and(|pin| pin.is_ground);
    link.pins.iter().filter(is_ground).count()
}
