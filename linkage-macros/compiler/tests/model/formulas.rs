//! Outputs of efforts, reactions, rates and loads.

use super::{CRANK, SIX_BAR, check, resolved};

/// The outputs of forces, in order.
fn asked(base: &str, statements: &str) -> Vec<String> {
    let (mechanism, mistakes) = resolved(&format!("{base} {statements}"));
    let dynamics = mechanism.unwrap_or_else(|| panic!("{mistakes}")).dynamics;
    dynamics.asked.iter().map(|asked| asked.path()).collect()
}

#[test]
fn formulas_stand_among_the_forces() {
    const RUBBING: &str = "load cut: force; mass 1kg on E; force (cut, 0) on E; \
                           friction 0.1 on BC at C radius 8mm; friction 0.12 on block; \
                           let law = cut - 2(N*s/m) * rate(block.slide);";
    let all = "output block.rail.friction, BC.C.friction, DC.C.friction, losses, law, \
               pv = hypot(BC.C.x, BC.C.y) / (16mm * 20mm) * 8mm * abs(rate(BC.angle)), \
               side = abs(block.rail.normal) + block.rail.couple / 60mm, plain = 2 * E.x, \
               work = losses - t.drive * rate(t), push = AB.drive / 1m, swing = shaking.couple / 1m;";
    let found = asked(SIX_BAR, &format!("{RUBBING} {all}"));
    let expected = [
        "block.rail.friction",
        "BC.C.friction",
        "DC.C.friction",
        "losses",
        "law",
        "pv",
        "side",
        "work",
        "push",
        "swing",
    ];
    assert_eq!(found, expected);
    let (mechanism, _) = resolved(&format!("{SIX_BAR} {RUBBING} {all}"));
    let outputs = mechanism.expect("it is legal").outputs;
    assert_eq!(
        outputs.iter().map(|output| output.field.to_string()).collect::<Vec<_>>(),
        ["plain"]
    );
}

#[test]
fn springs_and_stops_are_read() {
    let statements = "spring s between B and D { stiffness: 5(N/m), free_length: 1m }
                      stop low AB.angle between (0, 1) { stiffness: 5(N*m) }
                      output both = s.force + low.force / 1m, room = low.gap + 1rad;";
    assert_eq!(asked(CRANK, statements), ["both", "room"]);
}

#[test]
fn units_of_efforts_are_checked() {
    const LOADED: &str = "mass 1kg on B;";
    for (output, mistake) in [
        (
            "output w = t.drive + AB.A.x;",
            "AB.A.x: a force where a torque belongs / what stands left of the `+` is a torque",
        ),
        (
            "output w = AB.A;",
            "A: `AB.A` is a force; write `AB.A.x` or `AB.A.y` / an expression is made of single \
             numbers; its size is `hypot(AB.A.x, AB.A.y)`",
        ),
        (
            "output w = AB.A.z;",
            "z: `AB.A` has no `z` / it has `x` and `y`, and `friction` where it rubs",
        ),
        (
            "output AB.A.x;",
            "x: write `A.x` for the point, `AB.A` for the reaction / a point is known by its own name, \
             and the reaction's components are fields of the result; under a name of your own a \
             component is an output",
        ),
        ("output w = AB.D.x;", "D: `AB` does not touch `D` / there is `AB.drive` and `AB.A`"),
        (
            "output w = AB.A.friction;",
            "friction: nothing rubs at `AB.A` / as in `friction 0.1 on AB at A radius 8mm;`",
        ),
        (
            "output w = 2 * losses;",
            "losses: nothing rubs, so there are no losses / as in `friction 0.1 at C radius 8mm`",
        ),
        (
            "output w = rate(t.drive);",
            "t.drive: the rate of an effort is not known / it would follow from the rates of \
             accelerations, which no call is given",
        ),
        (
            "output w = AB.angle + rate(t) * 1s;",
            "AB.angle: `AB.angle` cannot stand here / a link's angle is known up to whole turns: it \
             stands in sums of angles, times an integer, because other ratios jump at ±π",
        ),
        (
            "output AB.A.friction;",
            "friction: nothing rubs at `AB.A` / as in `friction 0.1 on AB at A radius 8mm;`",
        ),
        (
            "output t.drive, losses;",
            "losses: nothing rubs, so there are no losses / as in `friction 0.1 at C radius 8mm`",
        ),
    ] {
        check(&[(CRANK, &format!("{LOADED} {output}"), mistake)]);
    }
}

