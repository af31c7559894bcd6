// Workers with engines, one for each question at a time.

class Engines {
  constructor(bytes, count) {
    const source = `'use strict';\n${kWorkerSource}`;
    const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
    this.waiting = [];
    this.free = [];
    this.workers = Array.from({ length: count }, () => this.start(url, bytes));
  }

  start(url, bytes) {
    const worker = new Worker(url);
    worker.postMessage({ module: bytes });
    worker.onmessage = ({ data }) => {
      const { resolve } = worker.question;
      worker.question = null;
      this.free.push(worker);
      resolve({ ...data.answer, seconds: data.seconds });
      this.next();
    };
    this.free.push(worker);
    return worker;
  }

  next() {
    while (this.free.length && this.waiting.length) {
      const worker = this.free.pop();
      worker.question = this.waiting.shift();
      worker.postMessage({ words: worker.question.words });
    }
  }

  ask(...words) {
    return new Promise((resolve) => {
      this.waiting.push({ words, resolve });
      this.next();
    });
  }

  /// A file for every worker, before its next question.
  add(name, bytes) {
    for (const worker of this.workers) worker.postMessage({ file: [name, bytes] });
  }

  /// Drops questions that no worker has begun.
  clear() {
    this.waiting = [];
  }
}
