//! All kinematic chains of eight links and ten joints with one freedom, each with every link as the
//! ground and every joint driven.
//!
//! A chain is a graph, its links the vertices and its joints the edges, in which no part is rigid:
//! 3 (n − 1) − 2 j ≥ 1 for any links n ≥ 2 with j joints between them. There are sixteen (Freudenstein
//! and Maki 1979, among many).

use super::variants::Random;

const LINKS: usize = 8;
/// The counts of joints of the links, which sum to twice ten.
const ASSORTMENTS: [[u32; LINKS]; 3] =
    [[3, 3, 3, 3, 2, 2, 2, 2], [4, 3, 3, 2, 2, 2, 2, 2], [4, 4, 2, 2, 2, 2, 2, 2]];

/// The joints of a chain, by pairs of links.
pub(crate) type Joints = Vec<[usize; 2]>;

fn pairs() -> impl Iterator<Item = [usize; 2]> {
    (0..LINKS).flat_map(|b| (0..b).map(move |a| [a, b]))
}

/// Joints as a set of bits.
fn bits(joints: impl IntoIterator<Item = [usize; 2]>) -> u32 {
    let bit = |[a, b]: [usize; 2]| {
        let (a, b) = (a.min(b), a.max(b));
        1 << (b * (b - 1) / 2 + a)
    };
    joints.into_iter().map(bit).sum()
}

/// True if no part of a chain is rigid.
fn moves(joints: &[[usize; 2]]) -> bool {
    (0..1_u32 << LINKS).filter(|part| part.count_ones() > 1 && part.count_ones() < 8).all(|part| {
        let has = |link: usize| part >> link & 1 == 1;
        let between = joints.iter().filter(|[a, b]| has(*a) && has(*b)).count() as u32;
        3 * (part.count_ones() - 1) > 2 * between
    })
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

fn renamed(joints: &[[usize; 2]], order: &[usize; LINKS]) -> Joints {
    joints.iter().map(|[a, b]| [order[*a], order[*b]]).collect()
}

/// All chains with these counts of joints, one of each kind.
fn chains(counts: &[u32; LINKS], orders: &[[usize; LINKS]]) -> Vec<Joints> {
    let mut seen = std::collections::HashSet::new();
    let mut found = Vec::new();
    let all: Vec<_> = pairs().collect();
    let mut open = vec![(0, Joints::new())];
    while let Some((next, joints)) = open.pop() {
        let count =
            |link: usize| joints.iter().filter(|joint| joint.contains(&link)).count() as u32;
        if (0..LINKS).any(|link| count(link) > counts[link]) {
            continue;
        }
        let Some(&pair) = all.get(next) else {
            let is_full = (0..LINKS).all(|link| count(link) == counts[link]);
            if is_full && !seen.contains(&bits(joints.iter().copied())) && moves(&joints) {
                seen.extend(orders.iter().map(|order| bits(renamed(&joints, order))));
                found.push(joints);
            }
            continue;
        };
        // The larger link of a pair comes last: the joints of those behind are still open.
        let left = |link: usize| all[next..].iter().filter(|pair| pair.contains(&link)).count();
        if (0..LINKS).any(|link| count(link) + (left(link) as u32) < counts[link]) {
            continue;
        }
        open.push((next + 1, joints.clone()));
        open.push((next + 1, [&joints[..], &[pair]].concat()));
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

/// Every chain with every ground and every driven joint, one of each kind.
pub(crate) fn all() -> Vec<Driven> {
    let mut found = Vec::new();
    for counts in ASSORTMENTS {
        let orders = orders(&counts);
        for joints in chains(&counts, &orders) {
            let all = bits(joints.iter().copied());
            let same: Vec<_> =
                orders.iter().filter(|order| bits(renamed(&joints, order)) == all).collect();
            let mut seen = Vec::new();
            for ground in 0..LINKS {
                for drive in 0..joints.len() {
                    let joint = bits([joints[drive]]);
                    if seen.contains(&(ground, joint)) {
                        continue;
                    }
                    seen.extend(
                        same.iter()
                            .map(|order| (order[ground], bits(renamed(&[joints[drive]], order)))),
                    );
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
