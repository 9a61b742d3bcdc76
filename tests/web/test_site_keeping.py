"""What a student writes is kept: over reloads, in two tabs, in a zip and a folder, and offline."""

from __future__ import annotations

import csv
import time
import zipfile
from pathlib import Path
from typing import Any

import pytest

from autograder.manifest import load_chapters
from copies import reference
from course_site import Served
from site_page import STUB, VECTOR, accessible, check, marked, stored, turn, upload, write
from staging import NO_UTF8, TOO_LARGE
from typed import typed

# A worker that never starts Python. Starting it would take longer than the whole test.
NO_PYTHON = """globalThis.Worker = class extends EventTarget {
  postMessage() {}
  terminate() {}
}"""


def lesson(visitor: Any, site: Served) -> Any:
    """Open the lesson of chapter 2, for a test that does not check anything."""
    page = visitor.new_page()
    page.add_init_script(NO_PYTHON)
    page.goto(f"{site.address}ch02_vectors.html")
    return page


def until(page: Any, condition: Any) -> None:
    """Wait until a condition holds."""
    for _ in range(200):
        if condition():
            return
        page.wait_for_timeout(25)
    raise AssertionError("it does not come to hold")


def until_at_end(page: Any, turn: Any, text: str) -> None:
    """Go to the end of an editor and wait for a text there, which may come from another tab."""
    turn.locator(".cm-content").focus()
    page.keyboard.press("Control+End")
    turn.locator(".cm-line", has_text=text).wait_for()


def test_work_survives_a_reload_a_closed_tab_and_typing_up_to_the_end(
    visitor: Any, site: Served
) -> None:
    page = lesson(visitor, site)
    write(page, turn(page, "B2.1"), "vector.py", marked("one"))
    until(page, lambda: stored(page) == marked("one"))
    page.reload()
    panel = turn(page, "B2.1")
    panel.locator(".cm-content").focus()
    page.keyboard.press("Control+End")
    page.keyboard.insert_text("# two\n")
    page.close()  # at once, before it is saved
    page = lesson(visitor, site)
    turn(page, "B2.1")
    until(page, lambda: stored(page) == f"{marked('one')}# two\n")


# Type a character every 40 ms for two seconds, and return how often the file was saved meanwhile.
TYPE = """() => new Promise((done) => {
  const put = IDBObjectStore.prototype.put;
  let [saved, left] = [0, 50];
  IDBObjectStore.prototype.put = function (...given) {
    saved++;
    return put.apply(this, given);
  };
  const timer = setInterval(() => {
    document.execCommand("insertText", false, "#");
    if (--left) return;
    clearInterval(timer);
    done(saved);
  }, 40);
})"""


def test_work_is_saved_while_somebody_types_without_a_pause(visitor: Any, site: Served) -> None:
    """At a save each fifth of a second it is ten times, and fewer if the machine is busy."""
    page = lesson(visitor, site)
    write(page, turn(page, "B2.1"), "vector.py", marked("one"))
    until(page, lambda: stored(page) == marked("one"))
    assert page.evaluate(TYPE) >= 4


def test_several_editors_of_one_file_show_one_text(visitor: Any, site: Served) -> None:
    page = lesson(visitor, site)
    first, second = turn(page, "B2.2"), turn(page, "B2.3")
    text = STUB.replace('raise NotImplementedError("Exercise B2.2: Length")', "return 0.0", 1)
    write(page, first, "vector.py", text)
    second.get_by_label("What you write").get_by_role("button", name="__mul__").click()
    page.keyboard.press("Control+z")  # nothing of its own is there to undo
    page.keyboard.press("Control+Home")
    page.keyboard.insert_text("# top\n")
    until(page, lambda: stored(page) == f"# top\n{text}")
    first.locator(".cm-content").focus()
    page.keyboard.press("Control+z")  # takes back what was pasted here, and not the other's line
    until(page, lambda: stored(page) == f"# top\n{STUB}")


def test_two_tabs_follow_each_other_and_never_overwrite_silently(
    visitor: Any, site: Served
) -> None:
    first, second = lesson(visitor, site), lesson(visitor, site)
    one, two = turn(first, "B2.1"), turn(second, "B2.1")
    write(first, one, "vector.py", marked("from the first"))
    until(first, lambda: stored(first) == marked("from the first"))
    until_at_end(second, two, "# from the first")
    second.keyboard.press("Control+End")
    second.keyboard.insert_text("# and the second\n")
    both = f"{marked('from the first')}# and the second\n"
    until(second, lambda: stored(second) == both)
    until_at_end(first, one, "# and the second")
    # Both change it within the moment before anything is saved.
    late = "BroadcastChannel.prototype.postMessage = () => undefined"
    second.evaluate(late)
    write(second, two, "vector.py", marked("second wins"))
    until(second, lambda: stored(second) == marked("second wins"))
    write(first, one, "vector.py", marked("first loses"))
    one.get_by_text("was changed in another tab at the same time").wait_for()
    assert stored(first) == marked("second wins")
    one.get_by_role("button", name="Take mine instead").click()
    until(first, lambda: stored(first) == marked("first loses"))
    first.goto(f"{site.address}index.html")
    first.get_by_text("earlier version").click()
    assert first.locator(".work li", has_text=VECTOR).count() >= 2


