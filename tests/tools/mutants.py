"""Which small mistakes do the tests notice? ``make mutants SEED=1 COUNT=150``.

1. Runs the tests that need no other program once and writes down which test runs which line, in child
   processes too (coverage).
2. Draws COUNT mutations at random from all modules of the product.
3. Makes each of them in a copy of the repository and runs the tests that run its line until one fails or
   their time is over, the likeliest first; if all pass, mypy checks the types, as the check does.

A test notices a mutation if it fails, or doesn't end, twice with it, and passes without it. What can't change
what Donnie does isn't drawn; the rules are in ``mutations.py``, and nothing is left out by hand.

Why no ready tool: mutmut and cosmic-ray mutate everything or a hand-written list, neither draws a sample by a
seed; mutmut runs all in one process and misses what a child process does; cosmic-ray runs the same tests for
every mutation. coverage does the hard part here.
"""

from __future__ import annotations

import argparse
import ast
import difflib
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cache
from itertools import count, islice
from pathlib import Path
from queue import SimpleQueue

import pytest

from tests.architecture.house import modules, tracked
from tests.conftest import ROOT
from tests.tools.forked_tests import HASH_SEED, ForkedTests
from tests.tools.mutations import Mutation, mutations

FOLDER = ROOT / ".mutants"
REPORT = FOLDER / "report.txt"
CONFIG = Path(__file__).with_name("coverage.toml")
MOST_SECONDS = 60.0
"""Of a processor, for the tests of a mutation: a busy machine runs as many of them."""
_FEWEST_ANEW, _MOST_ANEW = 10, 600
"""Tests a mutation in a new process, which makes anew what is made once and kept."""
_TO_BEGIN = 0.05
"""Seconds of a test's setup and teardown, about."""
WANTED = 0.92
NO_END, NO_TESTS = "(no end)", "(no tests)"
"""In place of a test's name, if pytest doesn't end, or can't import what is tested."""
TYPES = "(types)"
"""In place of a test's name, if mypy noticed it."""


@dataclass(frozen=True, slots=True)
class Verdict:
    mutation: Mutation
    by: str
    """The test that noticed it, or ``TYPES``; empty if none did."""
    tests: int
    """How many run its line."""


def main() -> int:
    options = _options()
    maps = _maps()
    if options.map is not None or not maps:
        for old in () if options.map else maps:
            shutil.rmtree(old)
        write_map(FOLDER / f"map-{time.time_ns()}", *options.map or ())
    sample = draw(options.seed, options.count, options.below)
    print(f"{len(sample)} mutations, seed {options.seed}", flush=True)
    if not sample:
        return 0
    maps = [Map(each) for each in _maps()]
    return report(try_all(sample, maps, options.tests, options.jobs, options.seconds))


def _maps() -> list[Path]:
    return sorted(each.parent for each in FOLDER.glob(f"map-*/{_PASSED}"))


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=150)
    parser.add_argument(
        "--jobs", type=int, default=3 * (os.cpu_count() or 1), help="at a time; tests often wait"
    )
    parser.add_argument(
        "--seconds", type=float, default=MOST_SECONDS, help="of a processor, for the tests of a mutation"
    )
    parser.add_argument("--below", default="", metavar="PATH", help="only modules whose path begins so")
    parser.add_argument(
        "--tests",
        nargs="*",
        default=(),
        metavar="TESTS",
        help="try only these: a quick look at a few modules",
    )
    parser.add_argument(
        "--map",
        nargs="*",
        metavar="TESTS",
        help="write down anew which test runs which line; with names, of these tests only",
    )
    return parser.parse_args()


# --- which test runs which line


