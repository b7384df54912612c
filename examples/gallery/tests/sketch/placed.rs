//! Where a picture puts things against `position`, for every driver and group.

use gallery::declarations::{crank_rocker_slider, excavator, jansen_leg, six_bar, whitworth};
use linkage_core::mechanism;
use linkage_core::sketch::{Drawn, Film};
use linkage_core::{Mechanism, Tracker};

use super::xml::{numbers, parse};

mechanism! {
    /// Every driver and group, on the ground and on moving links, and dimensions that inputs drive.
    struct Everything {
        input q: angle;
        input s: length;
        param side: mode = left;

        ground A(0, 0), D(0.9m, 0.15m);
        guide rail through (0.2m, -0.9m) along 20deg;
        guide post through (1.6m, -0.4m) along 90deg;

        crank AB(A) -> B         { length: 0.3m, angle: q }
        crank wheel(D)           { angle: 30deg - 2 * q }
        point W on wheel at (0.2m, 0.1m);
        guide slot on wheel through W along 40deg;
        guide tilt through (-0.8m, 0.6m) along 0.2 * q;
        slider cart(tilt) -> T   { slide: 0.4m + s, offset: 0.1m + s / 4 }
        rrr BC(B), DC(D) -> C    { lengths: (0.9m + s, 0.8m), mode: side }
        point P on DC at polar (0.4m, 50deg);
        rrp BE(B), block(rail) -> E { length: 2.1m, offset: 0.1m, mode: ahead }
        rpr sleeve(P), bar(A)    { offset: 0.05m, mode: ahead }
        prp first(slot), second(post) -> S { offsets: (0.1m, 0) }
        rpp pin(C), yoke(rail)   { slot: 70deg, offsets: (0.1m, 0.05m) }
        point Q at (0.3m + s, 1.2m + 0.1m * q);
        point V on AB at (0.1m, s);
    }
}

/// Numbers from 0 to 1 (xorshift).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Every row of the solver's outputs against the film's points and links, at a thousand random
/// inputs; and that what one cannot place the other cannot.
pub(super) fn compare<M: Mechanism<Scalar = f64>>(
    solver: &M,
    ranges: &[[f64; 2]],
    film: impl Fn(&[M::Inputs]) -> Film,
) {
    let mut random = Random(0x1234_5678_9abc_def1);
    let inputs: Vec<M::Inputs> = (0..1000)
        .map(|_| {
            M::inputs(|nth| ranges[nth][0] + (ranges[nth][1] - ranges[nth][0]) * random.next())
        })
        .collect();
    let film = film(&inputs);
    let mut solved = 0;
    for (pose, &q) in inputs.iter().enumerate() {
        let Ok(rows) = solver.position(q) else {
            let mut points = film.points().iter();
            assert!(points.any(|name| film.point(pose, name).is_err()), "{} {pose}", M::NAME);
            continue;
        };
        solved += 1;
        for (name, &value) in M::OUTPUTS.iter().zip(rows.as_ref()) {
            // An output without a dot in its name is no part of the picture.
            let Some((name, part)) = name.split_once('.') else { continue };
            let drawn = match part {
                "x" => film.point(pose, name).unwrap().x,
                "y" => film.point(pose, name).unwrap().y,
                "angle" => {
                    let direction = film.link(pose, name).unwrap().direction;
                    // The same direction, whichever of ±π it is called.
                    assert!((direction.cos - value.cos()).abs() < 1e-9, "{name} {pose}");
                    assert!((direction.sin - value.sin()).abs() < 1e-9, "{name} {pose}");
                    continue;
                }
                _ => continue,
            };
            assert!((drawn - value).abs() < 1e-9, "{} {name}.{part} {pose}", M::NAME);
        }
    }
    println!("{}: {solved} of 1000 poses", M::NAME);
    assert!(solved > 300, "{}: {solved}", M::NAME);
}

const TURN: [f64; 2] = [-7.0, 7.0];

