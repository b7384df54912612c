// The page: what happens when something is dragged, set or played, and what is drawn then.

/// What has to be drawn anew: the pose, the curves as well, the scale as well.
const POSE = 1, CURVES = 3, SCALE = 7;
let due = 0, lastGood = null;
const draw = (what) => {
  if (!due) requestAnimationFrame(frame);
  due |= what;
  if (what !== POSE) showDeclaration();
};

/// The milliseconds of script in each frame, for those who measure.
const spent = [];
const frame = () => {
  const begun = performance.now(), what = due;
  due = 0;
  if (what === SCALE) fit();
  else if (what === CURVES) sample();
  if (what !== POSE) {
    drawCurves();
    if (params.length) tellWorst();
  }
  drawPose();
  if (drag?.isOnItsWay) follow();
  spent.push(performance.now() - begun);
  if (spent.length > 1000) spent.shift();
};

/// Asked with the scale alone: asking in every frame would lay the page out in each once more.
let chartsWidth = 0;

/// True if the page finds ends of sliders itself.
const isOpen = [...inputs, ...params, ...loads].some(({ words, from }) => !words && !isFinite(from));
/// Scale and origin by which everything fits; all nodes anew.
const fit = () => {
  if (isOpen) findRanges();
  const poses = surveyed();
  chartsWidth = $("#charts").clientWidth;
  if (hasSlides) survey(poses);
  const [[x0, x1], [y0, y1]] = boxOf(poses);
  extent = max(x1 - x0, y1 - y0);
  if (!charts.length) buildCharts();
  const width = figure.parentElement.clientWidth, spare = width < 500 ? 40 : hasForces && forcesIn(answersAt(poses[0])).length ? 96 : 56;
  const least = width < 500 ? 240 : 300, most = max(320, min(0.62 * innerHeight, 560));
  const [wide, high] = [max(x1 - x0, 1e-3 * (y1 - y0), 1e-12), y1 - y0];
  const inner = clamp(((width - 2 * spare) * high) / wide + 2 * spare, least, most);
  const scale = min((width - 2 * spare) / wide, (inner - 2 * spare) / max(high, 1e-3 * wide));
  // Below stands the scale. Letters are as wide as the page's font has a digit beside Arial's.
  // While the page around this one moves a point, the scale stands still.
  assign(view, { scale, width, height: inner + 16, letter: widthOf("0") / 6.4, x: width / 2 - (scale * (x0 + x1)) / 2, y: inner / 2 + (scale * (y0 + y1)) / 2 }, globalThis.MOVED);
  sample();
  build(poses);
  setAll();
};

const drawCurves = () => {
  tracedPoints.forEach((point, k) => {
    const way = (samples) => lineThrough(samples.map(({ pose }) => !pose.error && onPage(pose.point(point))));
    trace(nodes.trace[k], way(samples));
    trace(nodes.oldTrace[k], way(isBeside() ? kept.samples : []));
  });
  // One margin for all, so that a cursor stands in one line.
  const left = max(...charts.map((chart) => prepared(chart).room), 34);
  charts.forEach((chart) => drawChart(chart, chartsWidth, left));
  // A motion that is none is left out, unless nothing else is there.
  const isAtRest = charts.every(({ isFlat }) => isFlat);
  for (const { svg, isFlat } of charts) svg.style.display = isFlat && !isAtRest ? "none" : "";
};

const drawPose = () => {
  const pose = new Pose(state.q);
  if (!pose.error) lastGood = pose;
  const now = answersAt(pose);
  const bodies = bodiesOf(pose), arrows = hasForces ? arrowsOf(now) : [];
  drawBodies(nodes.body, bodies);
  show(nodes.ghost, pose.error && lastGood);
  if (pose.error && lastGood) drawBodies(nodes.shade, bodiesOf(lastGood));
  if (PLAN.springs.length) drawSprings(pose);
  drawJoints(pose, bodies, arrows);
  drawGap(pose);
  const end = hasForces && drawForces(pose, arrows);
  if (MACHINE.marks) drawMarks(now, end);
  drawPicked(pose, now);
  const said = inputs.map(({ name }, k) => `${name} ${inputWords(k)}`.replaceAll(" ", "\u00a0")).join("  ·  ");
  say($("#state"), now.refused ? `${said}: ${why(now.refused)}` : said);
  $("#state").classList.toggle("warn", !!now.refused);
  const held = drag && pose.point(drag.point);
  show(nodes.halo, held, held && onPage(held));
  setInputs();
  drawCursors(now);
  tellValues(now);
  tellPicked(pose, now);
};

