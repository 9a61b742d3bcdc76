// Check an exercise or a chapter, and show what was found.

import {outline} from "../course.js";
import {button, el} from "../dom.js";
import {engines} from "../python/python.js";
import {failureOf, lineOf, linked} from "./report.js";
import {chaptersGiven, keep} from "./results.js";
import {ownerOf, panels} from "./panels.js";
import {workspace} from "../files/workspace.js";

const SLOW = 700; // ms until the page explains why there is no result yet

// Run checks for a panel, which has say, checking, result and data. Return the report if there is one.
export async function runChecks(panel, exercise) {
  if (panel.running) return null;
  panel.running = true;
  panel.checking.setAttribute("aria-disabled", "true");
  panel.result.setAttribute("aria-busy", "true");
  panel.say("Checking ...");
  const slow = setTimeout(() => panel.say("Python is starting. This takes a few seconds, but only the first time."), SLOW);
  try {
    await workspace.saveAll();
    const report = await engines().check({
      files: workspace.written(),
      chapter: panel.data.name,
      exercise,
      given: chaptersGiven(),
      seed: "1",
      onTrouble: (failure) => (clearTimeout(slow), panel.troubled?.(failure)),
      onProgress: (done, of) => (clearTimeout(slow), panel.say(`Checking ... ${done} of ${of}`)),
    });
    await keep(report, panel.data.exercises);
    return report;
  } catch (error) {
    panel.say(`The checks could not be run: ${error.message ?? error}`, "problem");
    return null;
  } finally {
    clearTimeout(slow);
    panel.running = false;
    panel.checking.removeAttribute("aria-disabled");
    panel.result.removeAttribute("aria-busy");
  }
}

// Check the exercise of a panel.
export async function check(panel) {
  await panel.mounted();
  const report = await runChecks(panel, panel.id);
  if (!report) return;
  const own = report.results.find(({id}) => id === panel.id);
  if (report.passed) panel.say(`${report.summary} ${lineOf(own)}`, "good");
  else panel.say(lineOf(own));
  const before = report.results.filter(({id, state}) => id !== panel.id && !["passed", "works"].includes(state));
  const parts = [];
  if (before.length) parts.push(el("p", {}, `${panel.id} builds on ${before.map(({id, state}) => `${id} (${state})`).join(", ")}.`));
  showReport(panel, report, parts);
}

// Show the failure of a check that did not end while other checks are still running.
export async function showTrouble(panel, failure) {
  panel.result.replaceChildren(failureOf(failure, panel.level, await stepsFor({failure}, panel)));
  panel.result.hidden = false;
}

// Show a report below the buttons of a panel.
export async function showReport(panel, report, parts) {
  if (report.failure) parts.push(failureOf(report.failure, panel.level, await stepsFor(report, panel)));
  const {chapters, solutions} = await outline();
  parts.push(...[...report.notes, ...report.finish].filter(Boolean).map((words) => el("p", {}, linked(words, chapters))));
  if (solutions && report.results.some(({state}) => state === "inherited" || state === "blocked")) {
    parts.push(el("p", {}, el("a", {href: "#your-chapter"}, "Take earlier chapters from the reference")));
  }
  panel.result.replaceChildren(...parts);
  panel.result.hidden = !parts.length;
}

// Buttons for what comes next: the line of the failure, and a nudge.
async function stepsFor({failure}, panel) {
  const {data} = panel;
  const {file, line, nudge} = failure;
  const steps = [];
  if (file && (file in data.files || file in data.complete)) {
    const owner = file in data.files ? ownerOf(file, line, await workspace.text(file), data.exercises) : "";
    const there = panels.get(owner) ?? panels.get(nudge) ?? panel;
    const where = `${line ? `line ${line} of ` : ""}${file.split("/")[1]}`;
    steps.push(button(`Go to ${where}`, () => there.open(file, line), {className: "main"}));
  }
  const nudged = panels.get(nudge);
  if (nudged) {
    const words = nudged === panel ? "Give me a hint" : `Give me a hint for ${nudge}`;
    steps.push(button(words, () => nudged.hint().then(() => nudged.list.scrollIntoView({block: "center"}))));
  }
  return steps;
}
