//! Requested outputs.

use super::*;

#[test]
fn an_output_is_given_once() {
    check(&[
        (CRANK, "output B, B;", "B#2: the output `B` is given twice; remove one"),
        (CRANK, "output AB, AB.angle;", "angle: the output `AB` is given twice; remove one"),
        (CRANK, "output AB.angle, AB;", "AB#2: the output `AB` is given twice; remove one"),
        (
            CRANK,
            "output B.angle;",
            "angle: a point has no `angle`; it has `x` and `y` / write `B.x` or `B.y`; `output B` \
             gives both",
        ),
        (
            SIX_BAR,
            "output block.slide, block, block.slide;",
            "block#2: the output `block` is given twice; remove one\n\
             slide#2: the output `block` is given twice; remove one",
        ),
        (
            SIX_BAR,
            "output block.slide, block.slide;",
            "slide#2: the output `block` is given twice; remove one",
        ),
    ]);
}

#[test]
fn forces_are_asked_by_drives_and_joints() {
    const MASS: &str = "mass 1kg on B;";
    check(&[
        (
            CRANK,
            &format!("{MASS} output AB.torque;"),
            "torque: a link has no `torque`; name its drive, or the joint at which a force acts / there \
             is `AB.drive` and `AB.A`",
        ),
        (
            CRANK,
            "output AB.reaction;",
            "reaction: a link has no `reaction`; name its drive, or the joint at which a force acts / \
             nothing has mass and nothing acts, so there are no forces",
        ),
        (
            CRANK,
            &format!("{MASS} output A.force;"),
            "force: write `AB.A` / a reaction at `A` acts on a link, which is named in front",
        ),
        (
            CRANK,
            &format!("{MASS} output power;"),
            "power: there is no `power`; write `output energy` or the `drive` of an input / the power of \
             a drive is its effort times the rate that you give",
        ),
        (
            CRANK,
            "output angle(AB);",
            "angle: write `AB.angle` / what a link or a point has stands behind its name",
        ),
        (
            CRANK,
            "output reach = x(B);",
            "x: write `B.x` / what a link or a point has stands behind its name",
        ),
        (
            SIX_BAR,
            &format!("{MASS} output AB.torque;"),
            "torque: a link has no `torque`; name its drive, or the joint at which a force acts / there \
             is `AB.drive`, `AB.A` and `AB.B`",
        ),
    ]);
}

#[test]
fn a_name_stands_in_front() {
    const NUMBER: &str = "the name of a number is the field of the result";
    check(&[
        (
            CRANK,
            "output B as tip, AB;",
            "as: leave out `as tip` / the result has the field `B`, named as it is declared; rename it \
             there",
        ),
        (
            CRANK,
            "output B.x as reach;",
            &format!("as: write the name in front: `output reach = …` / {NUMBER}"),
        ),
        (
            CRANK,
            "let twice = 2 * AB.angle; output twice as turn;",
            &format!("as: write the name in front: `output turn = …` / {NUMBER}"),
        ),
    ]);
}

#[test]
fn an_output_is_a_result() {
    check(&[
        (
            CRANK,
            "output Bx;",
            "Bx: no point, link or `let` named `Bx`; a point with a similar name exists: `B`",
        ),
        (
            CRANK,
            "output t;",
            "t: `t` is an input, and an output is a point or a link / an expression of it is \
             given by a name: `output twice = 2 * t`",
        ),
        (
            GUIDE,
            "output rail;",
            "rail: `rail` is a guide, and an output is a point or a link / the link that \
             carries it has a direction",
        ),
        (
            CRANK,
            "output 2 * t;",
            "2 * t: an expression needs a name; write `output name = …` / the name is the field \
             of the result",
        ),
        (
            CRANK,
            "output blade, AB;",
            "blade: no point, link or `let` named `blade` / declared so far: `A`, `D`, `AB`, `B`",
        ),
    ]);
}

