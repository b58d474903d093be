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


async def test_each_sound_has_a_volume_of_its_own_that_is_chosen_from_a_list(
    work, tmp_path, monkeypatch
) -> None:  # type: ignore[no-untyped-def]
    """C7."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    async with work() as desk:
        audible: Audible = desk.app.work.donnie.audible
        await desk.type_line("SET cue")
        await desk.until(lambda: "bump: A collision. Volume 100." in desk.screen, "the sounds")
        await desk.press(*"bump", "enter")
        await desk.until(lambda: "bump: A collision. Off." in desk.screen, "the volumes")
        await desk.press(*"off", "enter")
        await desk.told("Sounds, each: bump 0.")
        await desk.press("escape")
        await desk.until(lambda: desk.app.screen is desk.place, "the workplace")
        assert audible.settings.cues == {"bump": 0}

        await desk.type_line("SET cue open 40")
        await desk.told("Sounds, each: bump 0, open 40.")
        assert audible.settings.cues == {"bump": 0, "block-opened": 40}
        assert 'cues = "bump 0, block-opened 40"' in (tmp_path / "donnie" / "settings.toml").read_text()


async def test_what_is_typed_is_said_by_the_own_voice_where_that_is_chosen(
    work, tmp_path, monkeypatch
) -> None:  # type: ignore[no-untyped-def]
    """V5."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setattr(Audible, "echoes", property(lambda _: True))
    heard: list[str] = []
    monkeypatch.setattr(Audible, "echo", lambda _, text: heard.append(text))
    async with work() as desk:
        await desk.press("a")
        assert heard == []
        desk.app.work.prefer("key_echo", "characters")
        await desk.press("b", "backspace")
        assert heard == ["b.", "b."]
        desk.app.work.prefer("key_echo", "words")
        desk.place.command_line.focus()
        await desk.pilot.pause()
        await desk.press(*"FW 1", "enter")
        assert heard[2:] == ["FW", "1"]
