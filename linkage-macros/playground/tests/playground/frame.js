// Questions to the frame of the machine. They have the page's short names; what is called from outside stands in quotes.

globalThis["ASKED"] = {
  "text": () => PAGE.text,
  "inputs": () => [...state.q],
  "place": (name, theta) => new Pose([theta]).point(PLAN.points.indexOf(name)),
  /// Where a point is drawn, in pixels of the frame.
  "spot": (name) => {
    const box = figure.getBoundingClientRect(), [x, y] = onPage(new Pose(state.q).point(PLAN.points.indexOf(name)));
    return [box.left, box.top].map((from, axis) => from + ([x, y][axis] * box.width) / view.width);
  },
};
