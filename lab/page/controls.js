// Controls for a scene's parameters: a slider with a number field, or a drop-down list. The show
// function of a control displays a value that the scene itself has changed.

export function makeControl(parameter, value, onChange) {
  const label = document.createElement("label");
  label.className = "parameter";
  const name = document.createElement("span");
  name.textContent = parameter.label;
  label.append(name);
  if (parameter.kind === "choice") {
    const select = document.createElement("select");
    for (const option of parameter.options) {
      const unit = parameter.unit && typeof option === "number" ? ` ${parameter.unit}` : "";
      select.add(new Option(`${option}${unit}`, option));
    }
    select.value = value;
    select.name = parameter.name;
    select.onchange = () => onChange(select.value);
    label.show = (wanted) => (select.value = wanted);
    label.append(select);
    return label;
  }
  const range = document.createElement("input");
  range.type = "range";
  const number = document.createElement("input");
  Object.assign(number, {type: "number", step: "any", min: parameter.low, max: parameter.high, name: parameter.name});
  number.setAttribute("aria-label", `${parameter.label}, ${parameter.unit}`);
  if (parameter.log) {
    Object.assign(range, {min: Math.log(parameter.low), max: Math.log(parameter.high), step: "any"});
  } else {
    Object.assign(range, {min: parameter.low, max: parameter.high, step: parameter.step || "any"});
  }
  const show = (wanted) => {
    range.value = parameter.log ? Math.log(wanted) : wanted;
    number.value = Number(Number(wanted).toPrecision(6));
    range.setAttribute("aria-valuetext", `${number.value} ${parameter.unit}`);
  };
  show(value);
  range.oninput = () => {
    const wanted = parameter.log ? Number(Math.exp(range.value).toPrecision(4)) : Number(range.value);
    const clamped = Math.min(parameter.high, Math.max(parameter.low, wanted));
    show(clamped);
    onChange(clamped);
  };
  // The arrow keys move a slider without steps by a hundredth of its length.
  range.onkeydown = (event) => {
    const way = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key];
    if (!way || range.step !== "any") return;
    event.preventDefault();
    range.value = Number(range.value) + (way * (range.max - range.min)) / 100;
    range.oninput();
  };
  number.onchange = () => {
    const wanted = Math.min(parameter.high, Math.max(parameter.low, Number(number.value)));
    show(wanted);
    onChange(wanted);
  };
  const unit = document.createElement("span");
  unit.className = "unit";
  unit.textContent = parameter.unit;
  label.append(range, number, unit);
  label.show = show;
  return label;
}
