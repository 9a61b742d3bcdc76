"""Open pages of the site in a browser, and perform a student's actions on them."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from autograder.manifest import ROOT
from copies import reference

VECTOR = "ch02_vectors/vector.py"
STUB = (ROOT / "chapters" / VECTOR).read_text(encoding="utf-8")

PASTE = """([text]) => {
  const data = new DataTransfer();
  data.setData("text/plain", text);
  const paste = {clipboardData: data, bubbles: true, cancelable: true};
  document.activeElement.dispatchEvent(new ClipboardEvent("paste", paste));
}"""


@contextmanager
def visit(browser: Any, width: int = 1280, **options: Any) -> Iterator[Any]:
    """Yield a new visitor's browser context, in which no error and no other host may occur."""
    context = browser.new_context(viewport={"width": width, "height": 900}, **options)
    context.set_default_timeout(60_000.0)  # ms; machines of CI are slow
    context.troubles, context.hosts = [], set()
    context.on("request", lambda request: context.hosts.add(urlsplit(request.url).hostname))
    context.on("weberror", lambda error: context.troubles.append(str(error.error)))
    context.on("console", lambda message: _hear(context, message))
    yield context
    context.close()
    assert context.troubles == []
    assert context.hosts <= {"127.0.0.1", None}  # None: data within the page


def visitor(browser: Any) -> Iterator[Any]:
    """Yield the browser context of a visitor who has no stored data yet, for a fixture."""
    with visit(browser) as context:
        yield context


@contextmanager
def everything_written(browser: Any, address: str, folder: Path) -> Iterator[Any]:
    """Yield the page of a visitor who has uploaded all of the reference's files as a zip."""
    with visit(browser) as context:
        page = context.new_page()
        upload(page, address, reference(), folder)
        yield page


def _hear(context: Any, message: Any) -> None:
    if message.type == "error":
        context.troubles.append(f"{message.text} {message.location}")


def accessible(page: Any) -> None:
    """Assert that a page follows axe's rules and is not wider than its window."""
    from axe_playwright_python.sync_playwright import Axe

    # Observers, which let wide tables scroll with the keys, run at the end of a frame.
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    found = Axe().run(page).response["violations"]
    assert found == [], json.dumps([(v["id"], [n["html"] for n in v["nodes"][:3]]) for v in found])
    width = page.viewport_size["width"]
    assert page.evaluate("document.documentElement.scrollWidth") <= width


def turn(page: Any, exercise: str) -> Any:
    panel = page.locator(f"#ex-{exercise.replace('.', '-')}")
    panel.scroll_into_view_if_needed()
    panel.locator(".cm-content, textarea").wait_for()
    return panel


def write(page: Any, panel: Any, file: str, text: str) -> None:
    """Replace the whole text of a file in a panel's editor, as by selecting all and pasting."""
    path = panel.locator(".editor").get_attribute("data-path") or ""
    if not path.endswith(f"/{file}"):
        panel.get_by_label("Show a file of the chapter").select_option(label=file)
        panel.locator(f".editor[data-path$='/{file}']").wait_for()
    panel.locator(".cm-content").focus()
    page.keyboard.press("Control+a")
    page.evaluate(PASTE, [text])


def check(panel: Any, button: str = "Check") -> str:
    """Press Check, wait until the checks are done, and return the text that is shown."""
    panel.get_by_role("button", name=button, exact=True).click()
    panel.locator(".result:not([aria-busy])").wait_for(state="attached")
    status = panel.locator("[role=status]")
    for _ in range(1200):
        words = status.inner_text()
        if not words.startswith(("Checking", "Python is starting")):
            return str(words)
        panel.page.wait_for_timeout(50)
    raise AssertionError(f"the checks do not end: {words}")


def rows(panel: Any) -> list[tuple[str, str]]:
    """Return the labels and texts of the failure that a panel shows."""
    read = """list => [...list.children].map(e => [e.tagName, e.textContent])"""
    found = panel.locator(".result .rows").evaluate(read)
    labeled: list[tuple[str, str]] = []
    label = ""
    for tag, words in found:
        if tag == "DT":
            label = words
        else:
            labeled.append((label, words))
            label = ""
    return labeled


def upload(page: Any, address: str, texts: dict[str, str], folder: Path) -> None:
    import zipfile

    archive = folder / "mine.zip"
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as file:
        for path, text in texts.items():
            file.writestr(path, text)
    page.goto(f"{address}index.html")
    page.locator("#zip-file").set_input_files(archive)
    page.locator(".work [role=status]").filter(has_text="taken from mine.zip").wait_for()


STORED = """(path) => new Promise(resolve => {
  const name = `game-physics-companion ${new URL(".", document.baseURI).pathname}`;
  indexedDB.open(name).onsuccess = ({target: {result}}) =>
    result.transaction("files").objectStore("files").get(path).onsuccess = (event) => {
      result.close();
      resolve(event.target.result?.text ?? "");
    };
})"""


def stored(page: Any, path: str = VECTOR) -> str:
    return str(page.evaluate(STORED, path))


def marked(note: str) -> str:
    """Return the stub of vector.py with a comment at its end."""
    return f"{STUB}# {note}\n"
