// Curves over one input, the values at the cursor, and both as text.

/// Steps of the input that curves are drawn over, and of each input for the picture's size.
const STEPS = 240, SURVEYED = 48;
let samples = [];
/// The largest position, velocity and acceleration of any row.
let largest = [];

const withInput = (k, x) => state.q.map((value, n) => (n === k ? x : value));
const domain = () => [inputs[state.axis].from, inputs[state.axis].to];
const stepped = (count, [from, to], at) => Array.from({ length: count + 1 }, (_, k) => at(from + ((to - from) * k) / count));

const sample = () => {
  samples = stepped(STEPS, domain(), (x) => {
    const pose = new Pose(withInput(state.axis, x));
    return { x, pose, ...answersAt(pose) };
  });
  largest = [0, 1, 2].map((order) => samples.reduce((most, { motion }) =>
    (motion ? rows.reduce((most, { at }) => Math.max(most, Math.abs(motion[at[order]])), most) : most), 0));
  const arrows = efforts.flatMap(({ row, point }, k) => (point !== null && row === "x" ? [k] : []));
  largestForce = 0;
  for (const { forces } of samples) {
    for (const k of arrows) if (forces) largestForce = Math.max(largestForce, Math.hypot(forces[k], forces[k + 1]));
  }
};

/// Poses over every input's range and along the path.
const surveyed = () => [
  new Pose(state.q),
  ...inputs.flatMap(({ from, to }, k) => stepped(SURVEYED, [from, to], (x) => new Pose(withInput(k, x)))),
  ...PAGE.path.map((q) => new Pose(q)),
];

// ---- charts -----------------------------------------------------------------------------------------

const ORDERS = ["Position", "Velocity", "Acceleration"];
const unitOf = (row, order) => shownIn(row.unit, order);
const grouped = (list, keyOf) => [...new Set(list.map(keyOf))].map((key) => list.filter((entry) => keyOf(entry) === key));

/// The effort of the only input, which friction at rest leaves between two ends.
const driven = `${inputs[0].name}.drive`;

/// The charts of an output or a force: one for each order and unit. Charts of drives stand below.
const chartsOf = (name) => {
  const own = rows.filter(({ output }) => output === name);
  const motions = [0, 1, 2].flatMap((order) =>
    grouped(own, (row) => unitOf(row, order)[0]).map((list) => ({
      title: `${ORDERS[order]} of ${name}`,
      unit: unitOf(list[0], order)[0],
      isMotion: true,
      series: list.map((row) => ({
        name: row.row,
        isAngle: row.isAngle && order === 0,
        of: ({ motion }) => {
          const x = motion ? valueOf(row, order, motion) : NaN;
          // What rounding leaves of zero is none.
          return Math.abs(x) < 1e-9 * largest[order] ? 0 : x * unitOf(row, order)[1];
        },
      })),
    })));
  const drives = efforts.filter(({ effort, row }) => row === "" && effort.endsWith(".drive") && effort !== name);
  const asked = [...efforts.filter(({ effort }) => effort === name), ...drives];
  const forces = grouped(asked, ({ effort, unit }) => `${effort} ${unit}`).map((list) => ({
    title: list[0].effort,
    unit: list[0].unit,
    hasBand: MACHINE.holding && list[0].effort === driven,
    series: list.map((row) => ({
      // The title says of what.
      name: row.row,
      of: ({ forces }) => (forces ? forces[efforts.indexOf(row)] : NaN),
    })),
  }));
  return [...motions, ...forces];
};

