//! Poses that a designer has to know of: limits, dead points, change points, groups of class III.

use linkage_core::sketch::{Sketch, SketchError, Theme};
use linkage_core::{Side, mechanism};

use super::annotations::Figure;
use super::placing::at;

mechanism! {
    struct NearLimit {
        input x, y: length;
        param side: mode = left;
        point B at (x, y);
        point D at (x + 1.56m, y + 0.1m);
        rrr BC(B), DC(D) -> C { lengths: (0.85m, 0.78m), mode: side }
    }
}

mechanism! {
    struct Press {
        input theta: angle;
        ground A(0, 0);
        guide bed through A along 0deg;
        crank AB(A) -> B { length: 0.42m, angle: theta }
        rrp BC(B), ram(bed) -> C { length: 0.95m, mode: ahead }
    }
}

mechanism! {
    struct FourBar {
        input theta: angle;
        param side: mode = left;
        ground A(0, 0), D(1.3m, 0);
        crank AB(A) -> B { length: 0.55m, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (1.3m, 0.55m), mode: side }
    }
}

// One pose alone: the bars DQ and ES stand where the plate needs them, so that the picture has no driver beside AB.
mechanism! {
    struct Triad {
        input theta: angle;
        ground A(0, 0), D(1.5m, 0.1m), E(0.9m, 1.3m);
        crank AB(A) -> B { length: hypot(0.1m, 0.3m), angle: theta }
        crank DQ(D) -> Q { length: hypot(0.45m, 0.4m), angle: atan2(0.4m, -0.45m) }
        crank ES(E) -> S { length: hypot(0.05m, 0.45m), angle: atan2(-0.45m, -0.05m) }
        rrr plate(Q), BP(B) -> P { lengths: (hypot(0.5m, 0.05m), hypot(0.45m, 0.25m)), mode: right }
        point R on plate at distances (hypot(0.2m, 0.35m), hypot(0.3m, 0.3m)) right;
    }
}

/// Both modes of a dyad that is nearly stretched.
pub(super) fn limit(theme: Theme) -> Result<String, SketchError> {
    let solver = NearLimit::new();
    let sketch = solver.sketch([0.0, 0.0])?;
    let other = NearLimit { side: Side::Right, ..solver }.sketch([0.0, 0.0])?;
    let [b, c, d] = [at(&sketch, "B")?, at(&sketch, "C")?, at(&sketch, "D")?];
    let below = at(&other, "C")?;
    let text = "a limit: |BD| = l1 + l2, both modes meet";
    Ok(Figure::new(sketch, theme, 440.0, text)?
        .room([10.0, 30.0, 10.0, 84.0])
        .other(0, &[b, below])
        .other(1, &[d, below])
        .joint(below)
        .distance([d, b], 100.0, "|BD|", [0.0, 14.0])
        .name(b, [-16.0, 4.0], "B")
        .name(d, [17.0, 0.0], "D")
        .name(c, [0.0, -17.0], "C")
        .code(c, [0.0, -36.0], "left")
        .code(below, [0.0, 22.0], "right")
        .svg())
}

/// A crank in one line with its rod, between two poses with the ram in one place.
pub(super) fn dead_point(theme: Theme) -> Result<String, SketchError> {
    let solver = Press::new();
    let sketch = solver.sketch(0.0)?;
    let [a, b, c] = [at(&sketch, "A")?, at(&sketch, "B")?, at(&sketch, "C")?];
    let mut figure = Figure::new(
        sketch,
        theme,
        480.0,
        "a dead point of the ram over theta; a limit of theta over ram.slide",
    )?
    .room([10.0, 0.0, 40.0, 10.0]);
    for theta in [0.7, -0.7] {
        let beside = solver.sketch(theta)?;
        let [b, c] = [at(&beside, "B")?, at(&beside, "C")?];
        figure = figure.other(0, &[a, b]).other(1, &[b, c]).joint(b);
    }
    Ok(figure.name(a, [-2.0, 26.0], "A").name(b, [0.0, 20.0], "B").name(c, [0.0, 28.0], "C").svg())
}

/// A parallelogram just behind its line, and the other way on.
pub(super) fn change_point(theme: Theme) -> Result<String, SketchError> {
    let pose = |side| FourBar { side, ..FourBar::new() }.sketch(0.75);
    let height = |sketch: &Sketch| at(sketch, "C").map(|[_, y]| y);
    let (left, right) = (pose(Side::Left)?, pose(Side::Right)?);
    let (sketch, other) =
        if height(&left)? > height(&right)? { (left, right) } else { (right, left) };
    let [a, b, c, d] = [at(&sketch, "A")?, at(&sketch, "B")?, at(&sketch, "C")?, at(&sketch, "D")?];
    let crossed = at(&other, "C")?;
    let text = "behind a change point: a parallelogram, or crossed";
    Ok(Figure::new(sketch, theme, 440.0, text)?
        .room([10.0, 10.0, 20.0, 20.0])
        .other(1, &[b, crossed])
        .other(2, &[d, crossed])
        .joint(crossed)
        .name(a, [-14.0, -6.0], "A")
        .name(b, [-8.0, -16.0], "B")
        .name(c, [10.0, -16.0], "C")
        .name(d, [16.0, 4.0], "D")
        .svg())
}

/// A plate on three bars: no dyad can come first.
pub(super) fn class_three(theme: Theme) -> Result<String, SketchError> {
    let sketch = Triad::new().sketch(f64::atan2(0.3, 0.1))?;
    let [a, b, p, q, r] = [
        at(&sketch, "A")?,
        at(&sketch, "B")?,
        at(&sketch, "P")?,
        at(&sketch, "Q")?,
        at(&sketch, "R")?,
    ];
    let [d, e] = [at(&sketch, "D")?, at(&sketch, "E")?];
    Ok(Figure::new(sketch, theme, 440.0, "class III: a plate on three bars")?
        .room([10.0, 24.0, 20.0, 24.0])
        .name(a, [-16.0, -6.0], "A")
        .name(b, [-14.0, -8.0], "B")
        .name(p, [-4.0, 20.0], "P")
        .name(q, [6.0, 18.0], "Q")
        .joint(r)
        .name(r, [-16.0, -2.0], "R")
        .name(d, [16.0, -8.0], "D")
        .name(e, [18.0, 0.0], "E")
        .svg())
}
