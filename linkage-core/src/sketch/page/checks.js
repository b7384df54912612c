// The conditions that formulas are under, as the Rust crate's slow path decides them.

/// Words for the reasons that some machines alone know, by their kinds.
const REASONS = {
  NotCertified: ({ group }) => `${group}: not certified here, beyond the stretch that was followed`,
};

/// The part of an equation's size by which its sides may differ, and the name of ends that are in order.
const OPEN = 2 ** -20, ENDS = "ends of between";

/// Keeps the first condition that is not met, and lets values go on: behind a group that cannot be assembled
/// they are roots of negative numbers, which are no numbers.
class FirstError {
  error = null;
  /// The reason if no other condition fails: an equation was not a number.
  otherwise = null;
  /// The unknown that counts as not found, where only what stands without it is asked for.
  without = null;
  /// The roots of unknowns, each with the numbers that it was searched by.
  roots = {};
  /// True if the numbers are those of the fast path, if some are its alone, and if that has been left.
  isFast = true;
  hasFastValues = false;
  hasLeft = false;

  /// The reason why the numbers are not to be used, if there is one.
  get reason() {
    return this.error ?? this.otherwise;
  }

  /// Leaves the fast path: the slow one computes all numbers anew.
  leave() {
    this.hasLeft = true;
  }

  /// Sine and cosine of an angle.
  sinCos(x) {
    if (!isNear(x)) this.leave();
    return sinCos(x);
  }

  /// The root of the squares, where their sum is in range.
  length(x, y, least) {
    const square = fused(x, x, y * y), isInRange = square >= least && square <= Number.MAX_VALUE;
    if (!isInRange) this.leave();
    this.hasFastValues = true;
    return this.isFast && isInRange ? sqrt(square) : hypot(x, y);
  }

  /// Keeps the first refusal.
  refuse(kind, group, more) {
    this.error ??= { kind, group, ...more };
  }

  isCertain(value, spread) {
    const isIt = isFinite(value) && value > ROUNDINGS * EPSILON * spread;
    if (!isIt) this.leave();
    return isIt;
  }

  /// The value that goes with the answer of a decision.
  reached(value, reach, group) {
    if (typeof reach === "number") this.refuse("OutOfReach", group, { by: reach });
    else if (reach === NOT_FINITE || (reach === MEETS && !isFinite(value))) this.refuse("NotFinite", group);
    else if (reach === COINCIDENT) this.refuse("Singular", group);
    else return reach === MEETS && value > 0 ? value : 0;
    return value;
  }

  /// Circles of radii l1 and l2 about points d apart meet; the value is the product of both limits in squares
  /// of a unit.
  ReachCircles(value, dx, dy, l1, l2, unit, spread, group) {
    if (this.error || this.isCertain(value, spread)) return value;
    const reach = reachOfCircles(dx, dy, l1, l2);
    if ((reach === MEETS || reach === AT_LIMIT) && !(4 * l1 * l2 >= SMALLEST_NORMAL)) {
      this.refuse("NotFinite", group);
      return value;
    }
    if (reach === MEETS) value = restored(value, heightProduct(dx, dy, l1, l2) * unit * unit);
    return this.reached(value, reach, group);
  }

  /// The share of the line of centres at which the joint's foot stands.
  ShareOfCentres(value, height, dx, dy, l1, l2, spread) {
    if (this.error || this.isCertain(height, spread)) return value;
    const reach = reachOfCircles(dx, dy, l1, l2);
    if (reach === MEETS) return restored(value, foot(dx, dy, l1, l2));
    return reach === AT_LIMIT ? restored(value, footOnLine(dx, dy, l1, l2)) : value;
  }

  /// A point at distances r1 and r2 from two joints l apart; the value is the square of its height.
  ReachDistances(value, l, r1, r2, spread, group) {
    if (this.error || this.isCertain(value, spread)) return value;
    const reach = reachOfCircles(l, 0, r1, r2);
    if (reach === MEETS) {
      const height = 2 * r1 * (r2 / l), product = heightProduct(l, 0, r1, r2);
      const square = product * height * height;
      if (product > 0 && square < SMALLEST_NORMAL) {
        this.refuse("NotFinite", group);
        return value;
      }
      value = restored(value, square);
    }
    return this.reached(value, reach, group);
  }

  /// |t| ≤ l; the value is (l − t)(l + t).
  ReachLine(value, t, l, group) {
    if (this.error) return value;
    const reach = reachOfLine(t, l), hasRoom = l * l >= SMALLEST_SQUARE;
    if (reach === MEETS && Math.abs(t) < Math.abs(l) && !hasRoom && value < SMALLEST_NORMAL) {
      this.refuse("NotFinite", group);
      return value;
    }
    return this.reached(value, reach, group);
  }

  /// |e| ≤ |(bx, by)|; the value is bx² + by² − e².
  ReachOffset(value, bx, by, e, group) {
    return this.error ? value : this.reached(value, reachOfOffset(bx, by, e), group);
  }

