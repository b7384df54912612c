//! Tests of the films in a browser. They need Debian's `chromium`:
//! `cargo test --release -p gallery -- --ignored browser`.

use std::fmt::Write;
use std::fs;

use gallery::pieces;

use super::chromium::{chromium, run};

/// Every seventh pose is looked at.
const STEP: usize = 7;

/// Sets the time and reads where the circles are.
const READ: &str = r#"
// Times can be set once the films have begun, which is after the page has been loaded.
addEventListener("load", () => setTimeout(() => {
  const lines = [];
  document.querySelectorAll("svg").forEach((film, nth) => {
    const [poses, seconds] = counts[nth];
    film.pauseAnimations();
    // In the film's own pixels: a page sets films in boxes of whole 64ths of one.
    const own = film.getScreenCTM().inverse();
    for (let pose = 0; pose + 1 < poses; pose += STEP) {
      film.setCurrentTime(pose / (poses - 1) * seconds);
      for (const circle of film.querySelectorAll("circle[data-point]")) {
        if (getComputedStyle(circle.parentNode).opacity === "0") continue;
        const m = own.multiply(circle.getScreenCTM()), x = circle.cx.baseVal.value, y = circle.cy.baseVal.value;
        lines.push([nth, pose, circle.dataset.point, m.a * x + m.c * y + m.e, m.b * x + m.d * y + m.f].join(" "));
      }
    }
  });
  document.querySelector("pre").textContent = lines.join("\n");
}, 300));
"#;

#[test]
#[ignore = "needs chromium"]
fn a_browser_has_every_joint_where_the_solver_has_it() {
    let pieces = pieces();
    let mut page = String::from("<!DOCTYPE html><body><pre></pre>");
    let mut counts = String::new();
    for piece in &pieces {
        page += &piece.film.to_svg().unwrap();
        write!(counts, "[{}, {}],", piece.film.len(), piece.film.duration()).unwrap();
    }
    let read = READ.replace("STEP", &STEP.to_string());
    write!(page, "<script>const counts = [{counts}];{read}</script>").unwrap();
    let lines = run(&page, "joints", &["--virtual-time-budget=8000"]);
    let views: Vec<_> = pieces.iter().map(|piece| piece.film.view().unwrap()).collect();
    let (mut seen, mut worst) = (0, 0.0_f64);
    for line in lines.lines() {
        let parts: Vec<&str> = line.split(' ').collect();
        let [film, pose, point, x, y] = parts[..] else { panic!("{line}") };
        let nth: usize = film.parse().unwrap();
        let film = &pieces[nth].film;
        let at = film.point(pose.parse().unwrap(), point).expect("what is shown exists");
        let [px, py] = views[nth].pixels([at.x, at.y]);
        let (x, y): (f64, f64) = (x.parse().unwrap(), y.parse().unwrap());
        let off = (x - px).hypot(y - py);
        if off > worst {
            println!("{}: {point} {off:.4} px", pieces[nth].name);
        }
        worst = worst.max(off);
        seen += 1;
    }
    println!("{seen} joints, at most {worst:.4} px off");
    assert!(seen > 1000, "{seen}");
    assert!(worst < 0.02, "{worst}");
}

