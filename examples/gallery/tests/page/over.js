// What the texts of a page's picture and charts lie on, at many poses. A text is what its letters cover, as the
// browser draws them; a bar is what its stroke covers.

{
  const pen = document.createElement("canvas").getContext("2d");
  const isSeen = (node) => getComputedStyle(node).visibility === "visible";
  /// Where a place in a node's own axes is drawn.
  const drawnAt = (node, x, y) => new DOMPoint(x, y).matrixTransform(node.getCTM());
  const letters = (text) => {
    const style = getComputedStyle(text), at = (list) => (list.length ? list[0].value : 0);
    pen.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    const size = pen.measureText(text.textContent);
    const share = { "middle": 0.5, "end": 1 }[style.textAnchor] ?? 0;
    const { x: anchor, y } = drawnAt(text, at(text.x.baseVal), at(text.y.baseVal)), x = anchor - share * size.width;
    return { left: x, right: x + size.width, top: y - size.actualBoundingBoxAscent, bottom: y + size.actualBoundingBoxDescent };
  };
  const texts = (root) => [...root.querySelectorAll("text")].filter((text) => isSeen(text) && text.textContent.trim())
    .map((text) => [text.textContent, letters(text), text]);
  /// Places along a path in its own axes. Few paths change their shape when the machine moves.
  const known = new Map();
  const along = (path) => {
    const d = path.getAttribute("d");
    if (!known.has(d)) {
      const length = d ? path.getTotalLength() : 0;
      known.set(d, Array.from({ length: Math.ceil(length / 2) }, (_, k) => path.getPointAtLength(2 * k)));
    }
    return known.get(d);
  };
  /// Places that a name must not lie on, each with what is there and how far it reaches.
  const solid = () => {
    const found = [];
    for (const path of nodes.bodies.querySelectorAll(".bar, .rod, .plate, .tube")) {
      const kind = path.getAttribute("class");
      for (const place of along(path)) {
        const { x, y } = drawnAt(path, place.x, place.y);
        found.push([x, y, kind, 1.5]);
      }
    }
    for (const block of [...nodes.bodies.querySelectorAll(".block")].filter(isSeen)) {
      for (let along = -12; along <= 12; along += 4) for (const across of [-7, 0, 7]) {
        const { x, y } = drawnAt(block, along, across);
        found.push([x, y, "block", 1]);
      }
    }
    for (const arrow of [...nodes.forces.querySelectorAll(".arrow")].filter(isSeen)) {
      if (arrow === nodes.forceScale) continue;
      for (const { x, y } of along(arrow)) found.push([x, y, "arrow", 1]);
    }
    for (const [k, pin] of nodes.pin.entries()) {
      const { x, y } = drawnAt(pin, 0, 0);
      if (isSeen(pin)) found.push([x, y, `joint ${PLAN.points[k]}`, 4]);
    }
    return found;
  };
  const faults = new Map();
  let seen = 0, posed = 0;
  const fault = (what) => faults.set(what, (faults.get(what) ?? 0) + 1);
  const overlaps = (list) => list.forEach(([name, a], k) => list.slice(k + 1).forEach(([other, b]) => {
    if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) fault(`${name} over ${other}`);
  }));
  const look = () => {
    const own = texts(figure), spots = solid();
    seen += own.length;
    overlaps(own);
    for (const [name, { left, right, top, bottom }, node] of own) {
      if (Math.min(left, top, view.width - right, view.height - bottom) < 0) fault(`${name} over the edge`);
      const isForce = node.matches(".force"), isOfJoint = ([, , what]) => what.startsWith("joint");
      if (!isForce && !node.closest(".names")) continue;
      const on = (isForce ? spots.filter(isOfJoint) : spots).find(([x, y, , half]) => Math.hypot(Math.max(left - x, 0, x - right), Math.max(top - y, 0, y - bottom)) < half);
      if (on) fault(`${name} on a ${on[2]}`);
    }
    for (const { svg, width, left, top, bottom, height } of charts) {
      const own = texts(svg);
      overlaps(own);
      for (const dot of svg.querySelectorAll(".dot")) {
        const { x, y } = drawnAt(dot, 0, 0);
        if (svg.style.display !== "none" && isSeen(dot) && (y < top - 5 || y > height - bottom + 5 || x < left - 1)) fault("a dot beyond its chart");
      }
      for (const [name, { left, right }] of own) if (left < -0.5 || right > width + 0.5) fault(`${name} over the edge of a chart`);
    }
    for (const arrow of [...figure.querySelectorAll(".arrow")].filter(isSeen)) {
      const { x, y, width, height } = arrow.getBBox();
      if (Math.min(x, y, view.width - x - width, view.height - y - height) < 0) fault("an arrow over the edge");
    }
  };
  /// Names of controls that are cut, values that have to be moved to be read, and controls out of their line.
  const lookBeside = () => {
    for (const node of document.querySelectorAll(".row label, .row > span, .field, button, select")) {
      if (node.scrollWidth > node.clientWidth + 1) fault(`${node.value || node.textContent} is cut`);
    }
    const values = $("#values").parentElement;
    if (values.scrollWidth > values.clientWidth) fault(`the table is ${values.scrollWidth - values.clientWidth} wider than its place`);
    const boxesOf = (parent, kinds) => [...parent.querySelectorAll(kinds)].map((node) => node.getBoundingClientRect()).filter(({ width }) => width > 0);
    for (const line of document.querySelectorAll(".head, .row, .hint, #status")) {
      const { left, right } = line.getBoundingClientRect(), isOut = (box) => box.left < left - 1 || box.right > right + 1;
      if (boxesOf(line, "button, select, span, .field").some(isOut)) fault(`${line.textContent.slice(0, 20)} is wider than its line`);
    }
    for (const group of document.querySelectorAll(".head > div")) {
      const boxes = boxesOf(group, "button, select");
      if (Math.max(...boxes.map(({ top }) => top)) > Math.min(...boxes.map(({ bottom }) => bottom))) fault("a line of controls is broken");
    }
    if (document.documentElement.scrollWidth > innerWidth) fault("the page is wider than its window");
  };
  addEventListener("load", () => setTimeout(() => {
    play(false);
    const poses = inputs.flatMap((input, k) => Array.from({ length: 44 }, (_, n) => withInput(k, input.from + (sizeOf(input) * (n + 0.5)) / 44)));
    for (const q of [...PAGE.path.filter((_, k) => k % 9 === 0), ...poses]) {
      state.q = q;
      due = POSE;
      told = 0;
      frame();
      posed++;
      look();
      lookBeside();
    }
    parent.postMessage({ failures: [...faults].map(([what, count]) => `${what} ${count}×`), "told": [`${posed} poses`, `${seen} texts`] }, "*");
  }, 200));
}
