// Drives between which friction holds the machine at rest.

/// Lines between pairs of spots, there and back, interrupted where there is none.
const areaBetween = (pairs) => {
  let d = "", way = [];
  for (const pair of [...pairs, null]) {
    if (pair) way = [pair[0], ...way, pair[1]];
    else [d, way] = [d + pathOf(way, true), []];
  }
  return d;
};

const heldWords = ({ holding }) => {
  if (!holding) return "–";
  const { shown: [unit, times], noise } = holds.scales[0];
  return withUnit(holding.map((x) => digits(abs(x) < 1e-9 * noise ? 0 : x * times)).join(" … "), unit);
};
