//! Rice transplanter: two cranks turn at one speed with a phase between them, an RRR group joins
//! them, and the planting bill is rigid on one of its bars. The goal is the bill's path
//! relative to the ground while the machine drives on: narrow and steep in the soil, high enough
//! over the plants that stand.
//!
//! The dimensions are parameters; a random search weighs several goals and improves them from a
//! start by hand.

use std::f64::consts::TAU;

use charts::{BLACK, COLOURS, Curve, GREY, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Double-crank five-bar with a bill, in the frame of the machine, which drives along +x.
    pub struct Transplanter {
        /// Angles of the two cranks.
        input first, second: angle;

        /// Crank lengths.
        param r1 = 60mm;
        param r2 = 60mm;
        /// Bars from the first and from the second crank.
        param l1 = 240mm;
        param l2 = 240mm;
        /// Where the bill's tip is in the frame of the first bar.
        param tip_x = 380mm;
        param tip_y = -60mm;

        ground A(0, 0), D(160mm, 60mm);

        crank AB(A) -> B        { length: r1, angle: first }
        crank DE(D) -> E        { length: r2, angle: second }
        rrr   BC(B), EC(E) -> C { lengths: (l1, l2), mode: right }
        /// Tip of the bill.
        point bill on BC at (tip_x, tip_y);
    }
}

/// Distance between plants, and how deep they stand, in metres.
const SPACING: f64 = 0.16;
const DEPTH: f64 = 0.05;
const STEPS: u32 = 120;

/// A machine and the phase between its cranks.
#[derive(Clone, Copy)]
struct Design {
    linkage: Transplanter,
    phase: f64,
}

/// The criteria for a path.
#[derive(Clone, Copy)]
struct Goals {
    /// Width of the path in the soil: the hole that is torn.
    hole: f64,
    /// Height of the path.
    lift: f64,
    /// The turn of the bill while it is in the soil, in radians.
    tilt: f64,
    /// Height of the soil in the frame of the machine.
    soil: f64,
}

impl Design {
    fn cranks(&self, turn: f64) -> [f64; 2] {
        // The cranks turn clockwise: the bill moves backwards while it is low.
        [-turn, -turn + self.phase]
    }

    /// The tip relative to the ground after `turn` of the cranks, and the bill's direction.
    fn tip(&self, turn: f64) -> Result<([f64; 2], linkage_core::Direction), SolveError> {
        let pose = self.linkage.position(self.cranks(turn))?;
        Ok(([pose.bill.x + SPACING * turn / TAU, pose.bill.y], pose.BC))
    }

    fn goals(&self) -> Result<Goals, SolveError> {
        let mut path = Vec::new();
        for step in 0..STEPS {
            path.push(self.tip(f64::from(step) * TAU / f64::from(STEPS))?);
        }
        let deepest = path.iter().enumerate().min_by(|a, b| a.1.0[1].total_cmp(&b.1.0[1]));
        let (start, low) = deepest.map_or((0, 0.0), |(step, (tip, _))| (step, tip[1]));
        let high = path.iter().map(|(tip, _)| tip[1]).fold(f64::NEG_INFINITY, f64::max);
        let soil = low + DEPTH;
        // From the deepest point both ways, up to the soil; the path goes on over whole turns.
        let (mut left, mut right, mut tilt) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
        for direction in [1, -1] {
            for away in 0..i64::from(STEPS) {
                let step = start as i64 + direction * away;
                let (tip, bill) = path[step.rem_euclid(i64::from(STEPS)) as usize];
                if tip[1] > soil {
                    break;
                }
                let x = tip[0] + SPACING * step.div_euclid(i64::from(STEPS)) as f64;
                (left, right) = (left.min(x), right.max(x));
                tilt = tilt.max(bill.angle_from(path[start].1).abs());
            }
        }
        Ok(Goals { hole: right - left, lift: high - low, tilt, soil })
    }

    /// Less is better: millimetres of hole, of missing lift below 200 mm, degrees of tilt beyond
    /// 10°, and a decimetre of size.
    fn cost(&self) -> f64 {
        let Ok(goals) = self.goals() else { return f64::INFINITY };
        let l = &self.linkage;
        let size = l.r1 + l.r2 + l.l1 + l.l2 + l.tip_x.hypot(l.tip_y);
        goals.hole * 1e3
            + 2.0 * (0.2 - goals.lift).max(0.0) * 1e3
            + 0.5 * (goals.tilt.to_degrees() - 10.0).max(0.0)
            + 10.0 * size
    }

