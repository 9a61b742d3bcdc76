// Offline use: a service worker stores all pages, and then the files that Python needs.

import {button} from "./dom.js";
import {workspace} from "./files/workspace.js";

export async function startOffline() {
  if (!navigator.serviceWorker) return; // not on this browser, or not without https
  const status = document.getElementById("offline");
  const service = navigator.serviceWorker;
  const hadOne = Boolean(service.controller);
  service.addEventListener("message", ({data}) => {
    if (data.kind === "ready") status.textContent = "Everything is kept for use without the internet.";
  });
  service.addEventListener("controllerchange", async () => {
    if (!hadOne) return;
    await workspace.saveAll();
    location.reload(); // show the new version
  });
  try {
    const registration = await service.register("sw.js");
    const offer = () => registration.waiting && hadOne && offerVersion(status, registration.waiting);
    registration.addEventListener("updatefound", () => {
      registration.installing?.addEventListener("statechange", offer);
    });
    offer();
    const ready = await service.ready;
    // The large files wait until the page has been read a little, and where data is dear until they
    // are needed.
    if (!navigator.connection?.saveData) setTimeout(() => ready.active.postMessage({kind: "later"}), 1500);
  } catch (error) {
    console.info(`Offline use is not possible here: ${error.message}`);
  }
}

function offerVersion(status, waiting) {
  status.textContent = "A new version of the course is ready. ";
  status.append(button("Use it now", () => waiting.postMessage({kind: "activate"})));
}
