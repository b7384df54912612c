// The sets of inputs of one machine: one of them drives the page, and a reader chooses another.

/// What another set's inputs are in this pose; nothing where this set has none. They are outputs of this set, or its own
/// inputs. An angle is a number within half a turn of the drawing's.
const inputsOf = ({ page }) => {
  const { motion } = answersAt(new Pose(state.q));
  return motion && page.inputs.map(({ name, isAngle, at }) => {
    const own = inputs.findIndex((input) => input.name === name);
    if (own >= 0) return state.q[own];
    const value = valueOf(rows.find(({ output }) => output === name), 0, motion);
    return isAngle ? at + nearest(value - at) : value;
  });
};

/// Why the pose is none of another set's, or nothing. A set's solver has the sides of the drawing: with the same inputs it
/// may put a point elsewhere.
const whyNot = ({ set, plan, machine }, q) => {
  const { numbers, error } = machine.place(state.p, q), pose = new Pose(state.q);
  if (error) return `with ${set}, ${why(error)}`;
  const isElsewhere = plan.points.some((name, k) => {
    const here = pose.point(PLAN.points.indexOf(name));
    return PLAN.points.includes(name) && here && !(apart(here, [numbers[2 * k], numbers[2 * k + 1]]) <= 1e-6 * extent);
  });
  return isElsewhere ? `this pose is another assembly of ${set}` : "";
};

/// The page with another set of inputs in the same pose. It begins anew, with all that the address says.
const driveBy = (wanted) => {
  const other = SETS.find(({ set }) => set === wanted), q = inputsOf(other);
  const missed = q ? whyNot(other, q) : "this pose has no motion";
  $("#missed").hidden = !missed;
  say($("#missed"), missed && `Driven by ${BY.set} on: ${missed}.`);
  if (missed) {
    $("#by").value = BY.set;
    return;
  }
  clearTimeout(remember.later);
  const given = other.page.inputs.map(({ name }, k) => [name, q, k]);
  const text = [...stated([...given, ...named().slice(inputs.length)]), `~shown=${encodeURIComponent(state.shown)}`, byIn(wanted)].join("&");
  tellParent("state", { text });
  if (isInside) tellParent("again");
  else location.hash = text;
};

/// The choice, beside what it drives.
const offerSets = () => {
  choose("#by", SETS.map(({ set }) => [set, set]));
  $("#by").value = BY.set;
  $("#by").parentElement.hidden = false;
  on($("#by"), "change", ({ target }) => driveBy(target.value));
};