/// Other inputs. The curves over one input change where another one does.
const go = (q) => {
  const isOther = q.some((x, k) => k !== state.axis && x !== state.q[k]);
  state.q = q;
  draw(isOther ? CURVES : POSE);
  if (!playing && !running) remember();
};

const setAxis = (k) => {
  assign(state, { axis: k, rate: inputs[k].rate });
  $("#axis").value = k;
  setAll();
  setPace();
  draw(CURVES);
};

// ---- dragging ---------------------------------------------------------------------------------------

let drag = null;
const placeOf = ({ clientX, clientY }) => {
  const box = figure.getBoundingClientRect(), pixel = view.width / box.width;
  return [((clientX - box.left) * pixel - view.x) / view.scale, (view.y - (clientY - box.top) * pixel) / view.scale];
};
const movable = [...used].filter((point) => !grounds.has(point));
const pointNear = (place, far, among = movable) => {
  const pose = new Pose(state.q);
  const near = among.map((point) => [pose.point(point), point]).filter(([at]) => at)
    .map(([at, point]) => [apart(at, place) * view.scale, point]).filter(([distance]) => distance < far);
  return near.sort((a, b) => a[0] - b[0])[0]?.[1];
};

/// What was pressed: released in the same place, it is asked for.
let pressed = null;
on(figure, "pointerup", ({ clientX, clientY, isPrimary }) => {
  if (!pressed || !isPrimary || apart(pressed.at, [clientX, clientY]) > 3) return;
  const { point, link } = pressed;
  pressed = null;
  if (point !== undefined || link || picked) pick(point !== undefined ? { point } : link);
});

/// One finger, or the main button of a mouse, takes a joint.
on(figure, "pointerdown", (event) => {
  if (drag || !event.isPrimary || event.button !== 0) return;
  const place = placeOf(event), point = pointNear(place, event.pointerType === "touch" ? 44 : 28);
  pressed = { at: [event.clientX, event.clientY], point: pointNear(place, 14, [...used]), link: linkAt(event.target) };
  if (point === undefined) return;
  event.preventDefault();
  figure.focus({ preventScroll: true });
  figure.setPointerCapture(event.pointerId);
  play(false);
  drag = { point, pointer: event.pointerId, crank: crankOf(point), offset: minus(new Pose(state.q).point(point), place) };
  draw(POSE);
});
// A finger on a joint does not scroll.
on(figure, "touchstart", (event) => drag && event.preventDefault());
on(figure, "pointermove", (event) => {
  const place = placeOf(event);
  if (!drag) {
    figure.style.cursor = pointNear(place, 28) === undefined ? "" : "grab";
    return;
  }
  if (event.pointerId !== drag.pointer) return;
  drag.to = place.map((part, k) => part + drag.offset[k]);
  follow();
});
/// The dragged point goes to the pointer. Where it is still on its way, as behind a quick hand, the next frame goes on.
const follow = () => {
  const { to, crank, point } = drag, { q } = state;
  // A crank goes into a gap and out of it; any other joint is dragged on from the last pose that is whole.
  if (crank) return go(turned(crank, point, to, q));
  const pose = new Pose(q), next = towards(point, to, pose.error ? lastGood?.q ?? q : q);
  const [before, behind] = [pose, new Pose(next)].map((pose) => pose.point(point));
  go(next);
  drag.isOnItsWay = before && behind && apart(before, behind) * view.scale > 0.5;
};
for (const end of ["pointerup", "pointercancel"]) {
  on(figure, end, ({ pointerId }) => {
    if (pointerId !== drag?.pointer) return;
    drag = null;
    draw(POSE);
  });
}

