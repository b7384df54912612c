// Declare, drag, take along: the text at the left, its machine at the right, the compiler beside both.

const $ = (selector) => document.querySelector(selector);
const area = $("#editor textarea"), painted = $("#editor pre"), list = $("#messages"), stage = $("#stage");
const MACHINES = {{machines}};
const CHECK = 0, IMPORT = 5;
const say = (text) => $("#status").textContent = text;

// ---- the compiler -----------------------------------------------------------------------------------

/// Eleven letters are nine bytes: all that can be printed but `<`.
const bytesOf = (text) => {
  const length = Math.floor((text.length * 9) / 11), bytes = new Uint8Array(length + 12), all = new DataView(bytes.buffer);
  // Three bytes each.
  const parts = new Uint32Array(3);
  for (let k = 0, at = 0; k < text.length; k += 11, at += 9) {
    parts.fill(0);
    for (let n = k; n < k + 11; n++) {
      // Letters that are left out at the end are the last one.
      const code = n < text.length ? text.charCodeAt(n) : 126;
      let carry = code - (code > 60 ? 33 : 32);
      for (let part = 2; part >= 0; part--) {
        const sum = parts[part] * 94 + carry;
        parts[part] = sum & 0xffffff;
        carry = sum >>> 24;
      }
    }
    for (let part = 0; part < 3; part++) all.setUint32(at + 3 * part, parts[part] << 8);
  }
  return bytes.subarray(0, length);
};
/// The compiler, by the program that unpacks it: the head of an archive says how much it holds.
const unpacked = async () => {
  const packed = bytesOf($("#wasm").textContent), program = await WebAssembly.instantiate(bytesOf($("#unpack").textContent));
  const { memory, room, unpacked } = program.instance.exports, at = room(packed.length);
  new Uint8Array(memory.buffer, at, packed.length).set(packed);
  const found = unpacked(at, packed.length);
  return new Uint8Array(memory.buffer, found, new DataView(packed.buffer).getUint32(5, true));
};

/// Milliseconds after which a text is given up.
const PATIENCE = 20000;
let module = null, worker = null, busy = null, count = 0;
const waiting = [];

const begin = () => {
  worker = new Worker(URL.createObjectURL(new Blob([$("#worker").textContent], { type: "text/javascript" })));
  worker.postMessage({ module });
  worker.onmessage = ({ data }) => answer(data);
};
const answer = (data) => {
  if (!busy || data.id !== busy.id) return;
  clearTimeout(busy.timer);
  const { done } = busy;
  busy = null;
  done(data);
  send();
};
const send = () => {
  if (busy || !module || !waiting.length) return;
  busy = waiting.shift();
  busy.timer = setTimeout(() => {
    worker.terminate();
    begin();
    answer({ id: busy.id, broken: "it took too long" });
  }, PATIENCE);
  worker.postMessage({ id: busy.id, text: busy.text, task: busy.task });
};
/// The compiler's answer; of several texts that wait to be checked the last one is, and the others have none.
const ask = (text, task) => new Promise((done) => {
  const older = task === CHECK ? waiting.findIndex((one) => one.task === CHECK) : -1;
  if (older >= 0) waiting.splice(older, 1)[0].done({});
  waiting.push({ id: ++count, text, task, done });
  send();
});

// ---- the text ---------------------------------------------------------------------------------------

const WORDS = new Set(("pub struct input param load let ground guide crank slider rrr rrp rpr prp rpp point pin link drive gravity mass force torque "
  + "spring friction stop unknown solve numerics export output mechanism on at through along towards between by mode uniform inertia radius length").split(" "));
