//! Whole machines with friction, stops, springs and unknowns: their pages compute as their solvers do.

use linkage_core::Record;

use super::hard;
use super::numbers::{Functions, Random, asked, compare, compare_by, has_node};

/// The answers of `forces`, which is given a load; of `holding` as well.
macro_rules! answers {
    ($($holding:ident)?) => {
        |solver, [q, v, a], loads| {
            let forces = solver.forces(q, v, a, loads[0]);
            vec![
                ("forces", forces.map(|forces| forces.into_array().into())),
                $((stringify!($holding), solver.$holding(q, loads[0]).map(|ends| ends.into())),)?
            ]
        }
    };
}

/// Every stop pushes in some poses and does not in others.
#[test]
fn stopped_machines_compute_alike() {
    if !has_node() {
        return;
    }
    let stopped = hard::Stopped::new();
    let pages = [("Stopped", stopped.page().to_html().unwrap())];
    let solver = |random: &mut Random| hard::Stopped {
        mu: random.from([0.0, 1.0]),
        upper: random.about(0.8),
        stiffness: random.about(2e5),
    };
    let asked = asked(&pages, "Stopped", &[], solver, answers!(holding));
    let refused = asked.lines.matches(": Jams|").count();
    assert!(refused > 100, "{refused}");
    compare(&asked);
    let pushes = (0..60).map(|step| {
        let f = stopped.forces(0.1 * f64::from(step), 3.0, 0.0, 0.0).unwrap();
        [f.end.force != 0.0, f.swing.gap < 0.0]
    });
    let pushes: Vec<_> = pushes.collect();
    for stop in 0..2 {
        let count = pushes.iter().filter(|pushes| pushes[stop]).count();
        assert!(count > 5 && count < 55, "{count}");
    }
}

/// Behind an equation there are stops and springs, and no friction is offered.
#[test]
fn stopped_searches_compute_alike() {
    if !has_node() {
        return;
    }
    let sought = hard::Sought::new();
    let pages = [("Sought", sought.page().range("x", 0.17..=0.33).to_html().unwrap())];
    let solver =
        |random: &mut Random| hard::Sought { rod: random.about(0.25), lower: random.about(0.2) };
    let asked = asked(&pages, "Sought", &[[0.14, 0.36]], solver, answers!());
    let refused = asked.lines.matches("NoSolution|theta|").count();
    assert!(refused > 100, "{refused}");
    compare(&asked);
}

/// Half of the angles are those of a parallelogram, at which nothing rubs, and half those of an antiparallelogram.
#[test]
fn joints_that_do_not_turn_compute_alike() {
    if !has_node() {
        return;
    }
    let parallel = hard::Parallel::new();
    let pages = [("Parallel", parallel.page().to_html().unwrap())];
    let solver = |random: &mut Random| hard::Parallel { mu: random.from([0.0, 0.4]) };
    let asked = asked(&pages, "Parallel", &[], solver, answers!(holding));
    compare(&asked);
    for step in 1..314 {
        let theta = 0.01 * f64::from(step);
        let f = parallel.forces(theta, 7.0, 3.0, 50.0).unwrap();
        assert_eq!([f.block.P_friction, f.r.K_friction, f.losses], [0.0; 3], "{theta}");
        assert!(parallel.forces(-theta, 7.0, 3.0, 50.0).unwrap().losses > 0.0, "{theta}");
    }
}

/// The browser's own functions, and numbers made of them, are within two units in the last place.
#[test]
fn functions_of_the_browser_are_close() {
    if !has_node() {
        return;
    }
    let library = hard::Library::new();
    let pages = [("Library", library.page().to_html().unwrap())];
    let solver = |random: &mut Random| hard::Library { mu: random.from([0.0, 0.4]) };
    let asked = asked(&pages, "Library", &[], solver, |solver, [q, v, a], _| {
        vec![
            ("forces", solver.forces(q, v, a).map(|forces| forces.into_array().into())),
            ("holding", solver.holding(q).map(|ends| ends.into())),
        ]
    });
    compare_by(&asked, Functions::Browser);
}

/// Friction that jams at some poses, takes guarded steps at others, and is smooth in some joints.
#[test]
fn joints_that_rub_compute_alike() {
    if !has_node() {
        return;
    }
    let rubbing = hard::Rubbing::new();
    let pages = [("Rubbing", rubbing.page().to_html().unwrap())];
    let solver = |random: &mut Random| hard::Rubbing { mu: random.from([0.0, 1.2]) };
    let asked = asked(&pages, "Rubbing", &[], solver, answers!(holding));
    let refused = |how: &str| asked.lines.matches(how).count();
    assert!(refused(": Jams|") > 100, "{}", refused(": Jams|"));
    let counts = compare(&asked);
    // A machine at rest has forces where its joints jam.
    assert!(counts.contains("unheld") && !counts.contains("\"unheld\":0,"), "{counts}");
}
