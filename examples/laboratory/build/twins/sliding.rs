//! Groups with sliding joints.

use crate::random::Random;

use super::{Twin, at, pivots, place};

fn sense(random: &mut Random) -> &'static str {
    if super::super::is(random) { "ahead" } else { "behind" }
}

/// Bars that are long enough, one that is not, and an offset next to the bar's length.
fn slide(random: &mut Random, kind: usize, crank: f64) -> [f64; 2] {
    let length = random.between(0.1, 0.5);
    let offset = if kind == 0 { 0.0 } else { random.between(-0.1, 0.1) };
    match kind {
        0 | 1 => [length + crank + 0.125, offset],
        2 => [crank.min(length), offset],
        _ => [length, f64::from((length * (1.0 - 1e-4)) as f32)],
    }
}

pub(super) fn slider_crank(random: &mut Random, kind: usize) -> Twin {
    let crank = random.between(0.03, 0.3);
    let [length, offset] = slide(random, kind, crank);
    let mut params = at(["ax", "ay"], place(random));
    let k = if kind == 0 { [0.0; 2] } else { [params[0].1 + 0.0625, params[1].1 - 0.03125] };
    params.extend(at(["kx", "ky"], k));
    let tilt = if kind == 0 { 0.0 } else { random.between(-3.0, 3.0) };
    params.extend([("a", crank), ("l", length), ("e", offset), ("tilt", tilt)]);
    let statements = format!(
        "ground A(ax, ay); guide rail through (kx, ky) along tilt;
      crank AB(A) -> B {{ length: a, angle: theta }}
      rrp BC(B), ram(rail) -> C {{ length: l, offset: e, mode: {} }} output C, BC, ram.slide;",
        sense(random)
    );
    Twin { group: "rrp", inputs: vec![("theta", None)], params, statements }
}

pub(super) fn slider_on_a_crank(random: &mut Random, kind: usize) -> Twin {
    let crank = random.between(0.03, 0.3);
    let [length, offset] = slide(random, kind, crank);
    let between = [random.between(0.05, 0.2), random.between(-0.1, 0.1)];
    let mut params = pivots(random, between);
    params.extend(at(["kx", "ky"], [0; 2].map(|_| random.between(-0.1, 0.1))));
    let tilt = random.between(-3.0, 3.0);
    params.extend([("a", crank), ("l", length + 0.25), ("e", offset), ("tilt", tilt)]);
    let statements = format!(
        "ground A(ax, ay), D(gx, gy); crank AB(A) -> B {{ length: a, angle: theta }}
      crank arm(D) {{ angle: phi }} guide rail on arm through (kx, ky) along tilt;
      rrp BC(B), ram(rail) -> C {{ length: l, offset: e, mode: {} }} output C, BC, ram.slide;",
        sense(random)
    );
    let inputs = vec![("theta", None), ("phi", None)];
    Twin { group: "rrp between cranks", inputs, params, statements }
}

/// A pivot outside of the crank's circle, inside, and next to it.
fn pivot_of_block(random: &mut Random, kind: usize, crank: f64) -> [f64; 2] {
    let turn = random.between(-3.0, 3.0);
    let share = match kind {
        0 => random.between(1.3, 4.0),
        1 => random.between(0.1, 0.6),
        2 => 1.0 + 2_f64.powf(-random.between(3.0, 16.0)),
        _ => random.between(1.8, 3.0),
    };
    [share * crank * turn.cos(), share * crank * turn.sin()].map(|side| f64::from(side as f32))
}

pub(super) fn block(random: &mut Random, kind: usize) -> Twin {
    let crank = random.between(0.03, 0.3);
    let mut params = at(["ax", "ay"], [0.0; 2]);
    params.extend(at(["gx", "gy"], pivot_of_block(random, kind, crank)));
    let offset = if kind == 3 { f64::from((crank * random.between(0.2, 0.9)) as f32) } else { 0.0 };
    params.extend([
        ("a", crank),
        ("px", random.between(0.1, 0.5)),
        ("py", random.between(-0.2, 0.2)),
    ]);
    // Without an offset no dimension says so.
    let dimension = if kind == 3 { "offset: e, " } else { "" };
    if kind == 3 {
        params.push(("e", offset));
    }
    let statements = format!(
        "ground A(ax, ay), D(gx, gy); crank AB(A) -> B {{ length: a, angle: theta }}
      rpr block(B), rod(D) {{ {dimension}mode: {} }}
      point P on rod at (px, py); output P, rod, block.slide;",
        sense(random)
    );
    Twin { group: "rpr", inputs: vec![("theta", None)], params, statements }
}

