//! Ten machines with sliding joints or two inputs, drawn as the thirty are: no transmission angle below 25°, nor an
//! angle between a slot and its rail.

mod parts;

use core::f64::consts::PI;

use crate::random::Random;

use parts::{Rail, Rod, direction, sense, sign};

use super::{FourBar, bars, four_bar, is, length, mode, on, some, turn};

/// The parts of a row of the table.
struct Row {
    name: &'static str,
    inputs: &'static str,
    ranges: String,
    statements: String,
    /// Points, links and slides that may be asked for.
    names: [&'static [&'static str]; 3],
    by_hand: String,
}

const ANGLE: &str = "one [theta: angle]";
const TURN: &str = "[TURN; 2]";

pub(crate) fn table() -> String {
    let mut random = Random::new(22);
    let draws: [fn(&mut Random) -> Option<Row>; 10] = [
        |random| slider_crank(random, true),
        |random| slider_crank(random, false),
        shaper,
        press,
        crossed,
        yoke,
        rocker_guide,
        five_bar,
        arm,
        excavator,
    ];
    let mut text = String::new();
    let mut names = Vec::new();
    for draw in draws {
        let row = loop {
            if let Some(row) = draw(&mut random) {
                break row;
            }
        };
        text += &row.text(&mut random);
        names.push(row.name);
    }
    text + &super::every("machines", &names)
}

impl Row {
    fn text(&self, random: &mut Random) -> String {
        let Self { name, inputs, ranges, statements, names, by_hand } = self;
        // A point at least, where there is one, since a list begins with it.
        let [points, links, slides] =
            names.map(
                |names| {
                    if names.is_empty() { String::new() } else { some(random, names).join(" ") }
                },
            );
        format!(
            "machine! {{ {name}: {inputs} between {ranges},\n    {{ {statements} }},\n    output \
             [{points}] [{links}] [{slides}],\n    {by_hand} }}\n"
        )
    }
}

fn pin(crank: f64, angle: f64) -> [f64; 2] {
    [crank * angle.cos(), crank * angle.sin()]
}

fn slider_crank(random: &mut Random, is_along: bool) -> Option<Row> {
    let (crank, rail, rod) = (length(random, 0.03, 0.15), Rail::draw(random), Rod::draw(random));
    let [u, v] = [length(random, 0.02, 0.3), length(random, -0.15, 0.15)];
    let stands = turn().all(|angle| rod.stands(rail.across(pin(crank, angle))));
    (stands && (rail.degrees == 0.0) == is_along).then(|| Row {
        name: if is_along { "slider_crank" } else { "slider_crank_oblique" },
        inputs: ANGLE,
        ranges: TURN.into(),
        statements: format!(
            "ground A(0, 0); {} crank AB(A) -> B {{ length: {crank:?}, angle: theta }}
      rrp BC(B), ram(rail) -> C {{ {} }} point P on BC at ({u:?}, {v:?});",
            rail.declared(),
            rod.declared()
        ),
        names: [&["C", "P"], &["BC"], &["ram"]],
        by_hand: format!(
            "slider_crank({crank:?}, {}, {}, [{u:?}, {v:?}]) -> SliderCrank",
            rail.form(),
            rod.form()
        ),
    })
}