/// A picture of a page with films in an `<img>` each after some time.
fn shot(films: &[String], name: &str, milliseconds: u32) -> Vec<u8> {
    let folder = std::env::temp_dir().join(format!("gallery_{name}_{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let (page, mut images) = (folder.join("page.html"), String::from("<!DOCTYPE html><body>"));
    for (nth, film) in films.iter().enumerate() {
        fs::write(folder.join(format!("film{nth}.svg")), film).unwrap();
        write!(images, "<img src=\"film{nth}.svg\" style=\"{}\">", placed(nth)).unwrap();
    }
    fs::write(&page, images).unwrap();
    let picture = folder.join("shot.png");
    chromium(&folder)
        .arg(format!("--virtual-time-budget={milliseconds}"))
        .arg(format!("--window-size={WIDTH},{}", HEIGHT * films.len()))
        .arg(format!("--screenshot={}", picture.display()))
        .arg(format!("file://{}", page.display()))
        .output()
        .expect("chromium can be started");
    let bytes = fs::read(picture).expect("there is a picture");
    let _ = fs::remove_dir_all(&folder);
    bytes
}

/// Room of a film on such a page, one below the other.
const WIDTH: usize = 760;
const HEIGHT: usize = 640;

fn placed(nth: usize) -> String {
    format!("position:absolute;left:0;top:{}px", HEIGHT * nth)
}

/// Says of each film whether two pictures differ in its room.
const DIFFER: &str = r#"
addEventListener("load", () => {
  const [a, b] = [...document.images].map((image) => {
    const canvas = Object.assign(document.createElement("canvas"), { width: image.naturalWidth, height: image.naturalHeight });
    const pen = canvas.getContext("2d");
    pen.drawImage(image, 0, 0);
    return (nth) => pen.getImageData(0, HEIGHT * nth, canvas.width, HEIGHT).data;
  });
  const moves = (nth) => { const other = b(nth); return a(nth).some((byte, k) => byte !== other[k]); };
  document.querySelector("pre").textContent = Array.from({ length: COUNT }, (_, nth) => +moves(nth)).join("");
});
"#;

/// Returns 1 for each of so many films where two pictures differ, else 0.
fn differing(shots: [&[u8]; 2], count: usize) -> String {
    let images = shots.map(|bytes| {
        let mut written = String::new();
        bytes.iter().for_each(|byte| write!(written, "%{byte:02x}").unwrap());
        format!("<img src=\"data:image/png,{written}\">")
    });
    let compare =
        DIFFER.replace("HEIGHT", &HEIGHT.to_string()).replace("COUNT", &count.to_string());
    let page =
        format!("<!DOCTYPE html><body><pre></pre><script>{compare}</script>{}", images.concat());
    run(&page, "differing", &["--virtual-time-budget=8000"])
}

#[test]
#[ignore = "needs chromium"]
fn a_film_plays_as_an_image_too() {
    let pieces = pieces();
    let films: Vec<String> =
        pieces.iter().take(5).map(|piece| piece.film.to_svg().unwrap()).collect();
    let early = shot(&films, "plays", 300);
    // A browser that has little of the processor may have drawn no second frame yet.
    let mut stands: Vec<&str> = pieces.iter().take(5).map(|piece| piece.name).collect();
    for at in [1300, 2900, 4700, 7300] {
        let moves = differing([&early, &shot(&films, "plays", at)], films.len());
        assert_eq!(moves.len(), films.len(), "{moves}");
        let names = pieces.iter().zip(moves.chars());
        let moving: Vec<&str> =
            names.filter(|(_, moves)| *moves == '1').map(|(piece, _)| piece.name).collect();
        stands.retain(|name| !moving.contains(name));
        if stands.is_empty() {
            break;
        }
    }
    assert!(stands.is_empty(), "{stands:?} stand still");
    // Stills do not move.
    let stills: Vec<String> =
        pieces.iter().take(5).map(|piece| piece.film.still().to_svg().unwrap()).collect();
    assert!(shot(&stills, "plays", 300) == shot(&stills, "plays", 1300), "a still moves");
}

/// Uses the button and the slider of a film's page, and says what the films did.
const USE: &str = r#"
addEventListener("load", () => setTimeout(() => {
  const lines = [], say = () => lines.push([
    button.textContent, ...[...films].map((film) => film.animationsPaused() + " " + film.getCurrentTime().toFixed(2)), time.textContent,
  ].join(", "));
  button.click();
  slider.value = 1.5;
  slider.dispatchEvent(new Event("input"));
  say();
  slider.value = 0.25;
  slider.dispatchEvent(new Event("input"));
  say();
  button.click();
  lines.push([button.textContent, ...[...films].map((film) => film.animationsPaused())].join(", "));
  document.querySelector("pre").textContent = lines.join("\n");
}, 300));
"#;

#[test]
#[ignore = "needs chromium"]
fn a_page_stops_goes_on_and_goes_where_its_slider_is_put() {
    let film = pieces().remove(0).film;
    let page = film.to_html().unwrap();
    let found = run(
        &page.replace("</html>", &format!("<pre></pre><script>{USE}</script>")),
        "page",
        &["--virtual-time-budget=8000"],
    );
    let lines: Vec<&str> = found.lines().collect();
    // One film is light and one dark; both go together.
    assert_eq!(
        lines,
        [
            "Play, true 1.50, true 1.50, 1.50 s",
            "Play, true 0.25, true 0.25, 0.25 s",
            "Pause, false, false",
        ]
    );
}
