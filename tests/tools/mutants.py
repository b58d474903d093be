"""Which small mistakes do the tests notice? ``make mutants SEED=1 COUNT=150``.

1. Runs the tests that need no other program once and writes down which test runs which line, in child
   processes too (coverage).
2. Draws COUNT mutations at random from all modules of the product.
3. Makes each of them in a copy of the repository and runs the tests that run its line; if all pass, mypy
   checks the types, as the check does.

Why no ready tool: mutmut and cosmic-ray mutate everything or a hand-written list, neither draws a sample by a
seed; mutmut runs all in one process and misses what a child process does; cosmic-ray runs the same tests for
every mutation. coverage does the hard part here.
"""

from __future__ import annotations

import argparse
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
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from queue import SimpleQueue

from tests.architecture.house import modules, tracked
from tests.conftest import ROOT
from tests.tools.mutations import Mutation, mutations

FOLDER = ROOT / ".mutants"
DATA, PASSED, REPORT = FOLDER / "coverage", FOLDER / "passed.json", FOLDER / "report.txt"
CONFIG = Path(__file__).with_name("coverage.toml")
MOST_SECONDS = 150.0
"""Of tests a mutation."""
WANTED = 0.92


@dataclass(frozen=True, slots=True)
class Verdict:
    mutation: Mutation
    by: str
    """The test that noticed it, or ``(types)``; empty if none did."""
    tests: int
    """How many run its line."""


def main() -> int:
    options = _options()
    FOLDER.mkdir(exist_ok=True)
    if options.map is not None or not PASSED.exists():
        write_map(*options.map or ())
    sample = draw(options.seed, options.count, options.below)
    print(f"{len(sample)} mutations, seed {options.seed}", flush=True)
    verdicts = try_all(sample, Map(), options.jobs)
    return report(verdicts)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=150)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--below", default="", metavar="PATH", help="only modules whose path begins so")
    parser.add_argument(
        "--map",
        nargs="*",
        metavar="TESTS",
        help="write down anew which test runs which line; of these tests only",
    )
    return parser.parse_args()


# --- which test runs which line


def write_map(*tests: str) -> None:
    """Runs the tests under coverage, or those that are named."""
    for old in FOLDER.glob("coverage*"):
        old.unlink()
    command = [
        *_PYTEST, *_LEFT_OUT, "-n", "auto", "--dist", "worksteal", "-p", "tests.tools.mutants",
        "--cov", "--cov-config", str(CONFIG), "--cov-context", "test", "--cov-report", "", *tests,
    ]  # fmt: skip
    environment = {**os.environ, "COVERAGE_FILE": str(DATA), "MUTANTS_MAP": str(PASSED)}
    subprocess.run(command, cwd=ROOT, env=environment, check=False)


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

_seconds: dict[str, float] = defaultdict(float)
_failed: set[str] = set()


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
    """The tests that run a line: the shortest of each file first, then the next of each."""

    def __init__(self) -> None:
        from coverage import CoverageData

        self._seconds: dict[str, float] = json.loads(PASSED.read_text(encoding="utf-8"))
        self._data = CoverageData(str(DATA))
        self._data.read()
        self._lock = threading.Lock()

    def tests_of(self, mutation: Mutation) -> list[str]:
        with self._lock:
            by_line = self._data.contexts_by_lineno(str(ROOT / mutation.path))
        contexts = by_line.get(mutation.line, [])
        names = {_test_of(each) for each in contexts}
        if "" in names:  # run while it was imported: any test of the module may notice
            names |= {_test_of(each) for line in by_line.values() for each in line}
        known = (
            names & self._seconds.keys() or self._seconds.keys()
        )  # a table that no test runs: any may notice
        chosen, seconds = [], 0.0
        for name in self._in_turn(known):
            seconds += self._seconds[name]
            if seconds > MOST_SECONDS:
                break
            chosen.append(name)
        return chosen

    def _in_turn(self, names: Iterable[str]) -> list[str]:
        files: dict[str, int] = defaultdict(int)
        turns = {}
        for name in sorted(names, key=self._seconds.__getitem__):
            file = name.partition("::")[0]
            turns[name] = files[file]
            files[file] += 1
        return sorted(turns, key=lambda name: (turns[name], self._seconds[name]))


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


