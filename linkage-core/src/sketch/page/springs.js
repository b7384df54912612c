// Springs and dampers.

const zigzag = (a, b, side = 0) => {
  const length = apart(a, b), lead = min(16, length / 4), coils = 9;
  const spots = [along(a, b, 0, side), along(a, b, lead, side)];
  for (let k = 0; k < coils; k++) {
    spots.push(along(a, b, lead + ((length - 2 * lead) * (k + 0.5)) / coils, side + (k % 2 ? 7 : -7)));
  }
  return pathOf([...spots, along(a, b, length - lead, side), along(a, b, length, side)]);
};

const damper = (a, b, side = 0) => {
  const length = apart(a, b), [bottom, top, piston] = [0.3, 0.7, 0.55].map((share) => share * length);
  const spot = (far, across) => along(a, b, far, side + across);
  return pathOf([spot(0, 0), spot(bottom, 0)]) + pathOf([spot(top, 6), spot(bottom, 6), spot(bottom, -6), spot(top, -6)])
    + pathOf([spot(piston, 6), spot(piston, -6)]) + pathOf([spot(piston, 0), spot(length, 0)]);
};

const drawSprings = (pose) => PLAN.springs.forEach(({ ends, kinds }, k) => {
  const [a, b] = ends.map((end) => pose.point(end));
  const [hasStiffness, hasDamping] = kinds;
  const draw = ([a, b]) =>
    hasStiffness && hasDamping ? zigzag(a, b, -11) + damper(a, b, 11) + pathOf([along(a, b, 0, -11), along(a, b, 0, 11)])
      + pathOf([along(b, a, 0, -11), along(b, a, 0, 11)])
    : hasStiffness ? zigzag(a, b) : damper(a, b);
  trace(nodes.spring[k], a && b && draw([a, b].map(onPage)));
});
