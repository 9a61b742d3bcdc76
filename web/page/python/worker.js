// Python in its own thread. It receives the messages of engines.js, and Python answers them.

import {packedAt} from "../packed.js";

const UNPACK = `
import io, lzma, os, sys, zipfile
places = {"packages": next(path for path in sys.path if path.endswith("site-packages")), "course": "/course"}
with lzma.open("/course.xz") as packed:
    content = io.BytesIO(packed.read())
with zipfile.ZipFile(content) as archive:
    for name in archive.namelist():
        part, _, path = name.partition("/")
        file = f"{places[part]}/{path}"
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(file, "wb") as target:
            target.write(archive.read(name))
os.remove("/course.xz")
sys.path.insert(0, "/course")
`;
const POLLS = 16; // the number of times that Python asks before the clock is read again
const SIGALRM = 14;
const quiet = () => undefined;

console.error = quiet; // what Pyodide prints there is reported to the page below, by say

let receive = null;
let deadline = Infinity;
let polls = 0;

// Python reads entry 0 very often, to see whether Ctrl-C has been pressed. Any signal works there.
const clock = {
  get 0() {
    if (++polls % POLLS || performance.now() < deadline) return 0;
    deadline = Infinity;
    return SIGALRM;
  },
  set 0(_) {},
};
const forPython = {
  post: (text) => self.postMessage(text),
  startClock(seconds) {
    deadline = performance.now() + 1000 * seconds;
  },
  stopClock() {
    deadline = Infinity;
  },
};

// Return the path and the text of each stub and given module. The pack has no copy of them, because the
// pages have them as well.
async function chapterFiles(base) {
  const data = (name) => packedAt(new URL(`data/${name}.data`, base));
  const {chapters} = await data("course");
  const each = await Promise.all(chapters.map(({name}) => data(name)));
  return each.flatMap(({files, complete}) => Object.entries({...files, ...complete}));
}

async function start(base) {
  const folder = new URL("pyodide/", base).href;
  const course = fetch(new URL("course.xz", base)).then((answer) => answer.arrayBuffer());
  const chapters = chapterFiles(base);
  const {loadPyodide} = await import(`${folder}pyodide.mjs`);
  const python = await loadPyodide({
    indexURL: folder.replace("file://", ""), // Node, in which tests run this, needs a path
    packageBaseUrl: folder, // nothing is requested from another host
    stdout: quiet,
    stderr: quiet,
  });
  python.FS.writeFile("/course.xz", new Uint8Array(await course));
  python.runPython(UNPACK);
  for (const [path, text] of await chapters) {
    const file = `/course/chapters/${path}`;
    python.FS.mkdirTree(file.slice(0, file.lastIndexOf("/")));
    python.FS.writeFile(file, text);
  }
  python.registerJsModule("worker", forPython);
  python.setInterruptBuffer(clock);
  const main = python.pyimport("web.python.browser.main");
  receive = main.receive;
  main.start();
}

// Report a failure below Python, such as an os._exit in the student's code or exhausted memory.
function say(error) {
  const code = error.status ?? error.exitCode;
  self.postMessage(JSON.stringify(code === undefined ? {kind: "crashed", why: error.message} : {kind: "left", code}));
}

self.onmessage = async ({data}) => {
  try {
    if (receive) {
      receive(data);
    } else {
      await start(JSON.parse(data).base);
    }
  } catch (error) {
    say(error);
  }
};
