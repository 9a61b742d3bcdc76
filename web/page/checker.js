// Check in one worker after the other. A check that does not end costs its worker; what the worker has
// told goes to the next one, which continues. What the check is worth is for Python's runner to say.

const MORE = 1; // s beyond the limit of a check, for a loop that Python cannot interrupt
const SILENCE = 10; // s beyond it in which nothing is told between two checks
const CRASHED = -11; // as a process ends that has overrun its stack
const nothing = () => undefined;

// Return the report on what is asked. `next` promises the interpreter to go on with. `onProgress` hears
// how many checks are done, of how many. `onTrouble` hears of a failure that is known while the rest is
// not: of the first check that did not end, or of what is found before earlier chapters are checked.
export async function runChecks(asked, next, {onProgress = nothing, onTrouble = nothing}) {
  const past = [];
  const first = (failure) => {
    onTrouble(failure);
    hear.onTrouble = nothing;
  };
  const hear = {onProgress, onTrouble: first};
  for (;;) {
    const interpreter = await next();
    const end = await attempt(interpreter, asked, past, hear);
    if (end.kind === "report") return end.report;
    if (end.kind === "failed" || end.kind === "lost") throw new Error(end.why);
    interpreter.end("It was checking something that did not end.");
    if (end.kind !== "crashed") continue;
    // A browser's stack is small. What overruns it is run again with fewer nested calls, of which
    // Python says that they are too many.
    if (!end.during) throw new Error(`Python stopped: ${end.why}`);
    asked = {...asked, shallow: true};
  }
}

// Have one interpreter check, as far as it comes, and add what it tells to the past.
function attempt(interpreter, asked, past, hear) {
  return new Promise((resolve) => {
    let process = null;
    let timer = null;
    const close = (how) => {
      clearTimeout(timer);
      if (!process) return;
      const {run, lines, left, begun} = process;
      const seconds = (performance.now() - begun) / 1000;
      past.push({run, lines, left, seconds, stack: "", silent: false, code: 0, ...how});
      process = null;
    };
    const finish = (end, how = {}) => {
      const during = process !== null;
      if (end.kind === "crashed") process = null; // it did not happen
      close(how);
      interpreter.hear = () => undefined;
      resolve({...end, during});
    };
    const wait = (more) => {
      clearTimeout(timer);
      timer = setTimeout(() => finish({kind: "silent"}, {silent: true}), 1000 * (process.limit + more));
    };
    const takes = {
      process: ({run, limit, left}) => {
        process = {run, limit, left, lines: [], begun: performance.now()};
        wait(SILENCE);
      },
      event: ({line}) => {
        process.lines.push(line);
        wait(isBegun(line) ? MORE : SILENCE);
      },
      ended: () => close({}),
      progress: ({done, of}) => hear.onProgress(done, of),
      trouble: ({failure}) => failure && hear.onTrouble(failure),
      hung: ({stack, failure}) => {
        finish({kind: "hung"}, {stack});
        takes.trouble({failure});
      },
      left: ({code}) => finish({kind: "left"}, {code}),
      crashed: ({why}) => (asked.shallow && process ? finish({kind: "left"}, {code: CRASHED}) : finish({kind: "crashed", why})),
      report: finish,
      failed: finish,
      lost: finish,
    };
    interpreter.hear = (message) => takes[message.kind]?.(message);
    interpreter.send({kind: "check", ...asked, past});
  });
}

// The student's code is about to run: a check begins, or the import of a module.
function isBegun(line) {
  const [kind] = Object.keys(JSON.parse(line));
  return kind === "Started" || kind === "Importing";
}