let messages = [];
const PIECES = /\/\/[^\n]*|\/\*[^]*?(?:\*\/|$)|[\p{L}_][\p{L}\p{N}_]*|\d[\d._]*(?:[eE][-+]?\d+)?[\p{L}]*|\s+|./gsu;
const kindOf = (piece) => (/^\/[/*]/.test(piece) ? "em" : /^\d/.test(piece) ? "i" : WORDS.has(piece) ? "b" : null);

/// The text with its words and its mistakes marked. A mistake may begin or end inside a word.
const paint = () => {
  const text = area.value, cuts = messages.flatMap(({ from, to }) => [from, to]), nodes = [];
  let at = 0;
  for (const [piece] of text.matchAll(PIECES)) {
    const [from, to] = [at, at + piece.length], kind = kindOf(piece);
    const inner = [from, ...new Set(cuts.filter((cut) => cut > from && cut < to)), to].sort((a, b) => a - b);
    for (let k = 1; k < inner.length; k++) {
      const own = document.createTextNode(text.slice(inner[k - 1], inner[k]));
      const set = kind ? document.createElement(kind) : own;
      if (kind) set.append(own);
      const marks = messages.filter((message) => inner[k - 1] >= message.from && inner[k - 1] < message.to);
      if (!marks.length) nodes.push(set);
      else {
        const mark = document.createElement("u");
        if (marks.every(({ level }) => level === "note")) mark.className = "note";
        mark.append(set);
        nodes.push(mark);
      }
    }
    at = to;
  }
  painted.replaceChildren(...nodes, "\n");
};

const tell = (found) => {
  // What is missing behind the text, and what is about a whole declaration, still has a letter to stand at.
  const { length } = area.value;
  messages = found.map((message) => {
    const from = Math.min(message.from, Math.max(length - 1, 0));
    return { ...message, from, to: Math.min(Math.max(message.to, from + 1), length) };
  });
  paint();
  list.replaceChildren(...messages.map(({ message, help, level, from, to }) => {
    const line = document.createElement("li"), button = Object.assign(document.createElement("button"), { type: "button" });
    const put = (className, textContent) => button.append(Object.assign(document.createElement("span"), { className, textContent }));
    line.className = level;
    put("what", `line ${area.value.slice(0, from).split("\n").length}: ${message}`);
    if (help) put("help", help);
    button.onclick = () => {
      area.focus();
      area.setSelectionRange(from, to);
    };
    line.append(button);
    return line;
  }));
  // A reader of the screen hears of mistakes behind a pause, not at each letter.
  clearTimeout(tell.later);
  const mistakes = messages.filter(({ level }) => level !== "note");
  tell.later = setTimeout(() => $("#spoken").textContent = mistakes.length ? `${mistakes.length} mistakes. ${mistakes[0].message}` : "No mistakes.", 1000);
};

// ---- undo -------------------------------------------------------------------------------------------

const past = [], future = [];
let known = "", lastKind = "", lastTime = -Infinity;
/// Notes a change: what is typed, or slid, in one go is one step.
const note = (kind) => {
  const time = performance.now();
  if (kind !== lastKind || (time - lastTime > 700 && !kind.startsWith("move"))) past.push(known);
  [lastKind, lastTime, known] = [kind, time, area.value];
  future.length = 0;
};
const step = (from, to) => {
  if (!from.length) return;
  to.push(area.value);
  area.value = known = from.pop();
  lastKind = "";
  check();
  say(from === past ? "undone" : "done again");
};
const set = (text, kind) => {
  if (text === area.value) return;
  area.value = text;
  note(kind);
  check();
};

// ---- from the text to its machine -------------------------------------------------------------------

/// Two frames: one is shown while the next machine is drawn in the other.
const frames = [0, 1].map(() => {
  const frame = Object.assign(document.createElement("iframe"), { title: "The machine" });
  frame.setAttribute("sandbox", "allow-scripts allow-downloads");
  stage.append(frame);
  return frame;
});
let front = 0, state = "", good = null, began = 0;

/// The page with what its reader had set.
const withState = (page) => {
  const kept = JSON.stringify(state).replaceAll("<", "\\u003c");
  const begun = page.replace("<script>", () => `<script>globalThis.STATE = ${kept};${isMoving ? `globalThis.MOVED = ${JSON.stringify((held && seen?.view) ?? null)};` : ""}</script><script>`);
  return isMoving ? `${begun}<script>${$("#moved").textContent}</script>` : begun;
};

const check = async () => {
  paint();
  const text = area.value, begun = performance.now(), { found, broken } = await ask(text, CHECK);
  // What is said of an older text has its places there.
  if (text !== area.value || (!found && !broken)) return;
  if (broken) return tell([{ message: `the compiler failed on this text: ${broken}`, level: "error", from: 0, to: 1 }]);
  tell(found.messages);
  showPlaces(found.places ?? [], text);
  stage.classList.toggle("old", !found.page);
  if (!found.page) return;
  [good, began] = [found, begun];
  frames[1 - front].srcdoc = withState(found.page);
};

/// A number that a slider has set, written into the text as a default.
const written = (name, value) => {
  const text = area.value;
  for (const found of text.matchAll(new RegExp(`\\bparam\\s+(?:r#)?${name}\\s*(?::\\s*\\w+\\s*)?=\\s*`, "gu"))) {
    const start = found.index + found[0].length, line = text.slice(text.lastIndexOf("\n", found.index) + 1, found.index);
    if (!line.includes("//")) return text.slice(0, start) + value + text.slice(text.indexOf(";", start));
  }
  return text;
};

const isNumbers = (list, count) => Array.isArray(list) && list.length === count && list.every(Number.isFinite);
/// What a frame says is numbers and names, whoever wrote its text.
const isSeen = ({ view, origin, scale, points, frames }) => isNumbers(origin, 2) && scale > 0
  && isNumbers(Object.values(view ?? {}), 5) && Object.values(points ?? {}).every((at) => at === null || isNumbers(at, 2))
  && Object.values(frames ?? {}).every(({ at, cos, sin }) => isNumbers(at, 2) && isNumbers([cos, sin], 2));
addEventListener("message", ({ data, source }) => {
  const nth = frames.findIndex((frame) => frame.contentWindow === source);
  if (nth < 0 || typeof data !== "object" || data === null) return;
  if (data.kind === "ready" && nth !== front) {
    const hasFocus = document.activeElement === frames[front];
    front = nth;
    frames.forEach((frame, k) => frame.classList.toggle("shown", k === front));
    // Keys go on where the machine is: a frame that is hidden would keep them.
    if (hasFocus) frames[front].focus();
    say(`${Math.round(performance.now() - began)} ms`);
  }
  if (nth !== front) return;
  if (data.kind === "places" && isMoving && isSeen(data)) {
    seen = data;
    showHandles();
  }
  if (data.kind === "state" && typeof data.text === "string") state = data.text;
  // Another set of inputs drives the machine, which begins anew.
  if (data.kind === "again" && good) [began, frames[1 - front].srcdoc] = [performance.now(), withState(good.page)];
  if (data.kind === "default" && /^[\p{L}_][\p{L}\p{N}_]*$/u.test(data.name) && /^[-\w.()*/^·²³ ]{1,40}$/u.test(data.value)) {
    // The text says it from now on.
    state = state.split("&").filter((part) => part.split("=")[0] !== encodeURIComponent(data.name)).join("&");
    set(written(data.name, data.value), `slide ${data.name}`);
  }
});

