// A folder on the reader's own computer, if the browser can open one. Its files are imported, and changes
// on the page are saved there as well.

import {decoded} from "./archive.js";
import {allStubs} from "../course.js";
import {workspace} from "./workspace.js";

export const canOpenFolders = () => "showDirectoryPicker" in window;

let linked = null; // {folder, known: Map of path -> text as it is in the folder}

// Let the reader choose a folder, and return its texts. If it contains chapters/, use that folder.
export async function chooseFolder() {
  const chosen = await window.showDirectoryPicker({mode: "readwrite"});
  const folder = await chosen.getDirectoryHandle("chapters").catch(() => chosen);
  return {folder, name: chosen.name, texts: await textsIn(folder)};
}

async function textsIn(folder) {
  const texts = {};
  for (const path of Object.keys(await allStubs())) {
    const [chapter, name] = path.split("/");
    try {
      const file = await (await (await folder.getDirectoryHandle(chapter)).getFileHandle(name)).getFile();
      texts[path] = decoded(await file.arrayBuffer(), path);
    } catch (error) {
      if (error.name !== "NotFoundError") throw error;
    }
  }
  return texts;
}

// Keep the folder and the page in step until the tab is closed.
export function link(folder, texts) {
  linked = {folder, known: new Map(Object.entries(texts))};
}

workspace.addEventListener("saved", async ({detail: {path}}) => {
  if (!linked) return;
  const text = await workspace.text(path);
  if (linked.known.get(path) === text) return;
  linked.known.set(path, text);
  const [chapter, name] = path.split("/");
  try {
    const place = await linked.folder.getDirectoryHandle(chapter, {create: true});
    const out = await (await place.getFileHandle(name, {create: true})).createWritable();
    await out.write(text);
    await out.close();
  } catch (error) {
    linked = null;
    workspace.tell("trouble", {words: `${path} could not be saved in the folder (${error.message}). It is kept in this browser.`});
  }
});

// Read the changes that an editor outside the browser has saved meanwhile.
addEventListener("focus", async () => {
  if (!linked) return;
  for (const [path, text] of Object.entries(await textsIn(linked.folder))) {
    if (text === linked.known.get(path)) continue;
    linked.known.set(path, text);
    await workspace.replace(path, text, "replaced by the file in your folder");
  }
});
