// The buttons and the keyboard shortcuts of a lab.

import {compare} from "./contenders.js";
import {showStages} from "./stages.js";
import {advance, play, restart} from "./time.js";

const SCENE_KEYS = {ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down"};
const ARROWS = {velocity: "velocity", force: "force", contact: "contacts"};

export function connectButtons(lab) {
  const {$} = lab;
  $("play").onclick = () => play(lab, !lab.playing);
  $("step").onclick = () => (play(lab, false), advance(lab, 1));
  $("restart").onclick = () => restart(lab);
  $("help").onclick = () => showKeys(lab);
  $("split").onchange = () => showStages(lab);
  $("add").onchange = () => {
    if (!$("add").value) return;
    compare(lab, JSON.parse($("add").value));
    restart(lab);
    showStages(lab);
    lab.changed(lab);
    $("add").value = "";
  };
  $("csv").onclick = () => save(`${lab.name}.csv`, "text/csv", lab.charts.csv(lab.contenders.map((c) => c.label)));
  $("gif").hidden = !lab.record;
  $("gif").onclick = async () => {
    lab.say("Drawing the animation. This takes a few seconds.");
    const {content, why} = await lab.record(lab.name, lab.values).catch((error) => ({why: `The animation has failed: ${error.message}`}));
    if (content) save(`${lab.name}.gif`, "image/gif", content);
    lab.say(content ? "The animation has been saved." : why);
  };
  $("link").onclick = async () => {
    const address = lab.address(lab);
    try {
      await navigator.clipboard.writeText(address);
      lab.say("The link has been copied.");
    } catch {
      lab.say(`This browser does not let the page copy the link: ${address}`);
    }
  };
  for (const [kind, words] of Object.entries(ARROWS)) {
    const label = document.createElement("label");
    const box = document.createElement("input");
    Object.assign(box, {type: "checkbox", checked: !lab.hidden.has(kind)});
    box.onchange = () => (box.checked ? lab.hidden.delete(kind) : lab.hidden.add(kind));
    label.append(box, ` ${words}`);
    $("arrows").append(label);
  }
}

// Listen to the keys of the whole page or, if it has several labs, to those that reach one lab.
export function listenToKeys(lab, target) {
  target.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || lab.$("keys")?.open !== false) return;
    const inField = event.target.closest("input, select, textarea, button, a, dialog, summary");
    if (event.key === "?") showKeys(lab);
    else if (inField) return;
    else if (event.key === " ") play(lab, !lab.playing);
    else if (event.key === ".") advance(lab, 1);
    else if (event.key === "r") restart(lab);
    else {
      const key = SCENE_KEYS[event.key] ?? event.key;
      if (!lab.spec || !(key in lab.spec.keys)) return;
      lab.press(key);
    }
    event.preventDefault();
  });
}

function showKeys(lab) {
  const keys = {"space": "play or pause", ".": "advance by one frame", "r": "restart", "?": "show this list", ...lab.spec?.keys};
  lab.$("keys").querySelector("dl").replaceChildren(
    ...Object.entries(keys).flatMap(([key, words]) => {
      const [term, meaning] = [document.createElement("dt"), document.createElement("dd")];
      [term.textContent, meaning.textContent] = [key, words];
      return [term, meaning];
    }),
  );
  lab.$("keys").showModal();
}

export function save(name, type, content) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], {type}));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}
