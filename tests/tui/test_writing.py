"""Writing a program: completion, marked and fixed mistakes, search and replace."""

import pytest

from donnie_tui.commands.settings import change
from donnie_tui.tui.screens.dialogs import Completions
from tests.tui.conftest import burst
from tests.tui.settings_files import kept

pytestmark = pytest.mark.slow

# --- words


async def test_ctrl_space_lists_the_words_and_enter_takes_one(open_screen):
    async with open_screen() as screen:
        await screen.press(*"REP", "ctrl+@")
        await screen.until(lambda: isinstance(screen.app.screen, Completions), "the list")
        assert "REPEAT" in screen.text
        await screen.press("enter")
        await screen.until(lambda: screen.main.editor.text == "REPEAT", screen.main.editor.text)


async def test_the_cursor_of_the_terminal_stands_on_the_chosen_word(open_screen):
    async with open_screen("FW 1 ") as screen:
        screen.main.editor.move_cursor((0, 5))
        await screen.press("ctrl+@")
        await screen.until(lambda: isinstance(screen.app.screen, Completions), "the list")
        await screen.press("down", "down")
        await screen.pilot.pause()
        x, y = screen.app.cursor_position
        option = screen.app.screen.list.get_option_at_index(2)

        assert screen.text.splitlines()[y][x:].startswith(str(option.prompt))


async def test_a_letter_goes_on_typing_and_leaves_the_list(open_screen):
    async with open_screen() as screen:
        await screen.press(*"RE", "ctrl+@")
        await screen.until(lambda: isinstance(screen.app.screen, Completions), "the list")
        await screen.press("P")
        await screen.until(lambda: screen.main.editor.text == "REP", "the letter")


async def test_what_is_typed_right_after_enter_comes_after_the_chosen_word(open_screen):
    async with open_screen() as screen:
        await screen.press(*"REP", "ctrl+@")
        await screen.until(lambda: isinstance(screen.app.screen, Completions), "the list")
        burst(screen, "enter", "space", *"4")
        await screen.until(lambda: screen.main.editor.text == "REPEAT 4", screen.main.editor.text)


async def test_a_list_that_is_answered_twice_closes_once(open_screen):
    """As a key and a click at the same moment may; a second answer would close what is under it."""
    async with open_screen() as screen:
        await screen.press(*"REP", "ctrl+@")
        await screen.until(lambda: isinstance(screen.app.screen, Completions), "the list")
        listed = screen.app.screen
        listed.dismiss(("REPEAT", ""))
        listed.dismiss(("REPLACE", ""))
        await screen.until(lambda: screen.main.editor.text == "REPEAT", screen.main.editor.text)
        assert screen.app.screen is screen.main


async def test_the_likely_word_is_shown_behind_the_cursor_and_taken_with_the_right_arrow(open_screen):
    async with open_screen() as screen:
        await screen.press(*"REPE")
        await screen.pilot.pause()
        assert screen.main.editor.suggestion == "AT"
        await screen.press("right")

        assert screen.main.editor.text == "REPEAT"


@pytest.mark.parametrize(
    "key", ["f5", "f7", "f12", "left right", "home end", "tab shift+tab", "f1 escape", "ctrl+k escape"]
)
async def test_what_is_not_typing_drops_the_offered_word(open_screen, key):
    """Then Right moves the cursor, and writes nothing into the program."""
    async with open_screen() as screen:
        await screen.press(*"FW", "space", *"1", "enter", *"REPE")
        await screen.pilot.pause()
        assert screen.main.editor.suggestion == "AT"
        await screen.press(*key.split())
        await screen.pilot.pause()
        await screen.press("right")

        assert screen.main.editor.text == "FW 1\nREPE"


@pytest.mark.parametrize("line", [0, 1], ids=["in another line", "after its letters"])
async def test_a_click_drops_the_offered_word(open_screen, line):
    async with open_screen() as screen:
        editor = screen.main.editor
        await screen.press(*"FW", "space", *"1", "enter", *"REPE")
        await screen.pilot.pause()
        assert editor.suggestion == "AT"
        await screen.pilot.click("#editor", offset=(editor.gutter_width + 4, line))
        await screen.pilot.pause()
        await screen.press("right")

        assert editor.text == "FW 1\nREPE"


