//! Random four-bars and slider-cranks in both widths, against the full matrix of all bodies in double precision.
//!
//! `LINKAGE_FRICTION=10000 cargo test --release -p linkage-tests --test dynamics friction::matrix` compares so many draws.

mod newton;

use linkage_core::{Float, SolveError, mechanism};
use linkage_tests::random::{Random, cases};
use newton::{Acts, Bodies, Vector, carried, cross, minus, normal, parts, plus, rubbed, times};

mechanism! {
    pub struct DrawnFourBar {
        input theta: angle;
        param a = 0.2m;
        param b = 0.8m;
        param c = 0.5m;
        param dx = 0.9m;
        param dy = 0m;
        param mu = 0.1;
        param nu = 0.1;
        param radius = 10mm;
        param heavy = 2kg;
        load push: force;
        load turn: torque;
        ground A(0, 0), D(dx, dy);
        crank AB(A) -> B { length: a, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (b, c), mode: left }
        point P on BC at (0.3m, 0.1m);
        gravity (0, -9.75(m/s^2));
        mass 1.5kg on AB at (0.125m, 0.03125m) inertia 0.03125(kg*m^2);
        mass heavy on BC at (0.375m, -0.0625m) inertia 0.125(kg*m^2);
        mass 3kg on DC at (0.25m, 0.03125m) inertia 0.0625(kg*m^2);
        force (push, -push / 2) on P;
        torque turn on DC;
        friction mu at A radius radius;
        friction nu at B radius radius;
        friction mu at C radius radius;
        friction nu at D radius radius;
        output theta.drive, AB.A, BC.B, BC.C, DC.D, losses;
    }
}

mechanism! {
    pub struct DrawnPress {
        input theta: angle;
        param a = 0.2m;
        param b = 0.8m;
        param beside = 0m;
        param tilt = 0rad;
        param mu = 0.1;
        param nu = 0.1;
        param radius = 10mm;
        param block = 0.1m;
        param heavy = 2kg;
        load push: force;
        load turn: torque;
        ground A(0, 0);
        guide bed through (0, beside) along tilt;
        crank AB(A) -> B { length: a, angle: theta }
        rrp BC(B), ram(bed) -> C { length: b, mode: ahead }
        gravity (0, -9.75(m/s^2));
        mass 1.5kg on AB at (0.125m, 0.03125m) inertia 0.03125(kg*m^2);
        mass heavy on BC at (0.375m, -0.0625m) inertia 0.125(kg*m^2);
        mass 3kg on ram at (0.0625m, 0.03125m) inertia 0.0625(kg*m^2);
        force (push, -push / 2) on C;
        torque turn on ram;
        friction mu at A radius radius;
        friction nu at B radius radius;
        friction mu on BC at C radius radius;
        friction nu on ram length block;
        output theta.drive, AB.A, BC.B, BC.C, ram.bed, losses;
    }
}

/// Numbers that both widths hold: four lengths, an angle, two coefficients, the radius, the block and the mass; the
/// state and the loads.
struct Draw {
    lengths: [f64; 4],
    tilt: f64,
    mu: f64,
    nu: f64,
    radius: f64,
    block: f64,
    heavy: f64,
    state: [f64; 3],
    loads: [f64; 2],
}

impl Draw {
    fn new(random: &mut Random) -> Self {
        let mut between = |low, high| random.between(low, high);
        Self {
            lengths: [between(0.1, 0.3), between(0.6, 1.0), between(0.4, 0.7), between(-0.1, 0.1)],
            tilt: between(-0.5, 0.5),
            mu: between(0.0, 0.5),
            nu: between(0.0, 0.5),
            radius: between(0.0, 0.5),
            block: between(0.05, 0.3),
            heavy: between(0.5, 5.0),
            state: [between(-3.1, 3.1), between(-9.0, 9.0), between(-40.0, 40.0)],
            loads: [between(-300.0, 300.0), between(-30.0, 30.0)],
        }
    }

    /// A sample in an ordinary run of what `.ci/nightly` draws whole.
    fn count() -> usize {
        let asked = std::env::var("LINKAGE_FRICTION").ok();
        asked.map_or(cases(300, 1000), |count| count.parse().expect("a whole number"))
    }
}

