// A machine that moves by itself, without a drive and under the loads that are set.

/// The seconds of one step. Runge and Kutta's fourth order errs by its fourth power.
const STEP = 1 / 960;
const accelerations = (q, v) => {
  const { numbers, error } = MACHINE.forward_dynamics(state.p, q, v, atRest, state.l, atRest);
  return error ? null : numbers;
};

/// The state so many seconds later, without a drive and under the loads that are set; nothing where it cannot go on.
const later = (q, v, h) => {
  const slopes = [], shifted = (list, by, share) => list.map((x, k) => x + share * h * by[k]);
  for (const share of [0, 0.5, 0.5, 1]) {
    const last = slopes.at(-1), at = last ? [shifted(q, last[0], share), shifted(v, last[1], share)] : [q, v];
    const a = accelerations(...at);
    if (!a) return null;
    slopes.push([at[1], a]);
  }
  const mean = (of) => of.map((_, k) => slopes.reduce((sum, slope, n) => sum + [1, 2, 2, 1][n] * slope[of === q ? 0 : 1][k], 0) / 6);
  return [shifted(q, mean(q), 1), shifted(v, mean(v), 1)];
};

const run = (wanted) => {
  if (wanted === !!running) return;
  if (wanted) {
    play(false);
    const v = rates(), a = accelerations(state.q, v);
    running = a && { v, a, then: null };
    if (running) requestAnimationFrame(runOn);
  } else {
    running = null;
    draw(CURVES);
    remember();
  }
  say($("#run"), running ? "Stop" : "Run");
  $("#run").setAttribute("aria-pressed", !!running);
};
const runOn = (time) => {
  if (!running) return;
  const seconds = running.then === null ? 0 : min((time - running.then) / 1e3, 0.1) * pace, steps = Math.ceil(seconds / STEP);
  let [q, v] = [state.q, running.v];
  for (let k = 0; k < min(steps, 2000); k++) {
    const next = later(q, v, seconds / steps);
    if (!next) break;
    [q, v] = next;
  }
  const a = accelerations(q, v);
  go(q);
  if (!a || new Pose(q).error) return run(false);
  assign(running, { v, a, then: time });
  requestAnimationFrame(runOn);
};

onClick("#run", () => {
  // Masses move in real time at first.
  if (!running && pace !== 1) $("#pace").value = pace = 1;
  run(!running);
});
$("#run").hidden = !MACHINE.forward_dynamics;
