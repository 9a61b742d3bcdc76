// The engines of a page: workers that run Python. One runs checks, one plays scenes when the reader opens
// one, and one more is kept warm to replace a worker that has to be ended. That one starts when the page
// has been quiet for a while, so that it does not slow down the first check, or when a single check takes long.
//
//   const engines = new Engines({base, worker});  the addresses of the site's folder and of worker.js
//   engines.start();        start Python; the first call of check or lab does so as well
//   await engines.ready;    Python is ready
//   await engines.check({files, chapter, exercise, given, seed, onProgress, onTrouble});
//   await engines.tryLine({files, chapter, given, lines, line});
//   engines.lab(onAnswer);  returns a link: send(message), close() and busy

import {runChecks} from "./checker.js";
import {Interpreter} from "./interpreter.js";
import {Scenes} from "./scenes.js";
import {tryLine} from "./trying.js";

const QUIET = 5000; // ms

export class Engines {
  constructor({base, worker = new URL("worker.js", base)}) {
    Object.assign(this, {base, worker});
    this.all = new Set();
    this.warm = null; // an interpreter that is not in use yet
    this.checker = null; // a promise of the interpreter that runs checks
    this.turn = Promise.resolve(); // the queue of checks, which run one after the other
    this.scenes = new Scenes(() => this.take());
    this.ready = new Promise((resolve) => (this.tellReady = resolve));
  }

  start() {
    this.forChecks().catch(() => undefined); // a later check reports the error
  }

  check({files, chapter, exercise = null, given = [], seed = "1", ...hear}) {
    const asked = {files, chapter, exercise, given, seed};
    const onLong = () => this.warmUpIn(0);
    const next = async () => {
      const interpreter = await this.forChecks();
      clearTimeout(this.later); // the page is not quiet
      return interpreter;
    };
    const report = this.turn.then(() => runChecks(asked, next, {...hear, onLong}));
    this.turn = report.catch(() => undefined).then(() => this.warmUpIn(QUIET));
    return report;
  }

  // Run a line of Python after the checks that are running now. Return a promise of what it shows.
  tryLine(asked) {
    const shown = this.turn.then(() => tryLine(asked, () => this.forChecks()));
    this.turn = shown.catch(() => undefined);
    return shown;
  }

  lab(onAnswer) {
    return this.scenes.link(onAnswer);
  }

  async forChecks() {
    this.checker ??= this.take();
    try {
      const interpreter = await this.checker;
      if (!interpreter.ended) return interpreter;
    } catch (error) {
      this.checker = null;
      throw error;
    }
    this.checker = this.take();
    return this.checker;
  }

  // Return a promise of a ready interpreter, and soon have another one warm.
  async take() {
    const interpreter = this.warm ?? this.make();
    this.warm = null;
    await interpreter.ready;
    this.warmUpIn(QUIET);
    return interpreter;
  }

  warmUpIn(time) {
    clearTimeout(this.later);
    this.later = setTimeout(() => (this.warm ??= this.make()), time);
  }

  make() {
    const interpreter = new Interpreter(this.worker, this.base);
    this.all.add(interpreter);
    interpreter.ready.then(this.tellReady, () => undefined);
    interpreter.whenEnded = () => {
      this.all.delete(interpreter);
      if (this.warm === interpreter) this.warm = null;
    };
    return interpreter;
  }
}
