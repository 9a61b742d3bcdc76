// The student's folder: files by path, such as ch02_vectors/vector.py. A file that is not stored equals
// its stub. Every change is saved at once, and every other tab of the site follows.

import {stubOf} from "../course.js";
import {eraseAll, keepCopy, putFile, readAll, run} from "./store.js";

const SAVED_AFTER = 150; // ms after the first change that is not saved yet
const UNSAVED = `unsaved ${new URL(".", document.baseURI).pathname} `; // what a closed tab had not saved

class Workspace extends EventTarget {
  constructor() {
    super();
    this.files = new Map(); // path -> {text, version}; text is null if the stub was restored
    this.waiting = new Map(); // path -> timer of a change that is not saved yet
    this.unsaved = new Set(); // paths of these changes, and of those that are being saved
    this.saving = Promise.resolve();
    this.channel = new BroadcastChannel(UNSAVED);
    this.channel.onmessage = ({data}) => this.heard(data);
    addEventListener("pagehide", () => this.keepUnsaved());
    document.addEventListener("visibilitychange", () => (document.hidden ? this.saveAll() : this.reread()));
  }

  // Read all files. You may await this any number of times.
  opened() {
    this.opening ??= (async () => {
      for (const file of await readAll("files")) this.files.set(file.path, file);
      for (const key of Object.keys(localStorage).filter((each) => each.startsWith(UNSAVED))) await this.recover(key);
      return this;
    })();
    return this.opening;
  }

  // Return the files that differ from the stubs, in the form that the engines need.
  written() {
    const own = [...this.files].filter(([, {text}]) => text !== null && text !== undefined);
    return Object.fromEntries(own.map(([path, {text}]) => [path, text]));
  }

  async text(path) {
    return this.files.get(path)?.text ?? (await stubOf(path));
  }

  // Change a text as an editor does. `from` made the change, so it is not notified.
  edit(path, text, from = null) {
    const file = this.files.get(path) ?? {path, version: 0};
    if (file.text === text) return;
    this.files.set(path, {...file, text});
    this.unsaved.add(path);
    this.tell("text", {path, text, from});
    if (!this.waiting.has(path)) this.waiting.set(path, setTimeout(() => this.save(path), SAVED_AFTER));
  }

  // Replace the text of a file, and keep a copy of the old text.
  async replace(path, text, why) {
    const there = await this.text(path);
    if (there === text) return;
    if (this.files.get(path)?.text) await keepCopy(path, there, why); // a stub can be had any time
    this.edit(path, text);
    await this.save(path);
  }

  save(path) {
    clearTimeout(this.waiting.get(path));
    this.waiting.delete(path);
    this.saving = this.saving.then(() => this.write(path)).catch((error) => this.tell("trouble", {words: trouble(error)}));
    return this.saving;
  }

  saveAll() {
    for (const path of [...this.waiting.keys()]) this.save(path);
    return this.saving;
  }

  async write(path) {
    const {text, version} = this.files.get(path);
    const kept = text === (await stubOf(path)) ? null : text;
    const {theirs, version: now} = await putFile({path, text: kept}, version);
    if (this.files.get(path).text === text) this.unsaved.delete(path);
    if (theirs) return this.yieldTo(theirs, text);
    this.files.set(path, {...this.files.get(path), version: now});
    this.channel.postMessage({kind: "saved", path});
    this.tell("saved", {path});
    navigator.storage?.persist?.();
  }

  // Two tabs have changed a file at the same time. The first one to save wins, and the other text is kept.
  async yieldTo(theirs, mine) {
    await keepCopy(theirs.path, mine, "changed in two tabs at the same time");
    await this.adopt(theirs);
    this.tell("conflict", {path: theirs.path, mine});
  }

  async adopt(file) {
    this.files.set(file.path, file);
    this.tell("text", {path: file.path, text: file.text ?? (await stubOf(file.path)), from: null, elsewhere: true});
  }

  async heard({kind, path}) {
    if (kind === "erased") return location.reload();
    if (kind !== "saved") return this.tell(kind, {elsewhere: true});
    if (this.waiting.has(path)) return; // this tab is about to save it, and then compares both
    const file = await run("files", "readonly", (store) => store.get(path));
    if (file && this.isNewer(file)) await this.adopt(file);
  }

  isNewer({path, version}) {
    return !this.waiting.has(path) && version > (this.files.get(path)?.version ?? 0);
  }

  // A tab that was asleep may have missed messages of other tabs.
  async reread() {
    for (const file of await readAll("files")) {
      if (this.isNewer(file)) await this.adopt(file);
    }
  }

  keepUnsaved() {
    for (const path of this.unsaved) localStorage.setItem(UNSAVED + path, JSON.stringify(this.files.get(path)));
  }

  async recover(key) {
    const path = key.slice(UNSAVED.length);
    const {text, version} = JSON.parse(localStorage.getItem(key));
    localStorage.removeItem(key);
    const there = this.files.get(path);
    if ((there?.version ?? 0) === version) {
      this.files.set(path, {path, text, version});
      this.unsaved.add(path);
      await this.save(path);
    } else if (there?.text !== text) await keepCopy(path, text, "not saved when its tab was closed");
  }

  // Notify this tab and the others of a change that is not in a file.
  announce(kind) {
    this.tell(kind, {});
    this.channel.postMessage({kind});
  }

  tell(kind, detail) {
    this.dispatchEvent(new CustomEvent(kind, {detail}));
  }

  async erase() {
    await this.saveAll();
    await eraseAll();
    this.channel.postMessage({kind: "erased"});
  }
}

function trouble(error) {
  return error?.name === "QuotaExceededError"
    ? "This browser has no room left to save your work. Download it now, and free some space."
    : `Your last change could not be saved (${error?.message ?? error}). Download your work before you close this page.`;
}

export const workspace = new Workspace();
