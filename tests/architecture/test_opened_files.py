"""One module opens the files that a learner can name: nothing leaves the folder of a confined session."""

from __future__ import annotations

import ast
from collections import Counter

from tests.architecture.house import modules, tree_of

OPENING = {"open", "read_text", "read_bytes", "write_text", "write_bytes", "fdopen"}
OWNERS = {"os", "io", "wave", "Image", "Path", "path", "file", "folder", "table"}
"""Names on which ``open`` opens a file; elsewhere it opens a page or a port."""

ALLOWED = {
    "donnie_tui/process/confinement.py": "the one that opens them",
    "donnie_tui/__main__.py": "the null device",
    "donnie_tui/cli/streams.py": "the null device",
    "donnie_tui/cli/page_server.py": "pages that come with Donnie",
    "donnie_tui/process/disconnection.py": "what the kernel says of processes and connections",
    "donnie_tui/core/recovery.py": "what the kernel says of a process",
    "donnie_tui/core/program_files.py": "a descriptor of the one that opens them",
    "donnie_tui/core/session_log.py": "a descriptor of the one that opens them",
    "donnie_tui/settings/folders.py": "by the one that opens them, in a confined session",
    "donnie_tui/tui/environment.py": "a text for the pager, which no confined session has",
    "donnie_tui/world/recorded.py": "names that were checked, in a folder of its own",
    "donnie_tui/i18n/first_words.py": "sentences that come with Donnie",
    "donnie_tui/i18n/translations.py": "the tool of translators",
    "sim/compiled_scene.py": "worlds that come with Donnie",
    "sim/worldfile/floor_plans.py": "a picture that was read already",
    "sim/worldfile/parser.py": "the grammar",
    "worlds/__init__.py": "programs that come with Donnie",
    "language/locales.py": "words of a language",
}
"""Modules that open something by themselves, and what."""


def opened_by(path: str) -> Counter[int]:
    """The lines on which a module opens a file by itself."""
    found = Counter[int]()
    for node in ast.walk(tree_of(path)):
        if not isinstance(node, ast.Call):
            continue
        match node.func:
            case ast.Name("open"):
                found[node.lineno] += 1
            case ast.Attribute(ast.Name(name), attribute) if attribute in OPENING and name in OWNERS:
                found[node.lineno] += 1
            case ast.Attribute(_, attribute) if attribute in OPENING - {"open"}:
                found[node.lineno] += 1
    return found


def test_only_one_module_opens_files_that_a_learner_can_name() -> None:
    rooms = ("donnie_tui/", "sim/", "worlds/", "language/")
    found = {path: [*opened_by(path)] for path in modules() if path.startswith(rooms) and opened_by(path)}

    assert {path: lines for path, lines in found.items() if path not in ALLOWED} == {}
    assert [path for path in ALLOWED if path not in found] == []
