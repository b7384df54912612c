//! Bodies against the geometry that they stand for: lines run through the joints that they hold, blocks
//! lie on their guides, and guides are where their carriers bring them.

use gallery::declarations::{flying_shear, jansen_leg};
use gallery::motions::turn;
use linkage_core::mechanism;
use linkage_core::sketch::Film;

use super::xml::{Element, numbers, parse};

/// Coordinates in a path are rounded to 0.1 px, the place of a group to 0.01 px and its turn to 0.001°,
/// 0.012 px at the far end of a page of 720 px: 0.071 + 0.007 + 0.006 px at most.
const ROUNDED: f64 = 0.09;

type Spot = [f64; 2];

fn distance(a: Spot, b: Spot) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The distance of a spot from a stretch.
fn from_stretch(spot: Spot, [a, b]: [Spot; 2]) -> f64 {
    // Densely enough: a hundredth of a pixel at 720 px.
    let at = |k: u32| f64::from(k) / 72_000.0;
    let on = |share: f64| [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
    (0..=72_000).map(|k| distance(spot, on(at(k)))).fold(f64::MAX, f64::min)
}

/// The signed distance of a spot from the endless line through two others, positive to its left (on the
/// page, whose y points down).
fn from_line(spot: Spot, [a, b]: [Spot; 2]) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let off = [spot[0] - a[0], spot[1] - a[1]];
    (along[1] * off[0] - along[0] * off[1]) / along[0].hypot(along[1])
}

/// A group's place on the page as a function.
fn seat(group: &Element) -> impl Fn(Spot) -> Spot {
    let transform = group.attribute("transform").expect("a body stands somewhere");
    let seat = numbers(&transform.replace("translate", " ").replace("rotate", " "));
    let (sin, cos) = seat.get(2).copied().unwrap_or(0.0).to_radians().sin_cos();
    let [x, y] = [seat[0], seat[1]];
    move |[u, v]| [x + cos * u - sin * v, y + sin * u + cos * v]
}

/// The drawing of a link in its first pose: its lines, and the middles of its blocks.
#[derive(Debug, Default)]
struct Body {
    lines: Vec<Vec<Spot>>,
    blocks: Vec<Spot>,
}

impl Body {
    fn of(root: &Element, link: &str) -> Self {
        let mut body = Self::default();
        let elements = root.all();
        for group in elements.iter().filter(|e| e.attribute("data-link") == Some(link)) {
            let place = seat(group);
            for child in &group.children {
                let number = |name: &str| -> f64 {
                    child.attribute(name).expect("a rectangle has it").parse().unwrap()
                };
                match &child.name[..] {
                    "path" => {
                        let path = child.attribute("d").unwrap();
                        let flat = numbers(&path.replace(['M', 'L'], " ").replace('Z', " "));
                        let mut line: Vec<Spot> =
                            flat.chunks(2).map(|spot| place([spot[0], spot[1]])).collect();
                        if path.ends_with('Z') {
                            line.push(line[0]);
                        }
                        body.lines.push(line);
                    }
                    // The paper behind a block hides what is under it, and has its size.
                    "rect" if child.attribute("stroke").is_some() => {
                        let [x, y] = ["x", "y"].map(number);
                        let [width, height] = ["width", "height"].map(number);
                        body.blocks.push(place([x + width / 2.0, y + height / 2.0]));
                    }
                    _ => {}
                }
            }
        }
        body
    }

    fn stretches(&self) -> impl Iterator<Item = [Spot; 2]> {
        self.lines.iter().flat_map(|line| line.windows(2).map(|ends| [ends[0], ends[1]]))
    }

    /// The distance of a spot from the nearest of the lines.
    fn away(&self, spot: Spot) -> f64 {
        self.stretches().map(|ends| from_stretch(spot, ends)).fold(f64::MAX, f64::min)
    }

    /// The stretch of these ends, whichever comes first.
    fn has(&self, ends: [Spot; 2]) -> bool {
        let is = |[a, b]: [Spot; 2]| distance(a, ends[0]).max(distance(b, ends[1])) < ROUNDED;
        self.stretches().any(|[a, b]| is([a, b]) || is([b, a]))
    }
}

/// The picture, and where it should show a point in its first pose.
fn drawn(film: &Film) -> (Element, impl Fn(&str) -> Spot) {
    let view = film.view().unwrap();
    let pixels = move |name: &str| {
        let at = film.point(0, name).unwrap();
        view.pixels([at.x, at.y])
    };
    (parse(&film.to_svg().unwrap()), pixels)
}