def write_map(folder: Path, *tests: str) -> None:
    """Runs the tests under coverage, or those that are named."""
    folder.mkdir(parents=True)
    command = [
        *_PYTEST, *_LEFT_OUT, "-n", str(2 * (os.cpu_count() or 1)), "--dist", "worksteal",
        "-p", "tests.tools.mutants", "--cov", "--cov-config", str(CONFIG), "--cov-context", "test",
        "--cov-report", "", *tests,
    ]  # fmt: skip
    environment = {
        **os.environ, "COVERAGE_FILE": str(folder / _COVERAGE), "MUTANTS_MAP": str(folder / _PASSED)
    }  # fmt: skip
    sources = {path: _source(path).decode() for path in modules()}
    (folder / _SOURCES).write_text(json.dumps(sources), encoding="utf-8")
    (folder / _ROOT).write_text(str(ROOT), encoding="utf-8")
    subprocess.run(command, cwd=ROOT, env=environment, check=False)


_COVERAGE, _PASSED, _SOURCES, _ROOT = "coverage", "passed.json", "sources.json", "root"

_LEFT_OUT = (
    *(
        "--ignore=tests/readers",
        "--ignore=tests/sound",
        "--ignore=tests/packaging",
        "--ignore=tests/architecture",
    ),
    *("--ignore=tests/contract/test_soak.py", "--ignore=tests/sessions/test_ssh.py"),
    *("--ignore=tests/tui/test_serve.py", "--ignore=tests/unit/i18n/test_phonemes.py"),
)
"""Tests with other programs, tests of the source's text, and one that takes long."""