fn shaper(random: &mut Random) -> Option<Row> {
    let (crank, rail, rod) = (length(random, 0.03, 0.15), Rail::draw(random), Rod::draw(random));
    let [gx, gy] =
        [length(random, -0.3, 0.3), if is(random) { 0.0 } else { length(random, -0.5, -0.1) }];
    let ([u, v], is_ahead) = ([length(random, 0.1, 0.6), length(random, -0.1, 0.1)], is(random));
    // The block stays away from the pivot, as a square of a distance that is small by cancellation does not.
    let is_clear = gx.hypot(gy) >= 1.7 * crank;
    let stands = turn().all(|angle| {
        let [x, y] = pin(crank, angle);
        let turned = (y - gy).atan2(x - gx) + if is_ahead { 0.0 } else { PI };
        let (sin, cos) = turned.sin_cos();
        rod.stands(rail.across([gx + u * cos - v * sin, gy + u * sin + v * cos]))
    });
    (is_clear && stands).then(|| Row {
        name: "shaper",
        inputs: ANGLE,
        ranges: TURN.into(),
        statements: format!(
            "ground A(0, 0), D({gx:?}, {gy:?}); {} crank AB(A) -> B {{ length: {crank:?}, angle: theta }}
      rpr block(B), rod(D) {{ mode: {} }} point E on rod at ({u:?}, {v:?});
      rrp EC(E), ram(rail) -> C {{ {} }}",
            rail.declared(),
            sense(is_ahead),
            rod.declared()
        ),
        names: [&["C", "E"], &["rod", "EC"], &["block", "ram"]],
        by_hand: format!(
            "shaper({crank:?}, [{gx:?}, {gy:?}], {}, [{u:?}, {v:?}], {}, {}) -> Shaper",
            sign(is_ahead),
            rail.form(),
            rod.form()
        ),
    })
}

/// A four-bar, as declared and as a hand has it.
fn declared(
    FourBar { crank, pivot: [gx, gy], lengths: [l2, l3], is_left, .. }: &FourBar,
) -> [String; 2] {
    [
        format!(
            "crank AB(A) -> B {{ length: {crank:?}, angle: theta }}
      rrr BC(B), DC(D) -> C {{ lengths: ({l2:?}, {l3:?}), mode: {} }}",
            mode(*is_left)
        ),
        format!(
            "CrankDyad {{ crank: {crank:?}, dyad: Dyad {{ pivot: [{gx:?}, {gy:?}], lengths: [{l2:?}, {l3:?}], side: {} }} }}",
            sign(*is_left)
        ),
    ]
}

fn press(random: &mut Random) -> Option<Row> {
    let (machine, rail, rod) = (four_bar(random), Rail::draw(random), Rod::draw(random));
    let stands = turn().all(|angle| {
        let (b, [r, _]) = machine.moved(angle).expect("it turns fully");
        rod.stands(rail.across(on(b, r, machine.lengths[0], machine.point)))
    });
    let ([gx, gy], [u, v], [statements, form]) = (machine.pivot, machine.point, declared(&machine));
    stands.then(|| Row {
        name: "press",
        inputs: ANGLE,
        ranges: TURN.into(),
        statements: format!(
            "ground A(0, 0), D({gx:?}, {gy:?}); {}
      {statements} point P on BC at ({u:?}, {v:?});
      rrp PE(P), ram(rail) -> E {{ {} }}",
            rail.declared(),
            rod.declared()
        ),
        names: [&["E", "P"], &["BC", "DC", "PE"], &["ram"]],
        by_hand: format!("press({form}, [{u:?}, {v:?}], {}, {}) -> Press", rail.form(), rod.form()),
    })
}

fn crossed(random: &mut Random) -> Option<Row> {
    let (crank, rail) = (length(random, 0.03, 0.15), Rail::draw(random));
    let guide = random.between(-170.0, 170.0).round();
    let [e1, e2] = [0; 2].map(|_| length(random, -0.1, 0.1));
    // From 25° to 155° between guide and rail.
    let [low, high] = [25.0, 155.0].map(|between| (rail.degrees - guide + between).to_radians());
    Some(Row {
        name: "crossed_guides",
        inputs: ANGLE,
        ranges: format!("[[{low:?}, {high:?}]; 2]"),
        statements: format!(
            "ground A(0, 0); {} crank AB(A) -> B {{ length: {crank:?}, angle: theta }}
      guide slot on AB through B along {guide}deg;
      prp shoe(slot), ram(rail) -> C {{ offsets: ({e1:?}, {e2:?}) }}",
            rail.declared()
        ),
        names: [&["C"], &[], &["shoe", "ram"]],
        by_hand: format!(
            "crossed_guides({crank:?}, {}, {}, [{e1:?}, {e2:?}]) -> Crossed",
            direction(guide),
            rail.form()
        ),
    })
}

