// Marks of what an output shall be, of a page that is told.

/// The values that a chart's first row shall have, at values of the first input; angles in the curve's own turn.
const aimsOf = ({ pairs, series: [{ isAngle }], scale }, values) => {
  const [from, to] = domain();
  return (state.axis ? [] : pairs).map(([x, wanted]) => {
    const y = shownOf(wanted, scale()), near = values[clamp(round((STEPS * (x - from)) / (to - from)), 0, STEPS)];
    return [x, isAngle && isFinite(near) ? y + 360 * round((near - y) / 360) : y];
  });
};
