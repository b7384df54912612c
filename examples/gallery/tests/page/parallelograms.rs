//! Drawn parallelograms, behind rockers, in chains and on moving links, and links of given angle between bars: their pages
//! compute as their solvers do, through all change points.

use linkage_core::sketch::SketchError;
use linkage_core::{Record, mechanism};

use super::numbers::{Asked, Random, asked, compare, has_node};

mechanism! {
    /// A wiper for two blades: crank, rod, rocker, and a tie rod to the second rocker.
    pub struct Wiper {
        input theta: angle;
        load wind: force;
        ground A(0, 0), D(-250mm, 60mm), H(350mm, 60mm);
        pin B(45mm, 0), C(-245mm, -20mm), E(-320mm, 50mm), F(280mm, 50mm), tip1(-250mm, 660mm), tip2(350mm, 610mm);
        link AB(A, B);
        link rod(B, C);
        link first(D, C, E, tip1);
        link tie(E, F);
        link right_(H, F, tip2);
        drive AB.angle = theta;
        mass 0.4kg on tip1;
        mass 0.3kg on tip2;
        mass 0.2kg on tie uniform;
        force (wind, 0) on tip2;
    }
}

mechanism! {
    /// A square that is driven at one crank.
    pub struct Square {
        input theta: angle;
        ground J0(0, 0), J1(100mm, 0);
        pin J2(0, 100mm), J3(100mm, 100mm);
        link link_1(J0, J2);
        link link_3(J1, J3);
        link link_2(J2, J3);
        drive link_1.angle = theta;
    }
}

mechanism! {
    /// The rods of a locomotive: three wheels.
    pub struct Rods {
        input theta: angle;
        load steam: force;
        ground A(0, 0), D(1.4m, 0), G(2.9m, 10mm);
        pin B(0.2m, 0.2m), C(1.6m, 0.2m), F(3.1m, 0.21m);
        link first(A, B), second(D, C), third(G, F), rod(B, C), rear(C, F);
        drive first.angle = theta;
        mass 80kg on rod uniform;
        mass 60kg on rear uniform;
        force (steam, 0) on F;
    }
}

mechanism! {
    /// A lamp: a parallelogram on the moving side of another.
    pub struct Lamp {
        input theta: angle;
        ground A(0, 0), D(0, 60mm);
        pin B(300mm, 100mm), C(300mm, 160mm), E(450mm, 350mm), F(450mm, 410mm);
        link arm(A, B), guide_arm(D, C), head(B, C), upper(B, E), bar(C, F), shade(E, F);
        drive arm.angle = theta;
        drive upper.angle = 2 * theta + atan(250 / 150) - 2 * atan(100 / 300);
    }
}

mechanism! {
    /// Sides that are as long by one expression, which a parameter is in.
    pub struct Sides {
        input theta: angle;
        param side = 0.3m;
        load push: force;
        ground A(0, 0), D(0.9m, 0.15m);
        crank AB(A) -> B { length: side, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (hypot(0.9m, 0.15m), side), mode: parallel }
        mass 2kg on BC uniform;
        force (push, 0) on C;
        output C, BC, DC, BC.C, DC.D, theta.drive;
    }
}

mechanism! {
    /// Two links of given angle in a row between two bars.
    pub struct Carried {
        input u, v: angle;
        ground A(0, 0), D(3m, 0.2m);
        pin B(0.4m, 1m), P(1.3m, 1.4m), C(2.4m, 1.1m), X(1m, 2m);
        link front(A, B), first(B, P, X), second(P, C), rear(D, C);
        drive first.angle = u;
        drive second.angle - first.angle = v;
    }
}

fn page(name: &'static str, html: Result<String, SketchError>) -> [(&'static str, String); 1] {
    [(name, html.unwrap())]
}

/// Compares them, and returns how many of the answers are refusals.
fn refused(asked: &Asked) -> usize {
    compare(asked);
    asked.lines.lines().filter(|line| line.contains('|')).count()
}

#[test]
fn drawn_parallelograms_compute_alike() {
    if !has_node() {
        return;
    }
    let pages = page("Wiper", Wiper::new().page().to_html());
    let wiper = asked(
        &pages,
        "Wiper",
        &[],
        |_| Wiper::new(),
        |solver, [q, v, a], loads| {
            let forces = solver.forces(q, v, a, loads[0]);
            vec![("forces", forces.map(|forces| forces.into_array().into()))]
        },
    );
    assert_eq!(refused(&wiper), 0);
    let pages = page("Square", Square::new().page().to_html());
    let square = asked(&pages, "Square", &[], |_| Square::new(), |_, _, _| Vec::new());
    assert_eq!(refused(&square), 0);
    let pages = page("Rods", Rods::new().page().to_html());
    let rods = asked(
        &pages,
        "Rods",
        &[],
        |_| Rods::new(),
        |solver, [q, v, a], loads| {
            let forces = solver.forces(q, v, a, loads[0]);
            vec![("forces", forces.map(|forces| forces.into_array().into()))]
        },
    );
    assert_eq!(refused(&rods), 0);
    let pages = page("Lamp", Lamp::new().page().to_html());
    let lamp = asked(&pages, "Lamp", &[], |_| Lamp::new(), |_, _, _| Vec::new());
    assert_eq!(refused(&lamp), 0);
}

/// A side below zero is refused by its group.
#[test]
fn parallelograms_with_a_parameter_compute_alike() {
    if !has_node() {
        return;
    }
    let pages = page("Sides", Sides::new().page().to_html());
    let solver = |random: &mut Random| Sides { side: random.from([-0.05, 0.5]) };
    let sides = asked(&pages, "Sides", &[], solver, |solver, [q, v, a], loads| {
        let forces = solver.forces(q, v, a, loads[0]);
        let found = solver.forward_dynamics(q, v, a, loads[0]);
        vec![
            ("forces", forces.map(|forces| forces.into_array().into())),
            ("forward_dynamics", found.map(|found| vec![found])),
        ]
    });
    assert!(sides.lines.contains("Invalid|"), "no side below zero");
    assert!(refused(&sides) > 100);
}

/// Within reach and beyond it.
#[test]
fn links_of_given_angle_compute_alike() {
    if !has_node() {
        return;
    }
    let carried = Carried::new();
    let page_of = carried.page().range("u", 0.0..=1.0).range("v", -1.0..=0.0);
    let pages = page("Carried", page_of.to_html());
    let ends = [[-0.8, 1.6], [-2.0, 0.8]];
    let asked = asked(&pages, "Carried", &ends, |_| Carried::new(), |_, _, _| Vec::new());
    let refused = refused(&asked);
    assert!((100..1900).contains(&refused), "{refused}");
    assert!(
        asked.lines.contains("OutOfReach|front, rear, first, second|"),
        "{}",
        Carried::new().position([3.0, 0.0]).unwrap_err()
    );
}
