// The glossary: its terms, the links to them, and the tooltips of these links.

import {escape, slug, textOf} from "./markdown.mjs";

// Return the terms of the glossary: name, other names, anchor, words, and the first sentences.
export function termsOf(glossary) {
  return [...glossary.matchAll(/^\*\*(.+?)\*\*(?: \((.+?)\))?: ([\s\S]+?)(?=\n\n|$(?![\s\S]))/gm)].map(([, name, others, words]) => {
    const text = words.replaceAll("\n", " ");
    return {name, others: others ? others.split(", ") : [], id: slug(name), text, short: short(text)};
  });
}

// Return the explanation of a term, without its symbol, its unit and where it appears.
function short(text) {
  const meaning = text.replace(/ (Symbol|Unit|Book|Code): .*$/, "");
  const sentences = meaning.split(/(?<=\.) (?=[A-Z])/);
  return (meaning.length > 260 ? sentences.slice(0, 2).join(" ") : meaning).replaceAll("`", "");
}

// Return a function that finds the term for a word of a text, even if the word is a plural.
export function finder(terms) {
  const known = new Map();
  for (const term of terms) for (const name of [term.name, ...term.others]) known.set(name.toLowerCase(), term);
  return (words) => {
    const text = words.toLowerCase().replace(/\s+/g, " ");
    return known.get(text) ?? known.get(text.replace(/s$/, "")) ?? known.get(text.replace(/es$/, ""));
  };
}

// Link the terms that a page emphasizes, and the first mention of each wanted term.
export function linkTerms(md) {
  md.core.ruler.push("terms", (state) => {
    const {env} = state;
    if (!env.findTerm) return;
    let heading = false;
    state.tokens.forEach((token) => {
      if (token.type === "heading_open") heading = true;
      if (token.type === "heading_close") heading = false;
      if (token.type === "inline" && !heading) token.children = linked(token.children, state);
    });
  });
  md.renderer.rules.term_open = (tokens, i) => tokens[i].content;
  md.renderer.rules.term_close = () => "</a>";
}

function linked(tokens, state) {
  const {env} = state;
  const open = (term) => {
    env.used.set(term.id, term);
    const token = new state.Token("term_open", "a", 1);
    token.content = termLink(term);
    return token;
  };
  const close = () => new state.Token("term_close", "a", -1);
  const result = [];
  let inLink = 0;
  for (let i = 0; i < tokens.length; i++) {
    const token = tokens[i];
    if (token.type === "link_open") inLink++;
    if (token.type === "link_close") inLink--;
    const end = token.type === "em_open" ? tokens.findIndex((other, j) => j > i && other.type === "em_close") : -1;
    const term = end > 0 && !inLink && env.findTerm(textOf({children: tokens.slice(i + 1, end)}));
    if (term) {
      result.push(open(term), ...tokens.slice(i, end + 1), close());
      i = end;
    } else if (token.type === "text" && !inLink) result.push(...mentions(token, state, open, close));
    else result.push(token);
  }
  return result;
}

// Split a text at the first mention of a wanted term that the page has not linked yet.
function mentions(token, state, open, close) {
  const {env} = state;
  for (const term of env.wanted) {
    if (env.used.has(term.id)) continue;
    const found = new RegExp(`(?<![\\w-])${term.name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")}s?(?![\\w-])`, "i").exec(token.content);
    if (!found) continue;
    const text = (content) => Object.assign(new state.Token("text", "", 0), {content});
    const before = text(token.content.slice(0, found.index));
    const after = text(token.content.slice(found.index + found[0].length));
    const link = [open(term), text(found[0]), close()];
    return [...mentions(before, state, open, close), ...link, ...mentions(after, state, open, close)];
  }
  return [token];
}

export function termLink({id}) {
  return `<a class="term" href="glossary.html#${id}" aria-describedby="tip-${id}">`;
}

// Return the explanations of all terms that a page links, for the tooltips.
export function tips(used) {
  const each = [...used.values()].map(({id, short}) => `<p id="tip-${id}" role="tooltip" class="tip">${escape(short)}</p>`);
  return each.length ? `<div id="tips" hidden>${each.join("")}</div>` : "";
}
