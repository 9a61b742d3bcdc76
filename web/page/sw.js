// The service worker. Above this line the build writes VERSION, and the lists FIRST and LATER of all
// files with a hash of each file's content. A file is stored under its hash, so versions never mix, and
// unchanged files are not fetched again.

const FILES = {...FIRST, ...LATER};
const BASE = new URL("./", self.location).href;
const CACHE = `game-physics-companion ${new URL(BASE).pathname}`; // each site of a host has its own
const fetching = new Map();

const keyOf = (name) => `${BASE}${name}?kept=${FILES[name]}`;

// Return a file from the cache, or fetch and keep it.
async function file(name) {
  const cache = await caches.open(CACHE);
  const kept = await cache.match(keyOf(name));
  if (kept) return kept;
  if (!fetching.has(name)) fetching.set(name, fetched(cache, name).finally(() => fetching.delete(name)));
  return (await fetching.get(name)).clone();
}

async function fetched(cache, name) {
  const answer = await fetch(BASE + name, {cache: "no-cache"});
  if (!answer.ok) return answer;
  const content = await answer.arrayBuffer();
  const copy = new Response(content, {headers: {"Content-Type": answer.headers.get("Content-Type") ?? ""}});
  // While a new version is being published, the server may have other files than this list.
  if ((await hashOf(content)) === FILES[name]) await cache.put(keyOf(name), copy.clone());
  return copy;
}

async function hashOf(content) {
  const bytes = new Uint8Array(await crypto.subtle.digest("SHA-256", content));
  return btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").slice(0, 12);
}

async function keepAll(names) {
  for (const name of names) await file(name);
  const cache = await caches.open(CACHE);
  const missing = [];
  for (const name of names) if (!(await cache.match(keyOf(name)))) missing.push(name);
  if (missing.length) throw new Error(`not kept: ${missing.join(", ")}`);
}

async function dropOld() {
  const cache = await caches.open(CACHE);
  const wanted = new Set(Object.keys(FILES).map(keyOf));
  for (const request of await cache.keys()) if (!wanted.has(request.url)) await cache.delete(request);
}

self.addEventListener("install", (event) => event.waitUntil(keepAll(Object.keys(FIRST))));
self.addEventListener("activate", (event) => event.waitUntil(dropOld().then(() => self.clients.claim())));

self.addEventListener("message", (event) => {
  if (event.data.kind === "activate") self.skipWaiting();
  if (event.data.kind !== "later") return;
  event.waitUntil(keepAll(Object.keys(LATER)).then(() => event.source.postMessage({kind: "ready", version: VERSION}), () => {}));
});

self.addEventListener("fetch", (event) => {
  const url = new URL(event.request.url);
  if (event.request.method !== "GET" || !url.href.startsWith(BASE)) return;
  const name = url.pathname.slice(new URL(BASE).pathname.length) || "index.html";
  if (Object.hasOwn(FILES, name)) event.respondWith(file(name));
});
