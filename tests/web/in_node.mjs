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
  globalThis.self = {postMessage: (data) => parentPort.postMessage(data)};
  await import(process.argv[2]);
  parentPort.on("message", (data) => globalThis.self.onmessage({data}));
}
