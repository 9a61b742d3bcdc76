// Bundle the scripts and the style sheet, and pack data that scripts fetch.

import {deflateSync} from "node:zlib";
import path from "node:path";
import {copyFile, mkdir, readFile, writeFile} from "node:fs/promises";

import {build} from "esbuild";

export const WEB = path.join(import.meta.dirname, "..");
const PYODIDE = ["pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm"]; // and what pack.py has written

// Write assets/, and return the names of the entries. A name changes whenever its content changes.
export async function bundle(out) {
  const shared = {
    bundle: true,
    minify: true,
    format: "esm",
    target: "es2022",
    legalComments: "linked",
    metafile: true,
    outdir: path.join(out, "assets"),
    nodePaths: [path.join(WEB, "node_modules")],
    logLevel: "warning",
  };
  const page = (name) => path.join(WEB, "page", name);
  const worker = await build({...shared, entryPoints: [page("python/worker.js")], entryNames: "[name]-[hash]"});
  const workerFile = entries(worker.metafile)["worker.js"];
  const made = await build({
    ...shared,
    splitting: true,
    entryPoints: [page("main.js"), page("styles/site.css")],
    entryNames: "[name]-[hash]",
    chunkNames: "[name]-[hash]",
    define: {WORKER: JSON.stringify(path.basename(workerFile))},
  });
  const names = entries(made.metafile);
  return {script: names["main.js"], style: names["site.css"]};
}

function entries(metafile) {
  const found = Object.entries(metafile.outputs).filter(([, output]) => output.entryPoint);
  return Object.fromEntries(found.map(([file, output]) => [path.basename(output.entryPoint), `assets/${path.basename(file)}`]));
}

export async function copyPyodide(out) {
  await mkdir(path.join(out, "pyodide"), {recursive: true});
  for (const name of PYODIDE) {
    await copyFile(path.join(WEB, "node_modules", "pyodide", name), path.join(out, "pyodide", name));
  }
  // Leave out its list of packages, because none is used.
  const lock = await readJson(path.join(WEB, "node_modules", "pyodide", "pyodide-lock.json"));
  await writeFile(path.join(out, "pyodide", "pyodide-lock.json"), JSON.stringify({...lock, packages: {}}));
}

// Pack data that a script fetches and unpacks. This takes a third of the size on any server.
export async function writePacked(file, data) {
  await mkdir(path.dirname(file), {recursive: true});
  await writeFile(file, deflateSync(JSON.stringify(data), {level: 9}));
}

export const readJson = async (file) => JSON.parse(await readFile(file, "utf8"));
