// The machine's picture: bodies, joints, supports and names, by the symbols of kinematic diagrams.

const $ = (selector) => document.querySelector(selector);
const figure = $("#figure");
const on = (node, kind, does) => node.addEventListener(kind, does);
const element = (tag, properties, parent) => {
  const node = Object.assign(document.createElement(tag), properties);
  parent?.append(node);
  return node;
};
/// Writes a name that may be divided behind a point or an underscore.
const entitle = (node, text) => {
  text.split(/(?<=[._])/).forEach((part) => node.append(part, element("wbr")));
};
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
const degreesOf = ({ cos, sin }) => (-atan2(sin, cos) * 180) / Math.PI;
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

/// The length by which a guide exceeds the travel of its blocks, and a pointer's, in pixels.
const OVERRUN = 27, POINTER = 44;

const colours = PLAN.links.map((_, link) => `var(--l${link % 6})`);
const allMembers = statements.flatMap(({ members }) => members);
/// The points at which something stands, which are drawn.
const used = new Set([
  ...joints.flat(),
  ...PLAN.springs.flatMap(({ ends }) => ends),
  ...statements.flatMap(({ point, on }) => (point !== undefined && on === null ? [point] : [])),
]);

// ---- what all poses tell ----------------------------------------------------------------------------

/// How far links slide, how long cylinders are and which guides lie still, over all poses.
const travel = { slides: [], lengths: new Map(), stillGuides: new Set() };

const widened = ([least, most], x) => (isFinite(x) ? [Math.min(least, x), Math.max(most, x)] : [least, most]);
const NOTHING = [Infinity, -Infinity];
const orIdle = ([least, most]) => (least <= most ? [least, most] : [0, 0]);

const survey = (poses) => {
  travel.slides = PLAN.links.map((_, link) => poses.reduce((range, pose) => {
    const frame = pose.link(link);
    return frame ? widened(range, frame.slide) : range;
  }, NOTHING));
  for (const { members, pin } of statements) {
    for (const member of members) {
      if (member.shape !== "cylinder") continue;
      const lengths = poses.map((pose) => Math.abs(pose.dimension(member)));
      travel.lengths.set(member.link, lengths.reduce(widened, NOTHING));
    }
  }
  travel.stillGuides = new Set(PLAN.guides.map((_, guide) => guide).filter((guide) => {
    const frames = poses.map((pose) => pose.guide(guide)).filter(Boolean), [first] = frames;
    return frames.every(({ at, cos, sin }) => apart(at, first.at) < 1e-9 && Math.abs(cos - first.cos) + Math.abs(sin - first.sin) < 1e-9);
  }));
};

/// From where to where a block slides on a link of its own group.
const slidesOn = (link) => {
  const { members } = statements.find(({ members }) => members.some((member) => member.link === link));
  return orIdle(travel.slides[members.find(({ shape }) => shape === "sleeve").link]);
};

