// Charts over time, drawn with uPlot, and the chart of speed against accuracy.

const MOST = 900; // points per series

export class Charts {
  constructor(place) {
    this.place = place;
    this.charts = new Map();
    this.missing = ""; // why the charts cannot be drawn
  }

  clear() {
    this.remove();
    this.charts.clear();
  }

  // Remove the pictures of all charts, but not their data.
  remove() {
    for (const chart of this.charts.values()) {
      chart.plot?.destroy();
      chart.plot = null;
    }
    this.place.replaceChildren();
  }

  // Add a value at a given time. `number` is the index of the contender, and `colors` has a color for
  // each contender.
  add(title, time, number, colors, value) {
    if (!this.charts.has(title)) this.charts.set(title, this.make(title, colors));
    const chart = this.charts.get(title);
    const [times, ...series] = chart.data;
    let at = times.length - 1;
    while (at >= 0 && times[at] > time + 1e-9) at--;
    if (at < 0 || times[at] < time - 1e-9) {
      at++;
      times.splice(at, 0, time);
      for (const values of series) values.splice(at, 0, null);
    }
    series[number][at] = chart.log ? Math.max(value, 1e-16) : value;
    if (times.length > MOST) for (const values of chart.data) values.shift();
    chart.stale = true;
  }

  make(title, colors) {
    const log = title.startsWith("error");
    const chart = {plot: null, data: [[], ...colors.map(() => [])], log};
    this.attempt(() => (chart.plot = this.plot(title, colors, log)));
    return chart;
  }

  plot(title, colors, log) {
    const ink = getComputedStyle(document.documentElement).getPropertyValue("--ink");
    const axis = {stroke: ink, grid: {stroke: "#8884", width: 1}, ticks: {show: false}, size: 30, font: "12px system-ui"};
    return new uPlot(
      {
        width: this.place.clientWidth || 320,
        height: 130,
        title,
        cursor: {show: false},
        legend: {show: false},
        scales: {x: {time: false}, y: log ? {distr: 3} : {}},
        axes: [axis, {...axis, size: 56, values: (_, ticks) => ticks.map(short), ...(log && {splits: decades, filter: (_, ticks) => ticks})}],
        series: [{}, ...colors.map((stroke) => ({stroke, width: 1.5, spanGaps: true, points: {show: false}}))],
      },
      [[], ...colors.map(() => [])],
      this.place,
    );
  }

  draw() {
    for (const chart of this.charts.values()) {
      if (chart.stale) this.attempt(() => chart.plot.setData(chart.data));
      chart.stale = false;
    }
  }

  fit() {
    for (const {plot} of this.charts.values()) this.attempt(() => plot.setSize({width: this.place.clientWidth || 320, height: 130}));
  }

  // Draw a part of the charts. A scene runs without them, so if this fails, the page only says why.
  attempt(act) {
    try {
      if (!this.missing) act();
    } catch (error) {
      this.missing = whyMissing(error);
      this.remove();
    }
    if (!this.missing || this.place.hasChildNodes()) return;
    const note = document.createElement("p");
    Object.assign(note, {className: "facts", textContent: this.missing});
    this.place.append(note);
  }

  // Return all charted values as a CSV table.
  csv(names) {
    const columns = [...this.charts].flatMap(([title, {data}]) =>
      data.slice(1).map((values, i) => ({title: `${title} (${names[i]})`, times: data[0], values})),
    );
    const times = [...new Set(columns.flatMap((column) => column.times))].sort((a, b) => a - b);
    const quoted = (text) => `"${text.replaceAll('"', '""')}"`;
    const lines = [["time, s", ...columns.map((column) => column.title)].map(quoted).join(",")];
    for (const time of times) {
      lines.push([time, ...columns.map(({times: own, values}) => values[own.indexOf(time)] ?? "")].join(","));
    }
    return `${lines.join("\n")}\n`;
  }
}

// Return at most five powers of ten between two values.
function decades(_, __, low, high) {
  const [first, last] = [Math.ceil(Math.log10(low)), Math.floor(Math.log10(high))];
  const stride = Math.max(1, Math.ceil((last - first) / 4));
  const found = [];
  for (let power = first; power <= last; power += stride) found.push(10 ** power);
  return found;
}

function short(value) {
  if (value === null) return "";
  if (value && (Math.abs(value) >= 1e5 || Math.abs(value) < 1e-3)) return value.toExponential(0).replace("e+", "e");
  return String(Number(value.toPrecision(4)));
}

function whyMissing(error) {
  const language = JSON.stringify(navigator.language ?? null);
  const why = isLanguage(navigator.language)
    ? `because ${globalThis.uPlot ? "this browser cannot draw them" : "the library that draws them did not load"} (${error.message})`
    : `because the library that draws them cannot use this browser's language setting, which is ${language}`;
  return `The charts are missing, ${why}. Everything else works without them.`;
}

function isLanguage(language) {
  try {
    return Boolean(new Intl.NumberFormat(language));
  } catch {
    return false;
  }
}

// Plot each contender's largest error (upward) against its time per frame (to the right).
export function drawTradeoff(canvas, points) {
  const ratio = window.devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth || 300, 180];
  [canvas.width, canvas.height] = [width * ratio, height * ratio];
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  const ink = getComputedStyle(document.documentElement).getPropertyValue("--ink");
  const [left, right, bottom] = [52, 22, 30];
  const x = (cost) => left + ((Math.log10(cost) - 0) / 5) * (width - left - right); // 1 us to 0.1 s
  const y = (error) => 8 + ((2 - Math.log10(error)) / 18) * (height - bottom - 8); // 100 to 1e-16
  context.font = "11px system-ui";
  context.fillStyle = context.strokeStyle = ink;
  context.textAlign = "center";
  for (let power = 0; power <= 5; power++) {
    context.globalAlpha = 0.2;
    context.strokeRect(x(10 ** power), 8, 0, height - bottom - 8);
    context.globalAlpha = 1;
    context.fillText(["1 µs", "10 µs", "0.1 ms", "1 ms", "10 ms", "0.1 s"][power], x(10 ** power), height - 14);
  }
  context.textAlign = "right";
  for (let power = -16; power <= 2; power += 4) {
    context.globalAlpha = 0.2;
    context.strokeRect(left, y(10 ** power), width - left - right, 0);
    context.globalAlpha = 1;
    context.fillText(`1e${power}`, left - 6, y(10 ** power) + 4);
  }
  for (const {cost, error, color, number} of points) {
    const at = [x(Math.min(1e5, Math.max(1, cost))), y(Math.min(100, Math.max(1e-16, error)))];
    context.fillStyle = color;
    context.beginPath();
    context.arc(...at, 6, 0, 2 * Math.PI);
    context.fill();
    context.textAlign = "center";
    context.fillText(number, at[0], at[1] - 10);
  }
}
