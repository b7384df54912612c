//! Draws the mechanisms on which the programs of this package measure, each kind from a fixed seed, and writes them
//! as tables that the programs include:
//!
//! - `bars.rs` and `machines.rs` for `against_hand`: twenty four-bars and ten six-bars, their dimensions, points,
//!   modes and outputs, and ten machines with sliding joints or two inputs;
//! - `twins.rs` for `errors`, mechanisms of one group or two;
//! - `edges.rs` for `edges`.
//!
//! Every crank of the thirty turns fully, and no dyad comes nearer to its limit than a transmission angle of
//! 25°, as a designer would have it. Half of the rockers stand on the crank's x axis.

mod edges;
mod machines;
#[allow(unreachable_pub, reason = "the tests share it")]
#[path = "../../../tests/src/random.rs"]
mod random;
mod twins;

use std::path::Path;
use std::{env, fs};

use random::Random;

/// One of the machines, in m.
struct FourBar {
    crank: f64,
    pivot: [f64; 2],
    lengths: [f64; 2],
    is_left: bool,
    point: [f64; 2],
}

/// The dyad on it, as (joints, lengths, mode), and the points Q and F.
struct Second {
    joints: [&'static str; 2],
    q: [f64; 2],
    f: [f64; 2],
    lengths: [f64; 2],
    is_left: bool,
}

fn main() {
    println!("cargo::rerun-if-changed=build");
    println!("cargo::rerun-if-changed=../../tests/src/random.rs");
    let folder = env::var_os("OUT_DIR").expect("cargo sets it");
    let tables = [
        ("bars.rs", bars_table()),
        ("machines.rs", machines::table()),
        ("twins.rs", twins::table()),
        ("edges.rs", edges::table()),
    ];
    for (name, table) in tables {
        fs::write(Path::new(&folder).join(name), table).expect("the folder can be written");
    }
}

/// Twenty four-bars and ten six-bars.
fn bars_table() -> String {
    let mut random = Random::new(20);
    let (mut rows, mut names) = (String::new(), Vec::new());
    for index in 1..=30 {
        let (name, machine, second) = if index <= 20 {
            (format!("four_bar_{index:02}"), four_bar(&mut random), None)
        } else {
            let (machine, second) = six_bar(&mut random, index % 3);
            (format!("six_bar_{:02}", index - 20), machine, Some(second))
        };
        rows += &row(&mut random, &name, &machine, second.as_ref());
        names.push(name);
    }
    rows + &every("bars", &names)
}

/// The call of the macro that gathers a table.
fn every(table: &str, names: &[impl AsRef<str>]) -> String {
    let names: Vec<_> = names.iter().map(AsRef::as_ref).collect();
    format!("every! {{ {table}: {} }}\n", names.join(" "))
}

/// A number of millimetres.
fn length(random: &mut Random, low: f64, high: f64) -> f64 {
    (random.between(low, high) * 1000.0).round() / 1000.0
}

fn is(random: &mut Random) -> bool {
    random.between(0.0, 1.0) < 0.5
}

fn four_bar(random: &mut Random) -> FourBar {
    loop {
        let crank = length(random, 0.03, 0.15);
        let x = length(random, 0.15, 0.5);
        let y = if is(random) { 0.0 } else { length(random, 0.02, 0.2) };
        let machine = FourBar {
            crank,
            pivot: [x, y],
            lengths: [0; 2].map(|_| length(random, 0.1, 0.5)),
            is_left: is(random),
            point: [length(random, 0.02, 0.3), length(random, -0.15, 0.15)],
        };
        if turn().all(|angle| machine.moved(angle).is_some()) {
            return machine;
        }
    }
}

fn six_bar(random: &mut Random, family: usize) -> (FourBar, Second) {
    let joints = [["P", "F"], ["Q", "F"], ["P", "Q"]][family];
    loop {
        let machine = four_bar(random);
        let second = Second {
            joints,
            q: [length(random, 0.02, 0.3), length(random, -0.15, 0.15)],
            f: [length(random, 0.1, 0.7), length(random, -0.3, 0.3)],
            lengths: [0; 2].map(|_| length(random, 0.1, 0.5)),
            is_left: is(random),
        };
        if turn().all(|angle| second.stands(&machine, angle)) {
            return (machine, second);
        }
    }
}

fn turn() -> impl Iterator<Item = f64> {
    (0..360).map(|degree| f64::from(degree).to_radians())
}

/// The vectors of the bars from a to the pin and from b to it.
fn bars(a: [f64; 2], b: [f64; 2], [l, m]: [f64; 2], is_left: bool) -> Option<[[f64; 2]; 2]> {
    let d = [b[0] - a[0], b[1] - a[1]];
    let square = d[0] * d[0] + d[1] * d[1];
    let cosine = (l * l + m * m - square) / (2.0 * l * m);
    // The angle between the bars is from 25° to 155°.
    if cosine.abs() > 25_f64.to_radians().cos() {
        return None;
    }
    let sine = (1.0 - cosine * cosine).sqrt() * if is_left { 1.0 } else { -1.0 };
    let (along, aside) = ((square + l * l - m * m) / (2.0 * square), l * m * sine / square);
    let r = [along * d[0] - aside * d[1], along * d[1] + aside * d[0]];
    Some([r, [r[0] - d[0], r[1] - d[1]]])
}

/// The point (u, v) of the bar r from its joint.
fn on(joint: [f64; 2], r: [f64; 2], length: f64, [u, v]: [f64; 2]) -> [f64; 2] {
    let [u, v] = [u / length, v / length];
    [joint[0] + u * r[0] - v * r[1], joint[1] + u * r[1] + v * r[0]]
}

impl FourBar {
    /// The crank's pin and the bars.
    fn moved(&self, angle: f64) -> Option<([f64; 2], [[f64; 2]; 2])> {
        let b = [self.crank * angle.cos(), self.crank * angle.sin()];
        Some((b, bars(b, self.pivot, self.lengths, self.is_left)?))
    }
}

impl Second {
    fn stands(&self, machine: &FourBar, angle: f64) -> bool {
        let Some((b, [r2, r3])) = machine.moved(angle) else { return false };
        let place = |name| match name {
            "P" => on(b, r2, machine.lengths[0], machine.point),
            "Q" => on(machine.pivot, r3, machine.lengths[1], self.q),
            _ => self.f,
        };
        let [from, to] = self.joints.map(place);
        bars(from, to, self.lengths, self.is_left).is_some()
    }
}

/// Some of the names, at least one.
fn some<'n>(random: &mut Random, names: &[&'n str]) -> Vec<&'n str> {
    loop {
        let chosen: Vec<_> = names.iter().copied().filter(|_| is(random)).collect();
        if !chosen.is_empty() {
            return chosen;
        }
    }
}

