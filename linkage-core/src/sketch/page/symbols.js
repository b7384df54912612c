// What stands beside the bodies: supports, rails, springs, names, gaps and arrows.

const nodes = {};

/// Reactions of joints, with their places among the forces, and the points of loads that are applied.
const reactions = efforts.map((effort, at) => ({ ...effort, at })).filter(({ row, point }) => point !== null && row === "x");
const appliedAt = MACHINE.appliedAt ?? [], hasForces = reactions.length + appliedAt.length > 0 || MACHINE.marks;

/// All nodes anew, for another scale.
const build = (poses) => {
  figure.replaceChildren();
  put(figure, { viewBox: `0 0 ${view.width} ${view.height}` });
  for (const layer of ["ground", "traces", "ghost", "bodies", "springs", "reach", "pins", "forces", "names", "grip"]) {
    nodes[layer] = made("g", { class: layer }, figure);
  }
  nodes.trace = tracedPoints.map((point) => made("path", { class: "trace", style: `stroke:${colourOf(point)}` }, nodes.traces));
  nodes.oldTrace = tracedPoints.map(() => made("path", { class: "old" }, nodes.traces));
  nodes.body = bodiesIn(nodes.bodies);
  nodes.shade = bodiesIn(nodes.ghost);
  nodes.spring = PLAN.springs.map(() => made("path", { class: "spring" }, nodes.springs));
  nodes.reaches = [0, 1].map(() => made("path", { class: "bound" }, nodes.reach));
  nodes.missing = made("path", { class: "missing" }, nodes.reach);
  nodes.missingWords = made("text", { class: "word warn" }, nodes.reach);
  trace(made("path", { class: "wanted" }, nodes.pins), crossesAt(PAGE.points.map(onPage)));
  nodes.pin = PLAN.points.map((_, point) =>
    made("circle", { class: grounds.has(point) ? "pin" : "pin grip-able", r: tracedPoints.includes(point) ? 5.5 : 4.6 }, nodes.pins));
  nodes.leads = made("path", { class: "lead" }, nodes.names);
  nodes.name = PLAN.points.map((name) => {
    const text = made("text", { class: "name" }, nodes.names);
    say(text, name);
    return text;
  });
  const arrow = (kind) => ({
    path: made("path", { class: `arrow ${kind}` }, nodes.forces),
    text: made("text", { class: `word force ${kind}` }, nodes.forces),
  });
  nodes.arrows = reactions.map((effort) => ({ ...arrow(""), ...effort }));
  nodes.applied = appliedAt.map(() => arrow("applied"));
  if (MACHINE.marks) buildMarks(arrow);
  nodes.rates = [arrow("velocity"), arrow("acceleration")];
  nodes.forceScale = made("path", { class: "arrow" }, nodes.forces);
  nodes.forceWords = made("text", { class: "word force" }, nodes.forces);
  nodes.halo = made("circle", { class: "halo", r: 13, visibility: "hidden" }, nodes.grip);
  drawGround(poses);
  placeNames(poses);
};

/// The link that carries a point, of a pin the last one, in its colour.
const colourOf = (point) => colours[joints.findLastIndex((own) => own.includes(point))] ?? "var(--ink)";

/// The points whose paths are drawn: those asked for, or those on moving links, or the last pin.
const tracedPoints = (() => {
  const asked = PAGE.traces.map((name) => PLAN.points.indexOf(name));
  const onLinks = statements.filter(({ point, on }) => point !== undefined && on !== null).map(({ point }) => point);
  const ending = onLinks.filter((point) => joints.filter((own) => own.includes(point)).length < 2);
  const pins = statements.filter(({ pin, members }) => (pin ?? null) !== null && members.length > 1).map(({ pin }) => pin);
  return asked.length ? asked : ending.length ? ending.slice(-2) : pins.slice(-1);
})();

// ---- what stands still ------------------------------------------------------------------------------

const support = (at) => {
  const seat = made("g", { class: "still", transform: shiftTo(at) }, nodes.ground);
  made("path", { d: "M0 0L-10 17H10Z", class: "foot" }, seat);
  made("path", { d: "M-17 17H17" }, seat);
  made("path", { d: "M-11 17l-6 7M-4 17l-6 7M3 17l-6 7M10 17l-6 7M17 17l-6 7", class: "thin" }, seat);
};

