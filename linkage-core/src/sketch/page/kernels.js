// Arithmetic and elementary functions, to the bits of the Rust crate's `kernels` on a target without fused
// operations. Each is explained there; a test compares the two.

const EPSILON = 2 ** -52;
/// The smallest normal number, and the smallest square whose root has full precision.
const SMALLEST_NORMAL = 2 ** -1022, SMALLEST_SQUARE = 2 ** -918;
const TURN = 2 * Math.PI;
const isFinite = Number.isFinite;

const bytes = new DataView(new ArrayBuffer(8));
/// The upper 32 bits of a number: sign, exponent, 20 bits of the fraction.
const highBits = (x) => (bytes.setFloat64(0, x), bytes.getUint32(0));
const fromBits = (high, low = 0) => (bytes.setUint32(0, high), bytes.setUint32(4, low), bytes.getFloat64(0));
const isNegative = (x) => x < 0 || Object.is(x, -0);
const withSign = (x, sign) => (isNegative(x) === isNegative(sign) ? x : -x);

// Where one of both is no number these answer as the crate's do, unlike those of `Math`.
const magnitude = (x) => (x >= 0 ? x : -x);
const greater = (a, b) => (a > b ? a : b);

const fused = (a, b, c) => a * b + c;
const select = (isMet, yes, no) => (isMet ? yes : no);

// ---- sums and products with their rounding errors ---------------------------------------------------

/// The error of the rounded sum a + b (Knuth).
const addErr = (a, b) => {
  const sum = a + b, part = sum - a;
  return a - (sum - part) + (b - part);
};

const halves = (x) => {
  const scaled = 134217729 * x, high = scaled - (scaled - x);
  return [high, x - high];
};

/// The error of the rounded product a·b (Dekker).
const mulErr = (a, b) => {
  const [ah, al] = halves(a), [bh, bl] = halves(b);
  return ah * bh - a * b + ah * bl + al * bh + al * bl;
};

/// a·b − c·d, within 1.5 units in the last place.
const det = (a, b, c, d) => a * b - c * d + (mulErr(a, b) - mulErr(c, d));

/// The sum of all terms with a single rounding, or nearly: its sign is right (Shewchuk).
const exactSum = (terms) => {
  const parts = [];
  for (let carry of terms) {
    for (let k = 0; k < parts.length; k++) {
      const sum = carry + parts[k];
      parts[k] = addErr(carry, parts[k]);
      carry = sum;
    }
    parts.push(carry);
  }
  return parts.reduce((sum, part) => sum + part, 0);
};

// ---- sine and cosine --------------------------------------------------------------------------------

const NEAR = 2 ** 20, SHIFT = 1.5 * 2 ** 52;
const isNear = (x) => x * x <= NEAR * NEAR;
const QUADRANTS = 0.6366197723675814, REST = 6.077100506506192e-11;
const [C1, C2, C3, C4] = [1.5707963267341256, 6.077100506303966e-11, 2.0222662487111665e-21, 8.4784276603689e-32];
const [S0, S1, S2, S3, S4, S5] = [
  0.1666666666666663, -0.00833333333332184, 0.00019841269829358528,
  -2.7557313538514158e-6, 2.5050734389219857e-8, -1.5895433284842938e-10,
];
const [K0, K1, K2, K3, K4, K5] = [
  0.041666666666666595, -0.0013888888888873333, 2.4801587288992887e-5,
  -2.7557314213561954e-7, 2.087570483459e-9, -1.1358716362024778e-11,
];
/// Sines of quarter turns, each the cosine of the quarter before.
const QUARTERS = [-0, 1, 0, -1, -0];

/// 2/π in binary places.
const TWO_OVER_PI = BigInt(
  "0xa2f9836e4e441529fc2757d1f534ddc0db6295993c439041fe5163abdebbc561b7246e3a424dd2e006492eea09d1921cfe1deb1cb129a73e"
  + "e88235f52ebb4484e99c7026b45f7e413991d639835339f49c845f8bbdf9283b1ff897ffde05980fef2f118b5a0a6d1f6d367ecf27cb09b7"
  + "4f463f669e5fea2d7527bac7ebe5f17b3d0739f78a5292ea6bfb5fb11f8d5d0856033046");

/// The number of quarter turns in an angle beyond the kernel's range, modulo four, and the rest as r − excess: the
/// digits of 2/π that make whole turns are left out, 192 of the others multiplied (Payne and Hanek).
const farRest = (x) => {
  const high = highBits(x), shift = 2069 - ((high >>> 20) & 0x7ff);
  const mantissa = (BigInt((high & 0xfffff) | 0x100000) << 32n) | BigInt(bytes.getUint32(4));
  const product = BigInt.asUintN(192, mantissa * BigInt.asUintN(192, TWO_OVER_PI >> BigInt(shift)));
  const isAboveHalf = (product >> 189n) & 1n, count = Number((product >> 190n) + isAboveHalf);
  // The complement is less than the difference from the next quarter turn by 2⁻¹²⁸.
  const rest = BigInt.asUintN(128, isAboveHalf ? ~(product >> 62n) : product >> 62n);
  const part = (from, places) => Number(BigInt.asUintN(places, rest >> BigInt(from))) * 2 ** (from - 128);
  const first = part(96, 32), second = part(44, 52), sum = first + second;
  const sign = (isAboveHalf === 1n) !== x < 0 ? -1 : 1;
  const [most, least] = [sign * sum, sign * (first - sum + second + part(0, 44))];
  const quarters = most * QUARTER, error = mulErr(most, QUARTER) + (most * QUARTER_LOW + least * QUARTER);
  const r = quarters + error;
  return [x < 0 ? -count : count, r, r - quarters - error];
};