let charts = [];
const buildCharts = () => {
  $("#charts").replaceChildren();
  charts = chartsOf(state.shown).map((chart, nth) => {
    const svg = made("svg", { class: "chart", role: "img" }, $("#charts"));
    const node = (tag, attributes) => made(tag, attributes, svg);
    const out = node("path", { class: "out" }), grid = node("path", { class: "grid" }), zero = node("path", { class: "zero" });
    const inside = made("rect", {}, made("clipPath", { id: `inside${nth}` }, svg));
    const ticks = node("g", { class: "ticks" }), band = node("path", { class: "band", "clip-path": `url(#inside${nth})` });
    const lines = chart.series.map((_, k) => node("path", { class: `curve s${k}`, "clip-path": `url(#inside${nth})` }));
    const title = node("text", { class: "title" }), legend = node("text", { class: "legend" });
    title.textContent = chart.title;
    const labels = chart.series.map((_, k) => made("tspan", { class: `s${k}` }, legend)), rest = made("tspan", {}, legend);
    const cursor = node("path", { class: "cursor" });
    const dots = chart.series.map((_, k) => node("circle", { class: `dot s${k}`, r: 4 }));
    return { ...chart, svg, out, grid, zero, inside, ticks, band, lines, title, legend, labels, rest, cursor, dots };
  });
};

/// Round numbers in a range, and how far apart they are.
const roundNumbers = ([from, to], count) => {
  const raw = (to - from) / count || 1, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((factor) => factor * power).find((step) => step >= raw * (1 - 1e-9));
  const found = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; k++) found.push(k * step);
  return [found, step];
};
const decimalsOf = (step) => [0, 1, 2, 3, 4, 5].find((d) => Math.abs(step * 10 ** d - Math.round(step * 10 ** d)) < 1e-6) ?? 6;
const tickWords = (x, step) => x.toFixed(decimalsOf(step)).replace("-", "−").replace(/^−(0\.?0*)$/, "$1");

/// Angles that do not jump by a turn.
const unrolled = (values) => {
  let last = null;
  return values.map((x) => {
    if (!isFinite(x)) return x;
    last = last === null ? x : x + 360 * Math.round((last - x) / 360);
    return last;
  });
};

/// The range of a chart. Beside a pose that cannot be assembled, or is singular, the outermost values count
/// for nothing.
const rangeOf = (values) => {
  const known = values.filter(isFinite).sort((a, b) => a - b);
  if (!known.length) return [0, 1];
  const at = (share) => known[Math.round(share * (known.length - 1))];
  const [inner, outer] = [at(0.98) - at(0.02), at(1) - at(0)];
  const isWild = outer > 3 * inner && inner > 0;
  const [from, to] = isWild ? [at(0.02) - 0.5 * inner, at(0.98) + 0.5 * inner] : [at(0), at(1)];
  // What changes by rounding alone is constant.
  const isConstant = to - from <= 1e-9 * Math.max(Math.abs(from), Math.abs(to));
  const spare = isConstant ? 0.1 * Math.abs(to) || 1 : 0.06 * (to - from);
  return [from - spare, to + spare];
};

const drawChart = (chart, width) => {
  const isSlim = width < 420;
  const height = isSlim ? 168 : 170, [left, right, top, bottom] = [58, 14, isSlim ? 44 : 26, 24];
  const values = chart.series.map(({ of, isAngle }) => (isAngle ? unrolled : (list) => list)(samples.map(of)));
  // A row that is zero throughout is left out, unless all are.
  const isZero = (list) => list.every((x) => !(Math.abs(x) > 1e-12));
  const isShown = values.map((list) => !isZero(list) || values.every(isZero));
  chart.isFlat = !!chart.isMotion && values.every((list) => isZero(list) && list.some(isFinite));
  const bands = samples.map(({ holding }) => (chart.hasBand && holding) || null);
  const range = rangeOf([...values.filter((_, k) => isShown[k]), ...bands.filter(Boolean)].flat()), [from, to] = domain();
  const X = (x) => left + ((width - left - right) * (x - from)) / (to - from);
  const Y = (y) => height - bottom - ((height - top - bottom) * (y - range[0])) / (range[1] - range[0]);
  Object.assign(chart, { values, isShown, X, Y, left, right, top, bottom, width, height });
  put(chart.svg, { viewBox: `0 0 ${width} ${height}`, "aria-label": `${chart.title.textContent} over ${inputs[state.axis].name}` });
  put(chart.inside, { x: left, y: top, width: width - left - right, height: height - top - bottom });
  trace(chart.out, gapsIn(chart));
  drawTicks(chart, range);
  const spot = (y, n) => isFinite(y) && [X(samples[n].x), clamp(Y(y), -2000, 2000)];
  chart.lines.forEach((line, k) => trace(line, isShown[k] ? lineThrough(values[k].map(spot)) : ""));
  trace(chart.band, areaBetween(bands.map((ends, n) => ends && ends.map((y) => spot(y, n)))));
  const [x, y, anchor] = isSlim ? [left, 34, "start"] : [width - right, 15, "end"];
  put(chart.title, { x: left, y: 15 });
  put(chart.legend, { x, y, "text-anchor": anchor });
};

