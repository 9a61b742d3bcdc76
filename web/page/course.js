// The site's data about the course: an outline, and the files and exercises of each chapter.

import {site} from "./dom.js";

const loading = new Map();

// Fetch packed data, once.
export function packed(name) {
  if (!loading.has(name)) loading.set(name, fetched(name).catch((error) => (loading.delete(name), Promise.reject(error))));
  return loading.get(name);
}

async function fetched(name) {
  const answer = await fetch(site(`data/${name}.data`));
  if (!answer.ok) throw new Error(`${name} could not be loaded (${answer.status}). Are you offline?`);
  return new Response(answer.body.pipeThrough(new DecompressionStream("deflate"))).json();
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
