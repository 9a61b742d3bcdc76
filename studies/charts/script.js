// Draws the charts from the tables. Shows the numbers of a point on hover and on keyboard focus.
// Without this script the page has all tables.

"use strict";

const FLOOR = 1e-15; // smaller errors are only rounding
const $ = (id) => document.getElementById(id);
const all = (place, what) => [...place.querySelectorAll(what)];
const texts = (row) => [...row.cells].map((cell) => cell.textContent.trim());

const plain = (value) => (value >= 1e-3 && value < 1e5 ? `${Number(value.toPrecision(9))}` : value.toExponential(0).replace("+", ""));
const LOG = {type: "log", ticks: 4, tickFormat: plain, inset: 8, grid: true, labelArrow: "none", labelAnchor: "center"};
const PLACE = {marginTop: 8, marginBottom: 42};

// A chart whose points (elements of class "point") belong to the data `points`. They have a label, and the
// line that they are on. Arrow keys move the focus from point to point.
class Chart {
  constructor(figure) {
    this.figure = figure;
    figure.hidden = false;
    this.tip = figure.querySelector(".tip");
    figure.addEventListener("input", () => this.show(this.elements.get(this.plot.value) ?? this.focused()));
    figure.addEventListener("focusin", (event) => this.enter(event.target));
    figure.addEventListener("focusout", () => this.show(null));
    figure.addEventListener("keydown", (event) => this.press(event));
  }

  draw(points, options) {
    const near = Plot.pointer({...options.at, r: 8, stroke: "currentColor", strokeWidth: 1.5, maxRadius: 24});
    const marks = [...options.marks, Plot.dot(points, near)];
    this.plot = Plot.plot({...options, marks});
    this.figure.firstElementChild.replaceChildren(this.plot);
    const svg = this.plot.querySelector(".point")?.ownerSVGElement;
    svg?.setAttribute("role", "group");
    svg?.setAttribute("aria-label", options.name);
    for (const group of all(this.plot, "g[aria-label]")) group.removeAttribute("aria-label"); // a g without a role may have none
    this.elements = new Map();
    for (const element of all(this.plot, ".point > *")) {
      const point = points[d3.select(element).datum()];
      for (const [name, value] of Object.entries({role: "img", "aria-label": point.label, tabindex: -1})) element.setAttribute(name, value);
      this.elements.set(point, element);
    }
    this.lines = [...d3.group(points.filter((point) => this.elements.has(point)), (point) => point.line).values()].map((line) => line.map((point) => this.elements.get(point)));
    // One point of a chart is reached by Tab: the first one, or the one that was last focused.
    this.lines[0]?.[0].setAttribute("tabindex", 0);
    this.show(null);
  }

  focused() {
    return this.plot.contains(document.activeElement) ? document.activeElement : null;
  }

  enter(element) {
    for (const other of all(this.plot, "[tabindex='0']")) other.setAttribute("tabindex", -1);
    element.setAttribute("tabindex", 0);
    this.show(element);
  }

  press(event) {
    const row = this.lines.findIndex((line) => line.includes(event.target));
    if (row < 0 || event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === "Escape") this.show(null);
    const at = this.lines[row].indexOf(event.target);
    const places = {ArrowLeft: [row, at - 1], ArrowRight: [row, at + 1], Home: [row, 0], End: [row, Infinity], ArrowUp: [row - 1, at], ArrowDown: [row + 1, at]};
    if (!(event.key in places)) return;
    event.preventDefault();
    const within = (i, list) => list[Math.max(0, Math.min(i, list.length - 1))];
    within(places[event.key][1], within(places[event.key][0], this.lines)).focus();
  }

  show(element) {
    this.tip.hidden = !element;
    if (!element) return;
    this.tip.textContent = element.getAttribute("aria-label");
    const [box, around] = [element.getBoundingClientRect(), this.figure.getBoundingClientRect()];
    const left = box.x + box.width / 2 - around.x - this.tip.offsetWidth / 2;
    this.tip.style.left = `${Math.max(0, Math.min(left, around.width - this.tip.offsetWidth))}px`;
    const above = box.y - around.y - this.tip.offsetHeight - 8;
    this.tip.style.top = `${above < 0 ? box.bottom - around.y + 8 : above}px`;
  }
}

// A scene's runs, one for each row of its table. A tbody is a model.
function runsOf(panel) {
  const counted = texts(panel.querySelector(".runs tr")).at(-1);
  return all(panel, "[data-steps]").map((row) => {
    const [choice, shown, time, low, high, work] = texts(row);
    const model = row.parentElement.dataset;
    const label = `${model.model}, ${choice}: error ${shown} of the scale, ${time} ms (quartiles ${low} to ${high}), ${counted}: ${work}`;
    const isUseful = shown !== "useless";
    return {...model, ...row.dataset, line: model.model, label, isUseful, isBest: row.className === "best", time, low, high, work: work.replaceAll(",", ""), counted};
  });
}

