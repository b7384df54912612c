// Curves over one input, the values at the cursor, and both as text.

/// Steps of the input that curves are drawn over, and of each input for the picture's size.
const STEPS = 240, SURVEYED = 48;
let samples = [];

const withInput = (k, x) => withOne(state.q, k, x);
const domain = () => [inputs[state.axis].from, inputs[state.axis].to];
const stepped = (count, [from, to], at) => Array.from({ length: count + 1 }, (_, k) => at(from + ((to - from) * k) / count));

const sample = () => {
  // Curves are those at a constant rate, also while the machine runs by itself.
  const held = running;
  running = null;
  samples = stepped(STEPS, domain(), (x) => ({ x, ...answersAt(new Pose(withInput(state.axis, x))) }));
  running = held;
  setScales();
  if (hasForces) sampleForces();
  if (MACHINE.marks) sampleCouples();
};

const grouped = (list, keyOf) => [...new Set(list.map(keyOf))].map((key) => list.filter((entry) => keyOf(entry) === key));
/// The largest number that a chart of these rows shows.
const largestOf = (list, valueAt) => {
  const range = rangeOf(samples.flatMap((answers) => list.map((entry) => valueAt(entry, answers))), 0);
  return max(...range.map(abs));
};

/// The extent of the machine, by which its lengths are shown.
let extent = 1;
/// The units in which rows are shown: rows of one output and one unit alike. What is a thousand millionth of the
/// largest of all rows of a unit is rounding.
const setScales = () => {
  const lengths = shownIn("m", 0, extent / 2);
  const set = (list, valueAt, order, outputOf) => grouped(list, ({ unit }) => unit).forEach((alike) => {
    const noise = largestOf(alike, valueAt);
    grouped(alike, outputOf).forEach((own) => {
      const { unit } = own[0], isLength = unit === "m" && order === 0;
      const shown = isLength ? lengths : shownIn(unit, order, largestOf(own, valueAt));
      own.forEach((row) => row.scales[order] = { shown, noise });
    });
  });
  for (const order of [0, 1, 2]) set(rows, (row, { motion }) => (motion ? valueOf(row, order, motion) : NaN), order, ({ output }) => output);
  set(efforts, (row, { forces }) => (forces ? forces[efforts.indexOf(row)] : NaN), 0, ({ effort }) => effort);
  const held = largestOf([0, 1], (end, { holding }) => (holding ? holding[end] : NaN)), row = efforts.find(({ effort }) => effort === driven);
  const most = max(held, row ? largestOf([row], (row, { forces }) => (forces ? forces[efforts.indexOf(row)] : NaN)) : 0);
  holds.scales[0] = { shown: shownIn(holds.unit, 0, most), noise: most };
  if (row && MACHINE.holding) row.scales[0] = holds.scales[0];
};

/// Poses over every input's range and along the path.
const surveyed = () => [
  new Pose(state.q),
  ...inputs.flatMap(({ from, to }, k) => stepped(SURVEYED, [from, to], (x) => new Pose(withInput(k, x)))),
  ...PAGE.path.map((q) => new Pose(q)),
];

// ---- charts -----------------------------------------------------------------------------------------

const ORDERS = ["Position", "Velocity", "Acceleration"];

/// The effort of the only input, which friction at rest leaves between two ends.
const driven = `${inputs[0].name}.drive`;
const holds = { unit: inputs[0].isAngle ? "N·m" : "N", scales: [] };

/// A number of a row in the unit of its scale.
const shownOf = (x, { shown: [, times], noise }) => (abs(x) < 1e-9 * noise ? 0 : x * times);

