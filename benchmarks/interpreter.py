"""How fast programs run: ratios against the same program written in Python by hand.

    python benchmarks/interpreter.py [ROUNDS]

Each program and its counterpart are measured in turns, many times, by the time that their own thread had;
printed are the median of the ratios and how far the middle half of them spreads. 1 is as fast as by hand.
"Hooked" is the compilation that can be stepped; "to a line" runs it towards a line that it never reaches,
"traced" calls a function before each statement. Linking is counted in all of them. Never fails.
"""

from __future__ import annotations

import resource
import statistics
import sys
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from language.call_stack import raise_recursion_limit  # noqa: E402
from language.compiler import compile_program  # noqa: E402
from language.control import ExecutionControl  # noqa: E402
from language.diagnostics import Stopped  # noqa: E402
from language.parser import parse  # noqa: E402
from language.runtime import Memory, Runnable  # noqa: E402
from language.syntax import Program  # noqa: E402
from tests.unit.language_back.interpreter import interpreted_program  # noqa: E402
from tests.unit.language_back.recorder import Recorder  # noqa: E402

Work = Callable[[], object]


@dataclass(frozen=True)
class Pair:
    """A program, and the same by hand: Python's text that defines ``run``."""

    name: str
    program: str
    by_hand: str


LOOPS = Pair(
    "nested loops",
    """
VAR s = 0
FOR VAR i = 0; i < 700; i = i + 1 DO
  FOR VAR j = 0; j < 700; j = j + 1 DO
    s = s + i * j
  END FOR
END FOR
""",
    """
def run():
    s = 0
    for i in range(700):
        for j in range(700):
            s = s + i * j
""",
)
WHILES = Pair(
    "nested while",
    """
VAR s = 0 VAR i = 0 VAR j = 0
WHILE i < 500 DO
  j = 0
  WHILE j < 500 DO
    s = s + i * j
    j = j + 1
  END WHILE
  i = i + 1
END WHILE
""",
    """
def run():
    s = 0
    i = 0
    while i < 500:
        j = 0
        while j < 500:
            s = s + i * j
            j = j + 1
        i = i + 1
""",
)
FIB = Pair(
    "recursive fib",
    """
PROCEDURE FIB: n DO
  IF n >= 2 THEN
    FIB [n - 1]
    FIB [n - 2]
  END IF
END PROCEDURE
FIB [23]
""",
    """
def fib(n):
    if n >= 2:
        fib(n - 1)
        fib(n - 2)

def run():
    fib(23)
""",
)
PRIMES = Pair(
    "primes",
    """
VAR primes = 0 VAR d VAR prime
FOR VAR n = 2; n <= 12000; n = n + 1 DO
  d = 2
  prime = 1
  WHILE d * d <= n DO
    IF n - n / d * d == 0 THEN
      prime = 0
      d = n
    END IF
    d = d + 1
  END WHILE
  primes = primes + prime
END FOR
""",
    """
def run():
    primes = 0
    for n in range(2, 12001):
        d = 2
        prime = 1
        while d * d <= n:
            if n - n // d * d == 0:
                prime = 0
                d = n
            d = d + 1
        primes = primes + prime
""",
)
DOUBLING = Pair(
    "numbers that may reach the limit",
    """
VAR a VAR b VAR c
REPEAT 700 TIMES
  a = 0 b = 1
  REPEAT 300 TIMES
    c = a + b
    a = b
    b = c
  END REPEAT
END REPEAT
""",
    """
def run():
    for _ in range(700):
        a = 0
        b = 1
        for _ in range(300):
            c = a + b
            a = b
            b = c
""",
)
TARGETED = (LOOPS, FIB, PRIMES)
DEEP = Pair(
    "10 000 levels",
    "PROCEDURE P: n DO IF n > 0 THEN P [n - 1] END IF END PROCEDURE REPEAT 30 TIMES P [9998] END REPEAT",
    """
def p(n):
    if n > 0:
        p(n - 1)

def run():
    for _ in range(30):
        p(9998)
""",
)

STOPPED = {
    "empty loop": "WHILE 1 == 1 DO END WHILE",
    "counting loop": "VAR a WHILE a >= 0 DO a = a + 1 END WHILE",
    "recursion": "PROCEDURE P: n DO IF n > 0 THEN P [n - 1] P [n - 1] END IF END PROCEDURE P [60]",
    "15 000 levels": "PROCEDURE P: n DO IF n > 0 THEN P [n - 1] ELSE WHILE 1 == 1 DO END WHILE END IF "
    "END PROCEDURE P [15000]",
    "huge numbers": f"VAR a = {'9' * 4300} VAR b WHILE 1 == 1 DO b = a / 7 * 7 / 3 - a + a END WHILE",
    "WAIT": "REPEAT 1 TIMES WAIT 1000 END REPEAT",
    "FW": "FW 1000",
}


def program_of(text: str) -> Program:
    program = parse(text).program
    assert program is not None
    return program


def by_hand(pair: Pair) -> Work:
    names: dict[str, Work] = {}
    exec(pair.by_hand, names)
    return names["run"]