function drawScene(chart, panel, runs) {
  const [model, across] = [$("model").value, $("across").value];
  const own = runs.filter((run) => !model || run.model === model);
  const points = own.filter((run) => run.isUseful && run[across] > 0);
  const models = [...d3.group(own, (run) => run.model).values()];
  const names = models.map(([run]) => run.model);
  const told = (name) => {
    const found = models[names.indexOf(name)];
    return name + (found[0].by === "the book" ? " (the book's step)" : "") + (found.some((run) => run.isUseful) ? "" : ": useless");
  };
  const at = {x: (run) => Number(run[across]), y: (run) => Math.max(run.error, FLOOR)};
  const line = {...at, z: "line", stroke: "line", strokeWidth: 1.4};
  const best = d3.sort(points.filter((run) => run.isBest), at.x);
  chart.draw(points, {
    name: `${panel.dataset.scene}: error over ${across}, whose numbers are in the table below`,
    at,
    width: 380,
    height: 290,
    ...PLACE,
    marginLeft: 62,
    x: {...LOG, label: across === "time" ? "processor time, ms" : own[0].counted},
    y: {...LOG, ticks: 6, label: "error / scale", labelOffset: 56},
    color: {domain: names, range: models.map(([run]) => `var(--${run.color})`)},
    symbol: {domain: names, range: models.map(([run]) => run.symbol), legend: true, tickFormat: told},
    marks: [
      Plot.line(model ? [] : best, {...at, stroke: "var(--front)", strokeWidth: 11, strokeLinecap: "round"}),
      Plot.ruleY(across === "time" ? points : [], {...at, x: null, x1: (run) => Number(run.low), x2: (run) => Number(run.high), stroke: "line"}),
      Plot.line(points, {...line, filter: (run) => run.by !== "pymunk"}),
      Plot.line(points, {...line, filter: (run) => run.by === "pymunk", strokeDasharray: "5 3"}),
      Plot.dot(points, {...at, symbol: "line", fill: "line", stroke: "line", r: 3.5, className: "point"}),
    ],
  });
}

// The ratios of a table, with the color and the symbol of their tolerance.
function drawRatios(chart, section) {
  const heads = texts(section.querySelector("tr"));
  const rows = all(section, "[data-scene]:not([hidden])");
  const points = rows.flatMap((row, i) => texts(row).slice(1).map((text, j) => {
    const label = `${row.dataset.scene}, error ${heads[j + 1]}: ${text}`;
    return {line: row.dataset.scene, label, kind: text[0], y: i + 0.25 * (j - 1), error: heads[j + 1], ratio: Number(row.cells[j + 1].dataset.at)};
  })).filter((point) => /[~<>\d]/.test(point.kind));
  const at = {x: "ratio", y: "y"};
  const width = Math.min(chart.figure.clientWidth, 640) || 640;
  chart.draw(points, {
    name: `${section.getAttribute("aria-label")}: the ratios of the table below`,
    at,
    width,
    height: 60 + 24 * rows.length,
    ...PLACE,
    marginLeft: Math.min(220, 0.42 * width),
    x: {...LOG, label: "time of pymunk / our time"},
    y: {domain: [-0.5, rows.length - 0.5], reverse: true, label: null},
    color: {domain: heads.slice(1), range: ["var(--orange)", "var(--blue)", "var(--green)"]},
    opacity: {type: "identity"},
    symbol: {domain: heads.slice(1), range: ["circle", "triangle", "square"], legend: true, tickFormat: (error) => `error of ${error}`},
    marks: [
      Plot.axisY(d3.range(rows.length), {tickFormat: (i) => rows[i].dataset.scene, lineWidth: width < 500 ? 13 : 22, tickSize: 0}),
      Plot.ruleX([1]),
      Plot.dot(points, {...at, symbol: "error", fill: "error", fillOpacity: (point) => Number(/\d/.test(point.kind)), stroke: "error", r: 3.5, className: "point"}),
      ...[["<", "←", -10], [">", "→", 10]].map(([kind, arrow, dx]) => Plot.text(points, {...at, dx, text: () => arrow, filter: (point) => point.kind === kind})),
    ],
  });
}

const panels = all(document, ".panel").map((panel) => [panel, new Chart(panel.querySelector("figure")), runsOf(panel)]);
const compared = all(document, ".compared").map((section) => [section, new Chart(section.querySelector("figure"))]);

function filter() {
  const [scene, model] = [$("scene").value, $("model").value];
  let shown = 0;
  for (const [panel, chart, runs] of panels) {
    panel.hidden = (scene && panel.dataset.scene !== scene) || (model && !runs.some((run) => run.model === model));
    for (const body of all(panel, "[data-model]")) body.hidden = model && body.dataset.model !== model;
    shown += !panel.hidden;
    if (!panel.hidden) drawScene(chart, panel, runs);
  }
  for (const [section, chart] of compared) {
    for (const row of all(section, "[data-scene]")) row.hidden = scene && row.dataset.scene !== scene;
    drawRatios(chart, section);
  }
  $("status").textContent = shown ? `${shown} of ${panels.length} scenes` : "No scene has both.";
}

const columns = ["model", "by", "better", "steps", "per", "error", "time", "low", "high", "work", "counted"];
const lines = panels.flatMap(([panel, , runs]) => runs.map((run) => [panel.dataset.scene, ...columns.map((column) => run[column])]));
const csv = `${d3.csvFormatRows([JSON.parse($("csv").dataset.columns), ...lines])}\n`;
$("csv").href = URL.createObjectURL(new Blob([csv], {type: "text/csv"}));
for (const id of ["csv", "filter"]) $(id).hidden = false;
$("filter").addEventListener("input", filter);
$("filter").addEventListener("submit", (event) => event.preventDefault());
filter();
