// The machine's picture: bodies, joints, supports and names, by the symbols of kinematic diagrams.

const $ = (selector) => document.querySelector(selector);
const figure = $("#figure");
const on = (node, kind, does) => node.addEventListener(kind, does);
const onClick = (id, does) => on($(id), "click", does);
const element = (tag, properties, parent) => {
  const node = assign(document.createElement(tag), properties);
  parent?.append(node);
  return node;
};
/// Writes a name that may be divided behind a point or an underscore.
const entitle = (node, text) => {
  text.split(/(?<=[._])/).forEach((part) => node.append(part, element("wbr")));
};
const say = (node, words) => node.textContent = words;
const put = (node, attributes) => {
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
};
const made = (tag, attributes, parent) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  put(node, attributes);
  parent?.append(node);
  return node;
};
const trace = (node, d) => {
  // A frame costs most by what it changes.
  if (node.traced !== (node.traced = d ?? "")) node.setAttribute("d", node.traced);
};
const shiftTo = (spot) => `translate(${spot.map(short)})`;
/// Shows a node, at a spot if there is one, or hides it.
const show = (node, isShown, spot) => {
  node.setAttribute("visibility", isShown ? "inherit" : "hidden");
  if (isShown && spot) node.setAttribute("transform", shiftTo(spot));
};

/// From metres to pixels, y up and y down.
const view = { scale: 100, x: 0, y: 0, width: 700, height: 480, letter: 1 };
const onPage = ([x, y]) => [view.x + view.scale * x, view.y - view.scale * y];
const degreesOf = ({ cos, sin }) => (-atan2(sin, cos) * 180) / PI;
const seatOf = (frame) => `${shiftTo(onPage(frame.at))} rotate(${short(degreesOf(frame))})`;
const short = (x) => +x.toFixed(1);
const pathOf = (spots, isClosed = false) =>
  spots.length < 2 ? "" : `M${spots.map((spot) => spot.map(short).join(" ")).join("L")}${isClosed ? "Z" : ""}`;
/// The line through spots, interrupted where there is none.
const lineThrough = (spots) =>
  spots.map((spot, k) => (spot ? `${k && spots[k - 1] ? "L" : "M"}${spot.map(short)}` : "")).join("");
const crossesAt = (spots) => spots.map(([x, y]) => `M${short(x - 4)} ${short(y)}h8m-4-4v8`).join("");
const apart = ([x, y], [u, v]) => Math.hypot(u - x, v - y);
const minus = ([x, y], [u, v]) => [x - u, y - v];
/// The place so far behind a, on the way to b and so far to the side of it.
const along = (a, b, far, side = 0) => {
  const length = apart(a, b) || 1, [x, y] = minus(b, a).map((part) => part / length);
  return [a[0] + x * far - y * side, a[1] + y * far + x * side];
};

/// A pointer's length, in pixels.
const POINTER = 44;

const colours = PLAN.links.map((_, link) => `var(--l${link % 6})`);
const allMembers = statements.flatMap(({ members }) => members);
const hasSlides = PLAN.guides.length > 0 || allMembers.some(({ shape }) => !["bar", "body"].includes(shape));
/// The points at which something stands, which are drawn.
const used = new Set([
  ...joints.flat(),
  ...PLAN.springs.flatMap(({ ends }) => ends),
  ...statements.flatMap(({ point, on }) => (point !== undefined && on === null ? [point] : [])),
]);

// ---- what all poses tell ----------------------------------------------------------------------------

const widened = ([least, most], x) => (isFinite(x) ? [min(least, x), max(most, x)] : [least, most]);
const NOTHING = [Infinity, -Infinity];

/// The box around all points, also those that are wanted or kept, blocks and bars that blocks slide on, in metres.
const boxOf = (poses) => {
  let [xs, ys] = [NOTHING, NOTHING];
  const see = ([x, y]) => [xs, ys] = [widened(xs, x), widened(ys, y)];
  for (const pose of poses) {
    if (MACHINE.marks) markedPlaces(pose).forEach(see);
    for (const point of used) {
      const at = pose.point(point);
      if (at) see(at);
    }
    for (const { link, shape } of allMembers) {
      const frame = pose.link(link);
      if (!frame || ["bar", "body", "cylinder"].includes(shape)) continue;
      see(frame.at);
      if (shape === "slotted_bar") see(placed(frame, [slidesOn(link)[1], 0]));
    }
  }
  [...PAGE.points, ...keptPlaces()].forEach(see);
  if (!(xs[0] <= xs[1])) [xs, ys] = [[-1, 1], [-1, 1]];
  return [xs, ys];
};

