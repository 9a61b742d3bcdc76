// Earlier versions: texts that have been replaced.

import {button, count, download, el} from "../dom.js";
import {readAll} from "./store.js";
import {workspace} from "./workspace.js";

export async function showCopies(place, say) {
  const copies = (await readAll("copies")).reverse();
  if (!copies.length) return place.replaceChildren();
  const isOpen = place.querySelector("details")?.open ?? false;
  const items = copies.map(({path, text, why, time}) => {
    const when = new Date(time).toLocaleString();
    const back = async () => {
      await workspace.replace(path, text, "replaced by an earlier version");
      say(`${path} is as it was on ${when}.`, "good");
    };
    const name = `${path} of ${when}`;
    return el(
      "li",
      {},
      `${path}, ${when}: ${why} `,
      button("Take it back", back, {"aria-label": `Take back ${name}`}),
      " ",
      button("Download", () => download(path.split("/")[1], text, "text/plain"), {"aria-label": `Download ${name}`}),
    );
  });
  const details = el("details", {open: isOpen}, el("summary", {}, count(copies.length, "earlier version")), el("ul", {}, items));
  place.replaceChildren(details);
}
