// The engine: a WebAssembly module that answers questions in JSON. For pages, workers and Node alike.

/// What the C library asks of its system; there are no files, arguments or variables.
function system(memory) {
  const view = () => new DataView(memory());
  const nothing = () => 0;
  const none = (count, size) => {
    view().setUint32(count, 0, true);
    view().setUint32(size, 0, true);
    return 0;
  };
  const kBadFile = 8;
  return new Proxy(
    {
      environ_sizes_get: none,
      args_sizes_get: none,
      environ_get: nothing,
      args_get: nothing,
      clock_time_get: (_clock, _precision, time) => {
        view().setBigUint64(time, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
      fd_write: (_file, parts, count, written) => {
        let bytes = 0;
        for (let i = 0; i < count; ++i) bytes += view().getUint32(parts + 8 * i + 4, true);
        view().setUint32(written, bytes, true);
        return 0;
      },
      proc_exit: (code) => {
        throw new Error(`the engine ended with code ${code}`);
      },
    },
    { get: (known, name) => known[name] || (() => kBadFile) },
  );
}

class Engine {
  constructor(module) {
    const memory = () => this.exports.memory.buffer;
    const imports = {};
    for (const { module: from } of WebAssembly.Module.imports(module)) imports[from] = system(memory);
    this.exports = new WebAssembly.Instance(module, imports).exports;
    this.exports._initialize();
  }

  /// @param words  lines of text; the last may be bytes
  ask(...words) {
    const last = words.pop();
    const head = new TextEncoder().encode(words.map((word) => `${word}\n`).join(''));
    const body = typeof last === 'string' ? new TextEncoder().encode(last) : new Uint8Array(last);
    const buffer = this.exports.gurney_buffer(head.length + body.length);
    const bytes = new Uint8Array(this.exports.memory.buffer, buffer, head.length + body.length);
    bytes.set(head);
    bytes.set(body, head.length);
    const length = this.exports.gurney_answer();
    const answer = new Uint8Array(this.exports.memory.buffer, this.exports.gurney_buffer(length), length);
    return JSON.parse(new TextDecoder().decode(answer));
  }
}