/// The charts of an output or a force: one for each order and unit. Charts of drives stand below.
const chartsOf = (name) => {
  const own = rows.filter(({ output }) => output === name);
  const motions = [0, 1, 2].flatMap((order) =>
    grouped(own, ({ unit }) => unit).map((list, nth) => ({
      pairs: order || nth ? [] : PAGE.wanted.filter(({ output }) => output === name).flatMap(({ pairs }) => pairs),
      title: `${ORDERS[order]} of ${list[0].title}`,
      scale: () => list[0].scales[order],
      isMotion: true,
      series: list.map((row) => ({
        name: row.row,
        isAngle: row.isAngle && order === 0,
        of: ({ motion }) => (motion ? shownOf(valueOf(row, order, motion), row.scales[order]) : NaN),
      })),
    })));
  const drives = efforts.filter(({ effort, row }) => row === "" && effort.endsWith(".drive") && effort !== name);
  const asked = [...efforts.filter(({ effort }) => effort === name), ...drives];
  const forces = grouped(asked, ({ effort, unit }) => `${effort} ${unit}`).map((list) => ({
    title: list[0].effort,
    scale: () => list[0].scales[0],
    hasBand: MACHINE.holding && list[0].effort === driven,
    series: list.map((row) => ({
      // The title says of what.
      name: row.row,
      of: ({ forces }) => (forces ? shownOf(forces[efforts.indexOf(row)], row.scales[0]) : NaN),
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
    const clipped = (own) => node("path", { class: own, "clip-path": `url(#inside${nth})` });
    const ticks = node("g", { class: "ticks" }), band = clipped("band");
    const olds = chart.series.map(() => clipped("old"));
    const lines = chart.series.map((_, k) => clipped(`curve s${k}`));
    const wanted = clipped("wanted");
    const title = node("text", { class: "title" }), legend = node("text", { class: "legend" });
    say(title, chart.title);
    const labels = chart.series.map((_, k) => made("tspan", { class: `s${k}` }, legend)), rest = made("tspan", {}, legend);
    const cursor = node("path", { class: "cursor" });
    const dots = chart.series.map((_, k) => node("circle", { class: `dot s${k}`, r: 4 }));
    return { ...chart, svg, out, grid, zero, inside, ticks, band, olds, lines, wanted, title, legend, labels, rest, cursor, dots };
  });
};

const showCurvesOf = (name) => {
  state.shown = name;
  $("#shown").value = name;
  buildCharts();
};

/// Round numbers in a range, and how far apart they are.
const roundNumbers = ([from, to], count) => {
  const raw = (to - from) / count || 1, power = 10 ** floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((factor) => factor * power).find((step) => step >= raw * (1 - 1e-9));
  const found = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * step; k++) found.push(k * step);
  return [found, step];
};
/// The words of round numbers that are so far apart.
const tickWords = (x, step) => {
  const tens = floor(Math.log10(step)), rounded = round(x / step) * step;
  if (tens < -5 || abs(x) >= 1e6) return digits(abs(x) < 1e-9 * step ? 0 : x, 3);
  const decimals = [0, 1, 2, 3, 4, 5, 6].find((d) => abs(step * 10 ** d - round(step * 10 ** d)) < 1e-6) ?? 6;
  return rounded.toFixed(decimals).replace("-", "−").replace(/^−(0\.?0*)$/, "$1");
};
/// Angles that do not jump by a turn.
const unrolled = (values) => {
  let last = null;
  return values.map((x) => {
    if (!isFinite(x)) return x;
    last = last === null ? x : x + 360 * round((last - x) / 360);
    return last;
  });
};

/// The range of a chart. Beside a pose that cannot be assembled, or is singular, the outermost values count
/// for nothing.
const rangeOf = (values, margin = 0.06) => {
  const known = values.filter(isFinite).sort((a, b) => a - b);
  if (!known.length) return [0, 1];
  const at = (share) => known[round(share * (known.length - 1))];
  const [inner, outer] = [at(0.98) - at(0.02), at(1) - at(0)];
  const isWild = outer > 3 * inner && inner > 0;
  const [from, to] = isWild ? [at(0.02) - 0.5 * inner, at(0.98) + 0.5 * inner] : [at(0), at(1)];
  // What changes by rounding alone is constant.
  const isConstant = to - from <= 1e-9 * max(abs(from), abs(to));
  const spare = isConstant && margin ? 0.1 * abs(to) || 1 : margin * (to - from);
  return [from - spare, to + spare];
};

/// The width of a text of the axes.
const pen = document.createElement("canvas").getContext("2d");
const widthOf = (text) => {
  pen.font = `11.5px ${getComputedStyle(document.body).fontFamily}`;
  return pen.measureText(text).width;
};

/// The curves, the range and the ticks of a chart, and how much room its ticks take at the left.
const prepared = (chart) => {
  const values = chart.series.map(({ of, isAngle }) => (isAngle ? unrolled : (list) => list)(samples.map(of)));
  // A row that is zero throughout is left out, unless all are.
  const isZero = (list) => list.every((x) => !(abs(x) > 0));
  const isShown = values.map((list) => !isZero(list) || values.every(isZero));
  const bands = samples.map(({ holding }) => (chart.hasBand && holding?.map((x) => shownOf(x, holds.scales[0]))) || null);
  const before = isBeside() ? chart.series.map(({ of, isAngle }) => (isAngle ? unrolled : (list) => list)(kept.samples.map(of))) : [];
  const aims = chart.pairs?.length ? aimsOf(chart, values[0]) : [];
  const range = rangeOf([...values, ...before].filter((_, k) => isShown[k % values.length]).concat(bands.filter(Boolean), aims.map(([, y]) => y)).flat());
  const [levels, step] = roundNumbers(range, 4), marks = levels.map((y) => [y, tickWords(y, step)]);
  const isFlat = !!chart.isMotion && values.every((list) => isZero(list) && list.some(isFinite)), [unit] = chart.scale().shown;
  const room = max(...[...marks.map(([, text]) => text), unit].map(widthOf)) + 14;
  return assign(chart, { values, before, aims, isShown, bands, range, marks, isFlat, unit, room });
};

const drawChart = (chart, width, left) => {
  const isSlim = width < 420, { values, before, isShown, bands, range } = chart;
  const height = isSlim ? 168 : 170, [right, top, bottom] = [14, isSlim ? 44 : 26, 24];
  const [from, to] = domain();
  const X = (x) => left + ((width - left - right) * (x - from)) / (to - from);
  const Y = (y) => height - bottom - ((height - top - bottom) * (y - range[0])) / (range[1] - range[0]);
  assign(chart, { X, Y, left, right, top, bottom, width, height });
  put(chart.svg, { viewBox: `0 0 ${width} ${height}`, "aria-label": `${chart.title.textContent} over ${inputs[state.axis].name}` });
  put(chart.inside, { x: left, y: top, width: width - left - right, height: height - top - bottom });
  trace(chart.out, gapsIn(chart));
  drawTicks(chart, range);
  const spot = (y, n) => isFinite(y) && [X(samples[n].x), clamp(Y(y), -2000, 2000)];
  chart.lines.forEach((line, k) => trace(line, isShown[k] ? lineThrough(values[k].map(spot)) : ""));
  chart.olds.forEach((line, k) => trace(line, before[k] && isShown[k] ? lineThrough(before[k].map(spot)) : ""));
  trace(chart.wanted, crossesAt(chart.aims.map(([x, y]) => [X(x), Y(y)])));
  if (chart.hasBand) trace(chart.band, areaBetween(bands.map((ends, n) => ends && ends.map((y) => spot(y, n)))));
  const [x, y, anchor] = isSlim ? [left, 34, "start"] : [width - right, 15, "end"];
  put(chart.title, { x: left, y: 15 });
  put(chart.legend, { x, y, "text-anchor": anchor });
};

/// Bands where the machine cannot be assembled.
const gapsIn = ({ X, top, bottom, height }) => {
  let d = "", start = null;
  samples.forEach(({ x, pose }, k) => {
    if (pose.error && start === null) start = samples[max(k - 1, 0)].x;
    if (start === null || (pose.error && k < STEPS)) return;
    d += `M${short(X(start))} ${top}H${short(X(x))}V${height - bottom}H${short(X(start))}Z`;
    start = null;
  });
  return d;
};

const drawTicks = ({ X, Y, ticks, grid, zero, left, right, bottom, width, height, marks, unit }, range) => {
  let count = 0;
  // Texts are kept, and changed where they differ: new ones are what a frame costs most.
  const text = (words, x, y, anchor) => {
    const node = ticks.children[count++] ?? made("text", {}, ticks);
    if (node.textContent !== words) node.textContent = words;
    const place = [short(x), short(y), anchor].join();
    if (node.place !== place) put(node, { x: short(x), y: short(y), "text-anchor": anchor });
    node.place = place;
  };
  const across = (y) => `M${left} ${short(Y(y))}H${width - right}`;
  trace(grid, marks.map(([y]) => across(y)).join(""));
  trace(zero, range[0] < 0 && range[1] > 0 ? across(0) : "");
  for (const [y, words] of marks) text(words, left - 7, Y(y) + 4, "end");
  if (unit) text(unit, left - 7, 15, "end");
  const input = inputs[state.axis], [from, to] = domain(), [name, times] = shownIn(input.unit, 0, max(abs(from), abs(to)));
  const isTurn = input.isAngle && name === "°" && abs(to - from - TURN) < 1e-9, parts = width < 420 ? 4 : 8;
  const [places, apart] = isTurn
    ? [Array.from({ length: parts + 1 }, (_, k) => (360 / parts) * k + from * times), 45]
    : roundNumbers([from * times, to * times], parts - 1);
  places.forEach((x, k) => {
    const words = name === "°" ? `${tickWords(x, apart)}°` : tickWords(x, apart) + (k === places.length - 1 ? ` ${name}` : "");
    const at = X(x / times), isLast = at > width - right - 12;
    text(words, isLast ? width : at, height - 6, isLast ? "end" : "middle");
  });
  while (ticks.children.length > count) ticks.lastChild.remove();
};

/// Where the input of the curves stands, inside their domain.
const cursorAt = () => {
  const { turns, from, to } = inputs[state.axis], x = state.q[state.axis];
  return turns ? turnedInto(x, from, to) : x;
};

const drawCursors = (now) => {
  const x = cursorAt(), [from, to] = domain();
  const near = clamp(round((STEPS * (x - from)) / (to - from)), 0, STEPS);
  for (const chart of charts) {
    const { X, Y, series, isShown, values, dots, labels, rest, cursor, top, bottom, height, unit } = chart;
    trace(cursor, `M${short(X(x))} ${top}V${height - bottom}`);
    let isFirst = true;
    series.forEach(({ name, of, isAngle }, k) => {
      const y = of(now), isKnown = isFinite(y) && isShown[k];
      // The angle of the curve's own turn.
      const level = isAngle && isFinite(values[k][near]) ? y + 360 * round((values[k][near] - y) / 360) : y;
      const isInside = isKnown && Y(level) > top - 5 && Y(level) < height - bottom + 5;
      show(dots[k], isInside, [X(x), Y(level)]);
      say(labels[k], isShown[k] ? (isFirst ? "" : "   ") + `${name} ${withUnit(digits(y), unit)}`.trim() : "");
      isFirst &&= !isShown[k];
    });
    say(rest, chart.hasBand && now.holding ? `   at rest ${heldWords(now)}` : "");
    // On a phone a long line is written smaller.
    const share = (chart.width - chart.left) / roomOf(chart.legend), size = share < 1 ? `${short(12.5 * share)}px` : "";
    if (chart.legend.style.fontSize !== size) chart.legend.style.fontSize = size;
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
  if (rows.length) row("output", "col", ["position", "velocity", "acceleration"]);
  for (const each of rows) {
    const line = row(each.label, "row", ["", "", ""]);
    line.forEach((cell, order) => cells.push([cell, ({ motion }, then) => {
      const { shown, noise } = each.scales[order], x = motion && valueOf(each, order, motion);
      const by = motion && then?.motion ? changed(x, valueOf(each, order, then.motion), shown, noise) : "";
      return motion ? inScale(x, shown, noise) + by : "–";
    }]));
  }
  const kinds = { N: "force", "N·m": "torque", W: "power" };
  let kind = null;
  const headed = (unit) => {
    const own = kinds[unit] ?? "value";
    if (own !== kind) row("output", "col", [own]);
    kind = own;
  };
  for (const each of grouped(efforts, ({ unit }) => kinds[unit]).flat()) {
    headed(each.unit);
    const [cell] = row(each.label, "row", [""]), k = efforts.indexOf(each);
    cells.push([cell, ({ forces }, then) => {
      const { shown, noise } = each.scales[0], by = forces && then?.forces ? changed(forces[k], then.forces[k], shown, noise) : "";
      return forces ? inScale(forces[k], shown, noise) + by : "–";
    }]);
  }
  if (MACHINE.holding) {
    headed(holds.unit);
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
  const then = kept && !running && answersOf(kept, state.q);
  for (const [cell, of] of cells) say(cell, of(now, then));
  if (params.length) tellTolerances();
};

/// The samples as a table of comma-separated values in SI units, under the state that they belong to.
const csv = () => {
  const quoted = (text) => (/[",]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const { name, unit } = inputs[state.axis], per = ["", "/s", "/s²"];
  const held = MACHINE.holding ? ["backwards", "forwards"] : [];
  const orders = rows.flatMap((row) => [0, 1, 2].map((order) => [row, order]));
  const head = [
    `${name} [${unit}]`,
    ...orders.map(([{ label, unit }, order]) => `${["", "velocity of ", "acceleration of "][order]}${label} [${unit}${per[order]}]`),
    ...efforts.map(({ label, unit }) => `${label} [${unit}]`),
    ...held.map((way) => `${driven} at rest ${way} [${holds.unit}]`),
    "reason",
  ];
  const set = [
    ...inputs.flatMap(({ name, unit }, k) => (k === state.axis ? [[`rate of ${name} [${unit}/s]`, state.rate]] : [[`${name} [${unit}]`, state.q[k]]])),
    ...params.map(({ name, words, unit, size }, k) =>
      (words ? [name, words[state.p[k] > 0 ? 0 : 1]] : [`${name} [${unit}]`, +(state.p[k] / size).toPrecision(15)])),
    ...loads.map(({ name, unit }, k) => [`${name} [${unit}]`, state.l[k]]),
  ];
  const lines = samples.map(({ x, motion, forces, holding, refused }) => [
    x,
    ...orders.map(([row, order]) => (motion ? valueOf(row, order, motion) : "")),
    ...efforts.map((_, k) => (forces ? forces[k] : "")),
    ...held.map((_, k) => (holding ? holding[k] : "")),
    refused ? why(refused) : "",
  ]);
  const table = [head, ...lines].map((line) => line.map((cell) => quoted(String(cell))).join(","));
  const above = set.map(([name, value]) => `# ${name} = ${value}`);
  return [`# ${PLAN.name}`, ...above, ...table, ""].join("\n");
};
