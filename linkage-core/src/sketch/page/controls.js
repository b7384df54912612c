// Sliders and modes, the declaration with what was changed, and the address.

const row = (into, docs) => element("div", { className: "row", title: docs ?? "" }, $(into));

/// A slider with its name and its value in words. Returns a function that sets it.
const slider = (into, id, { name, docs, from, to }, wordsOf, change, settle) => {
  const line = row(into, docs);
  entitle(element("label", { htmlFor: id }, line), name);
  const input = element("input", { type: "range", id, min: from, max: to, step: "any" }, line);
  const output = element("output", { htmlFor: id }, line);
  const set = (x) => {
    if (+input.value !== x) input.value = x;
    output.textContent = wordsOf(x);
    input.setAttribute("aria-valuetext", wordsOf(x));
  };
  on(input, "input", () => {
    change(+input.value);
    output.textContent = wordsOf(+input.value);
  });
  if (settle) on(input, "change", settle);
  return set;
};

/// A choice between two words. Returns a function that sets it to +1 or −1.
const choice = (into, { name, docs, words: both }, change) => {
  const line = row(into, docs);
  entitle(element("span", {}, line), name);
  const set = element("fieldset", { ariaLabel: name }, line);
  const buttons = both.map((word, k) => {
    const label = element("label", {}, set), button = element("input", { type: "radio", name, value: k ? -1 : 1 }, label);
    element("span", { textContent: word }, label);
    return button;
  });
  on(set, "change", ({ target }) => change(+target.value));
  return (sign) => buttons.forEach((button) => button.checked = +button.value === sign);
};

const inUnit = ({ unit, size }, x) => withUnit(x / size, unit === "1" ? "" : unit === "deg" ? "°" : unit);
const rateWords = (x) =>
  inputs[state.axis].isAngle ? `${digits((x * 60) / TURN, 3)} rpm` : `${digits(x, 3)} m/s`;

/// Builds all controls. `changed` is told what has to be drawn anew.
const setters = {};
const buildControls = (changed) => {
  setters.inputs = inputs.map((input, k) => slider("#inputs", `input_${input.name}`, input, (x) => inputWords(k, x), (x) => {
    if (state.axis !== k) setAxis(k);
    go(withInput(k, x));
  }));
  const most = Math.max(...inputs.map(({ rate }) => Math.abs(rate)));
  setters.rate = slider("#inputs", "rate_", { name: "rate", from: -4 * most, to: 4 * most, docs: "The rate of the input over which curves are drawn." },
    rateWords, (x) => {
      state.rate = x;
      changed(CURVES);
    });
  setters.params = params.map((param, k) => {
    const set = (x) => {
      state.p[k] = x;
      lastGood = null;
      changed(CURVES);
    };
    const settle = () => changed(SCALE);
    return param.words
      ? choice("#params", param, (x) => [set(x), settle()])
      : slider("#params", `param_${param.name}`, param, (x) => inUnit(param, x), set, settle);
  });
  setters.loads = loads.map((load, k) => slider("#loads", `load_${load.name}`, load, (x) => inUnit(load, x), (x) => {
    state.l[k] = x;
    changed(CURVES);
  }));
  $("#params").hidden = !params.length;
  $("#loads").hidden = !loads.length;
};

const setInputs = () => setters.inputs.forEach((set, k) => {
  const { turns, from } = inputs[k];
  set(turns ? from + wrapped(state.q[k] - from) : state.q[k]);
});
const setAll = () => {
  setInputs();
  setters.rate(state.rate);
  setters.params.forEach((set, k) => set(state.p[k]));
  setters.loads.forEach((set, k) => set(state.l[k]));
};

// ---- declaration ------------------------------------------------------------------------------------

/// The declaration without what its lines have in common in front.
const declaration = (() => {
  const [first, ...rest] = PAGE.text.split("\n");
  const indents = rest.filter((line) => line.trim()).map((line) => line.search(/\S/));
  const indent = Math.min(...indents, Infinity);
  return [first, ...rest.map((line) => line.slice(isFinite(indent) ? indent : 0))].join("\n");
})();

