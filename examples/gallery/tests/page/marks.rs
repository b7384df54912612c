//! Masses, weights, couples, wheels and drives: where a page has them against the solver's own numbers, and where a browser
//! draws them.

use std::f64::consts::PI;
use std::fmt::Write;

use linkage_core::sketch::shortened;

use super::browser::{Visit, scripted};
use super::hard::{Marked, MarkedLoads, Pushed};
use super::numbers::{Functions, asked, compare_by, has_node};

/// Gravity of the declaration.
const GRAVITY: [f64; 2] = [1.0, -9.81];

/// A pose as the solver has it: centres and masses, the couples on links, and the radii of both pairs of wheels.
struct Marks {
    centres: [[f64; 2]; 4],
    masses: [f64; 4],
    couples: [f64; 2],
    radii: [f64; 4],
}

impl Marks {
    fn of(solver: &Marked, theta: f64, twist: f64) -> Self {
        let at = solver.position(theta).expect("it turns");
        let pair = |x: f64, y: f64| [x, y];
        let centres = [
            pair(at.M.x, at.M.y),
            pair(at.P.x, at.P.y),
            // A uniform crank about A.
            pair(at.B.x / 2.0, at.B.y / 2.0),
            pair(at.G.x, at.G.y),
        ];
        // The second wheel is smaller by the ratio of a parameter and turns back; the planet turns three times against its arm of 60 mm, in a
        // ring three times as large. Inside, both have one sign.
        let gear = solver.base / (1.0 + solver.times);
        let radii = [solver.times * gear, -gear, 0.09, 0.03];
        Self { centres, masses: [solver.heavy, 2.0, 3.0, 1.0], couples: [twist, 5.0], radii }
    }

    fn weights(&self) -> [[f64; 2]; 4] {
        self.masses.map(|mass| GRAVITY.map(|g| mass * g))
    }

    /// In the order of a page's numbers.
    fn numbers(&self) -> Vec<f64> {
        let masses = self.centres.iter().zip(self.masses);
        let masses = masses.flat_map(|([x, y], mass)| [*x, *y, mass]);
        GRAVITY.into_iter().chain(masses).chain(self.couples).chain(self.radii).collect()
    }
}

/// A thousand poses, with other parameters and loads each.
#[test]
fn a_page_has_masses_and_wheels_where_the_solver_has_them() {
    if !has_node() {
        return;
    }
    let solver = Marked::new();
    let pages = [("Marked", solver.page().to_html().unwrap())];
    let asked = asked(
        &pages,
        "Marked",
        &[[-4.0, 4.0]],
        |random| Marked {
            far: random.about(solver.far),
            heavy: random.about(solver.heavy),
            base: random.about(solver.base),
            times: random.about(solver.times),
        },
        |solver, [q, ..], loads| vec![("marked", Ok(Marks::of(solver, q, loads[1]).numbers()))],
    );
    // Another program computes the places: it may round otherwise.
    compare_by(&asked, Functions::Browser);
}

