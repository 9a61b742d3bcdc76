// The pictures of the scene, and pointer events on them.

import {Stage} from "./draw.js";

export function showStages(lab) {
  const {$, spec} = lab;
  const apart = $("split").checked ? lab.contenders : lab.contenders.slice(0, 1);
  $("stage").classList.toggle("split", apart.length > 1);
  $("stage").replaceChildren();
  lab.stages = apart.map((contender) => {
    const figure = document.createElement("figure");
    const canvas = document.createElement("canvas");
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `${spec.title}: ${spec.question}`);
    canvas.setAttribute("aria-describedby", `${lab.prefix}say`);
    figure.append(canvas);
    if (apart.length > 1) {
      const caption = document.createElement("figcaption");
      caption.textContent = contender.label;
      figure.append(caption);
    }
    $("stage").append(figure);
    const stage = new Stage(canvas);
    stage.view = spec.view;
    stage.fit();
    listen(lab, stage);
    return stage;
  });
}

export function drawAll(lab) {
  lab.stages?.forEach((stage, place) => {
    stage.clear();
    lab.contenders.forEach((contender, number) => {
      if (!contender.frame || (lab.stages.length > 1 && number !== place)) return;
      stage.draw(contender.frame.items, lab.hidden, number ? lab.tint(contender) : "");
    });
  });
}

// Return whether the reader can drag this item, which must be a circle with a name.
export const isGrabbed = (item) => item[0] === "circle" && item[6];

// Return the name of the draggable circle at a point, or "".
function grabbed(lab, stage, x, y) {
  const circles = (lab.contenders[0].frame?.items ?? []).filter(isGrabbed);
  return circles.find(([, , cx, cy, radius]) => Math.hypot(cx - x, cy - y) < Math.max(radius, 14 / stage.scale))?.[6] ?? "";
}

function listen(lab, stage) {
  const canvas = stage.canvas;
  let held = "";
  const send = (message) => lab.contenders.forEach((contender) => contender.link.send(message));
  canvas.onpointerdown = (event) => {
    const [x, y] = stage.point(event);
    held = grabbed(lab, stage, x, y);
    if (held) canvas.setPointerCapture(event.pointerId);
    else send({kind: "click", x, y});
  };
  canvas.onpointermove = (event) => {
    const [x, y] = stage.point(event);
    if (!held) canvas.style.cursor = grabbed(lab, stage, x, y) ? "grab" : "";
    if (!held || lab.contenders[0].link.busy) return;
    send({kind: "drag", name: held, x, y});
  };
  canvas.onpointerup = () => (held = "");
}
