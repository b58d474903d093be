"""Ends sessions with SIGKILL at random moments. ``python -m tests.tools.sudden_end --seed 1 --count 100``.

Not part of the check. A learner types lines, saves, and runs the program, while everything is recorded: in
the linear mode, there also with a robot on a line, or in the full screen. The moment is in the middle of one
of these, which a ``Random`` made of the seed and the number of the case chooses. So ``--only NUMBER`` with
the same seed tries one case again, though never at quite the same moment.

Afterwards, on the disk: no line is lost that was entered more than two seconds before; the saved program is
one that was saved, whole; so is each copy; the recording has all that was printed, and at most its last line
is cut off; the settings can be read. The next start opens what is left. A robot on a line stands.
"""

from __future__ import annotations

import argparse
import random
import re
import signal
import tempfile
import time
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

import pexpect

from devices.board_simulator.board import SimulatedBoard
from donnie_tui.core.program_files import DocumentError
from donnie_tui.core.recording import Recording
from donnie_tui.core.recovery import read_copy
from tests.board_on_pty import PtyBoard
from tests.sessions.command import QUIET, donnie
from tests.sessions.learner import Learner
from tests.timeouts import TIMEOUT
from tests.tools.fuzz_screens import Screen

AT_MOST = 2.0
"""Seconds of typing that may be lost."""
PROGRAM, RECORDING = "work.gd", "a.rec"
SPEED = "20"
LONGEST_TYPED = 80
"""Characters of a line; a longer one is pasted into the full screen, as no learner types it in an instant."""
PAUSES = (0.0, 0.0, 0.01, 0.1, 0.5)
"""Seconds at most from the last key to the end."""


@dataclass(frozen=True)
class Case:
    """What is typed, and when it ends."""

    steps: tuple[str, ...]
    """The last one is the one that the end interrupts."""
    is_entered: bool
    """The last one, with Enter."""
    is_burst: bool
    """Nothing is waited for while lines are typed."""
    settles_after: int
    """After so many steps the learner thinks until the text is on the disk."""
    pause: float


@dataclass
class Typed:
    """What was entered, and what is known of it."""

    lines: list[str] = field(default_factory=list)
    seen: list[float] = field(default_factory=list)
    """When the prompt came after each line, as far as it did."""
    settled: int = 0
    """So many lines were on the disk once."""
    saved: list[str] = field(default_factory=list)
    """Each text that was to be saved."""
    printed: set[str] = field(default_factory=set)
    """Numbers that the program had printed when the prompt came."""
    partial: str = ""
    """What was typed of a last line without Enter; an editor has it at once."""

    @property
    def text(self) -> str:
        return as_text(self.lines)


def as_text(lines: list[str]) -> str:
    return "".join(f"{line}\n" for line in lines)


def made(seed: int, number: int) -> Case:
    chance = random.Random(f"{seed} sudden end {number}")
    steps = [_line(chance, at) for at in range(2)]
    for at in range(chance.randrange(2, 12)):
        kind = chance.randrange(6)
        steps.append("SAVE work" if kind == 0 else "RUN" if kind == 1 else _line(chance, at + 2))
    steps.append(chance.choice(("SAVE work", "RUN", _line(chance, 90), _line(chance, 91))))
    last, is_entered = steps[-1], chance.randrange(4) > 0
    steps[-1] = last if is_entered else last[: chance.randrange(len(last))]
    settles_after = chance.randrange(1, len(steps))
    pause = chance.random() * chance.choice(PAUSES)
    return Case(tuple(steps), is_entered, chance.randrange(3) == 0, settles_after, pause)


def _line(chance: random.Random, at: int) -> str:
    return chance.choice((f"SPEAK {1000 + at}", f"SPEAK {1000 + at}", "FW 1", f'SPEAK "{"long " * 60}"'))


MODES = ("linear", "robot", "screen")


def end_suddenly(case: Case, folder: Path, at_most: float = AT_MOST, mode: str = "linear") -> float:
    """Raises ``AssertionError``. How many seconds of typing were lost."""
    if mode == "screen":
        return _end_screen(case, folder, at_most)
    if mode == "linear":
        return _end_linear(case, folder, at_most)
    with PtyBoard(SimulatedBoard(boot_loader=0.1)) as robot:
        lost = _end_linear(case, folder, at_most, "--robot", f"serial:{robot.path}")
        until = time.monotonic() + TIMEOUT
        while robot.board.is_driving:
            assert time.monotonic() < until, "the robot drives on"
            time.sleep(0.01)
    return lost


