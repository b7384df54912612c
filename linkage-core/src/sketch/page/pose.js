// Poses of the mechanism: what its formulas give, read by its plan, and what of it stands.

const { inputs, params, loads } = PAGE;

/// The reader's choices. `axis` is the input that curves are drawn over, and that moves at `rate`.
const state = {
  q: inputs.map((input) => input.at),
  p: params.map((param) => param.value),
  l: loads.map((load) => load.value),
  axis: 0,
  rate: inputs[0].rate,
};

const LINKS = 2 * PLAN.points.length, GUIDES = LINKS + 5 * PLAN.links.length;
const DIMENSIONS = GUIDES + 4 * PLAN.guides.length;
const DIMENSIONS_OF = { "body": 0, "sleeve": 0, "bar": 1, "cylinder": 1, "block": 1, "slotted_bar": 1, "yoke": 2 };

/// The statements, each with its title in errors, where its dimensions begin, and what it makes.
const statements = (() => {
  let first = DIMENSIONS;
  return PLAN.statements.map((made) => {
    const members = (made.members ?? []).map((member) => {
      const own = { ...member, first };
      first += DIMENSIONS_OF[member.shape];
      return own;
    });
    const names = members.map(({ link }) => PLAN.links[link]);
    const title = made.point !== undefined && made.on === null ? PLAN.points[made.point] : names.join(", ");
    return { ...made, members, title, makes: made.ground ?? made.point ?? made.pin ?? null };
  });
})();

/// The points of each link.
const joints = PLAN.links.map((_, link) => {
  const of = statements.flatMap(({ members, point, on, pin }) => {
    if (point !== undefined) return on === link ? [point] : [];
    const own = members.filter((member) => member.link === link);
    return own.flatMap(({ pivot }) => [pivot, pin]);
  });
  return [...new Set(of.filter((point) => point !== undefined && point !== null))];
});
const grounds = new Set(statements.flatMap(({ ground }) => (ground === undefined ? [] : [ground])));

/// The name of the part that a number of a pose belongs to.
const nameOfPlace = (place) =>
  place < LINKS ? PLAN.points[place >> 1]
  : place < GUIDES ? PLAN.links[floor((place - LINKS) / 5)]
  : place < DIMENSIONS ? PLAN.guides[(place - GUIDES) >> 2]
  : PLAN.name;

/// Everything that stands at some inputs, and the reason why not all of it does.
class Pose {
  constructor(q) {
    this.q = q;
    assign(this, MACHINE.place(state.p, q));
    this.gone = this.error && this.#gone();
  }

  /// The failed statement's parts, those that depend on them, and what is not finite.
  #gone() {
    const gone = { points: new Set(), links: new Set(), guides: new Set() };
    const isLost = (from, count) => !this.numbers.slice(from, from + count).every(isFinite);
    this.failed = statements.find(({ title }) => title && title === this.error.group);
    for (const made of statements) {
      const { members, makes, guide, on } = made;
      let falls = made === this.failed || gone.links.has(on)
        || members.some((member) => gone.points.has(member.pivot) || gone.guides.has(member.guide));
      for (const { link } of members) if (falls || isLost(LINKS + 5 * link, 5)) gone.links.add(link);
      falls ||= members.some(({ link }) => gone.links.has(link));
      if (makes !== null && (falls || isLost(2 * makes, 2))) gone.points.add(makes);
      if (guide !== undefined && (falls || isLost(GUIDES + 4 * guide, 4))) gone.guides.add(guide);
    }
    return gone;
  }

  #frame(at) {
    const [x, y, cos, sin, slide] = this.numbers.slice(at, at + 5);
    return { at: [x, y], cos, sin, slide };
  }

  point(point) {
    return this.gone?.points.has(point) ? null : [this.numbers[2 * point], this.numbers[2 * point + 1]];
  }

  link(link) {
    return this.gone?.links.has(link) ? null : this.#frame(LINKS + 5 * link);
  }

  guide(guide) {
    return this.gone?.guides.has(guide) ? null : this.#frame(GUIDES + 4 * guide);
  }

  /// A length or an offset of a member, known also where its group cannot be assembled.
  dimension(member, nth = 0) {
    return this.numbers[member.first + nth];
  }
}

/// A place of a frame, in ground axes, and the other way round.
const placed = ({ at, cos, sin }, [x, y]) => [at[0] + cos * x - sin * y, at[1] + sin * x + cos * y];
const seenFrom = ({ at, cos, sin }, [x, y]) => {
  const [dx, dy] = [x - at[0], y - at[1]];
  return [cos * dx + sin * dy, cos * dy - sin * dx];
};

