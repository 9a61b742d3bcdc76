// Build the pages: node site.mjs IN OUT, where IN has course.json, scenes.json, pictures.json and the
// folders figures/ and stills/. See __main__.py, which makes these.

import path from "node:path";
import {cp, mkdir, readFile, writeFile} from "node:fs/promises";

import {bundle, copyPyodide, readJson, WEB, writePacked} from "./bundle.mjs";
import {glossaryPage, plainPages} from "./documents.mjs";
import {layout} from "./layout.mjs";
import {anchor, callouts, chapterPanel, fence, inlineCode, liveFigure} from "./lesson.mjs";
import {linker, pageOf, pictures} from "./links.mjs";
import {reader, textOf} from "./markdown.mjs";
import {writeServiceWorker} from "./offline.mjs";
import {indexOf, sectionsOf} from "./search.mjs";
import {labPage, startPage} from "./start.mjs";
import {finder, linkTerms, termsOf, tips} from "./terms.mjs";

const ROOT = path.join(WEB, "..");
const [from, out] = process.argv.slice(2);
const settings = await readJson(path.join(from, "settings.json"));
const course = await readJson(path.join(from, "course.json"));
const scenes = await readJson(path.join(from, "stills", "scenes.json"));
const known = await readJson(path.join(from, "pictures.json"));
const text = (file) => readFile(path.join(ROOT, file), "utf8");

const terms = termsOf(await text("glossary.md"));
const findTerm = finder(terms);
const md = reader();
linkTerms(md);
callouts(md);
md.renderer.rules.code_inline = (tokens, i, _, env) => inlineCode(tokens[i].content, env);
const image = md.renderer.rules.image;
md.renderer.rules.image = (tokens, i, options, env) => {
  const picture = image(tokens, i, options, env);
  return tokens[i].meta ? liveFigure(tokens[i].meta.scene, "", env, picture) : picture;
};

const assets = await bundle(out);
const [found, titles] = [[], {}];

// Write a page that a Markdown file becomes.
async function writePage(source, {title, description, chapter, wanted = [], after = "", kind = "page", change = (words) => words}) {
  const file = pageOf(source);
  const env = {
    source,
    chapter,
    scenes,
    findTerm: kind === "lesson" ? findTerm : null,
    wanted,
    used: new Map(),
    fence: kind === "lesson" ? fence : null,
    link: linker(source, settings.repository),
    picture: pictures(source, known),
  };
  const tokens = md.parse(change(await text(source)), env);
  const body = md.renderer.render(tokens, md.options, env) + after + tips(env.used);
  const sections = headings(tokens);
  if (after) sections.push({id: "your-chapter", words: "Your chapter", level: 2});
  titles[file] = title;
  found.push(...sectionsOf(tokens, file, title));
  await write(file, {title: `${title} - Game Physics Companion`, description, body, sections, chapter: chapter?.name, kind});
}

const write = (file, parts) => writeFile(path.join(out, file), layout({file, assets, ...parts}));

function headings(tokens) {
  const opens = tokens.map((token, i) => [token, i]).filter(([token]) => token.type === "heading_open" && token.tag === "h2");
  return opens.map(([, i]) => ({id: tokens[i].attrGet("id"), words: md.utils.escapeHtml(textOf(tokens[i + 1])), level: 2}));
}

await mkdir(out, {recursive: true});
// How a chapter works is different on a page, which has editors and buttons and no terminal.
const HOW = /^## How a chapter works\n[\s\S]*?(?=^## )/m;
const onThisPage = await text("web/builder/how_a_chapter_works.md");
for (const [number, chapter] of course.chapters.entries()) {
  const names = new Set(chapter.exercises.flatMap((exercise) => exercise.terms));
  await writePage(`chapters/${chapter.name}/README.md`, {
    title: `Chapter ${chapter.number}: ${chapter.title}`,
    description: chapter.summary,
    chapter,
    wanted: [...names].map(findTerm).filter(Boolean),
    after: chapterPanel(chapter, course.chapters[number + 1]),
    kind: "lesson",
    change: (words) => words.replace(HOW, onThisPage),
  });
  const page = `${chapter.name}.html`;
  found.push(...chapter.exercises.map(({id, title}) => ({page, id: anchor(id), heading: `${id} ${title}`, text: ""})));
  await writePage(`chapters/${chapter.name}/reference.md`, {
    title: `Chapter ${chapter.number}: reference`,
    description: `Tables for chapter ${chapter.number}.`,
    chapter: null,
  });
  await writePacked(path.join(out, "data", `${chapter.name}.data`), chapter);
}
for (const [source, title, description] of plainPages) await writePage(source, {title, description});
const glossary = glossaryPage(terms, (words) => md.renderInline(words, {link: linker("glossary.md", settings.repository)}));
titles["glossary.html"] = "Glossary";
found.push(...terms.map(({name, id, text: words}) => ({page: "glossary.html", id, heading: name, text: words})));
await write("glossary.html", {title: "Glossary - Game Physics Companion", description: "The terms of the course.", body: glossary});
await write("index.html", startPage(course, settings));
await write("lab.html", labPage());
const outline = course.chapters.map(({name, number, title, builds_on, exercises}) => ({
  name,
  number,
  title,
  builds_on,
  exercises: exercises.map(({id, points, kind}) => ({id, points, kind})),
}));
await writePacked(path.join(out, "data", "course.data"), {chapters: outline, scenes, solutions: settings.solutions});
await writePacked(path.join(out, "data", "search.data"), indexOf(found, titles));
for (const folder of ["figures", "stills"]) {
  await cp(path.join(from, folder), path.join(out, folder), {recursive: true, filter: (file) => !file.endsWith(".json")});
}
const vendor = path.join(ROOT, "lab", "page", "vendor");
await cp(vendor, path.join(out, "vendor"), {recursive: true, filter: (file) => !file.endsWith("SUMS")});
await cp(path.join(WEB, "page", "icon.svg"), path.join(out, "icon.svg"));
await copyPyodide(out);
await writeServiceWorker(out);
