// The exact decision whether two links bridge the distance between their outer joints: `limit.rs` of the
// Rust crate, step by step.
//
// An answer is a distance in metres, by which they cannot, or one of these words.
const MEETS = "meets", AT_LIMIT = "at the limit", COINCIDENT = "coincident", NOT_FINITE = "not finite";

/// An error of a value in ε of its spread, and a distance by which a pose may miss assembly, in units in the
/// last place of its longest length.
const ROUNDINGS = 16, ULPS = 4;
/// Above this a sum of two words has the sign of the exact one.
const TWO_WORDS = 2 ** -40;

/// 2ᵏ for −1023 ≤ k ≤ 1023.
const powerOfTwo = (k) => (k < -1022 ? SMALLEST_NORMAL / 2 : fromBits((k + 1023) << 20));

/// A power of two that brings the largest of some finite numbers between 1 and 2.
const scaleOf = (numbers) => {
  if (!numbers.every(isFinite)) return null;
  const exponent = Math.max((highBits(Math.max(...numbers.map(Math.abs))) >>> 20) & 0x7ff, 1) - 1023;
  const down = powerOfTwo(-exponent), up = powerOfTwo(exponent);
  return {
    down: (x) => x * down,
    up: (x) => Math.min(x * up, Number.MAX_VALUE),
    ulp: (x) => Math.max(fromBits(highBits(x) & 0x7ff00000) * EPSILON, Number.MIN_VALUE * down),
  };
};

const distance = ([dx, dy]) => Math.sqrt(dx * dx + dy * dy);
const exactProducts = (products) => exactSum(products.flatMap(([x, y]) => [x * y, mulErr(x, y)]));

/// dx² + dy² − (a + b + w)², with the sign of the exact value.
const excessWith = ([dx, dy], [a, b, w]) =>
  exactProducts([[dx, dx], [dy, dy], [-a, a], [-b, b], [-w, w], [-2 * a, b], [-2 * a, w], [-2 * b, w]]);

/// The same for w = 0: in two words, and without rounding next to a limit.
const excess = ([dx, dy], [a, b]) => {
  const span = a + b, rest = addErr(a, b);
  const [dx2, dy2, span2] = [dx * dx, dy * dy, span * span];
  const square = dx2 + dy2, high = square - span2;
  const products = mulErr(dx, dx) + mulErr(dy, dy) - mulErr(span, span) - rest * (2 * span);
  const value = high + (products + (addErr(dx2, dy2) + addErr(square, -span2)));
  return Math.abs(value) > TWO_WORDS ? value : excessWith([dx, dy], [a, b, 0]);
};

/// The lengths in their scale, all positive.
const scaled = (dx, dy, l1, l2) => {
  const scale = scaleOf([dx, dy, l1, l2]);
  if (!scale) return null;
  [dx, dy, l1, l2] = [dx, dy, l1, l2].map((x) => Math.abs(scale.down(x)));
  return { scale, d: [dx, dy], l1, l2, long: Math.max(l1, l2), short: Math.min(l1, l2) };
};

/// Decides if points d apart are at least `long` − `short` ≥ 0 apart.
const tooClose = (d, [long, short], slack, scale) => {
  const gap = long - short, missing = -excess(d, [long, -short]);
  const isClear = missing > 2 * (2 * gap * slack);
  const byRoundingOnly = () =>
    exactSum([long, -short, -slack]) <= 0 || excessWith(d, [long, -short, -slack]) >= 0;
  if (missing > 0 && (isClear || !byRoundingOnly())) return scale.up(missing / (distance(d) + gap));
  if (d[0] === 0 && d[1] === 0) return COINCIDENT;
  return missing > 0 ? AT_LIMIT : MEETS;
};

/// Decides if circles of radii |l1| and |l2| about points (dx, dy) apart meet.
const reachOfCircles = (...given) => {
  const lengths = scaled(...given);
  if (!lengths) return NOT_FINITE;
  const { scale, d, long, short } = lengths;
  const apart = distance(d), slack = ULPS * scale.ulp(Math.max(apart, long)), span = long + short;
  const missing = excess(d, [long, short]);
  if (missing <= 0) return tooClose(d, [long, short], slack, scale);
  const isClear = missing > 2 * (slack * (2 * span + slack));
  return !isClear && excessWith(d, [long, short, slack]) <= 0 ? AT_LIMIT : scale.up(missing / (apart + span));
};

/// Decides if (bx, by) is at least |e| long.
const reachOfOffset = (bx, by, e) => {
  const scale = scaleOf([bx, by, e]);
  if (!scale) return NOT_FINITE;
  [bx, by, e] = [bx, by, e].map((x) => Math.abs(scale.down(x)));
  return tooClose([bx, by], [e, 0], ULPS * scale.ulp(Math.max(distance([bx, by]), e)), scale);
};

/// Decides if |t| ≤ |l|.
const reachOfLine = (t, l) => {
  const scale = scaleOf([t, l]);
  if (!scale) return NOT_FINITE;
  [t, l] = [t, l].map((x) => Math.abs(scale.down(x)));
  const slack = ULPS * scale.ulp(Math.max(t, l));
  if (t <= l) return MEETS;
  return exactSum([t, -l, -slack]) <= 0 ? AT_LIMIT : scale.up(t - l);
};

/// (d² − (l₁ − l₂)²) ((l₁ + l₂)² − d²) / (4 l₁ l₂)², with the sign of the exact value.
const heightProduct = (...given) => {
  const lengths = scaled(...given);
  if (!lengths) return NaN;
  const { d, long, short } = lengths, four = 4 * long * short;
  return (-excess(d, [long, short]) / four) * (excess(d, [long, -short]) / four);
};

/// (d² + l₁² − l₂²)/2d²: where the foot of the joint stands between the centres.
const foot = (...given) => {
  const lengths = scaled(...given);
  if (!lengths) return NaN;
  const { d: [dx, dy], l1, l2 } = lengths;
  return exactProducts([[dx, dx], [dy, dy], [l1, l1], [-l2, l2]]) / (2 * (dx * dx + dy * dy));
};

/// The same for a joint on the line of centres.
const footOnLine = (dx, dy, l1, l2) => {
  const scale = scaleOf([dx, dy, l1, l2]);
  if (!scale) return NaN;
  const share = Math.abs(scale.down(l1)) / distance([scale.down(dx), scale.down(dy)]);
  return foot(dx, dy, l1, l2) < 0 ? -share : share;
};
