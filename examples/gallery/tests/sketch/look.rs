//! Sizes and colours of what is drawn, read from the text of pictures.

use gallery::declarations::{excavator, flying_shear, six_bar, slider_crank};
use gallery::motions::turn;
use linkage_core::sketch::{Film, Theme};

use super::sample;
use super::xml::{Element, numbers, parse};

/// The elements of this kind that have all of these attributes.
fn having(root: &Element, name: &str, wanted: &[(&str, &str)]) -> usize {
    let has = |element: &&&Element| {
        element.name == name
            && wanted.iter().all(|&(attribute, value)| element.attribute(attribute) == Some(value))
    };
    root.all().iter().filter(has).count()
}

fn drawn(film: &Film) -> Element {
    parse(&film.to_svg().unwrap())
}

#[test]
fn every_part_has_the_size_of_its_symbol() {
    let shear = flying_shear::FlyingShear::new().film(turn()).trace("blade").poses(6);
    let root = drawn(&shear);
    // Crank and rocker are bars, the coupler a body; A, B, C, D are joints, the blade a dot.
    assert_eq!(having(&root, "path", &[("stroke-width", "5")]), 2);
    assert_eq!(having(&root, "path", &[("stroke-width", "4"), ("fill-opacity", ".16")]), 1);
    assert_eq!(having(&root, "circle", &[("r", "4.6"), ("stroke-width", "1.8")]), 4);
    assert_eq!(having(&root, "circle", &[("r", "4"), ("data-point", "blade")]), 1);
    assert_eq!(having(&root, "path", &[("d", "M0 0L-10 17H10Z"), ("stroke-width", "1.6")]), 2);
    let trace = [("data-trace", "blade"), ("fill", "none")];
    assert_eq!(having(&root, "g", &trace), 1);
    assert_eq!(having(&root, "path", &[("stroke-width", "5.2")]), 1);
    assert_eq!(having(&root, "path", &[("stroke-width", "1.6"), ("opacity", ".28")]), 3);
    let circle = [("stroke-width", "1"), ("stroke-dasharray", "9 3 2 3")];
    assert_eq!(having(&root, "circle", &circle), 1);
    let names = [("font-size", "13"), ("font-style", "italic"), ("stroke-width", "3")];
    assert_eq!(having(&root, "g", &names), 1);
    let piston = drawn(&slider_crank::OffsetSliderCrank::new().film(turn()));
    let block = [("width", "26"), ("height", "17"), ("rx", "2"), ("stroke-width", "2")];
    assert_eq!(having(&piston, "rect", &block), 1);
}

#[test]
fn pages_have_room_and_the_colours_of_their_theme() {
    for piece in sample() {
        let root = drawn(&piece.film);
        let [width, height] =
            ["width", "height"].map(|side| root.attribute(side).unwrap().parse::<f64>().unwrap());
        // Texts may stand in the margin and make the page wider.
        assert!(width <= 760.0 && height <= 640.0, "{}: {width} by {height}", piece.name);
        for theme in [Theme::Light, Theme::Dark] {
            let (text, palette) = (piece.film.to_svg_in(theme).unwrap(), theme.palette());
            for colour in [palette.paper, palette.ink, palette.quiet, palette.links[0]] {
                assert!(text.contains(colour), "{}: {colour}", piece.name);
            }
        }
    }
    let [light, dark] = [Theme::Light, Theme::Dark].map(Theme::palette);
    assert_eq!([light.paper, light.ink, light.quiet], ["#ffffff", "#222222", "#667079"]);
    assert_eq!([dark.paper, dark.ink, dark.quiet], ["#0d1117", "#e6edf3", "#7d8590"]);
    let links = ["#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
    assert_eq!(light.links, links);
    let links = ["#f08a3c", "#4ea1e0", "#2fc99b", "#e39cc4", "#f2b53b", "#7cc7f2"];
    assert_eq!(dark.links, links);
}

/// The share of light that a colour gives off (WCAG 2.2).
fn luminance(colour: &str) -> f64 {
    let part = |at: usize| {
        let share = f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap()) / 255.0;
        if share <= 0.040_45 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
    };
    0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
}

