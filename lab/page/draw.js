// Draw the items recorded by a scene's pen on a canvas. The style sheet defines the colors.

const style = getComputedStyle(document.documentElement);
const color = (name) => style.getPropertyValue(`--${name}`) || name;

export class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.view = [-1, 1, -1, 1];
    new ResizeObserver(() => this.fit()).observe(canvas);
  }

  // Fit the view into the canvas at the screen's resolution.
  fit() {
    const {width, height} = this.canvas.getBoundingClientRect();
    if (!width) return;
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    [this.width, this.height] = [width, height];
    const [left, right, bottom, top] = this.view;
    this.scale = Math.min(width / (right - left), height / (top - bottom));
    this.dx = width / 2 - (this.scale * (left + right)) / 2;
    this.dy = height / 2 + (this.scale * (bottom + top)) / 2;
    this.redraw?.();
  }

  x(x) { return this.dx + this.scale * x; }
  y(y) { return this.dy - this.scale * y; }

  // Return the point of the scene under the pointer.
  point(event) {
    const box = this.canvas.getBoundingClientRect();
    return [(event.clientX - box.left - this.dx) / this.scale, (this.dy - event.clientY + box.top) / this.scale];
  }

  clear() {
    if (!this.scale) this.fit();
    this.context.clearRect(0, 0, this.width, this.height);
  }

  // Draw items. If there are several engines, each has a tint, which replaces all colors.
  draw(items, hidden, tint) {
    for (const [kind, name, ...values] of items) {
      const paint = tint || color(name);
      this.context.strokeStyle = this.context.fillStyle = paint;
      this.context.lineWidth = 2;
      this.context.setLineDash([]);
      if (kind === "arrow" && hidden.has(values[4])) continue;
      shapes[kind]?.(this, values, !!tint);
    }
  }
}

const shapes = {
  circle(stage, [x, y, radius, fill]) {
    const context = stage.context;
    context.beginPath();
    context.arc(stage.x(x), stage.y(y), Math.max(1, stage.scale * radius), 0, 2 * Math.PI);
    if (fill) context.fill();
    else context.stroke();
  },
  dots(stage, [points, size]) {
    for (let i = 0; i < points.length; i += 2) {
      stage.context.beginPath();
      stage.context.arc(stage.x(points[i]), stage.y(points[i + 1]), size / 2, 0, 2 * Math.PI);
      stage.context.fill();
    }
  },
  line(stage, [points, width, dashed]) {
    stage.context.lineWidth = width;
    if (dashed) stage.context.setLineDash([6, 5]);
    path(stage, points);
    stage.context.stroke();
  },
  segments(stage, [points, width]) {
    stage.context.lineWidth = width;
    stage.context.beginPath();
    for (let i = 0; i < points.length; i += 4) {
      stage.context.moveTo(stage.x(points[i]), stage.y(points[i + 1]));
      stage.context.lineTo(stage.x(points[i + 2]), stage.y(points[i + 3]));
    }
    stage.context.stroke();
  },
  area(stage, [points, solid]) {
    stage.context.globalAlpha = solid ? 1 : 0.3;
    path(stage, points);
    stage.context.fill();
    stage.context.globalAlpha = 1;
  },
  spring(stage, [ax, ay, bx, by]) {
    const [x, y] = [stage.x(ax), stage.y(ay)];
    const [dx, dy] = [stage.x(bx) - x, stage.y(by) - y];
    const length = Math.hypot(dx, dy) || 1;
    const [nx, ny] = [-dy / length, dx / length];
    const turns = 24;
    stage.context.beginPath();
    stage.context.moveTo(x, y);
    for (let i = 1; i < turns; i++) {
      const side = i < 3 || i > turns - 3 ? 0 : i % 2 ? 7 : -7;
      stage.context.lineTo(x + (dx * i) / turns + nx * side, y + (dy * i) / turns + ny * side);
    }
    stage.context.lineTo(x + dx, y + dy);
    stage.context.lineWidth = 1.5;
    stage.context.stroke();
  },
  arrow(stage, [x, y, vx, vy]) {
    const [px, py] = [stage.x(x), stage.y(y)];
    const [dx, dy] = [stage.scale * vx, -stage.scale * vy];
    const length = Math.hypot(dx, dy);
    if (length < 2) return;
    const head = Math.min(9, length / 2);
    const angle = Math.atan2(dy, dx);
    const context = stage.context;
    context.beginPath();
    context.moveTo(px, py);
    context.lineTo(px + dx, py + dy);
    for (const turn of [2.6, -2.6]) {
      context.moveTo(px + dx, py + dy);
      context.lineTo(px + dx + head * Math.cos(angle + turn), py + dy + head * Math.sin(angle + turn));
    }
    context.stroke();
  },
  text(stage, [x, y, words, size], tinted) {
    if (tinted) return;
    stage.context.font = `${size}px system-ui, sans-serif`;
    stage.context.textAlign = "center";
    stage.context.textBaseline = "middle";
    stage.context.fillText(words, stage.x(x), stage.y(y));
  },
  ground(stage, [height]) {
    const y = stage.y(height);
    stage.context.globalAlpha = 0.25;
    stage.context.fillRect(0, y, stage.width, stage.height - y);
    stage.context.globalAlpha = 1;
    stage.context.beginPath();
    stage.context.moveTo(0, y);
    stage.context.lineTo(stage.width, y);
    stage.context.stroke();
  },
};

function path(stage, points) {
  stage.context.beginPath();
  for (let i = 0; i < points.length; i += 2) stage.context.lineTo(stage.x(points[i]), stage.y(points[i + 1]));
}
