// Masses, weights, couples, wheels and drives, of a machine that has any of them.

const { masses, weigh, couples, wheels, drives } = MACHINE.marks ?? { masses: 0, couples: [], wheels: [], drives: [] };
const MASSES = weigh ? 2 : 0, COUPLES = MASSES + 3 * masses, WHEELS = COUPLES + couples.length, WEIGHTS = weigh ? masses : 0;
/// The radius of couples' arcs, those of drives being larger beside others, and half the angle of the largest.
const ARC = 26, WIDEST = 0.75 * PI;
let largestCouple = 0;

const listOf = (count, of) => Array.from({ length: count }, (_, k) => of(k));
/// Drives of these kinds, with their places among the forces.
const drivesOf = (isOne) => drives.map(([effort, place]) => ({ effort, k: efforts.findIndex((row) => row.effort === effort), ...place })).filter(isOne);
const turns = drivesOf(({ turn }) => turn !== undefined), pushes = drivesOf(({ turn }) => turn === undefined);

/// The places of masses, each with its size; none of one that is zero.
const massesIn = ({ marked }) => (marked ? listOf(masses, (k) => marked.slice(MASSES + 3 * k, MASSES + 3 * k + 3)).map((mass) => (mass[2] > 0 ? mass : null)) : []);
/// The forces of weights and drives: where they act, in metres, and x and y in newtons.
const weightsAndPushes = (answers) => {
  const { pose, forces, marked } = answers, own = massesIn(answers);
  return [...listOf(WEIGHTS, (k) => [own[k], own[k] && [0, 1].map((axis) => own[k][2] * marked[axis])]), ...pushes.map(({ k, push, slide }) => {
    const [a, b] = (push ?? []).map((end) => pose.point(end)), frame = push ? null : pose.link(slide);
    if (!forces || !(frame || (a && b))) return [];
    return frame ? [frame.at, [frame.cos * forces[k], frame.sin * forces[k]]] : [b, minus(b, a).map((x) => (x * forces[k]) / apart(a, b))];
  })];
};
/// The couples on links, and of drives: the places that they turn about, and newton metres.
const couplesIn = ({ pose, marked, forces }) => [
  ...couples.map((link, k) => [pose.link(link)?.at, marked?.[COUPLES + k]]),
  ...turns.map(({ k, turn }) => [pose.point(turn), forces?.[k]]),
];
const sampleCouples = () => {
  largestCouple = max(0, ...samples.flatMap((answers) => couplesIn(answers).map(([, couple]) => abs(couple ?? 0))));
};

/// The arc of a couple, anticlockwise where it is positive, as wide as it is large.
const arcAbout = ([x, y], radius, couple) => {
  const half = (WIDEST * couple) / largestCouple;
  return stepped(12, [half, -half], (angle) => [x + radius * Math.sin(angle), y - radius * Math.cos(angle)]);
};
/// The arcs of couples on the page, empty where one is too small to be seen.
const arcsIn = (answers) => couplesIn(answers).map(([at, couple], k) =>
  at && abs(couple) > 0.02 * largestCouple ? arcAbout(onPage(at), k >= couples.length && couples.length ? ARC + 8 : ARC, couple) : []);
const headOf = (arc) => {
  const [from, to] = arc.slice(-2);
  return to ? [along(to, from, 8, 4), to, along(to, from, 8, -4)] : [];
};
const traceArc = (node, arc) => trace(node, pathOf(arc) + pathOf(headOf(arc)));

/// The wheels of all pairs: their links, centres and radii, in metres.
const wheelsIn = ({ pose, marked }) => wheels.flatMap((pair, n) => [0, 1].map((k) => ({
  link: pair[2 * k],
  at: pose.point(pair[2 * k + 1]),
  radius: abs(marked?.[WHEELS + 2 * n + k]),
})));

/// Places that belong into the picture. A wheel that is much larger than the way between centres goes beyond it.
const markedPlaces = (pose) => {
  const answers = answersAt(pose), all = wheelsIn(answers);
  return [...massesIn(answers).filter(Boolean), ...all.flatMap(({ at, radius }, k) => {
    const other = all[k ^ 1].at;
    return at && other && radius < 2.5 * apart(at, other) ? [-radius, radius].map((by) => at.map((x) => x + by)) : [];
  })];
};
/// Lines that names keep off: masses and arcs.
const markedLines = (answers) => [
  ...massesIn(answers).filter(Boolean).map(onPage).map(([x, y]) => ({ from: [x - 5, y], to: [x + 5, y] })),
  ...arcsIn(answers).flatMap((arc) => [arc, headOf(arc)]).flatMap((line) => line.slice(1).map((to, k) => ({ from: line[k], to }))),
];

const buildMarks = (arrow) => {
  nodes.acting = [...listOf(WEIGHTS, () => arrow("applied")), ...pushes.map(({ effort }) => ({ ...arrow("drive"), effort }))];
  nodes.couples = [...couples.map(() => arrow("applied")), ...turns.map(({ effort }) => ({ ...arrow("drive"), effort }))];
  nodes.coupleScale = arrow("drive");
  nodes.wheels = wheels.flatMap(([first, , second]) => [first, second]).map((link) => made("path", { class: "centre", style: link === null ? "" : `stroke:${colours[link]}` }, nodes.traces));
  nodes.masses = listOf(masses, () => {
    const seat = made("g", { class: "mass" }, nodes.pins);
    made("circle", { r: 6.5 }, seat);
    made("path", { d: "M0-6.5A6.5 6.5 0 0 1 6.5 0H-6.5A6.5 6.5 0 0 0 0 6.5Z" }, seat);
    return seat;
  });
};

/// All of a pose but weights and drives that push, which are drawn as other forces are. The scale of couples ends at
/// this place.
const drawMarks = (answers, end) => {
  const { pose } = answers, own = massesIn(answers), all = wheelsIn(answers), [unit, times] = shownIn("N·m", 0, largestCouple);
  nodes.masses.forEach((node, k) => show(node, own[k], own[k] && onPage(own[k])));
  nodes.wheels.forEach((node, k) => {
    // At a ratio of one wheels roll on nothing.
    const { link, at, radius } = all[k], r = isFinite(radius) && short(radius * view.scale), frame = link === null ? { cos: 1, sin: 0 } : pose.link(link);
    show(node, r && at && frame);
    if (!r || !at || !frame) return;
    trace(node, `M${short(r - 8)} 0H${r}A${r} ${r} 0 0 1 ${-r} 0A${r} ${r} 0 0 1 ${r} 0`);
    put(node, { transform: seatOf({ ...frame, at }) });
  });
  const arcs = arcsIn(answers), turning = couplesIn(answers);
  nodes.couples.forEach((arrow, k) => {
    traceArc(arrow.path, arcs[k]);
    show(arrow.text, false);
    if (arcs[k].length && view.width >= 500) tellForce(arrow, pose, withUnit(digits(abs(turning[k][1]) * times, 3), unit), arcs[k][6]);
  });
  const { path, text } = nodes.coupleScale, y = view.height - 14, isAny = largestCouple > 0, round = roundBelow(largestCouple * times);
  show(path, isAny);
  show(text, isAny);
  if (!isAny) return;
  say(text, withUnit(digits(round, 1), unit));
  const x = end - roomOf(text);
  traceArc(path, arcAbout([x - 16, y], 9, round / times));
  show(text, true, [x, y + 4]);
};
