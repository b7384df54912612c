// Sliders and modes, the declaration with what was changed, and the address.

const row = (into) => element("div", { className: "row" }, $(into));
/// What the declaration says of a number, below it.
const describe = (line, id, docs, ...controls) => {
  if (!docs) return;
  element("small", { id: `${id}_docs`, textContent: docs }, line);
  for (const control of controls) control.setAttribute("aria-describedby", `${id}_docs`);
};

/// A slider with its name and a field, in which a number may lie beyond the slider's ends and have any unit. Returns
/// a function that sets both, and the slider's ends where these are given.
const slider = (into, id, { name, docs, unit }, shown, change, settle) => {
  const line = row(into);
  entitle(element("label", { htmlFor: id }, line), name);
  const input = element("input", { type: "range", id, step: "any" }, line);
  const field = element("input", { type: "text", className: "field", id: `${id}_field`, ariaLabel: `${name}, as a number`, autocomplete: "off", spellcheck: false }, line);
  describe(line, id, docs, input, field);
  const set = (x, { from, to } = {}) => {
    // What was typed beyond the ends is not cut off.
    if (from !== undefined) assign(input, { min: min(from, x), max: max(to, x) });
    else if (x < +input.min) input.min = x;
    else if (x > +input.max) input.max = x;
    if (+input.value !== x) input.value = x;
    const text = asTyped(x, shown());
    if (document.activeElement !== field && field.value !== text) field.value = text;
    input.setAttribute("aria-valuetext", text);
  };
  on(input, "input", () => {
    change(+input.value);
    set(+input.value);
  });
  on(field, "focus", () => field.select());
  const read = () => {
    const x = numberIn(field.value, unit, shown());
    field.setAttribute("aria-invalid", x === null);
    if (x === null) return;
    set(x);
    change(x);
    settle?.();
  };
  // Setting a text by hand makes no event: what is left unread says what stands.
  on(field, "change", read);
  on(field, "blur", () => {
    field.setAttribute("aria-invalid", false);
    field.value = asTyped(+input.value, shown());
  });
  on(field, "keydown", ({ key }) => {
    if (key === "Enter") read();
    if (key === "Escape") field.value = asTyped(+input.value, shown());
  });
  if (settle) on(input, "change", settle);
  return set;
};

const ownUnit = ({ unit, size }) => [unit === "1" ? "" : unit === "deg" ? "°" : unit, 1 / size];
const mostOf = ({ from, to }) => max(abs(from), abs(to));
const shownRate = () => {
  const { isAngle, unit } = inputs[state.axis];
  return isAngle ? ["rpm", 60 / TURN] : shownIn(unit, 1, mostRate());
};
/// The largest rate of the slider.
const mostRate = () => 4 * abs(inputs[state.axis].rate || 1);

/// Builds all controls. `changed` is told what has to be drawn anew.
const setters = {};
const buildControls = (changed) => {
  setters.inputs = inputs.map((input, k) => slider("#inputs", `input_${input.name}`, input, () => shownIn(input.unit, 0, mostOf(input)), (x) => {
    if (state.axis !== k) setAxis(k);
    go(withInput(k, x));
  }));
  const docs = "The rate of the input over which curves are drawn, and at which it plays.";
  setters.rate = slider("#inputs", "rate_", { name: "rate", docs, get unit() { return `${inputs[state.axis].unit}/s`; } }, shownRate, (x) => {
    state.rate = x;
    changed(CURVES);
  });
  setters.params = params.map((param, k) => {
    const set = (x) => {
      state.p[k] = x;
      lastGood = null;
      changed(CURVES);
    };
    const settle = () => {
      const found = defaultOf(declaration, param.name);
      if (found) tellParent("default", { name: param.name, value: asWritten(param, state.p[k], declaration.slice(...found)) });
      changed(SCALE);
    };
    return param.words
      ? choice("#params", param, (x) => [set(x), settle()])
      : slider("#params", `param_${param.name}`, param, () => ownUnit(param), set, settle);
  });
  setters.loads = loads.map((load, k) => slider("#loads", `load_${load.name}`, load, () => shownIn(load.unit, 0, mostOf(load)), (x) => {
    state.l[k] = x;
    changed(CURVES);
  }));
  $("#params").hidden = !params.length;
  $("#loads").hidden = !loads.length;
};

const setInputs = () => setters.inputs.forEach((set, k) => {
  const { turns, from, to } = inputs[k];
  set(turns ? turnedInto(state.q[k], from, to) : state.q[k]);
});
const setAll = () => {
  setters.inputs.forEach((set, k) => set(clamp(state.q[k], inputs[k].from, inputs[k].to), inputs[k]));
  setInputs();
  setters.rate(state.rate, { from: -mostRate(), to: mostRate() });
  setters.params.forEach((set, k) => set(state.p[k], params[k]));
  setters.loads.forEach((set, k) => set(state.l[k], loads[k]));
};

