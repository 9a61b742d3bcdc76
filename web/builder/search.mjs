// The index of the search: words of every section of every page, made when the site is built.

import MiniSearch from "minisearch";

import {textOf} from "./markdown.mjs";

const TOO_COMMON = new Set("a an and are as at be but by for from has have if in is it its not of on or that the then this to was what when which with you your".split(" "));

// What the page that searches must know as well: see search.js.
export const OPTIONS = {fields: ["heading", "text"], storeFields: []};

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

// Return the index and where each of its entries leads, as data for search.js.
export function indexOf(sections, titles) {
  const pages = [...new Set(sections.map(({page}) => page))];
  const index = new MiniSearch({
    ...OPTIONS,
    processTerm: (word) => {
      const plain = word.toLowerCase();
      return TOO_COMMON.has(plain) || /^[\d.]+$/.test(plain) ? null : plain;
    },
  });
  index.addAll(sections.map(({heading, text}, id) => ({id, heading, text})));
  return {
    index: index.toJSON(),
    pages: pages.map((page) => [page, titles[page]]),
    sections: sections.map(({page, id, heading}) => [pages.indexOf(page), id, heading]),
  };
}
