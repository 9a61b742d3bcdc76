// Run a line of Python on the student's engine. If it does not end, its worker is ended.

const MORE = 1; // s of grace after the limit, for a loop that Python cannot interrupt

// Return a promise of what the line shows: value, printed, error and where, which are all texts.
export async function tryLine(asked, next) {
  const interpreter = await next();
  const {hung, left, limits} = interpreter.words;
  const end = await new Promise((resolve) => {
    const timer = setTimeout(() => resolve({kind: "hung", why: hung.other}), 1000 * (limits.other + MORE));
    interpreter.hear = (message) => {
      clearTimeout(timer);
      resolve(message);
    };
    interpreter.send({kind: "try", ...asked});
  });
  interpreter.hear = () => undefined;
  if (end.kind === "tried") return end;
  if (end.kind !== "failed") interpreter.end("A line did not end.");
  return {value: "", printed: "", error: end.why ?? left, where: ""};
}