/// The cursor of the curves is dragged as well.
const scrub = (event) => {
  const [{ svg, left, right, width }] = charts, box = svg.getBoundingClientRect(), [from, to] = domain();
  const share = clamp((((event.clientX - box.left) / box.width) * width - left) / (width - left - right), 0, 1);
  play(false);
  go(withInput(state.axis, from + (to - from) * share));
};
on($("#charts"), "pointerdown", (event) => {
  $("#charts").setPointerCapture(event.pointerId);
  scrub(event);
});
on($("#charts"), "pointermove", (event) => $("#charts").hasPointerCapture(event.pointerId) && scrub(event));

on(figure, "keydown", (event) => {
  const way = { "ArrowRight": 1, "ArrowUp": 1, "ArrowLeft": -1, "ArrowDown": -1 }[event.key];
  if (event.key === " ") play(!playing);
  else if (way) {
    const input = inputs[state.axis], step = input.isAngle ? PI / 180 : sizeOf(input) / 200;
    play(false);
    go(withInput(state.axis, within(state.q[state.axis] + way * step * (event.shiftKey ? 10 : 1), input)));
  } else return;
  event.preventDefault();
});

// ---- play -------------------------------------------------------------------------------------------

/// Seconds of a path. Anything else plays at its rate, in a time that runs so much slower or faster than ours.
const SECONDS = 5;
let playing = false, phase = 0, sense = 1, then = null, pace = 1;
const PACES = [1000, 500, 200, 100, 50, 20, 10, 5, 2, 1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001];
const paceWords = (x) => (x < 1 ? `${round(1 / x)} × slower` : x > 1 ? `${x} × faster` : "real time");

/// The pace at which a turn, or a way there and back, takes about five seconds.
const setPace = () => {
  const input = inputs[state.axis], own = (sizeOf(input) * (input.turns ? 1 : 2)) / abs(state.rate || input.rate || 1);
  const off = (x) => abs(Math.log(own / SECONDS / x));
  pace = PACES.reduce((best, x) => (off(x) < off(best) ? x : best));
  $("#pace").value = pace;
};

const play = (wanted) => {
  if (running) run(false);
  if (wanted === playing) return;
  playing = wanted;
  say($("#play"), playing ? "Pause" : "Play");
  $("#play").setAttribute("aria-pressed", playing);
  then = null;
  if (playing) requestAnimationFrame(tick);
  else remember();
};

const tick = (time) => {
  if (!playing) return;
  const seconds = then === null ? 0 : min((time - then) / 1e3, 0.1);
  then = time;
  if (PAGE.path.length) {
    const { length } = PAGE.path;
    phase = (phase + (seconds / SECONDS) * length) % length;
    const k = floor(phase), [a, b] = [PAGE.path[k], PAGE.path[(k + 1) % length]];
    go(a.map((x, n) => x + (b[n] - x) * (phase - k)));
  } else {
    go(withInput(state.axis, stepTo(state.rate * pace * seconds)));
  }
  requestAnimationFrame(tick);
};

/// One input's next value, a step on: round by round, and back where it ends or the machine cannot follow. No step
/// leaps over a gap.
const stepTo = (step) => {
  const input = inputs[state.axis], x = state.q[state.axis], most = sizeOf(input) / 12;
  const next = (way) => x + way * clamp(step, -most, most);
  const isFree = (x) => within(x, input) === x && !new Pose(withInput(state.axis, x)).error;
  if (!isFree(next(sense)) && isFree(x)) sense = -sense;
  const to = next(sense);
  return input.turns ? to - TURN * floor(to / TURN) : within(to, input);
};

// ---- beginning --------------------------------------------------------------------------------------

/// Inputs at which the machine can be assembled, if those at first are none.
const begin = () => {
  if (!new Pose(state.q).error) return;
  for (const k of inputs.keys()) {
    const { from, to } = inputs[k], found = stepped(SURVEYED, [from, to], (x) => withInput(k, x));
    const q = found.find((q) => !new Pose(q).error);
    if (q) {
      state.q = q;
      return;
    }
  }
};

const choose = (id, names) => {
  for (const [value, name] of names) $(id).add(new Option(name, value));
};

const reset = () => {
  play(false);
  assign(state, { q: inputs.map(({ at }) => at), p: params.map(({ value }) => value), l: loads.map(({ value }) => value) });
  assign(state, { axis: 0, rate: inputs[0].rate });
  $("#axis").value = 0;
  begin();
  setPace();
  lastGood = null;
  draw(SCALE);
  remember();
};

