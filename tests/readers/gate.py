"""Prints what a reader makes of the long lesson: ``python -m tests.readers.gate yasr``; with ``screen``
behind the reader's name, of a short one in the full screen's plain layout.

The numbers are explained in ``hearing.py``; what was heard otherwise than it was printed follows. Of BRLTTY
it tells of how many answers the last line stands on a display of 40 cells.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

from tests.readers.hearing import Phase, is_whole, score, shown
from tests.readers.lesson import LONG, OF_THE_SCREEN
from tests.readers.reading import AS_PROMPT, BRIEF, FULL_SCREEN, phases_of

OPTIONS = ("--world", "living_room")


def main() -> None:
    reader = sys.argv[1] if len(sys.argv) > 1 else "yasr"
    with tempfile.TemporaryDirectory(prefix="donnie-gate-") as folder:
        if "screen" in sys.argv[2:]:
            # the greeting is the whole screen, and belongs to no command
            tell_heard(reader, phases_of(reader, OF_THE_SCREEN, Path(folder), OPTIONS, mode=FULL_SCREEN)[1:])
        elif reader == "brltty":
            tell_shown(phases_of(reader, LONG, Path(folder), (*OPTIONS, *BRIEF), AS_PROMPT)[1:])
        else:
            tell_heard(reader, phases_of(reader, LONG, Path(folder), OPTIONS))


def tell_heard(reader: str, phases: list[Phase]) -> None:
    print(f"{reader}: {sum(map(bool, (each.command for each in phases)))} commands  {score(phases)}")
    for phase in phases:
        if not phase.is_clean:
            tell(phase)


def tell_shown(phases: list[Phase]) -> None:
    answered = [each for each in phases if each.printed]
    whole = sum(map(is_whole, answered))
    print(f"brltty: {sum(map(shown, answered))} of {len(answered)} answers shown, {whole} whole")
    for phase in answered:
        if not shown(phase):
            tell(phase)


def tell(phase: Phase) -> None:
    print(f"otherwise: {phase.command}")
    print(f"  printed: {' | '.join(phase.printed)}")
    print(f"  heard:   {' | '.join(phase.heard)}")


if __name__ == "__main__":
    main()
