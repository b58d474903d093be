"""Writing a program: completion, marked and fixed mistakes, search and replace."""

import pytest

from donnie_tui.commands.settings import change
from donnie_tui.tui.screens.dialogs import Completions
from tests.tui.settings_files import kept


@pytest.fixture(autouse=True)
def own_settings(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


# --- words


async def test_ctrl_space_lists_the_words_and_enter_takes_one(work):
    async with work() as desk:
        await desk.press(*"REP", "ctrl+@")
        await desk.until(lambda: isinstance(desk.app.screen, Completions), "the list")
        assert "REPEAT" in desk.screen
        await desk.press("enter")
        await desk.until(lambda: desk.place.editor.text == "REPEAT", desk.place.editor.text)


async def test_the_cursor_of_the_terminal_stands_on_the_chosen_word(work):
    async with work("FW 1 ") as desk:
        desk.place.editor.move_cursor((0, 5))
        await desk.press("ctrl+@")
        await desk.until(lambda: isinstance(desk.app.screen, Completions), "the list")
        await desk.press("down", "down")
        await desk.pilot.pause()
        x, y = desk.app.cursor_position
        option = desk.app.screen.list.get_option_at_index(2)

        assert desk.screen.splitlines()[y][x:].startswith(str(option.prompt))


async def test_a_letter_goes_on_typing_and_leaves_the_list(work):
    async with work() as desk:
        await desk.press(*"RE", "ctrl+@")
        await desk.until(lambda: isinstance(desk.app.screen, Completions), "the list")
        await desk.press("P")
        await desk.until(lambda: desk.place.editor.text == "REP", "the letter")


async def test_the_likely_word_is_shown_behind_the_cursor_and_taken_with_the_right_arrow(work):
    async with work() as desk:
        await desk.press(*"REPE")
        await desk.pilot.pause()
        assert desk.place.editor.suggestion == "AT"
        await desk.press("right")

        assert desk.place.editor.text == "REPEAT"


async def test_what_is_only_offered_is_underlined(work):
    """By colour alone it would be typed text where there are no colours."""
    async with work() as desk:
        await desk.press(*"REPE")
        await desk.pilot.pause()
        row = desk.place.editor.render_line(0)

        underlined = [each.text for each in row if each.style and each.style.underline]
        assert "".join(underlined) == "AT"


async def test_completion_can_be_switched_off_and_that_is_kept(work, tmp_path):
    async with work() as desk:
        change(desk.app.controller.ctx, "completion", "off")
        await desk.press(*"REPE")
        await desk.pilot.pause()

        assert desk.place.editor.suggestion == ""
        assert kept(tmp_path)["completion"] is False


# --- mistakes


async def test_a_mistake_is_marked_with_its_sentence_while_the_learner_types(work):
    async with work(size=(120, 40)) as desk:
        await desk.press(*"FWD 3")
        await desk.until(lambda: "!1  FWD 3  ! I do not know FWD." in desk.screen, "the mark")

        assert "Ctrl+T puts FW." in desk.status


async def test_one_key_fixes_a_mistake(work):
    async with work("FW 1\nREPEAT 2 TIMS FW 1 END REPEAT") as desk:
        await desk.press("ctrl+t")
        await desk.shows("Line 2: REPEAT 2 TIMES FW 1 END REPEAT")

        assert desk.place.editor.text == "FW 1\nREPEAT 2 TIMES FW 1 END REPEAT"
        assert desk.place.editor.next_mistake is None
        await desk.press("ctrl+z")
        assert "TIMS" in desk.place.editor.text


async def test_typing_continues_at_the_cursor_after_a_fix(work):
    async with work("") as desk:
        await desk.press(*"FW 1 TRR 90")
        await desk.press("ctrl+t")
        await desk.shows("Line 1: FW 1 TR 90")
        await desk.press("enter", *"FW 2")
        await desk.until(lambda: desk.place.editor.text == "FW 1 TR 90\nFW 2", desk.place.editor.text)


async def test_ctrl_z_names_the_undone_change_and_ctrl_y_redoes_it(work):
    async with work("FW 1\nFW 2") as desk:
        await desk.type_line("DELETE 1")
        await desk.shows("Line 1 deleted.")
        desk.place.editor.focus()
        await desk.press("ctrl+z")
        await desk.shows("Line 1: FW 1")
        assert desk.place.editor.text == "FW 1\nFW 2"

        await desk.press("ctrl+y")
        await desk.shows("Line 1: FW 2")
        assert desk.place.editor.text == "FW 2"


async def test_a_mistake_without_a_fix_is_reported(work):
    async with work('SPEAK "x') as desk:
        await desk.press("ctrl+t")
        await desk.shows("I don't know what was meant.")


# --- the text as a whole


async def test_search_goes_to_the_next_place_and_round(work):
    async with work("FW 1\nTR 90\nfw 2") as desk:
        desk.place.editor.move_cursor((0, 1))
        await desk.type_line("SEARCH fw")
        await desk.until(lambda: desk.place.editor.line == 3, "the third line")
        await desk.type_line("SEARCH AGAIN")
        await desk.until(lambda: desk.place.editor.line == 1, "the first line")
        await desk.type_line("SEARCH XYZ")
        await desk.shows("XYZ is not in the program.")


async def test_the_line_that_was_found_stays_in_the_status_line_until_a_key_moves_on(work):
    async with work("FW 1\nTR 90\nfw 2") as desk:
        desk.place.editor.move_cursor((0, 1))
        await desk.type_line("SEARCH fw")
        await desk.until(lambda: desk.place.editor.line == 3, "the third line")
        await desk.shows("Line 3: fw 2")
        for _ in range(3):
            await desk.pilot.pause()
        assert "Line 3: fw 2." in desk.status
        await desk.press("up")
        await desk.until(lambda: "Line 3: fw 2." not in desk.status, "another line")


async def test_completions_are_listed_on_request_where_completion_is_off(work, tmp_path):
    async with work(completion=False) as desk:
        await desk.press(*"REPE")
        await desk.pilot.pause()
        assert desk.place.editor.suggestion == ""
        await desk.press("right")
        assert desk.place.editor.text == "REPE"
        await desk.press("ctrl+space")
        await desk.until(lambda: desk.app.screen is not desk.place, "the list")


@pytest.mark.parametrize("wanted", ["olá", "OLA"])
async def test_a_word_is_found_without_its_accents_and_selected_where_it_stands(work, wanted):
    """Letters that are longer in capitals stand before it, and on its line."""
    async with work('SPEAK "ßßß"\nSPEAK "ß Olá"') as desk:
        await desk.type_line(f"SEARCH {wanted}")
        await desk.shows('Line 2: SPEAK "ß Olá"')
        assert desk.place.editor.selected_text == "Olá"


async def test_a_missing_word_asks_for_no_replacement(work):
    async with work("FW 1") as desk:
        await desk.type_line("REPLACE BK")
        await desk.shows("BK is not in the program.")
        assert desk.app.screen is desk.place


async def test_replace_counts_and_is_one_thing_to_undo(work):
    async with work("FW 1 FW 2") as desk:
        await desk.type_line("REPLACE FW")
        await desk.answer("BW")
        await desk.shows("2 times replaced.")
        assert desk.place.editor.text == "BW 1 BW 2"
        await desk.type_line("UNDO")

        await desk.until(lambda: desk.place.editor.text == "FW 1 FW 2", "the text before")


async def test_format_and_translate_change_the_text(work):
    async with work("repeat 2 times fw 1 end repeat") as desk:
        await desk.type_line("FORMAT")
        await desk.shows("Laid out anew.")
        assert desk.place.editor.text == "REPEAT 2 TIMES\n  FW 1\nEND REPEAT"
        await desk.type_line("TRANSLATE pt")
        await desk.until(lambda: "REPITA" in desk.place.editor.text, "the keywords")
        desk.load("FW FW")
        await desk.type_line("FORMAT")
        await desk.shows("There is a mistake in line 1")


async def test_several_programs_keep_their_texts_and_files(work, tmp_path):
    (tmp_path / "one.gd").write_text("FW 1\n")
    async with work(file=tmp_path / "one.gd") as desk:
        await desk.type_line("PROGRAMS")
        await desk.until(lambda: "another, empty program" in desk.screen, "the list")
        await desk.press("end", "enter")
        await desk.shows("Now new program.")
        desk.place.editor.focus()
        await desk.press(*"FW 2")
        await desk.type_line("PROGRAMS")
        await desk.until(lambda: "one.gd, 1 line" in desk.screen, "the list")
        assert "new program, 1 line, changed" in desk.screen
        await desk.press("home", "enter")
        await desk.shows("Now one.gd.")
        assert desk.place.editor.text == "FW 1"

        workspace = desk.app.controller.workspace
        workspace.turn_to(workspace.documents[1])
        assert desk.place.editor.text == "FW 2"
        assert workspace.document.path is None


async def test_leaving_asks_for_each_program_that_is_not_saved(work):
    async with work() as desk:
        await desk.press(*"FW 1")
        workspace = desk.app.controller.workspace
        workspace.turn_to(workspace.add_document())
        await desk.press("ctrl+q")
        await desk.answer("no")
        await desk.until(lambda: not desk.app.is_running or desk.app._exit, "the end")


async def test_what_was_opened_lately_is_offered(work, tmp_path):
    (tmp_path / "one.gd").write_text("FW 1\n")
    async with work() as desk:
        await desk.type_line(f"OPEN {tmp_path / 'one.gd'}")
        await desk.shows("one.gd")
        await desk.type_line("RECENT")
        await desk.until(lambda: "Recent programs" in desk.screen, "the list")

        assert ">one.gd," in desk.screen
