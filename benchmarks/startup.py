"""How soon ``donnie --linear`` is there: to the first prompt, answer and line of a program.

Ratios, measured in one run and interleaved: the prompt against ``python -c pass``, the others against
``python -c "import lark"``. Times are from the start of the process; the median of several rounds. Then the
most memory that it ever had, with the living room, a walk included. Run: ``python benchmarks/startup.py``
"""

from __future__ import annotations

import os
import pty
import select
import statistics
import sys
import tempfile
import time
from pathlib import Path

ROUNDS = 21
PATIENCE = 60.0
QUIET = ("--linear", "--speech", "off", "--sound", "off", "--world", "living_room", "--speed", "max")
DONNIE = [str(Path(sys.executable).parent / "donnie"), *QUIET]


def main() -> None:
    """Measure and print."""
    names = ("python -c pass", "import lark", "first prompt", "first answer", "program that speaks", "walks")
    most_memory = 0
    seconds: dict[str, list[float]] = {name: [] for name in names}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(ROUNDS):
            seconds["python -c pass"].append(_until_exit([sys.executable, "-c", "pass"], folder))
            seconds["import lark"].append(_until_exit([sys.executable, "-c", "import lark"], folder))
            prompt, answer, _ = _until_prompt_and_answer(folder, b"WHERE", b"0, 0")
            seconds["first prompt"].append(prompt)
            seconds["first answer"].append(answer)
            _, answer, _ = _until_prompt_and_answer(folder, b"SPEAK 2000 + 22\r", b"\n2022")
            seconds["program that speaks"].append(answer)
            _, answer, memory = _until_prompt_and_answer(folder, b"FW 3 SPEAK 2000 + 22\r", b"\n2022")
            seconds["walks"].append(answer)
            most_memory = max(memory, most_memory)
    for name, measured in seconds.items():
        low, middle, high = statistics.quantiles(measured, n=4)
        print(f"{name}: {middle * 1000:.1f} ms ({low * 1000:.1f} to {high * 1000:.1f})")
    _print_ratio("first prompt / python -c pass", seconds["first prompt"], seconds["python -c pass"], "1.5")
    _print_ratio("first answer / import lark", seconds["first answer"], seconds["import lark"], "1.8")
    _print_ratio("speaks / import lark", seconds["program that speaks"], seconds["import lark"], "1.8")
    _print_ratio("walks and speaks / import lark", seconds["walks"], seconds["import lark"], "1.8")
    print(f"memory with the living room: {most_memory / 1e6:.1f} MB at most, target <= 45")


def _print_ratio(name: str, measured: list[float], reference: list[float], target: str) -> None:
    ratios = [one / other for one, other in zip(measured, reference, strict=True)]
    low, middle, high = statistics.quantiles(ratios, n=4)
    print(f"{name}: {middle:.2f} ({low:.2f} to {high:.2f}), target <= {target}")


def _until_exit(command: list[str], folder: str) -> float:
    began = time.perf_counter()
    child, terminal = _started(command, folder)
    os.waitpid(child, 0)
    seconds = time.perf_counter() - began
    os.close(terminal)
    return seconds


def _started(command: list[str], folder: str) -> tuple[int, int]:
    """A process on a terminal of its own: its number, and our end of the terminal."""
    own = {"XDG_STATE_HOME": folder, "XDG_CONFIG_HOME": folder, "TERM": "xterm", "DONNIE_TOUR": "off"}
    environment = {**os.environ, **own}
    child, terminal = pty.fork()
    if child == 0:
        os.execve(command[0], command, environment)
    return child, terminal


def _until_prompt_and_answer(folder: str, line: bytes, wanted: bytes) -> tuple[float, float, int]:
    """A line is typed as soon as the prompt is there; its answer needs everything to be loaded.

    The seconds until both, and the bytes that the process had at most.
    """
    began = time.perf_counter()
    child, terminal = _started(DONNIE, folder)
    _read_until(terminal, b"\n> ")
    prompt = time.perf_counter() - began
    os.write(terminal, line + b"\r")
    _read_until(terminal, wanted)
    answer = time.perf_counter() - began
    os.write(terminal, b"\x04")
    _, _, used = os.wait4(child, 0)
    os.close(terminal)
    return prompt, answer, used.ru_maxrss * (1 if sys.platform == "darwin" else 1024)


def _read_until(terminal: int, wanted: bytes) -> None:
    seen = b""
    while wanted not in seen:
        if not select.select([terminal], [], [], PATIENCE)[0]:
            sys.exit(f"{wanted!r} did not come, only {seen!r}")
        seen += os.read(terminal, 4096)


if __name__ == "__main__":
    main()
