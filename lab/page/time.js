// Time: frames that should have passed, and engines that are asked for them.

import {load} from "./contenders.js";
import {drawAll} from "./stages.js";
import {$, FRAMES, page, say, trouble} from "./state.js";

const MOST_AT_ONCE = 8; // frames that a link is asked for in one message
let pictures = 0;

export function play(wanted) {
  page.playing = wanted;
  page.last = performance.now();
  $("play").textContent = wanted ? "Pause" : "Play";
  if (wanted) return;
  page.target = Math.max(0, ...page.contenders.map((c) => c.asked)); // those behind catch up
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

// Before each picture of the screen: let time pass, draw, and now and then show the numbers.
export function tick(now, showNumbers) {
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
  requestAnimationFrame((later) => tick(later, showNumbers));
}
