// Compile Python's library and the course in Pyodide's own Python: node compile.mjs IN OUT.
// IN has the folders course/, packages/ and library/ of web/pack.py.

import path from "node:path";
import {readFile} from "node:fs/promises";

import {loadPyodide} from "pyodide";

const [from, out] = process.argv.slice(2);
// With a different seed in every build, sets would be written in a different order.
const pyodide = await loadPyodide({env: {HOME: "/home/pyodide", PYTHONHASHSEED: "0"}});
for (const [folder, at] of [[from, "/in"], [out, "/out"]]) {
  pyodide.FS.mkdirTree(at);
  pyodide.FS.mount(pyodide.FS.filesystems.NODEFS, {root: folder}, at);
}
try {
  pyodide.runPython(await readFile(path.join(import.meta.dirname, "compile.py"), "utf8"));
} catch (error) {
  console.error(error.message); // Node itself would print a megabyte of Pyodide before the message
  process.exit(1);
}