_PYTEST = (sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--no-header", "--tb=line")

_OF_CHILDREN = "COVERAGE_PROCESS_CONFIG"

_seconds: dict[str, float] = defaultdict(float)
_failed: set[str] = set()


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Gives the child processes of a test its name: they begin to measure with what is in this variable."""
    from coverage.config import CoverageConfig

    settings = os.environ.get(_OF_CHILDREN)
    if settings is not None:
        of_children = CoverageConfig.deserialize(settings)
        of_children.context = item.nodeid
        os.environ[_OF_CHILDREN] = of_children.serialize()


def pytest_runtest_logreport(report: object) -> None:
    """As a plugin of the run that writes the map."""
    _seconds[report.nodeid] += report.duration  # type: ignore[attr-defined]
    if report.failed:  # type: ignore[attr-defined]
        _failed.add(report.nodeid)  # type: ignore[attr-defined]


def pytest_sessionfinish(session: object) -> None:
    if "MUTANTS_MAP" in os.environ and not hasattr(session.config, "workerinput"):  # type: ignore[attr-defined]
        passed = {name: round(took, 3) for name, took in _seconds.items() if name not in _failed}
        Path(os.environ["MUTANTS_MAP"]).write_text(json.dumps(passed), encoding="utf-8")


class Map:
    """Which test runs which line, by the lines of the modules that were there then."""

    def __init__(self, folder: Path) -> None:
        from coverage import CoverageData

        self.seconds: dict[str, float] = json.loads((folder / _PASSED).read_text(encoding="utf-8"))
        self._sources: dict[str, str] = json.loads((folder / _SOURCES).read_text(encoding="utf-8"))
        self._root = Path((folder / _ROOT).read_text(encoding="utf-8"))
        self._by_neighbours = {
            neighbours: (path, number)
            for path, text in self._sources.items()
            for number, neighbours in enumerate(_neighbours(text), start=1)
        }
        self._data = CoverageData(str(folder / _COVERAGE))
        self._data.read()
        self._lock = threading.Lock()

    def tests_of(self, mutation: Mutation) -> tuple[set[str], bool]:
        """The tests that run that line or use what it makes, by name, and whether an import runs it."""
        names = self._tests_at(mutation.path, mutation.line)
        is_imported = "" in names
        names |= {name for place in _uses_of(mutation) for name in self._tests_at(*place)}
        if names <= {""}:  # any test of the module may notice
            names |= {name for line in self._by_line(mutation.path).values() for name in map(_test_of, line)}
        return names, is_imported

    def _tests_at(self, path: str, line: int) -> set[str]:
        path, line = self._place_then(path, line)
        return {_test_of(each) for each in self._by_line(path).get(line, [])}

    def _by_line(self, path: str) -> dict[int, list[str]]:
        with self._lock:
            return self._data.contexts_by_lineno(str(self._root / path))

    def _place_then(self, path: str, line: int) -> tuple[str, int]:
        """Where a line was; if it has moved to another module, it has the same neighbours there."""
        text = _source(path).decode()
        then = _lines_then(self._sources.get(path, ""), text).get(line)
        if then is not None:
            return path, then
        neighbours = next(islice(_neighbours(text), line - 1, None), ("", "", ""))
        return self._by_neighbours.get(neighbours, (path, 0))


def _uses_of(mutation: Mutation) -> set[tuple[str, int]]:
    """The lines that use what the mutated line makes once and for all, also by way of other such things.

    That is a constant, a table, a field, or what a function with a cache returns.
    """
    found = set[tuple[str, int]]()
    waiting, names = [(mutation.path, mutation.line)], set[str]()
    while waiting:
        place = waiting.pop()
        for name in _made_once(place[0]).get(place[1], frozenset()) - names:
            names.add(name)
            new = _places_by_name().get(name, set()) - found
            found |= new
            waiting += new
    return found


@cache
def _made_once(path: str) -> dict[int, frozenset[str]]:
    """For each line of a module: the names of what is made there once."""
    found: dict[int, frozenset[str]] = {}
    waiting = list[ast.stmt](ast.parse(_source(path)).body)
    while waiting:
        names = set[str]()
        match waiting.pop():
            case ast.ClassDef(body=within):
                waiting += within
                continue
            case ast.FunctionDef(name=name, decorator_list=decorators) as each:
                if any("cache" in ast.unparse(decorator) for decorator in decorators):
                    names = {name}
            case (ast.Assign() | ast.AnnAssign()) as each:
                targets = each.targets if isinstance(each, ast.Assign) else [each.target]
                names = {node.id for one in targets for node in ast.walk(one) if isinstance(node, ast.Name)}
            case _:
                continue
        for line in range(each.lineno, (each.end_lineno or 0) + 1):
            found[line] = frozenset(names)
    return found


@cache
def _places_by_name() -> dict[str, set[tuple[str, int]]]:
    """The lines of all modules that read a name, alone or after a dot."""
    found: dict[str, set[tuple[str, int]]] = defaultdict(set)
    for path in modules():
        for node in ast.walk(ast.parse(_source(path))):
            match node:
                case ast.Name(id=name, ctx=ast.Load()) | ast.Attribute(attr=name, ctx=ast.Load()):
                    found[name].add((path, node.lineno))
    return found


def _neighbours(text: str) -> Iterator[tuple[str, str, str]]:
    """Each line with the one before and the one after."""
    lines = ["", *text.splitlines(), ""]
    return zip(lines, lines[1:], lines[2:], strict=False)


@cache
def _lines_then(old: str, new: str) -> dict[int, int]:
    """The number in the old text for the number of each line that the new text has kept."""
    if old == new:
        return {number: number for number in range(1, len(new.splitlines()) + 1)}
    same = difflib.SequenceMatcher(None, old.splitlines(), new.splitlines(), autojunk=False)
    return {
        there + each + 1: here + each + 1
        for here, there, number in same.get_matching_blocks()
        for each in range(number)
    }


def _test_of(context: str) -> str:
    """The test's name in a context: ``NAME|run``, or in a child process ``NAME (call)``."""
    return re.sub(r" \((setup|call|teardown)\).*$|\|(setup|run|teardown)$", "", context)


# --- the sample


def draw(seed: int, count: int, below: str = "") -> list[Mutation]:
    """From all mutations of all modules, each with the same chance."""
    chance = random.Random(seed)
    paths = [each for each in modules() if each.startswith(below)]
    every = [each for path in paths for each in mutations(path, _source(path).decode())]
    chance.shuffle(every)
    sample = []
    for each in every:
        if len(sample) == count:
            break
        if each.can_be_read(_source(each.path)):
            sample.append(each)
    return sample


def _source(path: str) -> bytes:
    return (ROOT / path).read_bytes()


# --- trying


def try_all(
    sample: Sequence[Mutation],
    maps: Sequence[Map],
    tests: Sequence[str] = (),
    jobs: int = 1,
    seconds: float = MOST_SECONDS,
) -> list[Verdict]:
    with tempfile.TemporaryDirectory(prefix="mutants-") as folder, ThreadPoolExecutor(jobs) as pool:
        trials: SimpleQueue[Trial] = SimpleQueue()
        copies = [_copy_of_the_repository(Path(folder) / str(number)) for number in range(jobs)]
        for each in pool.map(lambda copy: Trial(copy, maps, tests, seconds), copies):
            trials.put(each)

        def attempt(mutation: Mutation) -> Verdict:
            trial = trials.get()
            try:
                verdict = trial.of(mutation)
            finally:
                trials.put(trial)
            word = "killed  " if verdict.by else "SURVIVED"
            print(word, mutation, f"({verdict.tests} tests)", verdict.by, flush=True)
            return verdict

        verdicts = list(pool.map(attempt, sample))
        trial = trials.get()
        for at, each in enumerate(verdicts):
            if not (each.by or tests or trial.has_its_types(each.mutation)):
                print("killed  ", each.mutation, TYPES, flush=True)
                verdicts[at] = replace(each, by=TYPES)
        trial.close()
        for _ in range(jobs - 1):
            trials.get().close()
        return verdicts


def _copy_of_the_repository(folder: Path) -> Path:
    copy = folder / "donnie"
    folder.mkdir()
    for path in tracked():
        (copy / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / path, copy / path)
    if (ROOT.parent / "shared").exists():
        (folder / "shared").symlink_to((ROOT.parent / "shared").resolve())
    subprocess.run(["git", "init", "--quiet"], cwd=copy, check=True)
    if (ROOT / ".mypy_cache").exists():
        shutil.copytree(ROOT / ".mypy_cache", copy / ".mypy_cache")
    return copy


class Trial:
    """Makes mutations, one after the other, in a copy of the repository."""

    def __init__(self, copy: Path, maps: Sequence[Map], tests: Sequence[str], most_seconds: float) -> None:
        self._copy, self._maps, self._most_seconds = copy, maps, most_seconds
        self._warm = ForkedTests(copy, (*_LEFT_OUT, *tests))
        self._seconds = defaultdict(lambda: 0.1)
        for each in maps:
            self._seconds.update(each.seconds)
        self._mapped = frozenset(self._seconds)
        self._limits = {name: 30 + 10 * self._seconds[name] for name in self._warm.names}
        self._times = count(int(time.time()) - 1_000_000_000)

    def close(self) -> None:
        self._warm.close()

    def of(self, mutation: Mutation) -> Verdict:
        names, is_imported = self._tests_of(mutation)
        source = _source(mutation.path)
        self._write(mutation.path, mutation.applied(source))
        try:
            by = self._noticed(mutation, names, is_imported)
        finally:
            self._write(mutation.path, source)
        return Verdict(mutation, by, len(names))

    def _tests_of(self, mutation: Mutation) -> tuple[list[str], bool]:
        """Those that run its line, in their turn, and whether it runs while it is imported.

        Of the tests that no map has those may run it that are about its room.
        """
        found = [each.tests_of(mutation) for each in self._maps]
        run = {name for names, _ in found for name in names}
        unknown = {
            name for name in self._warm.names - self._mapped if _is_of_room(self._file(name), mutation)
        }
        chosen = self._in_turn(self._warm.names & self._mapped & run | unknown or self._warm.names, mutation)
        is_imported = any(each for _, each in found) or not _is_in_a_function(mutation)
        return chosen, is_imported

    def _file(self, name: str) -> Path:
        return self._copy / name.partition("::")[0]

    def _in_turn(self, names: Iterable[str], mutation: Mutation) -> list[str]:
        """The likeliest for its time first: short tests, and the shortest of each file before the others.

        A test comes earlier if its file names the module or is about its room, and if its name has words of
        the line, or of what its function is for.
        """
        line = _source(mutation.path).decode().splitlines()[mutation.line - 1]
        words = set(_WORD.findall(f"{line} {_purpose(mutation)}".lower()))
        files: dict[str, int] = defaultdict(int)
        turns = {}
        for name in sorted(names, key=lambda name: (self._seconds[name], name)):
            file, _, test = name.partition("::")
            files[file] += 1
            likely = 1 + len(words.intersection(_WORD.findall(test.lower())))
            if _names_module(self._file(name), mutation):
                likely *= 8
            elif _is_of_room(self._file(name), mutation):
                likely *= 4
            turns[name] = files[file] * (_TO_BEGIN + self._seconds[name]) / likely
        return sorted(turns, key=lambda name: (turns[name], self._seconds[name], name))

    def _noticed(self, mutation: Mutation, names: list[str], is_imported: bool) -> str:
        """The first test that fails each time with the mutation, and passes without it.

        A module that runs once more leaves what the tests have made of it as it was, and makes its classes a
        second time, for which tests fail without the mutation too: new processes try all tests again.
        """
        path, left = mutation.path, names
        by: str | None = None
        while left:
            by = self._first_failure(path, left, is_imported)
            if not by:
                break
            again = self._warm.has_no_end or self._first_failure(path, [by], is_imported)
            if again and self._passes_without(path, by, is_imported):
                return by
            left = left[left.index(by) + 1 :]
        return self._noticed_anew(path, names if is_imported or by is None else left[:_FEWEST_ANEW])

    def _noticed_anew(self, path: str, names: list[str]) -> str:
        """The same in new processes, which import everything."""
        while names:
            by, some = self._first_failure_anew(names)
            if not by:
                return ""
            if by not in self._warm.names:  # pytest itself fails: nothing can be imported, or it takes no end
                return by if self._can_be_run_without(path, some) else ""
            if self._first_failure_anew([by])[0] and self._passes_without(path, by):
                return by
            names = names[names.index(by) + 1 :]
        return ""

    def _first_failure(self, path: str, names: list[str], is_imported: bool) -> str | None:
        return self._warm.first_failure(
            self._copy / path, names, self._limits, is_imported=is_imported, seconds=self._most_seconds
        )

    def _passes_without(self, path: str, name: str, is_imported: bool = False) -> bool:
        file = self._copy / path
        mutated = file.read_bytes()
        self._write(path, _source(path))
        try:
            anew = file if is_imported else None
            return self._warm.first_failure(anew, [name], self._limits, is_imported=True) == ""
        finally:
            self._write(path, mutated)

    def _write(self, path: str, source: bytes) -> None:
        """With a time of its own, or Python takes what it compiled before from its cache."""
        file = self._copy / path
        file.write_bytes(source)
        moment = next(self._times)
        os.utime(file, (moment, moment))

    def _can_be_run_without(self, path: str, names: list[str]) -> bool:
        mutated = (self._copy / path).read_bytes()
        self._write(path, _source(path))
        try:
            by = self._failure_of_pytest(names)
            return not by or by in self._warm.names
        finally:
            self._write(path, mutated)

    def _first_failure_anew(self, names: list[str]) -> tuple[str, list[str]]:
        """In a new process, and the names that it was given: few files first, whose collection is short."""
        for some in (names[:_FEWEST_ANEW], names[_FEWEST_ANEW:_MOST_ANEW]):
            by = self._failure_of_pytest(some) if some else ""
            if by:
                return by, some
        return "", names

    def _failure_of_pytest(self, names: list[str]) -> str:
        listed = self._copy / ".tests"
        listed.write_text("\n".join(names), encoding="utf-8")
        environment = {**os.environ, "PYTHONPATH": str(self._copy), "PYTHONDONTWRITEBYTECODE": "1"}
        environment["PYTHONHASHSEED"] = HASH_SEED
        limits = [self._limits.get(each, 30.0) for each in names]
        command = [*_PYTEST, "-x", "-p", "no:xdist", f"--timeout={max(limits):.0f}", f"@{listed}"]
        process = subprocess.Popen(
            command, cwd=self._copy, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            text=True, start_new_session=True,
        )  # fmt: skip
        try:
            printed, _ = process.communicate(timeout=60 + min(sum(limits), 600))
        except subprocess.TimeoutExpired:  # while it is imported, or it is slow: it is tried alone
            os.killpg(process.pid, 9)
            process.communicate()
            return names[0] if len(names) == 1 else NO_END
        if process.returncode == 0:
            return ""
        failed = re.search(r"^(?:FAILED|ERROR) (.+?)(?: - |$)", printed, re.MULTILINE)
        return failed[1] if failed else NO_TESTS

    def has_its_types(self, mutation: Mutation) -> bool:
        """Whether mypy finds nothing wrong, as without the mutation."""
        source = _source(mutation.path)
        self._write(mutation.path, mutation.applied(source))
        mypy = [sys.executable, "-m", "mypy", "--cache-dir", ".mypy_cache"]
        try:
            return subprocess.run(mypy, cwd=self._copy, capture_output=True, check=False).returncode != 1
        finally:
            self._write(mutation.path, source)


_WORD = re.compile("[a-z]{4,}")


def _purpose(mutation: Mutation) -> str:
    """The name and the docstring of the innermost function with the line."""
    functions = [
        node
        for node in ast.walk(ast.parse(_source(mutation.path)))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        and node.lineno <= mutation.line <= (node.end_lineno or 0)
    ]
    innermost = max(functions, key=lambda node: node.lineno, default=None)
    return f"{innermost.name} {ast.get_docstring(innermost) or ''}" if innermost else ""


def _names_module(file: Path, mutation: Mutation) -> bool:
    """Whether the file of a test names the mutation's module."""
    return mutation.path.removesuffix(".py").replace("/", ".") in _modules_named_in(file)


def _is_of_room(file: Path, mutation: Mutation) -> bool:
    """Whether a test's file is in a folder called as that of the module, or names a module of that folder."""
    room = mutation.path.rpartition("/")[0].replace("/", ".")
    named = _modules_named_in(file)
    return room.rpartition(".")[2] in file.parts or any(f"{each}.".startswith(f"{room}.") for each in named)


@cache
def _modules_named_in(file: Path) -> frozenset[str]:
    """As it imports them: ``from a.b import c`` names ``a.b`` and ``a.b.c``."""
    found = set[str]()
    for node in ast.walk(ast.parse(file.read_bytes())):
        match node:
            case ast.Import(names=names):
                found |= {each.name for each in names}
            case ast.ImportFrom(module=str(module), names=names):
                found |= {module, *(f"{module}.{each.name}" for each in names)}
    return frozenset(found)


def _is_in_a_function(mutation: Mutation) -> bool:
    """And not in a default of a parameter."""
    return any(first <= mutation.start < end for first, end in _bodies(mutation.path))


@cache
def _bodies(path: str) -> list[tuple[int, int]]:
    """The first and the last byte of each body of a function."""
    source = _source(path)
    starts = [0]
    for line in source.split(b"\n"):
        starts.append(starts[-1] + len(line) + 1)
    return [
        (starts[node.body[0].lineno - 1], starts[node.end_lineno or 0])
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]


# --- the report


def report(verdicts: Sequence[Verdict]) -> int:
    by_tests = sum(bool(each.by) and each.by != TYPES for each in verdicts)
    by_types = sum(each.by == TYPES for each in verdicts)
    lines = []
    for each in verdicts:
        if not each.by:
            old = _source(each.mutation.path)[each.mutation.start : each.mutation.end].decode()
            lines += [f"{each.mutation} ({each.tests} tests)", f"  - {old}", f"  + {each.mutation.text}"]
    share = (by_tests + by_types) / len(verdicts)
    lines.append(
        f"{by_tests} of {len(verdicts)} were noticed by tests, {by_types} more by types:"
        f" {share:.1%}; wanted {WANTED:.0%}"
    )
    REPORT.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(*lines, sep="\n")
    return int(share < WANTED)


if __name__ == "__main__":
    began = time.monotonic()
    code = main()
    print(f"{time.monotonic() - began:.0f} seconds")
    sys.exit(code)
