//! Drivers, guides and points.

use linkage_core::mechanism;
use linkage_core::sketch::{Sketch, SketchError, Theme};

use super::annotations::Figure;

mechanism! {
    struct Crank {
        input q: angle;
        ground A(0, 0);
        crank AB(A) -> B { length: 1m, angle: q }
    }
}

mechanism! {
    struct Slider {
        input s: length;
        ground K(0, 0);
        guide rail through K along 0deg;
        slider ram(rail) -> P { slide: s, offset: 0.28m }
    }
}

mechanism! {
    struct OnLink {
        input s: length;
        ground B(0, 0);
        crank BC(B) -> C { length: 1.12m, angle: 12deg }
        point P on BC at (0.5m + s, 0.3m);
    }
}

mechanism! {
    struct Slot {
        input s: length;
        ground B(0, 0);
        crank BC(B) -> C { length: 1.2m, angle: 8deg }
        point P on BC at (0.35m, 0.28m);
        guide slot on BC through P along 25deg;
        slider shoe(slot) { slide: s }
    }
}

mechanism! {
    struct Polar {
        input s: length;
        ground B(0, 0);
        crank BC(B) -> C { length: 1.2m, angle: 8deg }
        point P on BC at polar (0.75m + s, 35deg);
        point R on BC at distances (0.55m, 0.95m) right;
    }
}

/// Where a point is, in metres.
pub(super) fn at(sketch: &Sketch, name: &str) -> Result<[f64; 2], SketchError> {
    sketch.point(name).map(|point| [point.x, point.y])
}

pub(super) fn crank(theme: Theme) -> Result<String, SketchError> {
    let sketch = Crank::new().sketch(0.6)?;
    let (a, b, link) = (at(&sketch, "A")?, at(&sketch, "B")?, sketch.link("AB")?);
    let figure = Figure::new(sketch, theme, 330.0, "crank AB(A) -> B { length, angle }")?;
    Ok(figure
        .axis([a, [1.0, 0.0]])
        .axes(link)
        .distance([a, b], 26.0, "length", [-18.0, -10.0])
        .angle(a, [0.0, 0.6_f64.to_degrees()], 56.0, "angle")
        .name(a, [-30.0, 14.0], "A")
        .name(b, [14.0, -10.0], "B")
        .link(0, [0.85 * b[0], 0.85 * b[1]], [12.0, 14.0], "AB")
        .svg())
}

pub(super) fn slider(theme: Theme) -> Result<String, SketchError> {
    let sketch = Slider::new().sketch(1.0)?;
    let (k, p) = (at(&sketch, "K")?, at(&sketch, "P")?);
    let foot = [p[0], 0.0];
    let figure = Figure::new(sketch, theme, 400.0, "slider ram(rail) -> P { slide, offset }")?;
    Ok(figure
        .room([0.0, 0.0, 30.0, 40.0])
        .rail([k, [1.22, 0.0]])
        .distance([foot, k], 40.0, "slide", [0.0, 12.0])
        .distance([p, foot], 34.0, "offset", [26.0, 0.0])
        .name(k, [-2.0, -16.0], "K")
        .name(p, [-2.0, -16.0], "P")
        .name([0.45, 0.0], [0.0, -12.0], "rail")
        .link(0, foot, [-28.0, -16.0], "ram")
        .svg())
}

pub(super) fn guide(theme: Theme) -> Result<String, SketchError> {
    let sketch = Slot::new().sketch(0.42)?;
    let [b, c, p] = [at(&sketch, "B")?, at(&sketch, "C")?, at(&sketch, "P")?];
    let (bar, slot) = (sketch.link("BC")?, sketch.link("shoe")?);
    let end = [p[0] + 0.7 * slot.direction.cos, p[1] + 0.7 * slot.direction.sin];
    let level = [p[0] + 0.62 * bar.direction.cos, p[1] + 0.62 * bar.direction.sin];
    let figure = Figure::new(sketch, theme, 420.0, "guide slot on BC through P along 25deg;")?;
    Ok(figure
        .axis([p, level])
        .rail([p, end])
        .axes(bar)
        .angle(p, [8.0, 33.0], 118.0, "along")
        .name(b, [4.0, 18.0], "B")
        .name(c, [16.0, -8.0], "C")
        .name(p, [-10.0, -12.0], "P")
        .link(0, [0.6 * c[0], 0.6 * c[1]], [0.0, 16.0], "BC")
        .link(1, [slot.origin.x, slot.origin.y], [-14.0, -22.0], "slot")
        .svg())
}

pub(super) fn point(theme: Theme) -> Result<String, SketchError> {
    let sketch = OnLink::new().sketch(0.0)?;
    let [b, c, p] = [at(&sketch, "B")?, at(&sketch, "C")?, at(&sketch, "P")?];
    let link = sketch.link("BC")?;
    let (cos, sin) = (link.direction.cos, link.direction.sin);
    let foot = [0.5 * cos, 0.5 * sin];
    let figure = Figure::new(sketch, theme, 400.0, "point P on BC at (x, y);")?;
    Ok(figure
        .room([0.0, 0.0, 0.0, 26.0])
        .axes(link)
        .distance([foot, b], 34.0, "x", [4.0, 12.0])
        .distance([foot, p], -46.0, "y", [12.0, 4.0])
        .axis([foot, p])
        .name(b, [10.0, 18.0], "B")
        .name(c, [16.0, -8.0], "C")
        .name(p, [-4.0, -16.0], "P")
        .svg())
}

pub(super) fn polar(theme: Theme) -> Result<String, SketchError> {
    let sketch = Polar::new().sketch(0.0)?;
    let [b, c] = [at(&sketch, "B")?, at(&sketch, "C")?];
    let [p, r] = [at(&sketch, "P")?, at(&sketch, "R")?];
    let text = "point P on BC at polar (r, phi);  point R on BC at distances (r1, r2) right;";
    let figure = Figure::new(sketch, theme, 430.0, text)?;
    Ok(figure
        .room([0.0, 20.0, 0.0, 20.0])
        .axis([b, c])
        .distance([b, p], 26.0, "r", [-8.0, -10.0])
        .angle(b, [8.0, 43.0], 110.0, "phi")
        .distance([b, r], -24.0, "r1", [-10.0, 10.0])
        .distance([r, c], -24.0, "r2", [10.0, 10.0])
        .name(b, [-4.0, -18.0], "B")
        .name(c, [16.0, -8.0], "C")
        .name(p, [10.0, -14.0], "P")
        .name(r, [0.0, 18.0], "R")
        .svg())
}