def test_the_download_is_graded_with_the_points_of_the_page(
    visitor: Any, site: Served, tmp_path: Path
) -> None:
    page = visitor.new_page()
    page.goto(f"{site.address}index.html")
    page.get_by_role("button", name="Download my work").click()
    page.get_by_text("nothing to download").wait_for()
    texts = reference("ch02_vectors", "ch03_laws_of_motion")
    texts[VECTOR] = texts[VECTOR].replace("return Vector3(-self.x", "return Vector3(self.x")
    upload(page, site.address, texts, tmp_path)
    earned = []
    for chapter in load_chapters()[:2]:
        page.goto(f"{site.address}{chapter.name}.html")
        whole = page.locator("[data-whole]")
        whole.scroll_into_view_if_needed()
        check(whole, "Check the whole chapter")
        earned.append(float(whole.locator(".note").first.inner_text().split(" of ")[0]))
    began = time.monotonic()
    check(whole, "Check the whole chapter")  # again, as Python has been started
    assert time.monotonic() - began < 10.0
    page.goto(f"{site.address}index.html")
    page.get_by_label("Your name").fill("Ada Example")
    page.get_by_label("Your name").blur()
    with page.expect_download() as download:
        page.get_by_role("button", name="Download my work").click()
    assert download.value.suggested_filename == "Ada Example.zip"
    (tmp_path / "class").mkdir()
    download.value.save_as(tmp_path / "class" / "Ada Example.zip")
    options = ("--chapters", "2-3", "--seed", "1", "--out", tmp_path / "grades")
    done = typed("autograder", "grade", tmp_path / "class", *options)
    assert done.returncode in (0, 1), done.stderr
    with (tmp_path / "grades" / "gradebook.csv").open(encoding="utf-8", newline="") as file:
        graded = {row["student"]: row for row in csv.DictReader(file)}["Ada Example"]
    exercises = [each for chapter in load_chapters()[:2] for each in chapter.exercises]
    of = sum(each.points for each in exercises if each.kind != "written")
    assert of - 10.0 < sum(earned) < of, "one mistake"
    assert float(graded["score"]) == pytest.approx(sum(earned))


def test_an_upload_asks_before_it_overwrites_and_refuses_what_is_no_zip(
    visitor: Any, site: Served, tmp_path: Path
) -> None:
    page = visitor.new_page()
    upload(
        page, site.address, {f"me/chapters/{VECTOR}": marked("one"), "me/notes.txt": ""}, tmp_path
    )
    status = page.locator(".work [role=status]")
    assert "1 other file in it is not part of what you write" in status.inner_text()
    assert stored(page) == marked("one")
    with zipfile.ZipFile(tmp_path / "mine.zip", "w") as archive:
        archive.writestr(VECTOR, marked("two"))
    chooser = page.locator("#zip-file")
    chooser.set_input_files(tmp_path / "mine.zip")
    dialog = page.get_by_role("dialog")
    dialog.get_by_text(VECTOR).wait_for()
    accessible(page)
    dialog.get_by_role("button", name="Cancel").click()
    assert stored(page) == marked("one")
    chooser.set_input_files(tmp_path / "mine.zip")
    dialog.get_by_role("button", name="Replace them").click()
    until(page, lambda: stored(page) == marked("two"))
    for content, words in {
        b"no zip": "not an ordinary zip",
        b"x" * 5_000_001: "larger than 5 MB",
    }.items():
        (tmp_path / "bad.zip").write_bytes(content)
        chooser.set_input_files(tmp_path / "bad.zip")
        status.filter(has_text=words).wait_for()
    for name, text, words in (
        ("other/file.py", b"", "contains no file of the course"),
        ("constructor", b"", "contains no file of the course"),
        (VECTOR, b"\xff\xfe", f"{VECTOR} was rejected: {NO_UTF8}"),
        (VECTOR, b"x" * 1_000_001, f"{VECTOR} was rejected: {TOO_LARGE}"),
    ):
        with zipfile.ZipFile(tmp_path / "bad.zip", "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(name, text)
        chooser.set_input_files(tmp_path / "bad.zip")
        status.filter(has_text=words).wait_for()
    assert stored(page) == marked("two")
    page.get_by_text("earlier version").click()
    page.get_by_role("button", name="Take back").first.click()
    until(page, lambda: stored(page) == marked("one"))
    page.get_by_role("button", name="Erase everything").click()
    dialog.get_by_role("button", name="Cancel").click()
    assert stored(page) == marked("one")
    page.get_by_role("button", name="Erase everything").click()
    dialog.get_by_role("button", name="Erase everything").click()
    page.get_by_text("Nothing yet.").wait_for()
    assert stored(page) == ""


# The browser's own file system stands for a folder, since nobody can press the picker's buttons.
FOLDER = """async (text) => {
  const top = await navigator.storage.getDirectory();
  const chapters = await top.getDirectoryHandle("chapters", {create: true});
  const chapter = await chapters.getDirectoryHandle("ch02_vectors", {create: true});
  window.file = await chapter.getFileHandle("vector.py", {create: true});
  window.put = async (words) => {
    const out = await window.file.createWritable();
    await out.write(words);
    await out.close();
  };
  await window.put(text);
  window.showDirectoryPicker = async () => top;
}"""


def test_a_folder_is_opened_and_followed_both_ways(visitor: Any, site: Served) -> None:
    page = visitor.new_page()
    page.goto(f"{site.address}index.html")
    page.get_by_role("button", name="Open a folder").wait_for()
    page.evaluate(FOLDER, marked("in the folder"))
    page.get_by_role("button", name="Open a folder").click()
    page.get_by_text("is saved in the folder").wait_for()
    until(page, lambda: stored(page) == marked("in the folder"))
    page.evaluate("put", marked("by another editor"))
    page.evaluate("dispatchEvent(new Event('focus'))")
    until(page, lambda: stored(page) == marked("by another editor"))
    page.get_by_text("earlier version").click()
    page.get_by_role("button", name="Take back").first.click()
    until(page, lambda: page.evaluate("file.getFile().then(f => f.text())") == stored(page))
    assert stored(page) == marked("in the folder")
