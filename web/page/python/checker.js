// Run checks in one worker after the other. A worker whose check does not end is ended. Its reports go
// to the next worker, which continues. Python's runner decides what the check is worth.

const MORE = 1; // s of grace after the limit of a check, for a loop that Python cannot interrupt
const SILENCE = 10; // s of grace without a report between two checks
const LONG = 700; // ms; a check that takes longer may have a loop that does not end
const CRASHED = -11; // the exit code of a process that has overrun its stack
const nothing = () => undefined;

// Return the report on a request. `next` returns a promise of the interpreter to continue with.
// `onProgress` is called with the number of finished checks and of all checks. `onTrouble` is called with
// a failure that is known early: a check that did not end, or one found before earlier chapters are checked.
// `onLong` is called when a single check takes long, so that another interpreter will probably be needed.
export async function runChecks(asked, next, {onProgress = nothing, onTrouble = nothing, onLong = nothing}) {
  const past = [];
  const first = (failure) => {
    onTrouble(failure);
    hear.onTrouble = nothing;
  };
  const hear = {onProgress, onTrouble: first, onLong};
  for (;;) {
    const interpreter = await next();
    const end = await attempt(interpreter, asked, past, hear);
    if (end.kind === "report") return end.report;
    if (end.kind === "failed" || end.kind === "lost") throw new Error(end.why);
    interpreter.end("It was checking something that did not end.");
    if (end.kind !== "crashed") continue;
    // A browser's stack is small. Checks that overrun it are run again with a lower limit on nested
    // calls, so that Python reports too deep a recursion.
    if (!end.during) throw new Error(`Python stopped: ${end.why}`);
    asked = {...asked, shallow: true};
  }
}

// Let one interpreter run checks as far as it gets, and add its reports to the past.
function attempt(interpreter, asked, past, hear) {
  return new Promise((resolve) => {
    let process = null;
    let timer = null;
    let long = null;
    const stopClocks = () => {
      clearTimeout(timer);
      clearTimeout(long);
    };
    const close = (how) => {
      stopClocks();
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
      stopClocks();
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
        if (isBegun(line)) long = setTimeout(hear.onLong, LONG);
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

// Whether the student's code is about to run, because a check or the import of a module begins.
function isBegun(line) {
  const [kind] = Object.keys(JSON.parse(line));
  return kind === "Started" || kind === "Importing";
}
