// What a reader asks: the motion of a joint that is clicked, curves that are kept, pictures
// to take along.

/// The joint or link that was clicked.
let picked = null;
/// The curves of before: the state that they belong to, and their samples.
let kept = null;

/// The answers of another state.
const answersOf = ({ p, l, rate }, q) => {
  const own = { p: state.p, l: state.l, rate: state.rate };
  assign(state, { p, l, rate });
  const answers = answersAt(new Pose(q));
  assign(state, own);
  return answers;
};

const keep = () => {
  kept = kept ? null : { p: [...state.p], l: [...state.l], rate: state.rate, axis: state.axis, q: [...state.q], samples };
  $("#keep").setAttribute("aria-pressed", !!kept);
  say($("#kept"), kept ? "Dashed: curves and paths that are kept. In the table: the change since then." : "");
  draw(CURVES);
};
/// Keeps the curves of the parameters of before, over the same input.
const keepBefore = () => {
  const own = state.p;
  state.p = PAGE.before;
  sample();
  keep();
  state.p = own;
  fit();
};
/// The places on paths that are kept.
const keptPlaces = () =>
  (kept?.samples ?? []).flatMap(({ pose }) => (pose.error ? [] : tracedPoints.map((point) => pose.point(point))));
/// True where kept curves are over the same input.
const isBeside = () => kept && kept.axis === state.axis && kept.samples.length === samples.length;

/// The change of a number since the curves were kept.
const changed = (now, then, [, times], noise) => {
  const by = now - then;
  if (!isFinite(by)) return "";
  return ` (${by > 0 ? "+" : ""}${digits(abs(by) < 1e-9 * noise ? 0 : by * times, 3)})`;
};

// ---- a clicked joint --------------------------------------------------------------------------------

/// The rows of an output of this name.
const rowsOf = (name) => rows.filter(({ output }) => output === name);
const nameOfPicked = () => (picked === null ? null : picked.point === undefined ? PLAN.links[picked.link] : PLAN.points[picked.point]);

const pick = (to) => {
  const isSame = picked && picked.point === to?.point && picked.link === to?.link;
  picked = isSame ? null : to;
  const name = nameOfPicked();
  if (name && offered.includes(name) && name !== state.shown) showCurvesOf(name);
  draw(CURVES);
};

/// The link whose bar or plate is drawn at a place of the figure.
const linkAt = (node) => {
  const k = nodes.body.findIndex((body) => Object.values(body).includes(node));
  return k < 0 ? null : { link: allMembers[k].link };
};

/// A picked point's velocity and acceleration, to scales of their own, with their numbers.
const drawPicked = (pose, { motion }) => {
  const name = nameOfPicked(), own = name === null || picked.point === undefined ? [] : rowsOf(name), at = own.length === 2 && pose.point(picked.point);
  nodes.rates.forEach(({ path, text }, nth) => {
    const order = nth + 1, [vx, vy] = motion && at ? own.map((row) => valueOf(row, order, motion)) : [0, 0];
    const size = Math.hypot(vx, vy), most = at ? largestOf([0], (_, { motion: other }) => (other ? Math.hypot(...own.map((row) => valueOf(row, order, other))) : NaN)) : 0;
    const length = (size / most) * (view.width < 500 ? 36 : 70), isShown = at && length > 1;
    show(path, isShown);
    show(text, false);
    if (!isShown) return;
    const from = onPage(at), to = [from[0] + (vx / size) * length, from[1] - (vy / size) * length];
    trace(path, arrowTo(from, to));
    say(text, inScale(size, shownIn("m", order, size)));
    const wide = roomOf(text);
    write(text, wide, [-6, 16, -22, 32].flatMap((dy) => [[to[0] + 6, to[1] + dy], [to[0] - 6 - wide, to[1] + dy]]));
  });
};

