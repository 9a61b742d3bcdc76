"""Perform a student's actions on pages of the site by keyboard, in Firefox or WebKit."""

from __future__ import annotations

import base64
import json
import zipfile
from pathlib import Path

from course_site import Served
from site_page import STORED
from webdriver import CONTROL, ENTER, Browser, until

# What each page gets: a list of its errors, and functions that wait for something or find a button.
PREPARED = """
window.troubles = [];
addEventListener("error", ({message}) => troubles.push(message));
addEventListener("unhandledrejection", ({reason}) => troubles.push(String(reason)));
window.until = async (condition, shown = () => document.body.innerText.slice(0, 2000)) => {
  for (const end = Date.now() + 120_000; Date.now() < end; ) {  // machines of CI are slow
    const found = condition();
    if (found) return found;
    await new Promise((done) => setTimeout(done, 20));
  }
  throw new Error(`never true: ${condition}\\n${shown()}`);
};
window.button = (words, place) =>
  [...(place?.querySelectorAll("button") ?? [])].find((each) => each.textContent === words);
"""

# Select a text outside the page's own parts, to copy it.
SELECTED = """
const outside = document.createElement("textarea");
outside.id = "outside";
outside.value = %s;
document.body.append(outside);
outside.focus({preventScroll: true});
outside.select();
"""

# Put a file into a file input. Nobody can press the buttons of a browser's own file chooser.
CHOSEN = """
const [name, bytes] = %s;
const data = new DataTransfer();
data.items.add(new File([Uint8Array.from(atob(bytes), (each) => each.charCodeAt(0))], name));
const input = document.querySelector("#zip-file");
input.files = data.files;
input.dispatchEvent(new Event("change"));
"""


class Student:
    def __init__(self, browser: Browser, site: Served) -> None:
        self.browser, self.site = browser, site
        self.troubles: list[str] = []

    def visit(self, page: str) -> None:
        self.listen()
        self.browser.open(f"{self.site.address}{page}")
        self.browser.run(PREPARED)

    def see(self, condition: str) -> None:
        self.browser.run(f"await until(() => {condition})")

    def text(self, place: str) -> str:
        return str(self.browser.run(f"return {place}.innerText"))

    def read(self, words: str, place: str = "document.body") -> str:
        """Wait until a part of the page shows these words, and return all of its text."""
        text = f"{place}?.innerText"
        self.browser.run(f"await until(() => {text}.includes({json.dumps(words)}), () => {text})")
        return self.text(place)

    def press(self, button: str, place: str = "document") -> None:
        """Move the focus to a button in a part of the page, and press Enter."""
        found = f"button({json.dumps(button)}, {place})"
        self.see(found)
        # A dialog that has just opened moves the focus before the next frame.
        self.browser.run(f"await new Promise(requestAnimationFrame); {found}.focus()")
        self.browser.press(ENTER)

    def panel(self, selector: str, ready: str) -> str:
        """Go to a panel that is filled when it comes near. Return it, as an expression."""
        panel = f"document.querySelector({json.dumps(selector)})"
        # The editor that was used last may still scroll to its cursor.
        self.see(f"({panel}.scrollIntoView(), {panel}.querySelector({json.dumps(ready)}))")
        return panel

    def turn(self, exercise: str) -> str:
        return self.panel(f"#ex-{exercise.replace('.', '-')}", ".cm-content")

    def write(self, panel: str, text: str) -> None:
        """Replace the whole text in a panel's editor by one that is copied from elsewhere."""
        self.browser.run(SELECTED % json.dumps(text))
        self.browser.press(CONTROL, "c")
        self.browser.run(f"outside.remove(); {panel}.querySelector('.cm-content').focus()")
        self.browser.press(CONTROL, "a")
        self.browser.press(CONTROL, "v")

    def check(self, panel: str, button: str = "Check") -> str:
        """Press a button, wait until the checks are done, and return what they say."""
        status = f"{panel}.querySelector('[role=status]')"
        self.browser.run(f"{status}.textContent = ''")  # what the last checks said
        self.press(button, panel)
        done = f"{panel}.querySelector('.result:not([aria-busy])')"
        said = f"!/^(Checking|Python is starting|$)/.test({status}.innerText)"
        self.see(f"{done} && {said}")
        return self.text(status)

    def upload(self, archive: Path) -> None:
        self.see("document.querySelector('#zip-file')")
        sent = [archive.name, base64.b64encode(archive.read_bytes()).decode()]
        self.browser.run(CHOSEN % json.dumps(sent))

    def download(self, name: str) -> Path:
        """Return a zip that the browser is downloading, when all of it is there."""
        files = self.browser.home.rglob
        return until(lambda: next(filter(zipfile.is_zipfile, files(name)), None))

    def stored(self, path: str) -> str:
        """Return the text of a file that the page keeps in the browser."""
        return str(self.browser.run(f"return ({STORED})({json.dumps(path)})"))

    def listen(self) -> None:
        """Note the errors that have occurred since the page was opened."""
        self.troubles += self.browser.run("return window.troubles ?? []")
