"""Each command of the command line is answered, and what is wrong with one stays in the status line."""

from __future__ import annotations


def answers(desk) -> list[str]:  # type: ignore[no-untyped-def]
    """The lines since the last typed line."""
    typed = max(at for at, line in enumerate(desk.log) if line.startswith("> "))
    return list(desk.log[typed + 1 :])


async def type_and_wait(desk, typed: str) -> None:  # type: ignore[no-untyped-def]
    """Type a line and wait for the end of its command."""
    before = len(desk.log)
    await desk.type_line(typed)
    await desk.until(lambda: f"> {typed}" in desk.log[before:] and answers(desk), typed)
    await desk.idle()
    await desk.pilot.pause()


async def test_a_command_without_output_is_answered_with_done_in_the_status_line(work) -> None:  # type: ignore[no-untyped-def]
    async with work(language="pt") as desk:
        await desk.type_line("VAR a = 3")
        await desk.until(lambda: answers(desk) == ["Feito."], "the answer")
        await desk.idle()
        await desk.type_line("a = 5")
        await desk.until(lambda: desk.log.count("Feito.") == 2, "the answer again")

        assert desk.status.startswith(" Feito.")


async def test_the_status_line_keeps_what_is_wrong_until_the_next_answer(work) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        for typed, wrong in (
            ("xyzzy", "I do not know xyzzy."),
            ("IF a", "a comparison."),
            ("xyzzy plugh FWD", "I do not know xyzzy."),
        ):
            await type_and_wait(desk, typed)

            assert desk.status.startswith(f" {answers(desk)[0]}"), desk.log
            assert wrong in desk.status

        await desk.type_line("VAR a = 3")
        await desk.until(lambda: desk.status.startswith(" Done."), "the answer")


async def test_up_and_down_leave_the_line_that_is_being_typed_where_it_was(work) -> None:  # type: ignore[no-untyped-def]
    async with work() as desk:
        await type_and_wait(desk, "VAR a = 3")
        await desk.press(*"SPEAK", "down")
        assert desk.place.command_line.value == "SPEAK"

        await desk.press("up")
        assert desk.place.command_line.value == "VAR a = 3"
        await desk.press("down")
        assert desk.place.command_line.value == "SPEAK"


async def test_a_block_begun_at_the_command_line_gets_a_hint(work):
    async with work(language="pt") as desk:
        await desk.type_line("REPITA 2 VEZES")
        await desk.shows("Aqui um bloco é uma linha só, com FIM REPITA. Mais linhas vão no programa.")
        await desk.type_line("REPITA 2 VEZES PF 1 FIM REPITA")
        await desk.shows("Andei 1 passo para frente.")

        assert not any("não tem FIM REPITA" in line for line in desk.log)