/// The numbers of the matrix: reactions and drive, losses, ρ, and how far a sine is from a dead point.
struct Full {
    numbers: Vec<f64>,
    losses: f64,
    radius: f64,
    sine: f64,
    /// The largest force that acts or is transmitted.
    largest: f64,
}

const GRAVITY: Vector = [0.0, -9.75];

fn crank([a, ..]: [f64; 4], [q, rate, second]: [f64; 3]) -> [Vector; 4] {
    let u = [q.cos(), q.sin()];
    let b = times(a, u);
    let accelerated = plus(times(second, normal(b)), times(-rate * rate, b));
    [u, b, times(rate, normal(b)), accelerated]
}

/// None out of reach.
fn four_bar(draw: &Draw) -> Option<Full> {
    let [_, b, c, dy] = draw.lengths;
    let [_, rate, second] = draw.state;
    let [u1, pin, velocity, acceleration] = crank(draw.lengths, draw.state);
    let d = [0.875, dy];
    let line = minus(d, pin);
    let squared = line[0] * line[0] + line[1] * line[1];
    let along = (squared + b * b - c * c) / (2.0 * squared);
    let height = (b * b / squared - along * along).sqrt();
    if !height.is_finite() {
        return None;
    }
    let r2 = plus(times(along, line), times(height, normal(line)));
    let r3 = minus(plus(pin, r2), d);
    let [u2, u3] = [times(1.0 / b, r2), times(1.0 / c, r3)];
    // v + ω₂ r₂⊥ = ω₃ r₃⊥, and the same of accelerations.
    let [omega2, omega3] = parts(times(-1.0, normal(r2)), normal(r3), velocity);
    let rest = plus(acceleration, plus(times(-omega2 * omega2, r2), times(omega3 * omega3, r3)));
    let [alpha2, alpha3] = parts(times(-1.0, normal(r2)), normal(r3), rest);
    let g1 = carried([[0.0; 2]; 2], u1, [rate, second], [0.125, 0.03125]);
    let g2 = carried([pin, acceleration], u2, [omega2, alpha2], [0.375, -0.0625]);
    let g3 = carried([d, [0.0; 2]], u3, [omega3, alpha3], [0.25, 0.03125]);
    let p = carried([pin, acceleration], u2, [omega2, alpha2], [0.3, 0.1])[0];
    let bodies = [
        (1.5, g1[0], g1[1], 0.03125, second),
        (draw.heavy, g2[0], g2[1], 0.125, alpha2),
        (3.0, g3[0], g3[1], 0.0625, alpha3),
    ];
    let mut all = Bodies::new(&bodies, GRAVITY);
    let none = [0.0; 2];
    let [push, turn] = draw.loads;
    all.known(&[Acts(1, p, [push, -0.5 * push], 0.0), Acts(2, none, none, turn)]);
    let at_c = plus(pin, r2);
    all.joint(none, 0, None);
    all.joint(pin, 1, Some(0));
    all.joint(at_c, 1, Some(2));
    all.joint(d, 2, None);
    all.unknown(&[Acts(0, none, none, 1.0)]);
    let slips = [rate, omega2 - rate, omega2 - omega3, omega3];
    let pairs = [(0, None), (1, Some(0)), (1, Some(2)), (2, None)];
    for (slip, (first, second)) in slips.into_iter().zip(pairs) {
        let way = slip.signum();
        let mut acts = vec![Acts(first, none, none, -way)];
        acts.extend(second.map(|second| Acts(second, none, none, way)));
        all.friction(&acts);
    }
    let [mu, nu] = [draw.mu, draw.nu].map(|share| share * draw.radius);
    let pressing = [(0, mu, None), (2, nu, None), (4, mu, None), (6, nu, None)];
    let sine = cross(u2, u3).abs();
    Some(Full::of(all, &pressing, &slips, sine, &bodies, push))
}

