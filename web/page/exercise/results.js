// The results of the last checks by exercise, and which chapters come from the reference.

import {fact, setFact} from "../files/store.js";
import {workspace} from "../files/workspace.js";

let known = null; // {exercise: {state, score, points, files}}
let given = [];

export async function results() {
  if (!known) [known, given] = [(await fact("results")) ?? {}, (await fact("given")) ?? []];
  return known;
}

// Store a report's results for its exercises, with a hash of the files that were checked.
export async function keep(report, exercises) {
  await results();
  for (const {id, state, score, points} of report.results) {
    const exercise = exercises.find((each) => each.id === id);
    known[id] = {state, score, points, files: await sumOf(report.chapter, exercise)};
  }
  await setFact("results", known);
  workspace.announce("results");
}

workspace.addEventListener("results", ({detail}) => {
  if (detail.elsewhere) known = null;
});

export async function forget() {
  known = {};
  await setFact("results", known);
  workspace.announce("results");
}

// Return whether the files of an exercise have changed since it was checked.
export async function isStale(chapter, exercise) {
  const result = (await results())[exercise.id];
  return Boolean(result) && result.files !== (await sumOf(chapter, exercise));
}

// Return a short hash of the files of an exercise.
async function sumOf(chapter, exercise) {
  const names = [...new Set([...exercise.edit.map((name) => `${name.split(".")[0]}.py`), ...exercise.files])];
  let sum = 5381;
  for (const name of names) {
    for (const letter of (await workspace.text(`${chapter}/${name}`)) ?? "") sum = (sum * 33 + letter.charCodeAt(0)) | 0;
  }
  return sum;
}

// Return the chapters that are taken from the reference, if the site includes it.
export const chaptersGiven = () => given;

export async function setGiven(numbers) {
  given = [...numbers].sort((a, b) => a - b);
  await setFact("given", given);
  workspace.announce("results");
}

// Return the points earned and possible in a chapter's exercises, without written ones.
export async function pointsOf(chapter) {
  const all = await results();
  const checked = chapter.exercises.filter(({kind}) => kind !== "written");
  const earned = checked.reduce((sum, {id}) => sum + (all[id]?.score ?? 0), 0);
  return {earned, points: checked.reduce((sum, {points}) => sum + points, 0), begun: checked.some(({id}) => all[id])};
}

// Write a list of numbers the way people do, such as 2-5 or 2, 4.
export function numbersOf(numbers) {
  const parts = [];
  for (const number of numbers) {
    const last = parts.at(-1);
    if (last && last[1] === number - 1) last[1] = number;
    else parts.push([number, number]);
  }
  return parts.map(([from, to]) => (from === to ? `${from}` : `${from}-${to}`)).join(", ");
}

export const shown = (score) => (score === null || score === undefined ? "-" : String(Math.round(score * 100) / 100));
