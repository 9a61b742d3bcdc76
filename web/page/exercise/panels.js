// The panels of a page's exercises, and the one that a line of a file belongs to.

import {functionsOf, namesIn} from "./bodies.js";

export const panels = new Map(); // exercise -> Turn

// Return the exercise whose function contains a line of a file.
export function ownerOf(path, line, text, exercises) {
  const at = text.split("\n").slice(0, line).join("\n").length;
  const found = [...functionsOf(text)].filter(([name, {from, to}]) => !name.startsWith("class ") && from <= at && at <= to + 1);
  return exercises.find((exercise) => namesIn(exercise, path).some((name) => found.some(([own]) => own === name)))?.id;
}