/// Compares what is drawn with what the solver has, in pixels. Coordinates are rounded to a tenth.
const SEEN: &str = r##"
addEventListener("load", () => setTimeout(() => {
  const failures = [], told = [], is = (holds, ...words) => holds || failures.push(words.join(" "));
  const seatOfNode = (node) => /translate\(([-\d.]+),([-\d.]+)\)/.exec(node.getAttribute("transform")).slice(1).map(Number);
  const isShown = (node) => node.getAttribute("visibility") !== "hidden" && node.getAttribute("d") !== "";
  const lineOf = (path) => path.getAttribute("d").slice(1).split("M")[0].split("L").map((spot) => spot.split(" ").map(Number));
  const lengthOf = (path) => apart(...lineOf(path));
  const inNewtons = (text) => {
    const [number, unit] = text.textContent.split(" "), prefix = { m: 1e-3, k: 1e3, M: 1e6 };
    return +number * (/^[mkM]N/.test(unit) ? prefix[unit[0]] : 1);
  };
  // The angle of an arc about a place, anticlockwise positive.
  const turnOf = (path, [x, y]) => lineOf(path).reduce((sum, [u, v], k, all) => {
    if (!k) return 0;
    const [a, b] = [all[k - 1], [u, v]].map(([u, v]) => [u - x, y - v]);
    return sum + Math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  }, 0);
  let arrows = 0, arcs = 0;
  play(false);
  for (const { q, p, l, centres, weights, couples, radii, wheels, drive } of EXPECTED) {
    Object.assign(state, { q, p, l });
    due = SCALE;
    frame();
    const off = (place, node) => apart(onPage(place), seatOfNode(node)), scale = lengthOf(nodes.forceScale) / inNewtons(nodes.forceWords);
    centres.forEach((centre, k) => is(off(centre, nodes.masses[k]) < 0.5, q, "mass", k, "is off by", off(centre, nodes.masses[k])));
    weights.forEach((weight, k) => {
      const { path } = nodes.acting[k], size = Math.hypot(...weight);
      if (!isShown(path)) return is(size * scale < 1.2, q, "weight", k, "is not drawn");
      const [from, to] = lineOf(path), [dx, dy] = weight.map((part) => part * scale);
      is(apart(from, onPage(centres[k])) < 0.5, q, "weight", k, "begins elsewhere");
      // The scale's own length is rounded as well.
      is(apart(to, [from[0] + dx, from[1] - dy]) < 0.3 + 0.005 * size * scale, q, "weight", k, "ends at", to, "for", dx, dy);
      arrows++;
    });
    wheels.forEach((centre, k) => {
      const r = +/A([-\d.]+)/.exec(nodes.wheels[k].getAttribute("d"))[1];
      is(off(centre, nodes.wheels[k]) < 0.5, q, "wheel", k, "is off by", off(centre, nodes.wheels[k]));
      is(Math.abs(r - Math.abs(radii[k]) * view.scale) < 0.5, q, "wheel", k, "is", r, "large for", Math.abs(radii[k]) * view.scale);
    });
    // The wheels of the pair touch: their centres are as far apart as their radii together.
    is(Math.abs(apart(wheels[0], wheels[1]) - Math.abs(radii[0]) - Math.abs(radii[1])) < 1e-12, q, "the gears do not touch");
    const legend = nodes.coupleScale, legendLine = lineOf(legend.path), middle = [0, 1].map((k) => (Math.min(...legendLine.map((spot) => spot[k])) + Math.max(...legendLine.map((spot) => spot[k]))) / 2);
    const [bx, by] = legendLine[6], share = turnOf(legend.path, [bx, by + 9]) / inNewtons(legend.text);
    [...couples, drive].forEach((couple, k) => {
      const { path } = nodes.couples[k], at = onPage([wheels[1], wheels[0], wheels[0]][k]);
      if (!isShown(path)) return is(Math.abs(couple * share) < 0.1, q, "couple", k, "of", couple, "is not drawn");
      // Corners are rounded to a tenth of a pixel, those of the scale lie 9 px from its middle.
      is(Math.abs(turnOf(path, at) - couple * share) < 0.02 + 0.02 * Math.abs(couple * share), q, "couple", k, "turns by", turnOf(path, at), "for", couple * share);
      is(Math.sign(turnOf(path, at)) === Math.sign(couple), q, "couple", k, "turns the other way");
      arcs++;
    });
  }
  // At a ratio of one wheels roll on nothing, and the other marks stay.
  state.p = [state.p[0], 0, state.p[2], -1];
  due = SCALE;
  frame();
  is(!isShown(nodes.masses[0]) && isShown(nodes.masses[1]), "a mass of zero is drawn");
  is(!isShown(nodes.wheels[0]) && isShown(nodes.wheels[2]), "wheels roll on nothing");
  is(arrows >= 6 && arcs >= 6, arrows, "arrows and", arcs, "arcs are drawn");
  told.push(`${arrows} arrows, ${arcs} arcs`);
  parent.postMessage({ failures, "told": [...told, "looked"] }, "*");
}, 300));
"##;

