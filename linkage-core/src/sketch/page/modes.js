// Choices between two words.

/// A choice between two words. Returns a function that sets it to +1 or −1.
const choice = (into, { name, docs, words: both }, change) => {
  const line = row(into);
  entitle(element("span", {}, line), name);
  const set = element("fieldset", { ariaLabel: name }, line);
  const buttons = both.map((word, k) => {
    const label = element("label", {}, set), button = element("input", { type: "radio", name, value: k ? -1 : 1 }, label);
    element("span", { textContent: word }, label);
    return button;
  });
  describe(line, `param_${name}`, docs, set);
  on(set, "change", ({ target }) => change(+target.value));
  return (sign) => buttons.forEach((button) => button.checked = +button.value === sign);
};