/// From where to where a guide is drawn, in metres along it.
const endsOf = (guide) => {
  const links = allMembers.filter((member) => member.guide === guide).map(({ link }) => travel.slides[link]);
  const [least, most] = orIdle(links.reduce((range, [a, b]) => widened(widened(range, a), b), NOTHING));
  return [least - OVERRUN / view.scale, most + OVERRUN / view.scale];
};

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
  bar: (pose, { link }) => outline(spotsOf(pose, link)),
  body: (pose, { link }) => {
    const spots = spotsOf(pose, link);
    if (spots.length > 1) return outline(spots);
    const frame = pose.link(link);
    return { bar: pathOf([onPage(frame.at), onPage(placed(frame, [POINTER / view.scale, 0]))]) };
  },
  cylinder: (pose, { link, pivot }, { pin }) => {
    const [a, b] = [pivot, pin].map((point) => onPage(pose.point(point)));
    const [shortest, longest] = travel.lengths.get(link).map((length) => length * view.scale);
    const tube = Math.max(Math.min(shortest - 0.12 * (longest - shortest) - 10, apart(a, b) - 10), 0.3 * shortest);
    const others = joints[link].filter((point) => point !== pin);
    return {
      ...(others.length > 1 ? outline(others.map((point) => onPage(pose.point(point)))) : {}),
      rod: pathOf([a, along(a, b, 8)]) + pathOf([along(a, b, tube), b]),
      tube: pathOf([along(a, b, 8, 7), along(a, b, tube, 7), along(a, b, tube, -7), along(a, b, 8, -7)], true),
    };
  },
  block: (pose, member) => {
    const frame = pose.link(member.link), spots = spotsOf(pose, member.link);
    const seat = placed(frame, [0, -pose.dimension(member)]), stub = pathOf([onPage(seat), onPage(frame.at)]);
    const { bar = "", plate } = spots.length > 1 ? outline(spots) : {};
    return { bar: bar + stub, plate, block: { ...frame, at: seat } };
  },
  sleeve: (pose, { link }) => {
    const spots = spotsOf(pose, link);
    return { ...(spots.length > 1 ? outline(spots) : {}), block: pose.link(link) };
  },
  slotted_bar: (pose, member) => {
    const frame = pose.link(member.link), offset = pose.dimension(member), over = OVERRUN / view.scale;
    const [least, most] = slidesOn(member.link);
    const own = joints[member.link].map((point) => pose.point(point)).filter(Boolean).map((spot) => seenFrom(frame, spot));
    const reach = own.filter(([, y]) => Math.abs(y - offset) * view.scale < 1).map(([x]) => x);
    const ends = [Math.min(least - over, ...reach), Math.max(most + over, ...reach)];
    const line = pathOf(ends.map((x) => onPage(placed(frame, [x, offset]))));
    const stub = pathOf([onPage(frame.at), onPage(placed(frame, [0, offset]))]);
    const isAside = own.some(([, y]) => Math.abs(y - offset) * view.scale >= 1);
    const { bar = "", plate } = isAside && own.length > 1 ? outline(spotsOf(pose, member.link)) : {};
    return { bar: line + bar + (offset ? stub : ""), plate };
  },
  yoke: (pose, member, { members }) => {
    const yoke = pose.link(member.link), { link } = members.find(({ shape }) => shape === "sleeve");
    const first = { ...pose.link(link), at: placed(yoke, [0, pose.dimension(member)]) };
    const slot = { ...first, at: placed(first, [0, pose.dimension(member, 1)]) };
    const [least, most] = slidesOn(member.link), over = OVERRUN / view.scale;
    const line = [Math.min(least - over, 0), Math.max(most + over, 0)].map((x) => onPage(placed(slot, [x, 0])));
    const { bar = "", plate } = outline([...spotsOf(pose, member.link), onPage(yoke.at)]);
    const stub = pathOf([yoke.at, first.at, slot.at].map(onPage));
    return { bar: pathOf(line) + bar + stub, plate, block: yoke };
  },
};

/// The guides that a link carries: a bar as long as its blocks go, tied to the nearest joint.
const carriedBy = (pose, link) =>
  statements.filter(({ guide, on }) => guide !== undefined && on === link).map(({ guide }) => {
    const frame = pose.guide(guide);
    if (!frame) return "";
    const [from, to] = endsOf(guide), spots = joints[link].map((point) => pose.point(point)).filter(Boolean);
    const ties = (spots.length ? spots : [pose.link(link).at]).map((spot) => {
      const foot = placed(frame, [clamp(seenFrom(frame, spot)[0], from, to), 0]);
      return [spot, foot].map(onPage);
    });
    const [tie] = ties.sort((a, b) => apart(...a) - apart(...b));
    return pathOf([from, to].map((x) => onPage(placed(frame, [x, 0])))) + (apart(...tie) > 2 ? pathOf(tie) : "");
  }).join("");

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
  return { ...parts, bar: (parts.bar ?? "") + carriedBy(pose, member.link) };
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
