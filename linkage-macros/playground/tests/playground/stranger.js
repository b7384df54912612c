// The way of a stranger through the playground, step by step; a failure is told.

(async () => {
  const failures = [], expect = (isMet, ...words) => { if (!isMet) failures.push(words.join(" ")); };
  addEventListener("error", ({ message }) => failures.push(message));
  addEventListener("securitypolicyviolation", ({ blockedURI }) => failures.push(`asks for ${blockedURI}`));
  const pause = (ms) => new Promise((done) => setTimeout(done, ms));
  const until = async (what, is) => {
    for (let k = 0; k < 400; k++) {
      if (is()) return;
      await pause(25);
    }
    failures.push(`never: ${what}`);
  };
  const area = document.querySelector("textarea"), all = (selector) => [...document.querySelectorAll(selector)];
  const told = () => document.querySelector("#messages").textContent;
  const type = (text) => {
    area.value = text;
    area.dispatchEvent(new Event("input"));
  };
  let saved = [];
  URL.createObjectURL = ((old) => (blob) => (saved.push(blob), old.call(URL, blob)))(URL.createObjectURL);
  HTMLAnchorElement.prototype.click = () => {};
  await until("a machine", () => all("iframe.shown").length === 1);
  const first = area.value, wrong = first.replace("link BC(B, C, P)", "link BC(B, R, P)").replace("D(400mm, 0)", "D(400mm 0)");
  type(wrong);
  await until("a mistake", () => all("#messages .error").length > 0);
  expect(document.querySelector("#stage").className === "old", "the machine does not say that it is old");
  const marked = all("#editor u").map((node) => node.textContent);
  expect(marked.length > 0, "nothing is marked");
  all("#messages button")[0].click();
  expect(document.activeElement === area && area.selectionEnd > area.selectionStart, "a mistake does not lead to its letters");
  type(first.replace("link BC(B, C, P)", "link BC(B, R, P)"));
  await until("the second mistake", () => told().includes("`R`"));
  expect(all("#editor u").map((node) => node.textContent).join() === "R", "marked is", all("#editor u").map((node) => node.textContent).join());
  type(first);
  await until("no mistake", () => told() === "" && document.querySelector("#stage").className === "");
  for (const [task, begins, least] of [[1, "PK", 1000], [2, "PK", 1000], [3, "use linkage_core::mechanism;", first.length], [0, "<!DOCTYPE html>", 1000]]) {
    saved = [];
    document.querySelector(`[data-task="${task}"]`).click();
    await until(`file ${task}`, () => saved.length === 1);
    const text = saved.length ? await saved[0].text() : "";
    expect(text.length > least && text.startsWith(begins), "file", task, "of", text.length, "letters begins with", text.slice(0, 20));
  }
  // What a slider sets is written; messages of others, and of other kinds, are not.
  const shown = document.querySelector("iframe.shown");
  const from = (source, data) => dispatchEvent(new MessageEvent("message", { data, source }));
  from(shown.contentWindow, { kind: "default", name: "crank", value: "100mm" });
  expect(area.value.includes("param crank = 100mm;"), "a slider does not write");
  from(window, { kind: "default", name: "crank", value: "1mm" });
  from(shown.contentWindow, { kind: "default", name: "crank", value: "1mm; } <b>" });
  from(shown.contentWindow, null);
  expect(area.value.includes("param crank = 100mm;"), "a stranger writes", area.value);
  document.querySelector("#undo").click();
  expect(area.value === first, "undo does not bring the text back");
  document.querySelector("#redo").click();
  expect(area.value.includes("100mm"), "redo does not bring it back again");
  // An address with markup is a text and nothing else; one that inflates to much is refused.
  const packed = async (text) => {
    const zipped = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
    const bytes = new Uint8Array(await new Response(zipped).arrayBuffer());
    return btoa(bytes.reduce((text, byte) => text + String.fromCharCode(byte), "")).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  };
  const evil = "mechanism! {\n    /// <img src=x onerror=alert(1)></script><script>alert(2)</script>\n    struct E { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: t } }\n}";
  location.hash = `#t=${await packed(evil)}`;
  await until("the text of the address", () => area.value === evil);
  await until("its machine", () => told() === "" && document.querySelector("#stage").className === "");
  expect(!document.querySelector("img") && !document.querySelector("#editor script"), "a text becomes an element");
  location.hash = `#t=${await packed("a".repeat(3e6))}`;
  await until("a refusal", () => document.querySelector("#status").textContent.includes("no machine that can be read"));
  expect(area.value === evil, "what is refused is shown");
  type("(".repeat(20000));
  await until("what the compiler fails on", () => told() !== "");
  type(first);
  await until("the next text", () => told() === "" && document.querySelector("#stage").className === "");
  expect(document.documentElement.scrollWidth <= innerWidth, "the page is wider than its window");
  expect(performance.getEntriesByType("resource").every(({ name }) => /^(blob|data):/.test(name)), "something was asked of the network");
  console.log(`the way: ${failures.length ? failures.join("; ") : "all is well"}.`);
})();