  /// A squared length that something is divided by.
  Square(value, group) {
    if (value === 0) this.refuse("Singular", group);
    else if (!(isFinite(value) && value >= SMALLEST_SQUARE)) this.refuse("NotFinite", group);
    return value;
  }

  /// The same of the distance of circles' centres.
  SquareOfCentres(value, dx, dy, l1, l2, group) {
    // `ReachCircles` tells whether circles about centres that far apart meet.
    if (this.error || (isFinite(value) && value >= SMALLEST_SQUARE)) return value;
    const reach = reachOfCircles(dx, dy, l1, l2);
    if (typeof reach === "number") this.refuse("OutOfReach", group, { by: reach });
    else if (reach === COINCIDENT) this.refuse("Singular", group);
    return this.Square(value, group);
  }

  /// The root of an unknown's equation, of sides in this unit, and the size that its rounding is measured by, as
  /// `find` has it by these parameters and numbers.
  /// Where the equation was not a number the formulas go on with that trial, and find the group that cannot be
  /// assembled there.
  root(find, p, given, unknown, unit) {
    const last = this.roots[unknown], isKnown = last?.given.every((x, k) => Object.is(x, given[k]));
    const found = isKnown ? last.found : find(p, given), { kind, at, by, other, isOrdered } = found;
    this.roots[unknown] = { given, found };
    if (this.without) return kind || unknown === this.without ? [NaN, NaN] : found;
    if (!kind) return found;
    if (kind === "Interval") this.refuse("Invalid", unknown, { name: isOrdered ? ENDS : "width of between" });
    else if (kind === "NoSolution") this.refuse(kind, unknown, { by, unit, other });
    else if (kind === "NotFinite") this.otherwise ??= { kind, group: unknown };
    else this.refuse(kind, unknown);
    return [at ?? 0, 0];
  }

  /// An equation's left − right in the final pose, whose sides are of this size: none but a jump's is so large.
  Closed(difference, size, unknown, unit) {
    if (this.without || this.otherwise) return;
    if (!isFinite(difference)) this.refuse("NotFinite", unknown);
    else if (!(Math.abs(difference) <= OPEN * size)) this.refuse("NoSolution", unknown, { by: Math.abs(difference), unit });
  }

  /// The slope of an equation at its root.
  Moving(value, spread, group) {
    if (Number.isNaN(value)) this.refuse("NotFinite", group);
    else if (!(value > ROUNDINGS * EPSILON * spread)) this.refuse("Singular", group);
    return value;
  }

  /// How far the start of Newton's method is below the limit of its certificate.
  Certified(value, group) {
    if (Number.isNaN(value)) this.refuse("NotFinite", group);
    else if (!(value > 0)) this.refuse("NotCertified", group);
    return value;
  }

  Nonzero(value, group) {
    if (Number.isNaN(value)) this.refuse("NotFinite", group);
    else if (value === 0) this.refuse("Singular", group);
    return value;
  }

  /// A length that has to be greater than zero.
  Positive(value, group, name) {
    if (Number.isNaN(value)) this.refuse("NotFinite", name);
    else if (!(value > 0)) this.refuse("Invalid", group, { name });
    return value;
  }

  /// A mass or a spring's number.
  NotNegative(value, group, name) {
    if (Number.isNaN(value)) this.refuse("NotFinite", name);
    else if (!(value >= 0)) this.refuse("Invalid", group, { name });
    return value;
  }
}

/// The rounded value's replacement, added as the Rust crate adds it.
const restored = (value, exact) => value - value + exact;

/// Runs formulas on numbers that must be finite, `given` with their names, and asks for finite results.
/// Returns the numbers and the reason why they are not to be used, if there is one.
const solved = (given, formulas, nameOf) => {
  const begun = (more) => {
    const checks = Object.assign(new FirstError(), more);
    for (const [value, name] of given) if (!isFinite(value)) checks.refuse("NotFinite", name);
    return checks;
  };
  let checks = begun(), numbers = formulas(checks);
  const { hasLeft, hasFastValues, roots, reason } = checks;
  // The slow path decides every refusal.
  if (hasFastValues && (hasLeft || reason || !numbers.every(isFinite))) {
    checks = begun({ isFast: false, roots });
    numbers = formulas(checks);
  }
  if (!checks.reason) {
    const lost = numbers.findIndex((number) => !isFinite(number));
    if (lost >= 0) checks.refuse("NotFinite", blamed(given, nameOf(lost)));
  }
  const error = checks.reason, isSearched = error && Object.keys(roots).length;
  // A trial at which a search ended is no place of the machine.
  return { numbers: isSearched ? formulas(standing(error, checks)) : numbers, error };
};

/// Conditions of what stands in spite of an error.
const standing = (error, { roots, isFast }) =>
  Object.assign(new FirstError(), { error, without: error.group, roots, isFast });

/// The largest given number whose fourth power is infinite, or the result's own name.
const blamed = (given, name) => {
  let most = 0;
  for (const [value, of] of given) {
    const square = value * value;
    if (!isFinite(square * square) && Math.abs(value) > most) [most, name] = [Math.abs(value), of];
  }
  return name;
};
