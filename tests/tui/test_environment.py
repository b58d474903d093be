"""The terminal's normal screen: the end of the log after the end, and the pager."""

from contextlib import nullcontext

from donnie_tui.tui import environment


def test_the_last_twenty_lines_are_left_behind_in_their_order(capsys, monkeypatch):
    monkeypatch.delenv("TEXTUAL_DRIVER", raising=False)
    environment.print_last_lines([f"line {i}" for i in range(30)])

    assert capsys.readouterr().out.splitlines() == [f"line {i}" for i in range(10, 30)]


async def test_a_pager_that_can_not_be_run_is_reported_in_a_sentence(open_screen, monkeypatch, tmp_path):
    broken = tmp_path / "pager"
    broken.write_text("no program")
    broken.chmod(0o755)
    monkeypatch.setenv("PAGER", str(broken))
    async with open_screen() as screen:
        monkeypatch.setattr(screen.app, "suspend", nullcontext)
        await screen.type_line("LOG")
        await screen.shows("The log can't be shown: Exec format error. SAVE LOG writes it into a file.")