fn press(draw: &Draw) -> Option<Full> {
    let [_, b, _, beside] = draw.lengths;
    let [_, rate, second] = draw.state;
    let [u1, pin, velocity, acceleration] = crank(draw.lengths, draw.state);
    let u = [draw.tilt.cos(), draw.tilt.sin()];
    let n = normal(u);
    let across = cross(u, minus([0.0, beside], pin));
    let run = (b * b - across * across).sqrt();
    if !run.is_finite() {
        return None;
    }
    let r2 = plus(times(run, u), times(across, n));
    let u2 = times(1.0 / b, r2);
    // v + ω₂ r₂⊥ = ṡ u, and the same of accelerations.
    let [omega2, slide] = parts(times(-1.0, normal(r2)), u, velocity);
    let rest = plus(acceleration, times(-omega2 * omega2, r2));
    let [alpha2, speeding] = parts(times(-1.0, normal(r2)), u, rest);
    let at_c = plus(pin, r2);
    let g1 = carried([[0.0; 2]; 2], u1, [rate, second], [0.125, 0.03125]);
    let g2 = carried([pin, acceleration], u2, [omega2, alpha2], [0.375, -0.0625]);
    let g3 = carried([at_c, times(speeding, u)], u, [0.0; 2], [0.0625, 0.03125]);
    let bodies = [
        (1.5, g1[0], g1[1], 0.03125, second),
        (draw.heavy, g2[0], g2[1], 0.125, alpha2),
        (3.0, g3[0], g3[1], 0.0625, 0.0),
    ];
    let mut all = Bodies::new(&bodies, GRAVITY);
    let none = [0.0; 2];
    let [push, turn] = draw.loads;
    // A force on the pin goes to the ram; the bar is pushed at its end alone.
    all.known(&[Acts(2, at_c, [push, -0.5 * push], turn)]);
    all.joint(none, 0, None);
    all.joint(pin, 1, Some(0));
    all.joint(at_c, 1, Some(2));
    all.unknown(&[Acts(2, at_c, n, 0.0)]);
    all.unknown(&[Acts(2, none, none, 1.0)]);
    all.unknown(&[Acts(0, none, none, 1.0)]);
    let slips = [rate, omega2 - rate, omega2, slide];
    let ways = slips.map(f64::signum);
    all.friction(&[Acts(0, none, none, -ways[0])]);
    all.friction(&[Acts(1, none, none, -ways[1]), Acts(0, none, none, ways[1])]);
    all.friction(&[Acts(1, none, none, -ways[2]), Acts(2, none, none, ways[2])]);
    all.friction(&[Acts(2, at_c, times(-ways[3], u), 0.0)]);
    let [mu, nu] = [draw.mu, draw.nu].map(|share| share * draw.radius);
    let by = Some(2.0 / draw.block);
    let pressing = [(0, mu, None), (2, nu, None), (4, mu, None), (6, draw.nu, by)];
    Some(Full::of(all, &pressing, &slips, (run / b).abs(), &bodies, push))
}

impl Full {
    fn of(
        all: Bodies,
        pressing: &[(usize, f64, Option<f64>)],
        slips: &[f64],
        sine: f64,
        bodies: &[(f64, Vector, Vector, f64, f64)],
        push: f64,
    ) -> Self {
        let (amounts, numbers, radius) = rubbed(&all.solved(), pressing);
        let losses = amounts.iter().zip(slips).map(|(amount, slip)| amount * slip.abs()).sum();
        let inertia = bodies.iter().map(|(mass, _, a, ..)| mass * (a[0].hypot(a[1]) + 9.75));
        let sizes = inertia.chain(numbers.iter().map(|x| x.abs()));
        let largest = sizes.fold(push.abs(), f64::max);
        Self { numbers, losses, radius, sine, largest }
    }
}

fn number<T: Float>(x: f64) -> T {
    T::lit(x, x as f32)
}

/// The forces and the losses, or why there are none.
type Solved = Result<(Vec<f64>, f64), SolveError>;

