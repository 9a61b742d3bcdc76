// The start page and the page of the lab.

import {escape} from "./markdown.mjs";

export function startPage(course, {solutions}) {
  const chapters = course.chapters.map(
    ({name, number, title, summary}) => `<li data-progress="${name}">
<a href="${name}.html"><span class="number">${number}</span> ${escape(title)}</a>
<p>${escape(summary)}</p>
<p class="progress" hidden></p>
</li>`,
  );
  const reference = solutions
    ? "<p>This site has the reference's finished chapters as well. If you skip a chapter, a later one can take it from there.</p>"
    : "";
  const body = `<div class="hero">
<div>
<h1>Write your own physics engine</h1>
<p class="lead">You build it in pure Python, chapter by chapter, along Ian Millington's book <cite>Game Physics Engine
Development</cite>. Read a lesson, write a function right under it, and see at once whether it works. There is nothing
to install.</p>
<p><a class="button" id="begin" href="ch02_vectors.html">Begin with chapter 2</a> <a class="quiet" href="learning_path.html">I have only ten hours</a></p>
</div>
<img src="stills/bridge.svg" width="640" height="400" alt="A rope bridge of planks, rods and cables, with a heavy ball that rolls over it.">
</div>
<section aria-labelledby="chapters">
<h2 id="chapters">Chapters</h2>
<ol class="chapters">${chapters.join("\n")}</ol>
</section>
<section aria-labelledby="how">
<h2 id="how">How it works</h2>
<ul>
<li><strong>Write and check.</strong> Every exercise has an editor. <em>Check</em> runs the same checks that grade your work,
in this browser. It names the first mistake, its likely cause, and where to read.</li>
<li><strong>Play.</strong> The scenes of the <a href="lab.html">lab</a> and the live figures of the lessons run on the code
that you have written.</li>
<li><strong>Keep.</strong> Your work stays in this browser, also when you close it or are offline. Nothing is sent anywhere.
Download it as a file to hand it in, or to go on at another computer.</li>
</ul>
${reference}</section>
<section aria-labelledby="your-work" class="work" data-work>
<h2 id="your-work">Your work</h2>
<noscript><p>To write and check exercises on this page, switch on JavaScript.</p></noscript>
</section>`;
  return {
    title: "Game Physics Companion",
    description: "Write your own physics engine in pure Python, in your browser.",
    body,
    kind: "start",
  };
}

export function labPage() {
  const body = `<h1 id="title">The lab</h1>
<div class="lab-head">
<label class="pick">Scene <select id="scenes"></select></label>
<p id="question"></p>
<p id="lesson"></p>
</div>
<p class="aside" id="whose"></p>
<div id="lab" class="lab"></div>
<noscript><p>The lab needs JavaScript.</p></noscript>`;
  return {title: "The lab - Game Physics Companion", description: "Scenes that your own engine plays.", body, kind: "wide"};
}