fn yoke(random: &mut Random) -> Option<Row> {
    let (crank, rail) = (length(random, 0.03, 0.15), Rail::draw(random));
    let slot = random.between(25.0, 155.0).round();
    let [e1, e2] = [0; 2].map(|_| length(random, -0.1, 0.1));
    Some(Row {
        name: "scotch_yoke",
        inputs: ANGLE,
        ranges: TURN.into(),
        statements: format!(
            "ground A(0, 0); {} crank AB(A) -> B {{ length: {crank:?}, angle: theta }}
      rpp block(B), ram(rail) {{ slot: {slot}deg, offsets: ({e1:?}, {e2:?}) }}",
            rail.declared()
        ),
        names: [&["B"], &[], &["block", "ram"]],
        by_hand: format!(
            "scotch_yoke({crank:?}, {}, {}, [{e1:?}, {e2:?}]) -> Yoke",
            rail.form(),
            direction(slot)
        ),
    })
}

fn rocker_guide(random: &mut Random) -> Option<Row> {
    let (machine, rod) = (four_bar(random), Rod::draw(random));
    let [u, v] = [length(random, 0.02, 0.3), length(random, -0.15, 0.15)];
    let [fx, fy] = [length(random, 0.1, 0.7), length(random, -0.3, 0.3)];
    let guide = random.between(-170.0, 170.0).round();
    let stands = turn().all(|angle| {
        let (_, [_, r]) = machine.moved(angle).expect("it turns fully");
        let origin = on(machine.pivot, r, machine.lengths[1], [u, v]);
        let degrees = r[1].atan2(r[0]).to_degrees() + guide;
        rod.stands(Rail { origin, degrees }.across([fx, fy]))
    });
    let ([gx, gy], [statements, form]) = (machine.pivot, declared(&machine));
    stands.then(|| Row {
        name: "rocker_guide",
        inputs: ANGLE,
        ranges: TURN.into(),
        statements: format!(
            "ground A(0, 0), D({gx:?}, {gy:?}), F({fx:?}, {fy:?});
      {statements} guide slot on DC through ({u:?}, {v:?}) along {guide}deg;
      rrp FE(F), shoe(slot) -> E {{ {} }}",
            rod.declared()
        ),
        names: [&["C", "E"], &["BC", "DC", "FE"], &["shoe"]],
        by_hand: format!(
            "rocker_guide({form}, [{u:?}, {v:?}], {}, [{fx:?}, {fy:?}], {}) -> RockerGuide",
            direction(guide),
            rod.form()
        ),
    })
}

fn five_bar(random: &mut Random) -> Option<Row> {
    let [a, b] = [0; 2].map(|_| length(random, 0.03, 0.12));
    let [gx, gy] =
        [length(random, 0.15, 0.5), if is(random) { 0.0 } else { length(random, 0.02, 0.2) }];
    let ([l2, l3], is_left) = ([0; 2].map(|_| length(random, 0.1, 0.5)), is(random));
    let [u, v] = [length(random, 0.02, 0.3), length(random, -0.15, 0.15)];
    let stands = turn().step_by(7).all(|angle| {
        turn().step_by(7).all(|other| {
            let [x, y] = pin(b, other);
            bars(pin(a, angle), [gx + x, gy + y], [l2, l3], is_left).is_some()
        })
    });
    stands.then(|| Row {
        name: "five_bar",
        inputs: "two [theta: angle, phi: angle]",
        ranges: TURN.into(),
        statements: format!(
            "ground A(0, 0), D({gx:?}, {gy:?}); crank AB(A) -> B {{ length: {a:?}, angle: theta }}
      crank DE(D) -> E {{ length: {b:?}, angle: phi }}
      rrr BC(B), EC(E) -> C {{ lengths: ({l2:?}, {l3:?}), mode: {} }} point P on BC at ({u:?}, {v:?});",
            mode(is_left)
        ),
        names: [&["C", "P"], &["BC", "EC"], &[]],
        by_hand: format!(
            "five_bar([{a:?}, {b:?}], [{gx:?}, {gy:?}], [{l2:?}, {l3:?}], {}, [{u:?}, {v:?}]) -> FiveBar",
            sign(is_left)
        ),
    })
}

