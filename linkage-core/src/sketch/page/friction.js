// Amounts of friction that depend on each other: `friction.rs` of the Rust crate, step by step.
//
// A row holds a share, both components of the reaction without friction, and of its change by each amount.

/// Newton's steps of the fast path, those before steps are guarded, and the guarded ones.
const AT_ONCE = 3, UNGUARDED = 8, GUARDED = 64;

const signOf = (x) => (x >= 0 ? 1 : -1);

/// The identity less a matrix, in its place.
const without = (matrix) => {
  matrix.forEach((row, j) => {
    for (let k = 0; k < row.length; k++) row[k] = j === k ? 1 - row[k] : -row[k];
  });
  return matrix;
};

/// Clears a column below its pivot, in the right side as well, and puts the pivot's inverse in its place.
const eliminate = (matrix, right, k) => {
  const top = matrix[k], inverse = 1 / top[k];
  for (let j = k + 1; j < matrix.length; j++) {
    const factor = -(matrix[j][k] * inverse);
    for (let i = k + 1; i < matrix.length; i++) matrix[j][i] = fused(factor, top[i], matrix[j][i]);
    right[j] = fused(factor, right[k], right[j]);
  }
  top[k] = inverse;
};

/// The solution of a system whose elimination needs no exchanges, in the place of the right side.
const solution = (matrix, right) => {
  const count = matrix.length;
  for (let k = 0; k < count; k++) eliminate(matrix, right, k);
  for (let k = count - 1; k >= 0; k--) {
    for (let j = k + 1; j < count; j++) right[k] = fused(-matrix[k][j], right[j], right[k]);
    right[k] *= matrix[k][k];
  }
  return right;
};

/// Equations of amounts. Bit j of `guides` is set if contact j is a guide. Loops: a curve asks for thousands.
class System {
  constructor(rows, guides) {
    const isGuide = rows.map((_, j) => ((guides >> j) & 1) === 1);
    Object.assign(this, { rows, isGuide, none: rows.map(() => 0) });
    this.bounds = rows.map((row, j) => rows.map((_, k) => {
      const [x, y] = row.slice(3 + 2 * k), [across, along] = [magnitude(x), magnitude(y)];
      return row[0] * (isGuide[j] ? (across >= along ? across : along) : sqrt(fused(x, x, y * y)));
    }));
  }

  /// The values of all equations, and their slopes; at a corner those of one side.
  linear(amounts, length) {
    const values = [], slope = [], count = amounts.length;
    for (let j = 0; j < count; j++) {
      const row = this.rows[j], share = row[0];
      // Changes come first: contacts that a couple loads alike share their sum.
      let x = row[3] * amounts[0], y = row[4] * amounts[0];
      for (let k = 1; k < count; k++) {
        x = fused(row[3 + 2 * k], amounts[k], x);
        y = fused(row[4 + 2 * k], amounts[k], y);
      }
      x = row[1] + x;
      y = row[2] + y;
      if (this.isGuide[j]) {
        const isFirst = magnitude(x) >= magnitude(y);
        values.push(share * magnitude(isFirst ? x : y));
        [x, y] = isFirst ? [signOf(x), 0] : [0, signOf(y)];
      } else {
        const size = length(x, y), inverse = 0 >= size ? 0 : 1 / size;
        values.push(share * size);
        [x, y] = [x * inverse, y * inverse];
      }
      x *= share;
      y *= share;
      const own = [];
      for (let k = 0; k < count; k++) own.push(fused(row[3 + 2 * k], x, row[4 + 2 * k] * y));
      slope.push(own);
    }
    return { values, slope };
  }

  /// Newton's step from these amounts, which takes the slope's place.
  newton(amounts, { values, slope }) {
    const step = solution(without(slope), values.map((value, j) => value - amounts[j]));
    return amounts.map((x, j) => x + step[j]);
  }

