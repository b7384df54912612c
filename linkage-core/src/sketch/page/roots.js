// The search for an unknown: `roots` of the Rust crate, step by step, in numbers that carry no derivatives.
//
// A place is an object {x, value, slope}. A search that finds nothing throws the reason, an object with a kind.

/// Evaluations beyond those of bisection, and those of bisection in the widest bracket.
const SPARE = 6, HALVINGS = 53;
const MOST_TO_CLOSE_IN = HALVINGS + SPARE, MOST_OF_A_SEARCH = 2 + MOST_TO_CLOSE_IN;
const MOST_TO_A_DEAD_POINT = (MOST_TO_CLOSE_IN >> 1) + SPARE;
/// √ε, the slope's growth behind which a function is another one, and Newton's steps from a seed.
const ROOT_EPSILON = 2 ** -26, STEEPER = 4, SEEDED = 3;
/// A target within this part of the sides of an end counts as that end.
const SLACK = 4 * EPSILON;

// Where one of both is no number this answers as the crate's does, unlike that of `Math`.
const less = (a, b) => (b > a ? a : b);
const middle = (a, b) => a + (b - a) * 0.5;
const signed = (sign, { x, value, slope }) => ({ x, value: sign * value, slope: sign * slope });

/// The interval between two ends, if they are finite and in order.
const intervalOf = ([from, to]) => {
  const width = to - from, tolerance = greater(magnitude(from), magnitude(to)) * (0.5 * EPSILON);
  return isFinite(width) && width > 0 ? { from, to, width, tolerance } : null;
};

/// The evaluations of a bracket, and how far from its middle the first may be.
const budgetOf = (tolerance, width) => {
  const exponent = (x) => (highBits(x) >>> 20) & 0x7ff;
  let halvings = Math.min(Math.max(exponent(width) - exponent(tolerance) - 2, 0), HALVINGS);
  let reach = tolerance * 2 ** halvings;
  while (halvings < HALVINGS && width > reach + reach) {
    reach = reach + reach;
    halvings++;
  }
  return [halvings + SPARE, reach * 64];
};

/// The trial moved to where a bracket that is halved from now on ends in time.
const projected = (x, [a, b], reach) => {
  const half = (b - a) * 0.5, centre = a + half, aside = greater(reach - half, 0);
  const low = greater(centre - aside, a), high = less(centre + aside, b);
  if (x >= low && high >= x) return x;
  return low > x ? low : x > high ? high : centre;
};

/// Newton's step where the slope is one that rises.
const newtonStep = ({ value, slope }) => (slope > 0 && isFinite(slope) ? -value / slope : null);

/// True if this step leads to within the tolerance, as far as it and the one before show. `isExact` tells slopes
/// of the function from those of two values.
const isLastStep = ({ tolerance, width, isExact, last }, step, slope) => {
  step = magnitude(step);
  if (tolerance >= step) return true;
  if (!last) return false;
  const before = magnitude(last.step);
  if (step >= before * 0.7) return width * 2 ** -22 >= before;
  if (isExact && magnitude(slope) > magnitude(last.slope) * STEEPER) return false;
  const ratio = step / before;
  const bend = magnitude((slope - last.slope) / (slope + slope));
  return tolerance * 0.5 >= (isExact ? greater(ratio * ratio, bend * ratio) * step : ratio * step);
};

/// Where a function comes through zero, from below at the first place to above at the second. A trial answers
/// with a place, and with `isEnough` where the search may end.
const closeIn = ({ tolerance }, [a, b], start, isExact, most, trial) => {
  const width = b.x - a.x, believed = (b.value - a.value) / (width * ROOT_EPSILON);
  let [budget, reach] = budgetOf(tolerance, width), x = start, last = null;
  for (let left = Math.min(budget, most); left > 0; left--) {
    const wanted = x;
    x = projected(x, [a.x, b.x], reach);
    reach = reach * 0.5;
    if (x !== wanted) last = null;
    const at = trial(x);
    if (at.isEnough || at.value === 0) return at.x;
    if (at.value > 0) b = at;
    else a = at;
    if (tolerance + tolerance >= b.x - a.x) break;
    const step = newtonStep(at);
    const guides = step !== null && believed >= at.slope && x + step >= a.x && b.x >= x + step;
    if (!guides) {
      last = null;
      x = middle(a.x, b.x);
      continue;
    }
    if (isLastStep({ tolerance, width, isExact, last }, step, at.slope)) return x + step;
    last = { step, slope: at.slope };
    x = x + step;
  }
  return (magnitude(b.value) > magnitude(a.value) ? a : b).x;
};