const drawGround = (poses) => {
  const [pose] = poses;
  for (const { guide, on } of statements) {
    if (guide !== undefined && on === null && travel.stillGuides.has(guide)) rail(pose.guide(guide), endsOf(guide));
  }
  for (const point of grounds) if (used.has(point)) support(onPage(pose.point(point)));
  for (const { turned, link, pivot } of allMembers) {
    if (!turned || !inputs.some(({ turns }) => turns) || inputs.some((input) => input.isAngle && !input.turns)) continue;
    const [centre, pin] = [pose.point(pivot), joints[link].find((point) => point !== pivot)];
    const at = pin === undefined || !centre ? null : pose.point(pin);
    if (at) {
      const [cx, cy] = onPage(centre).map(short);
      made("circle", { class: "centre", cx, cy, r: short(apart(centre, at) * view.scale) }, nodes.ground);
    }
  }
  const bar = roundBelow((0.2 * view.width) / view.scale), y = view.height - 14;
  made("path", { class: "scale", d: `M16 ${y}v-4v8v-4h${short(bar * view.scale)}v-4v8` }, nodes.ground);
  const [unit, times] = shownIn("m", 0, bar), words = withUnit(`${+(bar * times).toPrecision(3)}`, unit);
  made("text", { class: "word", x: 24 + short(bar * view.scale), y: y + 4 }, nodes.ground).textContent = words;
};

// ---- names ------------------------------------------------------------------------------------------

/// Offsets of the names from their points: of eight sides, near and far, one that is clear of bars, joints and
/// other names in most poses. Where it is not, the name goes elsewhere.
const offsets = [];
const halfOf = (point) => 3.8 * view.letter * PLAN.points[point].length + 1.5;
const seenIn = (pose, bodies, arrows) => ({
  lines: [...linesOf(bodies), ...arrows.filter(({ to }) => to).map(({ from, to }) => [from, to, 3])],
  spots: PLAN.points.map((_, point) => {
    const at = used.has(point) && pose.point(point);
    return at && onPage(at);
  }),
});
const placeNames = (poses) => {
  offsets.length = 0;
  const seen = poses.filter((_, k) => k % Math.ceil(poses.length / 24) === 0).map((pose) => seenIn(pose, bodiesOf(pose), hasForces ? arrowsOf(answersAt(pose)) : []));
  for (const point of used) offsets[point] = sideOf(point, seen);
};

const sideOf = (point, seen) => {
  const isOnBlock = allMembers.some(({ link, shape }) => shape === "block" && joints[link].includes(point));
  let best = [Infinity];
  for (let way = 0; way < 40; way++) {
    const angle = (way * PI) / 4, far = way >> 3;
    const offset = [Math.cos(angle) * ((isOnBlock ? 18 : 11) + 9 * far + halfOf(point)), Math.sin(angle) * ((isOnBlock ? 20 : 16) + 9 * far)];
    const cost = way * 0.01 + seen.reduce((sum, one) => sum + crowding(one, point, offset), 0) / seen.length;
    if (cost < best[0]) best = [cost, offset];
  }
  return best[1];
};

/// The cost of a name at this offset: the things that it covers.
const crowding = ({ spots, lines }, point, [dx, dy]) => {
  if (!spots[point]) return 0;
  const [px, py] = spots[point], [x, y, half] = [px + dx, py + dy, halfOf(point)];
  const covers = (u, v, wide, above, below) => abs(u - x) < half + wide && y > v - above && y < v + below;
  let cost = x < half + 4 || x > view.width - half - 4 || y < 12 || y > view.height - 26 ? 3 : 0;
  spots.forEach((spot, other) => {
    if (!spot) return;
    const [u, v] = spot, [du, dv] = offsets[other] ?? [];
    if (grounds.has(other) && covers(u, v, 18, 6, 34)) cost += 2;
    if (other === point) return;
    if (covers(u, v, 8, 14, 14)) cost += 1;
    if (covers(u + du, v + dv, halfOf(other), 15, 15)) cost += 6;
  });
  for (const [a, b, thick] of lines) {
    // No axis tells the line and the name's box apart.
    const [ux, uy] = minus(b, a).map((part) => part / 2), [mx, my] = [x - a[0] - ux, y - a[1] - uy];
    const [wide, high, across, up] = [half + thick, 6 + thick, abs(ux), abs(uy)];
    const isApart = abs(mx) > wide + across || abs(my) > high + up || abs(ux * my - uy * mx) > wide * up + high * across;
    if (!isApart) cost += 1;
  }
  return cost;
};

/// The texts of a frame: left ends, baselines and widths. A text goes to the first spot where it lies on no other
/// one, and is hidden where there is none.
let texts = [];
const roomOf = ({ textContent }) => 6.7 * view.letter * textContent.length;
const write = (node, wide, spots) => {
  const spot = spots.map(([x, y]) => [clamp(x, 4, view.width - wide - 4), clamp(y, 14, view.height - 26)])
    .find(([x, y]) => texts.every(([u, v, its]) => x > u + its || u > x + wide || abs(y - v) > 15));
  show(node, spot, spot);
  if (spot) texts.push([...spot, wide]);
};

// ---- what moves -------------------------------------------------------------------------------------

