// Advance time: count the frames that are due, and request them from the engines.

import {load} from "./contenders.js";
import {drawAll} from "./stages.js";
import {$, FRAMES, page, say, trouble} from "./state.js";

const MOST_AT_ONCE = 8; // frames requested from an engine in one message
let pictures = 0;

export function play(wanted) {
  page.playing = wanted;
  page.last = performance.now();
  $("play").textContent = wanted ? "Pause" : "Play";
  if (wanted) return;
  page.target = Math.max(0, ...page.contenders.map((c) => c.asked)); // slower contenders catch up
  if (page.contenders[0]?.frame) say(page.contenders[0].frame.say);
}

export function advance(frames) {
  page.target += frames;
  for (const contender of page.contenders) {
    const due = Math.floor(page.target) - contender.asked;
    if (contender.dead || contender.link.busy || due < 1) continue;
    const now = Math.min(due, MOST_AT_ONCE);
    contender.asked += now;
    contender.link.send({kind: "run", frames: now});
  }
}

export function restart() {
  trouble("");
  page.charts.clear();
  page.target = 0;
  page.until = Infinity;
  for (const contender of page.contenders) {
    Object.assign(contender, {asked: 0, worst: 0});
    load(contender);
  }
}

// Run before each screen refresh: advance time, draw, and sometimes update the numbers.
export function tick(now, showNumbers) {
  if (page.playing) {
    advance(((now - page.last) / 1000) * FRAMES * Number($("speed").value));
    page.last = now;
    // If an engine cannot keep up, time passes more slowly.
    const slowest = Math.min(...page.contenders.filter((c) => !c.dead).map((c) => c.asked));
    page.target = Math.min(page.target, slowest + 4 * MOST_AT_ONCE, page.until);
    if (slowest >= page.until) {
      page.until = Infinity;
      play(false);
      page.contenders[0].link.send({kind: "predict", option: page.guess});
    }
  }
  advance(0); // request steps that came due while an engine was busy
  drawAll();
  if (++pictures % 6 === 0) showNumbers();
  requestAnimationFrame((later) => tick(later, showNumbers));
}
