// The *Try it* box of an exercise: a line of Python runs on the student's engine, and its result is shown.

import {button, el} from "../dom.js";
import {workspace} from "../files/workspace.js";
import {engines} from "../python/python.js";
import {chaptersGiven} from "./results.js";

const EXAMPLE = "v = Vector3(3, 4, 0)";

export function tryBox(panel) {
  const lines = []; // those that ran without an error, which later lines need
  const typed = []; // all of them, for the arrow keys
  let at = 0;
  const shown = el("div", {className: "tried", "aria-live": "polite"});
  const input = el("input", {type: "text", spellcheck: false, autocapitalize: "off", placeholder: EXAMPLE, "aria-label": `A line of Python for ${panel.id}`});

  async function run() {
    const line = input.value.trim();
    if (!line || input.readOnly) return;
    typed.push(line);
    at = typed.length;
    input.readOnly = true;
    input.value = "";
    const answer = el("p", {}, "...");
    shown.append(el("p", {className: "line"}, `>>> ${line}`), answer);
    await workspace.saveAll();
    const files = workspace.written();
    const chapter = panel.data.name;
    const {value, printed, error, where} = await engines()
      .tryLine({files, chapter, given: chaptersGiven(), lines: [...lines], line})
      .catch(({message}) => ({error: message}));
    if (!error) lines.push(line);
    answer.textContent = [printed, value, error, where].filter(Boolean).join("\n");
    answer.className = error ? "problem" : "";
    if (!answer.textContent) answer.remove();
    input.readOnly = false;
    input.focus();
  }

  function recall(step) {
    at = Math.max(0, Math.min(typed.length, at + step));
    input.value = typed[at] ?? "";
  }

  input.onkeydown = (event) => {
    if (event.key === "Enter") run();
    else if (event.key === "ArrowUp") recall(-1);
    else if (event.key === "ArrowDown") recall(1);
    else return;
    event.preventDefault();
  };
  const form = el("div", {className: "row"}, input, button("Run", run));
  return el("details", {className: "try"}, el("summary", {}, "Try it"), shown, form);
}
