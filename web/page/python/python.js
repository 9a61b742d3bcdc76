// The single pool of engines of this page. Python starts when the reader is about to need it.

import {site} from "../dom.js";
import {Engines} from "./engines.js";

let pool = null;

export function engines() {
  pool ??= new Engines({base: site("./"), worker: site(`assets/${WORKER}`)});
  return pool;
}

export function warmUp() {
  engines().start();
}
