"""What the documents name exists: links, paths, and modules that are run. How they are wrapped."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.architecture.house import PACKAGES, tracked, tree_of
from tests.conftest import ROOT

DOCUMENTS = [each for each in tracked("README.md", "CONTRIBUTING.md", "docs") if each.endswith(".md")]

TOP = {each.partition("/")[0] for each in tracked()}
"""What stands at the top of the repository."""

LINK = re.compile(r"\]\(([^)#\s]+)[^)]*\)")
QUOTED = re.compile(r"`([^`\n]+)`")
QUOTED_LINES = re.compile(r"^ *```.*?^ *```", re.DOTALL | re.MULTILINE)
PATH = re.compile(r"(?<![\w./-])[\w.-]+(?:/[\w.*-]*)+")
MODULE = re.compile(r"python -m ([a-z0-9_.]+)")
OUTSIDE = ("http:", "https:", "mailto:")
PLACEHOLDER = re.compile(r"\b[A-Z]{2,}\b")
"""As in ``locales/LANG``."""


def named_paths(document: str) -> Iterator[str]:
    """Each path of the repository that the document names, from the repository's root."""
    text = (ROOT / document).read_text(encoding="utf-8")
    for link in LINK.findall(text):
        if not link.startswith(OUTSIDE):
            yield str((ROOT / document).parent.joinpath(link).resolve().relative_to(ROOT))
    for quoted in QUOTED.findall(text):
        for module in MODULE.findall(quoted):
            if module.partition(".")[0] in (*PACKAGES, "tests"):
                yield f"{module.replace('.', '/')}.py"
        for path in PATH.findall(quoted):
            if path.partition("/")[0] in TOP and not PLACEHOLDER.search(path):
                yield path


def exists(path: str) -> bool:
    if (ROOT / path).exists() or (ROOT / path.removesuffix(".py")).is_dir():
        return True
    return "*" in path and any(ROOT.glob(path))


@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_path_that_a_document_names_exists(document: str) -> None:
    missing = {each for each in named_paths(document) if not exists(each)}

    assert not missing


TEST_FILE = re.compile(r"\btest_\w+\.py\b")


@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_test_file_that_a_document_names_exists(document: str) -> None:
    """Also without its folder."""
    known = {Path(each).name for each in tracked("tests")}

    assert {*TEST_FILE.findall((ROOT / document).read_text(encoding="utf-8"))} - known == set()


PLACED = re.compile(r"`([A-Za-z_.]+)` in\s+`([\w/]+\.py)`")
"""As in ``_ORDER`` in ``worlds/__init__.py``."""


def defined_in(path: str) -> set[str]:
    """The names of a module's functions, classes, methods and constants, imported ones aside."""
    names = set[str]()
    for node in ast.walk(tree_of(path)):
        match node:
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                names.add(name)
            case ast.Name(id=name, ctx=ast.Store()):
                names.add(name)
    return names


@pytest.mark.parametrize(
    ("name", "path"),
    sorted({each for document in DOCUMENTS for each in PLACED.findall((ROOT / document).read_text("utf-8"))}),
)
def test_a_name_is_defined_where_a_document_says_that_it_is(name: str, path: str) -> None:
    assert name.rpartition(".")[2] in defined_in(path)


def rooms() -> Iterator[tuple[str, str]]:
    """Each folder of the table of rooms, with what it names as its modules."""
    for line in (ROOT / "docs/architecture.md").read_text(encoding="utf-8").splitlines():
        cells = line.strip("| ").split(" | ")
        folder = cells[0].strip("`")
        if len(cells) == 3 and (ROOT / folder).is_dir():
            yield folder, cells[2]


@pytest.mark.parametrize(("folder", "modules"), [pytest.param(*each, id=each[0]) for each in rooms()])
def test_every_module_in_the_table_of_rooms_exists(folder: str, modules: str) -> None:
    named = [f"{folder}/{each}" for each in QUOTED.findall(modules) if "/" not in each]

    assert [each for each in named if not exists(each) and not exists(f"{each}.py")] == []


@pytest.mark.parametrize("document", [*DOCUMENTS, "CHANGELOG.md", "SECURITY.md"])
def test_a_document_is_wrapped_at_100_columns(document: str) -> None:
    """Its sentences; rows of tables, quoted programs and the generated list of commands are longer."""
    lines = QUOTED_LINES.sub("", (ROOT / document).read_text(encoding="utf-8")).splitlines()
    is_generated = document == "docs/commands.md"

    assert [each for each in lines if len(each) > 100 and not each.startswith("|") and not is_generated] == []


def test_paths_are_found() -> None:
    assert "docs/architecture.md" in {*named_paths("README.md")}
    assert "donnie_tui/commands" in {folder for folder, _ in rooms()}
    assert {each.partition("/")[0] for each in named_paths("CONTRIBUTING.md")} >= {
        "language",
        "docs",
        "tests",
    }
