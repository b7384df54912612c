//! Five-bar robot, forward and inverse. Forward: two cranks and one RRR group give the tool's
//! place. Inverse: the tool is a driven point and each arm is an RRR group between its pivot and
//! the tool. Both are closed forms, and one undoes the other to rounding.

use std::f64::consts::TAU;

use charts::{COLOURS, Curve, Panel};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// Where the tool is when the left motor stands at `q1` and the right one at `q2`.
    pub struct Forward {
        input q1, q2: angle;

        ground A(-60mm, 0), D(60mm, 0);

        crank AB(A) -> B        { length: 180mm, angle: q1 }
        crank DE(D) -> E        { length: 180mm, angle: q2 }
        rrr   BP(B), EP(E) -> P { lengths: (240mm, 240mm), mode: left }

        output B, E, P;
    }
}

mechanism! {
    /// How the motors stand when the tool is at (x, y).
    pub struct Inverse {
        input x, y: length;

        ground A(-60mm, 0), D(60mm, 0);
        point P at (x, y);

        rrr   AB(A), PB(P) -> B { lengths: (180mm, 240mm), mode: left }
        rrr   DE(D), PE(P) -> E { lengths: (180mm, 240mm), mode: right }

        output AB, DE;
    }
}

/// The tool's task: a circle of 50 mm about (20, 300) mm, once a second.
fn task(t: f64) -> [[f64; 2]; 3] {
    let (sin, cos) = (TAU * t).sin_cos();
    let (r, w) = (0.05, TAU);
    [
        [0.02 + r * cos, 0.3 + r * sin],
        [-r * w * sin, r * w * cos],
        [-r * w * w * cos, -r * w * w * sin],
    ]
}

fn main() -> Result<(), SolveError> {
    let (forward, inverse) = (Forward::new(), Inverse::new());
    println!("Five-bar robot on a circle of 50 mm, once a second\n");
    println!("    t     tool x   tool y       AB       DE  ω of AB  ω of DE  α of AB α of DE");
    println!("    s         mm       mm      deg      deg    rad/s    rad/s   rad/s²  rad/s²");
    let mut worst = [0.0_f64; 3];
    let (mut left, mut right, mut rates) = (vec![], vec![], [vec![], vec![]]);
    for step in 0..=100 {
        let t = f64::from(step) / 100.0;
        let [place, speed, second] = task(t);
        let arm = inverse.motion(place, speed, second)?;
        let motors = [arm.position.AB.angle(), arm.position.DE.angle()];
        let turning = [arm.velocity.AB.omega, arm.velocity.DE.omega];
        let spinning = [arm.acceleration.AB.alpha, arm.acceleration.DE.alpha];
        if step % 5 == 0 {
            println!(
                "{t:5.2} {:10.3} {:8.3} {:8.3} {:8.3} {:8.3} {:8.3} {:8.2} {:7.2}",
                place[0] * 1e3,
                place[1] * 1e3,
                motors[0].to_degrees(),
                motors[1].to_degrees(),
                turning[0],
                turning[1],
                spinning[0],
                spinning[1],
            );
        }
        // There and back again: position, velocity and acceleration of the tool.
        let tool = forward.motion(motors, turning, spinning)?;
        let back = [tool.position.P, tool.velocity.P, tool.acceleration.P];
        for ((worst, there), back) in worst.iter_mut().zip([place, speed, second]).zip(back) {
            *worst = worst.max((there[0] - back.x).hypot(there[1] - back.y));
        }
        left.push((t, motors[0].to_degrees()));
        right.push((t, motors[1].to_degrees()));
        rates[0].push((t, turning[0]));
        rates[1].push((t, turning[1]));
    }
    let [place, speed, second] = worst;
    println!("\nthere and back: {place:.1e} m, {speed:.1e} m/s, {second:.1e} m/s²");
    chart(&forward, &inverse, [left, right], rates)
}

fn chart(
    forward: &Forward,
    inverse: &Inverse,
    motors: [Vec<(f64, f64)>; 2],
    rates: [Vec<(f64, f64)>; 2],
) -> Result<(), SolveError> {
    let mm = |point: linkage_core::Point| (point.x * 1e3, point.y * 1e3);
    let mut paths = [vec![], vec![], vec![]];
    for step in 0..=96 {
        let [place, ..] = task(f64::from(step) / 96.0);
        let motors = inverse.position(place)?;
        let p = forward.position([motors.AB.angle(), motors.DE.angle()])?;
        for (path, pin) in paths.iter_mut().zip([p.B, p.E, p.P]) {
            path.push(mm(pin));
        }
    }
    let named = ["left crank's pin", "right crank's pin", "tool"].into_iter().zip(COLOURS);
    let paths = named.zip(paths).map(|((name, colour), path)| Curve::named(name, colour, path));
    let [left, right] = motors;
    let [left_rate, right_rate] = rates;
    let two = |one, other| {
        vec![Curve::named("left", COLOURS[0], one), Curve::named("right", COLOURS[1], other)]
    };
    charts::write(
        "five_bar_robot",
        "Five-bar robot on a circle",
        3,
        vec![
            Panel::plane("Paths", ["x in mm", "y in mm"], paths.collect()),
            Panel::over("Motors", ["t in s", "deg"], two(left, right)),
            Panel::over("Motor speeds", ["t in s", "rad/s"], two(left_rate, right_rate)),
        ],
    );
    Ok(())
}
