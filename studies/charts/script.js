// Numbers of a point on hover and on keyboard focus, and a filter by scene and model.
// Without this script the page has all charts and tables.

"use strict";

const NEAR = 24; // px from the pointer, within which a point shows its numbers
const $ = (id) => document.getElementById(id);
const all = (place, what) => [...place.querySelectorAll(what)];

class Chart {
  constructor(panel) {
    this.figure = panel.querySelector("figure");
    this.svg = this.figure.querySelector("svg");
    this.tip = panel.querySelector(".tip");
    const rows = all(panel, "tbody tr");
    // Every label is made of the texts of the point's row in the table.
    const heads = all(panel, "thead th").map((head) => head.textContent);
    for (const point of all(this.svg, "[data-row]")) {
      const [model, choice, error, time, quartiles, work] = [...rows[point.dataset.row].children].map((cell) => cell.textContent);
      const said = `${model}, ${choice}: error ${error} of the scale, ${time} ms (quartiles ${quartiles}), ${heads[5]}: ${work}`;
      point.setAttribute("role", "img");
      point.setAttribute("aria-label", said);
      point.tabIndex = -1;
    }
    this.svg.setAttribute("role", "group");
    this.svg.addEventListener("pointermove", (event) => this.hover(event));
    this.svg.addEventListener("pointerdown", (event) => this.hover(event));
    this.svg.addEventListener("pointerleave", () => this.show(this.focused()));
    this.svg.addEventListener("focusin", (event) => this.enter(event.target));
    this.svg.addEventListener("focusout", () => this.show(null));
    this.svg.addEventListener("keydown", (event) => this.press(event));
    this.restart();
  }

  // The models that are shown and have points, each as a list of its points.
  models() {
    return all(this.svg, ".model:not([hidden])").map((model) => all(model, "[data-row]")).filter((points) => points.length);
  }

  focused() {
    return this.svg.contains(document.activeElement) ? document.activeElement : null;
  }

  // One point of a chart is reached by Tab: the first one, or the one that was last focused.
  restart() {
    for (const point of all(this.svg, "[tabindex='0']")) point.tabIndex = -1;
    const [first] = this.models();
    if (first) first[0].tabIndex = 0;
    this.show(null);
  }

  enter(point) {
    for (const other of all(this.svg, "[tabindex='0']")) other.tabIndex = -1;
    point.tabIndex = 0;
    this.show(point);
  }

  press(event) {
    const models = this.models();
    const row = models.findIndex((points) => points.includes(event.target));
    if (row < 0) return;
    if (event.key === "Escape") {
      this.show(null);
      return;
    }
    const at = models[row].indexOf(event.target);
    const last = models[row].length - 1;
    const places = {
      ArrowLeft: [row, Math.max(at - 1, 0)],
      ArrowRight: [row, Math.min(at + 1, last)],
      Home: [row, 0],
      End: [row, last],
      ArrowUp: [Math.max(row - 1, 0), at],
      ArrowDown: [Math.min(row + 1, models.length - 1), at],
    };
    const place = places[event.key];
    if (!place || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const points = models[place[0]];
    points[Math.min(place[1], points.length - 1)].focus();
  }

  hover(event) {
    let [nearest, least] = [this.focused(), NEAR];
    for (const point of this.models().flat()) {
      const box = point.getBoundingClientRect();
      const apart = Math.hypot(box.x + box.width / 2 - event.clientX, box.y + box.height / 2 - event.clientY);
      if (apart < least) [nearest, least] = [point, apart];
    }
    this.show(nearest);
  }

  show(point) {
    for (const other of all(this.svg, ".current")) other.classList.remove("current");
    this.tip.hidden = !point;
    if (!point) return;
    point.classList.add("current");
    this.tip.textContent = point.getAttribute("aria-label");
    const [box, around] = [point.getBoundingClientRect(), this.figure.getBoundingClientRect()];
    const most = around.width - this.tip.offsetWidth;
    const left = box.x + box.width / 2 - around.x - this.tip.offsetWidth / 2;
    this.tip.style.left = `${Math.max(0, Math.min(left, most))}px`;
    const above = box.y - around.y - this.tip.offsetHeight - 8;
    this.tip.style.top = `${above < 0 ? box.bottom - around.y + 8 : above}px`;
  }
}

const panels = all(document, ".panel");
const charts = panels.map((panel) => new Chart(panel));

function filter() {
  const [scene, model] = [$("scene").value, $("model").value];
  let shown = 0;
  panels.forEach((panel, i) => {
    const has = !model || all(panel, ".model").some((group) => group.dataset.model === model);
    panel.hidden = (scene && panel.dataset.scene !== scene) || !has;
    shown += !panel.hidden;
    for (const part of all(panel, "[data-model]")) part.toggleAttribute("hidden", Boolean(model) && part.dataset.model !== model);
    panel.querySelector(".front").toggleAttribute("hidden", Boolean(model));
    charts[i].restart();
  });
  for (const row of all($("ratios").parentElement, "tr[data-scene]")) row.hidden = scene && row.dataset.scene !== scene;
  $("status").textContent = shown ? `${shown} of ${panels.length} scenes` : "No scene has both.";
}

$("filter").hidden = false;
$("filter").addEventListener("input", filter);
$("filter").addEventListener("submit", (event) => event.preventDefault());
filter();