/// Two poses, and one of them with other parameters, on a screen and on a phone.
#[test]
#[ignore = "needs chromium"]
fn a_browser_draws_masses_weights_wheels_and_couples_where_the_solver_has_them() {
    let (own, moved) = (Marked::new(), Marked { far: 0.25, heavy: 20.0, base: 0.35, times: 1.5 });
    let (push, twist, rate) = (60.0, 8.0, 2.0 * PI);
    let mut expected = String::new();
    for (solver, theta) in [(own, 0.6), (own, 2.5), (moved, 0.6)] {
        let marks = Marks::of(&solver, theta, twist);
        let at = solver.position(theta).expect("it turns");
        let forces =
            solver.forces(theta, rate, 0.0, MarkedLoads { push, twist }).expect("they follow");
        let wheels = [[0.0, 0.0], [solver.base, 0.0], [0.0, 0.0], [at.B.x, at.B.y]];
        write!(
            expected,
            "{{q: [{theta}], p: [{}, {}, {}, {}], l: [{push}, {twist}], centres: {:?}, weights: {:?}, couples: {:?}, radii: {:?}, wheels: {wheels:?}, drive: {:?}}},",
            solver.far, solver.heavy, solver.base, solver.times, marks.centres, marks.weights(), marks.couples, marks.radii, forces.theta.drive
        )
        .unwrap();
    }
    let html = own.page().rate("theta", rate).to_html().unwrap();
    let visit = |width| Visit { name: "Marked", html: html.clone(), width, steps: "" };
    let script = shortened(&format!("{{ const EXPECTED = [{expected}];\n{SEEN} }}"));
    let found =
        scripted(&[visit(1280), visit(360)], "marks", &["--force-prefers-reduced-motion"], |_| {
            script.clone()
        });
    println!("{found}");
    assert_eq!(found.matches("looked").count(), 2, "{found}");
    assert!(!found.contains("FAILED"), "{found}");
}

/// Drives that push, against the solver's: a cylinder at its far end along itself, and a block along its guide.
const PUSHED: &str = r##"
addEventListener("load", () => setTimeout(() => {
  const failures = [], is = (holds, ...words) => holds || failures.push(words.join(" "));
  const lineOf = (path) => path.getAttribute("d").slice(1).split("M")[0].split("L").map((spot) => spot.split(" ").map(Number));
  let seen = 0;
  play(false);
  for (const { q, pushes } of EXPECTED) {
    state.q = q;
    due = SCALE;
    frame();
    const [number, unit] = nodes.forceWords.textContent.split(" "), scale = apart(...lineOf(nodes.forceScale)) / (number * (unit === "kN" ? 1e3 : 1));
    pushes.forEach(([at, force], k) => {
      const { path, effort } = nodes.acting[2 + k], [from, to] = lineOf(path), [x, y] = onPage(at), end = [x + force[0] * scale, y - force[1] * scale];
      is(path.getAttribute("visibility") !== "hidden", q, effort, "is not drawn");
      // The length of the scale is rounded to a tenth of a pixel, as both ends are.
      is(apart(from, [x, y]) < 0.5 && apart(to, end) < 0.5, q, effort, "goes from", from, "to", to, "for", x, y, end);
      seen++;
    });
  }
  is(seen === 4, seen, "arrows");
  parent.postMessage({ failures, "told": ["looked"] }, "*");
}, 300));
"##;

#[test]
#[ignore = "needs chromium"]
fn a_browser_draws_the_drives_of_a_cylinder_and_a_block() {
    let solver = Pushed::new();
    let mut expected = String::new();
    for [s, x] in [[0.45, 0.2], [0.6, 0.3]] {
        let (at, still) = (solver.position([s, x]).expect("it stands"), [0.0; 2]);
        let forces = solver.forces([s, x], still, still).expect("they follow");
        let (dx, dy) = (at.G.x - 0.3, at.G.y + 0.2);
        let push = [dx, dy].map(|part| part / s * forces.s.drive);
        let slope = 30_f64.to_radians();
        let slide = [slope.cos(), slope.sin()].map(|part| part * forces.x.drive);
        // Along a slope of half the weight: 20 kg.
        assert!((forces.x.drive - 20.0 * 9.81 / 2.0).abs() < 1e-9);
        let (lift, block) = ([[at.G.x, at.G.y], push], [[at.P.x, at.P.y], slide]);
        write!(expected, "{{q: [{s}, {x}], pushes: [{lift:?}, {block:?}]}},").unwrap();
    }
    let page = solver.page().range("s", 0.4..=0.65).range("x", 0.1..=0.4);
    let html = page.rate("s", 0.0).to_html().unwrap();
    let visit = Visit { name: "Pushed", html, width: 1280, steps: "" };
    let script = shortened(&format!("{{ const EXPECTED = [{expected}];\n{PUSHED} }}"));
    let flags = ["--force-prefers-reduced-motion"];
    let found = scripted(&[visit], "pushed", &flags, |_| script.clone());
    assert!(found.contains("looked") && !found.contains("FAILED"), "{found}");
}
