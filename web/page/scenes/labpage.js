// The page of the lab: a list of scenes, the chosen one in the address, and one lab.

import {outline} from "../course.js";
import {el} from "../dom.js";
import {labOptions, loadLab} from "./link.js";
import {chaptersGiven, numbersOf, results} from "../exercise/results.js";
import {workspace} from "../files/workspace.js";

const $ = (id) => document.getElementById(id);

export async function startLabPage() {
  const {scenes, chapters} = await outline();
  listScenes($("scenes"), scenes);
  const [[{Lab, asked}, {listenToKeys}], options] = await Promise.all([loadLab(), labOptions(), workspace.opened(), results()]);
  const remember = (lab) => history.replaceState(null, "", `?${lab.query()}`);
  const lab = new Lab($("lab"), {
    ...options,
    changed: remember,
    opened: (spec) => lab.say(""),
    troubled: (words, place) => (lab.say(""), options.troubled(words, place)), // it has started, too
  });
  listenToKeys(lab, document);
  const open = (name, values, rivals) => {
    const scene = scenes.find((each) => each.name === name) ?? scenes[0];
    const chapter = chapters.find(({number}) => number === scene.chapter);
    $("scenes").value = scene.name;
    $("title").textContent = scene.title;
    document.title = `${scene.title} - the lab`;
    $("question").textContent = scene.question;
    $("lesson").replaceChildren(el("a", {href: `${chapter.name}.html`}, `Lesson: chapter ${chapter.number}`));
    lab.open(scene.name, values, rivals);
    const still = {src: `stills/${scene.name}.svg`, width: 640, height: 400, alt: "A still picture of the scene."};
    lab.$("stage").replaceChildren(el("img", still)); // shown until Python has started
    lab.say("Python is starting. This takes a few seconds, but only the first time.");
  };
  const given = chaptersGiven();
  $("whose").textContent = given.length
    ? `This scene runs your own code on the reference's chapters ${numbersOf(given)}.`
    : "This scene runs the code that you have written in the lessons.";
  $("scenes").onchange = () => (open($("scenes").value, {}), remember(lab));
  workspace.addEventListener("saved", () => lab.say("Your code has changed. Press Restart to run the new version."));
  const {scene, values, rivals} = asked(new URLSearchParams(location.search), scenes[0].name);
  open(scene, values, rivals);
}

function listScenes(select, scenes) {
  const chapters = [...new Set(scenes.map(({chapter}) => chapter))];
  for (const chapter of chapters) {
    const own = scenes.filter((scene) => scene.chapter === chapter);
    select.append(el("optgroup", {label: `Chapter ${chapter}`}, own.map(({name, title}) => new Option(title, name))));
  }
}
