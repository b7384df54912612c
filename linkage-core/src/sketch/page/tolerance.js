// What tolerances of the parameters do to the output whose curves are shown: in the pose of the cursor, and over the
// input. Both ends of each tolerance are posed, so that a machine that cannot be assembled there says so.

/// Parameters lie uniformly this far to both sides of their values: lengths, in metres, and angles, in radians.
const tolerances = { m: 1e-4, rad: PI / 1800 };
let isTolerated = false;

const tolerated = () => params.flatMap(({ name, unit, words }, k) => {
  const by = words ? 0 : tolerances[kindOf(unit)];
  return by ? [{ name, k, by }] : [];
});

/// The rows' values with a parameter so much larger; nothing where there is no pose.
const valuesWith = (own, q, k, by) => {
  const set = state.p;
  state.p = withOne(set, k, set[k] + by);
  const { motion } = answersAt(new Pose(q));
  state.p = set;
  return motion && own.map((row) => valueOf(row, 0, motion));
};

/// The effects of each tolerance on the rows: half of what lies between its ends.
const effectsAt = (own, q) => tolerated().map(({ name, k, by }) => {
  const [less, more] = [-by, by].map((by) => valuesWith(own, q, k, by));
  const between = (a, b, { isAngle }) => (isAngle ? b - a - TURN * round((b - a) / TURN) : b - a);
  return { name, by: own.map((row, n) => (less && more ? 0.5 * between(less[n], more[n], row) : NaN)) };
});
const worstOf = (effects, n) => effects.reduce((sum, { by }) => sum + abs(by[n]), 0);
/// The sum of variances of a row, or of all rows of one parameter; three times each, which shares do not see.
const squares = (list) => list.reduce((sum, x) => sum + x * x, 0);

/// Each row's largest worst case over the input, and where it is.
const largestWorst = (own) => {
  const found = own.map(() => [-1, NaN]);
  let lost = null;
  for (const x of stepped(SURVEYED, domain(), (x) => x)) {
    const q = withInput(state.axis, x);
    if (new Pose(q).error) continue;
    const effects = effectsAt(own, q);
    own.forEach((_, n) => {
      const worst = worstOf(effects, n);
      if (worst > found[n][0]) found[n] = [worst, x];
      else if (!isFinite(worst)) lost ??= x;
    });
  }
  return { found, lost };
};

const tolerate = () => {
  isTolerated = !isTolerated;
  $("#tolerate").setAttribute("aria-pressed", isTolerated);
  $("#tolerances").hidden = !isTolerated;
  draw(CURVES);
};

/// The table of the cursor's pose, the largest share first.
const tellTolerances = () => {
  if (!isTolerated) return;
  const own = rowsOf(state.shown), effects = effectsAt(own, state.q), all = squares(effects.flatMap(({ by }) => by));
  const table = $("#tolerances table"), line = (head, cells, tag = "td") => {
    const row = table.insertRow();
    entitle(element("th", { scope: tag === "td" ? "row" : "col" }, row), head);
    cells.forEach((textContent) => element(tag, { textContent }, row));
  };
  const told = (x, { unit }) => (isFinite(x) ? words(x, unit) : "–");
  table.replaceChildren();
  if (!own.length || !effects.length) return;
  line("parameter", [...own.map(({ label }) => label), "share"], "th");
  const shares = effects.map(({ name, by }) => ({ name, by, share: squares(by) / all }));
  // What has no pose at an end of its tolerance comes first.
  const rank = ({ share }) => (isFinite(share) ? share : isFinite(all) ? 0 : 2);
  for (const { name, by, share } of shares.sort((a, b) => rank(b) - rank(a))) {
    line(name, [...by.map((x, n) => told(x, own[n])), isFinite(share) ? `${digits(100 * share, 3)} %` : "–"]);
  }
  line("worst case", [...own.map((row, n) => told(worstOf(effects, n), row)), ""]);
  line("standard deviation", [...own.map((row, n) => told(Math.sqrt(squares(effects.map(({ by }) => by[n])) / 3), row)), ""]);
};

/// The sentence about the whole range, where curves change.
const tellWorst = () => {
  if (!isTolerated) return;
  const own = rowsOf(state.shown), is = tolerated().length > 0;
  const { name } = inputs[state.axis], { found, lost } = own.length && is ? largestWorst(own) : { found: [], lost: null };
  const worst = found.flatMap(([most, x], n) => (most < 0 ? [] : [`${own[n].label} ${words(most, own[n].unit)} at ${inputWords(state.axis, x)}`]));
  const said = worst.length ? `Worst case over ${name}: ${worst.join(", ")}.` : is ? "An output has tolerances, a force has none." : "Tolerances are those of parameters, param l = 80mm; declares one.";
  say($("#tolerances p"), lost === null ? said : `${said} At ${inputWords(state.axis, lost)} a tolerance has no pose.`);
};

/// The button, and what it shows: the fields of both tolerances, and the table.
const offerTolerances = () => {
  $("#keep").insertAdjacentHTML("afterend", '<button id=tolerate aria-pressed=false title="Tells what tolerances of the parameters do">Tolerances</button>');
  const field = (id) => `<input type=text class=field id=tolerance_${id} autocomplete=off spellcheck=false></label>`;
  const head = `<div class=head><h2>Tolerances</h2><div><label>Lengths ± ${field("m")}<label>angles ± ${field("rad")}</div></div>`;
  const table = '<div class=scroll tabindex=0 role=region aria-label=Tolerances><table></table></div>';
  $("#steady").insertAdjacentHTML("afterend", `<div id=tolerances hidden>${head}${table}<p></p></div>`);
  for (const [kind, unit] of [["m", "m"], ["rad", "rad"]]) {
    const field = $(`#tolerance_${kind}`), scale = () => shownIn(unit, 0, tolerances[kind]);
    const write = () => field.value = asTyped(tolerances[kind], scale());
    on(field, "change", () => {
      const x = numberIn(field.value, unit, scale());
      field.setAttribute("aria-invalid", !(x > 0));
      if (x > 0) tolerances[kind] = x;
      write();
      draw(CURVES);
    });
    write();
  }
  onClick("#tolerate", tolerate);
};
