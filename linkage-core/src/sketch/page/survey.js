// A look at all of an interval, where its ends alone do not enclose a root: `survey.rs` of the Rust crate.

/// The cubic through values and slopes of two places, by the part of the way from one to the other.
const cubicThrough = ([a, b]) => {
  const width = b.x - a.x, [d0, d1] = [a.slope * width, b.slope * width], rise = b.value - a.value;
  const p = d0 + d1 - 2 * rise, q = 3 * rise - 2 * d0 - d1, third = 1 / 3;
  return {
    at: (part) => ((p * part + q) * part + d0) * part + a.value,
    slopeAt: (part) => (3 * p * part + 2 * q) * part + d0,
    turningPart: () => -d0 / (q + Math.sqrt(q * q - 3 * p * d0)),
    valuesWithin: () => [a.value, a.value + d0 * third, b.value - d1 * third, b.value],
    slopesWithin: () => [d0, d0 + q, d1],
    curvatures: () => [2 * q, 2 * q + 6 * p],
  };
};

/// The most samples, the widest piece that is believed to be what its cubic is, as a part of the interval, and
/// how many times as large as a cubic's error that of its slope and of its curvature may be.
const MOST_SAMPLES = 48, WIDEST = 0.125, SLOPE_ERROR = 3.1, CURVATURE_ERROR = 32;

/// A piece between two samples; `error` is a bound on that of its cubic.
class Open {
  constructor(ends, error) {
    Object.assign(this, { ends, error, cubic: cubicThrough(ends) });
  }

  /// A bound on the errors of both halves' cubics, from the sample in the middle.
  remainderOfHalves(at) {
    const [a, b] = this.ends, off = magnitude(this.cubic.at(0.5) - at.value);
    return off + magnitude(this.cubic.slopeAt(0.5) - at.slope * (b.x - a.x)) * 0.25;
  }

  /// True if the function is known not to rise through zero here.
  isClear() {
    const [a, b] = this.ends;
    const error = this.error + greater(magnitude(a.value), magnitude(b.value)) * (4 * EPSILON);
    const above = (least, numbers) => numbers.every((x) => x > least);
    const below = (least, numbers) => numbers.every((x) => -least > x);
    const values = this.cubic.valuesWithin();
    if (above(error, values) || below(error, values)) return true;
    const slopes = this.cubic.slopesWithin(), least = error * SLOPE_ERROR, ends = [a.value, b.value];
    if (below(least, slopes) || (above(least, slopes) && (above(0, ends) || below(0, ends)))) return true;
    const sign = this.bends();
    return !!sign && (0 > sign * a.value || 0 > sign * b.value || !this.turns(sign));
  }

  /// Which way it bends throughout, 1 for a dip and −1 for a hump; 0 where that is not one way.
  bends() {
    const least = this.error * CURVATURE_ERROR, [first, second] = this.cubic.curvatures();
    return first > least && second > least ? 1 : -least > first && -least > second ? -1 : 0;
  }

  turns(sign) {
    const [a, b] = this.ends;
    return 0 > sign * a.slope && sign * b.slope > 0;
  }

  /// The dip or the hump that is all there is.
  onlyTurn() {
    const sign = this.bends();
    return sign && this.turns(sign) ? sign : 0;
  }
}

/// Samples in order, each with the piece up to the next.
class Samples {
  pieces = [];

  constructor(places) {
    const piece = (from) => ({ from, error: NaN, isClear: false });
    this.widestBelieved = (places.at(-1).x - places[0].x) * (WIDEST * (1 + 4 * EPSILON));
    this.pieces.push(piece(places[0]));
    for (const place of places) {
      if (place.x > this.pieces.at(-1).from.x) this.insert(this.pieces.length - 1, piece(place));
    }
  }

