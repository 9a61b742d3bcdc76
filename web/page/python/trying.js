// Run a line of Python on the student's engine. If it does not end, its worker is ended.

// Return a promise of what the line shows: value, printed, error and where, which are all texts.
export async function tryLine(asked, next) {
  const interpreter = await next();
  const end = await interpreter.answer({kind: "try", ...asked}, "other");
  if (end.kind === "tried") return end;
  if (end.kind !== "failed") interpreter.end("A line did not end.");
  return {value: "", printed: "", error: end.why ?? interpreter.words.left, where: ""};
}
