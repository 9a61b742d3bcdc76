// Links between a lab and the engines of this page, and the options of a lab on the site.

import {outline} from "../course.js";
import {el, site} from "../dom.js";
import {engines} from "../python/python.js";
import {chaptersGiven} from "../exercise/results.js";
import {workspace} from "../files/workspace.js";

const ABSENT = {pymunk: "pymunk cannot be compared here, because it is not available in a browser."};

// The options that every lab of the site has.
export async function labOptions() {
  const {chapters, solutions} = await outline();
  const all = chapters.map(({number}) => number);
  return {
    engines: solutions ? ["yours", "reference"] : ["yours"],
    absent: ABSENT,
    connect: (engine, onAnswer) => connect(onAnswer, () => (engine === "reference" ? all : chaptersGiven())),
    troubled: (words, place) => linkExercise(words, place, chapters),
  };
}

// A link that sends the student's files along whenever a scene is loaded.
function connect(onAnswer, given) {
  const link = engines().lab(onAnswer);
  return {
    send: (message) => link.send(message.kind === "load" ? {...message, files: workspace.written(), given: given()} : message),
    close: () => link.close(),
    get busy() {
      return link.busy;
    },
  };
}

// If a scene needs an exercise that is not done, link to that exercise.
function linkExercise(words, place, chapters) {
  const id = /Exercise ([BGP]?\d\.\w+)/.exec(words)?.[1];
  const chapter = chapters.find(({exercises}) => exercises.some((exercise) => exercise.id === id));
  if (!chapter) return;
  const href = `${chapter.name}.html#ex-${id.replace(".", "-")}`;
  place.append(el("br"), el("a", {href}, `This scene runs your own code. Write exercise ${id} first.`));
}

let loading = null;

// Load the library for charts, which is a separate script, and the lab's modules.
export function loadLab() {
  loading ??= new Promise((resolve) => {
    const script = el("script", {src: site("vendor/uPlot.iife.min.js"), onload: resolve, onerror: resolve}); // a scene runs without charts
    document.head.append(script);
  }).then(() => Promise.all([import("../../../lab/page/lab.js"), import("../../../lab/page/keys.js"), import("../../../lab/page/time.js")]));
  return loading;
}
