// Replace an exercise with its stub. This asks first, keeps a copy, and can be undone.

import {ask} from "../ask.js";
import {namesIn, putStubsBack} from "./bodies.js";
import {button, el} from "../dom.js";
import {workspace} from "../files/workspace.js";

export async function reset(panel) {
  const {id, exercise, paths, data} = panel;
  const names = paths.flatMap((path) => namesIn(exercise, path));
  const what = names.length ? `your code of ${names.join(", ")}` : paths[0].split("/")[1];
  const words = `This replaces ${what} with the stub. A copy of the file is kept among your earlier versions, and you can undo it.`;
  if (!(await ask(`Reset ${id} ${exercise.title}?`, el("p", {}, words), "Reset"))) return;
  const [before, lost] = [[], []];
  for (const path of paths) {
    const text = await workspace.text(path);
    const own = namesIn(exercise, path);
    const outcome = own.length ? putStubsBack(text, data.files[path], own) : {text: data.files[path], lost: []};
    lost.push(...outcome.lost);
    if (outcome.text === text) continue;
    before.push([path, text]);
    await workspace.replace(path, outcome.text, `before a reset of ${id}`);
  }
  panel.result.hidden = true;
  if (lost.length) return panel.say(`${lost.join(", ")} could not be put back, because its class is gone.`, "problem");
  panel.say(before.length ? `The stub of ${id} is back. ` : "The stub is there already.");
  if (!before.length) return;
  const undo = button("Undo", async () => {
    for (const [path, text] of before) await workspace.replace(path, text, `before a reset of ${id} was undone`);
    panel.say("Your code is back.");
  });
  panel.status.append(undo);
}