/// What is known of the picked joint or link, in words.
const tellPicked = (pose, { motion, forces }) => {
  const name = nameOfPicked();
  $("#picked").hidden = name === null;
  if (name === null) return;
  const own = rowsOf(name), point = picked.point === undefined ? null : pose.point(picked.point);
  const said = [0, 1, 2].flatMap((order) => own.map((row) => {
    const { shown, noise } = row.scales[order];
    return [`${["", "velocity ", "acceleration "][order]}${row.row}`, motion && inScale(valueOf(row, order, motion), shown, noise)];
  }));
  if (own.length === 2 && motion && point) {
    for (const order of [1, 2]) said.push([`${["velocity", "acceleration"][order - 1]}, size`, words(Math.hypot(...own.map((row) => valueOf(row, order, motion))), "m", order)]);
  }
  if (!own.length && point) ["x", "y"].forEach((axis, k) => said.push([axis, inScale(point[k], shownIn("m", 0, extent / 2))]));
  efforts.forEach((row, k) => {
    const isOwn = picked.point === undefined ? row.effort.split(".")[0] === name : row.point === picked.point;
    if (isOwn) said.push([row.label, forces && inScale(forces[k], row.scales[0].shown, row.scales[0].noise)]);
  });
  const head = $("#picked h2"), list = $("#picked dl");
  say(head, name);
  const hint = said.length && own.length ? "" : `For more, name it in the declaration: output ${name};`;
  say($("#picked p"), hint);
  while (list.children.length > 2 * said.length) list.lastChild.remove();
  said.forEach(([what, value], k) => {
    const [term, cell] = [2 * k, 2 * k + 1].map((n) => list.children[n] ?? element(n % 2 ? "dd" : "dt", {}, list));
    say(term, what);
    say(cell, value || "–");
  });
};

// ---- pictures to take along -------------------------------------------------------------------------

const STYLES = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "stroke-linejoin", "opacity", "visibility", "font-family", "font-size", "font-weight", "text-anchor", "paint-order", "white-space"];

/// A drawing with its styles written into it, on paper.
const standalone = (svg, y = 0) => {
  const copy = svg.cloneNode(true), own = [svg, ...svg.querySelectorAll("*")], copies = [copy, ...copy.querySelectorAll("*")];
  own.forEach((node, k) => {
    const style = getComputedStyle(node);
    copies[k].setAttribute("style", STYLES.map((name) => `${name}:${style.getPropertyValue(name)}`).join(";"));
  });
  copy.removeAttribute("tabindex");
  const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
  put(copy, { x: 0, y, width, height });
  return [copy, width, height];
};
const pictureOf = (drawings) => {
  let [y, wide] = [0, 0];
  const all = made("svg", { xmlns: "http://www.w3.org/2000/svg" }), paper = made("rect", { fill: getComputedStyle(document.body).backgroundColor }, all);
  for (const svg of drawings) {
    const [copy, width, height] = standalone(svg, y);
    all.append(copy);
    [y, wide] = [y + height + 8, max(wide, width)];
  }
  for (const node of [all, paper]) put(node, { width: wide, height: y });
  put(all, { viewBox: `0 0 ${wide} ${y}` });
  return [new XMLSerializer().serializeToString(all), wide, y];
};
const save = (blob, ending) => {
  const href = URL.createObjectURL(blob);
  element("a", { href, download: `${PLAN.name}.${ending}` }).click();
  setTimeout(() => URL.revokeObjectURL(href), 1000);
};
const saveDrawing = (drawings, ending) => {
  const [text, width, height] = pictureOf(drawings);
  if (ending === "svg") return save(new Blob([text], { type: "image/svg+xml" }), "svg");
  const image = new Image(), canvas = element("canvas", { width: 2 * width, height: 2 * height });
  image.onload = () => {
    canvas.getContext("2d").drawImage(image, 0, 0, 2 * width, 2 * height);
    canvas.toBlob((blob) => save(blob, "png"), "image/png");
  };
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
};
