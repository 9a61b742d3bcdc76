// The section "Your work" of the start page: download your work, bring it back, or start over.

import {unzipped, zipped} from "./archive.js";
import {ask} from "../ask.js";
import {outline} from "../course.js";
import {button, count, download, el} from "../dom.js";
import {canOpenFolders, chooseFolder, link} from "./folder.js";
import {showCopies} from "./copies.js";
import {fact, setFact} from "./store.js";
import {workspace} from "./workspace.js";

export async function startWork(section) {
  await workspace.opened();
  const status = el("p", {role: "status"});
  const say = (words, kind = "") => {
    status.textContent = words;
    status.className = `note ${kind}`;
  };
  const guarded = (act) => async () => {
    try {
      await act();
    } catch (error) {
      if (error.name !== "AbortError") say(error.message ?? String(error), "problem");
    }
  };
  const summary = el("p");
  const name = el("input", {type: "text", id: "zip-name", maxLength: 60, size: 20, autocomplete: "name", value: (await fact("name")) ?? ""});
  name.onchange = () => setFact("name", name.value.trim());
  const file = el("input", {type: "file", accept: ".zip,application/zip", id: "zip-file", hidden: true});
  file.onchange = guarded(async () => {
    const [chosen] = file.files;
    file.value = "";
    if (chosen) await take(await unzipped(chosen), chosen.name, say);
  });
  const open = guarded(async () => {
    const {folder, name: folderName, texts} = await chooseFolder();
    if (Object.keys(texts).length && !(await take({texts, others: []}, folderName, say))) return;
    link(folder, texts);
    say(`What you write is saved in the folder ${folderName} as well, until you close this tab.`, "good");
  });
  const save = guarded(async () => {
    await workspace.saveAll();
    const zip = await zipped();
    if (!zip) return say("You have not written anything yet, so there is nothing to download.");
    download(`${fileName(name.value) || "my-engine"}.zip`, zip, "application/zip");
    say("Your work is downloaded. Hand in this file, or upload it in another browser.", "good");
  });
  const copies = el("div");
  const erase = guarded(async () => {
    const words = "This erases everything you have written, its earlier versions and your results, in this browser. It cannot be undone. Download your work first if you may want it again.";
    if (!(await ask("Erase all your work?", el("p", {}, words), "Erase everything"))) return;
    await workspace.erase();
    location.reload();
  });
  section.append(
    summary,
    el("div", {className: "row"}, el("label", {htmlFor: "zip-name"}, "Your name, for the name of the file"), name),
    el("div", {className: "row"}, button("Download my work (.zip)", save, {className: "main"}), button("Upload a .zip", () => file.click()), file, canOpenFolders() ? button("Open a folder", open) : ""),
    status,
    copies,
    el("div", {className: "row"}, button("Erase everything", erase)),
  );
  file.setAttribute("aria-label", "A zip of your work");
  const show = async () => {
    const paths = Object.keys(workspace.written());
    const chapters = new Set(paths.map((path) => path.split("/")[0]));
    summary.textContent = paths.length
      ? `You have changed ${count(paths.length, "file")} in ${count(chapters.size, "chapter")}. All of it is in this browser and nowhere else, so download it now and then.`
      : "Nothing yet. What you write in the lessons is kept in this browser.";
    await showCopies(copies, say);
  };
  workspace.addEventListener("saved", show);
  workspace.addEventListener("text", show);
  workspace.addEventListener("trouble", ({detail}) => say(detail.words, "problem"));
  await show();
}

// Return the part of a name that is safe in a file's name.
const fileName = (words) => words.trim().replace(/[^\p{L}\p{N} ._-]/gu, "").replace(/^[. ]+/, "");

// Import texts from a zip or a folder. Ask first if they would replace the student's own text.
async function take({texts, others}, from, say) {
  const changed = [];
  for (const [path, text] of Object.entries(texts)) if ((await workspace.text(path)) !== text) changed.push(path);
  const written = workspace.written();
  const replaced = changed.filter((path) => path in written);
  const left = others.length ? ` ${count(others.length, "other file")} in it ${others.length === 1 ? "is" : "are"} not part of what you write, and ${others.length === 1 ? "was" : "were"} left out.` : "";
  if (!changed.length) {
    say(`${from} has the same texts as this browser.${left}`);
    return true;
  }
  if (replaced.length) {
    const list = el("ul", {}, replaced.map((path) => el("li", {}, path)));
    const words = `${from} has other texts of these files than this browser. Copies of yours are kept among the earlier versions.`;
    if (!(await ask("Replace your files?", [el("p", {}, words), list], "Replace them"))) return false;
  }
  for (const path of changed) await workspace.replace(path, texts[path], `replaced by ${from}`);
  say(`${count(changed.length, "file")} taken from ${from}.${left}`, "good");
  return true;
}

// Show the progress of each chapter in the list of chapters.
export async function startProgress() {
  const {meter} = await import("../exercise/report.js");
  const {pointsOf} = await import("../exercise/results.js");
  await workspace.opened();
  const {chapters} = await outline();
  const show = async () => {
    const begun = [];
    for (const chapter of chapters) {
      const place = document.querySelector(`[data-progress="${chapter.name}"] .progress`);
      const found = await pointsOf(chapter);
      place.hidden = !found.begun;
      place.replaceChildren(...meter(found.earned, found.points));
      if (found.begun) begun.push(chapter);
    }
    const last = begun.at(-1);
    if (!last) return;
    const link = document.getElementById("begin");
    Object.assign(link, {href: `${last.name}.html`, textContent: `Go on with chapter ${last.number}`});
  };
  workspace.addEventListener("results", show);
  await show();
}