  /// Divides the piece of this index: both parts are known as well as the new one.
  insert(index, added) {
    const { pieces } = this;
    pieces.splice(index + 1, 0, added);
    Object.assign(pieces[index], { error: added.error, isClear: added.isClear });
    for (const k of [index + 1, index]) {
      if (k + 1 >= pieces.length) continue;
      const ends = this.ends(k);
      pieces[k].isClear ||= this.isNarrow(ends) && new Open(ends, pieces[k].error).isClear();
    }
  }

  ends(k) {
    return [this.pieces[k].from, this.pieces[k + 1].from];
  }

  isNarrow([a, b]) {
    return this.widestBelieved >= b.x - a.x;
  }

  /// The index of the widest piece that is not clear.
  widest() {
    let found = -1, most = 0;
    for (let k = 0; k + 1 < this.pieces.length; k++) {
      const [a, b] = this.ends(k), width = b.x - a.x;
      if (!this.pieces[k].isClear && (found < 0 || width > most)) [found, most] = [k, width];
    }
    return found;
  }

  /// Two samples between which the function, times `sign`, rises through zero, or twice the one at which it does.
  crossing(sign) {
    let low = null;
    for (const { from } of this.pieces) {
      const { value, slope } = signed(sign, from);
      if (value === 0 && slope > 0) return [from, from];
      if (low && value > 0) return [low, from];
      if (0 > value) low = from;
    }
    return null;
  }

  /// The dip or the hump that comes nearest to zero by its cubic, and which it is.
  nearest() {
    let nearest = null;
    for (let k = 0; k + 1 < this.pieces.length; k++) {
      const ends = this.ends(k), sign = ends[0].value > 0 ? 1 : -1, both = ends.map((at) => signed(sign, at));
      const [a, b] = both, cubic = cubicThrough(both), least = cubic.at(cubic.turningPart());
      const isTurn = 0 > a.slope && b.slope > 0 && b.value > 0;
      if (isTurn && (!nearest || nearest.least > least)) nearest = { ends, sign, least };
    }
    return nearest;
  }
}

/// The lowest point of a dip (`sign` 1), or the highest of a hump (−1), or the first place beyond zero.
const extreme = (f, ends, sign, most) => {
  const turn = (at) => signed(sign, at), spared = Math.min(MOST_TO_A_DEAD_POINT, Math.max(most - 1, 0));
  return turn(lowest(ends.map(turn), 0, spared, (x) => turn(f.at(x))));
};

/// The course of a function between the first and the last of some places, by at most so many evaluations: two
/// places between which it `rises` through zero, a place where it is `zero`, or that it does neither, with the
/// dead point that comes nearest and where it is `falling` through zero.
const courseOf = (f, places, most) => {
  const samples = new Samples(places), end = f.evaluations + most, unknown = { isKnown: false };
  const left = () => Math.max(end - f.evaluations, 0);
  for (;;) {
    const rises = samples.crossing(1);
    if (rises) return rises[0] === rises[1] ? { zero: rises[0] } : { rises };
    const index = samples.widest();
    if (index < 0) break;
    if (left() === 0 || samples.pieces.length === MOST_SAMPLES) return unknown;
    const ends = samples.ends(index), open = new Open(ends, samples.pieces[index].error), sign = open.onlyTurn();
    if (sign && samples.isNarrow(ends)) {
      const at = extreme(f, ends, sign, left());
      if (at.value === 0) return { zero: at };
      samples.insert(index, { from: at, error: 0, isClear: true });
      continue;
    }
    const [a, b] = ends, x = middle(a.x, b.x);
    if (!(x > a.x && b.x > x)) {
      samples.pieces[index].isClear = true;
      continue;
    }
    const at = f.at(x);
    samples.insert(index, { from: at, error: open.remainderOfHalves(at), isClear: false });
  }
  const turn = samples.nearest(), nearest = turn && left() > 1 ? extreme(f, turn.ends, turn.sign, left()) : null;
  // The cubic that had shown the contrary was wrong.
  if (nearest && 0 > turn.sign * nearest.value) return unknown;
  return { isKnown: true, nearest, falling: samples.crossing(-1) };
};
