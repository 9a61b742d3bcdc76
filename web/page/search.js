// Search all pages: a dialog that / opens, with an index that was made when the site was built.

import {packed} from "./course.js";
import {button, count, el} from "./dom.js";
import {OPTIONS} from "./words.js";

const MOST = 20;
let dialog = null;

// The dialog is part of every page, so that it takes the first key; what finds is loaded with it.
export function openSearch() {
  dialog ??= make();
  dialog.showModal();
  dialog.querySelector("input").select();
}

function make() {
  const field = el("input", {type: "search", "aria-label": "Search the course", autocomplete: "off", spellcheck: false});
  const status = el("p", {role: "status"});
  const list = el("ol");
  const made = el(
    "dialog",
    {className: "search", "aria-label": "Search"},
    el("form", {method: "dialog", onsubmit: (event) => (event.preventDefault(), list.querySelector("a")?.click())}, field, button("Close", () => made.close())),
    status,
    list,
  );
  field.oninput = async () => {
    const query = field.value.trim();
    let found = [];
    try {
      if (query.length > 1) found = await search(query);
    } catch (error) {
      status.textContent = `The search does not work now: ${error.message}`;
      return;
    }
    if (field.value.trim() !== query) return; // the reader has typed more meanwhile
    status.textContent = query.length > 1 ? (found.length ? count(found.length, "result") : "Nothing found.") : "";
    list.replaceChildren(...found.map(({page, title, id, heading}) =>
      el("li", {}, el("a", {href: `${page}${id ? `#${id}` : ""}`, onclick: () => made.close()}, heading, el("small", {}, title))),
    ));
  };
  // Arrow keys move between the field and the results.
  made.onkeydown = (event) => {
    const way = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (!way) return;
    const stops = [field, ...list.querySelectorAll("a")];
    stops[stops.indexOf(document.activeElement) + way]?.focus();
    event.preventDefault();
  };
  document.body.append(made);
  return made;
}

async function search(query) {
  const {index, pages, sections} = await data();
  const found = index.search(query, {prefix: true, fuzzy: (word) => (word.length > 4 ? 0.2 : 0), boost: {heading: 4}, combineWith: "AND"});
  return found.slice(0, MOST).map(({id}) => {
    const [number, anchor, heading] = sections[id];
    const [page, title] = pages[number];
    return {page, title, id: anchor, heading};
  });
}

let loading = null;

function data() {
  loading ??= load().catch((error) => ((loading = null), Promise.reject(error)));
  return loading;
}

async function load() {
  const [{default: MiniSearch}, {index, ...rest}] = await Promise.all([import("minisearch"), packed("search")]);
  return {...rest, index: MiniSearch.loadJS(index, OPTIONS)};
}
