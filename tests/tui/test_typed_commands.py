"""Each command of the command line is answered, and what is wrong with one stays in the status line."""

from __future__ import annotations


def answers(screen) -> list[str]:  # type: ignore[no-untyped-def]
    """The lines since the last typed line."""
    typed = max(at for at, line in enumerate(screen.log) if line.startswith("> "))
    return list(screen.log[typed + 1 :])


async def type_and_wait(screen, typed: str) -> None:  # type: ignore[no-untyped-def]
    """Type a line and wait for the end of its command."""
    before = len(screen.log)
    await screen.type_line(typed)
    await screen.until(lambda: f"> {typed}" in screen.log[before:] and answers(screen), typed)
    await screen.idle()
    await screen.pilot.pause()


async def test_a_command_without_output_is_answered_with_done_in_the_status_line(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen(language="pt") as screen:
        await screen.type_line("VAR a = 3")
        await screen.until(lambda: answers(screen) == ["Pronto."], "the answer")
        await screen.idle()
        await screen.type_line("a = 5")
        await screen.until(lambda: screen.log.count("Pronto.") == 2, "the answer again")

        await screen.status_has(" Pronto.")


async def test_the_status_line_keeps_what_is_wrong_until_the_next_answer(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen() as screen:
        for typed, wrong in (
            ("xyzzy", "I do not know xyzzy."),
            ("IF a", "I need a comparison at the end."),
            ("xyzzy plugh FWD", "I do not know xyzzy."),
        ):
            await type_and_wait(screen, typed)

            await screen.status_has(f" {answers(screen)[0]}")
            await screen.status_has(wrong)

        await screen.type_line("VAR a = 3")
        await screen.until(lambda: screen.status.startswith(" Done."), "the answer")


async def test_up_and_down_leave_the_line_that_is_being_typed_where_it_was(open_screen) -> None:  # type: ignore[no-untyped-def]
    async with open_screen() as screen:
        await type_and_wait(screen, "VAR a = 3")
        await screen.press(*"SPEAK", "down")
        assert screen.main.command_line.value == "SPEAK"

        await screen.press("up")
        assert screen.main.command_line.value == "VAR a = 3"
        await screen.press("down")
        assert screen.main.command_line.value == "SPEAK"


async def test_a_block_begun_at_the_command_line_gets_a_hint(open_screen):
    async with open_screen(language="pt") as screen:
        await screen.type_line("REPITA 2 VEZES")
        await screen.shows("Aqui um bloco é uma linha só, com FIM REPITA. Mais linhas vão no programa.")
        await screen.type_line("REPITA 2 VEZES PF 1 FIM REPITA")
        await screen.shows("Andei 1 passo para frente.")

        assert not any("não tem FIM REPITA" in line for line in screen.log)


async def test_the_map_shows_what_is_built_at_once_and_quit_asks_about_it(open_screen, tmp_path):
    def things() -> dict[str, tuple[float, float]]:
        return {each.name: (each.x, each.y) for each in screen.main.map.scale.scene.things}

    async with open_screen(world="first_room") as screen:
        await type_and_wait(screen, "FW 2")
        await type_and_wait(screen, "PUT box red 4 6 AS treasure")
        assert things()["treasure"] == (4, 6)
        await type_and_wait(screen, "MOVE treasure 2 0")
        assert things()["treasure"] == (6, 6)
        assert screen.status == " Treasure, box, red: now at 6, 6. From the robot: 6 right, 4 ahead. "

        await type_and_wait(screen, "REMOVE ball")
        assert "ball" not in things()
        assert things()["treasure"] == (6, 6)

        await screen.press("ctrl+q")
        await screen.until(lambda: screen.app.screen is not screen.main, "the question")
        await screen.press("escape")
        await screen.shows("Not saved, so Donnie stays open.")
