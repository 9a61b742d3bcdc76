// The contenders: the student's engine first, then the engines and methods to compare it with.

import {EngineLink} from "./engine.js";
import {showStages} from "./stages.js";
import {$, page, remember, tint} from "./state.js";

export function addContender({engine, peer, changes}, answered) {
  const contender = {engine, peer, changes, number: page.contenders.length, asked: page.target, worst: 0, frame: null};
  contender.label = [peer || (engine === "yours" ? "your engine" : "the reference"), ...Object.values(changes)].join(", ");
  contender.link = new EngineLink(engine, (answer) => answered(contender, answer));
  page.contenders.push(contender);
  load(contender);
}

export function load(contender) {
  contender.dead = false;
  contender.link.send({kind: "load", scene: page.name, peer: contender.peer, values: {...page.values, ...contender.changes}});
}

export function showRivals(spec) {
  $("add").replaceChildren(new Option("choose ...", ""));
  const add = (label, rival) => $("add").add(new Option(label, JSON.stringify(rival)));
  for (const engine of page.list.engines.slice(1)) add("the reference", {engine, peer: "", changes: {}});
  const own = page.list.engines[0];
  for (const peer of spec.peers) add(peer, {engine: own, peer, changes: {}});
  for (const {name, label, options} of spec.parameters) {
    if (!spec.compare.includes(name)) continue;
    for (const option of options) add(`${label}: ${option}`, {engine: own, peer: "", changes: {[name]: option}});
  }
}

export function showContenders() {
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
