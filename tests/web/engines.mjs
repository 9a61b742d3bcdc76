// The site's engines in Node, for tests: node engines.mjs SITE. Each line of the input is a request,
// and each line of the output is the answer to it.

import "./in_node.mjs";
import {createInterface} from "node:readline";
import {pathToFileURL} from "node:url";

import {Engines} from "../../web/page/python/engines.js";

const base = pathToFileURL(`${process.argv[2]}/`);
const engines = new Engines({base, worker: new URL("../../web/page/python/worker.js", import.meta.url)});
const links = new Map();
const ANSWERS = ["frame", "stopped", "refused", "judged"]; // the last one to a message

const does = {
  async check({asked}) {
    const troubles = [];
    const started = performance.now();
    const seconds = () => (performance.now() - started) / 1000;
    const onTrouble = (failure) => troubles.push({failure, after: seconds()});
    try {
      return {report: await engines.check({...asked, onTrouble}), troubles, seconds: seconds()};
    } catch (error) {
      return {error: error.message, troubles};
    }
  },

  async try({asked}) {
    return engines.tryLine(asked);
  },

  scene({link, message}) {
    return new Promise((resolve) => {
      const got = [];
      const hear = (answer) => {
        got.push(answer);
        if (ANSWERS.includes(answer.kind)) resolve({answers: got});
      };
      if (!links.has(link)) links.set(link, engines.lab((answer) => links.get(link).hear(answer)));
      links.get(link).hear = hear;
      links.get(link).send(message);
    });
  },
};

for await (const line of createInterface({input: process.stdin})) {
  const {what, ...request} = JSON.parse(line);
  console.log(JSON.stringify(await does[what](request)));
}
process.exit(0);
