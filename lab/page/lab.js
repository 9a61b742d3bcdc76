// A lab: one scene, its parameters, and one or more engines that play it.
//
// options:
//   prefix         a text that is put before the ids of the lab's parts
//   compact        whether the charts and the comparison are folded away at first
//   engines        the names of the engines to choose from, starting with the student's own
//   connect        connect(engine, onAnswer) returns a link to an engine, with send, close and busy
//   absent         the engines that are not available here, each with the reason: {pymunk: "..."}
//   opened         is called with the description of a scene after it has been opened
//   troubled       troubled(words, place) may add to the message that a scene cannot run
//   address        address(lab) returns an address that opens the lab again in the same state
//   changed        is called when this address changes
//   record         record(scene, values) returns a promise of an animation, if one can be made

import {Charts} from "./charts.js";
import {compare, load, showContenders, showRivals} from "./contenders.js";
import {makeControl} from "./controls.js";
import {connectButtons} from "./keys.js";
import {isKnown, showNumbers} from "./numbers.js";
import {ask} from "./predict.js";
import {isGrabbed, showStages} from "./stages.js";
import {FRAMES, play, restart, tick} from "./time.js";
import {markup} from "./view.js";

const TINTS = ["--blue", "--red", "--green", "--violet", "--orange"];
const nothing = () => {};

export class Lab {
  constructor(place, options) {
    const defaults = {prefix: "", compact: false, absent: {}, opened: nothing, troubled: nothing, changed: nothing, address: () => location.href};
    Object.assign(this, {...defaults, ...options});
    this.place = place;
    place.innerHTML = markup(this.prefix, this.compact);
    place.classList.toggle("compact", this.compact);
    this.$ = (name) => document.getElementById(this.prefix + name);
    this.spec = null;
    this.values = {};
    this.contenders = [];
    this.playing = false;
    this.target = 0; // how many frames should have passed by now
    this.took = 0; // ms that the engines have spent on frames
    this.until = Infinity; // the number of frames after which a question is answered
    this.hidden = new Set(["force", "contact"]);
    this.charts = new Charts(this.$("charts"));
    this.controls = new Map();
    connectButtons(this);
    this.sizes = new ResizeObserver(() => this.charts.fit());
    this.sizes.observe(this.$("right"));
    requestAnimationFrame((now) => tick(this, now));
  }

  // Open a scene. Rivals are the engines with which the student's own engine is compared.
  open(name, values, rivals = []) {
    for (const contender of this.contenders.splice(0)) contender.link.close();
    Object.assign(this, {spec: null, values, name, target: 0, until: Infinity});
    play(this, false);
    this.trouble("");
    this.charts.clear();
    this.$("clock").textContent = "0.00 s";
    this.$("contenders").tBodies[0].replaceChildren();
    this.$("stage").replaceChildren();
    this.$("parameters").replaceChildren();
    for (const rival of [{engine: this.engines[0], peer: "", changes: {}}, ...rivals]) compare(this, rival);
  }

  close() {
    this.closed = true;
    this.sizes.disconnect();
    for (const contender of this.contenders.splice(0)) contender.link.close();
    this.charts.clear();
    this.place.replaceChildren();
  }

  answered(contender, answer) {
    if (this.closed) return;
    if (answer.kind === "scene") {
      if (!this.spec) this.show(answer);
      showContenders(this);
    } else if (answer.kind === "frame") {
      contender.frame = answer;
      this.took += answer.took ?? 0;
      this.$("grab").hidden = !answer.items.some(isGrabbed);
      if (isKnown(answer.error)) contender.worst = Math.max(contender.worst, answer.error);
      this.chart(contender, answer);
    } else if (answer.kind === "stopped") {
      contender.dead = true;
      this.trouble(`${contender.label}: ${answer.why}`);
      if (this.contenders.every((each) => each.dead)) play(this, false);
    } else if (answer.kind === "refused") {
      this.trouble(answer.why);
    } else if (answer.kind === "saved") {
      this.say(`${answer.files.join(", ")} saved. The scene restarts with the new code.`);
      restart(this);
    } else if (answer.kind === "judged") {
      this.judged?.(answer);
    }
  }

