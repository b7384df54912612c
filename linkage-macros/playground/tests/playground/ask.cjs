// What the compiler for a browser answers, written into a folder beside the texts.
const fs = require("fs"), [, , page, folder] = process.argv;
const html = fs.readFileSync(page, "utf8"), letters = /<script type="text\/plain" id="wasm">([^<]*)</.exec(html)[1];
const bytesOf = new Function(`${/const bytesOf = [^]*?\n};\n/.exec(html)[0]} return bytesOf;`)();
const wasm = new WebAssembly.Instance(new WebAssembly.Module(require("zlib").gunzipSync(bytesOf(letters)))).exports;
const answered = (text, task) => {
  const given = Buffer.from(text), at = wasm.room(given.length);
  new Uint8Array(wasm.memory.buffer, at, given.length).set(given);
  const answer = wasm.answer(at, given.length, task), length = new DataView(wasm.memory.buffer).getUint32(answer, true);
  const found = Buffer.from(new Uint8Array(wasm.memory.buffer, answer + 4, length));
  wasm.forget(answer);
  return found;
};
for (const file of fs.readdirSync(folder).filter((file) => file.endsWith(".rs"))) {
  const text = fs.readFileSync(`${folder}/${file}`, "utf8");
  for (const task of [0, 1, 2, 3, 4]) fs.writeFileSync(`${folder}/${file}.${task}`, answered(text, task));
}
const text = fs.readFileSync(`${folder}/four_bar.rs`, "utf8");
for (let k = 0; k < 20; k++) answered(text, 0);
const begun = wasm.memory.buffer.byteLength;
for (let k = 0; k < 300; k++) answered(text, 0);
console.log(begun, wasm.memory.buffer.byteLength);