async def test_steps_through_a_loop_write_nothing_into_it(open_screen):
    """WARD was offered after END FOR, and Right took it wherever a step had put the cursor."""
    text = "FW 1\nFOR VAR i = 0; i < 2; i = i + 1 DO\nFW 1\nTR 90\nEND FOR"
    async with open_screen(text[:-1]) as screen:
        screen.main.editor.go_to(5)
        await screen.press("end", "R")
        assert screen.main.editor.suggestion == ""
        screen.main.editor.suggestion = "WARD"
        for line in ("Line 1: ", "Line 2: ", "Line 3, "):
            await screen.press("f7")
            await screen.shows(line)
        await screen.press("right")
        await screen.pilot.pause()

        assert screen.main.editor.text == text


async def test_a_run_right_after_the_word_end_writes_nothing_after_it(open_screen):
    text = "REPEAT 4 TIMES FW 2 TR 90 END"
    async with open_screen() as screen:
        await screen.press(*("space" if each == " " else each for each in text))
        await screen.pilot.pause()
        assert screen.main.editor.suggestion
        await screen.press("f5")
        await screen.until(lambda: any(line.startswith("Error") for line in screen.log), "the mistake")
        await screen.press("right")
        await screen.pilot.pause()

        assert screen.main.editor.text == text


async def test_after_speak_one_letter_offers_what_can_be_spoken(open_screen):
    async with open_screen() as screen:
        await screen.press(*"SPEAK", "space", "D")
        await screen.pilot.pause()

        assert screen.main.editor.suggestion == "ISTANCE"


async def test_what_is_only_offered_is_underlined(open_screen):
    """By colour alone it would be typed text where there are no colours."""
    async with open_screen() as screen:
        await screen.press(*"REPE")
        await screen.pilot.pause()
        row = screen.main.editor.render_line(0)

        underlined = [each.text for each in row if each.style and each.style.underline]
        assert "".join(underlined) == "AT"


async def test_completion_can_be_switched_off_and_that_is_kept(open_screen, tmp_path):
    async with open_screen() as screen:
        change(screen.app.controller.ctx, "completion", "off")
        await screen.press(*"REPE")
        await screen.pilot.pause()

        assert screen.main.editor.suggestion == ""
        assert kept(tmp_path)["completion"] is False


# --- lines


@pytest.mark.parametrize("last", [(), tuple("END REPEAT"), ("down",)])
async def test_enter_indents_and_ends_a_block_however_it_is_left(open_screen, last):
    async with open_screen() as screen:
        keys = [*"REPEAT 4 TIMES", "enter", *"FW 2 TR 90", "enter"] if last != ("down",) else []
        keys = keys or [*"REPEAT 4 TIMES", "enter", *"FW 2 TR 90", "down", "end"]
        await screen.press(*("space" if each == " " else each for each in keys))
        await screen.press(*("space" if each == " " else each for each in last if each != "down"))
        if last:
            await screen.press("enter", *"BW")
        await screen.pilot.pause()
        expected = "REPEAT 4 TIMES\n  FW 2 TR 90\n" + ("END REPEAT\nBW" if last else "  \nEND REPEAT")

        assert screen.main.editor.text == expected


@pytest.mark.parametrize("key", ["f5", "f7", "ctrl+s"])
async def test_an_end_that_was_typed_is_no_second_one_when_a_key_follows_at_once(open_screen, key):
    async with open_screen() as screen:
        keys = [*"REPEAT 2 TIMES", "enter", *"FW 1", "enter", *"END REPEAT", key]
        await screen.press(*("space" if each == " " else each for each in keys))
        await screen.pilot.pause()

        assert screen.main.editor.text == "REPEAT 2 TIMES\n  FW 1\nEND REPEAT"
        if key == "f5":
            await screen.shows("The program is done.")
            assert not any("You changed the program" in line for line in screen.log)


async def test_in_the_plain_layout_enter_writes_nothing_but_a_line(open_screen):
    async with open_screen(plain=True) as screen:
        screen.main.editor.focus()
        await screen.pilot.pause()
        await screen.press(*"REPEAT", "space", "4", "space", *"TIMES", "enter")

        assert screen.main.editor.text == "REPEAT 4 TIMES\n"


