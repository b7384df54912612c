//! The groups of class II.

use linkage_core::sketch::{SketchError, Theme};
use linkage_core::{Sense, Side, mechanism};

use super::annotations::Figure;
use super::placing::at;

mechanism! {
    struct Rrr {
        input x, y: length;
        param side: mode = left;
        point B at (x, y);
        point D at (x + 1.3m, y + 0.12m);
        rrr BC(B), DC(D) -> C { lengths: (0.85m, 0.78m), mode: side }
    }
}

mechanism! {
    struct Rrp {
        input x, y: length;
        param sense: mode = ahead;
        ground K(-1.05m, 0);
        guide rail through K along 0deg;
        point B at (x, y);
        rrp BC(B), block(rail) -> C { length: 0.9m, offset: 0.2m, mode: sense }
    }
}

mechanism! {
    struct Rpr {
        input x, y: length;
        param sense: mode = ahead;
        point D at (0 * x, 0 * y);
        point B at (x, y);
        rpr block(B), bar(D) { offset: 0.3m, mode: sense }
    }
}

mechanism! {
    struct Prp {
        input s: length;
        ground K(0, 0), L(1.5m, 0.15m);
        guide first through K along 20deg;
        guide second through L along 110deg;
        prp p(first), q(second) -> C { offsets: (0.2m, 0.2m + s) }
    }
}

mechanism! {
    struct Rpp {
        input x, y: length;
        ground K(0, 0);
        guide rail through K along 0deg;
        point B at (x, y);
        rpp block(B), yoke(rail) { slot: 65deg, offsets: (0.22m, 0.22m) }
    }
}

pub(super) fn rrr(theme: Theme) -> Result<String, SketchError> {
    let solver = Rrr::new();
    let sketch = solver.sketch([0.0, 0.0])?;
    let other = Rrr { side: Side::Right, ..solver }.sketch([0.0, 0.0])?;
    let [b, c, d] = [at(&sketch, "B")?, at(&sketch, "C")?, at(&sketch, "D")?];
    let below = at(&other, "C")?;
    let (first, second) = (sketch.link("BC")?, sketch.link("DC")?);
    let text = "rrr BC(B), DC(D) -> C { lengths: (l1, l2), mode: left }";
    Ok(Figure::new(sketch, theme, 440.0, text)?
        .room([10.0, 10.0, 10.0, 150.0])
        .other(0, &[b, below])
        .other(1, &[d, below])
        .arrow([b, d])
        .joint(below)
        .axes(first)
        .axes(second)
        .distance([b, c], 34.0, "l1", [-10.0, -10.0])
        .distance([c, d], 34.0, "l2", [12.0, -10.0])
        .name(b, [-16.0, 4.0], "B")
        .name(d, [17.0, 0.0], "D")
        .name(c, [0.0, -17.0], "C")
        .link(0, [0.62 * c[0], 0.62 * c[1]], [16.0, 14.0], "BC")
        .link(1, [0.4 * c[0] + 0.6 * d[0], 0.4 * c[1] + 0.6 * d[1]], [-20.0, 14.0], "DC")
        .code(c, [92.0, -22.0], "mode: left")
        .code(below, [70.0, 4.0], "mode: right")
        .svg())
}

pub(super) fn rrp(theme: Theme) -> Result<String, SketchError> {
    let solver = Rrp::new();
    let sketch = solver.sketch([0.0, 0.75])?;
    let other = Rrp { sense: Sense::Behind, ..solver }.sketch([0.0, 0.75])?;
    let [k, b, c] = [at(&sketch, "K")?, at(&sketch, "B")?, at(&sketch, "C")?];
    let behind = at(&other, "C")?;
    let foot = [c[0], 0.0];
    let bar = sketch.link("BC")?;
    let text = "rrp BC(B), block(rail) -> C { length, offset, mode: ahead }";
    Ok(Figure::new(sketch, theme, 440.0, text)?
        .room([0.0, 16.0, 70.0, 44.0])
        .other(0, &[b, behind])
        .joint(behind)
        .rail([k, [1.05, 0.0]])
        .axis([b, [b[0], 0.0]])
        .axes(bar)
        .distance([b, c], 30.0, "length", [24.0, -8.0])
        .distance([foot, k], 42.0, "slide", [0.0, 12.0])
        .distance([c, foot], 36.0, "offset", [26.0, 0.0])
        .name(k, [0.0, -16.0], "K")
        .name(b, [-14.0, -10.0], "B")
        .name(c, [-4.0, -18.0], "C")
        .name([-0.25, 0.0], [0.0, -11.0], "rail")
        .link(0, [0.5 * (b[0] + c[0]), 0.5 * (b[1] + c[1])], [-20.0, 10.0], "BC")
        .link(1, foot, [-34.0, -14.0], "block")
        .code(c, [72.0, -22.0], "mode: ahead")
        .code(behind, [-30.0, -22.0], "mode: behind")
        .svg())
}