const offered = PAGE.curves.length ? PAGE.curves : [...new Set([...rows.map(({ output }) => output), ...efforts.map(({ effort }) => effort)])];

/// What the address says, at first and whenever it is another one.
const take = () => {
  const text = takeAsked(), isOther = BY && SETS.some(({ set }) => set !== BY.set && text.split("&").includes(byIn(set)));
  // A page is driven by one set, chosen while it loads.
  if (isOther && !isInside) return location.reload();
  recall(text);
  $("#axis").value = state.axis;
  showCurvesOf(state.shown);
  setPace();
  draw(SCALE);
};

const start = () => {
  const traced = tracedPoints.map((point) => PLAN.points[point]).find((name) => offered.includes(name));
  state.shown = PAGE.curves[0] ?? traced ?? rows.at(-1)?.output ?? offered.at(-1);
  buildControls((what) => {
    draw(what);
    remember();
  });
  const titleOf = (name) => rows.find(({ output }) => output === name)?.title ?? name;
  choose("#shown", offered.map((name) => [name, titleOf(name)]));
  choose("#axis", inputs.map(({ name }, k) => [k, name]));
  choose("#pace", PACES.map((x) => [x, paceWords(x)]));
  choose("#length", Object.keys(UNITS.length).map((unit) => [unit, unit]));
  if (BY) offerSets();
  choose("#angle", Object.keys(UNITS.angle).map((unit) => [unit, unit]));
  $("#axis").parentElement.hidden = inputs.length < 2;
  $("#results").hidden = !offered.length;
  $("#pace").hidden = PAGE.path.length > 0 && !MACHINE.forward_dynamics;
  buildTable();
  if (params.length) offerTolerances();
  if (isOpen) findRanges();
  const isRecalled = location.hash.length > 1 || asked !== "";
  document.body.classList.toggle("inside", isInside);
  if (!isRecalled) begin();
  take();
  fit();
  if (PAGE.before.length) keepBefore();
  const isStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (!isStill && !isRecalled) play(true);
  tellParent("ready");
};

onClick("#play", () => play(!playing));
onClick("#reset", reset);
onClick("#copy", copyDeclaration);
onClick("#csv", () => {
  save(new Blob([csv()], { type: "text/csv" }), "csv");
});
onClick("#keep", keep);
for (const ending of ["svg", "png"]) {
  onClick(`#${ending}`, () => saveDrawing([figure], ending));
  onClick(`#charts_${ending}`, () => saveDrawing(charts.map(({ svg }) => svg).filter((svg) => svg.style.display !== "none"), ending));
}
on($("#shown"), "change", ({ target }) => {
  showCurvesOf(target.value);
  draw(CURVES);
  remember();
});
on($("#axis"), "change", ({ target }) => {
  setAxis(+target.value);
  remember();
});
on($("#pace"), "change", ({ target }) => pace = +target.value);
for (const kind of ["length", "angle"]) {
  on($(`#${kind}`), "change", ({ target }) => {
    chosen[kind] = target.value;
    draw(SCALE);
  });
}
addEventListener("hashchange", take);
/// On a narrow screen picture and curves stand at its ends while a slider is moved: what it does to both is seen. The
/// slider goes between them.
let slid = 0;
on($("#machine"), "input", ({ target }) => {
  if (innerWidth > 860 || target.type !== "range") return;
  clearTimeout(slid);
  if (!document.body.classList.contains("sliding")) {
    const card = $(".card"), { top, bottom } = target.getBoundingClientRect();
    card.style.height = `${card.offsetHeight}px`;
    document.body.classList.add("sliding");
    if (top < 0.32 * innerHeight || bottom > 0.64 * innerHeight) scrollBy(0, top - 0.45 * innerHeight);
  }
  slid = setTimeout(() => {
    document.body.classList.remove("sliding");
    $(".card").style.height = "";
  }, 2000);
});
let lastWidth = 0;
new ResizeObserver(() => {
  const width = figure.parentElement.clientWidth;
  if (width !== lastWidth && lastWidth) draw(SCALE);
  lastWidth = width;
}).observe(figure.parentElement);
start();
