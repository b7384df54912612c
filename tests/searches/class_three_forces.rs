//! Forces in machines of class III from links and joints: Newton's and Euler's equations of all bodies at once, which
//! know no groups, and no bar that was left out.

use std::collections::HashMap;

use linkage_core::{Record, SolveError, Tracker};
use linkage_tests::random::cases;
use num_dual::Dual64;

use super::class_three::{EightBar1, EightBar1Forces, EightBar2};

type Vector = [f64; 2];
/// Places with their velocities and accelerations.
type Moving = HashMap<&'static str, [Vector; 3]>;

/// A machine by its bodies.
struct Bodies {
    ground: &'static [(&'static str, Vector)],
    links: &'static [(usize, &'static [&'static str])],
    driven: usize,
    /// The link that a couple of 5 N·m acts on.
    torque: usize,
}

const FIRST: Bodies = Bodies {
    ground: &[("p01", [0.789, 0.304]), ("p17", [0.603, 0.18])],
    links: &[
        (0, &["p01", "p05"]),
        (2, &["p25", "p27"]),
        (3, &["p36", "p37"]),
        (4, &["p46", "p47"]),
        (5, &["p05", "p25", "p56"]),
        (6, &["p36", "p46", "p56"]),
        (7, &["p17", "p27", "p37", "p47"]),
    ],
    driven: 7,
    torque: 4,
};

const SECOND: Bodies = Bodies {
    ground: &[("p37", [0.06, 0.401]), ("p47", [0.205, 0.007]), ("p57", [0.209, 0.442])],
    links: &[
        (0, &["p01", "p04"]),
        (1, &["p01", "p15"]),
        (2, &["p24", "p26"]),
        (3, &["p36", "p37"]),
        (4, &["p47", "p04", "p24"]),
        (5, &["p15", "p56", "p57"]),
        (6, &["p26", "p36", "p56"]),
    ],
    driven: 4,
    torque: 0,
};

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

impl Bodies {
    /// The pins with their rates, from the numbers of a motion by their labels.
    fn moving(&self, orders: [HashMap<&'static str, f64>; 3]) -> Moving {
        let names = self.links.iter().flat_map(|(_, pins)| pins.iter().copied());
        let point = |pin: &'static str| {
            if let Some((_, at)) = self.ground.iter().find(|(known, _)| *known == pin) {
                return (pin, [*at, [0.0; 2], [0.0; 2]]);
            }
            let axis = |order: &HashMap<&'static str, f64>, axis: &str| {
                let found = order
                    .iter()
                    .find(|(label, _)| label.rsplit(' ').next() == Some(&format!("{pin}.{axis}")));
                *found.unwrap_or_else(|| panic!("no {pin}: {order:?}")).1
            };
            (pin, orders.each_ref().map(|order| [axis(order, "x"), axis(order, "y")]))
        };
        names.map(point).collect()
    }

    /// The pins with the links through each: two numbers a joint between two links.
    fn joints(&self) -> Vec<(&'static str, Vec<usize>)> {
        let mut joints: Vec<(&str, Vec<usize>)> = Vec::new();
        for (link, pins) in self.links {
            for pin in *pins {
                match joints.iter_mut().find(|(known, _)| known == pin) {
                    Some((_, links)) => links.push(*link),
                    None => joints.push((pin, vec![*link])),
                }
            }
        }
        joints
    }

    /// The centre of a link, and the force and the couple about it that its joints and its drive have to exert.
    fn needed(&self, link: usize, pins: &[&str], moving: &Moving) -> (Vector, [f64; 3]) {
        let [[p, v, a], [q, w, b]] = [pins[0], pins[1]].map(|pin| moving[pin]);
        let d = minus(q, p);
        let square = d[0] * d[0] + d[1] * d[1];
        let omega = cross(d, minus(w, v)) / square;
        let alpha = cross(d, minus(b, a)) / square;
        let u = [d[0] / square.sqrt(), d[1] / square.sqrt()];
        let (x, y) = (0.05 * (link as f64 + 1.0), -0.04);
        let r = [x * u[0] - y * u[1], x * u[1] + y * u[0]];
        let accel = [0, 1].map(|axis| {
            let normal = [-r[1], r[0]];
            a[axis] + alpha * normal[axis] - omega * omega * r[axis]
        });
        let (mass, inertia) = (1.0 + 0.3 * link as f64, 0.02);
        let mut needed = [mass * (accel[0] - 0.7), mass * (accel[1] + 9.81), inertia * alpha];
        if self.torque == link {
            needed[2] -= 5.0;
        }
        if link == 5 {
            // A force of 20 N and −15 N at (0.2, 0.1).
            let t = [0.2 * u[0] - 0.1 * u[1], 0.2 * u[1] + 0.1 * u[0]];
            let force = [20.0, -15.0];
            let moment = cross(minus(t, r), force);
            needed = [needed[0] - force[0], needed[1] - force[1], needed[2] - moment];
        }
        ([p[0] + r[0], p[1] + r[1]], needed)
    }

    /// The force of each pin on each of its links, and the driving couple, by the names that solvers give them.
    fn by_newton(&self, moving: &Moving) -> HashMap<String, f64> {
        let joints = self.joints();
        let count = 2 * joints.len() + 1;
        assert_eq!(count, 3 * self.links.len());
        let mut rows = vec![vec![0.0; count + 1]; count];
        for (nth, (link, pins)) in self.links.iter().enumerate() {
            let (centre, needed) = self.needed(*link, pins, moving);
            for (column, (pin, links)) in joints.iter().enumerate() {
                let Some(place) = links.iter().position(|own| own == link) else { continue };
                let arm = minus(moving[pin][0], centre);
                let sign = if place == 0 { 1.0 } else { -1.0 };
                rows[3 * nth][2 * column] = sign;
                rows[3 * nth + 1][2 * column + 1] = sign;
                rows[3 * nth + 2][2 * column] = -sign * arm[1];
                rows[3 * nth + 2][2 * column + 1] = sign * arm[0];
            }
            if *link == self.driven {
                rows[3 * nth + 2][count - 1] = 1.0;
            }
            for (row, needed) in needed.into_iter().enumerate() {
                rows[3 * nth + row][count] = needed;
            }
        }
        self.named(&solved(rows))
    }

    /// The forces of a solution by their names.
    fn named(&self, solution: &[f64]) -> HashMap<String, f64> {
        let drive = solution[solution.len() - 1];
        let mut found = HashMap::from([
            ("theta.drive".to_string(), drive),
            (format!("l{}.drive", self.driven), drive),
        ]);
        for (column, (pin, links)) in self.joints().iter().enumerate() {
            for (place, link) in links.iter().enumerate() {
                let sign = if place == 0 { 1.0 } else { -1.0 };
                for (axis, name) in ["x", "y"].into_iter().enumerate() {
                    found.insert(
                        format!("l{link}.{pin}.{name}"),
                        sign * solution[2 * column + axis],
                    );
                }
            }
        }
        found
    }

    /// The most by which each force can differ, to first order, where every place and rate is off by this.
    fn spread(&self, moving: &Moving, off: &Moving) -> HashMap<String, f64> {
        let truth = self.by_newton(moving);
        let mut spread: HashMap<_, _> = truth.keys().map(|name| (name.clone(), 0.0)).collect();
        for (pin, orders) in off {
            for (order, axis) in (0..3).flat_map(|order| [(order, 0), (order, 1)]) {
                let mut moved = moving.clone();
                moved.get_mut(pin).expect("a pin")[order][axis] += orders[order][axis];
                for (name, value) in self.by_newton(&moved) {
                    *spread.get_mut(&name).expect("the same forces") +=
                        (value - truth[&name]).abs();
                }
            }
        }
        spread
    }
}

