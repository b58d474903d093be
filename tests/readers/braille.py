"""A braille display that logs its 40 cells: a client of BRLTTY's "virtual" driver.

Arguments: the socket, the log.
"""

from __future__ import annotations

import re
import socket
import sys
import time
from pathlib import Path

from tests.readers.voice import write

CELLS = 40
_QUOTED = re.compile(r"\\(?:X([0-9A-Fa-f]{2})|(.))")
_SHOWN = re.compile(r'Visual "(.*)"', re.DOTALL)


def main() -> None:
    line, log, last = connected(sys.argv[1]), Path(sys.argv[2]), ""
    line.sendall(f"Cells {CELLS} 1\n".encode())
    for each in line.makefile("r", encoding="utf-8", errors="replace"):
        found = _SHOWN.fullmatch(each.strip())
        if found is not None:
            shown = _QUOTED.sub(lambda code: chr(int(code[1], 16)) if code[1] else code[2], found[1]).rstrip()
            if shown != last:
                last = shown
                write(log, shown)


def connected(path: str) -> socket.socket:
    """BRLTTY takes a moment to listen."""
    for _ in range(100):
        line = socket.socket(socket.AF_UNIX)
        try:
            line.connect(path)
        except OSError:
            line.close()
            time.sleep(0.1)
        else:
            return line
    raise SystemExit("no BRLTTY")


if __name__ == "__main__":
    main()
