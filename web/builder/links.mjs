// Which page a Markdown file becomes, and where its links lead.

import path from "node:path";

import {escape} from "./markdown.mjs";

// Return the file of the page that a Markdown file becomes; nothing for one that is no page.
export function pageOf(file) {
  const lesson = /^chapters\/(ch\d\d_\w+)\/(README|reference)\.md$/.exec(file);
  if (lesson) return lesson[2] === "README" ? `${lesson[1]}.html` : `${lesson[1]}_reference.html`;
  return {
    "chapters/README.md": "commands.html",
    "glossary.md": "glossary.html",
    "docs/claims.md": "claims.html",
    "docs/errata.md": "errata.html",
    "docs/learning_path.md": "learning_path.html",
    "README.md": "index.html",
  }[file];
}

// Return a function that turns a link of a Markdown file into one of the site. A file that is not a page
// is linked in the repository if its address is known. The result "" means that there is no link.
export function linker(source, repository) {
  return (href) => {
    if (/^(https?:|#)/.test(href)) return href;
    const [target, hash] = href.split("#");
    const file = path.posix.join(path.posix.dirname(source), target).replace(/\/$/, "");
    const page = pageOf(file) ?? pageOf(`${file}/README.md`);
    if (page) return page + (hash ? `#${hash}` : "");
    return repository ? `${repository}/blob/HEAD/${file}` : "";
  };
}

const BROAD = 900; // pixels; a picture that is wider links to itself in full size

// Return a function that turns a picture of a Markdown file into one of the site.
export function pictures(source, known) {
  return (src, alt) => {
    const file = path.posix.join(path.posix.dirname(source), src);
    const {name, width, height} = known[file];
    const image = `<img src="figures/${name}" width="${width}" height="${height}" loading="lazy" alt="${escape(alt.replaceAll("\n", " "))}">`;
    return width < BROAD ? image : `<a href="figures/${name}">${image}</a>`;
  };
}
