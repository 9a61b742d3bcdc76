"""Make up a class at random, with an account of who handed in what that no reader has touched."""

from __future__ import annotations

import csv
import json
import random
import unicodedata
from dataclasses import dataclass, field
from pathlib import Path

from moodle_sheet import LANGUAGES, Sheet, download

GIVEN = ["Ann", "Bo", "José", "Ana María", "Li", "Wei", "Zoë", "小龙", "Jean-Luc", "J."]
GIVEN.append("Ann Marie")
FAMILY = ["Lee", "Doe", "Ñandú", "O'Neill", "Li", "Wei", "van der Berg", "Müller", "王", "Ek-Dahl"]
HOW = ["folders", "canvas", "canvas with other ids", "moodle", "moodle with a worksheet"]
HOW += ["gradescope", "github", "groups", "twice", "canvas with groups"]
HOW += ["moodle with a worksheet and groups", "gradescope with groups", "github with groups"]


@dataclass
class Person:
    """A student, and the ``path`` of the submission to be graded, which a group shares, or ""."""

    id: str
    given: str
    family: str
    email: str
    login: str
    group: str = ""
    path: str = ""
    is_gradable: bool = False

    def name(self, *, comma: bool = False) -> str:
        return f"{self.family}, {self.given}" if comma else f"{self.given} {self.family}"


@dataclass
class RandomClass:
    """A class in a folder. It is clear whom everything belongs to unless ``is_unclear`` is set."""

    how: str
    folder: Path
    roster: Path
    people: list[Person]
    comma: bool  # whether the roster has "Doe, Jane"
    is_unclear: bool = False
    strangers: list[str] = field(default_factory=list)  # paths of nobody on the roster


def plain(text: str) -> str:
    return "".join(c for c in unicodedata.normalize("NFKC", text).lower() if c.isalnum())


def random_class(seed: int, place: Path) -> RandomClass:
    rng = random.Random(seed)
    how = HOW[seed % len(HOW)]
    comma = rng.random() < 0.3
    may_pad = how not in ("canvas", "canvas with groups")  # whose own ids have no zeros in front
    people = [_person(rng, i, may_pad and rng.random() < 0.5) for i in range(rng.randint(4, 16))]
    made = RandomClass(how, place / "class", place / "roster.csv", people, comma)
    made.folder.mkdir()
    rng.shuffle(people)
    if how.endswith("groups"):
        for i, person in enumerate(people):
            person.group = f"Team {i // 3}" if i < len(people) - 2 else ""  # two work alone
    rows = [[p.id, p.name(comma=comma), p.email, p.login, p.group] for p in people]
    with made.roster.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file).writerows([["id", "name", "email", "login", "group"], *rows])
    others = [rng.randrange(10**6, 10**7) for _ in people]
    uploads = iter(rng.sample(range(100, 10**5), 5 * len(people)))
    for person, other in zip(people, others, strict=True):
        group = [p for p in people if p.group and p.group == person.group]
        if not any(p.path for p in group):
            _hand_in(rng, made, person, other, uploads)
        for each in group:
            each.path, each.is_gradable = person.path, person.is_gradable
    _add_files(rng, made, others)
    return made


def twins(made: RandomClass, person: Person) -> list[Person]:
    """Return the others who share a person's name, in whatever order its parts are read."""
    mine = {plain(person.name()), plain(person.family + person.given)}
    return [
        other
        for other in made.people
        if other is not person and mine & {plain(other.name()), plain(other.family + other.given)}
    ]


def a_name_of(rng: random.Random, made: RandomClass, person: Person) -> str:
    """Return a name that only this person has, in one of several spellings."""
    names = [person.id, *filter(None, [person.email, person.login])]
    if not twins(made, person):
        names += [person.name(), person.name(comma=True)]
    name = rng.choice(names)
    if name == person.id and name.startswith("00") and rng.random() < 0.5:
        return name.lstrip("0")  # as a spreadsheet writes it
    return rng.choice([name, name, name.upper(), f" {name} "])


def _person(rng: random.Random, i: int, padded: bool) -> Person:
    number = f"00{7000 + i}" if padded else f"{7000 + i}"
    given, family = rng.choice(GIVEN), rng.choice(FAMILY)
    email = f"p{i}@example.org" if rng.random() < 0.8 else ""
    return Person(number, given, family, email, f"login{i}" if rng.random() < 0.5 else "")


