// The way of a stranger with real pointers and keys, and the same by keyboard alone. `node way.cjs PLAY.html FOLDER mouse|keys`
// tells what failed, and leaves the C sources in the folder beside the numbers that the page shows.
const fs = require("fs"), path = require("path");
const { chromium } = require("playwright-core");
const [, , file, folder, kind] = process.argv, isKeys = kind === "keys";
const failures = [], expect = (isMet, ...words) => { if (!isMet) failures.push(words.join(" ")); };

const WRONG = `mechanism! {
    struct FourBar {
        input theta: angle;
        param crank = 120mm;
        ground A(0, 0), D(400mm 0);
        pin B(120mm, 0), C(333mm, 255mm), P(180mm, 200mm);
        link AB(A, B) { length: crank }
        link BC(B, R, P);
        link DC(D, C);
        drive AB.angle = theta;
        output P, DC.angle;
    }
}`;

(async () => {
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: "reduce", acceptDownloads: true });
  const page = await context.newPage(), { keyboard, mouse } = page;
  page.on("pageerror", (error) => failures.push(String(error)));
  page.on("console", (message) => message.type() === "error" && failures.push(message.text()));
  page.on("request", (request) => /^(file|data|blob|about)/.test(request.url()) || failures.push(`asks for ${request.url()}`));
  await page.goto(`file://${file}`);
  const area = page.locator("#editor textarea"), text = () => area.inputValue();
  const shown = async () => (await page.locator("iframe.shown").elementHandle()).contentFrame();
  const settled = (is) => page.waitForFunction(is, null, { timeout: 20000 }).catch(() => failures.push(`never: ${is}`));
  const whole = () => settled(() => !document.querySelector("#messages .error") && document.querySelector("#stage").className === "" && document.querySelector("iframe.shown"));
  await whole();
  /// Waits until a handle stands still where it belongs by this text.
  const handled = async (name) => {
    await asked();
    let last = "";
    for (let k = 0; k < 100; k++) {
      const place = JSON.stringify(await page.locator(`#handles button[data-name=${name}]`).boundingBox());
      if (place === last) return;
      last = place;
      await page.waitForTimeout(100);
    }
    failures.push(`the handle of ${name} never stands still`);
  };
  /// Moves the focus by Tab to what has these words; nothing else is pressed.
  const tabTo = async (is) => {
    for (let k = 0; k < 200; k++) {
      if (await page.evaluate(() => document.activeElement.matches("#editor textarea"))) await keyboard.press("Escape");
      await keyboard.press("Tab");
      if (await page.evaluate(is)) return true;
    }
    failures.push(`Tab never comes to ${is}`);
    return false;
  };
  const press = async (selector, is) => {
    if (!isKeys) return page.click(selector);
    await tabTo(is);
    return keyboard.press("Enter");
  };
  // A four-bar with two mistakes is typed.
  if (isKeys) await tabTo(() => document.activeElement.matches("#editor textarea"));
  else await area.click();
  await keyboard.press("Control+A");
  await keyboard.insertText(WRONG);
  await settled(() => document.querySelectorAll("#messages .error").length > 0);
  // Each is mended by what its message says: the message selects its letters, and names what belongs there.
  for (let k = 0; k < 2; k++) {
    await settled(() => document.querySelector("#messages .error"));
    if (isKeys) {
      await tabTo(() => document.activeElement.matches("#messages button"));
      await keyboard.press("Enter");
    } else await page.locator("#messages .error button").first().click();
    const [what, marked] = await page.evaluate(() => {
      const area = document.querySelector("#editor textarea");
      return [document.querySelector("#messages .error").textContent, area.value.slice(area.selectionStart, area.selectionEnd)];
    });
    if (/no pin named `R`/.test(what)) {
      expect(marked === "R", "marked is", marked);
      await keyboard.insertText("C");
    } else {
      expect(/expected `,`/.test(what) && marked === "0", "the message does not say what is missing:", what, marked);
      await keyboard.press("ArrowLeft");
      await keyboard.insertText(",");
    }
    await page.waitForTimeout(400);
  }
  await whole();
  expect((await text()) === WRONG.replace("400mm 0", "400mm, 0").replace("B, R, P", "B, C, P") || (await text()) === WRONG.replace("400mm 0", "400mm ,0").replace("B, R, P", "B, C, P"), "mended is", await text());
  // The coupler is dragged, or the input moved by keys.
  const script = fs.readFileSync(path.join(folder, "frame.js"), "utf8");
  /// The frame that is shown, once it has this text, with what it is asked. One that begins anew answers nothing.
  const asked = async () => {
    const isThis = async (frame) => {
      await frame.evaluate(script);
      return (await frame.evaluate(() => ASKED.text())) === (await text());
    };
    for (let k = 0; k < 200; k++) {
      const frame = await shown();
      if (await isThis(frame).catch(() => false)) return frame;
      await page.waitForTimeout(100);
    }
    failures.push("the frame never has the text");
    return shown();
  };
  let frame = await asked();
  const state = () => frame.evaluate(() => ASKED.inputs());
  const before = await state();
  const stage = await page.locator("#stage").boundingBox();
  if (isKeys) {
    await tabTo(() => document.activeElement.matches("iframe.shown"));
    for (let k = 0; k < 40 && !(await frame.evaluate(() => document.activeElement.id === "figure")); k++) await keyboard.press("Tab");
    for (let k = 0; k < 10; k++) await keyboard.press("ArrowRight");
  } else {
    const [x, y] = await frame.evaluate(() => ASKED.spot("P"));
    await mouse.move(stage.x + x, stage.y + y);
    await mouse.down();
    await mouse.move(stage.x + x + 25, stage.y + y + 12, { steps: 6 });
    await mouse.up();
  }
  await page.waitForTimeout(200);
  expect((await state()).some((x, k) => x !== before[k]), "the machine does not follow");
  // A length is typed into its field: the text says so.
  if (isKeys) {
    for (let k = 0; k < 40 && !(await frame.evaluate(() => document.activeElement.matches("#params input[type=text], #params input:not([type=range])"))); k++) await keyboard.press("Tab");
  } else await frame.locator("#params input:not([type=range])").first().click({ clickCount: 3 });
  await keyboard.press("Control+A");
  await keyboard.insertText("11.5cm");
  await keyboard.press("Enter");
  await settled(() => /param crank = (11\.5cm|115mm)/.test(document.querySelector("#editor textarea").value));
  await whole();
  // A pin is moved: by the mouse, or by keys on its handle.
  const old = await text();
  await press("#move", () => document.activeElement.id === "move");
  await settled(() => document.querySelectorAll("#handles button:not([hidden])").length === 5 && !document.querySelector("#handles").hidden);
  const handle = page.locator("#handles button[data-name=C]");
  const at = await handle.boundingBox();
  if (isKeys) {
    await tabTo(() => document.activeElement.dataset.name === "C");
    await keyboard.press("Shift+ArrowRight");
    await page.waitForTimeout(500);
    await keyboard.press("ArrowUp");
  } else {
    const [x, y] = [at.x + at.width / 2, at.y + at.height / 2];
    await mouse.move(x, y);
    await mouse.down();
    for (let k = 1; k <= 5; k++) {
      await mouse.move(x + 6 * k, y - 4 * k);
      await page.waitForTimeout(120);
    }
    await page.waitForTimeout(400);
    // The scale stands still until it is let go, and the joint is where the pointer is.
    const now = await handle.boundingBox(), [u, v] = await (await asked()).evaluate(() => ASKED.spot("C"));
    expect(Math.hypot(now.x - at.x - 30, now.y - at.y + 20) < 3, "the handle is", now.x - at.x, now.y - at.y, "px away");
    expect(Math.hypot(stage.x + u - x - 30, stage.y + v - y + 20) < 3, "the joint is", stage.x + u - x, stage.y + v - y, "px away");
    await mouse.up();
  }
  await page.waitForTimeout(600);
  await whole();
  const moved = await text(), [, cx, cy] = /C\((-?[\d.]+)mm, (-?[\d.]+)mm\)/.exec(moved) ?? [];
  expect(+cx > 333 && +cy > 255, "the pin is at", cx, cy);
  expect(moved.replace(/C\([^)]*\)/, "") === old.replace(/C\([^)]*\)/, ""), "something else changed:", moved);
  if (!isKeys) {
    const grain = [cx, cy].map((digits) => (digits.split(".")[1] ?? "").length);
    expect(Math.max(...grain) <= 1, "no round numbers:", cx, cy);
    await page.click("#undo");
    expect((await text()) === old, "one step of undo does not bring a drag back");
    await page.click("#redo");
    // A tracer and a pin of the ground move as well; a neighbour's coordinate is taken as it is.
    for (const [name, dx, dy] of [["P", 20, -15], ["D", 18, 3]]) {
      await handled(name);
      const box = await page.locator(`#handles button[data-name=${name}]`).boundingBox(), was = await text();
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      await mouse.move(x, y);
      await mouse.down();
      await mouse.move(x + dx, y + dy, { steps: 4 });
      await page.waitForTimeout(250);
      await mouse.up();
      await page.waitForTimeout(500);
      expect((await text()) !== was, name, "does not move");
      if (name === "D") expect(/D\([\d.]+mm ?, ?0\)/.test(await text()), "D does not keep to the line of A:", await text());
      await page.click("#undo");
    }
    // What is no number stays, and is named.
    const written = await text();
    await area.fill(written.replace("P(180mm, 200mm)", "P(crank + 60mm, 200mm)"));
    await handled("P");
    const box = await page.locator("#handles button[data-name=P]").boundingBox(), [x, y] = [box.x + 13, box.y + 13];
    await mouse.move(x, y);
    await mouse.down();
    await mouse.move(x + 30, y, { steps: 3 });
    await mouse.up();
    expect(/P\.x is crank \+ 60mm/.test(await page.locator("#status").textContent()), "an expression is moved:", await page.locator("#status").textContent());
    expect((await text()).includes("P(crank + 60mm,"), "an expression is changed");
    await area.fill(written);
    await whole();
  }
  await press("#move", () => document.activeElement.id === "move");
  await whole();
  await page.waitForTimeout(400);
  // C is exported, all as well.
  for (const [task, name] of [[1, "c"], [4, "all"]]) {
    const coming = page.waitForEvent("download", { timeout: 20000 });
    await press(`[data-task="${task}"]`, task === 1 ? () => document.activeElement.dataset.task === "1" : () => document.activeElement.dataset.task === "4");
    await (await coming).saveAs(path.join(folder, `${name}.zip`));
  }
  // The numbers that the page shows at an angle.
  frame = await asked();
  const numbers = await frame.evaluate(() => [0.5, 1, 2.5, 4].map((theta) => [theta, ...ASKED.place("P", theta)]));
  fs.writeFileSync(path.join(folder, "numbers.json"), JSON.stringify(numbers));
  fs.writeFileSync(path.join(folder, "text.rs"), await text());
  if (!isKeys) {
    // A machine of PMKS+ that is pasted is a declaration.
    await page.click("#import");
    await page.fill("#source", "nonsense");
    await page.click("#convert");
    await page.waitForFunction(() => document.querySelector("#foreign .error").textContent !== "", null, { timeout: 8000 }).catch(() => failures.push("nonsense is imported"));
    for (const source of JSON.parse(fs.readFileSync(path.join(folder, "foreign.json"), "utf8"))) {
      await page.fill("#source", source);
      await page.click("#convert");
      await page.waitForFunction(() => !document.querySelector("#foreign").open, null, { timeout: 8000 }).catch(() => failures.push(`not imported: ${source.slice(0, 60)}`));
      await whole();
      expect((await text()).startsWith("mechanism! {"), "imported is", (await text()).slice(0, 80));
      await page.click("#import");
    }
    await page.keyboard.press("Escape");
  }
  // No violation of what axe knows, in both documents.
  const axe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
  for (const document of [page.mainFrame(), await shown()]) {
    await document.evaluate(axe);
    const found = await document.evaluate(async () => (await axe.run(window.document, { resultTypes: ["violations"], iframes: false })).violations.map(({ id, nodes }) => `${id} ${nodes[0].html.slice(0, 90)}`));
    expect(!found.length, "axe:", found.join(" | "));
  }
  await page.screenshot({ path: path.join(folder, `${kind}.png`) });
  await browser.close();
  console.log(failures.length ? failures.join("\n") : "all is well");
})().catch((error) => console.log(`the way ends: ${error.stack}\n${failures.join("\n")}`));
