// Markdown to HTML, as the pages of the course need it: formulas, links between pages, pictures.

import {classHighlighter, highlightTree} from "@lezer/highlight";
import {parser as python} from "@lezer/python";
import MarkdownIt from "markdown-it";
import temml from "temml";

export const escape = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

// Return a Markdown reader. What it needs to know of a page is in the env of each call:
// {path, links(href), picture(src), ...}; other modules add rules of their own.
export function reader() {
  const md = new MarkdownIt({html: true, linkify: false});
  md.inline.ruler.before("escape", "formula", inlineFormula);
  md.block.ruler.before("paragraph", "formula", blockFormula, {alt: ["paragraph", "blockquote", "list"]});
  md.renderer.rules.formula = (tokens, i) => formula(tokens[i].content, tokens[i].block);
  md.core.ruler.push("anchors", anchors);
  md.renderer.rules.heading_open = (tokens, i, options, env, self) => {
    env.level = Number(tokens[i].tag[1]);
    return self.renderToken(tokens, i, options);
  };
  md.renderer.rules.table_open = () => '<div class="scroll" data-scrolls="Table"><table>';
  md.renderer.rules.table_close = () => "</table></div>";
  md.renderer.rules.fence = (tokens, i, _, env) => {
    const {info, content} = tokens[i];
    return env.fence?.(info.trim(), content, env) ?? code(info.trim(), content);
  };
  md.renderer.rules.link_open = (tokens, i, options, env, self) => {
    const href = env.link(tokens[i].attrGet("href"));
    env.dead = !href;
    if (!href) return "";
    tokens[i].attrSet("href", href);
    return self.renderToken(tokens, i, options);
  };
  md.renderer.rules.link_close = (_, __, ___, env) => (env.dead ? "" : "</a>");
  md.renderer.rules.image = (tokens, i, _, env) => env.picture(tokens[i].attrGet("src"), tokens[i].content);
  md.core.ruler.push("figures", figures);
  return md;
}

// Return the anchor of a heading, in GitHub's form.
export function slug(text) {
  return text.toLowerCase().replace(/[^\p{L}\p{N} _-]/gu, "").replaceAll(" ", "-");
}

// Headings get an anchor. If two headings have the same words, the second anchor gets a number.
function anchors(state) {
  const seen = new Map();
  state.tokens.forEach((token, i) => {
    if (token.type !== "heading_open") return;
    const id = slug(textOf(state.tokens[i + 1]));
    const times = seen.get(id) ?? 0;
    seen.set(id, times + 1);
    token.attrSet("id", times ? `${id}-${times}` : id);
  });
}

export function textOf(inline) {
  return (inline.children ?? []).map((token) => (token.type === "softbreak" ? " " : token.content)).join("");
}

export function formula(tex, display) {
  const math = temml.renderToString(tex, {displayMode: display, throwOnError: true});
  return display ? `<div class="formula" data-scrolls="Formula">${math}</div>` : math;
}

// A code listing. Python code is colored.
export function code(language, content) {
  const html = ["python", "pycon"].includes(language) ? colored(content) : escape(content);
  return `<pre data-scrolls="Listing"><code>${html}</code></pre>\n`;
}

function colored(content) {
  let [html, at] = ["", 0];
  highlightTree(python.parse(content), classHighlighter, (from, to, classes) => {
    html += `${escape(content.slice(at, from))}<span class="${classes}">${escape(content.slice(from, to))}</span>`;
    at = to;
  });
  return html + escape(content.slice(at));
}

// $x$, without a space just inside the dollars and without a digit after them.
function inlineFormula(state, silent) {
  if (state.src[state.pos] !== "$") return false;
  const found = /^\$(?! )([^$]+?)(?<! )\$(?!\d)/s.exec(state.src.slice(state.pos));
  if (!found) return false;
  if (!silent) state.push("formula", "math", 0).content = found[1].replaceAll("\n", " ");
  state.pos += found[0].length;
  return true;
}

// $$ ... $$ as a paragraph of its own.
function blockFormula(state, start, end, silent) {
  const line = (n) => state.src.slice(state.bMarks[n] + state.tShift[n], state.eMarks[n]);
  if (!line(start).startsWith("$$")) return false;
  if (silent) return true;
  let [text, next] = ["", start];
  do text += `${line(next++)}\n`;
  while (next < end && !/^\$\$[\s\S]+\$\$\s*$/.test(text));
  const token = state.push("formula", "math", 0);
  Object.assign(token, {block: true, content: text.trim().replace(/^\$\$|\$\$$/g, "")});
  state.line = next;
  return true;
}

// A paragraph that contains only a picture, or a link around one, becomes a figure. A picture that
// links to an animation of a scene stores the scene's name.
function figures(state) {
  state.tokens.forEach((token, i) => {
    if (token.type !== "inline" || state.tokens[i - 1]?.type !== "paragraph_open") return;
    const inner = token.children.filter((child) => child.type !== "text" || child.content.trim());
    const linked = inner.length === 3 && inner[0].type === "link_open" && inner[1].type === "image";
    if (!(inner.length === 1 && inner[0].type === "image") && !linked) return;
    const animation = linked && /([\w-]+)\.gif$/.exec(inner[0].attrGet("href"));
    const image = inner[linked ? 1 : 0];
    if (animation) Object.assign(image, {meta: {scene: animation[1]}});
    if (animation) token.children = [image];
    state.tokens[i - 1].tag = state.tokens[i + 1].tag = animation ? "div" : "figure";
    state.tokens[i - 1].attrSet("class", "picture");
  });
}
