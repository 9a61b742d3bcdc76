// The lab's page: a scene, its parameters, and one or more engines that run it.

import {drawTradeoff} from "./charts.js";
import {addContender, showContenders, showRivals} from "./contenders.js";
import {makeControl} from "./controls.js";
import {ask} from "./predict.js";
import {isGrabbed, showStages} from "./stages.js";
import {$, FRAMES, page, remember, say, tint, trouble} from "./state.js";
import {advance, play, restart, tick} from "./time.js";

// --- Scenes and contenders -------------------------------------------------------------------

function openScene(name, values) {
  for (const contender of page.contenders.splice(0)) contender.link.close();
  Object.assign(page, {spec: null, values, name});
  $("stage").replaceChildren();
  $("parameters").replaceChildren();
  $("scenes").value = name;
  compare({engine: page.list.engines[0], peer: "", changes: {}});
}

function compare(rival) {
  addContender(rival, answered);
}

function answered(contender, answer) {
  if (answer.kind === "scene") {
    if (!page.spec) showScene(answer);
    showContenders();
  } else if (answer.kind === "frame") {
    contender.frame = answer;
    $("grab").hidden = !answer.items.some(isGrabbed);
    if (answer.error !== null && answer.error !== undefined) contender.worst = Math.max(contender.worst, answer.error);
    chart(contender, answer);
  } else if (answer.kind === "stopped") {
    contender.dead = true;
    trouble(`${contender.label}: ${answer.why}`);
    if (page.contenders.every((each) => each.dead)) play(false);
  } else if (answer.kind === "refused") {
    trouble(answer.why);
  } else if (answer.kind === "saved") {
    say(`${answer.files.join(", ")} saved. The scene restarts with the new code.`);
    restart();
  } else if (answer.kind === "judged") {
    page.judged?.(answer);
  }
}

const controls = new Map();

// --- Showing a scene -------------------------------------------------------------------------

function showScene(spec) {
  page.spec = spec;
  page.values = spec.values; // as the scene has interpreted them
  document.title = `${spec.title} - the lab`;
  $("title").textContent = spec.title;
  $("question").textContent = spec.question;
  controls.clear();
  for (const parameter of spec.parameters) {
    const value = page.values[parameter.name] ?? parameter.default;
    const control = makeControl(parameter, value, (wanted) => change(parameter.name, wanted));
    $("parameters").append(control);
    controls.set(parameter.name, control);
  }
  $("parameters").hidden = !spec.parameters.length;
  showActions(spec.keys);
  showRivals(spec);
  showStages();
  ask($("predict"), spec.predict, {
    skip: () => play(true),
    watch: (option, then) => {
      page.until = page.target + spec.predict.seconds * FRAMES;
      Object.assign(page, {guess: option, judged: then});
      play(true);
    },
  });
}

function showActions(keys) {
  $("actions").replaceChildren();
  $("actions").hidden = !Object.keys(keys).length;
  for (const [key, words] of Object.entries(keys)) {
    const button = document.createElement("button");
    button.textContent = `${words} (${key})`;
    button.onclick = () => press(key);
    $("actions").append(button);
  }
}

function chart(contender, frame) {
  const colors = page.contenders.map(tint);
  if (contender.number >= colors.length) return;
  const values = {...frame.chart};
  if (frame.error !== null && frame.error !== undefined) values[`error, ${page.spec.errorUnit}`] = frame.error;
  for (const [title, value] of Object.entries(values)) page.charts.add(title, frame.time, contender.number, colors, value);
}

function showNumbers() {
  const [first] = page.contenders;
  if (!first?.frame) return;
  $("clock").textContent = `${first.frame.time.toFixed(2)} s`;
  if ($("facts").textContent !== first.frame.facts) $("facts").textContent = first.frame.facts;
  if (page.playing && first.frame.time - (page.said ?? -2) >= 2) {
    page.said = first.frame.time;
    say(first.frame.say);
  }
  for (const [name, value] of Object.entries(first.frame.changed)) {
    if (page.values[name] === value) continue;
    page.values[name] = value;
    controls.get(name).show(value);
    remember();
  }
  const exact = first.frame.error !== null && first.frame.error !== undefined;
  for (const {cells, frame, worst} of page.contenders) {
    if (!cells || !frame) continue;
    cells[0].textContent = exact ? `${worst.toPrecision(2)} ${page.spec.errorUnit}` : "no exact solution";
    cells[1].textContent = frame.cost >= 1000 ? `${(frame.cost / 1000).toPrecision(3)} ms` : `${frame.cost.toPrecision(3)} µs`;
  }
  page.charts.draw();
  $("tradeoff").hidden = !exact;
  if (exact) {
    const points = page.contenders.filter((c) => c.frame && c.frame.cost).map((c) => ({cost: c.frame.cost, error: c.worst, color: tint(c), number: c.number + 1}));
    drawTradeoff($("tradeoff").firstElementChild, points);
  }
}