fn solved_four_bar<T: Float>(draw: &Draw) -> Solved {
    let lit = number::<T>;
    let [a, b, c, dy] = draw.lengths.map(lit);
    let (mu, nu, radius, heavy) = (lit(draw.mu), lit(draw.nu), lit(draw.radius), lit(draw.heavy));
    let machine = DrawnFourBar::<T> { a, b, c, dx: lit(0.875), dy, mu, nu, radius, heavy };
    let ([q, rate, second], loads) = (draw.state.map(lit), draw.loads.map(lit));
    let f = machine.forces(q, rate, second, loads)?;
    let found = [
        f.AB.A.x,
        f.AB.A.y,
        f.BC.B.x,
        f.BC.B.y,
        f.BC.C.x,
        f.BC.C.y,
        f.DC.D.x,
        f.DC.D.y,
        f.theta.drive,
    ];
    Ok((found.map(|number| number.value()).to_vec(), f.losses.value()))
}

fn solved_press<T: Float>(draw: &Draw) -> Solved {
    let lit = number::<T>;
    let [a, b, _, beside] = draw.lengths.map(lit);
    let (mu, nu, radius, heavy) = (lit(draw.mu), lit(draw.nu), lit(draw.radius), lit(draw.heavy));
    let (tilt, block) = (lit(draw.tilt), lit(draw.block));
    let machine = DrawnPress::<T> { a, b, beside, tilt, mu, nu, radius, block, heavy };
    let ([q, rate, second], loads) = (draw.state.map(lit), draw.loads.map(lit));
    let f = machine.forces(q, rate, second, loads)?;
    let (bed, drive) = (f.ram.bed, f.theta.drive);
    let found =
        [f.AB.A.x, f.AB.A.y, f.BC.B.x, f.BC.B.y, f.BC.C.x, f.BC.C.y, bed.normal, bed.couple, drive];
    Ok((found.map(|number| number.value()).to_vec(), f.losses.value()))
}

/// Roundings of reactions in ε of the largest force. Velocities hold a bar's direction over the sine between the bars, within
/// 2ε each; accelerations and reactions divide by the sine once more, and are sums of both bars' terms. What the amounts
/// are off by comes back over 1 − ρ. Losses are taken for slips below 30 of their units.
const ROUNDINGS: f64 = 8.0;

fn compared(
    name: &str,
    epsilon: f64,
    full: fn(&Draw) -> Option<Full>,
    solved: fn(&Draw) -> Solved,
) {
    let (mut random, mut counts, mut worst) = (Random::new(61), [0; 3], 0.0_f64);
    for _ in 0..Draw::count() {
        let draw = Draw::new(&mut random);
        match (full(&draw), solved(&draw)) {
            (None, Err(SolveError::OutOfReach { .. })) => counts[2] += 1,
            (Some(full), Err(SolveError::Jams { .. })) => {
                assert!(full.radius > 1.0 - 1e-4, "{name}: jams at {}", full.radius);
                counts[1] += 1;
            }
            (Some(full), Ok((found, losses))) => {
                if full.radius > 0.7 || full.sine < 0.3 {
                    continue;
                }
                let tolerance = epsilon * full.largest / (full.sine.powi(2) * (1.0 - full.radius));
                let off = |found: f64, expected: f64| (found - expected).abs() / tolerance;
                for (found, expected) in found.into_iter().zip(&full.numbers) {
                    worst = worst.max(off(found, *expected));
                }
                worst = worst.max(off(losses, full.losses) / 30.0);
                counts[0] += 1;
            }
            (full, found) => {
                assert!(full.is_none_or(|full| full.sine < 1e-2), "{name}: {found:?}");
            }
        }
    }
    println!("{name}: {counts:?} {worst}");
    assert!(worst < ROUNDINGS, "{name}: {worst}");
    let least = Draw::count() / 50;
    assert!(counts[0] > least && counts[1] > least, "{name}: {counts:?}");
}

#[test]
fn four_bars_are_those_of_the_full_matrix() {
    compared("four-bar", f64::EPSILON, four_bar, solved_four_bar::<f64>);
    compared("four-bar, f32", f32::EPSILON.into(), four_bar, solved_four_bar::<f32>);
    compared("press", f64::EPSILON, press, solved_press::<f64>);
    compared("press, f32", f32::EPSILON.into(), press, solved_press::<f32>);
}
