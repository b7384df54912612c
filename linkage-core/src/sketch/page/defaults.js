// The declaration with what a reader has changed: of a machine that has parameters.

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
