// The page for marking: one answer at a time, with keys for points and comments.

import {discard, enter, hasDraft, markOf, marksOf, refresh, save, savedMark, unsaved} from "./marks.js";

const $ = (id) => document.getElementById(id);
const WAIT = 400; // ms without a keystroke, after which a comment is saved
const MOST = 9; // lines of comments to choose from
const KEYS = {
  "0 to 9": "so many points",
  "h": "half a point more",
  "Shift+1 to 9": "add, or take away, a line that you wrote before",
  "c": "write a comment; Escape leaves it",
  "j, k": "next answer, previous answer",
  "n": "next answer without a mark; Ctrl+Enter does the same in a comment",
  "x": "remove the mark",
  "?": "this list",
};
const here = {question: null, answer: null};
let questions = [];
let timer = 0;

const element = (name, words, more = {}) => Object.assign(document.createElement(name), {textContent: words, ...more});
const hasChanged = (question, answer) => savedMark(question.id, answer.code)?.changed === true;
const isMarked = (question, answer) => savedMark(question.id, answer.code) !== null && !hasChanged(question, answer);
const isOpen = (question, answer) => (markOf(question.id, answer.code)?.points ?? null) === null || hasChanged(question, answer);
const linesOf = (comment) => comment.split("\n").filter((line) => line.trim());
const current = () => [here.question.id, here.answer.code];
const entered = () => markOf(...current()) ?? {points: null, comment: ""};

// --- What is shown -----------------------------------------------------------------------------

function showQuestion(question) {
  here.question = question;
  $("questions").value = question.id;
  $("title").textContent = `${question.id} ${question.title}`;
  for (const part of ["question", "rubric", "model"]) $(part).textContent = question[part];
}

function showAnswer(answer, {focus = true} = {}) {
  here.answer = answer;
  const number = here.question.answers.indexOf(answer) + 1;
  $("which").textContent = `Answer ${number} of ${here.question.answers.length}`;
  document.title = `${here.question.id}, answer ${number}: marking`;
  $("note").hidden = !answer.note;
  $("note").textContent = answer.note;
  $("text").textContent = answer.text || "Nothing was written here.";
  history.replaceState(null, "", `#${here.question.id}/${answer.code}`);
  showMark();
  say(stateOf(here.question, answer));
  trouble();
  if (hasDraft(...current())) store();
  if (focus) $("which").focus();
}

function stateOf(question, answer) {
  if (hasChanged(question, answer)) return "This answer has changed since it was marked. Give its points again.";
  return isMarked(question, answer) ? "This answer has a mark." : "This answer has no mark yet.";
}

function showMark() {
  const {points, comment} = entered();
  if ($("comment").value !== comment) $("comment").value = comment;
  const values = Array.from({length: 2 * here.question.points + 1}, (_, i) => i / 2);
  if (points !== null && !values.includes(points)) values.push(points);
  values.sort((a, b) => a - b);
  const shown = Array.from($("points").querySelectorAll("input"), (input) => Number(input.value));
  if (String(shown) !== String(values)) {
    $("points").replaceChildren(element("legend", `Points, of ${here.question.points}`), ...values.map(choice));
  }
  for (const input of $("points").querySelectorAll("input")) input.checked = Number(input.value) === points;
  $("remove").disabled = savedMark(...current()) === null;
  showBank();
  showProgress();
}

function choice(value) {
  const label = document.createElement("label");
  const input = Object.assign(document.createElement("input"), {type: "radio", name: "points", value});
  input.onclick = () => change({points: value}); // also if it is checked, for an answer that has changed
  label.append(input, String(value));
  return label;
}

// The lines of comments to this question, those first that were used most.
function bankOf(question) {
  const uses = new Map();
  for (const {comment} of Object.values(marksOf(question.id))) {
    for (const line of linesOf(comment)) uses.set(line, (uses.get(line) ?? 0) + 1);
  }
  return [...uses.keys()].sort((a, b) => uses.get(b) - uses.get(a) || (a < b ? -1 : 1)).slice(0, MOST);
}

function showBank() {
  const used = linesOf(entered().comment);
  const buttons = bankOf(here.question).map((line, i) => {
    const button = element("button", `${line} `, {type: "button", onclick: () => toggle(line)});
    button.setAttribute("aria-pressed", String(used.includes(line)));
    button.append(element("kbd", `Shift+${i + 1}`));
    return button;
  });
  const old = Array.from($("bank").querySelectorAll("button"), (button) => button.textContent + button.ariaPressed);
  if (String(old) !== String(buttons.map((button) => button.textContent + button.ariaPressed))) {
    const focused = [...$("bank").querySelectorAll("button")].indexOf(document.activeElement);
    $("bank").replaceChildren($("bank").querySelector("legend"), ...buttons);
    if (focused >= 0) buttons[Math.min(focused, buttons.length - 1)]?.focus();
  }
  $("bank").hidden = !buttons.length;
}

function showProgress() {
  const {answers} = here.question;
  const marked = answers.filter((answer) => isMarked(here.question, answer)).length;
  $("progress").textContent = `${marked} of ${answers.length} marked`;
  for (const option of $("questions").options) {
    const question = questions.find(({id}) => id === option.value);
    const left = question.answers.filter((answer) => !isMarked(question, answer)).length;
    option.textContent = `${question.id} ${question.title} (${left ? `${left} left` : "done"})`;
  }
}

function say(words) {
  if ($("status").textContent !== words) $("status").textContent = words;
}