// --- Responding to the reader ----------------------------------------------------------------

function change(name, value) {
  page.values[name] = value;
  trouble("");
  const {live} = page.spec.parameters.find((parameter) => parameter.name === name);
  for (const contender of page.contenders) {
    if (name in contender.changes) continue;
    contender.dead = false;
    contender.worst = 0;
    contender.link.send({kind: "set", name, value});
    if (!live) contender.asked = 0;
  }
  if (!live) page.target = 0;
  if (!live) page.charts.clear();
  remember();
}

function press(key) {
  for (const contender of page.contenders) contender.link.send({kind: "press", key});
}

function save(name, type, content) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], {type}));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

const SCENE_KEYS = {ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down"};

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || $("keys").open) return;
  const inField = event.target.closest("input, select, textarea, button, a, dialog");
  if (event.key === "?") showKeys();
  else if (inField) return;
  else if (event.key === " ") play(!page.playing);
  else if (event.key === ".") advance(1);
  else if (event.key === "r") restart();
  else {
    const key = SCENE_KEYS[event.key] ?? event.key;
    if (!page.spec || !(key in page.spec.keys)) return;
    press(key);
  }
  event.preventDefault();
});

function showKeys() {
  const keys = {"space": "play or pause", ".": "advance by one frame", "r": "restart", "?": "show this list", ...page.spec?.keys};
  $("keys").querySelector("dl").replaceChildren(
    ...Object.entries(keys).flatMap(([key, words]) => {
      const [term, meaning] = [document.createElement("dt"), document.createElement("dd")];
      [term.textContent, meaning.textContent] = [key, words];
      return [term, meaning];
    }),
  );
  $("keys").showModal();
}

$("play").onclick = () => play(!page.playing);
$("step").onclick = () => (play(false), advance(1));
$("restart").onclick = restart;
$("help").onclick = showKeys;
$("scenes").onchange = () => (openScene($("scenes").value, {}), remember());
$("split").onchange = showStages;
$("add").onchange = () => {
  if (!$("add").value) return;
  compare(JSON.parse($("add").value));
  restart();
  showStages();
  remember();
  $("add").value = "";
};
$("csv").onclick = () => save(`${page.name}.csv`, "text/csv", page.charts.csv(page.contenders.map((c) => c.label)));
$("gif").onclick = async () => {
  say("Drawing the animation. This takes a few seconds.");
  const answer = await fetch(`record.gif?${new URLSearchParams({scene: page.name, ...page.values})}`);
  if (answer.ok) save(`${page.name}.gif`, "image/gif", await answer.blob());
  say(answer.ok ? "The animation has been saved." : await answer.text());
};
$("link").onclick = async () => {
  await navigator.clipboard.writeText(location.href);
  say("The link has been copied.");
};
new ResizeObserver(() => page.charts.fit()).observe($("right"));

for (const [kind, words] of Object.entries({velocity: "velocity", force: "force", contact: "contacts"})) {
  const label = document.createElement("label");
  const box = document.createElement("input");
  Object.assign(box, {type: "checkbox", checked: !page.hidden.has(kind)});
  box.onchange = () => (box.checked ? page.hidden.delete(kind) : page.hidden.add(kind));
  label.append(box, ` ${words}`);
  $("arrows").append(label);
}

async function start() {
  page.list = await (await fetch("scenes.json")).json();
  const chapters = Map.groupBy?.(page.list.scenes, (scene) => scene.chapter) ?? new Map([["all", page.list.scenes]]);
  for (const [chapter, scenes] of chapters) {
    const group = document.createElement("optgroup");
    group.label = `Chapter ${chapter}`;
    for (const {name, title} of scenes) group.append(new Option(title, name));
    $("scenes").append(group);
  }
  const query = new URLSearchParams(location.search);
  const {scene = page.list.scenes[0].name, ...values} = Object.fromEntries([...query].filter(([key]) => key !== "with"));
  openScene(scene, values);
  for (const rival of query.getAll("with")) compare(JSON.parse(rival));
  requestAnimationFrame((now) => tick(now, showNumbers));
}

start();
