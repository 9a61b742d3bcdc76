// Show the numbers of a lab: the clock, the facts, the table of contenders and the charts.

import {drawTradeoff} from "./charts.js";

export function isKnown(error) {
  return error !== null && error !== undefined;
}

// Return a duration in microseconds as text. It is measured with an uncertainty of up to a fifth.
function duration(micros) {
  const [value, unit] = micros >= 1000 ? [micros / 1000, "ms"] : [micros, "µs"];
  return `${Number(value.toPrecision(2))} ${unit}`;
}

export function showNumbers(lab) {
  const {$} = lab;
  const [first] = lab.contenders;
  if (!first?.frame) return;
  $("clock").textContent = `${first.frame.time.toFixed(2)} s`;
  if ($("facts").textContent !== first.frame.facts) $("facts").textContent = first.frame.facts;
  if (lab.playing && first.frame.time - (lab.said ?? -2) >= 2) {
    lab.said = first.frame.time;
    lab.say(first.frame.say);
  }
  for (const [name, value] of Object.entries(first.frame.changed)) {
    if (lab.values[name] === value) continue;
    lab.values[name] = value;
    lab.controls.get(name).show(value);
    lab.changed(lab);
  }
  const exact = isKnown(first.frame.error);
  for (const {cells, frame, worst} of lab.contenders) {
    if (!cells || !frame) continue;
    cells[0].textContent = exact ? `${worst.toPrecision(2)} ${lab.spec.errorUnit}` : "no exact solution";
    cells[1].textContent = frame.cost ? duration(frame.cost) : "not known yet";
  }
  lab.charts.draw();
  $("tradeoff").hidden = !exact;
  if (!exact) return;
  const costly = lab.contenders.filter((each) => each.frame && each.frame.cost);
  const points = costly.map((c) => ({cost: c.frame.cost, error: c.worst, color: lab.tint(c), number: c.number + 1}));
  drawTradeoff($("tradeoff").firstElementChild, points);
}
