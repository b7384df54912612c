//! The same machines told otherwise, and machines with a bar too few or too many.

use std::time::Instant;

use super::textbook::{groups, resolved_text};
use super::{Case, cases};

/// A generator of numbers by Marsaglia's xorshift.
pub(crate) struct Random(pub u64);

impl Random {
    pub(crate) fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % count as u64) as usize
    }
}

/// Machines of dyads alone, without guides.
fn of_bars() -> impl Iterator<Item = Case> {
    let is_of_dyads = |case: &Case| case.expected[0].starts_with("crank");
    cases().into_iter().filter(move |case| is_of_dyads(case) && !case.statements.contains("guide"))
}

fn found(name: &str, statements: &str) -> Vec<String> {
    let mechanism = resolved_text(statements).unwrap_or_else(|told| panic!("{name}: {told:?}"));
    let mut found = groups(&mechanism);
    found.sort();
    found
}

/// The statements with the coordinates of pins changed.
pub(super) fn moved(statements: &str, change: impl Fn([f64; 2]) -> [f64; 2]) -> String {
    let line = |line: &str| {
        if !line.starts_with("ground") && !line.starts_with("pin") {
            return line.to_string();
        }
        let mut parts = line.split('(');
        let first = parts.next().expect("a statement has a word").to_string();
        parts.fold(first, |text, part| {
            let (place, rest) = part.split_once(')').expect("a place ends");
            let mut numbers = place.split(", ").map(|number| number.parse().expect("a decimal"));
            let [x, y] = change([(); 2].map(|()| numbers.next().expect("two numbers")));
            format!("{text}({x:?}m, {y:?}m){rest}")
        })
    };
    statements.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// A group of the mirrored machine.
pub(super) fn mirrored(group: &str) -> String {
    match group.strip_suffix(" left") {
        Some(group) => format!("{group} right"),
        None => group.replace(" right", " left"),
    }
}

#[test]
fn the_order_of_statements_changes_no_group() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for case in cases().into_iter().filter(|case| case.expected[0].starts_with("crank")) {
        let before = found(case.name, case.statements);
        let mut lines: Vec<_> = case.statements.lines().collect();
        for _ in 0..5 {
            // A point is declared before links name it, as everywhere.
            for last in (3..lines.len()).rev() {
                let other = 2 + random.below(last - 1);
                lines.swap(last, other);
            }
            assert_eq!(found(case.name, &lines.join("\n")), before, "{lines:?}");
        }
    }
}

#[test]
fn scaled_drawings_have_the_same_groups_and_mirrored_ones_the_other_modes() {
    for case in of_bars() {
        let before = found(case.name, case.statements);
        // A power of two rounds nothing: what is a parallelogram exactly stays one.
        for scale in [1.0 / 128.0, 128.0] {
            let scaled = moved(case.statements, |[x, y]| [x * scale, y * scale]);
            assert_eq!(found(case.name, &scaled), before, "{}", case.name);
        }
        let flipped = found(case.name, &moved(case.statements, |[x, y]| [x, -y]));
        let mut swapped: Vec<_> = before.iter().map(|group| mirrored(group)).collect();
        swapped.sort();
        assert_eq!(flipped, swapped, "{}", case.name);
    }
}

/// The pins that a statement draws, each with its place.
fn places(line: &str) -> Vec<(String, String)> {
    let all = line.split_once(' ').expect("names follow").1.trim_end_matches(';').split("), ");
    let pin = |pin: &str| {
        let (name, at) = pin.trim_end_matches(')').split_once('(').expect("a place");
        (name.to_string(), format!("({at})"))
    };
    all.map(pin).collect()
}