function trouble(words = "", actions = {}) {
  $("trouble").hidden = !words;
  const buttons = Object.entries(actions).map(([name, onclick]) => element("button", name, {type: "button", onclick}));
  $("trouble").replaceChildren(element("p", words), ...buttons);
}

// --- What a person does ------------------------------------------------------------------------

function change(more, {soon = false} = {}) {
  enter(...current(), {...entered(), ...more});
  showMark();
  clearTimeout(timer);
  if (soon) timer = setTimeout(store, WAIT);
  else store();
}

async function store() {
  clearTimeout(timer);
  const [question, answer] = [here.question, here.answer];
  const result = await save(question.id, answer.code);
  if (answer !== here.answer) {
    showProgress();
    const number = question.answers.indexOf(answer) + 1;
    if (result.why) trouble(`Answer ${number} of question ${question.id} is not saved. ${result.why}`, {"Go back to it": () => go(answer, question)});
    return;
  }
  const saved = savedMark(question.id, answer.code);
  if (result.why) {
    say("This is not saved.");
    const actions = {"Try again": () => (trouble(), store())};
    if (result.changed) actions["Keep what is in the file"] = () => (discard(question.id, answer.code), trouble(), showMark());
    trouble(result.why, actions);
  } else {
    trouble();
    say(saved ? `Saved: ${saved.points} of ${question.points}.` : "This answer has no mark yet.");
  }
  showMark();
}

function toggle(line) {
  const lines = linesOf(entered().comment);
  const left = lines.filter((each) => each !== line);
  change({comment: (left.length < lines.length ? left : [...lines, line]).join("\n")});
}

function remove() {
  enter(...current(), null);
  $("comment").value = "";
  store();
}

async function go(answer, question = here.question) {
  if (!answer) return;
  store();
  if (question !== here.question) showQuestion(question);
  showAnswer(answer);
  await refresh();
  showMark();
}

function step(by) {
  const {answers} = here.question;
  const next = answers[answers.indexOf(here.answer) + by];
  if (next) go(next);
  else say(by > 0 ? "This was the last answer." : "This is the first answer.");
}

// The next answer without a mark: behind this one, then from the first on, then of other questions.
function goToUnmarked() {
  const {answers} = here.question;
  const place = answers.indexOf(here.answer);
  const others = questions.filter((question) => question !== here.question);
  const order = [here.question, ...others].flatMap((question) => {
    const own = question === here.question ? [...answers.slice(place + 1), ...answers.slice(0, place)] : question.answers;
    return own.map((answer) => [answer, question]);
  });
  const found = order.find(([answer, question]) => isOpen(question, answer));
  if (found) go(...found);
  else say("Every other answer has a mark.");
}

function pressed(event) {
  const {key, target} = event;
  if (event.metaKey || event.altKey || $("keys").open) return;
  if (event.ctrlKey && key === "Enter") goToUnmarked();
  else if (event.ctrlKey) return;
  else if (target === $("comment")) {
    if (key !== "Escape") return;
    $("which").focus();
  } else if (target.closest("select") || !$("single").checked) return;
  else if (event.shiftKey && /^Digit[1-9]$/.test(event.code)) {
    const comment = bankOf(here.question)[Number(event.code.at(-1)) - 1];
    if (comment) toggle(comment);
  } else if (/^[0-9]$/.test(key) && Number(key) <= here.question.points) change({points: Number(key)});
  else if (key === "h") {
    const points = (entered().points ?? 0) + 0.5;
    if (points <= here.question.points) change({points});
  } else if (key === "c") $("comment").focus();
  else if (key === "j") step(1);
  else if (key === "k") step(-1);
  else if (key === "n") goToUnmarked();
  else if (key === "x") remove();
  else if (key === "?") $("keys").showModal();
  else return;
  event.preventDefault();
}

// --- The beginning -----------------------------------------------------------------------------

async function start() {
  const answer = await fetch("questions.json");
  ({questions} = await answer.json());
  const {why} = await refresh();
  for (const {id} of questions) $("questions").append(new Option(id, id));
  for (const [key, words] of Object.entries(KEYS)) $("keys").querySelector("dl").append(element("dt", key), element("dd", words));
  for (const details of document.querySelectorAll("details")) details.open = matchMedia("(min-width: 60rem)").matches;
  const [id, code] = decodeURIComponent(location.hash.slice(1)).split("/");
  const remembered = questions.find((question) => question.id === id);
  const open = questions.find((question) => question.answers.some((each) => !isMarked(question, each)));
  showQuestion(remembered ?? open ?? questions[0]);
  const {answers} = here.question;
  const place = answers.find((each) => each.code === code) ?? answers.find((each) => !isMarked(here.question, each));
  showAnswer(place ?? answers[0], {focus: false});
  if (why) trouble(why);
}

document.addEventListener("keydown", pressed);
addEventListener("focus", async () => (await refresh(), here.answer && showMark()));
addEventListener("beforeunload", (event) => unsaved() && event.preventDefault());
$("comment").oninput = () => change({comment: $("comment").value}, {soon: true});
$("comment").onblur = store;
$("form").onsubmit = (event) => event.preventDefault();
$("questions").onchange = () => {
  const question = questions.find(({id}) => id === $("questions").value);
  go(question.answers.find((each) => !isMarked(question, each)) ?? question.answers[0], question);
};
$("previous").onclick = () => step(-1);
$("next").onclick = () => step(1);
$("unmarked").onclick = goToUnmarked;
$("remove").onclick = remove;
$("help").onclick = () => $("keys").showModal();
start();
