// Workers with engines, one for each question at a time.

/// Questions of which many are asked at once, and which wait for all others.
const isOfSeries = ({ words }) => words[0] === 'case' || words[0] === 'outcome';

class Engines {
  constructor(module, count) {
    const source = `'use strict';\n${kWorkerSource}`;
    const url = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
    this.waiting = [];
    this.free = [];
    this.workers = Array.from({ length: count }, () => this.start(url, module));
  }

  start(url, module) {
    const worker = new Worker(url);
    worker.postMessage({ module });
    worker.onmessage = ({ data }) => {
      const { resolve } = worker.question;
      worker.question = null;
      this.free.push(worker);
      resolve(data);
      this.next();
    };
    worker.onerror = ({ message }) => worker.onmessage({ data: { error: `The engine does not answer: ${message}` } });
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
      const at = isOfSeries({ words }) ? -1 : this.waiting.findIndex(isOfSeries);
      this.waiting.splice(at < 0 ? this.waiting.length : at, 0, { words, resolve });
      this.next();
    });
  }

  /// A file for every worker, before its next question.
  add(name, bytes) {
    for (const worker of this.workers) worker.postMessage({ file: [name, bytes] });
  }

  /// Drops the questions of series that no worker has begun, whose promises stay open.
  dropSeries() {
    this.waiting = this.waiting.filter((question) => !isOfSeries(question));
  }
}
