// The student's work as a zip, for make grade and for continuing on another computer.

import {strToU8, unzipSync, zipSync} from "fflate";

import {allStubs} from "../course.js";
import {workspace} from "./workspace.js";

const LARGEST = 5_000_000; // bytes of a zip, the same limit as in make grade
const LARGEST_FILE = 1_000_000; // bytes of one text, the same limit as in autograder/accepted_files.py
const MOST = 5_000; // entries

// Return a zip of every chapter in which the student has written something, or null if there is none.
export async function zipped() {
  const [written, stubs] = [workspace.written(), await allStubs()];
  const chapters = new Set(Object.keys(written).map((path) => path.split("/")[0]));
  if (!chapters.size) return null;
  const paths = Object.keys(stubs).filter((path) => chapters.has(path.split("/")[0]));
  return zipSync(Object.fromEntries(paths.map((path) => [path, strToU8(written[path] ?? stubs[path])])));
}

// Return the texts in a zip that are files of the course, and the names of all other files. Throws an
// Error with a message for the student if the zip cannot be read.
export async function unzipped(file) {
  if (file.size > LARGEST) throw new Error(`The file is larger than ${LARGEST / 1e6} MB. A zip of your work is far smaller.`);
  const stubs = await allStubs();
  const [texts, others, seen] = [{}, [], new Set()];
  let entries = 0;
  const filter = ({name, originalSize}) => {
    if (++entries > MOST) throw new Error(`The zip has more than ${MOST} files in it.`);
    if (/(^|\/)(\.|__MACOSX\/|__pycache__\/)|\/$/.test(name)) return false;
    const path = pathOf(name, stubs);
    if (path && originalSize > LARGEST_FILE) throw new Error(`${path} was rejected: it is larger than ${LARGEST_FILE.toLocaleString("en-US")} bytes`);
    if (!path) others.push(name);
    else if (seen.has(path)) throw new Error(`${path} is in the zip twice. Remove one of them.`);
    else seen.add(path);
    return Boolean(path);
  };
  for (const [name, bytes] of Object.entries(opened(new Uint8Array(await file.arrayBuffer()), filter))) {
    const path = pathOf(name, stubs);
    texts[path] = decoded(bytes, path);
  }
  if (!Object.keys(texts).length) {
    throw new Error("The zip contains no file of the course, such as ch02_vectors/vector.py. Zip the folders of the chapters.");
  }
  return {texts, others};
}

// Return the path of a file within the course, wherever it is in the zip; undefined for other files.
function pathOf(name, stubs) {
  const path = name.replaceAll("\\", "/").split("/").slice(-2).join("/");
  return Object.hasOwn(stubs, path) ? path : undefined;
}

function opened(bytes, filter) {
  try {
    return unzipSync(bytes, {filter});
  } catch (error) {
    throw error.code === undefined ? error : new Error("The file is damaged, or it is not an ordinary zip file. Zip the folders of the chapters again.");
  }
}

// Return the text of a file. If it is not UTF-8, throw an Error in the same words as make check.
export function decoded(bytes, path) {
  try {
    return new TextDecoder("utf-8", {fatal: true}).decode(bytes).replaceAll("\r\n", "\n");
  } catch {
    throw new Error(`${path} was rejected: it is not UTF-8: save it as UTF-8 in your editor`);
  }
}

