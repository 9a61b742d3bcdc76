// Ask before something is overwritten.

import {button, el} from "./dom.js";

// Ask a question and return the answer: true only if the reader presses the confirming button.
export function ask(title, content, yes, no = "Cancel") {
  return new Promise((resolve) => {
    const dialog = el("dialog", {className: "ask", "aria-labelledby": "ask-title"});
    const close = (answer) => () => {
      dialog.close();
      resolve(answer);
    };
    dialog.append(
      el("h2", {id: "ask-title"}, title),
      ...[content].flat(),
      el("div", {className: "row"}, button(yes, close(true), {className: "main"}), button(no, close(false), {autofocus: true})),
    );
    dialog.oncancel = () => resolve(false);
    dialog.onclose = () => dialog.remove();
    document.body.append(dialog);
    dialog.showModal();
  });
}