#[test]
fn a_picture_is_where_the_solver_is_for_every_driver_and_group() {
    let everything = Everything::new();
    compare(&everything, &[TURN, [-0.05, 0.05]], |path| everything.film(path.iter().copied()));
    let jansen = jansen_leg::JansenLeg::new();
    compare(&jansen, &[TURN], |path| jansen.film(path.iter().map(|q| q[0])));
    let six = six_bar::SixBar::new();
    compare(&six, &[TURN], |path| six.film(path.iter().map(|q| q[0])));
    let shaper = whitworth::Whitworth::new();
    compare(&shaper, &[TURN], |path| shaper.film(path.iter().map(|q| q[0])));
    let slider = crank_rocker_slider::CrankRockerSlider::new();
    compare(&slider, &[TURN], |path| slider.film(path.iter().map(|q| q[0])));
    let digger = excavator::Excavator::new();
    let ranges = [[2.1, 2.8], [2.6, 3.5], [1.75, 2.45]];
    compare(&digger, &ranges, |path| digger.film(path.iter().copied()));
}

mechanism! {
    /// Its bars lie on one line twice a turn, and a constant mode would fold it there.
    struct Parallelogram {
        input theta: angle;
        param elbow: mode = left;
        ground A(0, 0), D(2m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }
        point P on BC at (1m, 0.5m);
    }
}

#[test]
fn a_film_that_follows_the_motion_is_where_the_tracker_is() {
    let solver = Parallelogram::new();
    // A turn and a half; no pose lies on a change point, but poses next to it do.
    let path: Vec<f64> = (0..=90).map(|k| 0.3 + f64::from(k) * 0.105).collect();
    let film = solver.film(path.iter().copied()).following();
    let fixed = solver.film(path.iter().copied());
    let (mut tracker, mut parted) = (Tracker::new(solver), 0);
    assert!(film.gaps().is_empty());
    for (pose, &theta) in path.iter().enumerate() {
        let p = tracker.position(theta).unwrap();
        for (name, at) in [("B", p.B), ("C", p.C), ("P", p.P)] {
            let drawn = film.point(pose, name).unwrap();
            assert!((drawn.x - at.x).hypot(drawn.y - at.y) < 1e-9, "{name} {pose}");
        }
        // In a parallelogram the coupler keeps its direction.
        let (b, c) = (film.point(pose, "B").unwrap(), film.point(pose, "C").unwrap());
        assert!((c.x - b.x - 2.0).hypot(c.y - b.y) < 1e-6, "{pose}");
        let other = fixed.point(pose, "C").unwrap();
        parted += usize::from((other.x - c.x).hypot(other.y - c.y) > 0.1);
    }
    assert!(parted > 30, "{parted}");
}

/// The seats of bodies in the text, against `link` and `point`.
fn seats<S: Drawn>(solver: &S, q: S::Input) {
    let sketch = linkage_core::sketch::Sketch::of(solver, q).unwrap();
    let (view, root) = (sketch.view().unwrap(), parse(&sketch.to_svg().unwrap()));
    let mut seen = 0;
    for element in root.all() {
        let (Some(name), Some(transform)) =
            (element.attribute("data-link"), element.attribute("transform"))
        else {
            continue;
        };
        let link = sketch.link(name).unwrap();
        let origin = view.pixels([link.origin.x, link.origin.y]);
        let seat = numbers(&transform.replace("translate", " ").replace("rotate", " "));
        let angle = -link.direction.sin.atan2(link.direction.cos).to_degrees();
        let turned = seat.get(2).copied().unwrap_or(0.0);
        // A rod has its pin for an origin, a slot or a block of a driven offset its foot.
        if (seat[0] - origin[0]).hypot(seat[1] - origin[1]) > 1.0 {
            continue;
        }
        seen += 1;
        assert!(
            (seat[0] - origin[0]).abs() < 0.006 && (seat[1] - origin[1]).abs() < 0.006,
            "{name}"
        );
        let off = (turned - angle + 540.0).rem_euclid(360.0) - 180.0;
        assert!(off.abs() < 0.006, "{name}: {turned} for {angle}");
    }
    assert!(seen >= S::PLAN.links.len(), "{seen}");
}

#[test]
fn transforms_are_the_frames_of_the_links() {
    for nth in 0..20 {
        let q = 0.31 * f64::from(nth);
        seats(&jansen_leg::JansenLeg::new(), q);
        seats(&six_bar::SixBar::new(), q);
        seats(&whitworth::Shaper::new(), q);
        seats(&crank_rocker_slider::CrankRockerSlider::new(), q);
    }
}
