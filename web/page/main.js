// Set up a page once its text is loaded. Each part is loaded only on the pages that need it.

import {startOffline} from "./offline.js";
import {openSearch} from "./search.js";
import {startTips} from "./tips.js";

const search = document.getElementById("search-open");
search.hidden = false;
search.onclick = openSearch;
document.addEventListener("keydown", (event) => {
  if (event.key !== "/" || event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.target.closest("input, textarea, select, [contenteditable], dialog")) return;
  event.preventDefault();
  openSearch();
});

// On a narrow screen the list of sections is folded.
const contents = document.querySelector(".contents details");
if (contents && matchMedia("(max-width: 1099px)").matches) contents.open = false;

// Content that is too wide for the page can be scrolled with the keyboard.
const wide = new ResizeObserver((entries) => {
  for (const {target} of entries) {
    const scrolls = target.scrollWidth > target.clientWidth;
    const needed = {tabindex: "0", role: "group", "aria-label": target.dataset.scrolls};
    for (const [name, value] of Object.entries(needed)) {
      if (scrolls) target.setAttribute(name, value);
      else target.removeAttribute(name);
    }
  }
});
document.querySelectorAll("[data-scrolls]").forEach((element) => wide.observe(element));

startTips();

const {chapter} = document.body.dataset;
if (chapter) {
  const [{startTurns}, {startWhole}, {startLive}] = await Promise.all([import("./exercise/turn.js"), import("./exercise/whole.js"), import("./scenes/live.js")]);
  startTurns(chapter);
  document.querySelectorAll("[data-whole]").forEach(startWhole);
  startLive();
}
if (document.getElementById("lab")) (await import("./scenes/labpage.js")).startLabPage();
const work = document.querySelector("[data-work]");
if (work) {
  const {startProgress, startWork} = await import("./files/work.js");
  startProgress();
  startWork(work);
}

startOffline();