pub(super) fn block_between_cranks(random: &mut Random, kind: usize) -> Twin {
    let crank = random.between(0.03, 0.3);
    let mut params = at(["ax", "ay"], [0.0; 2]);
    params.extend(at(["gx", "gy"], pivot_of_block(random, kind, crank)));
    let (b, e) = (crank * random.between(0.1, 0.5), crank * random.between(0.1, 0.5));
    params.extend([("a", crank), ("b", f64::from(b as f32))]);
    let dimension = if kind % 2 == 1 { "offset: e, " } else { "" };
    if kind % 2 == 1 {
        params.push(("e", f64::from(e as f32)));
    }
    let statements = format!(
        "ground A(ax, ay), D(gx, gy); crank AB(A) -> B {{ length: a, angle: theta }}
      crank DE(D) -> E {{ length: b, angle: phi }}
      rpr block(B), rod(E) {{ {dimension}mode: {} }} output rod, block.slide;",
        sense(random)
    );
    let inputs = vec![("theta", None), ("phi", None)];
    Twin { group: "rpr between cranks", inputs, params, statements }
}

pub(super) fn crossed_guides(random: &mut Random) -> Twin {
    let between = [random.between(0.05, 0.4), random.between(-0.1, 0.1)];
    let mut params = pivots(random, between);
    params.extend([("a", random.between(0.03, 0.3)), ("tilt", random.between(0.2, 2.9))]);
    params.extend([("e1", random.between(-0.1, 0.1)), ("e2", random.between(-0.1, 0.1))]);
    let (is_second, way) = if super::super::is(random) {
        (true, "crank arm(D) { angle: phi } guide post on arm through (0, a) along tilt;")
    } else {
        (false, "guide post through (gx, gy) along tilt;")
    };
    let (ground, inputs) = if is_second {
        ("ground A(ax, ay), D(gx, gy);", vec![("theta", None), ("phi", None)])
    } else {
        ("ground A(ax, ay);", vec![("theta", None)])
    };
    let statements = format!(
        "{ground} crank AB(A) -> B {{ length: a, angle: theta }}
      guide slot on AB through B along e1; {way}
      prp shoe(slot), ram(post) -> C {{ offsets: (e1, e2) }} output C, shoe.slide, ram.slide;"
    );
    let statements = statements.replace("along e1", "along turn");
    params.push(("turn", random.between(0.2, 2.9)));
    Twin { group: "prp", inputs, params, statements }
}

pub(super) fn yoke(random: &mut Random, kind: usize) -> Twin {
    let between = [random.between(0.05, 0.4), random.between(-0.1, 0.1)];
    let mut params = pivots(random, between);
    params.extend([("a", random.between(0.03, 0.3)), ("tilt", random.between(-3.0, 3.0))]);
    params.extend([("e1", random.between(-0.1, 0.1)), ("e2", random.between(-0.1, 0.1))]);
    params.push((
        "across",
        if kind == 3 { random.between(0.001, 0.1) } else { random.between(0.3, 2.8) },
    ));
    let (ground, rail, inputs) = if kind.is_multiple_of(2) {
        ("ground A(ax, ay);", "guide rail through (gx, gy) along tilt;", vec![("theta", None)])
    } else {
        let rail = "crank arm(D) { angle: phi } guide rail on arm through (0, a) along tilt;";
        ("ground A(ax, ay), D(gx, gy);", rail, vec![("theta", None), ("phi", None)])
    };
    let statements = format!(
        "{ground} crank AB(A) -> B {{ length: a, angle: theta }} {rail}
      rpp block(B), ram(rail) {{ slot: across, offsets: (e1, e2) }}
      output block, ram.slide;"
    );
    Twin { group: "rpp", inputs, params, statements }
}
