// The site's data about the course: an outline, and the files and exercises of each chapter.

import {site} from "./dom.js";
import {packedAt} from "./packed.js";

const loading = new Map();

// Fetch packed data, once.
export function packed(name) {
  if (!loading.has(name)) {
    const data = packedAt(site(`data/${name}.data`));
    loading.set(name, data.catch((error) => (loading.delete(name), Promise.reject(error))));
  }
  return loading.get(name);
}

export const outline = () => packed("course");
export const chapterOf = (name) => packed(name);

// Return the stub of a file such as ch02_vectors/vector.py; undefined if there is no such file.
export async function stubOf(path) {
  return (await chapterOf(path.split("/")[0])).files[path];
}

// Return the stubs of all files that a student may edit, by path.
export async function allStubs() {
  const {chapters} = await outline();
  const each = await Promise.all(chapters.map(({name}) => chapterOf(name)));
  return Object.assign({}, ...each.map(({files}) => files));
}