def _hand_in(
    rng: random.Random, made: RandomClass, person: Person, other: int, uploads: object
) -> None:
    action = rng.choice(["nothing", "work", "work", "work", "pdf", "both", "twice"])
    if action == "nothing":
        return
    upload = iter(uploads)  # type: ignore[call-overload]
    person.is_gradable = action != "pdf"
    if made.how.startswith("canvas"):
        number = other if made.how.endswith("other ids") else int(person.id)
        person_is = plain(person.family + person.given)
        made.is_unclear |= made.how.endswith("other ids") and bool(twins(made, person))
        late = rng.choice(["", "LATE_"])

        def canvas(file: str) -> str:
            return f"{person_is}_{late}{number}_{next(upload)}_{file}"

        numbers = sorted(next(upload) for _ in range(2))
        first, last = (f"{person_is}_{late}{number}_{n}_work.zip" for n in numbers)
        files = {
            "work": [last],
            "pdf": [canvas("report.pdf")],
            "both": [canvas("notes.pdf"), last],
            "twice": [first, last],
        }[action]
        person.path = files[-1]
    elif made.how.startswith(("moodle", "gradescope", "github")):
        alike = [plain(p.name()) for p in made.people].count(plain(person.name()))
        made.is_unclear |= made.how == "moodle" and alike > 1  # the given name is first
        person.path = {
            "moodle": f"{person.name()}_{other}_assignsubmission_file",
            "gradescope": f"submission_{other}",
            "github": f"lab1-user{other}",
        }[made.how.split()[0]]
        files = [f"{person.path}/{'report.pdf' if action == 'pdf' else 'work.zip'}"]
        person.is_gradable = True  # as far as the folder tells; grading looks inside
    else:
        name = a_name_of(rng, made, person).strip().replace("/", "")
        person.path = f"{name}.pdf" if action == "pdf" else rng.choice([name, f"{name}.zip"])
        zipped = person.path.endswith((".zip", ".pdf"))
        files = [person.path if zipped else f"{person.path}/x.py"]
        files += [f"{name}.pdf"] if action == "both" else []
        if made.how == "twice" and rng.random() < 0.1:  # under another name as well
            files.append(f"{person.id}.zip" if name != person.id else f"{name}.ZIP")
            made.is_unclear |= person.is_gradable and not person.path.endswith(".pdf")
            person.is_gradable, person.path = True, files[0] if person.is_gradable else files[-1]
    for file in files:
        path = made.folder / file
        path.parent.mkdir(exist_ok=True)
        path.touch()


def _add_files(rng: random.Random, made: RandomClass, others: list[int]) -> None:
    there = [(p, o) for p, o in zip(made.people, others, strict=True) if p.path]
    if made.how.startswith("moodle with"):
        sheet = Sheet(rng.choice([*LANGUAGES.values()]))
        rows = {o: (p.name(), p.id, p.email) for p, o in zip(made.people, others, strict=True)}
        text = download(sheet, rows)
        (made.folder / "worksheet.csv").write_text(text, encoding="utf-8")
    elif made.how.startswith("gradescope"):
        submitters: dict[str, dict[str, list[dict[str, str]]]] = {}
        for p, _ in there:
            names = {":name": p.name(), ":sid": p.id, ":email": p.email or "hidden@example.org"}
            submitters.setdefault(p.path, {":submitters": []})[":submitters"].append(names)
        # JSON is YAML, too.
        text = json.dumps(submitters, ensure_ascii=False)
        (made.folder / "submission_metadata.yml").write_text(text, encoding="utf-8")
    elif made.how.startswith("github"):
        rows_of = [[p.path, rng.choice([p.id, p.email or p.id, p.login or p.id])] for p, _ in there]
        with (made.folder / "grades.csv").open("w", encoding="utf-8", newline="") as file:
            head = ["student_repository_name", "roster_identifier"]
            csv.writer(file).writerows([head, *rows_of])
    if made.how in ("folders", "github") and rng.random() < 0.5:
        made.strangers.append("nobody-we-know")
        (made.folder / "nobody-we-know").mkdir()