/// The differences between the places and rates of one motion in two precisions, and the roundings from these to forces.
fn off(wide: &Moving, narrow: &Moving) -> Moving {
    // A force is made of a dozen products of such numbers, one after the other, each off by half a unit.
    const UNITS: f64 = 6.0;
    let largest = |order: usize| {
        let of = |orders: &[Vector; 3]| orders[order][0].hypot(orders[order][1]);
        wide.values().map(of).fold(0.0, f64::max)
    };
    let rounding = [0, 1, 2].map(|order| UNITS * f64::from(f32::EPSILON) * largest(order));
    let of_pin = |(pin, orders): (&&'static str, &[Vector; 3])| {
        let differences = [0, 1, 2].map(|order| {
            [0, 1].map(|axis| {
                (orders[order][axis] - narrow[pin][order][axis]).abs() + rounding[order]
            })
        });
        (*pin, differences)
    };
    wide.iter().map(of_pin).collect()
}

/// Gauss's elimination with the largest pivot of each column.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs()));
        rows.swap(k, pivot.expect("rows are left"));
        for row in k + 1..n {
            let factor = rows[row][k] / rows[k][k];
            let (above, below) = rows.split_at_mut(row);
            for (value, top) in below[0][k..].iter_mut().zip(&above[k][k..]) {
                *value -= factor * top;
            }
        }
    }
    let mut solution = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|column| rows[k][column] * solution[column]).sum();
        solution[k] = (rows[k][n] - known) / rows[k][k];
    }
    solution
}

fn by_label<R: Record<Number: Into<f64>>>(record: R) -> HashMap<&'static str, f64> {
    R::LABELS.iter().copied().zip(record.into_array().into_iter().map(Into::into)).collect()
}

/// The largest difference over the largest force. All of one are in the other.
fn apart(found: &HashMap<&'static str, f64>, truth: &HashMap<String, f64>) -> f64 {
    let largest = truth.values().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let all = truth.keys().map(|name| (name.clone(), largest)).collect();
    apart_by(found, truth, &all)
}

/// The largest difference as a part of what each force may differ by.
fn apart_by(
    found: &HashMap<&'static str, f64>,
    truth: &HashMap<String, f64>,
    spread: &HashMap<String, f64>,
) -> f64 {
    assert_eq!(found.len(), truth.len(), "{found:?} {truth:?}");
    let off = |(label, value): (&&str, &f64)| (value - truth[*label]).abs() / spread[*label];
    found.iter().map(off).fold(0.0, f64::max)
}

