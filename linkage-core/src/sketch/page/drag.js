// Which inputs bring a dragged point where the pointer is.

const withOne = (q, k, x) => q.map((own, n) => (n === k ? x : own));

/// The crank of the ground that carries a point, and the input that turns it by how much; none for any other
/// point, and for a crank that an equation turns. An input is found by what a little of it does, either way.
const crankOf = (point) => {
  const turned = statements.flatMap(({ members }) => members).filter((member) => member.turned);
  // About a pivot that moves no angle brings the point to the pointer.
  const crank = turned.find(({ link, pivot }) => grounds.has(pivot) && pivot !== point && joints[link].includes(point));
  if (!crank) return null;
  const angle = (q) => {
    const { cos, sin } = new Pose(q).link(crank.link) ?? { cos: NaN, sin: NaN };
    return atan2(sin, cos);
  };
  for (const k of inputs.keys()) {
    const ratios = [1e-3, -1e-3].map((step) => {
      return nearest(angle(withOne(state.q, k, state.q[k] + step)) - angle(state.q)) / step;
    });
    const [ratio, back] = ratios;
    if (abs(ratio) > 1e-3 && abs(ratio - back) < 1e-6) return { ...crank, input: k, ratio };
  }
  return null;
};

/// An angle no farther than half a turn from zero.
const nearest = (angle) => angle - TURN * round(angle / TURN);

/// Turns a crank by the angle from its point to the pointer: it winds up, and goes on into a gap.
const turned = (crank, point, [x, y], q) => {
  const pose = new Pose(q), [px, py] = pose.point(crank.pivot), [bx, by] = pose.point(point);
  const angle = nearest(atan2(y - py, x - px) - atan2(by - py, bx - px));
  return withOne(q, crank.input, q[crank.input] + angle / crank.ratio);
};

const clamp = (x, from, to) => min(max(x, from), to);
const within = (x, { turns, from, to }) => (turns ? x : clamp(x, from, to));
const sizeOf = ({ from, to }) => to - from;

/// How a point moves by each input, from poses a little apart; nothing where neither can be assembled.
const movesBy = (point, q, at) =>
  inputs.map((input, k) => {
    const step = 1e-6 * sizeOf(input);
    for (const h of [step, -step]) {
      const pose = new Pose(withOne(q, k, q[k] + h));
      const to = !pose.error && pose.point(point);
      if (to) return [(to[0] - at[0]) / h, (to[1] - at[1]) / h];
    }
    return [0, 0];
  });

/// The least change of the inputs that moves a point by e (damped least squares). An input that would leave its
/// range goes to its end, one after the other, and the others do the rest.
const change = (moves, e, q) => {
  const held = new Map();
  for (;;) {
    let [ex, ey] = e, [xx, xy, yy] = [0, 0, 0];
    moves.forEach(([x, y], k) => {
      if (held.has(k)) [ex, ey] = [ex - x * held.get(k), ey - y * held.get(k)];
      else [xx, xy, yy] = [xx + x * x, xy + x * y, yy + y * y];
    });
    const damping = 1e-4 * (xx + yy) + 1e-12;
    const [a, c] = [xx + damping, yy + damping], size = a * c - xy * xy;
    const [wx, wy] = [(c * ex - xy * ey) / size, (a * ey - xy * ex) / size];
    const steps = moves.map(([x, y], k) => held.get(k) ?? x * wx + y * wy);
    const beyond = inputs.findIndex((input, k) => !held.has(k) && within(q[k] + steps[k], input) !== q[k] + steps[k]);
    if (beyond < 0) return steps;
    held.set(beyond, within(q[beyond] + steps[beyond], inputs[beyond]) - q[beyond]);
  }
};

/// The inputs near q at which a point comes nearest to a place: a few of Newton's steps, each at most 20° or
/// 15 % of a range, taken only to a pose that can be assembled and is nearer. At a limit it stays.
const towards = (point, place, q) => {
  let pose = new Pose(q);
  if (pose.error) return q;
  const missing = (pose) => {
    const [x, y] = pose.point(point);
    return [place[0] - x, place[1] - y];
  };
  const square = ([x, y]) => x * x + y * y;
  for (let round = 0; round < 6; round++) {
    const e = missing(pose), steps = change(movesBy(point, pose.q, pose.point(point)), e, pose.q);
    const longest = inputs.map((input) => (input.isAngle ? PI / 9 : 0.15 * sizeOf(input)));
    let share = min(1, ...steps.map((step, k) => longest[k] / max(abs(step), 1e-12)));
    const least = share / 40;
    const tried = () => new Pose(pose.q.map((x, k) => within(x + share * steps[k], inputs[k])));
    const isNearer = (next) => !next.error && square(missing(next)) < square(e) * (1 - 1e-6);
    let next = tried();
    while (!isNearer(next) && share > least) {
      share /= 2;
      next = tried();
    }
    if (!isNearer(next)) break;
    pose = next;
  }
  return pose.q;
};