/// The machine seen from the link that is driven: that one stands still, and the ground is driven against it.
fn inverted(statements: &str) -> Option<(String, String)> {
    let lines: Vec<_> = statements.lines().collect();
    let drive = lines.iter().find_map(|line| line.strip_prefix("drive "))?;
    let driven = drive.split_once(".angle = ")?.0;
    let pins: Vec<_> = lines
        .iter()
        .filter(|line| line.starts_with("ground ") || line.starts_with("pin "))
        .flat_map(|line| places(line))
        .collect();
    let ground: Vec<_> = places(lines.iter().find(|line| line.starts_with("ground "))?);
    let links: Vec<_> = lines.iter().filter_map(|line| line.strip_prefix("link ")).collect();
    let through = |link: &str| -> Vec<String> {
        let pins = link.split_once('(').expect("pins follow").1.trim_end_matches(");");
        pins.split(", ").map(String::from).collect()
    };
    let still = through(links.iter().find(|link| link.split('(').next() == Some(driven))?);
    let listed = |of_ground: bool| {
        let own = pins.iter().filter(|(name, _)| still.contains(name) == of_ground);
        own.map(|(name, at)| format!("{name}{at}")).collect::<Vec<_>>().join(", ")
    };
    let frame: Vec<_> = ground.iter().map(|(name, _)| &name[..]).collect();
    let others = links.iter().filter(|link| link.split('(').next() != Some(driven));
    let others: String = others.map(|link| format!("link {link}\n")).collect();
    let text = format!(
        "input theta: angle;\nground {};\npin {};\n{others}link frame({});\ndrive frame.angle = theta;",
        listed(true),
        listed(false),
        frame.join(", ")
    );
    Some((text, format!("crank {driven}")))
}