fn mode(is_left: bool) -> &'static str {
    if is_left { "left" } else { "right" }
}

fn row(random: &mut Random, name: &str, machine: &FourBar, second: Option<&Second>) -> String {
    let FourBar { crank, pivot: [gx, gy], lengths: [l2, l3], is_left, point: [u, v] } = machine;
    let mut row = format!("drawn! {{ {name}: crank {crank:?}, D({gx:?}, {gy:?}), ");
    row += &format!("lengths {l2:?} {l3:?} {}, P({u:?}, {v:?}), ", mode(*is_left));
    // A six-bar always has an output of its second loop.
    let (mut points, mut links) = (vec!["C", "P"], vec!["BC", "DC"]);
    let mut asked = Vec::new();
    if let Some(Second { joints: [from, to], q, f, lengths: [l4, l5], is_left }) = second {
        row += &format!("Q({:?}, {:?}), F({:?}, {:?}), ", q[0], q[1], f[0], f[1]);
        row += &format!("second {from} {to} lengths {l4:?} {l5:?} {}, ", mode(*is_left));
        asked.push("E");
        links.extend(["XE", "YE"]);
    }
    points = some(random, &points);
    points.extend(asked);
    links = some(random, &links);
    row + &format!("output [{}] [{}] }}\n", points.join(" "), links.join(" "))
}
