// Numbers in words: digits, prefixes and units, alike in tables, axes, legends, arrows and fields.

const { abs, floor, max, min, round, PI } = Math, { assign } = Object;
const PREFIXES = [["a", 1e-18], ["f", 1e-15], ["p", 1e-12], ["n", 1e-9], ["µ", 1e-6], ["m", 1e-3], ["", 1], ["k", 1e3], ["M", 1e6], ["G", 1e9]];
const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/// A number with so many digits, and a minus sign as long as a plus; a power of ten where it would begin or end in
/// many zeros.
const digits = (x, count = 4) => {
  if (!isFinite(x)) return "–";
  if (x === 0) return "0";
  const [mantissa, power] = x.toExponential(count - 1).split("e"), tens = +power;
  if (tens >= -4 && tens < 6) return x.toFixed(max(count - 1 - tens, 0)).replace("-", "−");
  const raised = [...String(abs(tens))].map((digit) => RAISED[digit]).join("");
  return `${mantissa.replace("-", "−")}·10${tens < 0 ? "⁻" : ""}${raised}`;
};

/// A unit with the prefix in which this number has one to three digits before its point, and how many of it there
/// are in the unit. Of a squared unit, an angle and a plain number the unit itself.
const prefixed = (unit, largest) => {
  const [base, size] = unit.startsWith("kg") ? [unit.slice(1), 1e3] : [unit, 1];
  if (!/^[mNWJg](?![\w²³])/.test(base) || !(largest > 0 && largest < Infinity)) return [unit, 1];
  // 999.96 is a thousand in four digits.
  const [prefix, factor] = PREFIXES.findLast(([, factor]) => largest * size * 1.00005 >= factor) ?? PREFIXES[0];
  return [prefix + base, size / factor];
};

/// The units that readers choose among, each with what it is in SI; without a choice the prefix follows the numbers.
const UNITS = {
  length: { auto: null, m: 1, mm: 1e-3, in: 0.0254, ft: 0.3048 },
  angle: { "°": PI / 180, rad: 1 },
};
const chosen = { length: "auto", angle: "°" };

/// The unit that a quantity of this order is shown in, and how many of it there are in an SI unit, where its largest
/// number is known.
const shownIn = (unit, order, largest = 1) => {
  const per = ["", "/s", "/s²"][order] ?? "";
  if (unit === "1") return [per && `1${per}`, 1];
  if (unit === "rad") return [chosen.angle + per, 1 / UNITS.angle[chosen.angle]];
  if (unit === "m" && chosen.length !== "auto") return [chosen.length + per, 1 / UNITS.length[chosen.length]];
  // The field writes a damper's newtons for a speed.
  return prefixed(unit.replace(/^kg\/s(?![²³\w])/, "N·s/m") + per, largest);
};
const withUnit = (text, unit) => `${text}${unit === "°" || text === "–" ? "" : " "}${text === "–" ? "" : unit}`.trim();

/// A number in the unit in which its largest is shown. What rounding leaves of zero beside that is none.
const inScale = (x, [unit, times], largest = 0) =>
  withUnit(digits(abs(x) < 1e-9 * largest ? 0 : x * times), unit);
/// The same as a reader would write it: no zeros at the end.
const asTyped = (x, scale) => inScale(x, scale).replace(/(\.\d*?)0+(?=\D|$)/, "$1").replace(/\.(?=\D|$)/, "");
const words = (x, unit, order = 0) => inScale(x, shownIn(unit, order, abs(x)));

/// The number in SI that a reader writes: bare ones are in the unit shown, others in their own. Nothing where it is none.
const WRITTEN = {
  rad: { rad: 1, deg: PI / 180, "°": PI / 180, turn: TURN },
  m: { m: 1, mm: 1e-3, cm: 1e-2, um: 1e-6, "µm": 1e-6, km: 1e3, in: 0.0254, ft: 0.3048 },
  "rad/s": { "rad/s": 1, rpm: TURN / 60, "°/s": PI / 180, "deg/s": PI / 180, "1/s": 1 },
  "m/s": { "m/s": 1, "mm/s": 1e-3, "in/s": 0.0254, "ft/s": 0.3048 },
  kg: { kg: 1, g: 1e-3, t: 1e3 },
  N: { N: 1, kN: 1e3, mN: 1e-3, MN: 1e6 },
  "N·m": { "N·m": 1, "N*m": 1, Nm: 1, "kN·m": 1e3, "kN*m": 1e3, kNm: 1e3, "N·mm": 1e-3, "N*mm": 1e-3, Nmm: 1e-3 },
  s: { s: 1, ms: 1e-3 },
};
/// The group of units that one belongs to.
const kindOf = (unit) => Object.keys(WRITTEN).find((kind) => kind === unit || unit in WRITTEN[kind]) ?? unit;
const numberIn = (text, unit, [shown, times]) => {
  const found = /^\s*([-−+]?(?:\d[\d_ ]*)?(?:[.,]\d*)?(?:\s*[·*×]\s*10\s*[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+|[eE][-+]?\d+)?)\s*\(?([^\d\s)][^\s)]*)?\)?\s*$/u.exec(text);
  if (!found || !/\d/.test(found[1])) return null;
  const plain = found[1].replace(/[_ ]/g, "").replace("−", "-").replace(",", ".")
    .replace(/[·*×]10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)/, (_, power) => `e${[...power].map((sign) => (sign === "⁻" ? "-" : RAISED.indexOf(sign))).join("")}`);
  const own = found[2], size = own === undefined || own === shown ? 1 / times : WRITTEN[kindOf(unit)]?.[own];
  const value = +plain * size;
  return size && isFinite(value) ? value : null;
};

/// An angle of one turn.
const wrapped = (angle) => angle - TURN * floor(angle / TURN);
