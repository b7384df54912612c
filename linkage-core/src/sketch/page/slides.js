// Cylinders, blocks, sleeves and guides, of a machine that has any of them.

/// The length by which a guide exceeds the travel of its blocks, in pixels.
const OVERRUN = 27;
/// How far links slide, how long cylinders are and which guides lie still, over all poses.
const travel = { slides: [], lengths: new Map(), stillGuides: new Set() };
const orIdle = ([least, most]) => (least <= most ? [least, most] : [0, 0]);

const survey = (poses) => {
  travel.slides = PLAN.links.map((_, link) => poses.reduce((range, pose) => {
    const frame = pose.link(link);
    return frame ? widened(range, frame.slide) : range;
  }, NOTHING));
  for (const { members, pin } of statements) {
    for (const member of members) {
      if (member.shape !== "cylinder") continue;
      const lengths = poses.map((pose) => abs(pose.dimension(member)));
      travel.lengths.set(member.link, lengths.reduce(widened, NOTHING));
    }
  }
  travel.stillGuides = new Set(PLAN.guides.map((_, guide) => guide).filter((guide) => {
    const frames = poses.map((pose) => pose.guide(guide)).filter(Boolean), [first] = frames;
    return frames.every(({ at, cos, sin }) => apart(at, first.at) < 1e-9 && abs(cos - first.cos) + abs(sin - first.sin) < 1e-9);
  }));
};

/// From where to where a block slides on a link of its own group.
const slidesOn = (link) => {
  const { members } = statements.find(({ members }) => members.some((member) => member.link === link));
  return orIdle(travel.slides[members.find(({ shape }) => shape === "sleeve").link]);
};

/// From where to where a guide is drawn, in metres along it.
const endsOf = (guide) => {
  const links = allMembers.filter((member) => member.guide === guide).map(({ link }) => travel.slides[link]);
  const [least, most] = orIdle(links.reduce((range, [a, b]) => widened(widened(range, a), b), NOTHING));
  return [least - OVERRUN / view.scale, most + OVERRUN / view.scale];
};

assign(SHAPES, {
  "cylinder": (pose, { link, pivot }, { pin }) => {
    const [a, b] = [pivot, pin].map((point) => onPage(pose.point(point)));
    const [shortest, longest] = travel.lengths.get(link).map((length) => length * view.scale);
    const tube = max(min(shortest - 0.12 * (longest - shortest) - 10, apart(a, b) - 10), 0.3 * shortest);
    const others = joints[link].filter((point) => point !== pin);
    return {
      ...(others.length > 1 ? outline(others.map((point) => onPage(pose.point(point)))) : {}),
      rod: pathOf([a, along(a, b, 8)]) + pathOf([along(a, b, tube), b]),
      tube: pathOf([along(a, b, 8, 7), along(a, b, tube, 7), along(a, b, tube, -7), along(a, b, 8, -7)], true),
    };
  },
  "block": (pose, member) => {
    const frame = pose.link(member.link), spots = spotsOf(pose, member.link);
    const seat = placed(frame, [0, -pose.dimension(member)]), stub = pathOf([onPage(seat), onPage(frame.at)]);
    const { bar = "", plate } = spots.length > 1 ? outline(spots) : {};
    return { bar: bar + stub, plate, block: { ...frame, at: seat } };
  },
  "sleeve": (pose, { link }) => {
    const spots = spotsOf(pose, link);
    return { ...(spots.length > 1 ? outline(spots) : {}), block: pose.link(link) };
  },
  "slotted_bar": (pose, member) => {
    const frame = pose.link(member.link), offset = pose.dimension(member), over = OVERRUN / view.scale;
    const [least, most] = slidesOn(member.link);
    const own = joints[member.link].map((point) => pose.point(point)).filter(Boolean).map((spot) => seenFrom(frame, spot));
    const reach = own.filter(([, y]) => abs(y - offset) * view.scale < 1).map(([x]) => x);
    const ends = [min(least - over, ...reach), max(most + over, ...reach)];
    const line = pathOf(ends.map((x) => onPage(placed(frame, [x, offset]))));
    const stub = pathOf([onPage(frame.at), onPage(placed(frame, [0, offset]))]);
    const isAside = own.some(([, y]) => abs(y - offset) * view.scale >= 1);
    const { bar = "", plate } = isAside && own.length > 1 ? outline(spotsOf(pose, member.link)) : {};
    return { bar: line + bar + (offset ? stub : ""), plate };
  },
  "yoke": (pose, member, { members }) => {
    const yoke = pose.link(member.link), { link } = members.find(({ shape }) => shape === "sleeve");
    const first = { ...pose.link(link), at: placed(yoke, [0, pose.dimension(member)]) };
    const slot = { ...first, at: placed(first, [0, pose.dimension(member, 1)]) };
    const [least, most] = slidesOn(member.link), over = OVERRUN / view.scale;
    const line = [min(least - over, 0), max(most + over, 0)].map((x) => onPage(placed(slot, [x, 0])));
    const { bar = "", plate } = outline([...spotsOf(pose, member.link), onPage(yoke.at)]);
    const stub = pathOf([yoke.at, first.at, slot.at].map(onPage));
    return { bar: pathOf(line) + bar + stub, plate, block: yoke };
  },
});

/// The guides that a link carries: a bar as long as its blocks go, tied to the nearest joint.
const carriedBy = (pose, link) =>
  statements.filter(({ guide, on }) => guide !== undefined && on === link).map(({ guide }) => {
    const frame = pose.guide(guide);
    if (!frame) return "";
    const [from, to] = endsOf(guide), spots = joints[link].map((point) => pose.point(point)).filter(Boolean);
    const ties = (spots.length ? spots : [pose.link(link).at]).map((spot) => {
      const foot = placed(frame, [clamp(seenFrom(frame, spot)[0], from, to), 0]);
      return [spot, foot].map(onPage);
    });
    const [tie] = ties.sort((a, b) => apart(...a) - apart(...b));
    return pathOf([from, to].map((x) => onPage(placed(frame, [x, 0])))) + (apart(...tie) > 2 ? pathOf(tie) : "");
  }).join("");

const rail = (frame, [from, to]) => {
  const [a, b] = [from, to].map((x) => x * view.scale);
  const seat = made("g", { class: "still", transform: `${seatOf(frame)} translate(0 9.5)` }, nodes.ground);
  made("path", { d: `M${short(a)} 0H${short(b)}` }, seat);
  let hatches = "";
  for (let x = a + 6; x <= b; x += 7) hatches += `M${short(x)} 0l-6 7`;
  made("path", { d: hatches, class: "thin" }, seat);
};
