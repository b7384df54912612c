//! All kinematic chains of eight links and ten joints with one freedom, each with every link as the
//! ground and every joint driven.
//!
//! A chain is a graph, its links the vertices and its joints the edges, in which no part is rigid:
//! 3 (n − 1) − 2 j ≥ 1 for any links n ≥ 2 with j joints between them. There are sixteen (Freudenstein
//! and Maki 1979, among many).

use std::sync::LazyLock;

use super::variants::Random;

const LINKS: usize = 8;
/// The counts of joints of the links, which sum to twice ten.
const ASSORTMENTS: [[u32; LINKS]; 3] =
    [[3, 3, 3, 3, 2, 2, 2, 2], [4, 3, 3, 2, 2, 2, 2, 2], [4, 4, 2, 2, 2, 2, 2, 2]];

/// The joints of a chain, by pairs of links.
pub(crate) type Joints = Vec<[usize; 2]>;

const PAIRS: usize = LINKS * (LINKS - 1) / 2;

fn pairs() -> impl Iterator<Item = [usize; 2]> {
    (0..LINKS).flat_map(|b| (0..b).map(move |a| [a, b]))
}

/// The place of a pair among all.
fn place([a, b]: [usize; 2]) -> usize {
    let (a, b) = (a.min(b), a.max(b));
    b * (b - 1) / 2 + a
}

/// Joints as a set of bits, by the places of their pairs.
fn bits(joints: impl IntoIterator<Item = [usize; 2]>) -> u32 {
    joints.into_iter().map(|joint| 1 << place(joint)).sum()
}

fn joints(mut bits: u32, pairs: &[[usize; 2]]) -> Joints {
    let mut joints = Joints::new();
    while bits > 0 {
        joints.push(pairs[bits.trailing_zeros() as usize]);
        bits &= bits - 1;
    }
    joints
}

/// For every part of a chain its count of links, and its pairs.
fn parts() -> Vec<(u32, u32)> {
    let parts = (0..1_u32 << LINKS).filter(|part| part.count_ones() > 1 && part.count_ones() < 8);
    let of_part = |part: u32| {
        let is_inside = |&[a, b]: &[usize; 2]| part >> a & part >> b & 1 == 1;
        (part.count_ones(), bits(pairs().filter(is_inside)))
    };
    parts.map(of_part).collect()
}

/// True if no part of a chain is rigid.
fn moves(joints: u32, parts: &[(u32, u32)]) -> bool {
    parts.iter().all(|(links, pairs)| 3 * (links - 1) > 2 * (joints & pairs).count_ones())
}

/// All orders of the links that keep their counts of joints.
fn orders(counts: &[u32; LINKS]) -> Vec<[usize; LINKS]> {
    fn extend(counts: &[u32; LINKS], order: &mut Vec<usize>, all: &mut Vec<[usize; LINKS]>) {
        if let Ok(order) = order[..].try_into() {
            all.push(order);
            return;
        }
        for link in 0..LINKS {
            if counts[link] == counts[order.len()] && !order.contains(&link) {
                order.push(link);
                extend(counts, order, all);
                order.pop();
            }
        }
    }
    let mut all = Vec::new();
    extend(counts, &mut Vec::new(), &mut all);
    all
}

/// The bit that each pair becomes under an order of the links.
type Renaming = [u32; PAIRS];

fn renaming(order: &[usize; LINKS]) -> Renaming {
    let mut renaming = [0; PAIRS];
    for (bit, [a, b]) in renaming.iter_mut().zip(pairs()) {
        *bit = bits([[order[a], order[b]]]);
    }
    renaming
}

fn renamed(mut joints: u32, renaming: &Renaming) -> u32 {
    let mut other = 0;
    while joints > 0 {
        other |= renaming[joints.trailing_zeros() as usize];
        joints &= joints - 1;
    }
    other
}

