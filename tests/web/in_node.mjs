// The page's engines in Node: what a page has of a browser, and node has not.

import {readFile} from "node:fs/promises";
import {fileURLToPath} from "node:url";
import {Worker as NodeWorker, isMainThread, parentPort} from "node:worker_threads";

const fromWeb = globalThis.fetch;
globalThis.fetch = async (address) =>
  new URL(address).protocol === "file:" ? new Response(await readFile(fileURLToPath(address))) : fromWeb(address);

if (isMainThread) {
  globalThis.Worker = class {
    constructor(address) {
      this.worker = new NodeWorker(new URL(import.meta.url), {workerData: null, argv: [String(address)]});
      this.worker.on("message", (data) => this.onmessage?.({data}));
      this.worker.on("error", (error) => this.onerror?.({message: error.message}));
    }

    postMessage(data) {
      this.worker.postMessage(data);
    }

    terminate() {
      this.worker.terminate();
    }
  };
} else {
  // Some browsers round their clocks to this number of milliseconds. Such a clock counts the processor
  // time here, because a test that compares times would fail on a busy machine.
  const step = Number(process.env.CLOCK_STEP ?? 0);
  const used = ({user, system}) => (user + system) / 1000;
  if (step) performance.now = () => Math.floor(used(process.cpuUsage()) / step) * step;
  globalThis.self = {postMessage: (data) => parentPort.postMessage(data)};
  await import(process.argv[2]);
  parentPort.on("message", (data) => globalThis.self.onmessage({data}));
}