def _end_linear(case: Case, folder: Path, at_most: float, *options: str) -> float:
    learner = Learner(folder, "--record", RECORDING, *options, speed=SPEED)
    try:
        learner.sees_prompt()
        typed = _type(case, learner, folder)
        time.sleep(case.pause)
        ended = time.monotonic()
    finally:
        learner.child.kill(signal.SIGKILL)
        learner.child.expect(pexpect.EOF)
        learner.child.wait()
        learner.child.close()
    return _check(typed, folder, ended, at_most)


def _type(case: Case, learner: Learner, folder: Path) -> Typed:
    typed = Typed()
    *whole, last = case.steps
    awaited = 0
    for number, step in enumerate(whole, 1):
        _note(typed, step)
        learner.types(f"{step}\r")
        awaited += 1
        if not case.is_burst or step in ("RUN", "SAVE work") or number == case.settles_after:
            _wait_for_prompts(learner, typed, awaited)
            awaited = 0
        if step == "RUN":
            typed.printed |= {*re.findall(r"SPEAK (1\d\d\d)", typed.text)}
        if number == case.settles_after:
            _until_kept(folder, typed)
    if case.is_entered:
        _note(typed, last)
    learner.types(last + "\r" * case.is_entered)
    return typed


def _end_screen(case: Case, folder: Path, at_most: float) -> float:
    screen = Screen(folder, "--record", RECORDING, speed=SPEED)
    try:
        screen.wait_until_loaded()
        typed = _type_on_screen(case, screen, folder)
        time.sleep(case.pause)
        ended = time.monotonic()
    finally:
        screen.kill()
        screen.close()
    return _check(typed, folder, ended, at_most)


def _type_on_screen(case: Case, screen: Screen, folder: Path) -> Typed:
    """A line counts from the moment when the screen has painted it: it reads keys long before."""
    typed, runs = Typed(), 0
    *whole, last = case.steps
    for number, step in enumerate(whole, 1):
        _note(typed, step)
        if step in ("RUN", "SAVE work"):
            _wait_for_painting(screen, typed)
        for keys in _keys_of(step, is_first_save=len(typed.saved) == 1):
            screen.press(keys)
        if not case.is_burst or number == case.settles_after:
            _wait_for_painting(screen, typed)
        if step == "RUN":
            runs += 1
            screen.read_while(lambda: _runs_in(folder / RECORDING) < runs)  # noqa: B023 -- is over in this turn
        if step == "SAVE work":
            screen.read_while(lambda: _saved_in(folder) != typed.text)
        if number == case.settles_after:
            screen.read_while(lambda: len(_kept(folder, typed)) < len(typed.text))
            typed.settled = len(typed.lines)
    if case.is_entered:
        _note(typed, last)
    elif not last.startswith(("R", "SAVE")):
        typed.partial = last
    if case.is_entered or typed.partial:
        for keys in _keys_of(last, is_first_save=len(typed.saved) == 1):
            screen.press(keys if case.is_entered else keys.rstrip("\r"))
    return typed


def _wait_for_painting(screen: Screen, typed: Typed) -> None:
    screen.read_until_quiet()
    typed.seen += [time.monotonic()] * (len(typed.lines) - len(typed.seen))


_F5, _CTRL_S = "\x1b[15~", "\x13"


def _keys_of(step: str, *, is_first_save: bool) -> tuple[str, ...]:
    if step == "RUN":
        return (_F5,)
    if step == "SAVE work":
        return (_CTRL_S, "work\r") if is_first_save else (_CTRL_S,)
    return (f"\x1b[200~{step}\x1b[201~", "\r") if len(step) > LONGEST_TYPED else (f"{step}\r",)


def _runs_in(recording: Path) -> int:
    return recording.read_bytes().count(b'"event":"run_ended"')


def _saved_in(folder: Path) -> str:
    file = folder / PROGRAM
    return file.read_text(encoding="utf-8") if file.exists() else ""


def _note(typed: Typed, step: str) -> None:
    if step == "SAVE work":
        typed.saved.append(typed.text)
    elif step != "RUN":
        typed.lines.append(step)


def _wait_for_prompts(learner: Learner, typed: Typed, count: int) -> None:
    for _ in range(count):
        learner.sees_prompt()
    typed.seen += [time.monotonic()] * (len(typed.lines) - len(typed.seen))


