// The service worker, with the list of all files of the site and what each contains.

import {createHash} from "node:crypto";
import path from "node:path";
import {readdir, readFile, writeFile} from "node:fs/promises";

import {WEB} from "./bundle.mjs";

const LATER = /^(pyodide\/|course)/; // the files for Python, which are fetched after the pages

export async function writeServiceWorker(out) {
  const hashes = {};
  const names = (await readdir(out, {recursive: true, withFileTypes: true})).filter((entry) => entry.isFile());
  for (const entry of names) {
    const file = path.join(entry.parentPath, entry.name);
    const name = path.relative(out, file).replaceAll(path.sep, "/");
    if (name === "sw.js" || name.endsWith(".LEGAL.txt")) continue;
    hashes[name] = createHash("sha256").update(await readFile(file)).digest("base64url").slice(0, 12);
  }
  const sorted = Object.entries(hashes).sort(([a], [b]) => (a < b ? -1 : 1));
  const version = createHash("sha256").update(JSON.stringify(sorted)).digest("base64url").slice(0, 12);
  const pick = (wanted) => Object.fromEntries(sorted.filter(([name]) => LATER.test(name) === wanted));
  const source = await readFile(path.join(WEB, "page", "sw.js"), "utf8");
  const list = `const VERSION = ${JSON.stringify(version)};\nconst FIRST = ${JSON.stringify(pick(false))};\nconst LATER = ${JSON.stringify(pick(true))};\n`;
  await writeFile(path.join(out, "sw.js"), list + source);
}
