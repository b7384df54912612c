// Compares the answers of a page's script with those of a file, number by number.

const number = (hex) => fromBits(parseInt(hex.slice(0, 8), 16), parseInt(hex.slice(8), 16));
const tally = { numbers: 0, equal: 0, refused: 0, unheld: 0, wrong: 0, worst: 0 };
const wrong = (...words) => { if (++tally.wrong <= 5) console.log(...words); };
for (const line of require("fs").readFileSync(process.argv[2], "utf8").trim().split("\n")) {
  const [asked, expected] = line.split(" : "), [name, ...lists] = asked.split(" ");
  const [p, q, v, a, l, e = []] = lists.map((list) => list.split(",").slice(1).map(number));
  if (name === "stands") {
    state.p = p;
    const pose = new Pose(q), parts = [...PLAN.points.map((_, k) => pose.point(k)), ...PLAN.links.map((_, k) => pose.link(k))];
    const found = parts.map((part) => +!!part).join("");
    if (found !== expected) wrong(q, "stands", found, "for", expected, pose.error);
    // A guide stands with the link that it lies on.
    for (const { guide, on } of statements) {
      if (guide !== undefined && on !== null && !pose.guide(guide) !== !pose.link(on)) wrong(q, "guide", guide, "on", on);
    }
    continue;
  }
  if (name === "holding") {
    // Where nothing moves, no friction acts, and joints that jam hold the machine.
    Object.assign(state, { p, l, rate: 0 });
    const { motion, forces, holding, refused } = answersAt(new Pose(q));
    // The forces are there nevertheless.
    if (!refused !== !!(motion && forces)) wrong(q, "is refused for", refused?.kind);
    if (!refused && !holding) tally.unheld++;
  }
  const { numbers, error } = MACHINE[name](p, q, v, a, l, e);
  const { kind, group, name: named, by, unit, other } = error ?? {};
  const said = error && [kind, group, named ?? unit ?? "", by ?? "", other?.trend ?? "", other?.at ?? ""].join("|");
  if (expected.includes("|")) {
    const [kind, group, named, by, trend, at] = expected.split("|");
    const sought = [kind, group, named, by && number(by), trend, at && number(at)].join("|");
    tally.refused++;
    if (said !== sought) wrong(name, q, said, "for", sought);
  } else if (error) wrong(name, q, "is refused:", said);
  else {
    const sought = expected.split(",").slice(1).map(number), size = Math.max(...sought.map(Math.abs));
    if (sought.length !== numbers.length) wrong(name, numbers.length, "numbers for", sought.length);
    sought.forEach((x, k) => {
      tally.numbers++;
      if (Object.is(x, numbers[k])) tally.equal++;
      else tally.worst = Math.max(tally.worst, Math.abs(x - numbers[k]) / (size * EPSILON));
    });
  }
}
console.log(JSON.stringify(tally));
// Of what the browser's own functions compute two units in the last place of the answer's largest number are granted.
const isSame = FUSED ? tally.worst <= 4 : FOREIGN ? tally.worst <= 2 : tally.equal === tally.numbers;
process.exitCode = tally.wrong || !isSame ? 1 : 0;
