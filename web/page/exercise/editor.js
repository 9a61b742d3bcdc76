// An editor of one file, or of one after another. Several may show the same file: each follows the
// workspace, and keeps an undo history of its own.

import {defaultKeymap, history, historyKeymap, indentWithTab} from "@codemirror/commands";
import {python} from "@codemirror/lang-python";
import {bracketMatching, indentOnInput, indentUnit, syntaxHighlighting} from "@codemirror/language";
import {Annotation, EditorState, StateEffect, StateField, Transaction} from "@codemirror/state";
import {
  crosshairCursor,
  Decoration,
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
  rectangularSelection,
} from "@codemirror/view";
import {classHighlighter} from "@lezer/highlight";

import {functionsOf, namesIn} from "./bodies.js";
import {workspace} from "../files/workspace.js";

const MARGIN = 24; // pixels above what is scrolled to
const fromElsewhere = Annotation.define();
const markWrong = StateEffect.define(); // the line that a check has named; 0 for none
const ownLine = Decoration.line({class: "cm-own"});
const wrongLine = Decoration.line({class: "cm-wrong"});

export class Editor {
  // `place` is the parent element. The functions of `exercise` are highlighted. Ctrl-Enter calls `onCheck`.
  constructor(place, {exercise, onCheck}) {
    this.place = place;
    this.exercise = exercise;
    this.onCheck = onCheck;
    this.path = "";
    this.states = new Map(); // editor states of the files that are not shown now
    workspace.addEventListener("text", ({detail}) => this.follow(detail));
  }

  // Show a file at its last position. A file that students do not edit is read-only.
  async show(path, given = null) {
    if (path === this.path) return;
    const text = given ?? (await workspace.text(path));
    if (this.path) this.states.set(this.path, this.view.state);
    const state = this.states.get(path) ?? this.stateOf(path, text, given !== null);
    this.path = path;
    if (this.view) this.view.setState(state);
    else this.view = new EditorView({state, parent: this.place});
    this.place.dataset.path = path;
  }

  stateOf(path, text, readOnly) {
    const name = path.split("/")[1];
    const label = `${name}${readOnly ? ", which you use as it is" : `, exercise ${this.exercise.id}`}`;
    return EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        highlightActiveLineGutter(),
        highlightActiveLine(),
        drawSelection(),
        EditorView.lineWrapping,
        rectangularSelection(),
        crosshairCursor(),
        history(),
        indentOnInput(),
        indentUnit.of("    "),
        EditorState.tabSize.of(4),
        bracketMatching(),
        syntaxHighlighting(classHighlighter),
        name.endsWith(".py") ? python() : [],
        readOnly ? [] : highlights(namesIn(this.exercise, path)),
        EditorState.readOnly.of(readOnly),
        EditorView.contentAttributes.of({"aria-label": label, spellcheck: "false", tabindex: "0"}),
        keymap.of([
          {key: "Mod-Enter", run: () => (this.onCheck(), true)},
          {key: "Mod-s", run: () => (this.onCheck(), true)},
          ...defaultKeymap,
          ...historyKeymap,
          indentWithTab,
        ]),
        EditorView.updateListener.of((update) => {
          if (!update.docChanged || update.transactions.some((each) => each.annotation(fromElsewhere))) return;
          workspace.edit(path, update.state.doc.toString(), this);
        }),
      ],
    });
  }

  // Another editor, or another tab, has changed a file.
  follow({path, text, from}) {
    if (from === this) return;
    if (path !== this.path) return void this.states.delete(path);
    const change = difference(this.view.state.doc.toString(), text);
    if (!change) return;
    this.view.dispatch({changes: change, annotations: [fromElsewhere.of(true), Transaction.addToHistory.of(false)]});
  }

  // Change the whole text in one step that can be undone.
  change(text) {
    const change = difference(this.view.state.doc.toString(), text);
    if (change) this.view.dispatch({changes: change, userEvent: "input.reset"});
  }

  get text() {
    return this.view.state.doc.toString();
  }

  // Scroll to a function, and put the cursor on the first line of its body.
  goTo(name, {focus = true} = {}) {
    const where = functionsOf(this.text).get(name);
    if (!where) return false;
    this.reveal(where.from, where.to, focus);
    return true;
  }

  goToLine(number) {
    const line = this.view.state.doc.line(Math.min(Math.max(number, 1), this.view.state.doc.lines));
    this.view.dispatch({effects: markWrong.of(line.number)});
    this.reveal(line.from, line.to, true);
  }

  // Scroll within the editor alone: the page stays where it is.
  reveal(from, to, focus) {
    this.view.dispatch({selection: {anchor: focus ? to : from}});
    const scroll = (left) =>
      this.view.requestMeasure({
        read: (view) => view.lineBlockAt(from).top,
        write: (top, view) => {
          view.scrollDOM.scrollTop = top - MARGIN;
          if (left) requestAnimationFrame(() => scroll(left - 1)); // lines that are seen now are measured now
        },
      });
    scroll(2);
    if (focus) this.view.focus();
  }
}

// Highlight the lines of these functions and the line that a check has named.
function highlights(names) {
  const decorate = (state, wrong) => {
    const lines = new Set();
    const found = names.length ? functionsOf(state.doc.toString()) : new Map();
    for (const name of names) {
      if (!found.has(name)) continue;
      const {from, to} = found.get(name);
      for (let n = state.doc.lineAt(from).number; n <= state.doc.lineAt(to).number; n++) lines.add(n);
    }
    const marks = [...lines].sort((a, b) => a - b).map((n) => (n === wrong ? wrongLine : ownLine).range(state.doc.line(n).from));
    if (wrong && !lines.has(wrong)) marks.push(wrongLine.range(state.doc.line(wrong).from));
    return {wrong, set: Decoration.set(marks, true)};
  };
  return StateField.define({
    create: (state) => decorate(state, 0),
    update(value, transaction) {
      const effect = transaction.effects.find((each) => each.is(markWrong));
      if (effect) return decorate(transaction.state, effect.value);
      return transaction.docChanged ? decorate(transaction.state, 0) : value;
    },
    provide: (field) => EditorView.decorations.from(field, (value) => value.set),
  });
}

// Return the single change that turns one text into another. It keeps the common start and end.
function difference(before, after) {
  if (before === after) return null;
  let start = 0;
  while (start < before.length && start < after.length && before[start] === after[start]) start++;
  let [end, last] = [before.length, after.length];
  while (end > start && last > start && before[end - 1] === after[last - 1]) end--, last--;
  return {from: start, to: end, insert: after.slice(start, last)};
}
