// The compiler beside the page: a text and a task in, an answer out.

const CHECK = 0, IMPORT = 5, letters = new TextEncoder(), words = new TextDecoder();
let module = null, wasm = null;
const begin = () => wasm = new WebAssembly.Instance(module).exports;

const answered = (text, task) => {
  const given = letters.encode(text), at = wasm.room(given.length);
  new Uint8Array(wasm.memory.buffer, at, given.length).set(given);
  const answer = wasm.answer(at, given.length, task);
  const length = new DataView(wasm.memory.buffer).getUint32(answer, true);
  const found = new Uint8Array(wasm.memory.buffer, answer + 4, length).slice();
  wasm.forget(answer);
  return task === CHECK || task === IMPORT ? JSON.parse(words.decode(found)) : found;
};

onmessage = ({ data }) => {
  if (data.module) {
    module = data.module;
    begin();
    return;
  }
  try {
    postMessage({ id: data.id, found: answered(data.text, data.task) });
  } catch (error) {
    // A machine that has trapped is of no more use; another one is.
    begin();
    postMessage({ id: data.id, broken: String(error) });
  }
};