  /// True where amounts solve the equations as far as rounding can tell.
  isSettled(amounts, { values }, start) {
    return amounts.every((x, j) => {
      const size = amounts.reduce((size, other, k) => fused(this.bounds[j][k], other, size), start[j]);
      return magnitude(values[j] - x) <= 4 * EPSILON * size;
    });
  }

  lessBounds() {
    return without(this.bounds.map((row) => [...row]));
  }

  /// The first contact at which friction may hold itself, −1 if there is none: whose pivot is not positive.
  jammed() {
    const matrix = this.lessBounds(), right = [...this.none];
    return matrix.findIndex((row, k) => {
      const isMet = row[k] > 0;
      eliminate(matrix, right, k);
      return !isMet;
    });
  }

  /// As many steps as the fast path takes; nothing where they do not end.
  atOnce(start) {
    let amounts = start, isMet = true;
    const near = (x, y) => {
      const square = fused(x, x, y * y);
      isMet &&= square >= SMALLEST_SQUARE && square <= Number.MAX_VALUE;
      return sqrt(square);
    };
    for (let step = 0; step <= AT_ONCE; step++) {
      const linear = this.linear(amounts, near);
      if (step === AT_ONCE) isMet &&= this.jammed() < 0 && this.isSettled(amounts, linear, start);
      amounts = this.newton(amounts, linear);
    }
    return isMet && amounts.every(isFinite) ? amounts : null;
  }

  /// The only solution, or the contact at which friction may hold itself.
  solved() {
    const jams = this.jammed();
    if (jams >= 0) return jams;
    const { values: start } = this.linear(this.none, hypot);
    let amounts = start;
    for (let step = 0; step <= UNGUARDED; step++) {
      const linear = this.linear(amounts, hypot);
      if (this.isSettled(amounts, linear, start)) return amounts;
      amounts = this.newton(amounts, linear);
    }
    return this.guarded(start) ?? 0;
  }

  /// Newton's steps, each replaced by the equations' values where it gains less than those.
  guarded(start) {
    const units = start.map((x, j) => {
      const size = x + start.reduce((sum, other, k) => sum + this.bounds[j][k] * other, 0);
      return size > 0 ? size : 1;
    });
    const weights = solution(this.lessBounds(), [...units]);
    const largest = (of) => start.reduce((most, _, j) => greater(of(j), most), 0);
    const gain = largest((j) => 1 - units[j] / weights[j]);
    const off = (amounts, { values }) => largest((j) => magnitude(values[j] - amounts[j]) / weights[j]);
    let amounts = start, linear = this.linear(start, hypot);
    for (let step = 0; step <= GUARDED; step++) {
      if (this.isSettled(amounts, linear, start)) return amounts;
      const next = this.newton(amounts, linear);
      amounts = off(next, this.linear(next, hypot)) <= gain * off(amounts, linear) ? next : linear.values;
      linear = this.linear(amounts, hypot);
    }
    return null;
  }
}

/// The solution: that which straight-line code has `found` on the fast path, if the numbers that are to be above zero
/// are, and the first of each small pair is less than the rounding of the second; or by steps from `start`. Behind a
/// condition that is not met these values themselves.
const amountsOf = (checks, start, rows, guides, joints, found, positive, small) => {
  if (checks.error) return start;
  if (found && checks.isFast) {
    checks.hasFastValues = true;
    const isMet = positive.every((x) => x > 0) && small.every(([less, more]) => 4 * EPSILON * more > less);
    if (isMet && found.every(isFinite)) return found;
    checks.leave();
  }
  const lost = rows.findIndex((row) => !row.every(isFinite));
  if (lost >= 0) {
    checks.refuse("NotFinite", joints[lost]);
    return start;
  }
  const system = new System(rows, guides), amounts = system.atOnce(start);
  if (amounts) return amounts;
  checks.leave();
  const solved = system.solved();
  if (Array.isArray(solved)) return solved;
  checks.refuse("Jams", joints[solved]);
  return start;
};

REASONS.Jams = ({ group }) => `${group}: friction may hold itself here`;