#[test]
fn every_link_runs_through_its_own_joints_and_no_others() {
    let film = flying_shear::FlyingShear::new().film(turn());
    let (root, at) = drawn(&film);
    let joints = [("AB", "AB"), ("BC", "BC"), ("DC", "DC")];
    for (link, own) in joints {
        let body = Body::of(&root, link);
        for joint in own.chars().map(String::from) {
            assert!(body.away(at(&joint)) < ROUNDED, "{link} misses {joint}: {body:?}");
        }
        for joint in ["A", "B", "C", "D"].into_iter().filter(|joint| !own.contains(joint)) {
            assert!(body.away(at(joint)) > 20.0, "{link} runs through {joint}: {body:?}");
        }
    }
    assert!(Body::of(&root, "BC").away(at("blade")) < ROUNDED);
    // Two dyads on one pin, and points that lie on a link.
    let film = jansen_leg::JansenLeg::new().film(turn());
    let (root, at) = drawn(&film);
    let elements = root.all();
    let joints = elements.iter().filter_map(|element| element.attribute("data-point"));
    let joints: Vec<&str> = joints.collect();
    assert!(joints.len() > 5, "{joints:?}");
    for joint in joints {
        let links = elements.iter().filter_map(|element| element.attribute("data-link"));
        let through = links.filter(|link| Body::of(&root, link).away(at(joint)) < ROUNDED).count();
        assert!(through >= 1, "nothing runs through {joint}");
    }
}

mechanism! {
    /// Offsets everywhere: of a block on a rail, of a bar beside its pivot, of a slot and its yoke.
    struct Aside {
        input q: angle;
        ground A(0, 0), D(0.5m, -0.4m);
        guide rail through (0.2m, -0.9m) along 20deg;
        guide bed through (0, 0.7m) along -10deg;
        crank AB(A) -> B { length: 0.3m, angle: q }
        rrp BE(B), block(rail) -> E { length: 1.1m, offset: 0.15m, mode: ahead }
        rpr sleeve(B), lever(D)  { offset: 0.12m, mode: ahead }
        rpp pin(B), yoke(bed)    { slot: 70deg, offsets: (0.1m, 0.06m) }
    }
}

#[test]
fn a_block_lies_on_its_guide_and_a_stub_ties_it_to_its_pin() {
    let film = Aside::new().film(turn());
    let ((root, at), view) = (drawn(&film), film.view().unwrap());
    let body = Body::of(&root, "block");
    let [middle] = body.blocks[..] else { panic!("one block: {body:?}") };
    // By the declaration: the rail on the page, and the pin 0.15 m to the left of it.
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    let rail = [[0.2, -0.9], [0.2 + cos, -0.9 + sin]].map(|spot| view.pixels(spot));
    let pin = at("E");
    assert!((from_line(pin, rail) - 0.15 * view.scale).abs() < 1e-6, "{}", from_line(pin, rail));
    assert!(from_line(middle, rail).abs() < ROUNDED, "{}", from_line(middle, rail));
    assert!((distance(middle, pin) - 0.15 * view.scale).abs() < ROUNDED);
    assert!(body.has([middle, pin]), "{body:?}");
}

#[test]
fn a_bar_runs_through_its_sleeve_and_passes_its_pivot_at_the_offset() {
    let film = Aside::new().film(turn());
    let ((root, at), view) = (drawn(&film), film.view().unwrap());
    let body = Body::of(&root, "lever");
    let (pivot, sleeve) = (at("D"), at("B"));
    assert_eq!(Body::of(&root, "sleeve").blocks.len(), 1);
    assert!(distance(Body::of(&root, "sleeve").blocks[0], sleeve) < ROUNDED);
    let bars: Vec<_> =
        body.stretches().filter(|&ends| from_stretch(sleeve, ends) < ROUNDED).collect();
    let [bar] = bars[..] else { panic!("one bar under the sleeve: {body:?}") };
    let off = from_line(pivot, bar);
    assert!((off.abs() - 0.12 * view.scale).abs() < 2.0 * ROUNDED, "{off}");
    // The pivot is tied to the bar by the shortest way.
    let ties =
        body.stretches().filter(|&[a, b]| distance(a, pivot).min(distance(b, pivot)) < ROUNDED);
    let ties: Vec<f64> = ties.map(|[a, b]| distance(a, b)).collect();
    let [tie] = ties[..] else { panic!("one stub at the pivot: {body:?}") };
    assert!((tie - 0.12 * view.scale).abs() < 2.0 * ROUNDED, "{tie}");
}

#[test]
fn a_slot_runs_through_its_pin_at_its_angle_to_the_rail() {
    let film = Aside::new().film(turn());
    let ((root, at), view) = (drawn(&film), film.view().unwrap());
    let yoke = Body::of(&root, "yoke");
    let slot = yoke.stretches().filter(|&ends| from_stretch(at("B"), ends) < ROUNDED);
    let slot: Vec<_> = slot.collect();
    let [[a, b]] = slot[..] else { panic!("one slot under the pin: {yoke:?}") };
    // The rail runs at −10° and the slot 70° further; the page's y points down, and a line has two ways.
    let degrees = (-(b[1] - a[1])).atan2(b[0] - a[0]).to_degrees().rem_euclid(180.0);
    // A rounding of each end over its length.
    let turned = (2.0 * ROUNDED / distance(a, b)).to_degrees();
    assert!((degrees - 60.0).abs() < turned, "{degrees}");
    let [block] = yoke.blocks[..] else { panic!("one block: {yoke:?}") };
    let (sin, cos) = (-10_f64).to_radians().sin_cos();
    let bed = [[0.0, 0.7], [cos, 0.7 + sin]].map(|spot| view.pixels(spot));
    assert!(from_line(block, bed).abs() < ROUNDED, "{}", from_line(block, bed));
}

