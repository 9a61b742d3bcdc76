// What the last checks found, exercise by exercise, and which chapters come from the reference.

import {fact, setFact} from "./store.js";
import {workspace} from "./workspace.js";

let known = null; // {exercise: {state, score, points, files}}
let given = [];

export async function results() {
  if (!known) [known, given] = [(await fact("results")) ?? {}, (await fact("given")) ?? []];
  return known;
}

// Keep what a report says of its exercises, with what their files were when they were checked.
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

// Whether the files of an exercise have changed since it was checked.
export async function isStale(chapter, exercise) {
  const result = (await results())[exercise.id];
  return Boolean(result) && result.files !== (await sumOf(chapter, exercise));
}

// A short number for the texts that an exercise is written in.
async function sumOf(chapter, exercise) {
  const names = [...new Set([...exercise.edit.map((name) => `${name.split(".")[0]}.py`), ...exercise.files])];
  let sum = 5381;
  for (const name of names) {
    for (const letter of (await workspace.text(`${chapter}/${name}`)) ?? "") sum = (sum * 33 + letter.charCodeAt(0)) | 0;
  }
  return sum;
}

// The chapters that are taken from the reference, where the site has it.
export const chaptersGiven = () => given;

export async function setGiven(numbers) {
  given = [...numbers].sort((a, b) => a - b);
  await setFact("given", given);
  workspace.announce("results");
}

// Points earned and possible of a chapter's exercises, written ones left out.
export async function pointsOf(chapter) {
  const all = await results();
  const checked = chapter.exercises.filter(({kind}) => kind !== "written");
  const earned = checked.reduce((sum, {id}) => sum + (all[id]?.score ?? 0), 0);
  return {earned, points: checked.reduce((sum, {points}) => sum + points, 0), begun: checked.some(({id}) => all[id])};
}

// A list of numbers as people write it, such as 2-5 or 2, 4.
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
