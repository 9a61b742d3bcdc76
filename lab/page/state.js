// The current state of the page, and small helpers that all of its modules use.

import {Charts} from "./charts.js";

export const $ = (id) => document.getElementById(id);
export const FRAMES = 60; // per second
const TINTS = ["--blue", "--red", "--green", "--violet", "--orange"];

export const page = {
  list: {scenes: [], engines: []},
  spec: null,
  values: {},
  contenders: [],
  playing: false,
  target: 0, // frames that should have passed
  until: Infinity, // number of frames after which a prediction is judged
  hidden: new Set(["force", "contact"]),
  charts: new Charts($("charts")),
};

export function trouble(words) {
  $("trouble").hidden = !words;
  $("trouble").textContent = words;
}

export function say(words) {
  if ($("say").textContent !== words) $("say").textContent = words;
}

// The color of a contender in the table, the charts and the picture.
export function tint(contender) {
  return getComputedStyle(document.documentElement).getPropertyValue(TINTS[contender.number % TINTS.length]);
}

// Store everything in the address that is needed to restore the page.
export function remember() {
  const query = new URLSearchParams({scene: page.name, ...page.values});
  for (const {engine, peer, changes} of page.contenders.slice(1)) query.append("with", JSON.stringify({engine, peer, changes}));
  history.replaceState(null, "", `?${query}`);
}