/// Between 0 and 1 the root of the cubic with these values, below zero and above, and slopes at both ends.
const partOfCubic = ([y0, y1], [d0, d1]) => {
  if (!(isFinite(d0) && isFinite(d1))) return y0 / (y0 - y1);
  const p = 2 * (y0 - y1) + (d0 + d1), q = 3 * (y1 - y0) - (2 * d0 + d1);
  const parabola = (-2 * y0) / (d0 + Math.sqrt(d0 * d0 - 4 * q * y0));
  let u = parabola > 0 && 1 > parabola ? parabola : 0.5, [low, high] = [0, 1];
  for (let left = 10; left > 0; left--) {
    const value = ((p * u + q) * u + d0) * u + y0, slope = (3 * p * u + 2 * q) * u + d0;
    if (value > 0) high = u;
    else low = u;
    const next = u - value / slope, isNear = 1e-3 * u >= magnitude(next - u);
    u = next > low && high > next ? next : (low + high) * 0.5;
    if (isNear) break;
  }
  return u;
};

/// The first trial: the cubic's root, from the end that is nearer to zero.
const startOf = ([a, b]) => {
  const width = b.x - a.x;
  return b.value > -a.value
    ? a.x + width * partOfCubic([a.value, b.value], [a.slope * width, b.slope * width])
    : b.x - width * partOfCubic([-b.value, -a.value], [b.slope * width, a.slope * width]);
};

/// The lowest point between a place where a function falls and one where it rises, or the first place below a floor.
const lowest = ([a, b], floor, most, sample) => {
  const interval = intervalOf([a.x, b.x]);
  if (!interval) return a;
  const slopeAt = ({ x, slope }) => ({ x, value: slope, slope: 0 });
  const start = a.x + (b.x - a.x) * cubicThrough([a, b]).turningPart();
  let last = a;
  const found = closeIn(interval, [a, b].map(slopeAt), start, false, most, (x) => {
    const at = sample(x), secant = (at.slope - last.slope) / (at.x - last.x);
    last = at;
    return { x, value: at.slope, slope: secant, isEnough: floor > at.value };
  });
  return found === last.x ? last : sample(found);
};

/// left − right of an equation, its sign such that it rises at the root, its evaluations counted.
class Equation {
  evaluations = 0;

  constructor(sign, difference) {
    this.sign = sign;
    this.difference = difference;
  }

  /// At a trial; nothing where it is no number.
  sample(x) {
    this.evaluations++;
    const [value, slope] = this.difference(x);
    return isFinite(value) ? signed(this.sign, { x, value, slope }) : null;
  }

  at(x) {
    const at = this.sample(x);
    if (!at) throw { kind: "NotFinite", at: x };
    return at;
  }

  /// The root that Newton's method converges to from a seed, if it does at once and inside.
  newton(seed, { from, to, width, tolerance }) {
    let x = seed, last = null;
    for (let left = SEEDED; left > 0; left--) {
      if (!(x >= from && to >= x)) return null;
      const at = this.sample(x), step = at && newtonStep(at);
      if (step === null || !(width >= magnitude(step))) return null;
      x = x + step;
      if (isLastStep({ tolerance, width, isExact: true, last }, step, at.slope)) return x >= from && to >= x ? x : null;
      last = { step, slope: at.slope };
    }
    return null;
  }

  root(ends, interval) {
    return closeIn(interval, ends, startOf(ends), true, Infinity, (x) => this.at(x));
  }

  /// The root between a place above zero and one below it; one place for both is the root.
  fallingRoot(ends, most) {
    const [a, b] = ends.map((end) => signed(-1, end)), interval = intervalOf([a.x, b.x]);
    return interval ? closeIn(interval, [a, b], startOf([a, b]), true, most, (x) => signed(-1, this.at(x))) : a.x;
  }

  /// One of the ends, moved to the dead point that it lies beyond or until its sign is right, by so many
  /// evaluations at most.
  movedIn(ends, end, most) {
    const [stays, moves] = end === 0 ? [ends[1], ends[0]] : ends;
    const inner = stays.slope > 0 ? stays : this.at(middle(ends[0].x, ends[1].x));
    if (!(inner.slope > 0)) return moves;
    const turn = (at) => (end === 0 ? at : signed(-1, at));
    const between = (end === 0 ? [moves, inner] : [inner, moves]).map(turn);
    const spared = Math.max(Math.min(MOST_TO_A_DEAD_POINT, most) - 2, 0);
    return turn(lowest(between, 0, spared, (x) => turn(this.at(x))));
  }
}

/// True if a function whose slope keeps its sign rises between these ends on one side of zero.
const risesWithoutARoot = ([a, b]) =>
  b.value > a.value && ((a.value > 0 && a.slope >= 0) || (0 > b.value && b.slope >= 0));

