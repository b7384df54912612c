// The ends of sliders of which nothing was said: an input goes as far as the machine can be assembled, from where it
// stands; a parameter that is zero at first goes as far as the machine is large.

const unbounded = inputs.flatMap(({ from, rate }, k) => (isFinite(from) ? [] : [{ k, hasRate: isFinite(rate) }]));
const idle = [...params, ...loads].filter(({ words, from }) => !words && !isFinite(from));

/// What no length of the machine exceeds by much: the sum of its lengths, offsets and ground points' coordinates.
const sizeOfMachine = () => {
  const pose = new Pose(state.q.map((x) => (isFinite(x) ? x : 0)));
  const own = pose.numbers.slice(DIMENSIONS), fixed = [...grounds].flatMap((point) => pose.numbers.slice(2 * point, 2 * point + 2));
  return [...own, ...fixed].map(abs).filter((x) => x < Infinity).reduce((sum, x) => sum + x, 0) || 1;
};

/// The lengths of cylinders, which end where they change their sign.
const cylinders = statements.flatMap(({ members }) => members.filter(({ shape }) => shape === "cylinder"));
const signsOf = (pose) => cylinders.map((member) => Math.sign(pose.dimension(member)));
const standsAt = (q) => !new Pose(q).error;

/// The inputs where the machine begins: the drawn ones, or those in the middle of what stands on a grid. Lengths that
/// are all alike are tried first, and positive ones.
const inputsThatStand = (size) => {
  const first = state.q.map((x) => (isFinite(x) ? x : 0)), open = unbounded.filter(({ k }) => !isFinite(state.q[k])).map(({ k }) => k);
  if (!open.length) return first;
  const middle = (list) => {
    if (!list.length) return null;
    const mean = first.map((_, k) => list.reduce((sum, q) => sum + q[k], 0) / list.length);
    const off = (q) => q.reduce((sum, x, k) => sum + (x - mean[k]) ** 2, 0);
    return list.reduce((best, q) => (off(q) < off(best) ? q : best));
  };
  const places = (count) => Array.from({ length: count }, (_, n) => ((n + 0.5) / count) * size);
  const alike = (x) => first.map((own, k) => (open.includes(k) ? x : own));
  for (const sign of [1, -1]) {
    const found = middle(places(400).map((x) => alike(sign * x)).filter(standsAt));
    if (found) return found;
  }
  if (open.length > 3) return first;
  const sides = [...places(open.length > 2 ? 8 : 24)].flatMap((x) => [x, -x]);
  const all = open.reduce((list, k) => list.flatMap((q) => sides.map((x) => withOne(q, k, x))), [first]);
  return middle(all.filter(standsAt)) ?? first;
};

/// The ends of one input while the others hold: steps of a two hundredth of the machine, and halves of the last.
const travelOf = (k, q, size) => {
  const step = size / 200, start = q[k], signs = signsOf(new Pose(q));
  const stands = (x) => {
    const pose = new Pose(withOne(q, k, x));
    return !pose.error && signsOf(pose).every((sign, n) => sign === signs[n]);
  };
  const end = (way) => {
    let [good, bad] = [start, start + way * step];
    while (stands(bad)) {
      if (abs(bad - start) > size) return bad;
      [good, bad] = [bad, bad + way * step];
    }
    for (let round = 0; round < 50; round++) {
      const middle = 0.5 * (good + bad);
      if (stands(middle)) good = middle;
      else bad = middle;
    }
    return good;
  };
  const [a, b] = [end(-1), end(1)];
  return a < b ? [a, b] : [start - step, start + step];
};

/// True if a parameter or a load may be negative, as the machine stands.
const mayBeNegative = (list, n, size) => {
  const was = list[n];
  list[n] = -size;
  const pose = new Pose(state.q.map((x) => (isFinite(x) ? x : 0))), { refused } = answersAt(pose);
  list[n] = was;
  return refused?.kind !== "Invalid";
};

const findIdle = (size) => {
  for (const own of idle) {
    const n = params.indexOf(own), unit = own.unit in WRITTEN.m ? 0.5 * size : 10 * own.size;
    const isFree = n < 0 || mayBeNegative(state.p, n, unit);
    assign(own, { from: isFree ? -unit : 0, to: unit });
  }
};

/// Finds all ends, again whenever a parameter has another value.
const findRanges = () => {
  if (!unbounded.length && !idle.length) return;
  const size = sizeOfMachine(), q = inputsThatStand(size);
  findIdle(size);
  for (const { k, hasRate } of unbounded) {
    const [from, to] = travelOf(k, q, size), input = inputs[k];
    assign(input, { from, to });
    if (!isFinite(input.at)) input.at = unbounded.length > 1 ? q[k] : 0.5 * (from + to);
    if (!isFinite(state.q[k])) state.q[k] = input.at;
    if (!hasRate) {
      const isOwn = k === state.axis && (!isFinite(state.rate) || state.rate === input.rate);
      input.rate = 0.25 * (to - from);
      if (isOwn) state.rate = input.rate;
    }
  }
};