fn arm(random: &mut Random) -> Option<Row> {
    let [a, b] = [length(random, 0.1, 0.3), length(random, 0.05, 0.15)];
    let [gx, gy] = [length(random, 0.5, 0.9), length(random, -0.4, 0.4)];
    let (e, is_ahead) = (length(random, 0.01, 0.1), is(random));
    let [u, v] = [length(random, 0.02, 0.3), length(random, -0.15, 0.15)];
    // The nearest that the pin comes is a quarter of the farthest.
    let (far, reach) = (gx.hypot(gy), a + b);
    ((far - reach).hypot(e) >= 0.25 * (far + reach)).then(|| Row {
        name: "arm",
        inputs: "two [theta: angle, phi: angle]",
        ranges: TURN.into(),
        statements: format!(
            "ground A(0, 0), D({gx:?}, {gy:?}); crank AB(A) -> B {{ length: {a:?}, angle: theta }}
      crank BC(B) -> C {{ length: {b:?}, angle: phi, relative_to: AB }}
      rpr block(C), rod(D) {{ offset: {e:?}, mode: {} }} point P on rod at ({u:?}, {v:?});",
            sense(is_ahead)
        ),
        names: [&["C", "P"], &["rod"], &["block"]],
        by_hand: format!(
            "arm([{a:?}, {b:?}], [{gx:?}, {gy:?}], {e:?}, {}, [{u:?}, {v:?}]) -> Arm",
            sign(is_ahead)
        ),
    })
}

/// From 25° to 155° between cylinder and bar, as far as the cylinder may be this long.
fn strokes([x, y]: [f64; 2], length: f64) -> Option<[f64; 2]> {
    let d = x.hypot(y);
    // A cylinder is not much shorter than the bar.
    let is_sound = |s: &f64| {
        let cosine = (s * s + length * length - d * d) / (2.0 * s * length);
        *s >= 0.5 * length && cosine.abs() <= 25_f64.to_radians().cos()
    };
    let sound: Vec<_> = (1..1000).map(|step| f64::from(step) / 1000.0).filter(is_sound).collect();
    let [low, high] = [*sound.first()?, *sound.last()?];
    let is_whole = sound.len() == ((high - low) * 1000.0).round() as usize + 1;
    (is_whole && high - low > 0.1).then_some([low, high])
}

fn excavator(random: &mut Random) -> Option<Row> {
    let [fx, fy] = [length(random, 0.1, 0.3), length(random, -0.3, -0.1)];
    let [k, j] = [
        [length(random, 0.1, 0.4), length(random, 0.05, 0.2)],
        [length(random, 0.5, 0.9), length(random, -0.1, 0.1)],
    ];
    let [boom, stick] = [0; 2].map(|_| length(random, 0.15, 0.5));
    let [is_left, is_other] = [0; 2].map(|_| is(random));
    let [u, v] = [length(random, 0.02, 0.3), length(random, -0.15, 0.15)];
    let lift = strokes([fx, fy], boom)?;
    let reach = strokes([j[0] - k[0], j[1] - k[1]], stick)?;
    let ([kx, ky], [jx, jy]) = (k, j);
    Some(Row {
        name: "excavator",
        inputs: "two [lift: length, reach: length]",
        ranges: format!("[{lift:?}, {reach:?}]"),
        statements: format!(
            "ground O(0, 0), F({fx:?}, {fy:?});
      rrr lifter(F), boom(O) -> G {{ lengths: (lift, {boom:?}), mode: {} }}
      point K on boom at ({kx:?}, {ky:?}); point J on boom at ({jx:?}, {jy:?});
      rrr pusher(K), stick(J) -> H {{ lengths: (reach, {stick:?}), mode: {} }}
      point P on stick at ({u:?}, {v:?});",
            mode(is_left),
            mode(is_other)
        ),
        names: [&["H", "P"], &["boom", "stick"], &[]],
        by_hand: format!(
            "excavator([{fx:?}, {fy:?}], ({boom:?}, {}), [{k:?}, {j:?}], ({stick:?}, {}), [{u:?}, {v:?}]) -> Excavator",
            sign(is_left),
            sign(is_other)
        ),
    })
}
