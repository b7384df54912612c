//! Mechanisms of one group or two on which errors are compared: of any proportion, with bars of one
//! length, of nearly one, or one a hundred-thousandth of the other, with limits or without.
//!
//! Every dimension is one that both widths hold, but for bars that differ by places of `f64` alone.

mod sliding;

use crate::random::Random;

/// A declaration: inputs with their ranges, dimensions by name, and statements.
struct Twin {
    group: &'static str,
    inputs: Vec<(&'static str, Option<[f64; 2]>)>,
    params: Vec<(&'static str, f64)>,
    statements: String,
}

/// The number of kinds of bars.
const KINDS: usize = 7;

/// A crank's length, where the other pivot stands from its own, and two bars.
struct Loop {
    crank: f64,
    between: [f64; 2],
    bars: [f64; 2],
}

pub(crate) fn table() -> String {
    let mut random = Random::new(21);
    let mut twins = Vec::new();
    for index in 0..2 * KINDS {
        let kind = index % KINDS;
        twins.push(behind_a_crank(&mut random, kind));
        twins.push(between_cranks(&mut random, kind));
        twins.push(at_a_driven_distance(&mut random, kind, index < KINDS));
    }
    for index in 0..10 {
        twins.push(six_bar(&mut random, index));
    }
    for kind in 0..4 {
        twins.push(sliding::slider_crank(&mut random, kind));
        twins.push(sliding::slider_on_a_crank(&mut random, kind));
        twins.push(sliding::block(&mut random, kind));
        twins.push(sliding::block_between_cranks(&mut random, kind));
        twins.push(sliding::crossed_guides(&mut random));
        twins.push(sliding::yoke(&mut random, kind));
    }
    let names = (1..).map(|number| format!("twin_{number:02}"));
    let mut named: Vec<_> = names.zip(&twins).collect();
    // The poses of a mechanism are drawn by its place among all.
    named.sort_by_key(|(_, twin)| place_of(twin.group));
    let rows: String = named.iter().map(|(name, twin)| row(name, twin)).collect();
    let names: Vec<_> = named.iter().map(|(name, _)| &name[..]).collect();
    rows + &format!("twins! {{ {} }}\n", names.join(" "))
}

/// Bars behind cranks come first, then other bars, then slides.
fn place_of(group: &str) -> usize {
    match group {
        "rrr behind a crank" | "rrr between cranks" => 0,
        group if group.starts_with("rrr") => 1,
        _ => 2,
    }
}

fn row(name: &str, Twin { group, inputs, params, statements }: &Twin) -> String {
    let inputs = inputs.iter().map(|(name, range)| match range {
        None => format!("{name}: angle"),
        Some([low, high]) => format!("{name}: length between {low:?} {high:?}"),
    });
    let inputs: Vec<_> = inputs.collect();
    let params: Vec<_> =
        params.iter().map(|(name, value)| format!("({name} = {})", exact(*value))).collect();
    format!(
        "twin! {{ {name}, {group:?}, [{}], [{}], {{ {statements} }} }}\n",
        inputs.join(", "),
        params.join(" ")
    )
}

/// All digits of a number.
fn exact(value: f64) -> String {
    let digits = format!("{value:.80}");
    let digits = digits.trim_end_matches('0');
    if digits.ends_with('.') { format!("{digits}0") } else { digits.to_owned() }
}

fn side(random: &mut Random) -> &'static str {
    if super::is(random) { "left" } else { "right" }
}

/// The origin for every other.
fn place(random: &mut Random) -> [f64; 2] {
    let place = [0; 2].map(|_| random.between(-0.5, 0.5));
    if super::is(random) { place } else { [0.0; 2] }
}

/// Where B comes near to D as far as the bars reach at least a tenth of the turn.
fn drawn_loop(random: &mut Random, kind: usize) -> Loop {
    loop {
        let drawn = any_loop(random, kind);
        let Loop { crank, between: [x, y], bars: [l2, l3] } = drawn;
        let stands = super::turn().filter(|angle| {
            let d = (x - crank * angle.cos()).hypot(y - crank * angle.sin());
            (l2 - l3).abs() <= d && d <= l2 + l3
        });
        if stands.count() >= 36 {
            return drawn;
        }
    }
}

fn any_loop(random: &mut Random, kind: usize) -> Loop {
    let crank = random.between(0.03, 0.3);
    let between =
        [random.between(0.1, 0.5), if super::is(random) { 0.0 } else { random.between(-0.2, 0.2) }];
    let long = random.between(0.26, 0.49);
    let few = 1.0 + random.between(0.0, 3.9).floor();
    let single = |value: f64| f64::from(value as f32);
    match kind {
        // Last places of f64 and of f32.
        2 => Loop { crank, between, bars: [long, long + few * 2_f64.powi(-54)] },
        3 => Loop { crank, between, bars: [long + few * 2_f64.powi(-25), long] },
        // A short crank and a short rocker.
        4 => {
            let size = single(long * 10_f64.powf(random.between(-5.0, -0.7)));
            let between = [single(long + size * random.between(-1.0, 1.0)), size];
            let short = single(size * random.between(0.5, 2.0));
            let bars = if super::is(random) { [long, short] } else { [short, long] };
            Loop { crank: size, between, bars }
        }
        // The pin comes next to the other pivot.
        5 => {
            let away = 2_f64.powf(-random.between(3.0, 20.0));
            Loop { crank, between: [single(crank * (1.0 + away)), 0.0], bars: [long; 2] }
        }
        // A parallelogram or nearly.
        6 => Loop { crank, between: [long, 0.0], bars: [long, crank] },
        _ => Loop { crank, between, bars: [0; 2].map(|_| random.between(0.1, 0.5)) },
    }
}

/// Names of the numbers of a place.
fn at(names: [&'static str; 2], [x, y]: [f64; 2]) -> Vec<(&'static str, f64)> {
    vec![(names[0], x), (names[1], y)]
}

/// A crank's pivot and the other one.
fn pivots(random: &mut Random, between: [f64; 2]) -> Vec<(&'static str, f64)> {
    let [x, y] = place(random);
    // The sums are numbers of both widths.
    let grid = |value: f64| (value * 16.0).round() / 16.0;
    let a = [grid(x), grid(y)];
    let is_small = between.iter().all(|side| f64::from((side + 1.0) as f32) == side + 1.0);
    let a = if is_small { a } else { [0.0; 2] };
    [at(["ax", "ay"], a), at(["gx", "gy"], [a[0] + between[0], a[1] + between[1]])].concat()
}

fn behind_a_crank(random: &mut Random, kind: usize) -> Twin {
    let Loop { crank, between, bars } = drawn_loop(random, kind);
    let mut params = pivots(random, between);
    params.extend([("a", crank), ("l2", bars[0]), ("l3", bars[1])]);
    params.extend(at(["px", "py"], [0; 2].map(|_| random.between(-0.3, 0.3))));
    let statements = format!(
        "ground A(ax, ay), D(gx, gy); crank AB(A) -> B {{ length: a, angle: theta }}
      rrr BC(B), DC(D) -> C {{ lengths: (l2, l3), mode: {} }}
      point P on BC at (px, py); output C, P, BC, DC;",
        side(random)
    );
    Twin { group: "rrr behind a crank", inputs: vec![("theta", None)], params, statements }
}

fn between_cranks(random: &mut Random, kind: usize) -> Twin {
    let Loop { crank, between, bars } = drawn_loop(random, kind);
    let mut params = pivots(random, between);
    let second = f64::from((crank * random.between(0.1, 0.9)) as f32);
    params.extend([("a", crank), ("b", second), ("l2", bars[0]), ("l3", bars[1])]);
    let statements = format!(
        "ground A(ax, ay), D(gx, gy); crank AB(A) -> B {{ length: a, angle: theta }}
      crank DE(D) -> E {{ length: b, angle: phi }}
      rrr BC(B), EC(E) -> C {{ lengths: (l2, l3), mode: {} }} output C, BC, EC;",
        side(random)
    );
    let inputs = vec![("theta", None), ("phi", None)];
    Twin { group: "rrr between cranks", inputs, params, statements }
}

/// Between a pivot and a slider, and between a pivot and an arm that turns about it and grows.
fn at_a_driven_distance(random: &mut Random, kind: usize, is_turning: bool) -> Twin {
    let Loop { bars: [l2, l3], .. } = drawn_loop(random, kind);
    let mut params = at(["ax", "ay"], place(random));
    params.extend([("l2", l2), ("l3", l3)]);
    // A little beyond both limits, as far as there are any.
    let beyond = 0.02 * l2.min(l3);
    let range = [((l2 - l3).abs() - beyond).max(l2 * 1e-6), l2 + l3 + beyond];
    let mut inputs = vec![("r", Some(range))];
    let (group, driver) = if is_turning {
        inputs.push(("theta", None));
        ("rrr on a turning arm", "crank AB(A) -> B { length: r, angle: theta }")
    } else {
        params.push(("tilt", random.between(-3.0, 3.0)));
        let slider = "guide rail through (ax, ay) along tilt; slider ram(rail) -> B { slide: r }";
        ("rrr behind a slider", slider)
    };
    let statements = format!(
        "ground A(ax, ay); {driver}
      rrr BC(B), AC(A) -> C {{ lengths: (l2, l3), mode: {} }} output C, BC, AC;",
        side(random)
    );
    Twin { group, inputs, params, statements }
}

/// The second bars are of any length, of nearly one, or one much longer than the other.
fn six_bar(random: &mut Random, kind: usize) -> Twin {
    loop {
        let Loop { crank, between, bars } = drawn_loop(random, 0);
        let is_left = super::is(random);
        let [p, f] = [0.3, 0.6].map(|most| [0; 2].map(|_| random.between(-most, most)));
        let [long, other] = [0; 2].map(|_| random.between(0.26, 0.49));
        let few = 1.0 + random.between(0.0, 3.9).floor();
        let second = match kind % 5 {
            0 | 1 => [long, other],
            2 => [long, long + few * 2_f64.powi(-54)],
            3 => [long + few * 2_f64.powi(-25), long],
            _ => [long, f64::from((long * random.between(0.01, 0.1)) as f32)],
        };
        let stands = super::turn().filter(|angle| {
            let b = [crank * angle.cos(), crank * angle.sin()];
            let Some([r, _]) = super::bars(b, between, bars, is_left) else { return false };
            let at = super::on(b, r, bars[0], p);
            let d = (f[0] - at[0]).hypot(f[1] - at[1]);
            (second[0] - second[1]).abs() <= d && d <= second[0] + second[1]
        });
        if stands.count() < 36 {
            continue;
        }
        let [x, y] = between;
        let mut params =
            [at(["gx", "gy"], [x, y]), at(["px", "py"], p), at(["fx", "fy"], f)].concat();
        params.extend([("a", crank), ("l2", bars[0]), ("l3", bars[1])]);
        params.extend([("l4", second[0]), ("l5", second[1])]);
        let statements = format!(
            "ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B {{ length: a, angle: theta }}
      rrr BC(B), DC(D) -> C {{ lengths: (l2, l3), mode: {} }}
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E {{ lengths: (l4, l5), mode: {} }} output C, P, E, DC, PE, FE;",
            super::mode(is_left),
            side(random)
        );
        return Twin { group: "rrr behind rrr", inputs: vec![("theta", None)], params, statements };
    }
}
