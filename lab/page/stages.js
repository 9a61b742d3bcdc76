// The pictures of the scene, and pointer events on them.

import {Stage} from "./draw.js";
import {$, page, tint} from "./state.js";

export function showStages() {
  const apart = $("split").checked ? page.contenders : page.contenders.slice(0, 1);
  $("stage").classList.toggle("split", apart.length > 1);
  $("stage").replaceChildren();
  page.stages = apart.map((contender) => {
    const figure = document.createElement("figure");
    const canvas = document.createElement("canvas");
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `${page.spec.title}: ${page.spec.question}`);
    canvas.setAttribute("aria-describedby", "say");
    figure.append(canvas);
    if (apart.length > 1) {
      const caption = document.createElement("figcaption");
      caption.textContent = contender.label;
      figure.append(caption);
    }
    $("stage").append(figure);
    const stage = new Stage(canvas);
    stage.view = page.spec.view;
    stage.fit();
    listen(stage);
    return stage;
  });
}

export function drawAll() {
  page.stages?.forEach((stage, place) => {
    stage.clear();
    page.contenders.forEach((contender, number) => {
      if (!contender.frame || (page.stages.length > 1 && number !== place)) return;
      stage.draw(contender.frame.items, page.hidden, number ? tint(contender) : "");
    });
  });
}

// Whether the reader can drag this item: only circles with a name can be dragged.
export const isGrabbed = (item) => item[0] === "circle" && item[6];

// Return the name of the draggable circle at a point, or "".
function grabbed(stage, x, y) {
  const circles = (page.contenders[0].frame?.items ?? []).filter(isGrabbed);
  return circles.find(([, , cx, cy, radius]) => Math.hypot(cx - x, cy - y) < Math.max(radius, 14 / stage.scale))?.[6] ?? "";
}

function listen(stage) {
  const canvas = stage.canvas;
  let held = "";
  const send = (message) => page.contenders.forEach((contender) => contender.link.send(message));
  canvas.onpointerdown = (event) => {
    const [x, y] = stage.point(event);
    held = grabbed(stage, x, y);
    if (held) canvas.setPointerCapture(event.pointerId);
    else send({kind: "click", x, y});
  };
  canvas.onpointermove = (event) => {
    const [x, y] = stage.point(event);
    if (!held) canvas.style.cursor = grabbed(stage, x, y) ? "grab" : "";
    if (!held || page.contenders[0].link.busy) return;
    send({kind: "drag", name: held, x, y});
  };
  canvas.onpointerup = () => (held = "");
}
