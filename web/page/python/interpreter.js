// One worker with Python, as the pool of engines sees it.

const MORE = 1; // s of grace after a time limit, for a loop that Python cannot interrupt

export class Interpreter {
  constructor(worker, base) {
    this.hear = () => undefined; // takes its messages, and {kind: "lost"} when it is ended from here
    this.whenEnded = () => undefined;
    this.words = null; // what to say about a scene when Python can no longer explain its failure
    this.ready = new Promise((resolve, reject) => Object.assign(this, {resolve, reject}));
    this.ready.catch(() => undefined); // the code that waits for it reports the error
    this.worker = new Worker(worker, {type: "module"});
    this.worker.onmessage = ({data}) => this.heard(JSON.parse(data));
    this.worker.onerror = (event) => this.heard({kind: "crashed", why: event.message ?? "its script could not be loaded"});
    this.worker.postMessage(JSON.stringify({base: String(base)}));
  }

  heard(message) {
    if (message.kind === "ready") {
      this.words = message;
      this.resolve();
    } else if (this.words) {
      this.hear(message);
    } else {
      this.end(`Python could not be started: ${message.why ?? message.kind}`);
    }
  }

  send(message) {
    this.worker.postMessage(JSON.stringify(message));
  }

  // Send a message, and return a promise of the next one that comes back. If none comes within the time
  // limit of this name, the promise is of {kind: "hung", why}.
  answer(message, limit) {
    return new Promise((resolve) => {
      const finish = (end) => {
        clearTimeout(timer);
        this.hear = () => undefined;
        resolve(end);
      };
      const {hung, limits} = this.words;
      const timer = setTimeout(() => finish({kind: "hung", why: hung[limit]}), 1000 * (limits[limit] + MORE));
      this.hear = finish;
      this.send(message);
    });
  }

  // End Python, whatever it is doing.
  end(why) {
    if (this.ended) return;
    this.ended = true;
    this.worker.terminate();
    this.whenEnded();
    this.reject(new Error(why));
    this.hear({kind: "lost", why});
    this.hear = () => undefined;
  }
}
