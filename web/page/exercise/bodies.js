// Find the functions of an exercise in a Python file, and put their stubs back.

import {parser} from "@lezer/python";

// Return every top-level function and method by its name, such as Vector3.copy or mass.setter, with
// where it begins and ends, decorators included, and the class that it is in.
export function functionsOf(text) {
  const found = new Map();
  const visit = (node, scope, start) => {
    if (node.name === "DecoratedStatement") {
      visit(node.lastChild, scope, node.from);
    } else if (node.name === "FunctionDefinition") {
      const own = text.slice(...range(node.getChild("VariableName")));
      const setter = text.slice(start, node.from).includes(`@${own}.setter`) ? ".setter" : "";
      found.set(`${scope}${own}${setter}`, {from: start, to: endOf(node, text), scope});
    } else if (node.name === "ClassDefinition" && !scope) {
      const name = text.slice(...range(node.getChild("VariableName")));
      const body = node.getChild("Body");
      found.set(`class ${name}`, {from: start, to: endOf(node, text), scope});
      for (let child = body?.firstChild; child; child = child.nextSibling) visit(child, `${name}.`, child.from);
    }
  };
  for (let child = parser.parse(text).topNode.firstChild; child; child = child.nextSibling) visit(child, "", child.from);
  return found;
}

const range = (node) => (node ? [node.from, node.to] : [0, 0]);

// A body ends with its last line. Blank lines or comments that follow do not belong to it.
function endOf(node, text) {
  let end = node.to;
  while (end > node.from && /\s/.test(text[end - 1])) end--;
  return end;
}

// Return the functions of an exercise in one file. `edit` has names such as vector.Vector3.copy.
export function namesIn(exercise, path) {
  const module = path.split("/")[1].replace(/\.py$/, "");
  return exercise.edit.filter((name) => name.startsWith(`${module}.`)).map((name) => name.slice(module.length + 1));
}

// Return the text with these functions replaced by their stubs, and the names that could not be replaced.
export function putStubsBack(text, stub, names) {
  const pristine = functionsOf(stub);
  const lost = [];
  for (const name of names) {
    const wanted = pristine.get(name);
    const own = functionsOf(text).get(name);
    const body = stub.slice(wanted.from, wanted.to);
    if (own) text = text.slice(0, own.from) + body + text.slice(own.to);
    else text = insert(text, stub, name, pristine) ?? (lost.push(name), text);
  }
  return {text, lost};
}

// Insert a deleted function after the nearest function that comes before it in the stub.
function insert(text, stub, name, pristine) {
  const there = functionsOf(text);
  const {scope, from, to} = pristine.get(name);
  if (scope && !there.has(`class ${scope.slice(0, -1)}`)) return null;
  const siblings = [...pristine].filter(([other, {scope: of}]) => of === scope && !other.startsWith("class ")).map(([other]) => other);
  const before = siblings.slice(0, siblings.indexOf(name)).findLast((other) => there.has(other));
  const at = before ? there.get(before).to : scope ? there.get(`class ${scope.slice(0, -1)}`).to : text.trimEnd().length;
  const gap = scope ? "\n\n    " : "\n\n\n";
  return text.slice(0, at) + gap + stub.slice(from, to) + (text.slice(at) || "\n");
}
