// The lab's page: a scene, its parameters, and one or more engines that play it.

import {Charts, drawTradeoff} from "./charts.js";
import {makeControl} from "./controls.js";
import {Stage} from "./draw.js";
import {EngineLink} from "./engine.js";
import {ask} from "./predict.js";

const $ = (id) => document.getElementById(id);
const TINTS = ["--blue", "--red", "--green", "--violet", "--orange"];
const FRAMES = 60; // in a second
const MOST_AT_ONCE = 8; // frames that a link is asked for in one message

const page = {
  list: {scenes: [], engines: []},
  spec: null,
  values: {},
  contenders: [],
  playing: false,
  target: 0, // frames that should have passed
  until: Infinity, // frames after which a question is answered
  hidden: new Set(["force", "contact"]),
  charts: new Charts($("charts")),
};

// --- Scenes and contenders -------------------------------------------------------------------

function openScene(name, values) {
  for (const contender of page.contenders.splice(0)) contender.link.close();
  Object.assign(page, {spec: null, values, name});
  $("stage").replaceChildren();
  $("parameters").replaceChildren();
  $("scenes").value = name;
  addContender({engine: page.list.engines[0], peer: "", changes: {}});
}

function addContender({engine, peer, changes}) {
  const contender = {engine, peer, changes, number: page.contenders.length, asked: page.target, worst: 0, frame: null};
  contender.label = [peer || (engine === "yours" ? "your engine" : "the reference"), ...Object.values(changes)].join(", ");
  contender.link = new EngineLink(engine, (answer) => answered(contender, answer));
  page.contenders.push(contender);
  load(contender);
}

function load(contender) {
  contender.dead = false;
  contender.link.send({kind: "load", scene: page.name, peer: contender.peer, values: {...page.values, ...contender.changes}});
}

function answered(contender, answer) {
  if (answer.kind === "scene") {
    if (!page.spec) showScene(answer);
    showContenders();
  } else if (answer.kind === "frame") {
    contender.frame = answer;
    if (answer.error !== null && answer.error !== undefined) contender.worst = Math.max(contender.worst, answer.error);
    chart(contender, answer);
  } else if (answer.kind === "stopped") {
    contender.dead = true;
    trouble(`${contender.label}: ${answer.why}`);
    if (page.contenders.every((each) => each.dead)) play(false);
  } else if (answer.kind === "refused") {
    trouble(answer.why);
  } else if (answer.kind === "saved") {
    say(`${answer.files.join(", ")} saved: the scene starts again with it.`);
    restart();
  } else if (answer.kind === "judged") {
    page.judged?.(answer);
  }
}

function trouble(words) {
  $("trouble").hidden = !words;
  $("trouble").textContent = words;
}

function say(words) {
  if ($("say").textContent !== words) $("say").textContent = words;
}

// --- What is shown of a scene ----------------------------------------------------------------