def _until_kept(folder: Path, typed: Typed) -> None:
    until = time.monotonic() + TIMEOUT
    while len(_kept(folder, typed)) < len(typed.text):
        assert time.monotonic() < until, "the text never reached the disk"
        time.sleep(0.01)
    typed.settled = len(typed.lines)


def _kept(folder: Path, typed: Typed) -> str:
    """The longest text on the disk. Each one must be the program as it once was."""
    once = {as_text(typed.lines[:count]) for count in range(len(typed.lines) + 1)}
    texts = [""]
    for copy in (folder / "state").rglob("unsaved-*.gd"):
        try:
            texts.append(as_text(read_copy(copy).text.splitlines()))
        except DocumentError:  # it was renamed or removed just now
            assert not copy.exists(), f"{copy.name} can't be read"
    if (folder / PROGRAM).exists():
        text = (folder / PROGRAM).read_text(encoding="utf-8")
        assert text in typed.saved, f"{PROGRAM} is no text that was saved: {text!r}"
        texts.append(text)
    for text in texts:
        is_begun = (typed.text + typed.partial).startswith(text.removesuffix("\n"))
        assert text in once or is_begun, f"on the disk is no text that was typed: {text!r}"
    return max(texts, key=len)


def _check(typed: Typed, folder: Path, ended: float, at_most: float) -> float:
    on_disk = _kept(folder, typed).splitlines()
    kept = sum(one == other for one, other in zip(on_disk, typed.lines, strict=False))
    assert kept >= typed.settled, f"{typed.settled} lines were on the disk, and {kept} are now"
    lost = ended - typed.seen[kept] if kept < len(typed.seen) else 0.0
    assert lost <= at_most, f"{lost:.1f} seconds are lost"
    _check_recording(folder / RECORDING, typed)
    for settings in (folder / "config").rglob("*.toml"):
        tomllib.loads(settings.read_text(encoding="utf-8"))
    _check_next_start(folder, typed, kept)
    return lost


def _check_recording(file: Path, typed: Typed) -> None:
    data = file.read_bytes()
    with file.open("rb") as opened:
        recording = Recording(opened)
        assert recording.header is not None
        assert recording.is_cut_off_only
        assert len(recording.events) >= data.count(b"\n") - 1, "the last line alone may be cut off"
    for number in typed.printed:
        assert f'"{number}"'.encode() in data, f"{number} was printed, and is not in the recording"


def _check_next_start(folder: Path, typed: Typed, kept: int) -> None:
    """A copy may be older than the file, if the end came between a save and the removal of the copy."""
    has_copy = any(each.stat().st_size for each in (folder / "state").rglob("unsaved-*.gd"))
    asked = ["RECOVER\nLIST\n"] * has_copy + ["OPEN work\nLIST\n"] * (folder / PROGRAM).exists()
    found = ""
    for lines in asked:
        done = donnie(folder, "--linear", *QUIET, typed=lines)
        said = (done.stdout + done.stderr).decode()
        assert "Traceback" not in said, said
        assert done.returncode in (0, 1), said
        found += said.replace("\n", " ")
    for line in typed.lines[:kept]:
        assert line.strip() in found, f"{line!r} is not recovered"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--mode", choices=MODES, default="linear")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--first", type=int, default=0, metavar="NUMBER", help="begin with this case")
    parser.add_argument("--only", type=int, metavar="NUMBER", help="try this one case")
    options = parser.parse_args()
    numbers = range(options.first, options.first + options.count)
    failed, tried, longest = 0, 0, 0.0
    for number in numbers if options.only is None else [options.only]:
        case = made(options.seed, number)
        tried += 1
        with tempfile.TemporaryDirectory() as folder:
            try:
                longest = max(longest, end_suddenly(case, Path(folder), mode=options.mode))
            except (AssertionError, pexpect.ExceptionPexpect) as problem:
                failed += 1
                print(f"{number} failed: {type(problem).__name__} {problem}\n{case}", flush=True)
                print(
                    f"Again: python -m tests.tools.sudden_end --mode {options.mode} --seed {options.seed}"
                    f" --only {number}",
                    flush=True,
                )
    print(
        f"{options.mode}, seed {options.seed}: {tried} ends, {failed} failed, "
        f"at most {longest:.2f} seconds lost",
        flush=True,
    )
    return 1 if failed else 0


if __name__ == "__main__":
    raise SystemExit(main())