#[test]
fn a_link_gives_what_it_has() {
    check(&[
        (
            CRANK,
            "output AB.slide;",
            "slide: `AB` does not slide / no link of `crank AB` slides on a guide",
        ),
        (GUIDE, "output B.x, B, B.y, A.x;", ""),
        (GUIDE, "output B.x, B.x;", "x#2: the output `B_x` is given twice; remove one"),
        (
            GUIDE,
            "output B.speed;",
            "speed: rates need no output of their own; write `output B` / `velocity` gives that \
             of `B`, and `motion` its acceleration too",
        ),
        (
            CRANK,
            "output AB.omega;",
            "omega: rates need no output of their own; write `output AB.angle` / `velocity` \
             gives `AB.omega` and `motion` also `AB.alpha`",
        ),
        (
            CRANK,
            "output AB.x;",
            "x: `AB` is a link and has no `x`; name a point / a point of it is declared `point \
             P on AB at (x, y);`",
        ),
        (CRANK, "output motor.drive;", "motor: no link named `motor` / declared so far: `AB`"),
        (
            CRANK,
            "output AB.angel;",
            "angel: a link has no `angel`; one with a similar name exists: `angle` / it has \
             `angle`, `slide` if it slides, `margin` and `transmission`",
        ),
        (
            CRANK,
            "output AB.margin;",
            "margin: `crank` has no `margin` / a driver transmits what it is given; ask the \
             dyads that follow",
        ),
        (
            SIX_BAR,
            "output CE.slide;",
            "slide: `CE` does not slide / of `rrp CE, block`, `block` slides",
        ),
        (
            SIX_BAR,
            "output DC.slide;",
            "slide: `DC` does not slide / no link of `rrr BC, DC` slides on a guide",
        ),
        (
            SIX_BAR,
            "output AB.transmission;",
            "transmission: `crank` has no `transmission` / a driver transmits what it is given; \
             ask the dyads that follow",
        ),
        (
            GUIDE,
            "prp p(rail), q(rail) -> C { } output p.margin;",
            "rail#2: both links of `prp` stand on `rail` / two links on one guide never cross\n\
             margin: `prp` has no `margin` / it is never out of reach; `transmission` tells how \
             far from parallel",
        ),
        (
            SIX_BAR,
            "guide slot on CE through C towards E; rpr pin(B), fork(E) { offset: 1mm } output \
             slot, pin.margin, fork.slide;",
            "slot#2: `slot` is a guide, and an output is a point or a link / the link that \
             carries it has a direction\n\
             slide: `fork` does not slide / of `rpr pin, fork`, `pin` slides",
        ),
        (
            GUIDE,
            "output B.velocity;",
            "velocity: rates need no output of their own; write `output B` / `velocity` gives that \
             of `B`, and `motion` its acceleration too",
        ),
    ]);
}

#[test]
fn an_expression_has_a_name_of_its_own() {
    check(&[
        (CRANK, "output AB = t;", "AB: the name `AB` is taken; choose another / `AB` is a link"),
        (
            CRANK,
            "output twice = 2 * t, twice = 3 * t;",
            "twice#2: the output `twice` is given twice; remove one",
        ),
        (
            CRANK,
            "output sum = AB.margin;",
            "margin: `AB.margin` stands in no expression / a link has `angle`, and `slide` if \
             it slides",
        ),
        (
            CRANK,
            "output sum = AB.slide;",
            "slide: `AB` does not slide / no link of `crank AB` slides on a guide",
        ),
        (
            CRANK,
            "output sum = B.z;",
            "z: a point has no `z`; it has `x` and `y` / write `B.x` or `B.y`; `output B` gives \
             both",
        ),
        (
            CRANK,
            "output sum = AB.x;",
            "x: `AB.x` stands in no expression / a link has `angle`, and `slide` if it slides; a \
             point has `x` and `y`",
        ),
        (
            CRANK,
            "output sum = B + 1m;",
            "B: `B` is a point, not a number / its coordinates are `B.x` and `B.y`",
        ),
        (CRANK, "output B = t;", "B: the name `B` is taken; choose another / `B` is a point"),
    ]);
}

#[test]
fn parts_of_a_link_are_legal_outputs() {
    check(&[(
        SIX_BAR,
        "output BC.margin, BC.transmission, block.slide, block.angle, x = BC.angle - \
             DC.angle, E, half = block.slide / 2;",
        "",
    )]);
}