/// Lines between pairs of spots, there and back, interrupted where there is none.
const areaBetween = (pairs) => {
  let d = "", way = [];
  for (const pair of [...pairs, null]) {
    if (pair) way = [pair[0], ...way, pair[1]];
    else [d, way] = [d + pathOf(way, true), []];
  }
  return d;
};

const heldWords = ({ holding }) => (holding ? holding.map((x) => digits(x)).join(" … ") : "–");

/// Bands where the machine cannot be assembled.
const gapsIn = ({ X, top, bottom, height }) => {
  let d = "", start = null;
  samples.forEach(({ x, pose }, k) => {
    if (pose.error && start === null) start = samples[Math.max(k - 1, 0)].x;
    if (start === null || (pose.error && k < STEPS)) return;
    d += `M${short(X(start))} ${top}H${short(X(x))}V${height - bottom}H${short(X(start))}Z`;
    start = null;
  });
  return d;
};

const drawTicks = ({ X, Y, ticks, grid, zero, left, right, bottom, width, height }, range) => {
  let count = 0;
  // Texts are kept, and changed where they differ: new ones are what a frame costs most.
  const text = (words, x, y, anchor) => {
    const node = ticks.children[count++] ?? made("text", {}, ticks);
    if (node.textContent !== words) node.textContent = words;
    const place = [short(x), short(y), anchor].join();
    if (node.place !== place) put(node, { x: short(x), y: short(y), "text-anchor": anchor });
    node.place = place;
  };
  const [levels, step] = roundNumbers(range, 4);
  const across = (y) => `M${left} ${short(Y(y))}H${width - right}`;
  trace(grid, levels.map(across).join(""));
  trace(zero, range[0] < 0 && range[1] > 0 ? across(0) : "");
  for (const y of levels) text(tickWords(y, step), left - 7, Y(y) + 4, "end");
  const { isAngle, unit } = inputs[state.axis], [name, times] = shownIn(unit, 0), [from, to] = domain();
  const isTurn = isAngle && Math.abs(to - from - TURN) < 1e-9, parts = width < 420 ? 4 : 8;
  const [places, apart] = isTurn
    ? [Array.from({ length: parts + 1 }, (_, k) => (360 / parts) * k + from * times), 45]
    : roundNumbers([from * times, to * times], parts - 1);
  places.forEach((x, k) => {
    const words = isAngle ? `${tickWords(x, apart)}°` : tickWords(x, apart) + (k === places.length - 1 ? ` ${name}` : "");
    const at = X(x / times), isLast = at > width - right - 12;
    text(words, isLast ? width : at, height - 6, isLast ? "end" : "middle");
  });
  while (ticks.children.length > count) ticks.lastChild.remove();
};

/// Where the input of the curves stands, inside their domain.
const cursorAt = () => {
  const { turns, from } = inputs[state.axis], x = state.q[state.axis];
  return turns ? from + wrapped(x - from) : x;
};

