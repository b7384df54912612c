// A reader's hand on a page: what it drags, sets and presses, and what the page makes of it. It has the page's short names;
// what the browser and Rust call so as well stands in quotes.

const failures = [];
const expect = (isMet, ...words) => { if (!isMet) failures.push(words.join(" ")); };
addEventListener("error", ({ message }) => failures.push(message));
addEventListener("securitypolicyviolation", ({ blockedURI }) => failures.push(`asks for ${blockedURI}`));
// Made events have no pointer that could be captured.
Element.prototype.setPointerCapture = () => {};
Element.prototype.hasPointerCapture = () => isPressed;
let isPressed = false;

const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
const point = (name) => PLAN.points.indexOf(name);
const now = (name) => new Pose(state.q).point(point(name));
const send = (kind, place, own = {}) => {
  const box = figure.getBoundingClientRect(), pixel = box.width / view.width, [x, y] = onPage(place);
  const at = { clientX: box.left + x * pixel, clientY: box.top + y * pixel };
  figure.dispatchEvent(new PointerEvent(kind, { ...at, pointerId: 1, isPrimary: true, ...own, bubbles: true, cancelable: true }));
};
/// Takes a point along a path of places; tells each.
const take = async (name, places, each) => {
  send("pointerdown", now(name));
  for (const place of places) {
    send("pointermove", place);
    await drawn();
    each?.(place);
  }
  send("pointerup", places.at(-1));
  await drawn();
};
const set = async (input, value) => {
  input.value = value;
  for (const kind of ["input", "change"]) input.dispatchEvent(new Event(kind, { bubbles: true }));
  await drawn();
};
const press = async (key, shiftKey = false) => {
  figure.dispatchEvent(new KeyboardEvent("keydown", { key, shiftKey, bubbles: true, cancelable: true }));
  await drawn();
};
const sound = (when) => {
  const paths = [...document.querySelectorAll("svg path")].map((path) => path.getAttribute("d") ?? "");
  expect(!paths.some((d) => /NaN|undefined|Infinity/.test(d)), when, "leaves a path without numbers");
  const moved = [...document.querySelectorAll("svg [transform]")].map((node) => node.getAttribute("transform"));
  expect(!moved.some((d) => /NaN|undefined|null/.test(d)), when, "leaves a place without numbers");
  expect(document.documentElement.scrollWidth <= innerWidth, when, "is wider than the window");
};
/// The cells of the curves as text, without the state above them.
const table = () => csv().trim().split("\n").filter((line) => !line.startsWith("# ")).map((line) => line.split(","));
/// Texts of a picture that lie over each other.
const overlapping = (texts) => {
  const boxes = [...texts].filter((text) => text.getAttribute("visibility") !== "hidden" && text.textContent.trim())
    .map((text) => [text.textContent, text.getBoundingClientRect()]);
  return boxes.flatMap(([name, a], k) => boxes.slice(k + 1)
    .filter(([, b]) => a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 3 && b.top < a.bottom - 3)
    .map(([other]) => `${name} over ${other}`));
};

