"""The naming rules: words that no name has, and patterns that no sentence has.

``python -m tests.architecture.naming [PATHS]`` lists what breaks them.
"""

from __future__ import annotations

import ast
import re
import sys
import tokenize
from collections.abc import Iterator
from pathlib import Path

from tests.architecture.house import parsed, tracked
from tests.conftest import ROOT

WORDS = frozenset(
    {
        *("deed", "deeds", "told", "tell", "tells", "telling", "teller", "hear"),
        *("hears", "heard", "hearing", "hearer", "beside", "who", "whoever", "somebody"),
        *("nobody", "anybody", "someone", "mend", "mends", "mended", "mending", "goes"),
        *("going", "coming", "comes", "brought", "bring", "habit", "habits", "choice"),
        *("choices", "wish", "wishes", "patience", "patiently", "thrift", "settle", "settled"),
        *("settling", "settles", "desk", "ends", "intake", "glance", "glances", "ear"),
        *("ears",),
    }
)
"""No module, class or function has one of them in its name."""

VERBS = frozenset({"ends", "goes", "comes", "settles"})
"""Allowed in the name of a test, which is a sentence."""

SENTENCES = [
    re.compile(each)
    for each in (
        r"\b[Ww]hoever\b",
        r"\b[Ss]omebody\b",
        r"\b[Nn]obody\b",
        r"\b[Tt]old\b",
        r"\b[Tt]ell(s|ing)?\b",
        r"\b[Dd]eeds?\b",
        r"\b[Mm]end(s|ed|ing)?\b",
        r"(?m)(^|[.:;\"] +)Who\b(?!.*\?)",
        r"\b[Ww]ho (types|listens|asks|reads|looks|wants|waits|hears|presses|plays|draws)\b(?!.*\?)",
        r"\b[Bb]rought\b",
        r"\b[Bb]eside\b",
        r"\b[Hh]abits?\b",
        r"\bstands? behind\b",
        r"\bbehind (a|the|its|their) (word|prompt|frame|screen)\b",
        r"\b[Gg]oes on\b",
        r"\b[Pp]atience\b",
        r"\b[Tt]hrift\b",
        r"\bours\b",
    )
]
"""In no docstring, comment, message of an exception, or document."""

HEARING = re.compile(r"\b[Hh]ear[sd]?\b")
SOUND = re.compile(
    r"(?i)sound|voice|cue|tone|speech|spoke|speak|says|said|audio|loud|volume|utter|listen|reader"
)
"""A person hears a sound; a program gets an event. HEARING is allowed in a sentence that is about SOUND."""

CODES = re.compile(r"(?<![\w#-])\(?[ABCDELMPSTVW]\d{1,2}(?=[\s).,:;]|$)\)?(?!\w)")
"""Numbers of requirements in documents outside the repository: a letter and one or two digits."""


def findings(*places: str) -> list[str]:
    """Each as ``path:line: what``."""
    return [each for path in tracked(*places) for each in _of_file(path)]


def _of_file(path: str) -> Iterator[str]:
    if path.endswith(".md"):
        for number, line in enumerate((ROOT / path).read_text(encoding="utf-8").splitlines(), 1):
            yield from (f"{path}:{number}: {each}" for each in wrong_sentences(line))
    elif path.endswith(".py"):
        yield from _of_module(path)


def _of_module(path: str) -> Iterator[str]:
    text = (ROOT / path).read_text(encoding="utf-8")
    if bad := parts(Path(path).stem) & WORDS:
        yield f"{path}:1: module {bad}"
    for node in ast.walk(parsed(path)):
        match node:
            case ast.ClassDef(name=name) | ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name):
                if bad := wrong_words(name):
                    yield f"{path}:{node.lineno}: name {name} {bad}"
            case ast.Expr(value=ast.Constant(value=str(prose))):
                yield from (f"{path}:{node.lineno}: {each}" for each in wrong_sentences(prose, codes=True))
            case ast.Raise(exc=ast.Call(args=arguments)):
                for argument in arguments:
                    if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
                        found = wrong_sentences(argument.value)
                        yield from (f"{path}:{node.lineno}: {each}" for each in found)
    if not any(_may_be_wrong(line) for line in text.splitlines() if "#" in line):
        return
    for token in tokenize.generate_tokens(iter(text.splitlines(keepends=True)).__next__):
        if token.type == tokenize.COMMENT:
            found = wrong_sentences(token.string, codes=True)
            yield from (f"{path}:{token.start[0]}: {each}" for each in found)


def _may_be_wrong(line: str) -> bool:
    """Whether a comment of this line can be wrong: most files need not be taken apart."""
    behind = line[line.index("#") :]
    return any(pattern.search(behind) for pattern in (*SENTENCES, CODES, HEARING))


def wrong_words(name: str) -> set[str]:
    allowed = VERBS if name.startswith("test_") else frozenset()
    return parts(name) & WORDS - allowed


def parts(name: str) -> set[str]:
    """The words of a name in either manner: ``told_lines``, ``ToldLines``."""
    return {each.lower() for each in re.findall(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+", name)}


def wrong_sentences(prose: str, *, codes: bool = False) -> Iterator[str]:
    """What is wrong, with the place in the sentence."""
    patterns = [*SENTENCES, CODES] if codes else SENTENCES
    if not SOUND.search(prose):
        patterns = [*patterns, HEARING]
    for pattern in patterns:
        if found := pattern.search(prose):
            around = " ".join(prose[max(0, found.start() - 40) : found.end() + 40].split())
            yield f"{found.group().strip()!r} in {around!r}"


if __name__ == "__main__":
    listed = findings(*sys.argv[1:])
    print(*listed, f"{len(listed)} findings", sep="\n")
