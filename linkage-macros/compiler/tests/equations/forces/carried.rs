//! Places that move in their link: what drives them pushes back on what they read.

use super::*;

/// A point reads an earlier slide, in each kind of placement; nothing else is loaded.
#[test]
fn a_place_that_reads_a_slide_pushes_back_on_it() {
    for place in [
        "point T on AB at (0.2 + 0.3 * ram.slide, 0.4 - 0.6 * ram.slide);",
        "point T on AB at polar(0.2 + 0.3 * ram.slide, ram.slide / 0.7m);",
        "point T on AB at distances (0.2 + 0.3 * ram.slide, 0.5 - 0.3 * ram.slide) left;",
    ] {
        let source = format!(
            "struct M {{ input q: angle; input s: length; ground A(0, 0);
            guide rail through (0.3, -0.6) along 10deg;
            crank AB(A) -> B {{ length: 0.3, angle: q }} slider ram(rail) -> P {{ slide: s }}
            {place} force (20, -7) on T; }}"
        );
        check(place, &source, &[[0.7, 1.3, -0.6], [0.41, -0.4, 0.9]]);
    }
}

/// A bar's drive pushes its ends apart, so the push is the effort of an input that is in its length alone;
/// no more of the load on a third corner than what the triangle's geometry brings there.
#[test]
fn a_triangle_on_a_rod_loads_its_drive_by_its_geometry() {
    const SOURCE: &str = "struct M { input q: angle; input s: length; ground A(0, 0), D(0.9, 0.15);
        crank AB(A) -> B { length: 0.3, angle: q }
        rrr BC(B), DC(D) -> C { lengths: (0.6 + s, 0.5), mode: right }
        point X on BC at distances (0.4, 0.5) left; force (20, -7) on X; output BC.push; }";
    let inputs = [[0.7, 1.3, -0.6], [0.05, -0.4, 0.9]];
    check("triangle", SOURCE, &inputs);
    let mechanism = with_every_input_asked(mechanism(SOURCE));
    let builder = GraphBuilder::new(passes::RULES);
    let free = InputMotion::free(&mechanism, &builder);
    let kinematics = Kinematics::of(&builder, &mechanism, free);
    let walk = Walk::of(&kinematics);
    let bar = mechanism.links.iter().position(|link| link.name == "BC").expect("it is there");
    let push = walk.components(Effort::Push(LinkId(bar as u32)))[0].id;
    let effort = walk.input_efforts()[1].id;
    let (_, values) = evaluated(&mechanism, builder.graph(), &inputs);
    let [push, effort] = [push, effort].map(|id| &values[id.index()]);
    assert!(push.sub(effort).to_f64().abs() < 1e-40, "{} {}", push.to_f64(), effort.to_f64());
    assert!(push.to_f64().abs() > 1.0);
}