#[test]
fn whatever_is_written_stands_out_from_the_paper() {
    for theme in [Theme::Auto, Theme::Light, Theme::Dark] {
        let palette = theme.palette();
        for colour in [palette.ink, palette.quiet, palette.accent, palette.push] {
            let (a, b) = (luminance(colour), luminance(palette.paper));
            let contrast = (a.max(b) + 0.05) / (a.min(b) + 0.05);
            assert!(contrast >= 4.5, "{theme:?} {colour}: {contrast:.2}");
        }
    }
}

/// A picture for either scheme is the light one, and its rules turn it into the dark one.
#[test]
fn one_picture_is_light_and_dark() {
    for piece in sample() {
        let [auto, light, dark] = [Theme::Auto, Theme::Light, Theme::Dark]
            .map(|theme| piece.film.to_svg_in(theme).unwrap());
        let (head, rest) = auto.split_once(" class=\"auto\"><style>").expect("it has rules");
        let (rules, rest) = rest.split_once("</style>").unwrap();
        assert_eq!(format!("{head}>{rest}"), light, "{}", piece.name);
        let rules = rules.strip_prefix("@media (prefers-color-scheme:dark){").unwrap();
        let rules: Vec<&str> = rules.split_inclusive('}').filter(|rule| rule.len() > 1).collect();
        let mut turned = light;
        // In two steps, so that no colour is replaced twice.
        for (nth, rule) in rules.iter().enumerate() {
            let (attribute, _) = rule.strip_prefix(".auto [").unwrap().split_once(']').unwrap();
            assert!(turned.contains(attribute), "{}: nothing has {attribute}", piece.name);
            turned = turned.replace(attribute, &format!("<{nth}>"));
        }
        for (nth, rule) in rules.iter().enumerate() {
            let (_, set) = rule.split_once("]{").unwrap();
            let (property, colour) = set.trim_end_matches('}').split_once(':').unwrap();
            turned = turned.replace(&format!("<{nth}>"), &format!("{property}=\"{colour}\""));
        }
        assert_eq!(turned, dark, "{}", piece.name);
    }
}

/// The tube hides all of the rod but what its stroke needs, and the rod never leaves it.
#[test]
fn a_cylinder_is_as_long_as_its_stroke_asks() {
    let path = (0..=40).map(|k| [2.15 + 0.6 * f64::from(k) / 40.0, 2.65, 1.8]);
    let film = excavator::Excavator::new().film(path);
    let (root, scale) = (drawn(&film), film.view().unwrap().scale);
    let (shortest, longest) = (2.15 * scale, 2.75 * scale);
    let tube = shortest - 0.12 * (longest - shortest) - 10.0;
    let parts = root.all();
    let lift = parts.iter().filter(|part| part.attribute("data-link") == Some("lift_ram"));
    let of = |element: &Element| {
        let mut inside = element.children.iter();
        let rect = inside.find(|child| child.name == "rect")?;
        Some(numbers(rect.attribute("width")?)[0] + 8.0)
    };
    let drawn_tube = lift.clone().find_map(|part| of(part)).expect("there is a tube");
    assert!((drawn_tube - tube).abs() < 0.06, "{drawn_tube} for {tube}");
    let rod = lift.clone().find(|part| of(part).is_none()).expect("there is a rod");
    let path = rod.children.iter().find_map(|child| child.attribute("d")).unwrap();
    let rod = -numbers(&path.replace(['M', 'H'], " "))[0];
    assert!((rod - (longest - tube + 10.0)).abs() < 0.06, "{rod}");
    assert!(rod < shortest);
}

#[test]
fn a_guide_spans_its_slide_and_a_block() {
    let (solver, path) = (six_bar::SixBar::new(), turn().collect::<Vec<_>>());
    let film = solver.film(path.iter().copied());
    let scale = film.view().unwrap().scale;
    let slides = path.iter().map(|&q| solver.position(q).unwrap().ram.slide);
    let (least, most) =
        slides.fold((f64::MAX, f64::MIN), |(low, high), s| (low.min(s), high.max(s)));
    let root = drawn(&film);
    let rail = root.all().into_iter().find_map(|element| {
        let path =
            element.attribute("d").filter(|_| element.attribute("stroke-width") == Some("1.6"))?;
        let ends = numbers(&path.replace(['M', 'H'], " "));
        (path.contains(" 0H") && ends.len() == 3).then(|| [ends[0], ends[2]])
    });
    let [start, end] = rail.expect("there is a rail");
    assert!((start - (scale * least - 27.0)).abs() < 0.06, "{start}");
    assert!((end - (scale * most + 27.0)).abs() < 0.06, "{end}");
}