#[test]
fn one_name_is_one_output() {
    let twice =
        |at: &str, name: &str| format!("{at}: the output `{name}` is given twice; remove one");
    for (statements, at, name) in [
        ("output w = B.x, w = t.drive;", "w#2", "w"),
        ("output w = t.drive, w = B.x;", "w#2", "w"),
        ("output w = t.drive, w = AB.drive;", "w#2", "w"),
        ("let law = 1(N*s) * rate(t); output law, law;", "law#3", "law"),
    ] {
        check(&[(CRANK, &format!("mass 1kg on B; {statements}"), &twice(at, name))]);
    }
    check(&[(
        CRANK,
        "mass 1kg on B; let law = 1(N*s) * rate(t); output law = t.drive;",
        "law#2: the name `law` is taken; choose another / `law` is a `let`",
    )]);
}

#[test]
fn forces_read_no_effort() {
    const REASON: &str = "a reaction follows from all forces, so none can depend on it; `friction 0.1 at C \
                          radius 8mm` does, and `friction 0.1 on ram` of what slides";
    for (statements, at) in [
        ("torque 2 * t.drive on AB;", "drive"),
        ("let f = 2 * AB.drive; torque f on AB;", "drive"),
        ("friction 0.1 + AB.drive / 1(N*m) at A radius 8mm;", "drive"),
        ("torque 0.1 * 20mm * AB.A on AB;", "A"),
    ] {
        let refused = format!("{at}: only an output reads a reaction or an effort / {REASON}");
        check(&[(CRANK, &format!("mass 1kg on B; {statements}"), &refused)]);
    }
}

#[test]
fn rates_without_forces_are_no_output() {
    check(&[(
        CRANK,
        "output w = rate(t);",
        "w: nothing has mass and nothing acts, so there are no forces beside `w` / an output of rates \
         and loads stands in the result of `forces`; of rates alone, `velocity` gives those of every \
         output",
    )]);
}

#[test]
fn an_unknown_allows_what_power_tells() {
    const PRESS: &str = "input x: length; ground A(0, 0); guide bed through A along 0deg; \
                         unknown q: angle between (5deg, 175deg); \
                         crank AB(A) -> B { length: 80mm, angle: q } \
                         rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead } \
                         solve q { ram.slide = x, mode: falling } mass 1kg on C;";
    check(&[
        (PRESS, "output power = x.drive * rate(x), other = q.drive * rate(AB.angle);", ""),
        (
            PRESS,
            "output side = BC.C.x;",
            "x: no reactions beside `unknown q`; ask for `x.drive` / what holds the equation of `solve` \
             exerts a force as well: of `distance(P, Q) = l` a bar does, of `offset(P, guide) = h` a block, of any \
             other equation nobody says what",
        ),
    ]);
}

#[test]
fn friction_is_that_of_a_joint() {
    const RUBBING: &str = "mass 1kg on E; friction 0.12 on block; friction 0.1 on BC at C radius 8mm; \
                           friction 0.1 on block at E radius 8mm;";
    let refused = |at: &str| format!("friction#4: {at} / friction is that of a joint");
    for (output, at) in [
        ("output CE.friction;", "write `CE.E.friction`"),
        ("output w = 2 * CE.friction;", "write `CE.E.friction`"),
        ("output block.friction;", "name the joint: `block.E.friction` or `block.rail.friction`"),
        ("output w = abs(DC.friction);", "write `DC.C.friction`"),
    ] {
        check(&[(SIX_BAR, &format!("{RUBBING} {output}"), &refused(at))]);
    }
    check(&[(
        SIX_BAR,
        &format!("{RUBBING} output AB.friction;"),
        "friction#4: nothing rubs at a joint of `AB` / as in `friction 0.1 on AB` of what slides, `friction \
         0.1 on AB at C radius 8mm` of a pin",
    )]);
}

/// The effort of a length is a force, and that of an angle a torque.
#[test]
fn a_drive_is_measured_as_its_input() {
    const SLIDER: &str = "input s: length; guide rail through (0, 0) along 0deg; \
                          slider ram(rail) -> P { slide: s } mass 1kg on P;";
    let refused = |found: &str, wanted: &str, at: &str| {
        format!("{at}: {found} where {wanted} belongs / what stands left of the `+` is {wanted}")
    };
    check(&[
        (SLIDER, "output w = 5N + s.drive + ram.drive;", ""),
        (SLIDER, "output w = 5(N*m) + s.drive;", &refused("a force", "a torque", "s.drive")),
        (CRANK, "mass 1kg on B; output w = 5(N*m) + t.drive + AB.drive;", ""),
        (
            CRANK,
            "mass 1kg on B; output w = 5N + t.drive;",
            &refused("a torque", "a force", "t.drive"),
        ),
        (
            SLIDER,
            "output w = 2 * ram.rail;",
            "rail: `ram.rail` is a normal force and a couple; write `ram.rail.normal` or \
             `ram.rail.couple` / an expression is made of single numbers",
        ),
    ]);
}
