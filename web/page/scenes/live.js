// Live figures: a picture until somebody starts it, and then a small lab. One runs at a time.

import {button, el} from "../dom.js";
import {labOptions, loadLab} from "./link.js";
import {warmUp} from "../python/python.js";
import {workspace} from "../files/workspace.js";

let running = null;

export function startLive() {
  document.querySelectorAll(".live").forEach((figure, number) => new Live(figure, number));
}

class Live {
  constructor(figure, number) {
    Object.assign(this, {figure, number});
    this.place = figure.querySelector(".live-place");
    this.still = [...this.place.children];
    this.toggle = button("Start", () => (this.lab ? this.stop() : this.start()), {className: "main"});
    this.status = el("span", {role: "status"});
    const caption = figure.querySelector("figcaption");
    this.toggle.setAttribute("aria-label", `Start: ${caption.firstChild.textContent.trim()}`);
    caption.prepend(this.toggle);
    caption.append(this.status);
  }

  async start() {
    running?.stop();
    running = this;
    warmUp();
    this.status.textContent = "Python is starting. This takes a few seconds, but only the first time.";
    try {
      const [[{Lab}, {listenToKeys}, {play}], options] = await Promise.all([loadLab(), labOptions(), workspace.opened()]);
      const place = el("div");
      place.className = "lab";
      const opened = (spec) => {
        this.status.textContent = "";
        this.place.replaceChildren(place);
        this.lab.charts.fit();
        if (!spec.predict) play(this.lab, true);
      };
      this.place.append(place);
      place.hidden = true;
      this.lab = new Lab(place, {...options, prefix: `live-${this.number}-`, compact: true, opened: (spec) => ((place.hidden = false), opened(spec)), address: () => this.address()});
      this.name(true);
      const {troubled} = this.lab;
      this.lab.troubled = (words, where) => {
        place.hidden = false;
        this.status.textContent = "";
        troubled(words, where);
      };
      listenToKeys(this.lab, place);
      this.lab.open(this.figure.dataset.scene, JSON.parse(this.figure.dataset.values));
      workspace.addEventListener("saved", (this.saved = () => this.lab?.say("Your code has changed. Press Restart to run the new version.")));
    } catch (error) {
      this.status.textContent = error.message;
      this.stop();
    }
  }

  stop() {
    this.lab?.close();
    this.lab = null;
    workspace.removeEventListener("saved", this.saved);
    this.place.replaceChildren(...this.still);
    this.name(false);
    if (running === this) running = null;
  }

  name(isRunning) {
    this.toggle.textContent = isRunning ? "Close" : "Start";
    const title = this.toggle.getAttribute("aria-label").replace(/^\w+: /, "");
    this.toggle.setAttribute("aria-label", `${this.toggle.textContent}: ${title}`);
  }

  address() {
    return new URL(`lab.html?${this.lab.query()}`, document.baseURI).href;
  }
}
