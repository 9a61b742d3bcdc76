// The browser's database: files that the student has written, earlier versions, and small facts.

const NAME = `game-physics-companion ${new URL(".", document.baseURI).pathname}`; // each site has its own
let opening = null;

// In WebKit, a transaction that is running when you leave its page never ends, and blocks the database for
// all pages that you open later. So a page that is left aborts its transactions, and starts no others.
const running = new Set();
let isLeft = false;
addEventListener("pagehide", () => {
  isLeft = true;
  running.forEach(abort);
});
addEventListener("pageshow", ({persisted}) => persisted && location.reload()); // the browser has kept it

function abort(transaction) {
  try {
    transaction.abort();
  } catch {} // it is about to end
}

function open() {
  opening ??= new Promise((resolve, reject) => {
    const request = indexedDB.open(NAME, 1);
    request.onupgradeneeded = () => {
      request.result.createObjectStore("files", {keyPath: "path"});
      request.result.createObjectStore("copies", {keyPath: "id", autoIncrement: true});
      request.result.createObjectStore("facts");
    };
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
  return opening;
}

// Run a function on object stores in one transaction. The function may return a request.
export async function run(names, mode, act) {
  const database = await open();
  return new Promise((resolve, reject) => {
    if (isLeft) return; // nobody waits for the result
    const transaction = database.transaction(names, mode);
    running.add(transaction);
    let result;
    const end = (act) => () => (running.delete(transaction), act());
    transaction.oncomplete = end(() => resolve(result instanceof IDBRequest ? result.result : result?.value));
    transaction.onerror = transaction.onabort = end(() => reject(transaction.error));
    result = act(...[names].flat().map((name) => transaction.objectStore(name)));
  });
}

export const readAll = (name) => run(name, "readonly", (store) => store.getAll());
export const fact = (key) => run("facts", "readonly", (store) => store.get(key));
export const setFact = (key, value) => run("facts", "readwrite", (store) => store.put(value, key));

// Write a file if its version is still `base`. Return the new version, or what another tab has written.
export function putFile(file, base) {
  return run("files", "readwrite", (store) => {
    const outcome = {};
    const reading = store.get(file.path);
    reading.onsuccess = () => {
      const there = reading.result;
      const version = (there?.version ?? 0) + 1;
      if (there && there.version !== base && there.text !== file.text) return void (outcome.value = {theirs: there});
      store.put({...file, version, time: Date.now()});
      outcome.value = {version};
    };
    return outcome;
  });
}

const MOST_COPIES = 60;

// Keep a copy of a text that is about to be replaced, and delete the oldest copies.
export function keepCopy(path, text, why) {
  return run("copies", "readwrite", (store) => {
    store.add({path, text, why, time: Date.now()});
    const keys = store.getAllKeys();
    keys.onsuccess = () => keys.result.slice(0, -MOST_COPIES).forEach((key) => store.delete(key));
  });
}

export async function eraseAll() {
  await run(["files", "copies", "facts"], "readwrite", (...stores) => {
    for (const store of stores) store.clear();
  });
}