def running(runnable: Runnable, *, to_a_line: bool = False, traced: bool = False) -> Work:
    def work() -> None:
        control = ExecutionControl()
        if to_a_line:
            control.run_to(1_000_000)
        runnable.run(Recorder(), control, Memory(), trace=ignore if traced else None)

    return work


def ignore(line: int, column: int, depth: int) -> None:
    """A trace that does nothing."""


def ways(pair: Pair) -> dict[str, Work]:
    program = program_of(pair.program)
    hooked = compile_program(program, hooked=True)
    return {
        "fast": running(compile_program(program)),
        "hooked": running(hooked),
        "to a line": running(hooked, to_a_line=True),
        "traced": running(hooked, traced=True),
    }


def seconds(work: Work) -> float:
    start = time.thread_time()
    work()
    return time.thread_time() - start


def ratios(pair: Pair, works: dict[str, Work], rounds: int) -> dict[str, list[float]]:
    """For each way how fast it is compared with by hand, in each round."""
    hand = by_hand(pair)
    found: dict[str, list[float]] = {name: [] for name in works}
    for _ in range(rounds):
        reference = seconds(hand)
        for name, work in works.items():
            found[name].append(reference / seconds(work))
    return found


def spread(values: list[float]) -> str:
    quarter = max(1, len(values) // 4)
    ordered = sorted(values)
    return f"{statistics.median(values):5.2f} ({ordered[quarter - 1]:.2f} to {ordered[-quarter]:.2f})"


def print_speed(rounds: int) -> None:
    means: dict[str, list[float]] = {}
    for pair in (LOOPS, FIB, PRIMES, WHILES, DOUBLING):
        print(f"\n{pair.name}, by hand = 1")
        for name, values in ratios(pair, ways(pair), rounds).items():
            print(f"  {name:10} {spread(values)}")
            if pair in TARGETED:
                means.setdefault(name, []).append(statistics.median(values))
    print("\ngeometric mean of nested loops, fib and primes")
    targets = {"fast": ">= .75", "hooked": ">= .60", "to a line": ">= .40", "traced": "no target"}
    for name, values in means.items():
        print(f"  {name:10} {statistics.geometric_mean(values):5.2f} (target {targets[name]})")


def print_plain(rounds: int) -> None:
    print("\nthe plain back end, times slower than by hand")
    for pair in TARGETED:
        values = ratios(
            pair, {"interpreted": running(interpreted_program(program_of(pair.program)))}, max(1, rounds // 5)
        )
        print(f"  {pair.name:14} {1 / statistics.median(values['plain']):5.0f}")


def print_recursion(rounds: int) -> None:
    raise_recursion_limit()
    memory = bytes_a_level()
    fast = {"fast": running(compile_program(program_of(DEEP.program)))}
    times = [1 / ratio for ratio in ratios(DEEP, fast, rounds)["fast"]]
    print("\n10 000 levels of recursion")
    print(f"  memory     {memory:.0f} bytes a level (target <= 300)")
    print(f"  time       {spread(times)} times by hand (target <= 1.6)")


def bytes_a_level() -> float:
    """What a process needs more at the bottom of a recursion than before it; Linux only."""
    sizes: list[int] = []
    text = "PROCEDURE P: n DO IF n > 0 THEN P [n - 1] ELSE SPEAK n END IF END PROCEDURE SPEAK 0 P [9998]"
    actions = Recorder(before=lambda _: sizes.append(resident_bytes()))
    compile_program(program_of(text)).run(actions, ExecutionControl(), Memory())
    return (sizes[1] - sizes[0]) / 10_000


def resident_bytes() -> int:
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize()


class Waiting(Recorder):
    """A robot whose commands take time, at the control's pace."""

    def __init__(self, control: ExecutionControl, begun: threading.Event) -> None:
        super().__init__(before=lambda _: begun.set())
        self._control = control

    def wait(self, seconds: int) -> None:
        self._control.sleep(seconds)

    def forward(self, steps: int, command: str) -> None:  # noqa: ARG002 -- the port gives the text
        self._control.sleep(steps)


def milliseconds_to_stop(text: str) -> float:
    """From the request to the end of the program's run."""
    control, begun, ended = ExecutionControl(), threading.Event(), []
    program = compile_program(program_of(f"SPEAK 1 {text}"))

    def go() -> None:
        try:
            program.run(Waiting(control, begun), control, Memory())
        except Stopped:
            ended.append(time.perf_counter())

    thread = threading.Thread(target=go)
    thread.start()
    begun.wait()
    time.sleep(0.005)
    asked = time.perf_counter()
    control.stop()
    thread.join()
    return (ended[0] - asked) * 1000


def print_stopping(rounds: int) -> None:
    print("\nfrom a stop request to stopped, milliseconds: median, 99 of 100 (target 5)")
    for name, text in STOPPED.items():
        values = sorted(milliseconds_to_stop(text) for _ in range(4 * rounds))
        print(f"  {name:14} {statistics.median(values):6.2f} {values[int(len(values) * 0.99)]:6.2f}")


def main() -> None:
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 25
    print_speed(rounds)
    print_plain(rounds)
    print_recursion(rounds)
    print_stopping(rounds)


if __name__ == "__main__":
    main()
