// Advance time: count the frames that are due, and request them from the engines.

import {drawAll} from "./stages.js";

export const FRAMES = 60; // per second
const MOST_AT_ONCE = 8; // frames requested from an engine in one message
const SLOW = 0.85; // fraction of real time below which the page shows a note
const BUSY = 0.5; // fraction of the time that the engines spend on frames if these are too slow
const WINDOW = 1000; // ms over which the pace is measured

export function play(lab, wanted) {
  lab.playing = wanted;
  lab.last = performance.now();
  lab.measured = null;
  lab.$("play").textContent = wanted ? "Pause" : "Play";
  if (wanted) return;
  lab.target = Math.max(0, ...lab.contenders.map((c) => c.asked)); // slower contenders catch up
  if (lab.contenders[0]?.frame) lab.say(lab.contenders[0].frame.say);
}

export function advance(lab, frames) {
  lab.target += frames;
  for (const contender of lab.contenders) {
    const due = Math.floor(lab.target) - contender.asked;
    if (contender.dead || contender.link.busy || due < 1) continue;
    const now = Math.min(due, MOST_AT_ONCE);
    contender.asked += now;
    contender.link.send({kind: "run", frames: now});
  }
}

export function restart(lab) {
  lab.trouble("");
  lab.charts.clear();
  lab.target = 0;
  lab.until = Infinity;
  for (const contender of lab.contenders) Object.assign(contender, {asked: 0, worst: 0});
  lab.reload();
}

// Run before each screen refresh: advance time, draw, and sometimes update the numbers.
export function tick(lab, now) {
  if (lab.closed) return;
  requestAnimationFrame((later) => tick(lab, later));
  if (lab.playing) {
    if (now - lab.last > WINDOW / 2) lab.measured = null; // the page was hidden or busy
    const speed = Number(lab.$("speed").value);
    advance(lab, ((now - lab.last) / 1000) * FRAMES * speed);
    lab.last = now;
    // If an engine cannot keep up, time passes more slowly.
    const slowest = Math.min(...lab.contenders.filter((c) => !c.dead).map((c) => c.asked));
    lab.target = Math.min(lab.target, slowest + 4 * MOST_AT_ONCE, lab.until);
    showPace(lab, now, speed);
    if (slowest >= lab.until) {
      lab.until = Infinity;
      play(lab, false);
      lab.contenders[0].link.send({kind: "predict", option: lab.guess});
    }
  }
  advance(lab, 0); // request steps that came due while an engine was busy
  lab.pictures = (lab.pictures ?? 0) + 1;
  lab.attempt(() => drawAll(lab));
  if (lab.pictures % 6 === 0) lab.attempt(() => lab.showNumbers());
}

// Show a note if the scene does not run in real time. Blame the frames only if the engines spend most
// of the time on them.
function showPace(lab, now, speed) {
  const whose = lab.contenders.find((each) => !each.dead);
  const time = whose?.frame?.time;
  if (time === undefined) return;
  const since = lab.measured;
  const current = {now, whose, time, speed, took: lab.took};
  if (!since || since.whose !== whose || since.speed !== speed || time < since.time) lab.measured = current;
  else if (now - since.now >= WINDOW) {
    const pace = (time - since.time) / ((now - since.now) / 1000) / speed;
    const busy = (lab.took - since.took) / (now - since.now);
    const why = busy > BUSY ? "one frame takes too long here" : "the browser is busy";
    lab.measured = current;
    lab.$("pace").hidden = pace >= SLOW;
    const words = `This runs at ${Math.round(100 * pace)} % of the speed that was asked for: ${why}.`;
    lab.$("pace").textContent = pace >= SLOW ? "" : words;
  }
}
