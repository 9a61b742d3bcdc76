// Your turn: the panel of one exercise, with its editor and its buttons.

import {namesIn} from "./bodies.js";
import {check, showTrouble} from "./checking.js";
import {chapterOf} from "../course.js";
import {button, el, marked, whenNear} from "../dom.js";
import {warmUp} from "../python/python.js";
import {reset} from "./reset.js";
import {panels} from "./panels.js";
import {isStale, results} from "./results.js";
import {workspace} from "../files/workspace.js";
import {tryBox} from "./trying.js";
import {writtenPart} from "./written.js";

export function startTurns(chapter) {
  for (const section of document.querySelectorAll(".turn")) {
    panels.set(section.dataset.exercise, new Turn(section, chapter));
  }
  const showStates = () => panels.forEach((panel) => panel.showState());
  workspace.addEventListener("results", showStates);
  workspace.addEventListener("saved", showStates);
  workspace.addEventListener("conflict", ({detail}) => showConflict(detail));
}

class Turn {
  constructor(section, chapter) {
    Object.assign(this, {section, chapter, id: section.dataset.exercise, hints: 0});
    this.body = section.querySelector(".turn-body");
    this.level = Number(section.querySelector("h3, h4, h5, h6").tagName[1]) + 1;
    this.place = el("div", {className: "editor"});
    this.body.append(this.place);
    this.showState();
    whenNear(section, () => this.mounted());
    section.addEventListener("focusin", warmUp, {once: true});
    section.addEventListener("pointerdown", warmUp, {once: true});
  }

  // Create the editor and the buttons once.
  mounted() {
    this.mounting ??= this.mount().catch((error) => {
      this.mounting = null;
      this.place.textContent = error.message;
    });
    return this.mounting;
  }

  async mount() {
    this.data = await chapterOf(this.chapter);
    await workspace.opened();
    this.exercise = this.data.exercises.find(({id}) => id === this.id);
    this.status = el("p", {className: "note", role: "status"});
    this.result = el("div", {className: "result", hidden: true});
    this.list = el("ol", {className: "hints", "aria-live": "polite", "aria-label": `Hints for ${this.id}`});
    this.hinting = button("Hint", () => this.hint());
    if (this.exercise.kind === "written") {
      this.place.replaceWith(writtenPart(this));
      this.body.append(el("div", {className: "row"}, this.hinting), this.list);
      return;
    }
    const {Editor} = await import("./editor.js");
    this.editor = new Editor(this.place, {exercise: this.exercise, onCheck: () => check(this)});
    this.checking = button("Check", () => check(this), {className: "main", "aria-keyshortcuts": "Control+Enter"});
    this.place.before(this.files());
    this.body.append(
      el("p", {className: "leave"}, "Ctrl+Enter checks. To leave the editor with the keyboard, press Escape and then Tab."),
      el("div", {className: "row"}, this.checking, this.hinting, button("Reset", () => reset(this))),
      this.status,
      this.list,
      this.result,
      tryBox(this),
    );
    await this.editor.show(this.paths[0]);
    const [name] = namesIn(this.exercise, this.paths[0]);
    if (name) this.editor.goTo(name, {focus: false});
  }

  // The files of the exercise, with a button for each function to write, and the chapter's others.
  files() {
    const {edit, files} = this.exercise;
    const modules = [...new Set(edit.map((name) => `${name.split(".")[0]}.py`))];
    this.paths = [...modules, ...files].map((name) => `${this.chapter}/${name}`);
    const short = edit.map(shortName);
    const isOnce = (name) => short.indexOf(shortName(name)) === short.lastIndexOf(shortName(name));
    const parts = this.paths.flatMap((path) => [
      el("span", {className: "file"}, `${path.split("/")[1]}:`),
      ...namesIn(this.exercise, path).map((name) => button(isOnce(name) ? shortName(name) : name, () => this.goTo(path, name))),
      namesIn(this.exercise, path).length ? "" : button("open", () => this.open(path)),
    ]);
    const {data} = this;
    const others = Object.keys({...data.files, ...data.complete}).filter((path) => !path.endsWith(".md"));
    const select = el("select", {"aria-label": "Show a file of the chapter"}, new Option("show a file ...", ""));
    for (const path of others) select.add(new Option(`${path.split("/")[1]}${path in data.complete ? " (given)" : ""}`, path));
    select.onchange = () => select.value && this.open(select.value);
    return el("div", {className: "bodies", role: "group", "aria-label": "What you write"}, parts, select);
  }

  async goTo(path, name) {
    await this.editor.show(path);
    if (!this.editor.goTo(name)) this.say(`${name} is not in this file any more. Reset puts its stub back.`, true);
  }

  async open(path, line) {
    await this.mounted();
    await this.editor.show(path, this.data.complete[path] ?? null);
    if (line) this.editor.goToLine(line);
    else this.editor.view.focus();
    this.place.scrollIntoView({block: "center"});
  }

  say(words, kind = "") {
    this.status.textContent = words;
    this.status.className = `note ${kind}`;
  }

  troubled(failure) {
    showTrouble(this, failure);
  }

  // Show the next hint, and how many are left.
  async hint() {
    await this.mounted();
    const {hints} = this.exercise;
    if (this.hints < hints.length) this.list.append(el("li", {}, marked(hints[this.hints++])));
    const left = hints.length - this.hints;
    this.hinting.textContent = left ? `Next hint (${left} more)` : "No more hints";
    this.hinting.setAttribute("aria-disabled", String(!left));
  }

  async showState() {
    const label = this.section.querySelector(".state");
    const result = (await results())[this.id];
    if (!result || result.state === "to answer" || result.state === "answered") return;
    const exercise = (await chapterOf(this.chapter)).exercises.find(({id}) => id === this.id);
    const stale = await isStale(this.chapter, exercise);
    label.dataset.state = stale ? "" : result.state;
    label.textContent = stale ? `${result.state} before your last change` : result.state;
  }
}

// Return the name of a function without its class. A setter gets the name of its property.
function shortName(name) {
  return name.split(".").slice(name.endsWith(".setter") ? -2 : -1).join(".");
}

// Two tabs have changed a file at the same time. Show the other tab's text, and offer this tab's.
function showConflict({path, mine}) {
  for (const panel of panels.values()) {
    if (panel.editor?.path !== path) continue;
    const words = `${path.split("/")[1]} was changed in another tab at the same time, and that text is shown. `;
    panel.say(words, "problem");
    panel.status.append(
      button("Take mine instead", async () => {
        await workspace.replace(path, mine, "replaced by the text of another tab");
        panel.say("Your text is back. The other tab's is among your earlier versions.");
      }),
    );
  }
}
