// A folder of the reader's own computer, where the browser can open one: what is in it is taken, and
// what is written on the page is saved there as well.

import {decoded} from "./archive.js";
import {allStubs} from "./course.js";
import {workspace} from "./workspace.js";

export const canOpenFolders = () => "showDirectoryPicker" in window;

let linked = null; // {folder, known: Map of path -> text as it is in the folder}

// Let the reader choose a folder; return its texts. A folder with chapters/ in it stands for that.
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

// From now on keep the folder and the page the same, until the tab is closed.
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

// Take what an editor outside the browser has saved meanwhile.
addEventListener("focus", async () => {
  if (!linked) return;
  for (const [path, text] of Object.entries(await textsIn(linked.folder))) {
    if (text === linked.known.get(path)) continue;
    linked.known.set(path, text);
    await workspace.replace(path, text, "replaced by the file in your folder");
  }
});
