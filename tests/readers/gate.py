"""Prints what a reader makes of the long lesson: ``python -m tests.readers.gate yasr``.

The numbers are explained in ``hearing.py``; what was heard otherwise than it was printed follows.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

from tests.readers.hearing import score
from tests.readers.lesson import LONG
from tests.readers.reading import phases_of


def main() -> None:
    reader = sys.argv[1] if len(sys.argv) > 1 else "yasr"
    with tempfile.TemporaryDirectory(prefix="donnie-gate-") as folder:
        phases = phases_of(reader, LONG, Path(folder), ("--world", "living_room"))
    print(f"{reader}: {len(LONG)} commands  {score(phases)}")
    for phase in phases:
        if not phase.is_clean:
            print(f"not clean: {phase.command}")
            print(f"  printed: {' | '.join(phase.printed)}")
            print(f"  heard:   {' | '.join(phase.heard)}")


if __name__ == "__main__":
    main()
