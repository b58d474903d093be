"""Prints how a reader reads the long lesson: ``python -m tests.readers.gate yasr``.

With ``screen`` after the name of the reader it is a short lesson in the full screen's plain layout.
The numbers are explained in ``scoring.py``. The answers that were spoken differently from the printed ones
follow. For BRLTTY it counts the answers with their last line on a display of 40 cells.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

from tests.readers.lesson import LONG, OF_THE_SCREEN
from tests.readers.reading import AS_PROMPT, BRIEF, FULL_SCREEN, phases_of
from tests.readers.scoring import Phase, is_whole, score, shown

OPTIONS = ("--world", "living_room")


def main() -> None:
    reader = sys.argv[1] if len(sys.argv) > 1 else "yasr"
    with tempfile.TemporaryDirectory(prefix="donnie-gate-") as folder:
        if "screen" in sys.argv[2:]:
            # the greeting is the whole screen, and belongs to no command
            print_spoken(
                reader, phases_of(reader, OF_THE_SCREEN, Path(folder), OPTIONS, mode=FULL_SCREEN)[1:]
            )
        elif reader == "brltty":
            print_shown(phases_of(reader, LONG, Path(folder), (*OPTIONS, *BRIEF), AS_PROMPT)[1:])
        else:
            print_spoken(reader, phases_of(reader, LONG, Path(folder), OPTIONS))


def print_spoken(reader: str, phases: list[Phase]) -> None:
    print(f"{reader}: {sum(map(bool, (each.command for each in phases)))} commands  {score(phases)}")
    for phase in phases:
        if not phase.is_clean:
            print_phase(phase)


def print_shown(phases: list[Phase]) -> None:
    answered = [each for each in phases if each.printed]
    whole = sum(map(is_whole, answered))
    print(f"brltty: {sum(map(shown, answered))} of {len(answered)} answers shown, {whole} whole")
    for phase in answered:
        if not shown(phase):
            print_phase(phase)


def print_phase(phase: Phase) -> None:
    print(f"otherwise: {phase.command}")
    print(f"  printed: {' | '.join(phase.printed)}")
    print(f"  heard:   {' | '.join(phase.heard)}")


if __name__ == "__main__":
    main()
