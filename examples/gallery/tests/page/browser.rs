//! Pages in a browser, dragged along scripted paths. They need Debian's `chromium`:
//! `cargo test --release -p gallery -- --ignored browser`.

use std::fmt::Write;

use linkage_core::sketch::shortened;

use super::chromium::run;
use super::hard;

/// A page, the width of its window, and what is done with it.
pub(super) struct Visit {
    pub name: &'static str,
    pub html: String,
    pub width: u32,
    pub steps: &'static str,
}

/// In virtual time a browser without a screen shows no frames of its own.
const FRAMES: &str =
    "window.requestAnimationFrame = (frame) => setTimeout(() => frame(performance.now()), 16);";

/// Lays the pages out in frames and gathers what each tells.
const GATHER: &str = r#"
const found = {};
addEventListener("message", ({ data, source }) => {
  // A page within another one tells that what its reader does.
  if (!data.failures) return;
  const frame = [...document.querySelectorAll("iframe")].find((frame) => frame.contentWindow === source);
  found[frame.title] = data;
  document.querySelector("pre").textContent = Object.entries(found)
    .map(([name, { failures, told }]) => [name, ...told, ...failures.map((text) => `FAILED ${text}`)].join("\n  ")).join("\n");
});
"#;

fn visited(visits: &[Visit], name: &str, flags: &[&str]) -> String {
    let is_still = flags.contains(&"--force-prefers-reduced-motion");
    let hand = [include_str!("drag.js"), include_str!("asked.js")].concat();
    scripted(visits, name, flags, |steps| {
        shortened(&format!("{{ const IS_STILL = {is_still}, PLANNED = {steps};\n{hand} }}"))
    })
}

/// Opens the pages beside each other, with a script each, which is made of its steps: the start of a browser takes
/// as long as what most of them do.
pub(super) fn scripted(
    visits: &[Visit],
    name: &str,
    flags: &[&str],
    script: impl Fn(&str) -> String,
) -> String {
    let mut page = format!(
        "<!DOCTYPE html><meta charset=\"utf-8\"><body><pre></pre><script>{GATHER}</script>"
    );
    for Visit { name, html, width, steps } in visits {
        let script = script(steps);
        let own = html.replace("</html>", &format!("<script>{script}</script></html>"));
        let own = own.replacen("<script>", &format!("<script>{FRAMES}</script><script>"), 1);
        let own = own.replace('&', "&amp;").replace('"', "&quot;");
        write!(
            page,
            "<iframe title=\"{name} {width}\" style=\"width:{width}px;height:900px;border:0\" srcdoc=\"{own}\"></iframe>"
        )
        .unwrap();
    }
    let flags = [flags, &["--virtual-time-budget=90000", "--window-size=1320,920"]].concat();
    run(&page, name, &flags)
}

fn page(name: &str) -> String {
    let pages = gallery::live::pages().unwrap();
    pages.into_iter().find(|(own, _)| *own == name).expect("it has a page").1
}

