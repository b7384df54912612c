//! The text of every picture: well formed, self-contained, of modest size.

use std::time::Instant;

use gallery::pieces;
use linkage_core::sketch::{Film, Theme};

use super::sample;
use super::xml::parse;

fn check(name: &str, text: &str, most: usize) {
    let root = parse(text);
    assert_eq!(root.name, "svg");
    let known = [
        "svg",
        "style",
        "title",
        "desc",
        "rect",
        "g",
        "path",
        "circle",
        "text",
        "animate",
        "animateTransform",
    ];
    for element in root.all() {
        assert!(known.contains(&&element.name[..]), "{name}: {}", element.name);
        for (attribute, value) in &element.attributes {
            let is_foreign = ["style", "class", "href", "xlink:href", "id"]
                .contains(&&attribute[..])
                || attribute.starts_with("on")
                || value.contains("url(");
            let is_foreign = is_foreign && (&attribute[..], &value[..]) != ("class", "auto");
            assert!(!is_foreign, "{name}: {attribute}=\"{value}\"");
            assert!(!value.contains("NaN") && !value.contains("inf"), "{name}: {attribute}");
        }
    }
    assert_eq!(text.matches("http").count(), 1, "{name}: only the name space is an address");
    assert!(text.len() <= most, "{name}: {} of {most} bytes", text.len());
}

#[test]
fn every_picture_is_well_formed_self_contained_and_small() {
    for piece in sample() {
        let (film, name) = (&piece.film, piece.name);
        let most = match name {
            "jansen_leg::JansenLeg" => 40_000,
            "excavator::Excavator" => 60_000,
            _ => 100_000,
        };
        check(name, &film.to_svg().unwrap(), most);
        check(name, &film.to_svg_in(Theme::Dark).unwrap(), most);
        check(name, &film.still().to_svg().unwrap(), 15_000);
        let page = film.to_html().unwrap();
        assert!(page.contains("<button") && page.contains(r#"type="range""#));
        assert_eq!(page.matches("<svg").count(), 2);
    }
}

#[test]
fn a_single_pose_is_smaller_still() {
    use gallery::declarations::{excavator, flying_shear, jansen_leg};
    let stills = [
        flying_shear::FlyingShear::new().sketch(2.0).unwrap().to_svg(),
        jansen_leg::JansenLeg::new().sketch(1.0).unwrap().to_svg(),
        excavator::Excavator::new().sketch([2.35, 2.65, 1.8]).unwrap().to_svg(),
    ];
    for still in stills {
        check("still", &still.unwrap(), 8_000);
    }
}

#[test]
fn every_mechanism_of_the_examples_is_shown() {
    let mut shown: Vec<&str> = pieces().iter().map(|piece| piece.name).collect();
    let mut declared = gallery::declarations::NAMES.to_vec();
    shown.sort_unstable();
    declared.sort_unstable();
    assert_eq!(shown, declared);
}

/// Every point and link is in the picture, output or not.
#[test]
fn everything_declared_is_drawn() {
    for piece in pieces() {
        let text = piece.film.to_svg().unwrap();
        for link in piece.film.links() {
            assert!(text.contains(&format!("data-link=\"{link}\"")), "{}: {link}", piece.name);
        }
        for point in piece.film.points() {
            assert!(text.contains(&format!("data-point=\"{point}\"")), "{}: {point}", piece.name);
        }
        let springs = match piece.name {
            "suspension::ByTheWheel" => 1,
            "vibration::Oscillator" | "andrews_squeezer::Squeezer" => 1,
            "vibration::TwoMasses" => 2,
            _ => 0,
        };
        assert_eq!(text.matches("data-spring=").count(), springs, "{}", piece.name);
    }
}

#[test]
#[ignore = "a time"]
fn a_film_is_written_in_twenty_milliseconds() {
    // A build that is not optimised takes three times as long where nothing else runs.
    let most = if cfg!(debug_assertions) { 100.0 } else { 20.0 };
    // Other work of the machine can only make a film slower, so the quickest of several times is its own.
    let least = |film: &Film| {
        let mut least = f64::INFINITY;
        for _ in 0..31 {
            let start = Instant::now();
            std::hint::black_box(film.to_svg().unwrap());
            least = least.min(start.elapsed().as_secs_f64() * 1e3);
            if least < most {
                break;
            }
        }
        least
    };
    for piece in pieces() {
        let (time, size) = (least(&piece.film), piece.film.to_svg().unwrap().len());
        println!("{:38} {time:6.2} ms {size:7} bytes", piece.name);
        assert!(time < most, "{}: {time} ms", piece.name);
    }
}