// ---- declaration ------------------------------------------------------------------------------------

/// The declaration without what its lines have in common in front.
const declaration = (() => {
  const [first, ...rest] = PAGE.text.split("\n");
  const indents = rest.filter((line) => line.trim()).map((line) => line.search(/\S/));
  const indent = min(...indents, Infinity);
  return [first, ...rest.map((line) => line.slice(isFinite(indent) ? indent : 0))].join("\n");
})();

const KEYWORDS = /^(\s*)(pub struct|struct|input|param|load|let|ground|guide|crank|slider|rrr|rrp|rpr|prp|rpp|point|pin|link|drive|gravity|mass|force|torque|spring|friction|stop|unknown|solve|numerics|export|output)\b/gm;
const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
const declaredNow = () => (params.length ? declared() : [[declaration]]);
const showDeclaration = () => {
  const html = declaredNow().map(([text, isChanged]) => (isChanged ? `<mark>${escaped(text)}<\/mark>` : escaped(text))).join("");
  $("#code").innerHTML = html.replace(/\/\/[^\n]*/g, "<em>$&<\/em>").replace(KEYWORDS, "$1<b>$2<\/b>");
};

const copyDeclaration = async () => {
  const text = declaredNow().map(([piece]) => piece).join("");
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const range = document.createRange();
    range.selectNodeContents($("#code"));
    getSelection().removeAllRanges();
    getSelection().addRange(range);
    document.execCommand("copy");
  }
  say($("#copy"), "Copied");
  setTimeout(() => $("#copy").textContent = "Copy", 1200);
};

// ---- address ----------------------------------------------------------------------------------------

const named = () => [
  ...inputs.map(({ name }, k) => [name, state.q, k]),
  ...params.map(({ name }, k) => [name, state.p, k]),
  ...loads.map(({ name }, k) => [name, state.l, k]),
];
/// What is seen of the machine; no name of a declaration begins like these.
const SEEN = ["~rate", "~over", "~shown"];
/// The part of the address that says which set of inputs drives.
const byIn = (set) => `~by=${encodeURIComponent(set)}`;
const stated = (list) => list.map(([name, list, k]) => `${encodeURIComponent(name)}=${+list[k].toPrecision(9)}`);

/// Writes the state behind the address, a little after the last change.
const remember = () => {
  clearTimeout(remember.later);
  remember.later = setTimeout(() => {
    const seen = [state.rate, inputs[state.axis].name, state.shown];
    const parts = [
      ...stated(named()),
      ...SEEN.map((name, k) => `${name}=${encodeURIComponent(typeof seen[k] === "number" ? +seen[k].toPrecision(9) : seen[k])}`),
      ...(BY ? [byIn(BY.set)] : []),
    ];
    tellParent("state", { text: parts.join("&") });
    try {
      history.replaceState(null, "", `#${parts.join("&")}`);
    } catch {
      // A page inside another has no address of its own.
    }
  }, 250);
};

/// The page around this one, if there is one, is told what its reader does.
const isInside = parent !== window;
const tellParent = (kind, told) => isInside && parent.postMessage({ kind, ...told }, "*");
/// The state that is asked for: by the page around this one at first, then by the address.
let asked = globalThis.STATE ?? "";
const takeAsked = () => {
  const text = asked || location.hash.slice(1);
  asked = "";
  return text;
};

/// Takes a state. What is not understood in it is left out, and said.
const recall = (text) => {
  const known = named(), missed = [];
  for (const part of text.split("&")) {
    let name, value;
    try {
      [name, value] = part.split("=").map(decodeURIComponent);
    } catch {
      missed.push(part);
      continue;
    }
    const found = known.find(([own]) => own === name), number = value === "" || value === undefined ? NaN : +value;
    const axis = inputs.findIndex((input) => input.name === value);
    if (found && isFinite(number)) found[1][found[2]] = number;
    else if (name === "~rate" && isFinite(number)) state.rate = number;
    else if (name === "~over" && axis >= 0) state.axis = axis;
    else if (name === "~shown" && offered.includes(value)) state.shown = value;
    else if (part && !(BY && part === byIn(BY.set))) missed.push(part);
  }
  $("#missed").hidden = !missed.length;
  say($("#missed"), missed.length ? `The address holds what this page does not know: ${missed.slice(0, 3).join(", ").slice(0, 80)}` : "");
};