const drawCursors = (now) => {
  const x = cursorAt(), [from, to] = domain();
  const near = clamp(Math.round((STEPS * (x - from)) / (to - from)), 0, STEPS);
  for (const chart of charts) {
    const { X, Y, series, isShown, values, dots, labels, rest, cursor, top, bottom, height, unit } = chart;
    trace(cursor, `M${short(X(x))} ${top}V${height - bottom}`);
    let isFirst = true;
    series.forEach(({ name, of, isAngle }, k) => {
      const y = of(now), isKnown = isFinite(y) && isShown[k];
      // The angle of the curve's own turn.
      const level = isAngle && isFinite(values[k][near]) ? y + 360 * Math.round((values[k][near] - y) / 360) : y;
      const isInside = isKnown && Y(level) > top - 5 && Y(level) < height - bottom + 5;
      show(dots[k], isInside, [X(x), Y(level)]);
      labels[k].textContent = isShown[k] ? (isFirst ? "" : "   ") + `${name} ${withUnit(y, unit)}`.trim() : "";
      isFirst &&= !isShown[k];
    });
    rest.textContent = chart.hasBand && now.holding ? `   at rest ${heldWords(now)}` : "";
  }
};

// ---- values -----------------------------------------------------------------------------------------

/// The cells of the table: of each row three orders, of a force one value.
const cells = [];
const buildTable = () => {
  const table = $("#values");
  const row = (label, kind, contents) => {
    const line = table.insertRow();
    entitle(element("th", { scope: kind }, line), label);
    return contents.map((textContent) => element(kind === "row" ? "td" : "th", { textContent }, line));
  };
  if (rows.length) row("", "col", ["position", "velocity", "acceleration"]);
  for (const each of rows) {
    const line = row(each.label, "row", ["", "", ""]);
    line.forEach((cell, order) => cells.push([cell, ({ motion }) =>
      motion ? words(valueOf(each, order, motion), each.unit, order) : "–"]));
  }
  if (efforts.length) row("", "col", ["force"]);
  efforts.forEach(({ label, unit }, k) => {
    const [cell] = row(label, "row", [""]);
    cells.push([cell, ({ forces }) => (forces ? words(forces[k], unit) : "–")]);
  });
  if (MACHINE.holding) {
    const [cell] = row(`${driven} at rest`, "row", [""]);
    cell.className = "range";
    cells.push([cell, heldWords]);
  }
};

let told = 0;
/// Tells the values, not more often than can be read.
const tellValues = (now) => {
  const time = performance.now();
  if (time - told < 100) {
    clearTimeout(tellValues.later);
    tellValues.later = setTimeout(() => tellValues(now), 120);
    return;
  }
  told = time;
  for (const [cell, of] of cells) cell.textContent = of(now);
};

/// The samples as a table of comma-separated values in SI units.
const csv = () => {
  const quoted = (text) => (/[",]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const { name, unit } = inputs[state.axis], per = ["", "/s", "/s²"];
  const held = MACHINE.holding ? ["backwards", "forwards"] : [];
  const orders = rows.flatMap((row) => [0, 1, 2].map((order) => [row, order]));
  const head = [
    `${name} [${unit}]`,
    ...orders.map(([{ label, unit }, order]) => `${["", "velocity of ", "acceleration of "][order]}${label} [${unit}${per[order]}]`),
    ...efforts.map(({ label, unit }) => `${label} [${unit}]`),
    ...held.map((way) => `${driven} at rest ${way}`),
    "reason",
  ];
  const lines = samples.map(({ x, motion, forces, holding, refused }) => [
    x,
    ...orders.map(([row, order]) => (motion ? valueOf(row, order, motion) : "")),
    ...efforts.map((_, k) => (forces ? forces[k] : "")),
    ...held.map((_, k) => (holding ? holding[k] : "")),
    refused ? why(refused) : "",
  ]);
  return `${[head, ...lines].map((line) => line.map((cell) => quoted(String(cell))).join(",")).join("\n")}\n`;
};
