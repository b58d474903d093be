"""The product as its files: modules and their lines, classes, and the parameters of functions."""

from __future__ import annotations

import ast
import gc
import subprocess
from collections import defaultdict
from collections.abc import Iterator
from functools import cache

from tests.conftest import ROOT

PACKAGES = ("donnie_tui", "language", "sim", "devices", "worlds")
GENERATED = frozenset({"language/tables.py"})


@cache
def tracked(*places: str) -> tuple[str, ...]:
    """The paths that git knows, and that are there."""
    done = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *places],
        cwd=ROOT, capture_output=True, text=True, check=True,
    )  # fmt: skip
    return tuple(sorted(each for each in done.stdout.splitlines() if (ROOT / each).is_file()))


def modules() -> list[str]:
    """The paths of the product's modules; an empty ``__init__`` and what is generated are none."""
    found = [each for each in tracked(*PACKAGES) if each.endswith(".py")]
    return [each for each in found if each not in GENERATED and lines_of(each)]


def lines_of(path: str) -> int:
    return len((ROOT / path).read_text(encoding="utf-8").splitlines())


@cache
def tree_of(path: str) -> ast.Module:
    """Kept, as several tests need it."""
    return parsed(path)


def parsed(path: str) -> ast.Module:
    """Collects no garbage during the parse.

    Python reports a finalizer that fails with a traceback, and 3.11 parses a line for it. A parse inside
    another one makes the outer one fail.
    """
    text = (ROOT / path).read_text(encoding="utf-8")
    gc.disable()
    try:
        return ast.parse(text)
    finally:
        gc.enable()


def places_of_public_classes() -> dict[str, list[str]]:
    """The modules that define a class of each name."""
    places = defaultdict(list)
    for path in modules():
        for node in tree_of(path).body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                places[node.name].append(path)
    return places


def functions() -> Iterator[tuple[str, int]]:
    """Where each function is, and how many parameters it has besides ``self`` and ``cls``."""
    for path in modules():
        for node in ast.walk(tree_of(path)):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                given = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs]
                given += [each for each in (node.args.vararg, node.args.kwarg) if each]
                own = [each for each in given if each.arg not in ("self", "cls")]
                yield f"{path}:{node.lineno} {node.name}", len(own)