/// The root from both ends. `slackOf` is told the values there, and says by how much one may miss zero. The slope of
/// what `isSteady` is proved to have one sign.
const bracketed = (f, interval, isSteady, slackOf) => {
  const ends = [f.at(interval.from), f.at(interval.to)], slack = slackOf(ends.map(({ value }) => value));
  let [a, b] = ends, most = MOST_OF_A_SEARCH - 2;
  const move = (end) => {
    const before = f.evaluations, moved = f.movedIn([a, b], end, most);
    most = Math.max(most - (f.evaluations - before), 0);
    return moved;
  };
  if (a.value >= 0 && 0 > a.slope) a = move(0);
  if (0 >= b.value && 0 > b.slope) b = move(1);
  const size = greater(magnitude(ends[0].value), magnitude(ends[1].value));
  const steepest = greater(slack, size * EPSILON) / ((ends[1].x - ends[0].x) * ROOT_EPSILON);
  const falls = (end) => -end.slope > steepest;
  const misses = (end, by) => by > 0 || (by === 0 && falls(end));
  const [low, high] = [misses(a, a.value), misses(b, -b.value)];
  if (!low && !high) return [a, b].find(({ value }) => value === 0)?.x ?? f.root([a, b], interval);
  const nearer = !low || (high && a.value > -b.value) ? b : a;
  const isMet = (at) => slack >= magnitude(at.value) && !falls(at);
  if (isMet(nearer)) return nearer.x;
  if (isSteady && risesWithoutARoot(ends)) throw { kind: "NoSolution", by: magnitude(nearer.value), other: null };
  const course = courseOf(f, [ends[0], a, b, ends[1]], most);
  if (course.rises) return f.root(course.rises, interval);
  if (course.zero) return course.zero.x;
  if (!course.isKnown) throw { kind: "SeveralDeadPoints" };
  const { nearest: dead, falling } = course;
  const nearest = dead && magnitude(nearer.value) > magnitude(dead.value) ? dead : nearer;
  if (isMet(nearest)) return nearest.x;
  const left = Math.max(MOST_OF_A_SEARCH - f.evaluations, 0);
  const other = falling ? { trend: -f.sign, at: f.fallingRoot(falling, left) } : null;
  throw { kind: "NoSolution", by: magnitude(nearest.value), other };
};

/// The root of an equation of the wanted trend, +1 or −1, from a seed if there is one, and the size that its
/// rounding is measured by. `sides` gives left, right and the slope of left − right, which may be proved to have one sign.
const searched = (between, trend, near, sides, isSteady = false) => {
  const interval = intervalOf(between);
  if (!interval) throw { kind: "Interval", isOrdered: between[1] > between[0] };
  let [extent, change] = [0, 0];
  const f = new Equation(trend, (x) => {
    const [left, right, slope] = sides(x), size = magnitude(left) + magnitude(right);
    if (isFinite(size)) extent = greater(extent, size);
    change = magnitude(slope) * interval.width;
    return [left - right, slope];
  });
  let at = near === null ? null : f.newton(near, interval);
  if (at !== null) {
    const last = change;
    if (last > extent) f.at(interval.from);
    change = last;
  } else {
    at = bracketed(f, interval, isSteady, ([a, b]) => greater(greater(magnitude(a), magnitude(b)), extent) * SLACK);
  }
  if (!isFinite(at)) throw { kind: "Singular" };
  return [at, extent + change];
};

/// The same, or the reason why there is none.
const rootOf = (...asked) => {
  try {
    return searched(...asked);
  } catch (reason) {
    if (!reason.kind) throw reason;
    return reason;
  }
};

/// The same of an angle whose ends are known at run time: beyond a turn every pose comes once more.
const rootWithinATurn = ([from, to], ...asked) =>
  to - from > TURN + EPSILON * (magnitude(from) + magnitude(to) + TURN)
    ? { kind: "Interval", isOrdered: true }
    : rootOf([from, to], ...asked);

Object.assign(REASONS, {
  NoSolution: ({ group, by, unit, other }) => {
    const [wanted, found] = other?.trend > 0 ? ["falling", "rises"] : ["rising", "falls"];
    return other
      ? `${group}: no ${wanted} root between its ends; the equation ${found} through zero at ${digits(other.at)}`
      : `${group}: no solution between its ends, ${words(by, unit)} is missing`;
  },
  SeveralDeadPoints: ({ group }) => `${group}: several dead points between the ends; narrow the interval`,
  Invalid: ({ group, name }) => name === ENDS && `${group}: the ends of between must be at most a turn apart`,
});
