// The marks: what is in the file, what is not saved yet, and saving, one change after another.

const known = {}; // by question, then by code: {points, comment, changed}, as the server has them
const drafts = new Map(); // by "question/code", what a person has entered and is not saved
let queue = Promise.resolve();

export const savedMark = (question, code) => known[question]?.[code] ?? null;
export const hasDraft = (question, code) => drafts.has(`${question}/${code}`);
export const markOf = (question, code) => (hasDraft(question, code) ? drafts.get(`${question}/${code}`) : savedMark(question, code));
export const unsaved = () => drafts.size;
export const marksOf = (question) => known[question] ?? {};

export function enter(question, code, mark) {
  drafts.set(`${question}/${code}`, mark);
}

export function discard(question, code) {
  drafts.delete(`${question}/${code}`);
}

function take(marks) {
  for (const question of Object.keys(marks)) known[question] = marks[question];
}

async function ask(options) {
  let answer;
  try {
    answer = await fetch("marks.json", options);
  } catch {
    return {why: "The server does not answer. Is make mark still running?"};
  }
  const {marks, why} = await answer.json().catch(() => ({why: `The server answered ${answer.status}.`}));
  if (marks) take(marks);
  return {why, changed: answer.status === 409};
}

export function refresh() {
  return ask();
}

// Save what has been entered for an answer. Returns {} where it is saved, or what is in the way.
export function save(question, code) {
  const place = `${question}/${code}`;
  queue = queue.then(async () => {
    const mark = drafts.get(place);
    const seen = savedMark(question, code);
    if (mark === undefined) return {};
    if (mark?.points === null) return {why: "A comment is saved together with points. Give some."};
    if (same(mark, seen) && !seen?.changed) {
      drafts.delete(place);
      return {};
    }
    const body = JSON.stringify({exercise: question, code, mark, seen});
    const result = await ask({method: "POST", headers: {"Content-Type": "application/json"}, body});
    if (!result.why && drafts.get(place) === mark) drafts.delete(place);
    return result;
  });
  return queue;
}

function same(one, other) {
  return one?.points === other?.points && one?.comment === other?.comment;
}
