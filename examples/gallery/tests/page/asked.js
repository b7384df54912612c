// What a reader asks of a page, types into it, keeps and takes along. The steps are named like those of `drag.js`, behind
// which this stands.

Object.assign(STEPS_OF, {
  /// What the declaration says of a number can be read beside it, and is told with its fields.
  async "told"() {
    const known = [...inputs, ...params, ...loads].filter(({ docs }) => docs);
    expect(known.length > 0, "nothing is said of any number");
    for (const { name, docs } of known) {
      const fields = [...document.querySelectorAll(`#input_${name}, #param_${name}, #load_${name}`)].flatMap((field) => [field, $(`#${field.id}_field`)]);
      expect(fields.length === 2, name, "has", fields.length, "fields");
      for (const field of fields) {
        const said = document.getElementById(field.getAttribute("aria-describedby"));
        expect(said?.textContent === docs && said.getBoundingClientRect().height > 8, name, "is described by", said?.textContent);
      }
    }
  },
  /// On a phone picture, curves and the slider that is moved are on the screen together.
  async "strip"() {
    const isNarrow = innerWidth <= 860, box = (node) => node.getBoundingClientRect(), slides = [...document.querySelectorAll("#machine input[type=range]")].findLast((node) => node.offsetHeight > 0);
    slides.scrollIntoView({ "block": "center" });
    slides.dispatchEvent(new Event("input", { bubbles: true }));
    await drawn();
    const strip = box($("#charts")), picture = box(figure), held = box(slides);
    expect(document.body.classList.contains("sliding") === isNarrow, "a slider that is moved is not known");
    if (isNarrow) {
      expect(strip.height > 100 && strip.bottom <= innerHeight + 1 && strip.top < innerHeight, "the curves are at", strip.top, strip.bottom);
      expect(Math.abs(picture.top) < 1 && picture.height > 100, "the picture is at", picture.top);
      expect(held.top >= picture.bottom && held.bottom <= strip.top, "the slider is covered:", picture.bottom, held.top, held.bottom, strip.top);
      expect(document.documentElement.scrollWidth <= innerWidth, "the page is wider than its window");
    }
    await new Promise((done) => setTimeout(done, 2200));
    expect(!document.body.classList.contains("sliding"), "the strip stays");
    scrollTo(0, 0);
    $("#reset").click();
    await drawn();
  },
  /// Curves that are kept stand dashed beside the new ones, and the table tells the change.
  async "keeps"() {
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
  async "picks"(name) {
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
  async "saves"() {
    const saved = [], { createObjectURL } = URL, { click } = HTMLAnchorElement.prototype;
    URL.createObjectURL = (blob) => (saved.push(blob), "");
    HTMLAnchorElement.prototype.click = () => {};
    for (const id of ["svg", "charts_svg", "csv"]) $(`#${id}`).click();
    const [figureText, chartsText] = await Promise["all"](saved.slice(0, 2).map((blob) => blob.text()));
    for (const text of [figureText, chartsText]) {
      const drawing = new DOMParser().parseFromString(text, "image/svg+xml");
      expect(!drawing.querySelector("parsererror"), "a saved drawing is none:", text.slice(0, 80));
      const strokes = [...drawing.querySelectorAll("path")].map((path) => path.style.stroke).filter((stroke) => stroke && stroke !== "none");
      expect(strokes.length > 3 && !text.includes("var(--"), "a saved drawing has no colours of its own");
    }
    const [, , wide, high] = new DOMParser().parseFromString(chartsText, "image/svg+xml").documentElement.getAttribute("viewBox").split(" ").map(Number);
    const shown = charts.filter(({ svg }) => svg.style.display !== "none");
    expect(wide === shown[0].width && high === shown.reduce((sum, { height }) => sum + height + 8, 0), "the curves are", wide, "by", high);
    expect(chartsText.split("<svg").length - 2 === charts.filter(({ svg }) => svg.style.display !== "none").length, "charts are missing");
    $("#png").click();
    for (let k = 0; k < 40 && saved.length < 4; k++) await new Promise((done) => setTimeout(done, 50));
    expect(saved.length === 4 && saved[3]?.type === "image/png" && saved[3]["size"] > 2000, "the PNG is", saved[3]?.["size"]);
    Object.assign(URL, { createObjectURL });
    HTMLAnchorElement.prototype.click = click;
  },
  /// A joint that is clicked tells the components of its reaction, in newtons.
  async "reacts"() {
    play(false);
    const { point, at } = reactions[0];
    pick({ point });
    await drawn();
    const terms = [...$("#picked dl").children].map((node) => node.textContent), { forces } = answersAt(new Pose(state.q));
    for (const k of [at, at + 1]) {
      const said = terms[terms.indexOf(efforts[k].label) + 1], most = Math.max(...samples.map(({ forces }) => Math.abs(forces[k])));
      expect(Math.abs(numberIn(said ?? "", "N", ["N", 1]) - forces[k]) <= 1e-3 * Math.abs(forces[k]) + 1e-9 * most, efforts[k].label, "is", said, "for", forces[k]);
    }
    pick({ point });
    await drawn();
  },
  /// The points whose paths are drawn without being asked for.
  async "traced"(...names) {
    expect(tracedPoints.map((point) => PLAN.points[point]).join() === names.join(), "paths are those of", tracedPoints.map((point) => PLAN.points[point]).join());
  },
  /// Curves of an output stand above those of the drives alone.
  async "drives"(name, ...titles) {
    const found = chartsOf(name).filter(({ isMotion }) => !isMotion).map(({ title }) => title);
    expect(found.join() === titles.join(), "beside", name, "are", found.join());
  },
  /// The cursor of the curves goes with a pointer that is pressed on them, and with no other.
  async "scrub"() {
    play(false);
    const [{ svg, X, width }] = charts, box = svg.getBoundingClientRect(), [from, to] = domain(), [a, b] = [0.25, 0.6].map((share) => from + share * (to - from));
    const touch = async (kind, x) => {
      const clientX = box.left + (X(x) * box.width) / width;
      svg.dispatchEvent(new PointerEvent(kind, { clientX, clientY: box.top + 60, pointerId: 3, bubbles: true }));
      await drawn();
    };
    const isAt = (x) => Math.abs(state.q[state.axis] - x) < 2e-3 * (to - from);
    await touch("pointerdown", a);
    expect(isAt(a), "pressed, the cursor is at", state.q[state.axis], "for", a);
    await touch("pointermove", b);
    expect(isAt(a), "a pointer that is not pressed moves it to", state.q[state.axis]);
    isPressed = true;
    await touch("pointermove", b);
    isPressed = false;
    expect(isAt(b), "drawn, it is at", state.q[state.axis], "for", b);
  },
  /// A block that a link does not reach: its pin's line, and between both what is missing, as long as it is said.
  async "unreached"() {
    play(false);
    const failed = () => new Pose(state.q).error;
    while (!failed()) state.p[0] *= 1.1;
    draw(CURVES);
    await drawn();
    const pose = new Pose(state.q), lineOf = (path) => path.getAttribute("d").slice(1).split("M")[0].split("L").map((spot) => spot.split(" ").map(Number));
    const k = pose.failed.members.findIndex(({ shape }) => shape === "block"), [a, b] = lineOf(nodes.reaches[k]), gap = lineOf(nodes.missing);
    const { cos, sin } = pose.guide(pose.failed.members[k].guide), along = [(b[0] - a[0]) * cos - (b[1] - a[1]) * sin, (b[0] - a[0]) * sin + (b[1] - a[1]) * cos];
    expect(Math.abs(Math.abs(along[0]) - 240) < 0.3 && Math.abs(along[1]) < 0.3, "the line is", a, b, "along", cos, sin);
    const foot = [0, 1].map((n) => (a[n] + b[n]) / 2);
    expect(gap.some((end) => apart(end, foot) < 0.5), "the line passes", foot, "beside what is missing", gap);
    expect(Math.abs(apart(...gap) - failed().by * view.scale) < 0.3, "missing are", apart(...gap), "for", failed().by * view.scale);
    $("#reset").click();
    await drawn();
  },
  /// A spring of which an end stands nowhere is not drawn.
  async "sprung"() {
    play(false);
    const [{ ends }] = PLAN.springs, d = () => nodes.spring[0].getAttribute("d");
    expect(d().length > 100, "the spring is", d());
    let z = inputs[0].to;
    while (!new Pose([z]).error) z += 0.1 * sizeOf(inputs[0]);
    go([z]);
    await drawn();
    expect(ends.some((end) => !new Pose([z]).point(end)) && d() === "", "in a gap the spring is", d());
    $("#reset").click();
    await drawn();
  },
  /// Run by itself, a mass on a spring swings as the formula says.
  async "runs"(k, m) {
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
  async "loads"() {
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
  /// A joint far beyond its reach and back, also from a pose that cannot be assembled: the machine follows again.
  async "stuck"(name) {
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
  /// Numbers that are typed, beyond the slider's ends and in other units; what is none is refused and forgotten.
  async "typed"() {
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
      expect(Math.abs($(`#param_${name}`).value - state.p[k]) < 1e-15, "the slider is at", $(`#param_${name}`).value);
    }
    document.activeElement.blur();
    $("#reset").click();
    await drawn();
  },
  /// Reactions are as long as one scale says, and the scale is drawn.
  async "arrows"() {
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
  /// Where a peak would leave other arrows too short, its arrow is cut and has two heads.
  async "cut"() {
    play(false);
    const most = view.width < 500 ? 36 : 90;
    let [cut, whole] = [0, 0];
    for (let k = 0; k <= STEPS; k += 5) {
      go([samples[k].x]);
      await drawn();
      for (const { arrow, size } of arrowsOf(answersAt(new Pose(state.q)))) {
        if (!arrow || arrow.path.getAttribute("visibility") === "hidden") continue;
        const d = arrow.path.getAttribute("d"), [, x, y, u, v] = /^M([-\d.]+) ([-\d.]+)L([-\d.]+) ([-\d.]+)/.exec(d).map(Number);
        const isCut = size > largestForce, length = Math.hypot(u - x, v - y);
        expect(Math.abs(length - Math.min(1, size / largestForce) * most) < 0.2, size, "newtons are", length, "long");
        expect(d.split("M").length === (isCut ? 5 : 3), size, "newtons have the heads", d);
        isCut ? cut++ : whole++;
      }
    }
    expect(cut > 3 && whole > 100, cut, "arrows are cut,", whole, "are whole");
    // The force that every tenth pose exceeds, and its scale.
    const peaks = samples.map(({ forces, applied }) => Math.max(Math.abs(forces[efforts.findIndex(({ effort }) => effort === driven)]), ...applied.map(Math.abs)));
    expect(peaks.filter((size) => size > largestForce).length === STEPS / 10, "cut are", peaks.filter((size) => size > largestForce).length);
    expect(Math.max(...peaks) > 2 * largestForce && nodes.forceWords.textContent === "20 kN (» longer)", "the scale is", nodes.forceWords.textContent);
  },
  /// Played, an input moves by its rate, so much slower or faster than our time.
  async "pace"() {
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
  async "address"() {
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
  async "fingers"(name) {
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
  /// What a slider holds at its ends, fingers, and readers of the screen.
  async "ends"() {
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
});
