// Where texts are against everything else, at every few times of every picture. A text is what its
// letters cover, as the browser draws them; a line is what its stroke covers.
const pen = document.createElement("canvas").getContext("2d");

const opacity = (element) => {
  let all = 1;
  for (; element.localName !== "svg"; element = element.parentNode) {
    all *= Number(getComputedStyle(element).opacity);
  }
  return all;
};

// The box of a text's letters on the page of its picture.
const letters = (text) => {
  const style = getComputedStyle(text), m = text.getCTM();
  pen.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
  const size = pen.measureText(text.textContent);
  const at = (list) => (list.length ? list[0].value : 0);
  const x = at(text.x.baseVal) + m.e - (style.textAnchor === "middle" ? size.width / 2 : 0);
  const y = at(text.y.baseVal) + m.f;
  return {
    left: x - size.actualBoundingBoxLeft, right: x + size.actualBoundingBoxRight,
    top: y - size.actualBoundingBoxAscent, bottom: y + size.actualBoundingBoxDescent,
  };
};

// Places of a shape in its own axes, close to each other, and how far it reaches about each.
const places = (shape) => {
  const style = getComputedStyle(shape);
  const half = style.stroke === "none" ? 0 : parseFloat(style.strokeWidth) / 2;
  const found = [];
  if (shape.localName === "circle") {
    const [x, y, r] = [shape.cx, shape.cy, shape.r].map((length) => length.animVal.value);
    if (r <= 6) return { found: [[x, y]], half: half + r };
    for (let k = 0; k < 90; k++) found.push([x + r * Math.cos(k / 90 * 2 * Math.PI), y + r * Math.sin(k / 90 * 2 * Math.PI)]);
  } else if (shape.localName === "rect") {
    const { x, y, width, height } = shape.getBBox();
    const steps = (length) => Math.max(1, Math.ceil(length / 3));
    for (let i = 0; i <= steps(width); i++) {
      for (let j = 0; j <= steps(height); j++) found.push([x + width * i / steps(width), y + height * j / steps(height)]);
    }
  } else {
    const length = shape.getTotalLength();
    for (let k = 0; k <= Math.ceil(length / 1.5); k++) {
      const { x, y } = shape.getPointAtLength(Math.min(length, 1.5 * k));
      found.push([x, y]);
    }
  }
  return { found, half };
};

// Whether no text may cover it: joints, links, supports, arrows; traces, faint poses, circles of cranks
// and thin axes may be covered.
const isHard = (shape, ink) => {
  const style = getComputedStyle(shape);
  const width = style.stroke === "none" ? 0 : parseFloat(style.strokeWidth);
  if (shape.closest("[data-trace]")) return false;
  return shape.closest("[data-link]") !== null
    || ["point", "force", "couple"].some((kind) => kind in shape.dataset)
    || (shape.localName === "circle" && shape.r.animVal.value <= 6)
    || width >= 4 || style.stroke === ink || style.fill === ink;
};

const named = (shape) => {
  const link = shape.closest("[data-link]");
  return shape.dataset.point ? "joint " + shape.dataset.point
    : link ? "link " + link.dataset.link : shape.localName + " " + (shape.getAttribute("d") || "").slice(0, 24);
};

const check = (film, [name, poses, seconds], report) => {
  const texts = [...film.querySelectorAll("text")];
  // The first is the paper.
  const shapes = [...film.querySelectorAll("path, circle, rect")].slice(1);
  const probe = document.createElement("span");
  probe.style.color = film.dataset.ink || "#222222";
  document.body.append(probe);
  const ink = getComputedStyle(probe).color;
  probe.remove();
  const known = new Map();
  const at = (shape) => {
    const moves = shape.querySelector("animate[attributeName=d], animate[attributeName=r]");
    if (moves) return places(shape);
    if (!known.has(shape)) known.set(shape, places(shape));
    return known.get(shape);
  };
  const hard = new Set(shapes.filter((shape) => isHard(shape, ink)));
  const { width, height } = film.viewBox.baseVal;
  const isOutside = (x, y, half) => Math.min(x, y, width - x, height - y) < half;
  const times = poses > 1 ? Array.from({ length: poses }, (_, k) => k) : [0];
  for (const time of times) {
    film.setCurrentTime(time / Math.max(1, poses - 1) * seconds);
    const boxes = texts.filter((text) => opacity(text) > 0.05).map((text) => [text.textContent, letters(text)]);
    boxes.forEach(([text, box], nth) => {
      report.texts += 1;
      if (isOutside(box.left, box.top, 1) || isOutside(box.right, box.bottom, 1)) report.add(name, time, text, "the edge");
      for (const [other, its] of boxes.slice(0, nth)) {
        const apart = Math.max(its.left - box.right, box.left - its.right, its.top - box.bottom, box.top - its.bottom);
        if (apart < 0) report.add(name, time, text, "text " + other);
      }
    });
    for (const shape of shapes) {
      if (opacity(shape) < 0.05) continue;
      const m = shape.getCTM(), { found, half } = at(shape), isIt = hard.has(shape);
      for (const [u, v] of found) {
        const x = m.a * u + m.c * v + m.e, y = m.b * u + m.d * v + m.f;
        if (isOutside(x, y, half)) report.add(name, time, named(shape), "the edge");
        if (!isIt) continue;
        for (const [text, box] of boxes) {
          const dx = Math.max(box.left - x, 0, x - box.right), dy = Math.max(box.top - y, 0, y - box.bottom);
          if (Math.hypot(dx, dy) < half) report.add(name, time, text, named(shape));
        }
      }
    }
  }
};

addEventListener("load", () => setTimeout(() => {
  const seen = new Set();
  const report = {
    texts: 0, lines: [],
    add(name, time, what, on) {
      const key = [name, what, on].join("|");
      if (!seen.has(key)) this.lines.push([name, "pose " + time, what, "on", on].join(" "));
      seen.add(key);
    },
  };
  const films = [...document.querySelectorAll("svg")];
  films.forEach((film) => film.pauseAnimations());
  films.forEach((film, nth) => check(film, pictures[nth], report));
  document.querySelector("pre").textContent = [report.texts, ...report.lines].join("\n");
}, 300));