const STEPS_OF = {
  /// Twice round by the crank's pin, the pointer outside its circle; the input winds up.
  async "crank"() {
    const [centre, from] = [now("A"), now("B")], begun = state.q[0];
    const first = Math.atan2(from[1] - centre[1], from[0] - centre[0]), radius = 1.7 * apart(centre, from);
    const places = Array.from({ length: 96 }, (_, k) => first + ((k + 1) * 4 * Math.PI) / 96)
      .map((angle) => [centre[0] + radius * Math.cos(angle), centre[1] + radius * Math.sin(angle)]);
    await take("B", places, (place) => {
      const at = now("B"), off = Math.atan2(at[1] - centre[1], at[0] - centre[0]) - Math.atan2(place[1] - centre[1], place[0] - centre[0]);
      expect(Math.abs(nearest(off)) < 0.1, "the pin is off the pointer by", off);
      const slider = +$(`#input_${inputs[0].name}`).value;
      expect(Math.abs(nearest(slider - state.q[0])) < 1e-6, "the slider is at", slider, "for", state.q[0]);
    });
    expect(Math.abs(state.q[0] - begun - 4 * Math.PI) < 0.1, "two turns are", state.q[0] - begun);
  },
  /// A coupler point along its own path, as far as the machine can follow.
  async "coupler"(name) {
    play(false);
    const runs = [[]];
    for (const { pose } of samples) {
      if (pose.error) runs.push([]);
      else runs.at(-1).push(pose.point(point(name)));
    }
    const off = (path) => Math.min(...path.map((at) => apart(at, now(name))));
    const path = runs.sort((a, b) => off(a) - off(b))[0], last = path.length - 1;
    const start = path.findIndex((at) => apart(at, now(name)) === off(path));
    // To and fro where the path has ends.
    const bounced = (k) => last - Math.abs(last - (k % (2 * last)));
    const places = Array.from({ length: 80 }, (_, k) => path[bounced(start + 3 * (k + 1))]);
    await take(name, places, (place) => {
      const off = apart(now(name), place) * view.scale;
      expect(off < 0.5, name, "is off its own path by", off, "pixels");
    });
  },
  /// A point towards a place beyond its reach, so many of the picture's widths away, and back: it stays in
  /// poses that can be assembled.
  async "limit"(name, across, up) {
    play(false);
    const from = now(name), far = view.width / view.scale;
    const shares = Array.from({ length: 60 }, (_, k) => 1 - Math.abs(1 - (k + 1) / 30));
    let isHeld = false, last = from;
    await take(name, shares.map((share) => [from[0] + share * across * far, from[1] + share * up * far]), (place) => {
      const { error } = new Pose(state.q);
      expect(!error, name, "is dragged into a pose with", error?.kind);
      isHeld ||= apart(now(name), place) * view.scale > 30;
      expect(apart(now(name), place) <= apart(last, place) + 1e-9, name, "goes away from the pointer");
      last = now(name);
    });
    expect(isHeld, name, "reaches places that it should not");
    expect(!$("#state").classList.contains("warn"), "a warning stays:", $("#state").textContent);
  },
  /// A point of several inputs' reach along a line and back.
  async "reach"(name) {
    play(false);
    go(inputs.map(({ from, to }) => (from + to) / 2));
    await drawn();
    const from = now(name);
    const places = Array.from({ length: 40 }, (_, k) => Math.sin((k * Math.PI) / 20))
      .map((share) => [from[0] - 40 / view.scale * Math.abs(share), from[1] + 30 / view.scale * share]);
    await take(name, places, (place) => {
      const off = apart(now(name), place) * view.scale;
      expect(off < 1, name, "is off the line by", off, "pixels");
    });
  },
  /// An input that would leave its range goes to its end, and another one does the rest.
  async "held"() {
    const [a, b, ...others] = inputs, s = sizeOf(a), middle = ({ from, to }) => (from + to) / 2;
    const moves = [[1, 0.5], [1, 1], ...others.map(() => [0, 0])], free = [0.05 * s, 0.02 * s], q = [a.to - 0.01 * s, ...[b, ...others].map(middle)];
    const e = [0, 1].map((axis) => moves[0][axis] * free[0] + moves[1][axis] * free[1]), [x, y] = change(moves, e, q);
    // The first may do 0.01; what is left of e, (0.06, 0.04) s, is met best by half of its sum. Damping takes a ten thousandth.
    expect(Math.abs(x - 0.01 * s) < 1e-9 && Math.abs(y / (0.05 * s) - 1) < 1e-3, "the steps are", x / s, y / s);
  },
  /// A pointer on a joint takes that one, also where others are near.
  async "nearest"() {
    play(false);
    const pose = new Pose(state.q), crowd = movable.filter((one) => movable.some((other) => other !== one && apart(pose.point(one), pose.point(other)) * view.scale < 28));
    expect(crowd.length > 2, "near each other are", crowd.length);
    for (const one of crowd) expect(pointNear(pose.point(one), 28) === one, PLAN.points[one], "is not taken");
    // Nearer than half the way to the nearest other one.
    for (const one of movable) {
      const [at, ...others] = [one, ...movable.filter((other) => other !== one)].map((point) => pose.point(point));
      const to = others.reduce((best, other) => (apart(at, other) < apart(at, best) ? other : best)), place = at.map((x, k) => x + 0.4 * (to[k] - x));
      expect(pointNear(place, 1e4) === one, PLAN.points[one], "is not the nearest");
    }
  },
  /// Into a gap and out of it.
  async "gap"() {
    play(false);
    const centre = now("A"), radius = apart(centre, now("B"));
    const at = (angle) => [centre[0] + radius * Math.cos(angle), centre[1] + radius * Math.sin(angle)];
    let met = 0;
    await take("B", Array.from({ length: 60 }, (_, k) => at(state.q[0] + (k * TURN) / 60)), () => {
      const isGap = !!new Pose(state.q).error;
      met += isGap;
      expect(isGap === $("#state").textContent.includes("cannot be assembled"), "the reason is", $("#state").textContent);
      expect(isGap === (nodes.reach.getAttribute("visibility") !== "hidden"), "what is missing shows in a pose that is whole");
      if (isGap) {
        const [, ...ends] = /^M([-\d.]+) ([-\d.]+)L([-\d.]+) ([-\d.]+)$/.exec(nodes.missing.getAttribute("d")).map(Number), { by } = new Pose(state.q).error;
        const length = Math.hypot(ends[2] - ends[0], ends[3] - ends[1]), text = nodes.missingWords, middle = (ends[0] + ends[2]) / 2;
        expect(Math.abs(length - by * view.scale) < 0.2, "missing are", length, "pixels for", by * view.scale);
        expect(text.textContent.replace(" missing", "") === words(by, "m"), "what is missing is", text.textContent);
        const left = /\(([-\d.]+)/.exec(text.getAttribute("transform"))[1] - middle, right = left + text.getComputedTextLength();
        expect(left > 8 || right < 0, "what is missing is told from", left, "to", right, "beside its line");
      }
      expect(isGap === (nodes.ghost.getAttribute("visibility") !== "hidden"), "the last pose does not show");
      const seen = [nodes.reach, nodes.ghost].flatMap((node) => [...node.querySelectorAll("*")]).filter((node) => getComputedStyle(node).visibility === "visible");
      expect(isGap || !seen.length, "a part of what is hidden shows:", seen[0]?.outerHTML.slice(0, 60));
    });
    expect(met > 5 && met < 55, "in a gap", met, "times of 60");
    expect(charts.every(({ out }) => out.getAttribute("d").startsWith("M")), "no band over the gap");
  },
  /// A finger on a joint, or near it, drags that, and the page stays where it is; beside one it scrolls.
  async "touch"(name) {
    play(false);
    const box = figure.getBoundingClientRect(), touched = (place, off) => {
      const [x, y] = onPage(place), at = { clientX: box.left + x + off, clientY: box.top + y };
      figure.dispatchEvent(new PointerEvent("pointerdown", { ...at, pointerId: 2, pointerType: "touch", isPrimary: true, bubbles: true, cancelable: true }));
      const touch = new Touch({ identifier: 1, target: figure, ...at });
      return !figure.dispatchEvent(new TouchEvent("touchstart", { touches: [touch], bubbles: true, cancelable: true }));
    };
    const lift = (kind) => figure.dispatchEvent(new PointerEvent(kind, { pointerId: 2, pointerType: "touch", bubbles: true }));
    expect(touched(now(name), 8), "a finger on", name, "scrolls");
    expect(drag?.point === point(name), "a finger takes", drag && PLAN.points[drag.point]);
    lift("pointercancel");
    expect(!drag, "a cancelled touch goes on");
    expect(!touched([(box.width + 90) / view.scale, 0], 0) && !drag, "a finger beside the machine drags");
    lift("pointerup");
  },
  /// The drives that hold the machine at rest: an area over the chart, its ends at the cursor, in the table and as text.
  async "band"() {
    play(false);
    const [chart] = charts.filter(({ hasBand }) => hasBand), area = chart.band.getAttribute("d");
    expect(/^M.*Z$/.test(area), "the band is", area.slice(0, 20));
    const runs = samples.filter(({ holding }, k) => holding && !samples[k - 1]?.holding).length;
    expect(area.split("M").length === runs + 1, "the band has", area.split("M").length - 1, "parts for", runs);
    expect(/at rest [−\d.]+ … [−\d.]+/.test(chart.legend.textContent), "the legend is", chart.legend.textContent);
    const row = [...document.querySelectorAll("#values tr")].find(({ textContent }) => textContent.includes("at rest"));
    expect(/\d … −?\d/.test(row?.textContent), "the table has", row?.textContent);
    expect(samples.every(({ holding }) => !holding || holding[0] <= holding[1]), "a band ends before it begins");
    const [head, ...lines] = table(), k = head.indexOf("theta.drive at rest backwards [N·m]");
    expect(k > 0 && lines.every((line, n) => String(samples[n].holding?.[0] ?? "") === line[k]), "the table of the curves has no band");
    expect(samples.some(({ refused }) => refused?.kind === "Jams") || samples.every(({ forces }) => forces), "forces are gone without a reason");
  },
  /// So much friction that joints jam at some poses: the band is interrupted there, and the table says why.
  async "jams"(parts) {
    play(false);
    const [slider] = document.querySelectorAll("#params input[type=range]");
    await set(slider, slider.max);
    const [chart] = charts.filter(({ hasBand }) => hasBand), area = chart.band.getAttribute("d");
    const holds = samples.map(({ holding }) => !!holding), runs = holds.filter((is, k) => is && !holds[k - 1]).length;
    expect(runs === parts && area.split("M").length === parts + 1, "the band has", area.split("M").length - 1, "parts,", runs, "of", parts);
    const edge = samples.findIndex((_, k) => !holds[k]), pieces = area.split("M").slice(1);
    // Each part lies over its own poses.
    const within = pieces.map((piece) => piece.match(/[\d.]+(?= )/g).map(Number)), { X } = chart;
    expect(within.every((xs) => xs.every((x) => samples.some((at, k) => holds[k] && Math.abs(X(at.x) - x) < 0.1))), "the band lies over poses that jam");
    const lines = table().slice(1);
    expect(lines.every((line, k) => (line.at(-1) === "") === !samples[k].refused), "reasons stand beside poses that have none");
    const told = lines.filter((line) => line.at(-1).includes("friction may hold itself here"));
    expect(told.length > 5, "the table tells", told.length, "jams");
    for (const [k, isThere] of [[edge, false], [edge - 1, true]]) {
      go([samples[k].x]);
      await drawn();
      expect(chart.legend.textContent.includes("at rest") === isThere, "beside the edge the legend is", chart.legend.textContent);
    }
    $("#reset").click();
    await drawn();
    expect(chart.band.getAttribute("d").split("M").length === 2, "less friction leaves", chart.band.getAttribute("d").split("M").length - 1);
  },
  /// Charts of motions that are none are left out.
  async "flat"(...names) {
    const hidden = charts.filter(({ svg }) => getComputedStyle(svg).display === "none");
    const found = hidden.map(({ title, series }) => `${title.textContent} ${series.map(({ name }) => name)}`);
    expect(found.join() === names.join(), "left out are", found.join());
    expect(charts.length > hidden.length, "no chart is left");
  },
  /// Every slider at both ends and back, every mode.
  async "sliders"() {
    play(false);
    for (const input of document.querySelectorAll("input[type=range]")) {
      const { value, min, max } = input;
      for (const end of [min, max, value]) {
        await set(input, end);
        sound(`${input.id} at ${end}`);
      }
    }
    for (const button of document.querySelectorAll("input[type=radio]")) {
      button.click();
      await drawn();
      sound(`${button.name} ${button.value}`);
    }
    $("#reset").click();
    await drawn();
  },
  /// The keyboard alone.
  async "keys"() {
    play(false);
    figure.focus();
    const begun = state.q[0];
    for (let k = 0; k < 5; k++) await press("ArrowRight");
    await press("ArrowLeft", true);
    expect(Math.abs(state.q[0] - begun + Math.PI / 36) < 1e-9, "five degrees and ten back are", state.q[0] - begun);
    await press(" ");
    expect($("#play").textContent === "Pause", "space does not play");
    await press(" ");
    expect($("#play").textContent === "Play", "space does not stop");
  },
  /// Numbers of the curves as text, the copied declaration, and the state in the address.
  async "texts"() {
    play(false);
    const all = csv().trim().split("\n"), lines = all.filter((line) => !line.startsWith("# ")), head = lines[0].split(",").length;
    const above = all.slice(0, all.length - lines.length), names = [...params, ...loads].map(({ name }) => name);
    expect(names.every((name) => above.some((line) => line.startsWith(`# ${name} `))), "the table's head is", above.join("; "));
    expect(above.some((line) => line.startsWith("# rate of ")), "the table does not say its rate");
    expect(lines.length === STEPS + 2, "the table has", lines.length, "lines");
    expect(lines.every((line) => line.replace(/"[^"]*"/g, "").split(",").length === head), "lines of the table differ in length");
    const [slider] = document.querySelectorAll("#params input[type=range]");
    if (slider) {
      await set(slider, slider.max);
      expect(document.querySelectorAll("mark").length === 1, "a changed parameter is not marked");
      expect(!$("#code").textContent.includes("undefined"), "the declaration has a hole");
    }
    expect($("#code").textContent.startsWith("mechanism! {"), "the declaration begins", $("#code").textContent.slice(0, 20));
    $("#reset").click();
    await drawn();
  },
  async "look"() {
    const over = charts.flatMap(({ svg }) => overlapping(svg.querySelectorAll("text")));
    expect(!over.length, "texts of a chart:", over.join("; "));
    const names = overlapping(document.querySelectorAll(".names text"));
    expect(!names.length, "names:", names.join("; "));
    expect($("#code").textContent.length > 0, "no declaration");
    expect(playing !== IS_STILL, "plays at first:", playing);
  },
};

addEventListener("load", () => setTimeout(async () => {
  for (const [step, ...given] of PLANNED) {
    try {
      await STEPS_OF[step](...given);
    } catch (error) {
      failures.push(`${step}: ${error.message}`);
    }
    sound(step);
  }
  expect(performance.getEntriesByType("resource").length === 0, "something was asked of the network");
  parent.postMessage({ failures: failures.slice(0, 6), "told": [`${spent.length} frames`] }, "*");
}, 200));
