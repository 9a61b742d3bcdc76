// The layout around the text of every page.

import {escape} from "./markdown.mjs";

// Allow no other host and no inline script. Python needs WebAssembly, and MathML needs inline styles.
const POLICY = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self' 'unsafe-inline'",
  "img-src 'self' data: blob:",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

const LINKS = [
  ["lab.html", "Lab"],
  ["glossary.html", "Glossary"],
  ["learning_path.html", "Learning path"],
];

// Return a page as HTML. `sections` are the headings for the list beside the text.
export function layout({file, title, description, body, sections = [], chapter, assets, before = "", kind = "page"}) {
  const nav = LINKS.map(([href, words]) => `<a href="${href}"${href === file ? ' aria-current="page"' : ""}>${words}</a>`);
  const listed = sections.map(({id, words, level}) => `<li class="level-${level}"><a href="#${id}">${words}</a></li>`);
  const contents = listed.length
    ? `<nav class="contents" aria-label="On this page"><details open><summary>On this page</summary><ul>${listed.join("")}</ul></details></nav>`
    : "";
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="${POLICY}">
<meta name="referrer" content="no-referrer">
<meta name="color-scheme" content="light dark">
<meta name="description" content="${escape(description)}">
<title>${escape(title)}</title>
<link rel="icon" href="icon.svg">
<link rel="stylesheet" href="${assets.style}">
<script type="module" src="${assets.script}"></script>
</head>
<body class="${kind}"${chapter ? ` data-chapter="${chapter}"` : ""}>
<a class="skip" href="#content">Skip to the text</a>
<header class="top">
<a class="home" href="index.html">Game Physics Companion</a>
<nav aria-label="Site">${nav.join("")}</nav>
<button type="button" id="search-open" aria-keyshortcuts="/" hidden>Search</button>
</header>
<div class="columns">
${contents}
<main id="content" tabindex="-1">
${before}${body}
</main>
</div>
<footer>
<p id="offline" role="status"></p>
<p>What you write stays in this browser. <a href="index.html#your-work">Your work</a> · <a href="claims.html">Claims of the book</a> · <a href="errata.html">Mistakes in the book</a> · <a href="commands.html">Commands and files</a></p>
</footer>
</body>
</html>
`;
}
