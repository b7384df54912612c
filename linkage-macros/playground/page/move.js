// Points are moved: a button beside each place that is written, and numbers that change in the unit that stands there.

const handles = $("#handles");
const LENGTHS = { m: 1, mm: 1e-3, cm: 1e-2, um: 1e-6, in: 0.0254, ft: 0.3048 };
/// The places of this text, and where the frame shows them.
let places = [], placesOf = "", seen = null, isMoving = false, held = null;

/// A number with its unit; nothing for any other expression.
const numberIn = (text) => {
  const [, sign, digits, unit] = /^(-?)\s*(\d[\d_]*(?:\.[\d_]*)?(?:[eE][-+]?\d+)?)\s*([a-z]*)$/u.exec(text) ?? [];
  if (digits === undefined || (unit && !LENGTHS[unit])) return null;
  return { unit, value: (sign ? -1 : 1) * +digits.replaceAll("_", "") * (LENGTHS[unit] ?? 1) };
};
/// Where a coordinate is written: as a number here, or as the default of the parameter that stands here.
const writtenAt = (text, [from, to]) => {
  const own = text.slice(from, to).trim();
  if (numberIn(own)) return { from, to };
  const found = /^[\p{L}_]\w*$/u.test(own) && new RegExp(`\\bparam\\s+${own}\\s*(?::\\s*\\w+\\s*)?=\\s*([^;]*)`, "u").exec(text);
  if (!found) return null;
  const end = found.index + found[0].length;
  return numberIn(found[1].trim()) ? { from: end - found[1].length, to: end, param: own } : null;
};
/// Both coordinates of a place in a text: value, unit, and where they are written.
const coordinates = (text, { numbers }) => {
  const both = numbers.map((at) => {
    const spot = writtenAt(text, at);
    return spot && { ...spot, ...numberIn(text.slice(spot.from, spot.to).trim()) };
  });
  // A zero without a unit has its neighbour's.
  const unit = both.map((own) => own?.unit).find((unit) => unit) ?? (/\d(mm|cm|um|in|ft|m)\b/.exec(text) ?? ["", ""])[1];
  const isBare = both.some((own) => own && !own.unit && own.value !== 0);
  return both.map((own) => own && { ...own, unit: own.unit || (isBare ? "" : unit) });
};

/// From the frame of a place, the ground's or a link's, to pixels of the stage, and back.
const frameOf = ({ on }) => (on ? seen.frames[on] : { at: [0, 0], cos: 1, sin: 0 });
const toStage = (place, [x, y]) => {
  const { at, cos, sin } = frameOf(place);
  return [seen.origin[0] + seen.scale * (at[0] + cos * x - sin * y), seen.origin[1] - seen.scale * (at[1] + sin * x + cos * y)];
};
const fromStage = (place, [u, v]) => {
  const { at, cos, sin } = frameOf(place), [x, y] = [(u - seen.origin[0]) / seen.scale - at[0], (seen.origin[1] - v) / seen.scale - at[1]];
  return [cos * x + sin * y, cos * y - sin * x];
};
/// Where a handle stands: at its numbers, or where the machine has the point.
const spotOf = (place, text) => {
  const at = coordinates(text, place);
  if (at.every((own) => own) && frameOf(place)) return toStage(place, at.map(({ value }) => value));
  const point = seen.points[place.name];
  return point && toStage({}, point);
};

/// A round number of the unit that is at least two pixels.
const stepOf = (size) => {
  const least = 2 / seen.scale / size, power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((step) => step * power).find((step) => step >= least * (1 - 1e-9));
};
const inSteps = (value, unit) => {
  const size = LENGTHS[unit] ?? 1, step = stepOf(size), decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  return +(Math.round(value / size / step) * step).toFixed(decimals);
};
const rounded = (value, unit) => +(value / (LENGTHS[unit] ?? 1)).toPrecision(9);

