// In the frame, while points are moved: the machine stands as it is drawn, and the page around it is told where everything is.
// It has the page's short names. What the page around it reads stands in quotes.

(() => {
  const told = () => {
    const pose = new Pose(state.q), box = figure.getBoundingClientRect(), pixel = box.width / view.width;
    const at = (spot) => spot && onPage(spot).map((part, k) => [box.left, box.top][k] + part * pixel);
    const frames = Object.fromEntries(PLAN.links.map((name, link) => [name, pose.link(link)]).filter(([, frame]) => frame));
    tellParent("places", {
      "view": { scale: view.scale, x: view.x, y: view.y, width: view.width, height: view.height },
      "origin": at([0, 0]),
      "scale": view.scale * pixel,
      "points": Object.fromEntries(PLAN.points.map((name, point) => [name, pose.point(point) ?? null])),
      "frames": frames,
    });
  };
  play(false);
  state.q = inputs.map(({ at }) => at);
  begin();
  draw(CURVES);
  requestAnimationFrame(told);
  for (const kind of ["scroll", "resize"]) addEventListener(kind, () => requestAnimationFrame(told));
})();
