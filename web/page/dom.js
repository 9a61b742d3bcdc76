// Small helpers for the elements of a page.

// Make an element. Properties of the element are set as such, others (data-, aria-, role) as attributes.
export function el(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name in element && !name.includes("-")) element[name] = value;
    else if (value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== ""));
  return element;
}

export function button(words, onclick, properties = {}) {
  return el("button", {type: "button", onclick, ...properties}, words);
}

// Turn words with `code` in backticks into elements.
export const marked = (words) => words.split(/`([^`]+)`/).map((part, i) => (i % 2 ? el("code", {}, part) : part));

// Return the address of a file of the site. All pages are in one folder.
export const site = (file) => new URL(file, document.baseURI).href;

// Call a function once, when an element comes near the visible part of the page.
export function whenNear(element, act) {
  const watcher = new IntersectionObserver(
    (entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      watcher.disconnect();
      act();
    },
    {rootMargin: "400px"},
  );
  watcher.observe(element);
}

export function count(number, one, many = `${one}s`) {
  return `${number} ${number === 1 ? one : many}`;
}

// Save text or bytes as a file on the reader's computer.
export function download(name, content, type) {
  const link = el("a", {href: URL.createObjectURL(new Blob([content], {type})), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
