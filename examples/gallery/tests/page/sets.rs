//! A machine with two sets of inputs, driven by one and by the other on one page.

#![allow(non_snake_case)]

use super::chromium::run;
use linkage_core::mechanism;
use linkage_core::sketch::shortened;

mechanism! {
    /// A five-bar robot.
    pub struct FiveBar {
        param upper = 114mm;
        ground A(-50mm, 0), E(50mm, 0);
        pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm);
        link BC(B, tool), CD(D, tool), ED(E, D);
        link AB(A, B) { length: upper }
        input motors { a = AB.angle, b = ED.angle }
        input hand { x = tool.x, y = tool.y }
    }
}

/// A reader turns a motor, lets the hand drive, takes the tool to a place, lets the motors drive again, turns one so far
/// that the arms stand on the other side, and lets the hand drive. What the page says stands in a list that is kept over
/// its new beginnings.
const READER: &str = r##"
{
  const told = JSON.parse(window.name || "[]"), step = told.length;
  const seen = () => [BY.set, $("#by").value, ...state.q];
  const drive = (set) => {
    $("#by").value = set;
    $("#by").dispatchEvent(new Event("change"));
  };
  const next = (found, act) => {
    told.push(found);
    window.name = JSON.stringify(told);
    act();
  };
  const dragged = ([x, y]) => {
    const box = figure.getBoundingClientRect();
    const event = (type, place) => {
      const [u, v] = onPage(place), pixel = box.width / view.width;
      const at = { clientX: box.left + u * pixel, clientY: box.top + v * pixel };
      figure.dispatchEvent(new PointerEvent(type, { ...at, pointerId: 1, isPrimary: true, button: 0, bubbles: true }));
    };
    figure.setPointerCapture = () => {};
    event("pointerdown", new Pose(state.q).point(PLAN.points.indexOf("tool")));
    for (let k = 0; k < 3; k++) event("pointermove", [x, y]);
    event("pointerup", [x, y]);
  };
  const done = () => {
    const report = document.createElement("pre");
    report.textContent = told.map((list) => list.join(" ")).join("\n");
    document.body.prepend(report);
  };
  const acts = [
    () => { state.q = [2.0, 1.1]; next(seen(), () => drive("hand")); },
    () => { const begun = seen(); dragged([0.03, 0.16]); next([...begun, ...state.q], () => drive("motors")); },
    () => { const begun = seen(); state.q = [state.q[0] - 1.9, state.q[1]]; drive("hand"); told.push([...begun, $("#missed").textContent, $("#by").value]); done(); },
  ];
  play(false);
  setTimeout(acts[step], 500);
}
"##;

#[test]
#[ignore = "needs chromium"]
fn a_reader_chooses_what_drives() {
    let html = FiveBar::new().page().to_html().unwrap();
    let html = html.replace("</html>", &format!("<script>{}</script></html>", shortened(READER)));
    let flags =
        ["--virtual-time-budget=20000", "--window-size=1280,900", "--force-prefers-reduced-motion"];
    let found = run(&html, "sets", &flags);
    println!("{found}");
    let lines: Vec<&str> = found.lines().collect();
    let [first, second, third] = lines[..] else { panic!("{found}") };
    assert!(first.starts_with("motors motors "), "{first}");
    // The hand is where the motors hold it; the address has nine digits.
    let robot = FiveBar::new();
    let at = robot.motors().to_hand([2.0, 1.1]).unwrap().coordinates;
    let hand = numbers(second.strip_prefix("hand hand ").expect("the hand drives"));
    assert!((hand[0] - at.x).abs() < 1e-9 && (hand[1] - at.y).abs() < 1e-9, "{hand:?}");
    // The tool is dragged itself: it is where the pointer is.
    assert!((hand[2] - 0.03).abs() < 1e-6 && (hand[3] - 0.16).abs() < 1e-6, "{hand:?}");
    let back = robot.hand().to_motors([hand[2], hand[3]]).unwrap().coordinates;
    let motors = numbers(third.strip_prefix("motors motors ").expect("the motors drive again"));
    assert!((motors[0] - back.a).abs() < 1e-8 && (motors[1] - back.b).abs() < 1e-8, "{motors:?}");
    // Behind this pose the arms stand on the other side than in the drawing, which Rust says as well.
    assert!(robot.motors().to_hand([motors[0] - 1.9, motors[1]]).is_err());
    let said = " Driven by motors on: this pose is another assembly of hand. motors";
    assert!(third.ends_with(said), "{third}");
}

/// The numbers at the beginning of a text.
fn numbers(text: &str) -> Vec<f64> {
    text.split(' ').map_while(|part| part.parse().ok()).collect()
}