// ---- motions and forces -----------------------------------------------------------------------------

const atRest = inputs.map(() => 0);
/// The rates and accelerations of all inputs while the machine runs by itself; nothing where they are given.
let running = null;
const rates = () => running?.v ?? inputs.map((_, k) => (k === state.axis ? state.rate : 0));

/// Outputs, forces at constant rate, the drives between which friction holds the machine at rest and the loads that are
/// applied, where they are there, and the first reason why outputs or forces are not.
const answersAt = (pose) => {
  const { q, error } = pose, found = { pose, refused: error };
  for (const name of ["motion", "forces", "holding", "applied", "marked"]) {
    const { numbers, error: own } = (!error && MACHINE[name]?.(state.p, q, rates(), running?.a ?? atRest, state.l, atRest)) || {};
    // A wheel without a size leaves the other marks.
    found[name] = own && (name !== "marked" || own.kind !== "NotFinite") ? null : numbers;
    if (name === "motion" || name === "forces") found.refused ??= own;
  }
  return found;
};

/// How many numbers each kind of output has, as a position and as a rate, and its scalar rows.
const KINDS = {
  "point": { numbers: [2, 2], rows: ["x", "y"] },
  "direction": { numbers: [2, 1], rows: ["angle"] },
  "sliding": { numbers: [3, 2], rows: ["angle", "slide"] },
  "slide": { numbers: [1, 1], rows: ["slide"] },
  "value": { numbers: [1, 1], rows: [""] },
};

/// The scalar rows of all outputs: the places of position, velocity and acceleration among a motion's numbers.
const rows = (() => {
  const count = (of) => MACHINE.outputs.reduce((sum, { kind }) => sum + KINDS[kind].numbers[of], 0);
  let [position, rate] = [0, count(0)];
  const found = MACHINE.outputs.flatMap(({ name, title = name, kind, unit }) => {
    const { numbers, rows } = KINDS[kind], isTurning = numbers[0] > numbers[1];
    const own = rows.map((row, k) => ({
      output: name,
      title,
      row,
      label: row ? `${title}.${row}` : title,
      scales: [],
      isAngle: row === "angle",
      unit: row === "angle" ? "rad" : row ? "m" : unit,
      at: [position + k + (isTurning && k > 0 ? 1 : 0), rate + k, rate + k + count(1)],
    }));
    position += numbers[0];
    rate += numbers[1];
    return own;
  });
  return found;
})();

/// A row's value of this order, in SI units.
const valueOf = (row, order, motion) =>
  row.isAngle && order === 0 ? atan2(motion[row.at[0] + 1], motion[row.at[0]]) : motion[row.at[order]];

/// The scalar rows of forces, in the order of their numbers.
const efforts = MACHINE.efforts.flatMap(({ name, rows, units, point }) =>
  rows.map((row, k) => ({ effort: name, row, label: row ? `${name}.${row}` : name, unit: units[k], point, scales: [] })));

// ---- words ------------------------------------------------------------------------------------------

/// An input in words. One that turns has no more than a turn; any other has the number of its axis.
const inputWords = (k, x = state.q[k]) => {
  const { turns, unit, from, to } = inputs[k];
  return inScale(turns ? turnedInto(x, from, to) : x, shownIn(unit, 0, max(abs(from), abs(to))));
};

/// An angle by whole turns into a range of one; both ends stay what they are, as sliders round them.
const turnedInto = (x, from, to) => (x >= from - 1e-9 && x <= to + 1e-9 ? x : from + wrapped(x - from));

/// The reason why a pose cannot be used, as the Rust crate's errors say it.
const why = (error) => {
  const { kind, group, by, name } = error, own = REASONS[kind]?.(error);
  if (own) return own;
  if (kind === "OutOfReach") return `${group} cannot be assembled: ${words(by, "m")} are missing`;
  const isSpring = group.startsWith("spring ");
  if (kind === "Singular") return `${group}: ${isSpring || group.startsWith("force ") ? "its ends meet, and it has no direction" : "undefined in this pose, at a limit or a dead point"}`;
  if (kind === "NotFinite") return `${group} leads to a result that is not finite`;
  const mayBeZero = isSpring || /^(mass on|inertia on|friction at) /.test(name);
  return `${group}: ${name} must ${mayBeZero ? "not be negative" : "be greater than zero"}`;
};