  // Show a scene that has been opened.
  show(spec) {
    this.spec = spec;
    this.values = spec.values; // as the scene has read them
    this.controls.clear();
    for (const parameter of spec.parameters) {
      const value = this.values[parameter.name] ?? parameter.default;
      const control = makeControl(parameter, value, (wanted) => this.change(parameter.name, wanted));
      this.$("parameters").append(control);
      this.controls.set(parameter.name, control);
    }
    this.$("parameters").hidden = !spec.parameters.length;
    this.showActions(spec.keys);
    showRivals(this);
    showStages(this);
    ask(this.$("predict"), spec.predict, {
      skip: () => play(this, true),
      watch: (option, then) => {
        this.until = this.target + spec.predict.seconds * FRAMES;
        Object.assign(this, {guess: option, judged: then});
        play(this, true);
      },
    });
    this.opened(spec);
  }

  showActions(keys) {
    this.$("actions").replaceChildren();
    this.$("actions").hidden = !Object.keys(keys).length;
    for (const [key, words] of Object.entries(keys)) {
      const button = document.createElement("button");
      Object.assign(button, {type: "button", textContent: `${words} (${key})`, onclick: () => this.press(key)});
      this.$("actions").append(button);
    }
  }

  chart(contender, frame) {
    const colors = this.contenders.map((each) => this.tint(each));
    if (contender.number >= colors.length) return;
    const values = {...frame.chart};
    if (isKnown(frame.error)) values[`error, ${this.spec.errorUnit}`] = frame.error;
    for (const [title, value] of Object.entries(values)) {
      this.charts.add(title, frame.time, contender.number, colors, value);
    }
  }

  // Change a parameter of the scene in all engines that do not have their own value for it.
  change(name, value) {
    this.values[name] = value;
    this.trouble("");
    const {live} = this.spec.parameters.find((parameter) => parameter.name === name);
    for (const contender of this.contenders) {
      if (name in contender.changes) continue;
      contender.dead = false;
      contender.worst = 0;
      contender.link.send({kind: "set", name, value});
      if (!live) contender.asked = 0;
    }
    if (!live) this.target = 0;
    if (!live) this.charts.clear();
    this.changed(this);
  }

  press(key) {
    for (const contender of this.contenders) contender.link.send({kind: "press", key});
  }

  // Do a part of the page's own work. If it fails, say so, and let the scene go on.
  attempt(act) {
    try {
      act();
    } catch (error) {
      console.error(error);
      this.trouble(`This page could not show everything: ${error.message}`);
    }
  }

  trouble(words) {
    this.$("trouble").hidden = !words;
    this.$("trouble").textContent = words;
    if (words) this.troubled(words, this.$("trouble"));
  }

  say(words) {
    if (this.$("say").textContent !== words) this.$("say").textContent = words;
  }

  // Return the color of a contender in the table, the charts and the picture.
  tint(contender) {
    return getComputedStyle(document.documentElement).getPropertyValue(TINTS[contender.number % TINTS.length]);
  }

  // Return the query of an address that opens this scene again, with its parameters and rivals.
  query() {
    const query = new URLSearchParams({scene: this.name, ...this.values});
    for (const {engine, peer, changes} of this.contenders.slice(1)) {
      query.append("with", JSON.stringify({engine, peer, changes}));
    }
    return query;
  }

  showNumbers() {
    showNumbers(this);
  }

  reload() {
    for (const contender of this.contenders) load(this, contender);
  }
}

// Read the query of an address: a scene, the values of its parameters, and the rivals.
export function asked(query, first) {
  const {scene = first, ...values} = Object.fromEntries([...query].filter(([key]) => key !== "with"));
  return {scene, values, rivals: query.getAll("with").map((rival) => JSON.parse(rival))};
}