def try_all(sample: list[Mutation], tests: Map, jobs: int) -> list[Verdict]:
    with tempfile.TemporaryDirectory(prefix="mutants-") as folder, ThreadPoolExecutor(jobs) as pool:
        copies: SimpleQueue[Path] = SimpleQueue()
        for number in range(jobs):
            copies.put(_copy_of_the_repository(Path(folder) / str(number)))

        def attempt(mutation: Mutation) -> Verdict:
            copy = copies.get()
            try:
                verdict = _tried(mutation, tests.tests_of(mutation), copy)
            finally:
                copies.put(copy)
            print("killed  " if verdict.by else "SURVIVED", mutation, f"({verdict.tests} tests)", flush=True)
            return verdict

        return list(pool.map(attempt, sample))


def _copy_of_the_repository(folder: Path) -> Path:
    copy = folder / "donnie"
    for path in tracked():
        (copy / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / path, copy / path)
    if (ROOT.parent / "shared").exists():
        (folder / "shared").symlink_to((ROOT.parent / "shared").resolve())
    subprocess.run(["git", "init", "--quiet"], cwd=copy, check=True)
    return copy


def _tried(mutation: Mutation, names: list[str], copy: Path) -> Verdict:
    source = _source(mutation.path)
    file = copy / mutation.path
    file.write_bytes(mutation.applied(source))
    try:
        by = _first_failure(names, copy) if names else ""
        if by and by != _TIMEOUT and by in names and not _first_failure([by], copy):
            rest = names[names.index(by) + 1 :]  # it failed by chance
            by = _first_failure(rest, copy) if rest else ""
        if not by and not _has_its_types(copy):
            by = "(types)"
        return Verdict(mutation, by, len(names))
    finally:
        file.write_bytes(source)


def _has_its_types(copy: Path) -> bool:
    mypy = [sys.executable, "-m", "mypy", "--cache-dir", ".mypy_cache"]
    return subprocess.run(mypy, cwd=copy, capture_output=True, check=False).returncode == 0


_TIMEOUT = "(no end)"


def _first_failure(names: list[str], copy: Path) -> str:
    """The first of these tests that fails in the copy; empty if all pass."""
    listed = copy / ".tests"
    listed.write_text("\n".join(names), encoding="utf-8")
    environment = {**os.environ, "PYTHONPATH": str(copy), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [*_PYTEST, "-x", "-p", "no:xdist", f"@{listed}"]
    process = subprocess.Popen(
        command, cwd=copy, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        start_new_session=True,
    )  # fmt: skip
    try:
        printed, _ = process.communicate(timeout=60 + 4 * MOST_SECONDS)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        process.communicate()
        return _TIMEOUT
    if process.returncode == 0:
        return ""
    failed = re.search(r"^(?:FAILED|ERROR) (.+?)(?: - |$)", printed, re.MULTILINE)
    return failed[1] if failed else "(no collection)"


# --- the report


def report(verdicts: list[Verdict]) -> int:
    killed = sum(bool(each.by) for each in verdicts)
    lines = []
    for each in verdicts:
        if not each.by:
            old = _source(each.mutation.path)[each.mutation.start : each.mutation.end].decode()
            lines += [f"{each.mutation} ({each.tests} tests)", f"  - {old}", f"  + {each.mutation.text}"]
    share = killed / len(verdicts)
    lines.append(f"{killed} of {len(verdicts)} were noticed: {share:.0%}; wanted {WANTED:.0%}")
    REPORT.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(*lines, sep="\n")
    return int(share < WANTED)


if __name__ == "__main__":
    began = time.monotonic()
    code = main()
    print(f"{time.monotonic() - began:.0f} seconds")
    sys.exit(code)
