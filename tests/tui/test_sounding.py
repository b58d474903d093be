"""The voice and the sounds at the full screen: a key ends them, and settings count at once."""

from __future__ import annotations

from donnie_tui.audible import Audible


async def test_any_key_ends_what_is_being_said(work) -> None:  # type: ignore[no-untyped-def]
    """V3."""
    async with work() as desk:
        before = desk.app.work.donnie.audible.hushed
        await desk.press("x")
        assert desk.app.work.donnie.audible.hushed > before


async def test_quiet_is_answered_in_the_log(work) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        await desk.type_line("QUIET")
        await desk.told("Quiet. LAST says it again.")


async def test_cues_are_named_one_a_line(work) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        await desk.type_line("CUES")
        await desk.told("Sounds are off here.")
        await desk.told("forward: A step forward.")
        await desk.told("close: A block ends.")


async def test_what_is_chosen_about_the_voice_counts_at_once(work, tmp_path, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    """V6."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    async with work() as desk:
        desk.app.work.prefer("rate", "300")
        await desk.told("Words a minute: 300.")
        audible: Audible = desk.app.work.donnie.audible
        assert audible.settings.rate == 300
        desk.app.work.prefer("wait_for_speech", True)
        await desk.told("Programs wait for the voice: on.")
        assert audible.settings.wait_for_speech