/// The link that is driven and the ground exchange their places: all groups are the same, in the same modes, for the pose is;
/// in the mirrored drawing in the other ones. Of machines that search, every sixth; `.ci/nightly` takes all of them.
#[test]
fn the_ground_and_the_driven_link_exchange_their_places() {
    let [of_dyads, searched] = exchanged_places(6);
    assert!(of_dyads > 15 && searched > 15, "{of_dyads} {searched}");
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn the_ground_and_the_driven_link_exchange_their_places_in_all_machines() {
    exchanged_places(1);
}

/// The counts of machines of dyads, and of those that search, every nth of which is looked at.
fn exchanged_places(nth: usize) -> [usize; 2] {
    let (mut of_dyads, mut searched) = (0, 0);
    for case in cases().into_iter().filter(|case| !case.statements.contains("guide")) {
        if case.statements.matches("drive ").count() > 1 {
            continue;
        }
        let Some((text, crank)) = inverted(case.statements) else { continue };
        if case.expected[0].starts_with("group") {
            searched += 1;
            if searched % nth != 0 {
                continue;
            }
        }
        let Ok(before) = resolved_text(case.statements) else { continue };
        let now =
            resolved_text(&text).unwrap_or_else(|told| panic!("{}: {told:?}\n{text}", case.name));
        assert_eq!(now.unknowns.len(), before.unknowns.len(), "{}", case.name);
        if !before.unknowns.is_empty() {
            continue;
        }
        let exchanged = |group: &String| match *group == crank {
            true => "crank frame".to_string(),
            false => group.clone(),
        };
        let mut wanted: Vec<_> = groups(&before).iter().map(exchanged).collect();
        wanted.sort();
        assert_eq!(found(case.name, &text), wanted, "{text}");
        let mut mirror: Vec<_> = wanted.iter().map(|group| mirrored(group)).collect();
        mirror.sort();
        assert_eq!(found(case.name, &moved(&text, |[x, y]| [x, -y])), mirror, "{text}");
        of_dyads += 1;
    }
    println!("{of_dyads} of dyads, {searched} searched");
    [of_dyads, searched]
}

#[test]
fn a_bar_too_few_or_too_many_is_told_by_its_names() {
    let mut told = [0, 0];
    // But for the one that has two freedoms and one input.
    for case in cases().into_iter().filter(|case| !case.expected[0].starts_with("refus")) {
        let lines: Vec<_> = case.statements.lines().collect();
        let names: Vec<_> = lines
            .iter()
            .filter_map(|line| line.strip_prefix("link "))
            .map(|link| link.split('(').next().expect("a link has a name"))
            .collect();
        let driven = lines.iter().find_map(|line| line.strip_prefix("drive ")).expect("a drive");
        for (index, line) in lines.iter().enumerate() {
            let is_driven = |link: &str| link.split('(').next() == driven.split('.').next();
            let Some(link) = line.strip_prefix("link ").filter(|link| !is_driven(link)) else {
                continue;
            };
            let mut fewer = lines.clone();
            fewer.remove(index);
            let mistakes = resolved_text(&fewer.join("\n")).err().expect("a link is missing");
            let all = mistakes.join(" ");
            let names_of = |name: &&str| all.contains(&format!("`{name}`"));
            assert!(names.iter().any(names_of) || all.contains("no link goes"), "{link}: {all}");
            told[0] += 1;
        }
        let pins: Vec<_> = lines
            .iter()
            .filter(|line| line.starts_with("pin ") || line.starts_with("ground "))
            .flat_map(|line| line.split_once(' ').expect("names follow").1.split("), "))
            .map(|pin| pin.split('(').next().expect("a pin has a name"))
            .collect();
        for (i, a) in pins.iter().enumerate() {
            for b in pins[..i].iter().step_by(3) {
                let more = format!("{}\nlink extra({a}, {b});", case.statements);
                let is_ground = |pin: &str| {
                    let mut of_ground = lines.iter().filter(|line| line.starts_with("ground "));
                    of_ground.any(|line| line.contains(&format!(" {pin}(")))
                };
                if is_ground(a) && is_ground(b) {
                    assert!(resolved_text(&more).is_ok(), "it is a part of the ground");
                    continue;
                }
                let mistakes = resolved_text(&more).err().expect("a link is too many");
                assert!(mistakes[0].contains("`extra`"), "{}: {mistakes:?}", case.name);
                told[1] += 1;
            }
        }
    }
    assert!(told[0] > 200 && told[1] > 400, "{told:?}");
}

#[test]
fn whatever_incidences_are_drawn_the_compiler_answers_soon() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let (mut understood, mut longest) = (0, 0.0_f64);
    for _ in 0..300 {
        let (pins, links) = (3 + random.below(8), 1 + random.below(9));
        let mut text = "input t: angle;\nground P0(0, 0), P1(4, 0);\n".to_string();
        for pin in 2..pins {
            let [x, y] = [(); 2].map(|()| random.below(1000) as f64 / 100.0);
            text += &format!("pin P{pin}({x:?}, {y:?});\n");
        }
        for link in 0..links {
            let through: Vec<_> =
                (0..1 + random.below(3)).map(|_| format!("P{}", random.below(pins))).collect();
            text += &format!("link L{link}({});\n", through.join(", "));
        }
        let other = random.below(links);
        text += &match random.below(3) {
            0 => format!("drive L0.angle - L{other}.angle = t;"),
            _ => "drive L0.angle = t;".to_string(),
        };
        let start = Instant::now();
        understood += usize::from(resolved_text(&text).is_ok());
        longest = longest.max(start.elapsed().as_secs_f64());
        // Optimised, all 300 take 0.04 s. A cut that tried all of what it may choose from would take minutes, which no
        // other work of the machine does.
        assert!(longest < 20.0, "{text}");
    }
    println!("{understood} of 300 are machines, {longest} s at most");
}

/// A link's frame is as written. Where the group has another, springs, uniform bars and distances mean the written one.
#[test]
fn statements_about_a_bar_mean_that_of_the_link() {
    for link in ["BC(B, C, P)", "BC(C, B, P)", "BC(P, B, C)"] {
        for statement in [
            "spring between AB and BC { stiffness: 5(N*m/rad) }",
            "point E on BC at distances (200mm, 500mm) left;",
            "mass 2kg on BC uniform;",
        ] {
            let statements = format!(
                "input t: angle;\nground A(0, 0), D(665.7mm, 0);\n\
                 pin B(80mm, 0), C(600mm, 360mm), P(570mm, 90mm);\n\
                 link AB(A, B), {link}, DC(D, C);\ndrive AB.angle = t;\n{statement}"
            );
            assert!(resolved_text(&statements).is_ok(), "{link} {statement}");
        }
    }
}
