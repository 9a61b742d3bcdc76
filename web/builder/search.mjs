// The index of the search, made when the site is built: the words of every section of every page.

import MiniSearch from "minisearch";

import {OPTIONS} from "../page/words.js";
import {textOf} from "./markdown.mjs";

// Return the sections of a page from its tokens: anchor, heading, and words.
export function sectionsOf(tokens, page, title) {
  const sections = [{page, id: "", heading: title, text: ""}];
  tokens.forEach((token, i) => {
    if (token.type !== "inline") return;
    const before = tokens[i - 1];
    if (before.type !== "heading_open") sections.at(-1).text += ` ${textOf(token)}`;
    else if (before.tag !== "h1") sections.push({page, id: before.attrGet("id"), heading: textOf(token), text: ""});
  });
  return sections;
}

// Return the index and the target of each entry, as data for search.js.
export function indexOf(sections, titles) {
  const pages = [...new Set(sections.map(({page}) => page))];
  const index = new MiniSearch(OPTIONS);
  index.addAll(sections.map(({heading, text}, id) => ({id, heading, text})));
  return {
    index: index.toJSON(),
    pages: pages.map((page) => [page, titles[page]]),
    sections: sections.map(({page, id, heading}) => [pages.indexOf(page), id, heading]),
  };
}