// ---- bodies -----------------------------------------------------------------------------------------

/// The corners of the convex hull, in turn.
const hull = (spots) => {
  const sorted = [...spots].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const chain = (list) => {
    const corners = [];
    for (const spot of list) {
      while (corners.length > 1) {
        const [a, b] = corners.slice(-2), [ux, uy] = minus(b, a), [vx, vy] = minus(spot, a);
        if (ux * vy - uy * vx > 1) break;
        corners.pop();
      }
      corners.push(spot);
    }
    return corners.slice(0, -1);
  };
  return [...chain(sorted), ...chain(sorted.reverse())];
};

/// The outline through spots: a line, or a plate.
const outline = (spots) => {
  const corners = hull(spots);
  return corners.length > 2 ? { plate: pathOf(corners, true) } : { bar: pathOf(corners.length > 1 ? corners : []) };
};

const spotsOf = (pose, link) => joints[link].map((point) => pose.point(point)).filter(Boolean).map(onPage);

/// The parts of a link in a pose: paths of lines, plates, tubes and rods, and the seat of a block.
const SHAPES = {
  "bar": (pose, { link }) => outline(spotsOf(pose, link)),
  "body": (pose, { link }) => {
    const spots = spotsOf(pose, link);
    if (spots.length > 1) return outline(spots);
    const frame = pose.link(link);
    return { bar: pathOf([onPage(frame.at), onPage(placed(frame, [POINTER / view.scale, 0]))]) };
  },
};

/// The nodes of every link, in a layer.
const bodiesIn = (layer) => {
  const seats = allMembers.map(({ link }) => made("g", { style: `--c:${colours[link]}` }));
  const isOnTop = ({ shape }) => ["cylinder", "block", "sleeve", "yoke"].includes(shape);
  layer.append(...seats.filter((_, k) => !isOnTop(allMembers[k])), ...seats.filter((_, k) => isOnTop(allMembers[k])));
  return seats.map((seat) => ({
    plate: made("path", { class: "plate" }, seat),
    bar: made("path", { class: "bar" }, seat),
    rod: made("path", { class: "rod" }, seat),
    tube: made("path", { class: "tube" }, seat),
    block: made("rect", { class: "block", x: -13, y: -8.5, width: 26, height: 17, rx: 2 }, seat),
  }));
};

/// The parts of every member of a pose.
const bodiesOf = (pose) => allMembers.map((member) => {
  if (!pose.link(member.link)) return {};
  const parts = SHAPES[member.shape](pose, member, statements.find(({ members }) => members.includes(member)));
  return { ...parts, bar: (parts.bar ?? "") + (PLAN.guides.length ? carriedBy(pose, member.link) : "") };
});

const drawBodies = (nodes, bodies) => bodies.forEach(({ plate, bar, rod, tube, block }, k) => {
  const node = nodes[k];
  trace(node.plate, plate);
  trace(node.bar, bar);
  trace(node.rod, rod);
  trace(node.tube, tube);
  show(node.block, block);
  if (block) put(node.block, { transform: seatOf(block) });
});

/// The lines that bodies are drawn with; of a block its long axis.
const linesOf = (bodies) => bodies.flatMap(({ plate = "", bar = "", rod = "", tube = "", block }) => {
  const lines = `${plate}${bar}${rod}${tube}`.split("M").slice(1).flatMap((way) => {
    const spots = way.split(/[LZ]/).filter(Boolean).map((spot) => spot.split(" ").map(Number));
    return spots.flatMap((spot, k) => (k || way.endsWith("Z") ? [[spots.at(k - 1), spot, 3]] : []));
  });
  const end = (x) => onPage(placed(block, [x / view.scale, 0]));
  return block ? [...lines, [end(-13), end(13), 11]] : lines;
});
