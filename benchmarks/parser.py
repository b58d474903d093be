"""How fast GoDonnie is read: ratios against the standard library's tokenizer and against importing lark.

    python benchmarks/parser.py

Each pair is measured in turns, many times; printed are the median of the ratios and how far the middle half
of them spreads. Above 1 the first is faster in "text to tree", slower in the others. Never fails.
"""

from __future__ import annotations

import io
import os
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
import tokenize
from collections.abc import Callable
from functools import partial
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from language.formatter import formatted  # noqa: E402
from language.lexer import lex  # noqa: E402
from language.parser import parse  # noqa: E402

ROUNDS = 25
READY = "from language.parser import parse; parse('FW 1')"

PROGRAM = """\
-- walks a spiral and tells what it sees
PROCEDURE SPIRAL{n}: steps, max DO
  IF steps <= max THEN
    FW steps * 2 - 1
    TR 90
    SPIRAL{n} [steps + 1, max]
  ELSE
    SPEAK "done, and what a way"
  END IF
END PROCEDURE
VAR found{n} = 0
FOR VAR i = 0; i < 10; i = i + 1 DO
  found{n} = found{n} + COLOR red * (i - 2) / 3
  WHILE DISTANCE f > 3 DO
    FW 1
  END WHILE
END FOR
SPIRAL{n} [1, 8]
"""
TEXT = "".join(PROGRAM.format(n=n) for n in range(60))
PORTUGUESE = formatted(TEXT, "pt").text or ""


def seconds(work: Callable[[], object]) -> float:
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def cost(code: str, folder: str) -> float:
    """Of a fresh interpreter: instructions where valgrind counts them, else processor seconds."""
    environment = {**os.environ, "PYTHONPYCACHEPREFIX": folder}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    command = [sys.executable, "-c", code]
    if shutil.which("valgrind"):
        options = ["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"]
        command = ["valgrind", *options, *command]
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, cwd=ROOT, env=environment, check=True, capture_output=True, text=True)
    counted = re.search(r"I\s+refs:\s+([\d,]+)", done.stderr)
    if counted:
        return float(counted[1].replace(",", ""))
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def ratios(measure: Callable[[], float], against: Callable[[], float], rounds: int = ROUNDS) -> list[float]:
    return [measure() / against() for _ in range(rounds)]


def report(what: str, values: list[float], target: str) -> None:
    low, middle, high = statistics.quantiles(values, n=4)
    print(f"{what}: {middle:.2f} (middle half {low:.2f} to {high:.2f}), target {target}")


def python_tokens() -> object:
    return list(tokenize.generate_tokens(io.StringIO(TEXT).readline))


def main() -> None:
    tokenizer = lambda: seconds(python_tokens)  # noqa: E731
    for name, text in (("English", TEXT), ("Portuguese", PORTUGUESE)):
        faster = ratios(tokenizer, partial(seconds, partial(parse, text)))
        report(f"text to tree, {name}, against tokenize", faster, "at least 1.0")
    tokens = ratios(tokenizer, lambda: seconds(lambda: lex(TEXT)))
    report("text to tokens, English, against tokenize", tokens, "none")
    wrong = TEXT + "JUMP\n"
    slower = ratios(lambda: seconds(lambda: parse(wrong)), lambda: seconds(lambda: parse(TEXT)))
    report("a text with a mistake against one without", slower, "none")
    with tempfile.TemporaryDirectory() as folder:
        cost(f"{READY}; import lark", folder)  # compiles
        ready = ratios(lambda: cost(READY, folder), lambda: cost("import lark", folder), 5)
    report("grammar ready against importing lark, whole interpreter", ready, "at most 1.25")


if __name__ == "__main__":
    main()
