// The panel of a whole chapter: check everything, and take earlier chapters from the reference.

import {runChecks, showReport, showTrouble} from "./checking.js";
import {chapterOf, outline} from "../course.js";
import {button, count, el, whenNear} from "../dom.js";
import {warmUp} from "../python/python.js";
import {meter, tableOf} from "./report.js";
import {chaptersGiven, pointsOf, results, setGiven, shown} from "./results.js";
import {workspace} from "../files/workspace.js";

export function startWhole(section) {
  whenNear(section, () => new Whole(section).mount());
}

class Whole {
  constructor(section) {
    Object.assign(this, {section, level: 3});
  }

  async mount() {
    this.data = await chapterOf(this.section.dataset.whole);
    this.solutions = (await outline()).solutions;
    await workspace.opened();
    await results();
    this.points = el("p", {className: "note"});
    this.status = el("p", {className: "note", role: "status"});
    this.result = el("div", {className: "result", hidden: true});
    this.checking = button("Check the whole chapter", () => this.check(), {className: "main"});
    this.section.append(this.points, this.given() ?? "", el("div", {className: "row"}, this.checking), this.status, this.result);
    this.section.addEventListener("focusin", warmUp, {once: true});
    workspace.addEventListener("results", () => this.showPoints());
    this.showPoints();
  }

  async showPoints() {
    const {earned, points} = await pointsOf(this.data);
    this.points.replaceChildren(...meter(earned, points, " earned so far."));
  }

  say(words, kind = "") {
    this.status.textContent = words;
    this.status.className = `note ${kind}`;
  }

  // Which earlier chapters come from the reference, on a site that has it.
  given() {
    const {builds_on: below} = this.data;
    if (!this.solutions || !below.length) return null;
    const boxes = below.map((number) => {
      const box = el("input", {type: "checkbox", checked: chaptersGiven().includes(number), value: number});
      box.onchange = () => {
        const wanted = new Set(chaptersGiven());
        if (box.checked) wanted.add(number);
        else wanted.delete(number);
        setGiven(wanted);
      };
      return el("label", {}, box, ` ${number} `);
    });
    return el("fieldset", {className: "given"}, el("legend", {}, "Take these chapters from the reference, not from my own work"), boxes);
  }

  troubled(failure) {
    showTrouble(this, failure);
  }

  async check() {
    const report = await runChecks(this, null);
    if (!report) return;
    if (report.passed) this.say(report.summary, "good");
    else this.say(`${shown(report.earned)} of ${count(report.points, "point")}.`);
    const titles = Object.fromEntries(this.data.exercises.map(({id, title}) => [id, title]));
    await showReport(this, report, [tableOf(report.results, titles)]);
  }
}
