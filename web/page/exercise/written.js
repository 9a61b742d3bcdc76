// A question to answer in words: a text field for its section of answers.md.

import {el} from "../dom.js";
import {workspace} from "../files/workspace.js";

const PLACE = "_Write your answer here._";
const ENOUGH = 2; // words

export function writtenPart(turn) {
  const {chapter, exercise, data} = turn;
  const path = `${chapter}/answers.md`;
  const question = (data.questions[exercise.id] ?? "").replace(/^> ?/gm, "").replaceAll("\n", " ");
  const field = el("textarea", {id: `answer-${exercise.id}`, rows: 7, spellcheck: true});
  const label = el("label", {htmlFor: field.id}, "Your answer");
  const note = el("p", {className: "leave"}, "Your answer is saved in answers.md. Check cannot grade it, because a person reads and marks it.");
  turn.isWritten = true;
  const show = async () => {
    const {answer} = parts(await workspace.text(path), exercise.id);
    if (field.value !== answer) field.value = answer;
    showState(turn, answer);
  };
  field.oninput = async () => {
    const {before, after} = parts(await workspace.text(path), exercise.id);
    // A heading of the second level would begin another answer.
    const answer = field.value.replace(/^##? /gm, "### ");
    workspace.edit(path, `${before}${answer.trim() ? answer : PLACE}\n${after}`, field);
    showState(turn, answer);
  };
  workspace.addEventListener("text", ({detail}) => {
    if (detail.path === path && detail.from !== field) show();
  });
  show();
  return el("div", {}, el("blockquote", {}, question), label, field, note);
}

function showState(turn, answer) {
  const words = (answer.match(/[\p{L}]{2,}/gu) ?? []).length;
  const label = turn.section.querySelector(".state");
  const state = words >= ENOUGH ? "answered" : "to answer";
  label.dataset.state = state;
  label.textContent = state;
}

// The text of answers.md around the answer to a question, and the answer; a section that is gone is
// made again at the end.
function parts(text, id) {
  const lines = text.split("\n");
  const start = lines.findIndex((line) => line.startsWith("#") && firstWord(line) === id);
  if (start < 0) return {before: `${text.trimEnd()}\n\n## ${id}\n\n`, answer: "", after: ""};
  const next = lines.findIndex((line, i) => i > start && line.startsWith("## "));
  const end = next < 0 ? lines.length : next;
  let at = start + 1;
  while (at < end && !lines[at].trim()) at++;
  while (at < end && lines[at].startsWith(">")) at++;
  while (at < end && !lines[at].trim()) at++;
  const answer = lines.slice(at, end).join("\n").trim();
  const before = `${lines.slice(0, at).join("\n").trimEnd()}\n\n`;
  const after = next < 0 ? "" : `\n${lines.slice(next).join("\n")}`;
  return {before, answer: answer === PLACE ? "" : answer, after};
}

const firstWord = (heading) => heading.replace(/^[# ]+/, "").split(/\s/)[0].replace(/[.:]+$/, "");