/// Sine and cosine of an angle, in this order.
const sinCos = (x) => {
  if (!isFinite(x)) return [NaN, NaN];
  let q, r, excess;
  if (isNear(x)) {
    q = x * QUADRANTS + SHIFT - SHIFT;
    const minuend = -q * C1 + x, subtrahend = q * REST;
    r = minuend - subtrahend;
    excess = q * C4 + (q * C2 - subtrahend + q * C3 - (minuend - r - subtrahend));
  } else {
    [q, r, excess] = farRest(x);
  }
  const z = r * r, z2 = z * z, head = 1 - 0.5 * z;
  const s = z * (z2 * (z2 * S5 + (z * S4 + S3)) + (z * S2 + S1)) + S0;
  const k = z * (z2 * (z2 * K5 + (z * K4 + K3)) + (z * K2 + K1)) + K0;
  const sin = r - (z * r * s + excess * head);
  const cos = head + (z2 * k + (r * excess + (1 - head - 0.5 * z)));
  const bySin = QUARTERS[q & 3], byCos = QUARTERS[(q & 3) + 1];
  return [cos * bySin + sin * byCos, -sin * bySin + cos * byCos];
};

// ---- arcs and lengths -------------------------------------------------------------------------------

const QUARTER = Math.PI / 2, QUARTER_LOW = 6.123233995736766e-17, EIGHTH = Math.PI / 4;
const ASIN = [
  0.16666666666666669, 0.07499999999998433, 0.04464285714635543, 0.030381944138531247,
  0.02237217294214989, 0.017352392720869973, 0.013971212973552933, 0.011479177415184906,
  0.01032281435018578, 0.005457506718640358, 0.01740087944269402, -0.014851887071247204,
  0.028757851367421566,
];
const ATAN = [
  -0.3333333333333333, 0.19999999999999984, -0.14285714285711718, 0.11111111110929807,
  -0.09090909084093506, 0.07692307534369985, -0.06666664203478607, 0.0588232553920069,
  -0.05262931380521779, 0.04760471049395462, -0.043407182638729704, 0.03971908106924452,
  -0.036139320776507194, 0.03213544133307827, -0.02718155333081564, 0.021121594179966983,
  -0.014503079564732733, 0.00844989240397037, -0.004000209679906822,
  0.0014617449054205385, -0.00038394037972999467, 6.417524965866564e-05,
  -5.1088410388226665e-06,
];
const timesPolynomial = (z, coefficients) => z * coefficients.reduceRight((sum, c) => sum * z + c, 0);

/// What arc sine and arc cosine share: above a half they go by the root of (1 − |x|)/2.
const halved = (x) => {
  const size = Math.abs(x), isLarge = size > 0.5;
  const z = isLarge ? 0.5 * (1 - size) : x * x, s = isLarge ? Math.sqrt(z) : size;
  return { isLarge, z, s, r: timesPolynomial(z, ASIN), high: fromBits(highBits(s)) };
};

const asin = (x) => {
  const { isLarge, z, s, r, high } = halved(x), rest = s - high;
  const low = rest + (z - high * high - rest * (s + high)) * (1.5 - s);
  const below = s * r + low, large = EIGHTH + (EIGHTH - 2 * high - (2 * below - QUARTER_LOW));
  return withSign(isLarge ? large : Math.abs(x) + s * r, x);
};

const acos = (x) => {
  const { isLarge, z, s, r, high } = halved(x);
  if (!isLarge) return QUARTER - (x - (QUARTER_LOW - withSign(s * r, x)));
  const low = s * r + (z - high * high) / (s + high + SMALLEST_NORMAL);
  return x > 0 ? 2 * high + 2 * low : QUARTER + (QUARTER - 2 * high - (2 * low - 2 * QUARTER_LOW));
};

const atan2 = (y, x) => {
  const across = Math.abs(y), along = Math.abs(x);
  const [short, long] = across < along ? [across, along] : [along, across];
  const t = long === 0 ? short : short === long ? 1 : short / long;
  const rest = t * timesPolynomial(t * t, ATAN);
  const [turns, sign] = isNegative(x)
    ? (across > along ? [1, 1] : [2, -1])
    : (across > along ? [1, -1] : [0, 1]);
  return withSign(turns * QUARTER + (sign * t + (turns * QUARTER_LOW + sign * rest)), y + 0);
};

const atan = (x) => withSign(atan2(x, 1), x);
const { sqrt, tan, exp, tanh, pow } = Math;
const ln = Math.log;

/// √(x² + y²), as musl's.
const hypot = (x, y) => {
  x = Math.abs(x), y = Math.abs(y);
  if (x < y || Number.isNaN(x)) [x, y] = [y, x];
  if (x === Infinity || y === Infinity) return Infinity;
  if (Number.isNaN(x + y) || y === 0) return x + y;
  const exponents = [highBits(x) >>> 20, highBits(y) >>> 20];
  if (exponents[0] - exponents[1] > 64) return x + y;
  const scale = exponents[0] > 0x3ff + 510 ? 2 ** 700 : exponents[1] < 0x3ff - 450 ? 2 ** -700 : 1;
  x /= scale, y /= scale;
  const square = (x) => {
    const scaled = x * 134217729, high = x - scaled + scaled, low = x - high, whole = x * x;
    return [whole, high * high - whole + 2 * high * low + low * low];
  };
  const [hx, lx] = square(x), [hy, ly] = square(y);
  return scale * Math.sqrt(ly + lx + hy + hx);
};
