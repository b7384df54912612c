// A reader's hand on a page: what it drags, sets and presses, and what the page makes of it.

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
  async crank() {
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
  async coupler(name) {
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
  async limit(name, across, up) {
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
  async reach(name) {
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
  /// Into a gap and out of it.
  async gap() {
    play(false);
    const centre = now("A"), radius = apart(centre, now("B"));
    const at = (angle) => [centre[0] + radius * Math.cos(angle), centre[1] + radius * Math.sin(angle)];
    let met = 0;
    await take("B", Array.from({ length: 60 }, (_, k) => at(state.q[0] + (k * TURN) / 60)), () => {
      const isGap = !!new Pose(state.q).error;
      met += isGap;
      expect(isGap === $("#state").textContent.includes("cannot be assembled"), "the reason is", $("#state").textContent);
      expect(isGap === (nodes.reach.getAttribute("visibility") !== "hidden"), "what is missing shows in a pose that is whole");
      if (isGap) expect(nodes.missing.getAttribute("d").startsWith("M"), "nothing is missing in a gap");
      expect(isGap === (nodes.ghost.getAttribute("visibility") !== "hidden"), "the last pose does not show");
      const seen = [nodes.reach, nodes.ghost].flatMap((node) => [...node.querySelectorAll("*")]).filter((node) => getComputedStyle(node).visibility === "visible");
      expect(isGap || !seen.length, "a part of what is hidden shows:", seen[0]?.outerHTML.slice(0, 60));
    });
    expect(met > 5 && met < 55, "in a gap", met, "times of 60");
    expect(charts.every(({ out }) => out.getAttribute("d").startsWith("M")), "no band over the gap");
  },
  /// A finger on a joint, or near it, drags that, and the page stays where it is; beside one it scrolls.
  async touch(name) {
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
  async band() {
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
  async jams(parts) {
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
  async flat(...names) {
    const hidden = charts.filter(({ svg }) => getComputedStyle(svg).display === "none");
    const found = hidden.map(({ title, series }) => `${title.textContent} ${series.map(({ name }) => name)}`);
    expect(found.join() === names.join(), "left out are", found.join());
    expect(charts.length > hidden.length, "no chart is left");
  },
  /// Every slider at both ends and back, every mode.
  async sliders() {
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
  async keys() {
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
  async texts() {
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
  /// Numbers that are typed, beyond the slider's ends and in other units; what is none is refused and forgotten.
  async typed() {
    play(false);
    const type = async (id, text) => {
      const field = $(`#${id}_field`);
      field.focus();
      field.value = text;
      field.dispatchEvent(new Event("change"));
      const isRefused = field.getAttribute("aria-invalid") === "true";
      await drawn();
      return [field, isRefused];
    };
    const [turn] = await type(`input_${inputs[0].name}`, "90");
    expect(Math.abs(state.q[0] - Math.PI / 2) < 1e-12, "90 are", state.q[0]);
    await type(`input_${inputs[0].name}`, "0.5 rad");
    expect(state.q[0] === 0.5, "0.5 rad are", state.q[0]);
    const [, isRefused] = await type(`input_${inputs[0].name}`, "half a turn");
    expect(state.q[0] === 0.5 && isRefused, "half a turn is", state.q[0]);
    turn.dispatchEvent(new Event("blur"));
    expect(turn.value === "28.65°" && turn.getAttribute("aria-invalid") === "false", "what stands is", turn.value);
    await type("rate_", "2 rad/s");
    expect(state.rate === 2, "2 rad/s are", state.rate);
    for (const [k, { name, words, size, unit, to }] of params.entries()) {
      if (words || unit !== "mm") continue;
      await type(`param_${name}`, "2.5 in");
      expect(Math.abs(state.p[k] - 0.0635) < 1e-15, "2.5 in are", state.p[k]);
      await type(`param_${name}`, `${(1.25 * to) / size}`);
      expect(Math.abs(state.p[k] - 1.25 * to) < 1e-12, name, "beyond its slider is", state.p[k]);
      expect(+$(`#param_${name}`).value === state.p[k], "the slider is at", $(`#param_${name}`).value);
    }
    document.activeElement.blur();
    $("#reset").click();
    await drawn();
  },
  /// Reactions are as long as one scale says, and the scale is drawn.
  async arrows() {
    play(false);
    const lengthOf = (path) => {
      const [, x, y, u, v] = /^M([-\d.]+) ([-\d.]+)L([-\d.]+) ([-\d.]+)/.exec(path.getAttribute("d")).map(Number);
      return Math.hypot(u - x, v - y);
    };
    let seen = 0;
    for (let k = 0; k < STEPS; k += 6) {
      go([samples[k].x]);
      await drawn();
      const { forces } = answersAt(new Pose(state.q));
      const [number, unit] = nodes.forceWords.textContent.split(" "), newtons = number * { mN: 1e-3, N: 1, kN: 1e3, MN: 1e6 }[unit];
      const scale = lengthOf(nodes.forceScale) / newtons;
      for (const { path, effort } of nodes.arrows) {
        if (path.getAttribute("visibility") === "hidden") continue;
        const n = efforts.findIndex((row) => row.effort === effort), size = Math.hypot(forces[n], forces[n + 1]);
        // Both ends, and those of the scale, are rounded to a tenth of a pixel.
        expect(Math.abs(lengthOf(path) - size * scale) < 0.2 + 0.2 * (size / newtons), effort, "is", lengthOf(path), "long for", size * scale);
        seen++;
      }
    }
    expect(seen > 40, "only", seen, "arrows");
  },
  /// Played, an input moves by its rate, so much slower or faster than our time.
  async pace() {
    play(false);
    for (const share of [1, 0.5, -0.25, 0]) {
      state.rate = inputs[0].rate * share;
      [pace, sense] = [0.1, 1];
      const begun = state.q[0] = 1, by = stepTo(state.rate * pace * 0.016) - begun;
      expect(Math.abs(nearest(by) - state.rate * 0.0016) < 1e-12, "in 16 ms it moves by", by, "at", state.rate);
    }
    $("#reset").click();
    expect(Math.abs((sizeOf(inputs[0]) / state.rate / pace) * Math.log10(5) - 5 * Math.log10(5)) < 5, "a turn takes", sizeOf(inputs[0]) / state.rate / pace);
  },
  /// The state behind the address, what is none of it, and an address that changes.
  async address() {
    play(false);
    const at = async (hash) => {
      location.hash = hash;
      dispatchEvent(new Event("hashchange"));
      await drawn();
    };
    const [{ name }] = inputs, other = offered.at(-1);
    await at(`#${encodeURIComponent(name)}=0.75&~rate=3&~shown=${encodeURIComponent(other)}`);
    expect(state.q[0] === 0.75 && state.rate === 3 && state.shown === other, "the address is", state.q[0], state.rate, state.shown);
    expect(charts.length && $("#shown").value === other && $("#missed").hidden, "what is shown is", $("#shown").value);
    await at("#%E0%A4%A&nothing=1");
    expect(!$("#missed").hidden && $("#missed").textContent.includes("nothing"), "nothing is said:", $("#missed").textContent);
    expect(figure.querySelectorAll("path").length > 5 && charts.length, "the page is empty");
    $("#reset").click();
    await at("");
  },
  /// A second finger, and the other button of a mouse, move nothing.
  async fingers(name) {
    play(false);
    const far = ([x, y]) => [x + 40 / view.scale, y + 30 / view.scale];
    send("pointerdown", now(name), { button: 2 });
    expect(!drag, "the other button drags");
    send("pointerdown", now(name));
    const begun = [...state.q];
    send("pointerdown", now(name), { pointerId: 7, isPrimary: false });
    send("pointermove", far(now(name)), { pointerId: 7, isPrimary: false });
    expect(state.q.every((x, k) => x === begun[k]), "a second finger moves it to", state.q.join());
    send("pointerup", now(name), { pointerId: 7, isPrimary: false });
    expect(drag, "a second finger lets it go");
    send("pointerup", now(name));
    expect(!drag, "it is not let go");
  },
  /// A joint far beyond its reach and back, also from a pose that cannot be assembled: the machine follows again.
  async stuck(name) {
    play(false);
    const from = now(name), way = [-1, 1].flatMap((sign) => [0.3, 0.8, 1.5, 0.8, 0.3, 0].map((share) => [sign * share, share]));
    const places = way.map(([x, y]) => [from[0] + (x * view.width) / view.scale, from[1] + (y * view.height) / view.scale]);
    await take(name, places, () => expect(!new Pose(state.q).error, name, "is dragged into a gap"));
    expect(apart(now(name), from) * view.scale < 1, name, "does not come back");
    const [input] = inputs, gap = samples.find(({ pose }) => pose.error && pose.point(point(name)));
    if (!gap) return;
    await set($(`#input_${input.name}`), gap.x);
    expect(new Pose(state.q).error, "the slider does not go into the gap");
    await take(name, [from, from]);
    expect(!new Pose(state.q).error, name, "stays in a gap");
  },
  /// Curves that are kept stand dashed beside the new ones, and the table tells the change.
  async keeps() {
    play(false);
    const n = params.findIndex(({ words, value }) => !words && value), was = state.p[n], before = csv(), cell = () => $("#values td").textContent;
    $("#keep").click();
    await drawn();
    expect(charts.every(({ olds, lines }) => olds.every((old, k) => old.getAttribute("d") === lines[k].getAttribute("d"))), "what is kept is another curve");
    state.p[n] = 1.1 * was;
    draw(CURVES);
    await drawn();
    const [now, then] = [answersAt(new Pose(state.q)), answersOf(kept, state.q)], row = rows[0];
    expect(state.p[n] === 1.1 * was, "asking for the kept state sets it");
    const by = valueOf(row, 0, now.motion) - valueOf(row, 0, then.motion), { shown: [, times] } = row.scales[0];
    told = 0;
    tellValues(now);
    const written = +/\(([+−][\d.]+)\)/.exec(cell())[1].replace("−", "-");
    expect(Math.abs(written - by * times) <= 0.006 * Math.abs(by * times), "the change is", cell(), "for", by * times);
    expect(csv() !== before, params[n].name, "changes nothing");
    expect(charts.some(({ olds, lines }) => olds[0].getAttribute("d") !== lines[0].getAttribute("d")), "kept curves follow");
    $("#keep").click();
    await drawn();
    expect(charts.every(({ olds }) => olds.every((old) => !old.getAttribute("d"))), "what is kept stays");
    $("#reset").click();
    await drawn();
  },
  /// A joint that is clicked tells its motion, and arrows show it; clicked once more it does not.
  async picks(name) {
    play(false);
    go(inputs.map(({ from, to }) => from + 0.3 * (to - from)));
    await drawn();
    const click = async () => {
      send("pointerdown", now(name));
      send("pointerup", now(name));
      await drawn();
    };
    await click();
    expect(!$("#picked").hidden && $("#picked h2").textContent === name, "what is told is", $("#picked").textContent);
    const [x, y] = rowsOf(name), { motion } = answersAt(new Pose(state.q)), speed = Math.hypot(motion[x.at[1]], motion[y.at[1]]);
    const terms = [...$("#picked dl").children].map((node) => node.textContent), size = terms[terms.indexOf("velocity, size") + 1];
    expect(Math.abs(numberIn(size, "m/s", ["mm/s", 1e3]) - speed) < 1e-3 * speed, "its speed is", size, "for", speed);
    expect(state.shown === name, "the curves are those of", state.shown);
    const [{ path }] = nodes.rates, [, u0, v0, u1, v1] = /^M([-\d.]+) ([-\d.]+)L([-\d.]+) ([-\d.]+)/.exec(path.getAttribute("d")).map(Number);
    const turned = Math.atan2(v0 - v1, u1 - u0) - Math.atan2(motion[y.at[1]], motion[x.at[1]]);
    expect(Math.abs(nearest(turned)) < 0.1, "its arrow is off by", turned);
    await click();
    expect($("#picked").hidden && path.getAttribute("visibility") === "hidden", "it stays");
  },
  /// A drawing that is taken along has its colours in it, and asks for nothing.
  async saves() {
    const saved = [], { createObjectURL } = URL, { click } = HTMLAnchorElement.prototype;
    URL.createObjectURL = (blob) => (saved.push(blob), "");
    HTMLAnchorElement.prototype.click = () => {};
    for (const id of ["svg", "charts_svg", "csv"]) $(`#${id}`).click();
    const [figureText, chartsText] = await Promise.all(saved.slice(0, 2).map((blob) => blob.text()));
    for (const text of [figureText, chartsText]) {
      const drawing = new DOMParser().parseFromString(text, "image/svg+xml");
      expect(!drawing.querySelector("parsererror"), "a saved drawing is none:", text.slice(0, 80));
      const strokes = [...drawing.querySelectorAll("path")].map((path) => path.style.stroke).filter((stroke) => stroke && stroke !== "none");
      expect(strokes.length > 3 && !text.includes("var(--"), "a saved drawing has no colours of its own");
    }
    expect(chartsText.split("<svg").length - 2 === charts.filter(({ svg }) => svg.style.display !== "none").length, "charts are missing");
    $("#png").click();
    for (let k = 0; k < 40 && saved.length < 4; k++) await new Promise((done) => setTimeout(done, 50));
    expect(saved.length === 4 && saved[3]?.type === "image/png" && saved[3].size > 2000, "the PNG is", saved[3]?.size);
    Object.assign(URL, { createObjectURL });
    HTMLAnchorElement.prototype.click = click;
  },
  /// Run by itself, a mass on a spring swings as the formula says.
  async runs(k, m) {
    play(false);
    const h = 1 / 960, w = Math.sqrt(k / m);
    let [q, v] = [[0.1], [0]];
    for (let n = 1; n <= 4800; n++) {
      [q, v] = later(q, v, h);
      // The method's phase is late by a share of (w h)⁴/120 of each step.
      const off = Math.abs(q[0] - 0.1 * Math.cos(w * n * h));
      if (off > 1e-8) return expect(false, "after", n, "steps it is off by", off);
    }
    go([0.1]);
    state.rate = 0;
    draw(CURVES);
    await drawn();
    run(true);
    expect(running && $("#run").textContent === "Stop", "it does not run");
    for (let n = 0; n < 30; n++) await drawn();
    expect(running && state.q[0] < 0.1 - 1e-6, "it stands at", state.q[0]);
    const { motion } = answersAt(new Pose(state.q)), [x] = rows;
    expect(motion[x.at[1]] === running.v[0] && Math.abs(motion[x.at[2]] - running.a[0]) < 1e-12, "its rates are", motion.join());
    draw(CURVES);
    await drawn();
    expect(running && samples.every(({ motion }) => motion[x.at[1]] === 0), "the curves run as well");
    await press(" ");
    expect(!running && playing, "play does not end the run");
    $("#reset").click();
    await drawn();
    expect(!running && !playing, "it runs on");
  },
  /// A load that is applied is drawn to the scale of forces.
  async loads() {
    play(false);
    const most = 7500;
    state.l[0] = most;
    draw(SCALE);
    await drawn();
    let seen = 0;
    for (let k = 0; k < STEPS; k += 12) {
      go([samples[k].x]);
      await drawn();
      const { applied } = answersAt(new Pose(state.q)), [{ path }] = nodes.applied;
      if (path.getAttribute("visibility") === "hidden") continue;
      const [, x, y, u, v] = /^M([-\d.]+) ([-\d.]+)L([-\d.]+) ([-\d.]+)/.exec(path.getAttribute("d")).map(Number);
      const share = Math.hypot(u - x, v - y) / Math.hypot(applied[0], applied[1]);
      expect(Math.abs(share * largestForce - (view.width < 500 ? 36 : 90)) < 1, "the load is", share * largestForce, "pixels of the largest");
      expect(Math.sign(u - x) === Math.sign(Math.round(applied[0])) || Math.abs(applied[0]) < 100, "it points the other way");
      seen++;
    }
    expect(seen > 5, "the load is drawn", seen, "times");
    $("#reset").click();
    await drawn();
  },
  /// What a slider holds at its ends, fingers, and readers of the screen.
  async ends() {
    play(false);
    const [input] = inputs, range = $(`#input_${input.name}`);
    await set(range, range.max);
    expect(Math.abs(state.q[0] - input.to) < 1e-9 && +range.value === +range.max, "at its end it is", state.q[0], range.value);
    await set(range, range.min);
    const text = $(`#input_${input.name}_field`).value, shown = numberIn(text, input.unit, shownIn(input.unit, 0));
    expect(Math.abs(shown - input.from) < 1e-3 * sizeOf(input), "its first end reads", text);
    expect(getComputedStyle(figure).touchAction.includes("pinch-zoom"), "two fingers cannot enlarge the picture");
    expect(!document.querySelector("output"), "a reader of the screen is told every frame");
    $("#reset").click();
    await drawn();
  },
  async look() {
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
  parent.postMessage({ failures: failures.slice(0, 6), told: [`${spent.length} frames`] }, "*");
}, 200));