/// The text in which a place has other coordinates; those that are no numbers are named, and stay.
const movedIn = (text, place, wanted, isExact) => {
  const own = coordinates(text, place), cuts = [];
  own.forEach((at, axis) => {
    if (!at) {
      const word = text.slice(...place.numbers[axis]);
      return say(`${place.name}.${"xy"[axis]} is ${word}: change it in the text`);
    }
    if (Math.abs(wanted[axis] - at.value) * seen.scale < 1e-6) return;
    const number = isExact[axis] ? rounded(wanted[axis], at.unit) : inSteps(wanted[axis], at.unit);
    // A default stands behind one name, which may be both coordinates of several places.
    if (!cuts.some(({ from }) => from === at.from)) cuts.push({ ...at, number });
  });
  return cuts.sort((a, b) => b.from - a.from).reduce((text, { from, to, number, unit }) =>
    `${text.slice(0, from)}${number}${number === 0 ? "" : unit}${text.slice(to)}`, text);
};
/// The coordinate of another place that is within a few pixels, which a place takes as it is.
const SNAP = 5;
const snapped = (text, place, wanted) => {
  const others = places.filter((other) => other !== place && (other.on ?? "") === (place.on ?? "")).map((other) => coordinates(text, other));
  const isExact = [false, false];
  const at = wanted.map((value, axis) => {
    const near = others.map((own) => own[axis]?.value).filter((x) => x !== undefined && Math.abs(x - value) * seen.scale < SNAP);
    isExact[axis] = near.length > 0;
    return near.sort((a, b) => Math.abs(a - value) - Math.abs(b - value))[0] ?? value;
  });
  return [at, isExact];
};

const put = (button, [u, v]) => Object.assign(button.style, { left: `${u}px`, top: `${v}px` });
const showHandles = () => {
  if (!isMoving || !seen || placesOf !== area.value) return;
  handles.hidden = false;
  places.forEach((place, k) => {
    const button = handles.children[k] ?? handles.appendChild(Object.assign(document.createElement("button"), { type: "button" }));
    const spot = spotOf(place, area.value), words = place.numbers.map((at) => area.value.slice(...at)).join(", ");
    button.hidden = !spot;
    button.dataset.name = place.name;
    button.setAttribute("aria-label", `${place.name} at (${words}). Arrow keys move it, with Shift ten times as far.`);
    if (spot && held?.button !== button) put(button, spot);
  });
  while (handles.children.length > places.length) handles.lastChild.remove();
};
const showPlaces = (found, text) => {
  [places, placesOf] = [found, text];
  showHandles();
};
const placeOf = (button) => places[[...handles.children].indexOf(button)];

let drags = 0;
handles.addEventListener("pointerdown", (event) => {
  const button = event.target.closest("button"), place = placeOf(button);
  if (!place || !event.isPrimary || event.button !== 0 || placesOf !== area.value) return;
  button.setPointerCapture(event.pointerId);
  const from = spotOf(place, area.value), box = stage.getBoundingClientRect();
  held = { button, place, from, text: area.value, by: [from[0] - event.clientX + box.left, from[1] - event.clientY + box.top], kind: `move ${++drags}` };
});
handles.addEventListener("pointermove", ({ clientX, clientY, shiftKey }) => {
  if (!held) return;
  const { button, place, from, text, by, kind } = held, box = stage.getBoundingClientRect();
  const to = [clientX - box.left + by[0], clientY - box.top + by[1]];
  // With Shift it stays on one line.
  if (shiftKey) to[Math.abs(to[0] - from[0]) < Math.abs(to[1] - from[1]) ? 0 : 1] = from[Math.abs(to[0] - from[0]) < Math.abs(to[1] - from[1]) ? 0 : 1];
  if (Math.hypot(to[0] - from[0], to[1] - from[1]) < 1) return;
  const [at, isExact] = snapped(text, place, fromStage(place, to));
  put(button, toStage(place, at));
  set(movedIn(text, place, at, isExact), kind);
});
for (const kind of ["pointerup", "pointercancel"]) {
  handles.addEventListener(kind, () => {
    if (!held) return;
    held = null;
    check();
  });
}
handles.addEventListener("keydown", (event) => {
  const way = { ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowLeft: [-1, 0], ArrowDown: [0, -1] }[event.key], place = way && placeOf(event.target);
  if (!place) return;
  event.preventDefault();
  // A text that is not compiled yet has its places a moment later.
  if (placesOf !== area.value) return;
  const own = coordinates(area.value, place);
  const at = own.map((one, axis) => one && one.value + way[axis] * stepOf(LENGTHS[one.unit] ?? 1) * (LENGTHS[one.unit] ?? 1) * (event.shiftKey ? 10 : 1));
  set(movedIn(area.value, place, at, [false, false]), `keys ${place.name}`);
});
$("#move").onclick = ({ target }) => {
  isMoving = !isMoving;
  target.setAttribute("aria-pressed", isMoving);
  handles.hidden = true;
  seen = null;
  check();
};