    /// A neighbour, every dimension moved by up to `reach` of itself.
    fn near(&self, reach: f64, random: &mut impl FnMut() -> f64) -> Self {
        let mut moved = |value: f64, least: f64| value + reach * random() * value.abs().max(least);
        let l = &self.linkage;
        let linkage = Transplanter {
            r1: moved(l.r1, 0.01).clamp(0.03, 0.12),
            r2: moved(l.r2, 0.01).clamp(0.03, 0.12),
            l1: moved(l.l1, 0.05).clamp(0.1, 0.4),
            l2: moved(l.l2, 0.05).clamp(0.1, 0.4),
            tip_x: moved(l.tip_x, 0.05).clamp(0.1, 0.6),
            tip_y: moved(l.tip_y, 0.05).clamp(-0.3, 0.3),
        };
        Self { linkage, phase: moved(self.phase, 0.5) }
    }
}

/// Random search with a reach that shrinks; the same in every run.
fn improve(start: Design) -> Design {
    let mut state = 1_u64;
    let mut random = || {
        // Xorshift (Marsaglia), in [−1, 1).
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    let (mut best, mut cost) = (start, start.cost());
    for round in 0..4000 {
        let reach = 0.3 * 0.999_f64.powi(round);
        let other = best.near(reach, &mut random);
        let other_cost = other.cost();
        if other_cost < cost {
            (best, cost) = (other, other_cost);
        }
    }
    best
}

fn main() -> Result<(), SolveError> {
    let start = Design { linkage: Transplanter::new(), phase: 0.5 };
    let best = improve(start);
    println!("Transplanter, plants {:.0} mm apart, {:.0} mm deep\n", SPACING * 1e3, DEPTH * 1e3);
    println!("            r1     r2     l1     l2  tip x  tip y  phase    hole   lift   tilt");
    println!("            mm     mm     mm     mm     mm     mm    deg      mm     mm    deg");
    for (name, design) in [("by hand", start), ("improved", best)] {
        let (l, goals) = (design.linkage, design.goals()?);
        print!("{name:8}");
        for length in [l.r1, l.r2, l.l1, l.l2, l.tip_x, l.tip_y] {
            print!(" {:6.1}", length * 1e3);
        }
        println!(
            " {:6.1} {:7.1} {:6.1} {:6.1}",
            design.phase.to_degrees(),
            goals.hole * 1e3,
            goals.lift * 1e3,
            goals.tilt.to_degrees(),
        );
    }

    println!("\nImproved, 120 plants a minute: the bill relative to the ground");
    println!("cranks        x        y   velocity x  velocity y   acceleration");
    println!("   deg       mm       mm         m/s         m/s           m/s²");
    let omega = 2.0 * TAU;
    for degrees in (0..360).step_by(15) {
        let turn = f64::from(degrees).to_radians();
        let m = best.linkage.motion(best.cranks(turn), [-omega, -omega], [0.0, 0.0])?;
        let (place, speed, second) = (best.tip(turn)?.0, m.velocity.bill, m.acceleration.bill);
        println!(
            "{degrees:6} {:8.1} {:8.1} {:12.3} {:11.3} {:14.2}",
            place[0] * 1e3,
            place[1] * 1e3,
            speed.x + SPACING * omega / TAU,
            speed.y,
            second.x.hypot(second.y),
        );
    }
    chart(&start, &best)
}

fn chart(start: &Design, best: &Design) -> Result<(), SolveError> {
    let path = |design: &Design| -> Result<Vec<(f64, f64)>, SolveError> {
        let soil = design.goals()?.soil;
        (-120..=240)
            .map(|step| {
                let ([x, y], _) = design.tip(f64::from(step) * TAU / 120.0)?;
                Ok((x * 1e3, (y - soil) * 1e3))
            })
            .collect()
    };
    let paths = vec![
        Curve::named("by hand", GREY, path(start)?),
        Curve::named("improved", COLOURS[1], path(best)?),
        Curve::line(BLACK, &[(-150.0, 0.0), (600.0, 0.0)]),
    ];
    let mm = |point: linkage_core::Point| (point.x * 1e3, point.y * 1e3);
    let mut closed = Vec::new();
    for step in 0..=120 {
        closed.push(mm(best.linkage.position(best.cranks(f64::from(step) * TAU / 120.0))?.bill));
    }
    let closed = vec![Curve::line(COLOURS[1], &closed)];
    charts::write(
        "transplanter",
        "Rice transplanter",
        2,
        vec![
            Panel::plane(
                "The improved bill in the machine's frame",
                ["x in mm", "y in mm"],
                closed,
            ),
            Panel::plane("The bill relative to the ground", ["x in mm", "height in mm"], paths),
        ],
    );
    Ok(())
}