/// All chains with these counts of joints, one of each kind.
fn chains(counts: &[u32; LINKS], renamings: &[Renaming]) -> Vec<u32> {
    let (pairs, parts) = (pairs().collect::<Vec<_>>(), parts());
    let mut seen = std::collections::HashSet::new();
    let mut found = Vec::new();
    // The next pair, the joints so far, and how many each link is still to have.
    let mut open = vec![(0, 0_u32, *counts)];
    while let Some((next, joints, left)) = open.pop() {
        let Some(&[a, b]) = pairs.get(next) else {
            if left == [0; LINKS] && !seen.contains(&joints) && moves(joints, &parts) {
                seen.extend(renamings.iter().map(|renaming| renamed(joints, renaming)));
                found.push(joints);
            }
            continue;
        };
        // A link meets those before its larger neighbour, and all behind.
        let others = |link: usize| LINKS - if link < b { b + usize::from(link < a) } else { 1 + a };
        if (0..=b).any(|link| left[link] as usize > others(link)) {
            continue;
        }
        open.push((next + 1, joints, left));
        if left[a] > 0 && left[b] > 0 {
            let mut left = left;
            left[a] -= 1;
            left[b] -= 1;
            open.push((next + 1, joints | 1 << next, left));
        }
    }
    found
}

/// A chain with a ground and a joint that is driven.
#[derive(Clone, Debug)]
pub(crate) struct Driven {
    pub joints: Joints,
    pub ground: usize,
    /// The index of the joint.
    pub drive: usize,
}

impl Driven {
    pub(crate) fn is_at_the_ground(&self) -> bool {
        self.joints[self.drive].contains(&self.ground)
    }

    /// The statements of the machine in a drawing of this many thousandths.
    pub(crate) fn statements(&self, places: &[[f64; 2]]) -> String {
        let pin = |joint: usize| format!("P{}{}", self.joints[joint][0], self.joints[joint][1]);
        let placed = |joint: usize| {
            let [x, y] = places[joint];
            format!("{}({x:?}, {y:?})", pin(joint))
        };
        let of = |link: usize| (0..10).filter(move |&joint| self.joints[joint].contains(&link));
        let listed = |names: Vec<String>| names.join(", ");
        let ground = listed(of(self.ground).map(placed).collect());
        let moving = (0..10).filter(|&joint| !self.joints[joint].contains(&self.ground));
        let mut text = format!(
            "input theta: angle;\nground {ground};\npin {};\n",
            listed(moving.map(placed).collect())
        );
        for link in (0..LINKS).filter(|&link| link != self.ground) {
            text += &format!("link L{link}({});\n", listed(of(link).map(pin).collect()));
        }
        let [a, b] = self.joints[self.drive];
        text + &match self.is_at_the_ground() {
            true => format!("drive L{}.angle = theta;", if a == self.ground { b } else { a }),
            false => format!("drive L{a}.angle - L{b}.angle = theta;"),
        }
    }
}

/// Every chain with every ground and every driven joint, one of each kind. Tests run beside each other, and the first
/// makes them for all.
pub(crate) fn all() -> &'static [Driven] {
    static ALL: LazyLock<Vec<Driven>> = LazyLock::new(enumerated);
    &ALL
}

fn enumerated() -> Vec<Driven> {
    let pairs: Vec<_> = pairs().collect();
    let mut found = Vec::new();
    for counts in ASSORTMENTS {
        let orders = orders(&counts);
        let renamings: Vec<_> = orders.iter().map(renaming).collect();
        for chain in chains(&counts, &renamings) {
            let same = orders.iter().zip(&renamings);
            let same: Vec<_> = same.filter(|(_, by)| renamed(chain, by) == chain).collect();
            let joints = joints(chain, &pairs);
            let mut seen = Vec::new();
            for ground in 0..LINKS {
                for drive in 0..joints.len() {
                    let joint = bits([joints[drive]]);
                    if seen.contains(&(ground, joint)) {
                        continue;
                    }
                    seen.extend(same.iter().map(|(order, by)| (order[ground], renamed(joint, by))));
                    found.push(Driven { joints: joints.clone(), ground, drive });
                }
            }
        }
    }
    found
}

/// Random places to three digits.
pub(crate) fn drawing(random: &mut Random) -> Vec<[f64; 2]> {
    (0..10).map(|_| [(); 2].map(|()| random.below(1000) as f64 / 1000.0)).collect()
}