area.addEventListener("input", () => {
  note("type");
  check();
});
let isLeaving = false;
area.addEventListener("keydown", (event) => {
  const leaves = event.key === "Tab" && isLeaving;
  isLeaving = event.key === "Escape" || (isLeaving && event.key === "Shift");
  if (event.key !== "Tab" || leaves || event.shiftKey) return;
  event.preventDefault();
  area.setRangeText("    ", area.selectionStart, area.selectionEnd, "end");
  note("type");
  check();
});
addEventListener("keydown", (event) => {
  const key = event.key.toLowerCase();
  if (!(event.ctrlKey || event.metaKey) || (key !== "z" && key !== "y")) return;
  event.preventDefault();
  if (key === "y" || event.shiftKey) step(future, past);
  else step(past, future);
});
$("#undo").onclick = () => step(past, future);
$("#redo").onclick = () => step(future, past);

// ---- taking it along --------------------------------------------------------------------------------

const save = (name, data, type) => {
  const href = URL.createObjectURL(new Blob([data], { type }));
  Object.assign(document.createElement("a"), { href, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(href), 1000);
};
const FILES = { 4: ["_all.zip", "application/zip"], 1: ["_c.zip", "application/zip"], 2: [".fmu", "application/zip"], 3: [".rs", "text/plain"], 0: [".html", "text/html"] };
for (const button of document.querySelectorAll("[data-task]")) {
  button.onclick = async () => {
    const task = +button.dataset.task, [ending, type] = FILES[task];
    if (messages.some(({ level }) => level !== "note") || !good) return say("first mend the mistakes");
    const data = task === CHECK ? good.page : (await ask(area.value, task)).found;
    if (!data?.length) return say("there is no such solver");
    save(`${good.name}${ending}`, data, type);
    say(`${good.name}${ending} is saved`);
  };
}

const through = async (data, stream) => new Uint8Array(await new Response(new Blob([data]).stream().pipeThrough(stream)).arrayBuffer());
const inBase64 = (data) => btoa(data.reduce((text, byte) => text + String.fromCharCode(byte), "")).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
const fromBase64 = (text) => Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
/// The most letters that an address may inflate to.
const MOST = 1e5;

$("#share").onclick = async () => {
  const packed = inBase64(await through(area.value, new CompressionStream("deflate-raw")));
  history.replaceState(null, "", `#t=${packed}${state && `&${state}`}`);
  try {
    await navigator.clipboard.writeText(location.href);
    say("the address is copied");
  } catch {
    say("the address is above: copy it");
  }
};
/// The text of the address, whoever wrote it: it is compiled, and nothing else. A little may inflate to much.
const shared = async () => {
  const [, packed, , rest] = /^#t=([\w-]+)(&(.*))?$/.exec(location.hash) ?? [];
  if (!packed) return location.hash.length > 1 ? null : undefined;
  try {
    const reader = new Blob([fromBase64(packed)]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
    const letters = new TextDecoder();
    let text = "";
    for (;;) {
      const { done, value } = await reader.read();
      if (done) {
        state = rest ?? "";
        return text + letters.decode();
      }
      text += letters.decode(value, { stream: true });
      if (text.length > MOST) {
        await reader.cancel();
        return null;
      }
    }
  } catch {
    return null;
  }
};
const take = async () => {
  const text = await shared();
  if (text === null) say("the address holds no machine that can be read");
  return text ?? null;
};

// ---- machines of others ------------------------------------------------------------------------------

/// A text that is no declaration but one of another program.
const FOREIGN = /^\s*(https?:\/\/\S+\?|\?|\{|M\[)/;
/// Takes it in place of the text; what is wrong with it is returned.
const convert = async (source) => {
  const { found } = await ask(source, IMPORT);
  if (!found?.text) return found?.mistake ?? "this cannot be read";
  state = "";
  set(found.text, "import");
  say("it is a declaration now");
  return null;
};
area.addEventListener("paste", (event) => {
  const source = event.clipboardData.getData("text");
  if (!FOREIGN.test(source)) return;
  event.preventDefault();
  convert(source).then((mistake) => mistake && say(mistake));
});
const dialog = $("#foreign");
$("#import").onclick = () => {
  dialog.querySelector(".error").textContent = "";
  dialog.showModal();
};
$("#convert").onclick = async () => {
  const mistake = await convert($("#source").value);
  dialog.querySelector(".error").textContent = mistake ?? "";
  if (mistake === null) dialog.close();
};
$("#close").onclick = () => dialog.close();
dialog.querySelector("[type=file]").onchange = async ({ target }) => $("#source").value = (await target.files[0]?.text()) ?? "";

{{move}}
// ---- beginning --------------------------------------------------------------------------------------

MACHINES.forEach(([name], k) => $("#machines").add(new Option(name, k)));
$("#machines").onchange = ({ target }) => {
  state = "";
  set(MACHINES[target.value][1], "machine");
};
area.value = known = (await take()) ?? MACHINES[0][1];
paint();
addEventListener("hashchange", async () => {
  const text = await take();
  if (text !== null) set(text, "address");
});
module = await WebAssembly.compile(await unpacked());
begin();
check();