mechanism! {
    /// A guide that turns in its carrier, with a block on it.
    struct Turning {
        input q: angle;
        ground A(0, 0);
        crank wheel(A) -> W { length: 0.3m, angle: q }
        guide rail on wheel through W along 30deg + q / 2;
        slider cart(rail) -> T { slide: 0.2m }
    }
}

/// Where the guide is follows from the declaration: through W, at 30° + q/2 against the wheel.
#[test]
fn a_guide_that_turns_in_its_carrier_is_drawn_where_it_is() {
    for q in [0.4, 1.7, -2.0] {
        let film = Turning::new().film([q, q + 0.5, q + 1.0]);
        let ((root, at), view) = (drawn(&film), film.view().unwrap());
        let (sin, cos) = (30_f64.to_radians() + 1.5 * q).sin_cos();
        let corner = [0.3 * q.cos(), 0.3 * q.sin()];
        let rail = [corner, [corner[0] + cos, corner[1] + sin]].map(|spot| view.pixels(spot));
        let wheel = Body::of(&root, "wheel");
        // Beside the wheel's own bar, which runs from A to W.
        let is_own = |ends: [Spot; 2]| {
            let [a, w] = [at("A"), at("W")];
            distance(ends[0], a).min(distance(ends[1], a)) < ROUNDED
                && distance(ends[0], w).min(distance(ends[1], w)) < ROUNDED
        };
        let guide: Vec<_> = wheel.stretches().filter(|&ends| !is_own(ends)).collect();
        let [guide] = guide[..] else { panic!("one line beside the bar: {wheel:?}") };
        for end in guide {
            assert!(from_line(end, rail).abs() < ROUNDED, "{q}: {}", from_line(end, rail));
        }
        // It holds the block, 0.2 m along, in the middle: nothing else slides on it.
        let block = Body::of(&root, "cart").blocks[0];
        let middle = [0, 1].map(|part| 0.5 * (guide[0][part] + guide[1][part]));
        assert!(distance(block, middle) < 2.0 * ROUNDED, "{q}: {block:?} {middle:?}");
        assert!((distance(block, at("W")) - 0.2 * view.scale).abs() < ROUNDED);
    }
}

mechanism! {
    /// Guides on a bar: behind its end, before its beginning, and beside its middle.
    struct Carried {
        input q: angle;
        ground A(0, 0);
        crank AB(A) -> B { length: 0.4m, angle: 0.2 * q }
        guide over on AB through (0.6m, 0.2m) along 60deg;
        guide before on AB through (-0.2m, -0.3m) along -35deg;
        guide beside on AB through (0.15m, 0.25m) along 10deg;
        slider far(over) -> F  { slide: 0.1m + 0.02m * q }
        slider close(before) -> N { slide: -0.1m - 0.02m * q }
        slider side(beside) -> S { slide: 0.2m * q - 0.2m }
    }
}

/// The tie of a guide is the shortest way from any of the joints to any place of the guide.
#[test]
fn a_guide_is_tied_to_its_link_by_the_shortest_way() {
    let film = Carried::new().film([0.0, 1.0, 2.0]);
    let ((root, at), view) = (drawn(&film), film.view().unwrap());
    let body = Body::of(&root, "AB");
    // In the first pose the bar lies along the ground's x. Ends: 27 px beyond where blocks go.
    let guides = [
        ([0.6, 0.2], 60_f64, [0.1, 0.14]),
        ([-0.2, -0.3], -35.0, [-0.14, -0.1]),
        ([0.15, 0.25], 10.0, [-0.2, 0.2]),
    ];
    let mut inside = 0;
    for (through, degrees, travel) in guides {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let overrun = 27.0 / view.scale;
        let ends = [travel[0] - overrun, travel[1] + overrun]
            .map(|s| view.pixels([through[0] + s * cos, through[1] + s * sin]));
        assert!(body.has(ends), "{degrees}: no guide {ends:?} in {body:?}");
        let nearest = |joint: Spot| from_stretch(joint, ends);
        let (a, b) = (nearest(at("A")), nearest(at("B")));
        let (joint, least) = if a < b { (at("A"), a) } else { (at("B"), b) };
        let ties = body.stretches().filter_map(|[from, to]| {
            let [from, to] = if distance(from, joint) < ROUNDED { [from, to] } else { [to, from] };
            let is_tie = distance(from, joint) < ROUNDED && from_stretch(to, ends) < ROUNDED;
            is_tie.then_some((distance(from, to), to))
        });
        let ties: Vec<_> = ties.collect();
        let [(length, foot)] = ties[..] else { panic!("{degrees}: one tie of {body:?}") };
        assert!((length - least).abs() < 2.0 * ROUNDED, "{degrees}: {length} for {least}");
        inside += usize::from(distance(foot, ends[0]).min(distance(foot, ends[1])) > 1.0);
    }
    // Ties to ends and to a place between them are among these.
    assert!((1..3).contains(&inside), "{inside}");
}
