// Forces, to one scale.

/// The force whose arrow is as long as arrows are: the largest over the range. Where this is more than twice what a tenth
/// of the poses exceeds, it is the latter: a peak, as at the end of a range, leaves the others to be seen. Longer arrows are
/// cut there, and have two heads.
let largestForce = 0, areCut = false;
const sampleForces = () => {
  const peaks = samples.map((answers) => max(0, ...forcesIn(answers).map(([, force]) => Math.hypot(...(force ?? []))))).sort((a, b) => a - b);
  const [usual, most] = [peaks[floor(0.9 * STEPS)], peaks[STEPS]];
  areCut = usual > 0 && most > 2 * usual;
  largestForce = areCut ? usual : most;
};
/// A round force at the foot of the picture, as long as arrows of it are, and where its arrow begins.
const drawForceScale = (most, [unit, times]) => {
  const round = roundBelow(largestForce * times);
  const length = (round / times / largestForce) * most, y = view.height - 14, right = view.width - 16;
  say(nodes.forceWords, withUnit(digits(round, 1), unit) + (areCut ? " (» longer)" : ""));
  const wide = roomOf(nodes.forceWords), x = right - wide - 8;
  trace(nodes.forceScale, arrowTo([x - length, y], [x, y]));
  show(nodes.forceWords, true, [x + 8, y + 4]);
  return x - length;
};
/// How long the largest arrow is. None leaves the picture, whose sides are that far from the machine.
const mostArrow = () => (view.width < 500 ? 36 : 90);
/// The forces of a pose, an arrow each: where they act, in metres, and x and y in newtons.
const forcesIn = (answers) => {
  const { pose, forces, applied } = answers;
  return [
    ...reactions.map(({ at, point }) => [pose.point(point), forces?.slice(at, at + 2)]),
    ...appliedAt.map((point, k) => [pose.point(point), applied?.slice(2 * k, 2 * k + 2)]),
    ...(MACHINE.marks ? weightsAndPushes(answers) : []),
  ];
};
/// The arrows of a pose, and what else names keep off.
const arrowsOf = (answers) => {
  const scale = mostArrow() / largestForce, own = [...nodes.arrows, ...nodes.applied, ...(nodes.acting ?? [])];
  return forcesIn(answers).map(([at, force], k) => {
    const arrow = own[k], size = Math.hypot(...(force ?? []));
    if (!at || !(size * scale > 1)) return { arrow };
    const [x, y] = onPage(at), by = scale * min(1, largestForce / size);
    return { arrow, size, from: [x, y], to: [x + force[0] * by, y - force[1] * by] };
  }).concat(MACHINE.marks ? markedLines(answers) : []);
};
/// Writes a number beside a place, at its left or right, and best on no joint.
const tellForce = ({ text, effort }, pose, number, [x, y], isLeft) => {
  const pins = [...used].map((point) => pose.point(point)).filter((at) => at).map(onPage);
  say(text, effort ? `${effort} ${number}` : number);
  const wide = roomOf(text), sides = [x + 6, x - 6 - wide];
  if (isLeft) sides.reverse();
  const spots = [-6, 16, -22].flatMap((dy) => sides.map((x) => [x, y + dy]));
  const isOnPin = ([x, y]) => pins.some(([u, v]) => abs(u - x - wide / 2) < wide / 2 + 7 && abs(v - y + 4) < 12);
  write(text, wide, spots.sort((a, b) => isOnPin(a) - isOnPin(b)));
};
/// The arrows, and where their scale begins.
const drawForces = (pose, arrows) => {
  const isAny = largestForce > 0, [unit, times] = shownIn("N", 0, largestForce);
  show(nodes.forceScale, isAny);
  show(nodes.forceWords, isAny);
  for (const { arrow, size, from, to } of arrows.filter(({ arrow }) => arrow)) {
    show(arrow.path, to);
    show(arrow.text, false);
    if (!to) continue;
    trace(arrow.path, arrowTo(from, to) + (size > largestForce * (1 + 1e-9) ? arrowTo(from, along(to, from, 6)) : ""));
    if (apart(from, to) >= 25 && view.width >= 500) tellForce(arrow, pose, withUnit(digits(size * times, 3), unit), to, to[0] < from[0]);
  }
  return isAny ? drawForceScale(mostArrow(), [unit, times]) - 16 : view.width - 16;
};
