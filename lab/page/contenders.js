// The contenders are the student's engine and, after it, the engines and methods to compare it with.

import {showStages} from "./stages.js";

export function compare(lab, {engine, peer, changes}) {
  const contender = {engine, peer, changes, number: lab.contenders.length, asked: lab.target, worst: 0, frame: null};
  contender.label = [peer || (engine === "yours" ? "your engine" : "the reference"), ...Object.values(changes)].join(", ");
  contender.link = lab.connect(engine, (answer) => lab.attempt(() => lab.answered(contender, answer)));
  lab.contenders.push(contender);
  load(lab, contender);
}

export function load(lab, contender) {
  contender.dead = false;
  contender.link.send({kind: "load", scene: lab.name, peer: contender.peer, values: {...lab.values, ...contender.changes}});
}

// Offer the engines and methods to compare the scene with, and name those that are not available.
export function showRivals(lab) {
  const {$, spec} = lab;
  $("add").replaceChildren(new Option("choose ...", ""));
  const add = (label, rival) => $("add").add(new Option(label, JSON.stringify(rival)));
  for (const engine of lab.engines.slice(1)) add("the reference", {engine, peer: "", changes: {}});
  const own = lab.engines[0];
  for (const peer of spec.peers) if (!lab.absent[peer]) add(peer, {engine: own, peer, changes: {}});
  for (const {name, label, options} of spec.parameters) {
    if (!spec.compare.includes(name)) continue;
    for (const option of options) add(`${label}: ${option}`, {engine: own, peer: "", changes: {[name]: option}});
  }
  const absent = spec.peers.map((peer) => lab.absent[peer]).filter(Boolean);
  $("absent").hidden = !absent.length;
  $("absent").textContent = absent.join(" ");
}

export function showContenders(lab) {
  const body = lab.$("contenders").tBodies[0];
  body.replaceChildren();
  for (const contender of lab.contenders) {
    const row = body.insertRow();
    const name = document.createElement("th");
    name.scope = "row";
    const swatch = document.createElement("span");
    swatch.className = "swatch";
    swatch.style.background = lab.tint(contender);
    name.append(swatch, contender.label);
    row.append(name);
    contender.cells = [row.insertCell(), row.insertCell()];
    const last = row.insertCell();
    if (contender.number) {
      const remove = document.createElement("button");
      Object.assign(remove, {type: "button", textContent: "remove", onclick: () => removeContender(lab, contender)});
      remove.setAttribute("aria-label", `remove ${contender.label}`);
      last.append(remove);
    }
  }
}

function removeContender(lab, contender) {
  contender.link.close();
  lab.contenders.splice(lab.contenders.indexOf(contender), 1);
  lab.contenders.forEach((each, number) => (each.number = number));
  lab.charts.clear();
  showContenders(lab);
  showStages(lab);
  lab.changed(lab);
}
