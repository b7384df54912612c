//! Statements about forces: their trees, and what does not parse.

use super::{body, check_statements};

#[test]
fn statements_about_forces_have_trees() {
    let (tree, mistakes) = body(
        "gravity (0, -g); load cut, work: force; mass 2kg on BC at G inertia 0.1(kg*m^2);
         mass 2 + m on BC at (x, 0); mass 1kg on BC uniform; mass 2kg on C; inertia J on AB;
         force (0, -cut) on blade; force (0, -f) in BC on P; force (a + b) / 2 between P and Q;
         torque t on DC; torque -t between ground and DC;
         stop DC.angle between (a, 110deg) { stiffness: k }
         stop low 2 * AB.angle - DC.angle between (0, b) { stiffness: k, damping: 5 }",
    );
    assert_eq!(mistakes, "");
    assert_eq!(
        tree,
        "gravity (0, (-g))
load cut, work: force
mass 2kg on BC at G inertia 0.1(kg^1 m^2)
mass (2 + m) on BC at (x, 0)
mass 1kg on BC uniform
mass 2kg on C
inertia J on AB
force (0, (-cut)) on blade
force (0, (-f)) in BC on P
force ((a + b) / 2) between P and Q
torque t on DC
torque (-t) between ground and DC
stop DC.angle between (a, 110deg) { stiffness: k }
stop low ((2 * AB.angle) - DC.angle) between (0, b) { stiffness: k, damping: 5 }"
    );
}

#[test]
fn statements_about_forces_that_do_not_parse() {
    const MASS: &str = "a mass is `mass 2kg on BC at G`, `… on BC at (x, y)`, `… on BC uniform` or, \
                        on a pin or point, `mass 2kg on C`";
    const FORCE: &str = "a force is `force (fx, fy) on P` or `force f between P and Q`";
    const AXES: &str = "a force f across a link is `force (0, f) in LINK on P`: behind `in` stands the \
                        body along whose axes the components lie";
    const TORQUE: &str = "a torque is `torque t on BC` or `torque t between BC and DC`";
    const STOP: &str = "a stop is `stop DC.angle between (20deg, 110deg) { stiffness: 2e4(N*m/rad) }`, of an \
                        angle, a slide or a distance, and may have a name";
    let rows: &[(&str, String)] = &[
        (
            "gravity -9.81;",
            "-: expected `(gx, gy)`, found `-` / gravity is an acceleration in ground axes: \
             `gravity (0, -9.81);`"
                .to_string(),
        ),
        ("mass BC;", format!(";: expected `on`, found `;` / {MASS}")),
        ("mass 2kg on BC at;", format!(";: expected a point or `(x, y)`, found `;` / {MASS}")),
        ("mass 2kg at G;", format!("at: expected `on`, found `at` / {MASS}")),
        (
            "inertia J;",
            ";: expected `on`, found `;` / an inertia is `inertia 0.1(kg*m^2) on AB`".to_string(),
        ),
        (
            "force 5N on P;",
            format!(
                "on: a force on a point has two components; write `force (fx, fy) on P` / {FORCE}"
            ),
        ),
        (
            "force f in arm (0, 1) on pad;",
            format!("in: write both components in front: `force (fx, fy) in arm on P` / {AXES}"),
        ),
        (
            "force (0, f) on pad in arm;",
            format!("in: write `force (fx, fy) in arm on pad` / {AXES}"),
        ),
        (
            "force (0, f) on jaw at (1m, 0);",
            "at: declare a point: `point P on LINK at (1m, 0);` / a force acts on a point, by its \
             name: `… on P`"
                .to_string(),
        ),
        (
            "load stone = 200kN;",
            "=: write `load stone: force;` / a load's value is an argument of each call; one that stays \
             is a `param` or a `let`"
                .to_string(),
        ),
        ("force (1, 2) P;", format!("P: expected `on` or `in`, found `P` / {FORCE}")),
        ("force 5N between P;", format!(";: expected `and`, found `;` / {FORCE}")),
        ("torque t DC;", format!("DC: expected `on` or `between`, found `DC` / {TORQUE}")),
        (
            "load cut;",
            ";: say what `cut` is: `load cut: force;` / a load is a `force`, a `torque` or a \
             `number`"
                .to_string(),
        ),
        ("load : force;", ":: expected the name of a load, found `:`".to_string()),
        (
            "ground inertia(0, 0);",
            "inertia: `inertia` is a reserved word; choose another name / statements of this and \
             of later versions are made of it"
                .to_string(),
        ),
        (
            "stop ram.slide between 0.3m { stiffness: 5 }",
            format!("0.3m: expected `(from, to)`, found `0.3m` / {STOP}"),
        ),
        ("stop ram.slide { stiffness: 5 }", format!("{{: expected `between`, found `{{` / {STOP}")),
        (
            "friction 0.1;",
            ";: expected `at`, `on` or `between`, found `;` / friction is `friction 0.1 at C radius 8mm` \
             of a pin, `friction 0.1 on BC at C radius 8mm` where more links meet, or `friction 0.1 on \
             ram` of what slides"
                .to_string(),
        ),
        (
            "drive theta by 5N;",
            "5N: expected a load, found `5N` / a load that drives an input is named behind it: `drive \
             theta by pull;`"
                .to_string(),
        ),
    ];
    for (source, expected) in rows {
        check_statements(&[(source, expected)]);
    }
}