pub(super) fn rpr(theme: Theme) -> Result<String, SketchError> {
    let solver = Rpr::new();
    let sketch = solver.sketch([1.3, 0.4])?;
    let other = Rpr { sense: Sense::Behind, ..solver }.sketch([1.3, 0.4])?;
    let [b, d] = [at(&sketch, "B")?, at(&sketch, "D")?];
    let (bar, behind) = (sketch.link("bar")?, other.link("bar")?);
    let on = |pose: linkage_core::sketch::LinkPose, x: f64, y: f64| {
        let (cos, sin) = (pose.direction.cos, pose.direction.sin);
        [cos * x - sin * y, sin * x + cos * y]
    };
    // In the other mode the block is on the bar's negative side.
    let corner = on(behind, 0.0, 0.3);
    let foot = on(bar, 0.0, 0.3);
    let text = "rpr block(B), bar(D) { offset, mode: ahead }";
    Ok(Figure::new(sketch, theme, 440.0, text)?
        .room([46.0, 30.0, 60.0, 76.0])
        .other(1, &[d, corner, b])
        .other(1, &[corner, on(behind, 0.35, 0.3)])
        .axes(bar)
        .distance([foot, b], 30.0, "slide", [0.0, -12.0])
        .distance([d, foot], 40.0, "offset", [-28.0, 0.0])
        .name(b, [4.0, 20.0], "B")
        .name(d, [-6.0, 20.0], "D")
        .link(0, b, [36.0, 18.0], "block")
        .link(1, on(bar, 0.55, 0.3), [0.0, 16.0], "bar")
        .code(b, [78.0, -14.0], "mode: ahead")
        .code(corner, [60.0, 14.0], "mode: behind")
        .svg())
}

pub(super) fn prp(theme: Theme) -> Result<String, SketchError> {
    let sketch = Prp::new().sketch(0.0)?;
    let [k, l, c] = [at(&sketch, "K")?, at(&sketch, "L")?, at(&sketch, "C")?];
    let (p, q) = (sketch.link("p")?.direction, sketch.link("q")?.direction);
    // The feet of the pin on both guides.
    let first = [c[0] + 0.2 * p.sin, c[1] - 0.2 * p.cos];
    let second = [c[0] + 0.2 * q.sin, c[1] - 0.2 * q.cos];
    let ahead = |at: [f64; 2], u: linkage_core::Direction<f64>, by: f64| {
        [at[0] + by * u.cos, at[1] + by * u.sin]
    };
    let text = "prp p(first), q(second) -> C { offsets: (offset1, offset2) }";
    Ok(Figure::new(sketch, theme, 540.0, text)?
        .room([0.0, 30.0, 80.0, 30.0])
        .rail([k, ahead(first, p, 0.28)])
        .rail([l, ahead(second, q, 0.28)])
        .distance([first, k], 36.0, "p.slide", [12.0, 12.0])
        .distance([second, l], 40.0, "q.slide", [30.0, 0.0])
        .distance([first, c], 34.0, "offset1", [-28.0, -4.0])
        .distance([c, second], 40.0, "offset2", [-12.0, -20.0])
        .name(k, [-6.0, -16.0], "K")
        .name(l, [-12.0, 12.0], "L")
        .name(c, [-14.0, -8.0], "C")
        .link(0, first, [22.0, 12.0], "p")
        .link(1, second, [22.0, 14.0], "q")
        .svg())
}

pub(super) fn rpp(theme: Theme) -> Result<String, SketchError> {
    let sketch = Rpp::new().sketch([1.15, 1.05])?;
    let [k, b] = [at(&sketch, "K")?, at(&sketch, "B")?];
    let (yoke, slot) = (sketch.link("yoke")?.origin, sketch.link("block")?.direction);
    let foot = [yoke.x, yoke.y];
    let corner = [yoke.x, yoke.y + 0.22];
    let start = [corner[0] - 0.22 * slot.sin, corner[1] + 0.22 * slot.cos];
    let along = [corner[0] + 0.62 * slot.cos, corner[1] + 0.62 * slot.sin];
    let text = "rpp block(B), yoke(rail) { slot: 65deg, offsets: (offset1, offset2) }";
    Ok(Figure::new(sketch, theme, 380.0, text)?
        .room([30.0, 0.0, 60.0, 44.0])
        .rail([k, [yoke.x + 0.75, 0.0]])
        .axis([corner, along])
        .axis([corner, [corner[0] + 0.55, corner[1]]])
        .angle(corner, [0.0, 65.0], 62.0, "slot")
        .distance([start, b], 34.0, "block.slide", [-36.0, -8.0])
        .distance([foot, k], 42.0, "yoke.slide", [0.0, 12.0])
        .distance([corner, foot], 92.0, "offset1", [30.0, 0.0])
        .distance([corner, start], 26.0, "offset2", [-24.0, 12.0])
        .name(k, [-4.0, -16.0], "K")
        .name(b, [20.0, 8.0], "B")
        .name([0.25, 0.0], [0.0, -12.0], "rail")
        .link(0, b, [36.0, -10.0], "block")
        .link(1, foot, [34.0, -16.0], "yoke")
        .svg())
}
