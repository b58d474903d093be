"""The table of differences, ``differences.toml``, which may only become shorter.

``python -m tests.parity.table`` runs the net, takes out of the table what no longer differs, and prints what
differs and does not stand in it. ``--add`` puts that in, with the decision ``undecided``. Names of decisions,
or parts of cases, behind it choose what is run: ``python -m tests.parity.table busy "held: RUN"``.
"""

from __future__ import annotations

import asyncio
import sys
import tempfile
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from tests.parity.cases import GROUPS, Group
from tests.parity.compare import in_linear_mode, on_full_screen
from tests.parity.outcome import Outcome
from tests.parity.rules import is_same

FILE = Path(__file__).with_name("differences.toml")
MOST = 6
"""Lines of each outcome that the table shows."""


@dataclass(frozen=True)
class Difference:
    """A case in which the front ends differ, and the decision that will remove the difference."""

    case: str
    decision: str
    linear: tuple[str, ...]
    screen: tuple[str, ...]


def decisions() -> dict[str, str]:
    """The decisions by name."""
    found: dict[str, str] = tomllib.loads(FILE.read_text(encoding="utf-8"))["decision"]
    return found


def differences() -> dict[str, Difference]:
    """By case."""
    rows = tomllib.loads(FILE.read_text(encoding="utf-8")).get("difference", [])
    return {
        each["case"]: Difference(each["case"], each["decision"], tuple(each["linear"]), tuple(each["screen"]))
        for each in rows
    }


async def outcomes(group: Group, folder: Path) -> list[tuple[str, str, Outcome, Outcome]]:
    """Case, line, and its outcomes in the linear mode and on the full screen."""
    linear = in_linear_mode(group, folder / "linear")
    screen = await on_full_screen(group, folder / "screen")
    return list(zip(group.cases, group.lines, linear, screen, strict=True))


def shown(outcome: Outcome) -> tuple[str, ...]:
    """As the table has it."""
    lines = outcome.as_text()
    return (*lines[:MOST], f"... {len(lines)} lines") if len(lines) > MOST else lines


def written(found: dict[str, Difference], decided: dict[str, str]) -> str:
    """The whole table as text."""
    head = [
        "# Where the two front ends differ, and what is decided about it. See table.py.",
        "",
        "[decision]",
    ]
    head += [f"{name} = {_quoted(text)}" for name, text in decided.items()]
    rows: list[str] = []
    for each in found.values():
        rows += ["", "[[difference]]", f"case = {_quoted(each.case)}", f"decision = {_quoted(each.decision)}"]
        rows += [f"linear = {_list(each.linear)}", f"screen = {_list(each.screen)}"]
    return "\n".join([*head, *rows, ""])


def _list(lines: tuple[str, ...]) -> str:
    if len(lines) < 2:
        return f"[{''.join(map(_quoted, lines))}]"
    return "[\n" + "".join(f"    {_quoted(each)},\n" for each in lines) + "]"


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"').replace("\t", "\\t")
    return f'"{escaped}"'


async def _renew(folder: Path, about: Sequence[str], *, adds: bool) -> None:
    """Run the sessions that have such a case: ``about`` are decisions and parts of cases; none means all."""
    known = differences()
    found = dict(known)
    for number, group in enumerate(GROUPS):
        if about and not any(_is_about(case, known, about) for case in group.cases):
            continue
        for case, line, linear, screen in await outcomes(group, folder / str(number)):
            differs = not is_same(case, line, linear, screen)
            if not differs and found.pop(case, None):
                print(f"no longer differs: {case}")
            elif differs and case not in known:
                print(f"{'' if adds else 'NOT IN THE TABLE '}{case}\n  {shown(linear)}\n  {shown(screen)}")
                if adds:
                    found[case] = Difference(case, "undecided", shown(linear), shown(screen))
    used = {each.decision for each in found.values()}
    decided = {name: text for name, text in decisions().items() if name in used}
    FILE.write_text(written(found, decided), encoding="utf-8")


def _is_about(case: str, known: dict[str, Difference], about: Sequence[str]) -> bool:
    return any(each in case or (case in known and known[case].decision == each) for each in about)


if __name__ == "__main__":
    words = [each for each in sys.argv[1:] if each != "--add"]
    asyncio.run(_renew(Path(tempfile.mkdtemp()), words, adds="--add" in sys.argv))