/// Poses of the machine's text, each with rates.
fn states(name: &str) -> impl Iterator<Item = [f64; 3]> {
    let poses = include_str!("class_three.txt").lines().filter_map(move |line| {
        let mut words = line.split(' ');
        (words.next() == Some(name)).then(|| words.next()?.parse::<f64>().ok()).flatten()
    });
    poses.zip(0..).map(|(at, index)| [at, 1.3 - 0.2 * f64::from(index), 0.7])
}

/// The numbers of a motion by their labels.
macro_rules! orders {
    ($motion:expr) => {{
        let m = $motion.expect("it has a pose");
        [by_label(m.position), by_label(m.velocity), by_label(m.acceleration)]
    }};
}

macro_rules! compare {
    ($machine:ident, $name:literal, $bodies:expr) => {{
        let (machine, single) = ($machine::new(), $machine::<f32>::default());
        let (mut poses, mut worst) = (0, [0.0_f64; 3]);
        for [at, rate, accel] in states($name) {
            let Ok(m) = machine.motion(at, rate, accel) else { continue };
            let moving = $bodies.moving(orders!(Ok::<_, SolveError>(m)));
            let truth = $bodies.by_newton(&moving);
            let f = machine.forces(at, rate, accel).expect("it has a pose");
            worst[0] = worst[0].max(apart(&by_label(f), &truth));
            let narrow = [at, rate, accel].map(|value| value as f32);
            // In single precision another pose: compared where the angle is one of both.
            let wide = narrow.map(f64::from);
            let [m, n] = [
                orders!(machine.motion(wide[0], wide[1], wide[2])),
                orders!(single.motion(narrow[0], narrow[1], narrow[2])),
            ]
            .map(|orders| $bodies.moving(orders));
            let f = single.forces(narrow[0], narrow[1], narrow[2]).expect("a pose");
            let (truth, spread) = ($bodies.by_newton(&m), $bodies.spread(&m, &off(&m, &n)));
            worst[1] = worst[1].max(apart_by(&by_label(f), &truth, &spread));
            // Held still, gravity and what acts are all there is.
            let still = moving.iter().map(|(pin, [at, ..])| (*pin, [*at, [0.0; 2], [0.0; 2]]));
            let truth = $bodies.by_newton(&still.collect());
            let f = machine.statics(at).expect("it has a pose");
            worst[2] = worst[2].max(apart(&by_label(f), &truth));
            poses += 1;
        }
        println!("{}: {poses} poses, apart by {worst:?}", $name);
        (poses, worst)
    }};
}

#[test]
fn forces_over_the_whole_motion_are_those_of_newton_on_all_bodies() {
    for (poses, [double, single, still]) in
        [compare!(EightBar1, "EightBar1", FIRST), compare!(EightBar2, "EightBar2", SECOND)]
    {
        assert!(poses >= 12, "{poses}");
        // Places are off by 1e-13 of the machine's size at most, which is Newton's as well as the solver's.
        assert!(double < 1e-12 && still < 1e-12, "{double} {still}");
        // As far as single precision has the places and rates off that the forces are made of.
        assert!(single < 1.0, "{single}");
    }
}

/// The forces of a solver that a tracker has brought to the pose, and how they change with the angle: at the
/// first poses of those of `.ci/nightly`.
#[test]
fn a_tracker_and_dual_numbers_know_the_forces() {
    let machine = EightBar1::new();
    let newton = |at: f64| FIRST.by_newton(&FIRST.moving(orders!(machine.motion(at, 0.9, 0.7))));
    let mut tracker = Tracker::new(machine);
    let mut poses = 0;
    for [at, ..] in states("EightBar1").take(cases(5, usize::MAX)) {
        let Ok(m) = tracker.motion(at, 0.9, 0.7) else { continue };
        let truth = FIRST.by_newton(&FIRST.moving(orders!(Ok::<_, SolveError>(m))));
        let f = tracker.solver().forces(at, 0.9, 0.7).expect("it has a pose");
        assert!(apart(&by_label(f), &truth) < 1e-12, "{at}");
        poses += 1;
        let dual = |value: f64, eps: f64| Dual64::new(value, eps);
        let lifted = machine.lift::<Dual64>();
        let f = lifted.forces(dual(at, 1.0), dual(0.9, 0.0), dual(0.7, 0.0)).expect("a pose");
        let labels = <EightBar1Forces<Dual64> as Record>::LABELS;
        // Differences over h are off by h² and by ε/h of the forces, which grow with the slope.
        const H: f64 = 1e-5;
        let [before, behind] = [newton(at - H), newton(at + H)];
        let slope = |label: &str| (behind[label] - before[label]) / (2.0 * H);
        let steepest =
            labels.iter().fold(1.0, |largest: f64, label| largest.max(slope(label).abs()));
        for (label, value) in labels.iter().zip(f.into_array()) {
            let off = (value.eps - slope(label)).abs() / steepest;
            assert!(off < 1e-5, "{label} at {at}: {} and not {}", value.eps, slope(label));
        }
    }
    assert!(poses >= cases(5, 12), "{poses}");
}
