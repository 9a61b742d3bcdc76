// Pages that are not lessons: which Markdown file becomes which page, and the glossary.

import {escape} from "./markdown.mjs";

export const plainPages = [
  ["docs/claims.md", "What the book claims, and what we measured", "Rules of thumb of the book as questions."],
  ["docs/errata.md", "Where the printed book is wrong", "Mistakes in the second edition of the book."],
  ["docs/learning_path.md", "Learning path", "Which exercises to do if you have little time."],
  ["chapters/README.md", "Commands and files", "What students read and edit, and the commands."],
];

// The glossary as a list of definitions. `rendered` turns Markdown into HTML.
export function glossaryPage(terms, rendered) {
  const letters = [...new Set(terms.map(({name}) => name[0].toUpperCase()))].sort();
  const links = letters.map((letter) => `<a href="#letter-${letter}">${letter}</a>`).join(" ");
  let last = "";
  const entries = terms.map(({name, others, id, text}) => {
    const letter = name[0].toUpperCase();
    const mark = letter === last ? "" : ` data-letter="${letter}"`;
    const target = mark ? `<span id="letter-${letter}"></span>` : "";
    last = letter;
    const more = others.length ? ` <span class="others">(${escape(others.join(", "))})</span>` : "";
    return `<dt id="${id}"${mark}>${target}${escape(name)}${more}</dt><dd>${rendered(text)}</dd>`;
  });
  return `<h1>Glossary</h1>
<p>The terms used in chapters 2 to 9. <em>Book</em> names the section, equation or exercise of the book where a term
appears, and <em>Code</em> says where to find it in the engine.</p>
<nav class="letters" aria-label="Letters">${links}</nav>
<dl class="glossary">${entries.join("\n")}</dl>`;
}