fn visits() -> Vec<Visit> {
    let visit = |name: &'static str, width, steps| Visit { name, html: page(name), width, steps };
    let shear = r#"[["look"], ["crank"], ["coupler", "blade"], ["touch", "B"], ["fingers", "B"], ["keys"], ["texts"], ["sliders"], ["ends"], ["typed"], ["pace"], ["address"], ["picks", "C"], ["scrub"], ["saves"], ["strip"]]"#;
    vec![
        visit("flying_shear::FlyingShear", 1280, shear),
        visit("flying_shear::FlyingShear", 360, shear),
        visit(
            "range::FourBar",
            1280,
            r#"[["look"], ["gap"], ["limit", "C", 1, 0.5], ["texts"], ["sliders"], ["traced", "C"]]"#,
        ),
        visit("range::FourBar", 360, r#"[["look"], ["gap"]]"#),
        visit(
            "excavator::Excavator",
            1280,
            r#"[["look"], ["held"], ["nearest"], ["reach", "tooth"], ["coupler", "G"], ["texts"]]"#,
        ),
        visit(
            "set_point::Press",
            1280,
            r#"[["look"], ["coupler", "B"], ["limit", "C", 1, 0], ["limit", "C", -1, 0], ["texts"], ["sliders"]]"#,
        ),
        visit(
            "suspension::ByTheWheel",
            360,
            r#"[["look"], ["coupler", "W"], ["limit", "W", 0, 2], ["sliders"], ["sprung"]]"#,
        ),
        visit(
            "press_friction::CutPress",
            1280,
            r#"[["look"], ["band"], ["texts"], ["loads"], ["sliders"], ["told"], ["drives", "ram", "theta.drive"]]"#,
        ),
        visit("press_friction::CutPress", 360, r#"[["look"], ["band"], ["sliders"]]"#),
        visit(
            "six_bar::SixBar",
            800,
            r#"[["look"], ["flat", "Position of ram angle", "Velocity of ram angle", "Acceleration of ram angle"]]"#,
        ),
        visit("crane::Crane", 800, r#"[["look"], ["flat", "Acceleration of L x,y"], ["sliders"]]"#),
        Visit {
            name: "hard::Rubbing",
            html: hard::Rubbing::new().page().range("mu", 0.0..=0.82).to_html().unwrap(),
            width: 800,
            steps: r#"[["look"], ["jams", 3]]"#,
        },
        visit("jansen_leg::JansenLeg", 1280, r#"[["look"], ["coupler", "foot"]]"#),
        visit("six_bar_reactions::SixBar", 1280, r#"[["look"], ["arrows"], ["reacts"]]"#),
        visit("slider_crank::OffsetSliderCrank", 800, r#"[["look"], ["typed"]]"#),
        Visit {
            name: "hard::Slanted",
            html: hard::Slanted::new().page().to_html().unwrap(),
            width: 800,
            steps: r#"[["look"], ["unreached"], ["traced", "F"]]"#,
        },
        visit("scissor_lift::ScissorLift", 800, r#"[["look"], ["cut"]]"#),
        visit("toggle_clamp::ToggleClamp", 800, r#"[["look"], ["ends"], ["sliders"]]"#),
        visit("counterweight::FourBar", 1280, r#"[["look"], ["typed"], ["sliders"]]"#),
        visit("calibration::SixBar", 1280, r#"[["keeps"]]"#),
        visit("vibration::Oscillator", 800, r#"[["look"], ["runs", 15, 1.6632], ["sliders"]]"#),
        Visit {
            name: "hard::Knee",
            html: hard::Knee::new().page().to_html().unwrap(),
            width: 800,
            steps: r#"[["look"], ["stuck", "ankle"]]"#,
        },
        Visit {
            name: "hard::Lift",
            html: hard::Lift::new().page().to_html().unwrap(),
            width: 800,
            steps: r#"[["look"], ["ends"], ["sliders"], ["coupler", "B"]]"#,
        },
        Visit {
            name: "hard::Bridge",
            html: hard::Bridge::new().page().to_html().unwrap(),
            width: 360,
            steps: r#"[["look"], ["ends"], ["texts"]]"#,
        },
        visit("shear_bearings::FlyingShear", 360, r#"[["look"], ["crank"], ["sliders"]]"#),
        Visit {
            name: "hard::Function",
            html: hard::Function::new().page().to_html().unwrap(),
            width: 1280,
            steps: r#"[["look"], ["coupler", "constructor"], ["texts"], ["sliders"]]"#,
        },
        Visit {
            name: "hard::AtRest",
            html: hard::AtRest::new().page().to_html().unwrap(),
            width: 800,
            steps: r#"[["flat"]]"#,
        },
        Visit {
            name: "hard::EightBar",
            html: hard::EightBar::new().page().to_html().unwrap(),
            width: 1280,
            steps: r#"[["look"], ["coupler", "p56"], ["limit", "p37", 2, 0], ["sliders"]]"#,
        },
    ]
}

fn check(name: &str, flags: &[&str]) {
    let visits = visits();
    for visits in visits.chunks(5) {
        let found = visited(visits, name, flags);
        println!("{found}");
        let told = found.lines().filter(|line| line.ends_with(" frames")).count();
        assert_eq!(told, visits.len(), "a page tells nothing: {found}");
        assert!(!found.contains("FAILED"), "{found}");
    }
}

#[test]
#[ignore = "needs chromium"]
fn a_reader_drags_machines_in_a_browser() {
    check("drag_light", &["--force-prefers-reduced-motion"]);
}

#[test]
#[ignore = "needs chromium"]
fn a_reader_drags_machines_in_a_dark_browser_while_they_play() {
    check("drag_dark", &["--blink-settings=preferredColorScheme=0"]);
}

/// Names and values on each other, on a bar, on an arrow or on a joint: every machine of the gallery, over the ranges of its inputs
/// and along its path, on a phone, a tablet and a screen. A font whose letters are wider by a seventh, where there is one, is
/// what a reader may have instead.
#[test]
#[ignore = "needs chromium"]
fn no_text_lies_on_another_nor_a_name_on_a_bar() {
    let pages = gallery::live::pages().unwrap();
    let wrong = std::thread::scope(|scope| {
        let halves = pages.chunks(pages.len().div_ceil(2)).enumerate();
        let halves = halves.map(|(half, pages)| {
            let look = move || pages.chunks(5).map(|pages| faults(half, pages)).collect::<Vec<_>>();
            scope.spawn(look)
        });
        let halves: Vec<_> = halves.collect();
        let found = halves.into_iter().map(|half| half.join().expect("it looks to the end"));
        found.flatten().collect::<Vec<_>>()
    });
    let (faults, poses): (Vec<_>, Vec<usize>) = wrong.into_iter().unzip();
    let faults = faults.concat();
    assert!(faults.is_empty(), "{faults}");
    let poses: usize = poses.iter().sum();
    println!("{poses} poses");
    assert!(poses >= 5_000, "{poses}");
}

/// A font with wide letters in place of a page's own.
const WIDE: &str = "body{font-family:\"DejaVu Sans\",Verdana,sans-serif}</style>";

/// The faults of that kind on some pages, in one of two browsers, and how many poses were looked at.
fn faults(half: usize, pages: &[(&'static str, String)]) -> (String, usize) {
    let of_look = |(name, html): &(&'static str, String)| {
        let wide = html.replacen("</style>", WIDE, 1);
        [(360, html), (800, html), (1280, html), (350, &wide), (900, &wide)]
            .map(|(width, html)| Visit { name, html: html.clone(), width, steps: "" })
    };
    let visits: Vec<Visit> = pages.iter().flat_map(of_look).collect();
    let (name, flags) = (format!("over_{half}"), ["--force-prefers-reduced-motion"]);
    let found = scripted(&visits, &name, &flags, |_| shortened(include_str!("over.js")));
    let seen = found.lines().filter(|line| line.ends_with(" texts")).count();
    assert_eq!(seen, visits.len(), "{found}");
    let poses = found.lines().filter_map(|line| line.trim().strip_suffix(" poses"));
    let poses = poses.filter_map(|count| count.parse::<usize>().ok()).sum();
    let faults = if found.contains("FAILED") { found } else { String::new() };
    (faults, poses)
}

/// A frame of each kind, over and over: inputs that move, a point that is dragged, a parameter that is set. The most
/// formulas that one evaluates and the most changes that it makes to the document, and the milliseconds that a quarter
/// of them does not exceed.
const MEASURE: &str = r#"
{
  let asked = 0;
  for (const name of ["place", "motion", "forces", "holding"]) {
    const own = MACHINE[name];
    if (own) MACHINE[name] = (...args) => (asked++, own(...args));
  }
  const changes = new MutationObserver(() => {});
  changes.observe(document, { subtree: true, childList: true, "attributes": true, characterData: true });
  const measured = (count, what, change) => {
    const times = [], found = { formulas: 0, changes: 0 };
    for (let k = 0; k < count; k++) {
      asked = 0;
      changes.takeRecords();
      const begun = performance.now();
      change(k);
      due = what;
      frame();
      times.push(performance.now() - begun);
      found.formulas = Math.max(found.formulas, asked);
      found.changes = Math.max(found.changes, changes.takeRecords().length);
    }
    return [found.formulas, found.changes, times.sort((a, b) => a - b)[count >> 2]];
  };
  const point = tracedPoints[0], path = samples.filter(({ pose }) => !pose.error).map(({ pose }) => pose.point(point));
  const found = [
    measured(60, POSE, (k) => state.q = withInput(0, inputs[0].from + (sizeOf(inputs[0]) * k) / 60)),
    measured(60, inputs.length > 1 ? CURVES : POSE, (k) => state.q = towards(point, path[3 * k % path.length], state.q)),
    measured(60, CURVES, (k) => params.length && (state.p[0] = params[0].value * (1 + k / 600))),
  ];
  const report = document.createElement("pre");
  report.textContent = JSON.stringify(found);
  document.body.prepend(report);
}
"#;

/// What a frame costs, counted: a limit in milliseconds would fail on a machine that does other work beside. `--nocapture`
/// shows them.
#[test]
#[ignore = "needs chromium"]
fn a_frame_evaluates_few_formulas_and_changes_little() {
    for name in ["flying_shear::FlyingShear", "excavator::Excavator", "calibration::SixBar"] {
        let html = page(name)
            .replace("</html>", &format!("<script>{}</script></html>", shortened(MEASURE)));
        let found =
            run(&html, "measure", &["--force-prefers-reduced-motion", "--window-size=1280,900"]);
        println!("{name}: {found}");
        let found: Vec<f64> =
            found.split(['[', ',', ']']).filter_map(|part| part.parse().ok()).collect();
        let [input, drag, curves] = [0, 3, 6].map(|at| (found[at], found[at + 1]));
        // The pose and its outputs.
        assert_eq!(input.0, 2.0, "{name}: {found:?}");
        // Those at each of 241 steps, and once more where the cursor stands.
        assert_eq!(curves.0, 2.0 * 241.0 + 2.0, "{name}: {found:?}");
        // Six of Newton's steps at most: a pose beside for each input, and few that are tried.
        let searched = drag.0 - if name.starts_with("excavator") { curves.0 } else { input.0 };
        assert!(searched > 0.0 && searched <= 6.0 * 6.0, "{name}: {found:?}");
        // Some attributes of each bar, joint, curve, chart and value.
        assert!(
            [input, drag, curves].iter().all(|at| at.1 > 10.0 && at.1 < 300.0),
            "{name}: {found:?}"
        );
    }
}
