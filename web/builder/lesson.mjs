// What is added to the text of a lesson: a panel for each exercise, and live figures.

import {code, escape} from "./markdown.mjs";
import {termLink} from "./terms.mjs";

const CHECK = /^make check EX=(\S+)/;
const LAB = /make lab SCENE=([\w-]+)(?:\s+SET="([^"]*)")?/;
const SHORT = 20; // code of at most this many letters is not broken over lines
const STARS = ["", "★☆☆", "★★☆", "★★★"];

export const anchor = (id) => `ex-${id.replace(".", "-")}`;

// A block of commands: panels where it checks exercises; else the commands, which a page needs not.
export function fence(info, content, env) {
  const lines = content.trim().split("\n");
  if (info === "sh" && lines.every((line) => CHECK.test(line))) {
    return lines.map((line) => panel(CHECK.exec(line)[1], env, line)).join("");
  }
  if (info !== "sh" || !/^make /m.test(content) || env.told) return null;
  env.told = true;
  const words =
    "These commands are for your own computer. On this page you need none of them: each exercise has an editor " +
    "with the buttons Check and Hint, and the scenes of the lab start with a click.";
  return `${code(info, content)}<p class="aside">${words}</p>`;
}

function panel(id, env, command) {
  const {chapter} = env;
  const exercise = chapter.exercises.find((each) => each.id === id);
  const level = Math.min(6, (env.level ?? 2) + 1);
  const points = exercise.points === 1 ? "1 point" : `${exercise.points} points`;
  const stars = `<span class="stars" role="img" aria-label="${exercise.stars} of 3 stars">${STARS[exercise.stars]}</span>`;
  const terms = exercise.terms.map((name) => env.findTerm(name)).filter(Boolean);
  for (const term of terms) env.used.set(term.id, term);
  const words = terms.map((term) => `${termLink(term)}${escape(term.name)}</a>`).join(", ");
  const kind = exercise.kind === "written" ? "turn written" : "turn";
  return `<section class="${kind}" id="${anchor(id)}" data-exercise="${id}" aria-labelledby="${anchor(id)}-title">
<div class="turn-head"><h${level} id="${anchor(id)}-title">${id} ${escape(exercise.title)}</h${level}>
<p class="turn-meta">${stars} <span>${points}</span> <span class="state" data-state="">not checked yet</span></p></div>
${words ? `<p class="turn-terms">Terms: ${words}</p>` : ""}
<div class="turn-body"></div>
<noscript><p>To check it on your own computer:</p>${code("sh", `${command}\n`)}</noscript>
</section>
`;
}

// The panel that checks a whole chapter, at the end of its lesson.
export function chapterPanel(chapter, next) {
  const following = next ? `<p class="next"><a href="${next.name}.html">Next: chapter ${next.number}, ${escape(next.title)}</a></p>` : "";
  return `<h2 id="your-chapter">Your chapter ${chapter.number}</h2>
<section class="whole" data-whole="${chapter.name}" aria-labelledby="your-chapter">
<noscript><p>To check all exercises on your own computer:</p>${code("sh", `make check CH=${chapter.number}\n`)}</noscript>
</section>
${following}
`;
}

// A command in a sentence becomes a link to what it does, if the site can do it.
export function inlineCode(content, env) {
  const html = `<code${content.length <= SHORT ? ' class="short"' : ""}>${escape(content)}</code>`;
  const lab = LAB.exec(content);
  if (lab) return `<a href="${labAddress(lab[1], lab[2])}">${html}</a>`;
  const whole = /^make check CH=(\d+)$/.exec(content);
  return whole && Number(whole[1]) === env.chapter?.number ? `<a href="#your-chapter">${html}</a>` : html;
}

export function labAddress(scene, settings = "") {
  const values = settings.split(/\s+/).filter(Boolean).map((word) => word.split("="));
  return escape(`lab.html?${new URLSearchParams([["scene", scene], ...values])}`);
}

// A quotation that begins with bold words is an experiment, which gets its scene, or a question.
export function callouts(md) {
  md.renderer.rules.blockquote_open = (tokens, i, _, env) => {
    const words = tokens[i + 2]?.type === "inline" ? tokens[i + 2].content : "";
    const kind = words.startsWith("**Experiment") ? "experiment" : words.startsWith("**Check yourself") ? "question" : "";
    env.quotes = [...(env.quotes ?? []), kind === "experiment" ? LAB.exec(words) : null];
    return kind ? `<div class="callout ${kind}" role="note">` : '<blockquote class="plain">';
  };
  md.renderer.rules.blockquote_close = (tokens, i, _, env) => {
    const scene = env.quotes.pop();
    const open = tokens.slice(0, i).findLast((token) => token.type === "blockquote_open" && token.level === tokens[i].level);
    const words = tokens[tokens.indexOf(open) + 2].content;
    if (!/^\*\*(Experiment|Check yourself)/.test(words)) return "</blockquote>";
    return `${scene ? liveFigure(scene[1], scene[2], env) : ""}</div>`;
  };
}

// A figure that plays a scene once the reader starts it. Before that, and without scripts, it is a picture.
export function liveFigure(name, settings, env, picture = "") {
  const scene = env.scenes.find((each) => each.name === name);
  const still = [name, ...(settings ?? "").replaceAll("=", "-").split(/\s+/).filter(Boolean)].join("_");
  const alt = `A still picture of the scene “${escape(scene.title)}”.`;
  const image = picture || `<img src="stills/${still}.svg" width="640" height="400" loading="lazy" alt="${alt}">`;
  const values = Object.fromEntries((settings ?? "").split(/\s+/).filter(Boolean).map((word) => word.split("=")));
  return `<figure class="live" data-scene="${name}" data-values="${escape(JSON.stringify(values))}">
<div class="live-place">${image}</div>
<figcaption>${escape(scene.title)} <a href="${labAddress(name, settings)}">Open it in the lab</a></figcaption>
</figure>
`;
}