async def test_enter_in_a_block_moves_the_breakpoints_below_it_and_can_be_undone(open_screen):
    text = "REPEAT 4 TIMES\n  FW 1\nEND REPEAT\nBW 1"
    async with open_screen() as screen:
        screen.load(text, frozenset({4}))
        screen.main.editor.move_cursor((1, 6))
        await screen.press("enter", *"BW")
        assert screen.main.editor.text == text.replace("FW 1", "FW 1\n  BW")
        assert screen.main.editor.breakpoints == {5}
        await screen.press("ctrl+z", "ctrl+z")

        assert screen.main.editor.text == text
        assert screen.main.editor.breakpoints == {4}


# --- mistakes


async def test_a_mistake_is_marked_with_its_sentence_while_the_learner_types(open_screen):
    async with open_screen(size=(120, 40)) as screen:
        await screen.press(*"FWD 3")
        await screen.until(lambda: "!1  FWD 3  ! I do not know FWD." in screen.text, "the mark")

        assert "Ctrl+T puts FW." in screen.status


async def test_a_long_mistake_and_its_key_are_whole_in_eighty_columns(open_screen):
    async with open_screen("REPEAT 4 TIMES FW 2 TR 90 END") as screen:
        await screen.until(lambda: screen.main.editor.mistakes, "the mark")
        await screen.painted()

        status = screen.text.splitlines()[-2]
        assert "END does not close REPEAT of line 1. Ctrl+T: END REPEAT." in status


async def test_one_key_fixes_a_mistake(open_screen):
    async with open_screen("FW 1\nREPEAT 2 TIMS FW 1 END REPEAT") as screen:
        await screen.press("ctrl+t")
        await screen.shows("Line 2: REPEAT 2 TIMES FW 1 END REPEAT")

        assert screen.main.editor.text == "FW 1\nREPEAT 2 TIMES FW 1 END REPEAT"
        assert screen.main.editor.mistakes == ()
        await screen.press("ctrl+z")
        assert "TIMS" in screen.main.editor.text


async def test_typing_continues_at_the_cursor_after_a_fix(open_screen):
    async with open_screen("") as screen:
        await screen.press(*"FW 1 TRR 90")
        await screen.press("ctrl+t")
        await screen.shows("Line 1: FW 1 TR 90")
        await screen.press("enter", *"FW 2")
        await screen.until(lambda: screen.main.editor.text == "FW 1 TR 90\nFW 2", screen.main.editor.text)


async def test_ctrl_z_names_the_undone_change_and_ctrl_y_redoes_it(open_screen):
    async with open_screen("FW 1\nFW 2") as screen:
        await screen.type_line("DELETE 1")
        await screen.shows("Line 1 is deleted.")
        screen.main.editor.focus()
        await screen.press("ctrl+z")
        await screen.shows("Line 1: FW 1")
        assert screen.main.editor.text == "FW 1\nFW 2"

        await screen.press("ctrl+y")
        await screen.shows("Line 1: FW 2")
        assert screen.main.editor.text == "FW 2"


async def test_a_mistake_without_a_fix_is_reported(open_screen):
    async with open_screen('SPEAK "x') as screen:
        await screen.press("ctrl+t")
        await screen.shows("I don't know what was meant.")


# --- the text as a whole


async def test_search_goes_to_the_next_place_and_round(open_screen):
    async with open_screen("FW 1\nTR 90\nfw 2") as screen:
        screen.main.editor.move_cursor((0, 1))
        await screen.type_line("SEARCH fw")
        await screen.until(lambda: screen.main.editor.line == 3, "the third line")
        await screen.type_line("SEARCH AGAIN")
        await screen.until(lambda: screen.main.editor.line == 1, "the first line")
        await screen.type_line("SEARCH XYZ")
        await screen.shows("XYZ is not in the program.")


async def test_the_line_that_was_found_stays_in_the_status_line_until_a_key_moves_on(open_screen):
    async with open_screen("FW 1\nTR 90\nfw 2") as screen:
        screen.main.editor.move_cursor((0, 1))
        await screen.type_line("SEARCH fw")
        await screen.until(lambda: screen.main.editor.line == 3, "the third line")
        await screen.shows("Line 3: fw 2")
        for _ in range(3):
            await screen.pilot.pause()
        assert "Line 3: fw 2." in screen.status
        await screen.press("up")
        await screen.until(lambda: "Line 3: fw 2." not in screen.status, "another line")


async def test_completions_are_listed_on_request_where_completion_is_off(open_screen, tmp_path):
    async with open_screen(completion=False) as screen:
        await screen.press(*"REPE")
        await screen.pilot.pause()
        assert screen.main.editor.suggestion == ""
        await screen.press("right")
        assert screen.main.editor.text == "REPE"
        await screen.press("ctrl+space")
        await screen.until(lambda: screen.app.screen is not screen.main, "the list")