/// A number and its unit, if this is what is written.
const literalIn = (written) => /^(-?\s*[\d_.]+(?:[eE][-+]?\d+)?)(\s*(?:[a-zA-Z]+|\([^()]*\)))?$/.exec(written.trim());

/// The default of a parameter as the declaration would write its present value.
const asWritten = (param, value, written) => {
  if (param.words) return param.words[value > 0 ? 0 : 1];
  const literal = literalIn(written), inUnits = literal && value / (literal[2] ? param.size : 1);
  return literal ? `${+inUnits.toPrecision(6)}${literal[2] ?? ""}` : `${+value.toPrecision(6)}`;
};

/// The statement `param name = default;` of the text, outside comments: where its default begins and ends.
const defaultOf = (text, name) => {
  for (const found of text.matchAll(new RegExp(`\\bparam\\s+(?:r#)?${name}\\s*(?::\\s*\\w+\\s*)?=\\s*`, "gu"))) {
    const lineStart = text.lastIndexOf("\n", found.index) + 1, start = found.index + found[0].length;
    if (!text.slice(lineStart, found.index).includes("//")) return [start, text.indexOf(";", start)];
  }
  return null;
};

/// The text in pieces, the defaults that are not the declaration's among them.
const declared = () => {
  const changes = params.map((param, k) => {
    const found = defaultOf(declaration, param.name);
    if (!found) return null;
    const written = declaration.slice(...found), now = asWritten(param, state.p[k], written);
    const isSame = param.words ? now === written.trim() : asWritten(param, valueWritten(param, written), written) === now;
    return isSame ? null : { from: found[0], to: found[1], now };
  }).filter(Boolean).sort((a, b) => a.from - b.from);
  const pieces = [];
  let at = 0;
  for (const { from, to, now } of changes) {
    pieces.push([declaration.slice(at, from), false], [now, true]);
    at = to;
  }
  return [...pieces, [declaration.slice(at), false]];
};

/// The value that a literal means; none of any other expression, whose parameter counts as changed only if the
/// reader changed it.
const valueWritten = (param, written) => {
  const literal = literalIn(written);
  return literal ? parseFloat(literal[1].replace(/[_ ]/g, "")) * (literal[2] ? param.size : 1) : param.value;
};

const KEYWORDS = /^(\s*)(pub struct|struct|input|param|load|let|ground|guide|crank|slider|rrr|rrp|rpr|prp|rpp|point|pin|link|drive|gravity|mass|force|torque|spring|friction|stop|unknown|solve|numerics|export|output)\b/gm;
const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
const showDeclaration = () => {
  const html = declared().map(([text, isChanged]) => (isChanged ? `<mark>${escaped(text)}<\/mark>` : escaped(text))).join("");
  $("#code").innerHTML = html.replace(/\/\/[^\n]*/g, "<em>$&<\/em>").replace(KEYWORDS, "$1<b>$2<\/b>");
};

const copyDeclaration = async () => {
  const text = declared().map(([piece]) => piece).join("");
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const range = document.createRange();
    range.selectNodeContents($("#code"));
    getSelection().removeAllRanges();
    getSelection().addRange(range);
    document.execCommand("copy");
  }
  $("#copy").textContent = "Copied";
  setTimeout(() => $("#copy").textContent = "Copy", 1200);
};

// ---- address ----------------------------------------------------------------------------------------

const named = () => [
  ...inputs.map(({ name }, k) => [name, state.q, k]),
  ...params.map(({ name }, k) => [name, state.p, k]),
  ...loads.map(({ name }, k) => [name, state.l, k]),
];

/// Writes the state behind the address, a little after the last change.
const remember = () => {
  clearTimeout(remember.later);
  remember.later = setTimeout(() => {
    const parts = named().map(([name, list, k]) => `${encodeURIComponent(name)}=${+list[k].toPrecision(9)}`);
    try {
      history.replaceState(null, "", `#${parts.join("&")}`);
    } catch {
      // A page inside another has no address of its own.
    }
  }, 250);
};

const recall = () => {
  const known = named();
  for (const part of location.hash.slice(1).split("&")) {
    const [name, value] = part.split("=").map(decodeURIComponent), found = known.find(([own]) => own === name);
    if (found && value && isFinite(+value)) found[1][found[2]] = +value;
  }
};
