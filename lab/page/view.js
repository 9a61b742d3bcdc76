// The parts of a lab as HTML. A page of the course may show several labs, so each lab puts its own
// prefix before the ids of its parts.

export function markup(p, compact) {
  return `
<section class="lab-scene" aria-label="Scene">
  <div id="${p}predict" class="panel" hidden></div>
  <div id="${p}stage" class="stage"></div>
  <p id="${p}grab" class="facts" hidden>Drag a circle to move it.</p>
  <p id="${p}trouble" class="panel trouble" role="alert" hidden></p>
  <div class="bar" role="group" aria-label="Time">
    <button type="button" id="${p}play" aria-keyshortcuts="Space">Play</button>
    <button type="button" id="${p}step" aria-keyshortcuts=".">Step</button>
    <button type="button" id="${p}restart" aria-keyshortcuts="R">Restart</button>
    <label>Speed
      <select id="${p}speed">
        <option value="0.1">1/10</option>
        <option value="0.25">1/4</option>
        <option value="1" selected>1</option>
        <option value="2">2</option>
      </select>
    </label>
    <span id="${p}clock" class="number">0.00 s</span>
    <button type="button" id="${p}help" aria-keyshortcuts="?">Keys</button>
  </div>
  <p id="${p}pace" class="facts" role="status" hidden></p>
  <div id="${p}actions" class="bar" role="group" aria-label="Actions in the scene"></div>
  <p id="${p}say" class="say" aria-live="polite"></p>
</section>
<section id="${p}right" class="lab-controls" aria-label="Parameters and charts">
  <form id="${p}parameters" class="panel" aria-label="Parameters"></form>
  <p id="${p}facts" class="facts"></p>
  ${compact ? `<details><summary>Compare, and see charts</summary>${rest(p)}</details>` : rest(p)}
</section>
<dialog id="${p}keys" aria-labelledby="${p}keys-title">
  <h2 id="${p}keys-title">Keys</h2>
  <dl></dl>
  <form method="dialog"><button>Close</button></form>
</dialog>`;
}

function rest(p) {
  return `
<fieldset class="panel" id="${p}arrows"><legend>Arrows</legend></fieldset>
<div class="panel">
  <h2>Compare</h2>
  <table id="${p}contenders" class="contenders">
    <thead><tr><th scope="col">engine</th><th scope="col">largest error</th><th scope="col">time per frame</th><td></td></tr></thead>
    <tbody></tbody>
  </table>
  <div class="bar">
    <label>Add <select id="${p}add"></select></label>
    <label><input type="checkbox" id="${p}split"> side by side</label>
  </div>
  <p id="${p}absent" class="facts" hidden></p>
</div>
<div id="${p}charts"></div>
<figure id="${p}tradeoff" class="tradeoff" hidden>
  <canvas width="300" height="180" role="img" aria-label="Largest error against time per frame"></canvas>
  <figcaption>Speed against accuracy: points farther left are faster, and lower points are more accurate.</figcaption>
</figure>
<div class="bar">
  <button type="button" id="${p}csv">Save the charts (CSV)</button>
  <button type="button" id="${p}gif" hidden>Save an animation (GIF)</button>
  <button type="button" id="${p}link">Copy a link to this page</button>
</div>`;
}
