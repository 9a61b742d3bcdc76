// The page of `make lab`: a list of scenes, and one lab.

import {EngineLink} from "./engine.js";
import {listenToKeys} from "./keys.js";
import {Lab, asked} from "./lab.js";

const $ = (id) => document.getElementById(id);

// Fill the list of scenes, chapter by chapter.
export function listScenes(select, scenes) {
  let group = null;
  for (const {name, title, chapter} of scenes) {
    if (group?.label !== `Chapter ${chapter}`) {
      group = document.createElement("optgroup");
      group.label = `Chapter ${chapter}`;
      select.append(group);
    }
    group.append(new Option(title, name));
  }
}

function showTitle(spec) {
  document.title = `${spec.title} - the lab`;
  $("title").textContent = spec.title;
  $("question").textContent = spec.question;
}

async function record(scene, values) {
  const answer = await fetch(`record.gif?${new URLSearchParams({scene, ...values})}`);
  return answer.ok ? {content: await answer.blob()} : {why: await answer.text()};
}

async function start() {
  const {scenes, engines} = await (await fetch("scenes.json")).json();
  const remember = (lab) => history.replaceState(null, "", `?${lab.query()}`);
  const connect = (engine, onAnswer) => new EngineLink(engine, onAnswer);
  const lab = new Lab($("lab"), {engines, connect, record, opened: showTitle, changed: remember});
  listenToKeys(lab, document);
  listScenes($("scenes"), scenes);
  $("scenes").onchange = () => (lab.open($("scenes").value, {}), remember(lab));
  const {scene, values, rivals} = asked(new URLSearchParams(location.search), scenes[0].name);
  $("scenes").value = scene;
  lab.open(scene, values, rivals);
}

start();
