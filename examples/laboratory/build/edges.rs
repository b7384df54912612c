//! Draws the machines of `edges`: a four-bar with a coupler point, the same bars behind a crank so long
//! that some of its turn is out of reach, and a five-bar whose hand is moved over a map.

use crate::random::Random;

#[path = "../src/bin/edges/map.rs"]
mod map;

use map::map;

struct Dyad {
    from: [f64; 2],
    lengths: [f64; 2],
}

impl Dyad {
    /// The clearance of the dyad, as a share of the shorter bar.
    fn clearance(&self, to: [f64; 2]) -> f64 {
        let d = (to[0] - self.from[0]).hypot(to[1] - self.from[1]);
        let [l, m] = self.lengths;
        (l + m - d).min(d - (l - m).abs()) / l.min(m)
    }
}

fn length(random: &mut Random, low: f64, high: f64) -> f64 {
    (random.between(low, high) * 1000.0).round() / 1000.0
}

/// The pins of a crank over a turn.
fn turn(crank: f64) -> impl Iterator<Item = [f64; 2]> {
    (0..360).map(move |degree| {
        let (sin, cos) = f64::from(degree).to_radians().sin_cos();
        [crank * cos, crank * sin]
    })
}

pub(crate) fn table() -> String {
    let mut random = Random::new(43);
    let rows: String = (1..=10).map(|nth| row(&mut random, nth)).collect();
    let names: Vec<_> = (1..=10).map(|nth| format!("drawn_{nth:02}")).collect();
    rows + &format!("machines! {{ named {} }}\n", names.join(" "))
}

fn row(random: &mut Random, nth: usize) -> String {
    let (crank, long, rocker, [l, m]) = loop {
        let crank = length(random, 0.03, 0.15);
        let bars = [length(random, 0.1, 0.5), length(random, 0.1, 0.5)];
        let rocker =
            Dyad { from: [length(random, 0.15, 0.5), length(random, -0.2, 0.2)], lengths: bars };
        let long = length(random, 0.15, 0.6);
        let reached = turn(long).filter(|&pin| rocker.clearance(pin) > 0.0).count();
        if turn(crank).all(|pin| rocker.clearance(pin) > 0.1) && (90..270).contains(&reached) {
            break (crank, long, rocker, bars);
        }
    };
    let point = [length(random, 0.02, 0.3), length(random, -0.15, 0.15)];
    let ([x, y], near, far, arms, pivot) = hand(random);
    format!(
        "machine! {{ drawn_{nth:02}: crank {crank:?}, D({:?}, {:?}), lengths {l:?} {m:?}, \
         P({:?}, {:?}), rise {:?}, long {long:?} D({:?}, {:?}) lengths {l:?} {m:?}, ram {crank:?} {:?}, \
         hand {:?} {:?} {:?} {:?} E({:?}, {:?}), map ({x:?}, {y:?}) {near:?} {far:?} }}\n",
        rocker.from[0],
        rocker.from[1],
        point[0],
        point[1],
        // More than P rises to.
        ((crank + point[0].hypot(point[1])) * 1200.0).round() / 1000.0,
        rocker.from[0],
        rocker.from[1],
        ((crank + l) * 1000.0).round() / 1000.0,
        arms[0][0],
        arms[0][1],
        arms[1][0],
        arms[1][1],
        pivot[0],
        pivot[1],
    )
}

type Hand = ([f64; 2], f64, f64, [[f64; 2]; 2], [f64; 2]);

/// A five-bar: the middle of its map, half the width that is all reached and half that of which 43 % is,
/// its arms and its second pivot.
fn hand(random: &mut Random) -> Hand {
    loop {
        let arms = [0; 2].map(|_| [length(random, 0.2, 0.4), length(random, 0.3, 0.6)]);
        let pivot = [length(random, 0.05, 0.3), length(random, -0.05, 0.05)];
        let middle = [length(random, -0.1, 0.3), length(random, 0.25, 0.6)];
        let dyads =
            [Dyad { from: [0.0; 2], lengths: arms[0] }, Dyad { from: pivot, lengths: arms[1] }];
        let reached = |half| {
            let is_reached = |&at: &[f64; 2]| dyads.iter().all(|arm| arm.clearance(at) > 0.0);
            map(middle, half, 64).filter(is_reached).count() as f64 / 4096.0
        };
        let near = 0.08;
        if reached(near) < 1.0 {
            continue;
        }
        let mut far = (20..3000).map(|step| f64::from(step) / 1000.0);
        if let Some(far) = far.find(|&half| reached(half) < 0.44) {
            return (middle, near, far, arms, pivot);
        }
    }
}
