//! Every reaction of a six-bar over a turn of its crank, as bearings are sized by them: the twelve
//! numbers of its joints and the driving torque, and what each pin carries as a polar chart, in the axes
//! of the ground for the housing and in those of a link for the pin.
//!
//! Crank 0.4 m at 10 rad/s, an RPR group with a rod of 1.6 m about a pivot 1 m below, and an RPP group
//! whose yoke runs on a rail 0.8 m above. Masses of crank, block and rod are those of a course work on
//! mechanism dynamics; those of slider and yoke are cut off in its text, and invented here. The text's own
//! twelve numbers, without them, are held by `cargo test --test dynamics published`.

use std::f64::consts::TAU;

use charts::{COLOURS, Curve, Panel, rounded};
use linkage_core::{Direction, Force, SolveError, mechanism};

mechanism! {
    /// Crank, RPR and RPP group.
    pub struct SixBar {
        input theta: angle;
        ground A(0, 0), D(0, -1m);
        guide rail through (0, 800mm) along 0deg;

        crank AB(A) -> B           { length: 400mm, angle: theta }
        rpr   block(B), rod(D)     {}
        point E on rod at (1.6m, 0);
        rpp   slider(E), yoke(rail) { slot: 90deg }

        gravity (0, -9.8(m/s^2));
        mass 1.2kg on AB at (0.2m, 0) inertia 0.016(kg*m^2);
        mass 1.5kg on block at (0, 0);
        mass 10kg on rod at (0.8m, 0) inertia 2.2(kg*m^2);
        mass 1kg on slider at (0, 0);
        mass 4kg on yoke at (0, -150mm) inertia 0.1(kg*m^2);

        output AB, rod, AB.A, AB.B, block.rod, rod.D, slider.E, slider.yoke, yoke.rail, AB.drive;
    }
}

const OMEGA: f64 = 10.0;

fn main() -> Result<(), SolveError> {
    let machine = SixBar::new();
    println!("Forces in N on the link named first, couples in N·m; 10 rad/s\n");
    println!(
        " crank      AB.A            AB.B           block.rod          rod.D           slider.E    \
         slider.yoke yoke.rail  AB.drive"
    );
    println!(
        "   deg       x       y       x       y  normal  couple       x       y       x       y    \
         normal    normal       N·m"
    );
    for step in 0..=24 {
        let degrees = 15.0 * f64::from(step);
        let f = machine.forces(degrees.to_radians(), OMEGA, 0.0)?;
        let numbers = [
            f.AB.A.x,
            f.AB.A.y,
            f.AB.B.x,
            f.AB.B.y,
            f.block.rod.normal,
            f.block.rod.couple,
            f.rod.D.x,
            f.rod.D.y,
            f.slider.E.x,
            f.slider.E.y,
        ];
        print!("{degrees:6.0}");
        numbers.iter().for_each(|number| print!(" {:7.1}", rounded(*number, 1)));
        let [slot, rail] = [f.slider.yoke.normal, f.yoke.rail.normal].map(|n| rounded(n, 1));
        println!(" {slot:9.1} {rail:9.1} {:9.2}", rounded(f.AB.drive, 2));
    }
    chart(machine)
}

/// The components of a force along a link's axes.
fn seen_from(link: Direction, force: Force) -> (f64, f64) {
    let Direction { cos, sin } = link;
    (cos * force.x + sin * force.y, cos * force.y - sin * force.x)
}

fn chart(machine: SixBar) -> Result<(), SolveError> {
    let (mut torque, mut side) = (vec![], [vec![], vec![], vec![]]);
    let (mut ground, mut links) =
        ([vec![], vec![], vec![], vec![]], [vec![], vec![], vec![], vec![]]);
    for step in 0..=720 {
        let theta = TAU * f64::from(step) / 720.0;
        let (p, f) = (machine.position(theta)?, machine.forces(theta, OMEGA, 0.0)?);
        let degrees = theta.to_degrees();
        torque.push((degrees, f.AB.drive));
        let normals = [f.block.rod.normal, f.slider.yoke.normal, f.yoke.rail.normal];
        side.iter_mut().zip(normals).for_each(|(curve, normal)| curve.push((degrees, normal)));
        let joints = [(f.AB.A, p.AB), (f.AB.B, p.AB), (f.rod.D, p.rod), (f.slider.E, p.rod)];
        for (k, (force, link)) in joints.into_iter().enumerate() {
            ground[k].push((force.x, force.y));
            links[k].push(seen_from(link, force));
        }
    }
    let named = |names: &[&str], curves: Vec<Vec<(f64, f64)>>| {
        let curves = names.iter().zip(COLOURS).zip(curves);
        curves
            .map(|((name, colour), points)| Curve::named(name, colour, points))
            .collect::<Vec<_>>()
    };
    let of_pins = |names: &[&str], curves: Vec<Vec<(f64, f64)>>| {
        let curves = names.iter().zip(curves);
        curves
            .map(|(name, points)| Curve::named(name, charts::colour_of_pin(name), points))
            .collect::<Vec<_>>()
    };
    let degrees = "crank angle in degrees";
    let sides = ["block on rod", "slider in yoke", "yoke on rail"];
    let pins = ["A on crank", "B on crank", "D on rod", "E on slider"];
    let in_links = ["A, crank's axes", "B, crank's axes", "D, rod's axes", "E, rod's axes"];
    charts::write(
        "six_bar_reactions",
        "Reactions of a six-bar at 10 rad/s",
        2,
        vec![
            Panel::over(
                "Driving torque",
                [degrees, "torque in N·m"],
                vec![Curve::named("AB.drive", COLOURS[0], torque)],
            ),
            Panel::over("Normal forces", [degrees, "force in N"], named(&sides, side.into())),
            Panel::plane(
                "Pins, in the axes of the ground",
                ["force in N, x", "force in N, y"],
                of_pins(&pins, ground.into()),
            ),
            Panel::plane(
                "Pins, in the axes of their links",
                ["force in N, along", "force in N, across"],
                of_pins(&in_links, links.into()),
            ),
        ],
    );
    Ok(())
}