@pytest.mark.parametrize("wanted", ["olá", "OLA"])
async def test_a_word_is_found_without_its_accents_and_selected_where_it_stands(open_screen, wanted):
    """Letters that are longer in capitals stand before it, and on its line."""
    async with open_screen('SPEAK "ßßß"\nSPEAK "ß Olá"') as screen:
        await screen.type_line(f"SEARCH {wanted}")
        await screen.shows('Line 2: SPEAK "ß Olá"')
        assert screen.main.editor.selected_text == "Olá"


async def test_a_missing_word_asks_for_no_replacement(open_screen):
    async with open_screen("FW 1") as screen:
        await screen.type_line("REPLACE BK")
        await screen.shows("BK is not in the program.")
        assert screen.app.screen is screen.main


async def test_replace_counts_and_is_one_thing_to_undo(open_screen):
    async with open_screen("FW 1 FW 2") as screen:
        await screen.type_line("REPLACE FW")
        await screen.answer("BW")
        await screen.shows("Replaced 2 times.")
        assert screen.main.editor.text == "BW 1 BW 2"
        await screen.type_line("UNDO")

        await screen.until(lambda: screen.main.editor.text == "FW 1 FW 2", "the text before")


async def test_format_and_translate_change_the_text(open_screen):
    async with open_screen("repeat 2 times fw 1 end repeat") as screen:
        await screen.type_line("FORMAT")
        await screen.shows("The program is tidy now.")
        assert screen.main.editor.text == "REPEAT 2 TIMES\n  FW 1\nEND REPEAT"
        await screen.type_line("TRANSLATE pt")
        await screen.until(lambda: "REPITA" in screen.main.editor.text, "the keywords")
        screen.load("FW FW")
        await screen.type_line("FORMAT")
        await screen.shows("There is a mistake in line 1")


async def test_several_programs_keep_their_texts_and_files(open_screen, tmp_path):
    (tmp_path / "one.gd").write_text("FW 1\n")
    async with open_screen(file=tmp_path / "one.gd") as screen:
        await screen.type_line("PROGRAMS")
        await screen.until(lambda: "another, empty program" in screen.text, "the list")
        await screen.press("end", "enter")
        await screen.shows("Now new program.")
        screen.main.editor.focus()
        await screen.press(*"FW 2")
        await screen.type_line("PROGRAMS")
        await screen.until(lambda: "one.gd, 1 line" in screen.text, "the list")
        assert "new program, 1 line, changed" in screen.text
        await screen.press("home", "enter")
        await screen.shows("Now one.gd.")
        assert screen.main.editor.text == "FW 1"

        workspace = screen.app.controller.workspace
        workspace.turn_to(workspace.documents[1])
        assert screen.main.editor.text == "FW 2"
        assert workspace.document.path is None


async def test_leaving_asks_for_each_program_that_is_not_saved(open_screen):
    async with open_screen() as screen:
        await screen.press(*"FW 1")
        workspace = screen.app.controller.workspace
        workspace.turn_to(workspace.add_document())
        await screen.press("ctrl+q")
        await screen.answer("no")
        await screen.until(lambda: not screen.app.is_running or screen.app._exit, "the end")


async def test_what_was_opened_lately_is_offered(open_screen, tmp_path):
    (tmp_path / "one.gd").write_text("FW 1\n")
    async with open_screen() as screen:
        await screen.type_line(f"OPEN {tmp_path / 'one.gd'}")
        await screen.shows("one.gd")
        await screen.type_line("RECENT")
        await screen.until(lambda: "Recent programs" in screen.text, "the list")

        assert ">one.gd," in screen.text


async def test_what_is_typed_at_once_after_a_fix_is_fixed_too(open_screen):
    """The cursor is at the end of the line, and a command that touches the number there is none."""
    async with open_screen("FWD 1") as screen:
        screen.main.editor.move_cursor((0, 5))
        await screen.press("ctrl+t")
        await screen.until(lambda: screen.main.editor.text == "FW 1", "the word that was meant")
        await screen.press(*"TR", "space", *"90", "ctrl+t")
        await screen.until(lambda: screen.main.editor.text == "FW 1 TR 90", "the blank")