function showScene(spec) {
  page.spec = spec;
  document.title = `${spec.title} - the lab`;
  $("title").textContent = spec.title;
  $("question").textContent = spec.question;
  for (const parameter of spec.parameters) {
    const value = page.values[parameter.name] ?? parameter.default;
    $("parameters").append(makeControl(parameter, value, (wanted) => change(parameter.name, wanted)));
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

function showRivals(spec) {
  $("add").replaceChildren(new Option("another one ...", ""));
  const add = (label, rival) => $("add").add(new Option(label, JSON.stringify(rival)));
  for (const engine of page.list.engines.slice(1)) add("the reference", {engine, peer: "", changes: {}});
  const own = page.list.engines[0];
  for (const peer of spec.peers) add(peer, {engine: own, peer, changes: {}});
  for (const {name, label, options} of spec.parameters) {
    if (!["integrator", "rate"].includes(name)) continue;
    for (const option of options) add(`${label}: ${option}`, {engine: own, peer: "", changes: {[name]: option}});
  }
}

function tint(contender) {
  return getComputedStyle(document.documentElement).getPropertyValue(TINTS[contender.number % TINTS.length]);
}

function showStages() {
  const apart = $("split").checked ? page.contenders : page.contenders.slice(0, 1);
  $("stage").classList.toggle("split", apart.length > 1);
  $("stage").replaceChildren();
  page.stages = apart.map((contender) => {
    const figure = document.createElement("figure");
    const canvas = document.createElement("canvas");
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `${page.spec.title}: ${page.spec.question}`);
    canvas.setAttribute("aria-describedby", "say");
    figure.append(canvas);
    if (apart.length > 1) {
      const caption = document.createElement("figcaption");
      caption.textContent = contender.label;
      figure.append(caption);
    }
    $("stage").append(figure);
    const stage = new Stage(canvas);
    stage.view = page.spec.view;
    stage.fit();
    listen(stage);
    return stage;
  });
}

function showContenders() {
  const body = $("contenders").tBodies[0];
  body.replaceChildren();
  for (const contender of page.contenders) {
    const row = body.insertRow();
    const name = document.createElement("th");
    name.scope = "row";
    name.innerHTML = `<span class="swatch" style="background:${tint(contender)}"></span>`;
    name.append(contender.label);
    row.append(name);
    contender.cells = [row.insertCell(), row.insertCell()];
    const last = row.insertCell();
    if (contender.number) {
      const remove = document.createElement("button");
      remove.textContent = "remove";
      remove.setAttribute("aria-label", `remove ${contender.label}`);
      remove.onclick = () => removeContender(contender);
      last.append(remove);
    }
  }
}

function removeContender(contender) {
  contender.link.close();
  page.contenders.splice(page.contenders.indexOf(contender), 1);
  page.contenders.forEach((each, number) => (each.number = number));
  page.charts.clear();
  showContenders();
  showStages();
  remember();
}

function chart(contender, frame) {
  const colors = page.contenders.map(tint);
  if (contender.number >= colors.length) return;
  const values = {...frame.chart};
  if (frame.error !== null && frame.error !== undefined) values[`error, ${page.spec.errorUnit}`] = frame.error;
  for (const [title, value] of Object.entries(values)) page.charts.add(title, frame.time, contender.number, colors, value);
}

// --- Time ------------------------------------------------------------------------------------

function play(wanted) {
  page.playing = wanted;
  page.last = performance.now();
  $("play").textContent = wanted ? "Pause" : "Play";
  if (wanted) return;
  page.target = Math.max(0, ...page.contenders.map((c) => c.asked)); // those behind catch up
  if (page.contenders[0]?.frame) say(page.contenders[0].frame.say);
}

function advance(frames) {
  page.target += frames;
  for (const contender of page.contenders) {
    const due = Math.floor(page.target) - contender.asked;
    if (contender.dead || contender.link.busy || due < 1) continue;
    const now = Math.min(due, MOST_AT_ONCE);
    contender.asked += now;
    contender.link.send({kind: "run", frames: now});
  }
}

function restart() {
  trouble("");
  page.charts.clear();
  page.target = 0;
  page.until = Infinity;
  for (const contender of page.contenders) {
    Object.assign(contender, {asked: 0, worst: 0});
    load(contender);
  }
}

let pictures = 0;

function tick(now) {
  if (page.playing) {
    advance(((now - page.last) / 1000) * FRAMES * Number($("speed").value));
    page.last = now;
    // Where an engine cannot follow, time passes more slowly.
    const slowest = Math.min(...page.contenders.filter((c) => !c.dead).map((c) => c.asked));
    page.target = Math.min(page.target, slowest + 4 * MOST_AT_ONCE, page.until);
    if (slowest >= page.until) {
      page.until = Infinity;
      play(false);
      page.contenders[0].link.send({kind: "predict", option: page.guess});
    }
  }
  advance(0); // a step that was wanted while an engine was busy
  drawAll();
  if (++pictures % 6 === 0) showNumbers();
  requestAnimationFrame(tick);
}

function drawAll() {
  page.stages?.forEach((stage, place) => {
    stage.clear();
    page.contenders.forEach((contender, number) => {
      if (!contender.frame || (page.stages.length > 1 && number !== place)) return;
      stage.draw(contender.frame.items, page.hidden, number ? tint(contender) : "");
    });
  });
}

function showNumbers() {
  const [first] = page.contenders;
  if (!first?.frame) return;
  $("clock").textContent = `${first.frame.time.toFixed(2)} s`;
  if ($("facts").textContent !== first.frame.facts) $("facts").textContent = first.frame.facts;
  if (page.playing && pictures % 120 === 0) say(first.frame.say);
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

// --- What a reader does ----------------------------------------------------------------------

function change(name, value) {
  page.values[name] = value;
  trouble("");
  const live = ["integrator", "rate"].includes(name);
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

function listen(stage) {
  const canvas = stage.canvas;
  let held = "";
  const send = (message) => page.contenders.forEach((contender) => contender.link.send(message));
  canvas.onpointerdown = (event) => {
    const [x, y] = stage.point(event);
    const circles = (page.contenders[0].frame?.items ?? []).filter((item) => item[0] === "circle" && item[6]);
    const near = circles.find(([, , cx, cy, radius]) => Math.hypot(cx - x, cy - y) < Math.max(radius, 14 / stage.scale));
    held = near ? near[6] : "";
    if (held) canvas.setPointerCapture(event.pointerId);
    else send({kind: "click", x, y});
  };
  canvas.onpointermove = (event) => {
    if (!held || page.contenders[0].link.busy) return;
    const [x, y] = stage.point(event);
    send({kind: "drag", name: held, x, y});
  };
  canvas.onpointerup = () => (held = "");
}

function remember() {
  const query = new URLSearchParams({scene: page.name, ...page.values});
  for (const {engine, peer, changes} of page.contenders.slice(1)) query.append("with", JSON.stringify({engine, peer, changes}));
  history.replaceState(null, "", `?${query}`);
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
  const keys = {"space": "play or pause", ".": "one frame", "r": "restart", "?": "this list", ...page.spec?.keys};
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
  addContender(JSON.parse($("add").value));
  restart();
  showStages();
  remember();
  $("add").value = "";
};
$("csv").onclick = () => save(`${page.name}.csv`, "text/csv", page.charts.csv(page.contenders.map((c) => c.label)));
$("gif").onclick = async () => {
  say("The animation is being drawn. This takes some seconds.");
  const answer = await fetch(`record.gif?${new URLSearchParams({scene: page.name, ...page.values})}`);
  if (answer.ok) save(`${page.name}.gif`, "image/gif", await answer.blob());
  say(answer.ok ? "The animation is saved." : await answer.text());
};
$("link").onclick = async () => {
  await navigator.clipboard.writeText(location.href);
  say("The address is copied.");
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
  for (const rival of query.getAll("with")) addContender(JSON.parse(rival));
  requestAnimationFrame(tick);
}

start();