const drawJoints = (pose, bodies, arrows) => {
  const seen = seenIn(pose, bodies, arrows), { spots } = seen;
  let leads = "";
  texts = [];
  spots.forEach((spot, point) => {
    show(nodes.pin[point], spot, spot);
    show(nodes.name[point], spot);
    if (!spot) return;
    if (crowding(seen, point, offsets[point])) offsets[point] = sideOf(point, [seen]);
    const [dx, dy] = offsets[point], half = halfOf(point);
    const [x, y] = [clamp(spot[0] + dx, half + 2, view.width - half - 2), clamp(spot[1] + dy + 4.5, 14, view.height - 6)];
    show(nodes.name[point], true, [x, y]);
    texts.push([x - half, y, 2 * half]);
    const far = Math.hypot(dx, dy);
    if (far > 35 + half) leads += pathOf([along(spot, [x, y - 4.5], 7), along(spot, [x, y - 4.5], far - 12)]);
  });
  trace(nodes.leads, leads);
};

/// How far each link of the failed group reaches, dashed, and what is missing between them.
const drawGap = (pose) => {
  const { error, failed } = pose;
  const isShown = error?.kind === "OutOfReach" && failed;
  show(nodes.reach, isShown);
  show(nodes.missingWords, false);
  if (!isShown) return;
  const bounds = failed.members.map((member) => boundOf(pose, member, failed)).filter(Boolean);
  const ends = bounds.length === 2 ? between(...bounds) : null;
  nodes.reaches.forEach((node, k) => {
    const bound = bounds[k], to = ends?.[k];
    trace(node, bound && to && dashed(bound, to));
    if (bound) node.style.stroke = colours[failed.members[k].link];
  });
  trace(nodes.missing, ends && pathOf(ends));
  say(nodes.missingWords, ends ? `${words(error.by, "m")} missing` : "");
  if (!ends) return;
  const [x, y] = ends[0].map((part, k) => (part + ends[1][k]) / 2), wide = roomOf(nodes.missingWords);
  write(nodes.missingWords, wide, [-10, 22, -28, 40].flatMap((dy) => [[x + 10, y + dy], [x - 10 - wide, y + dy]]));
};

/// A circle about its pivot, or the line along which a block's pin goes.
const boundOf = (pose, member, { members }) => {
  if (member.shape === "block") {
    const frame = pose.guide(member.guide), pivot = members.find((other) => other.pivot !== null)?.pivot;
    const at = frame && pivot !== undefined && pose.point(pivot);
    if (!at) return null;
    const [x] = seenFrom(frame, at);
    return { at: onPage(placed(frame, [x, pose.dimension(member)])), angle: degreesOf(frame) };
  }
  if (member.pivot === null) return null;
  const radius = member.shape === "sleeve" ? 0 : abs(pose.dimension(member)) * view.scale;
  const at = pose.point(member.pivot);
  return at && isFinite(radius) ? { at: onPage(at), radius } : null;
};

/// The shortest way from what the first link reaches to what the second one does.
const between = (first, second) => {
  const [a, b] = [first.at, second.at], r = first.radius ?? 0, s = second.radius;
  if (first.radius === undefined) return s === undefined ? null : between(second, first).reverse();
  if (s === undefined) return [along(a, b, r), b];
  const far = apart(a, b), to = far > 1e-9 ? b : [b[0] + 1, b[1]];
  const from = (at, length) => [at[0] + along([0, 0], minus(to, a), length)[0], at[1] + along([0, 0], minus(to, a), length)[1]];
  return far > r + s ? [from(a, r), from(b, -s)] : r > s ? [from(a, r), from(b, s)] : [from(a, -r), from(b, -s)];
};

const dashed = ({ at, radius, angle }, to) => {
  if (radius === undefined) {
    const [cos, sin] = [Math.cos((angle * PI) / 180), Math.sin((angle * PI) / 180)].map((x) => 120 * x);
    return pathOf([[at[0] - cos, at[1] - sin], [at[0] + cos, at[1] + sin]]);
  }
  if (radius < 1) return "";
  const middle = Math.atan2(to[1] - at[1], to[0] - at[0]);
  const [start, end] = [-0.6, 0.6].map((by) => [at[0] + radius * Math.cos(middle + by), at[1] + radius * Math.sin(middle + by)].map(short));
  return `M${start}A${short(radius)} ${short(radius)} 0 0 1 ${end}${pathOf([at, to])}`;
};

/// An arrow with a head that is no longer than itself.
const arrowTo = (from, to) => {
  const head = min(9, 0.6 * apart(from, to));
  return pathOf([from, to]) + pathOf([along(to, from, head, 0.45 * head), to, along(to, from, head, -0.45 * head)]);
};
/// The largest of 1, 2 and 5 times a power of ten that is not above the number.
const roundBelow = (most) => {
  const power = 10 ** floor(Math.log10(most));
  return [5, 2, 1].map((step) => step * power).find((x) => x <= most) ?? power;
};
