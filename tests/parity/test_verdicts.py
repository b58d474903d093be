"""A program has the same verdict live in both front ends, from its file, in a folder and from a recording."""

from __future__ import annotations

from pathlib import Path

import pytest

from donnie_tui.cli.main import main
from tests.parity.cases import Group
from tests.parity.compare import in_linear_mode, on_full_screen

PROGRAMS = {
    "solved": ("FW 5\n", 0, "Solved, in 1 command."),
    "a step short": ("FW 4\n", 1, "0 of 1 goal. You stopped 1 step south of 0, 5."),
    "bumping": ("FW 40\n", 1, "0 of 1 goal. You stopped 8 steps north of 0, 5. You bumped 1 time."),
}


@pytest.mark.parametrize("name", PROGRAMS)
async def test_a_verdict_is_the_same_everywhere(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    text, code, verdict = PROGRAMS[name]
    group = Group("verdict", text, (), ("AGAIN",), world="challenge:first_walk")
    program, recording = tmp_path / "p.gd", tmp_path / "p.jsonl"
    program.write_text(text)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))

    (linear,) = in_linear_mode(group, tmp_path / "linear")
    (screen,) = await on_full_screen(group, tmp_path / "screen")
    main(["run", str(program), "--world", "challenge:first_walk", "--record", str(recording), "--lang", "en"])
    capsys.readouterr()
    codes = [
        main([*command, "--lang", "en"])
        for command in (
            ["run", "--challenge", "first_walk", str(program)],
            ["replay", str(recording), "--challenge", "first_walk"],
        )
    ]

    assert codes == [code, code]
    assert capsys.readouterr().out == f"p.gd: {verdict}\n{verdict}\n"
    assert [each for each in linear.published if each.startswith(verdict[:6])] == [verdict]
    assert [each for each in screen.published if each.startswith(verdict[:6])] == [verdict]


BOTH = """\
format = 1
world = "two_robots"
[en]
title = "T"
task = "Do."
[[goal]]
robots = ["alice", "bob"]
"""


async def test_robots_that_start_together_have_one_verdict(tmp_path: Path) -> None:
    """They are 30 steps apart, and their bodies are 3 steps wide."""
    file = tmp_path / "both.toml"
    file.write_text(BOTH, encoding="utf-8")
    group = Group("together", "FW 10\n", (), ("TOGETHER",), world=f"challenge:{file}")
    verdict = "0 of 1 goal. alice and bob come no nearer than 17 steps."

    (linear,) = in_linear_mode(group, tmp_path / "linear")
    (screen,) = await on_full_screen(group, tmp_path / "screen")

    assert [each for each in linear.published if "of 1 goal" in each] == [verdict]
    assert [each for each in screen.published if "of 1 goal" in each] == [verdict]
