// Turn a report of checks into elements, in the words of `make check`.

import {count, el} from "../dom.js";
import {shown} from "./results.js";

const CODE = ["with", "called", "got", "wanted", "where", "printed", "check"];

// The first failure with its rows, and buttons for the next steps.
export function failureOf(failure, level, buttons) {
  const rows = failure.rows.flatMap(([label, words]) => row(label, words));
  if (failure.printed) rows.push(...row("printed", failure.printed));
  return el("div", {className: "failure"}, el(`h${level}`, {}, failure.heading), el("dl", {className: "rows"}, rows), el("div", {className: "row"}, buttons));
}

function row(label, words) {
  if (!label) return [el("dd", {className: "alone"}, words)];
  return [el("dt", {}, label), el("dd", {className: CODE.includes(label) ? "code" : ""}, words)];
}

// Words in which commands are links to what they do here: to a lesson, an exercise or a scene.
export function linked(words, chapters) {
  const parts = words.split(/(make (?:check|lab|hint) [A-Z]+=\S*[\w](?: [A-Z]+=\S*[\w])*)/);
  return parts.map((part, i) => {
    const href = i % 2 && addressOf(Object.fromEntries(part.split(" ").slice(2).map((word) => word.split("="))), chapters);
    return href ? el("a", {href}, part) : part;
  });
}

function addressOf({CH, EX, SCENE}, chapters) {
  if (SCENE) return `lab.html?scene=${SCENE}`;
  const chapter = chapters.find(({number, exercises}) => (EX ? exercises.some(({id}) => id === EX) : number === parseInt(CH, 10)));
  return chapter && `${chapter.name}.html#${EX ? anchor(EX) : "your-chapter"}`;
}

export const anchor = (id) => `ex-${id.replace(".", "-")}`;

// All exercises with their states and points.
export function tableOf(results, titles) {
  const head = ["", "exercise", "state", "physics", "robust", "points"].map((words) => el("th", {scope: "col"}, words));
  const body = results.map(({id, state, physics, robust, score, points}) =>
    el(
      "tr",
      {},
      el("th", {scope: "row"}, el("a", {href: `#${anchor(id)}`}, id)),
      el("td", {}, titles[id] ?? ""),
      el("td", {}, el("span", {className: "state", "data-state": state}, state)),
      [physics, robust, `${shown(score)}/${points}`].map((words) => el("td", {}, words)),
    ),
  );
  const table = el("table", {}, el("thead", {}, el("tr", {}, head)), el("tbody", {}, body));
  return el("div", {className: "scores", tabIndex: 0, role: "group", "aria-label": "Exercises and their states"}, table);
}

// A bar of points, and the same numbers in words.
export function meter(earned, points, more = "") {
  const bar = el("i");
  bar.style.width = `${points ? (100 * earned) / points : 0}%`;
  return [el("span", {className: "meter", "aria-hidden": "true"}, bar), `${shown(earned)} of ${count(points, "point")}${more}`];
}

// One line about an exercise: how many checks pass, and its points.
export function lineOf({id, physics, robust, score, points, state}) {
  const tiers = [physics && `physics ${physics}`, robust && `robust ${robust}`].filter(Boolean).join(", ");
  return `${id}: ${state}${tiers ? `, ${tiers}` : ""}, ${shown(score)} of ${count(points, "point")}.`;
}
