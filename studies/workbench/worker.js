// A worker: keeps an engine, and starts another one after a failure that is no error of the user.

let module;
let engine;
const files = new Map();

function started() {
  engine = new Engine(module);
  for (const [name, bytes] of files) engine.ask('file', name, bytes);
}

function answered(words) {
  try {
    if (!engine) started();
    return engine.ask(...words);
  } catch (error) {
    engine = null;
    return { error: `The engine stopped: ${error.message}. It starts again with the next run.` };
  }
}

self.onmessage = ({ data }) => {
  if (data.module) {
    module = data.module;
    return;
  }
  if (data.file) {
    files.set(...data.file);
    if (engine) engine.ask('file', ...data.file);
    return;
  }
  const start = performance.now();
  const answer = answered(data.words);
  const seconds = (performance.now() - start) / 1000;
  self.postMessage({ ...answer, seconds, memory: engine ? engine.exports.memory.buffer.byteLength : 0 });
};
