"""The words that may stand at the cursor."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

import donnie_tui.core.completion as tested
from donnie_tui.core.completion import completion, next_line


def words(text: str, language: str = "en", colours: tuple[str, ...] | None = None) -> tuple[str, ...]:
    """The words for the place of the bar in the text, or for its end."""
    at = text.find("|")
    return completion(text.replace("|", ""), at if at >= 0 else len(text), language, colours).words


@pytest.mark.parametrize(
    ("text", "language", "first"),
    [
        ("REP", "en", "REPEAT"),
        ("rep", "en", "repeat"),
        ("VAR distance_left = 3\ndistance_l", "en", "distance_left"),
        ("REPI", "pt", "REPITA"),
        ("HABL", "es", "HABLAR"),
        ("COLOR r", "en", "RED"),
        ("PROCEDURE Square: n DO END PROCEDURE\nSq", "en", "Square"),
        ("IF 1 == 1 THEN REPEAT 3 TIMES\nFW 1\nEND", "en", "END REPEAT"),
        ("IF 1 == 1 THEN REPEAT 3 TIMES\nEND REPEAT\nEND", "en", "END IF"),
        ("REPITA 3 VEZES\nFI", "pt", "FIM REPITA"),
    ],
)
def test_the_likely_word_comes_first(text: str, language: str, first: str) -> None:
    assert words(text, language)[0] == first


@pytest.mark.parametrize(
    ("text", "offered"),
    [
        ("SPEAK D", ("DISTANCE",)),
        ("VAR distance_left = 3\nSPEAK D", ("distance_left", "DISTANCE")),
        ("VAR base = 2\nFW ", ("base", "DISTANCE", "COLOR", "POS", "POSITION")),
        ("REPEAT 4 T", ("TIMES",)),
        ("IF DISTANCE F < 5 ", ("THEN",)),
        ("PROCEDURE Square: side DO\nFW s", ("side",)),
        ("VAR d", ()),
        ("PROCEDURE D", ()),
        ("PROCEDURE Walk: a, d", ()),
        ("REPEAT 4 TIMES\nEND ", ("REPEAT",)),
        ("FOR VAR i = 1; i < 5; i = i + 1 DO\nEND FOR", ()),
        ("RIGHT ", ("TURN",)),
        ("EX", ()),
        ("QU", ()),
        ("END I", ()),
        ("REPEAT 4 TIMES\nEL", ()),
        ("IF 1 == 1 THEN\nEL", ("ELSE",)),
        ("WAIT 1\nnonsense here 3 4\nREPEAT 4 ", ("TIMES",)),
        ("-- remark\nREP", ("REPEAT",)),
        ("HELP QU", ("QUIT",)),
        ("FW 1\nHELP QU", ("QUIT",)),
        ("HELP\nQU", ()),
        ("FW 1\nnonsense ", ()),
        ("VAR distance = 1\nVAR d", ()),
        ("PROCEDURE dance DO END PROCEDURE\nPROCEDURE d", ()),
        ("PROCEDURE P: side DO END PROCEDURE\nPROCEDURE Q: s", ()),
        ("PROCEDURE P: side DO END PROCEDURE\nPROCEDURE Q: a, s", ()),
        ("PROCEDURE sum DO END PROCEDURE\nVAR side = 1\nFW s", ("side",)),
        ("PROCEDURE sudden DO END PROCEDURE\nVAR sunny = 1\nSU", ("sunny", "sudden")),
        ("PROCEDURE ii DO END PROCEDURE\nFOR VAR i = 1; i < 5; i", ()),
        ("FW nea|\nVAR nearest", ("nearest",)),
        ("VAR ac\u0327a\u0303o = 1\nFW a", ("ac\u0327a\u0303o",)),  # as some keyboards write accents
        ("PROCEDURE P: a, b DO\nEND PROCEDURE\nVAR side = 1\nP [1, si", ("side",)),
        ("PROCEDURE sudden DO END PROCEDURE\nVAR sunny = 1\nSPEAK su", ("sunny",)),
        ("P [1, sink]\nFW si", ()),
        ("PROCEDURE P: a sink DO\nFW si", ()),
        ("PROCEDURE scan DO\nSC", ("SCAN",)),
        ("VAR scan = 1\nFW sc", ()),
        ("sink\nVAR a = VAR\nFW si", ()),
        ("REPEAT 3 TIMES\nIF \nEND ", ()),
        ("VAR above = 1\nVAR abandon = 1\nFW ab|\nVAR abc", ("abandon", "above", "abc")),
    ],
)
def test_what_may_not_stand_there_is_not_offered(text: str, offered: tuple[str, ...]) -> None:
    """By the grammar in the manual."""
    assert words(text) == offered


@pytest.mark.parametrize("text", ["", "FW 1\n", "nonsense\n", "VAR a = 1\n"])
def test_on_an_empty_line_the_commonest_commands_come_first(text: str) -> None:
    found = words(text)

    assert found[:8] == ("FW", "TR", "TL", "BW", "SPEAK", "REPEAT", "IF", "VAR")
    assert found[8:12] == ("FOR", "WHILE", "PROCEDURE", "WAIT")
    assert found[12:16] == ("FORWARD", "RIGHT TURN", "LEFT TURN", "BACKWARD")
    assert [each for each in found if each in ("HELP", "RUN", "VIBRATE")] == ["VIBRATE", "HELP", "RUN"]
    assert not {"QUIT", "EXIT", "END IF", "ELSE", "THEN", "DO"} & set(found)


@pytest.mark.parametrize(
    ("text", "first"),
    [
        *((f"{word} ", ("1", "2", "3", "4", "5", "10", "45", "90")) for word in ("FW", "BW", "WAIT")),
        ("TR ", ("90", "45", "180", "30", "60", "120")),
        ("VAR a SPEAK ", ("a", "DISTANCE")),
        ("TL ", ("90", "45")),
        ("REPEAT ", ("1", "2")),
        ("PROCEDURE P: n DO\nEND PROCEDURE\nP [", ("1", "2")),
        ("IF ", ("DISTANCE",)),
        ("VAR a = 1\nIF ", ("a", "DISTANCE")),
        ("VAR a = 1\nIF a ", ("==", "<", ">", "<=", ">=", "<>")),
        ("PROCEDURE Square ", (":",)),
        ("IF DISTANCE F > ", ("1", "2")),
        ("VAR a ", ("=",)),
        ("VAR a = 1\na ", ("=",)),
        ("PROCEDURE SQUARE: side DO\nFW side\nEND PROCEDURE\nSQUARE ", ("[",)),
        ("FOR VAR i = 1 ", (";",)),
        ("VAR a\n", ("FW", "TR")),
        ("SPEAK ", ("DISTANCE",)),
        ("SPEAK DISTANCE ", ("F", "FR", "FL")),
        ("IF DISTANCE ", ("F", "FR", "FL")),
        ("IF DISTANCE F ", ("==", "<")),
        ("VAR a = ", ("1", "2")),
        ("FOR VAR i = ", ("1", "2")),
        ("FOR VAR i = 1; ", ("i",)),
        ("FOR VAR i = 1; i ", ("==", "<")),
        ("FOR VAR i = 1; i < ", ("1", "2")),
        ("FOR VAR i = 1; i < 5 ", (";",)),
        ("FOR VAR i = 1; i < 5; ", ("i",)),
        ("FOR VAR i = 1; i < 5; i ", ("=",)),
        ("FOR VAR i = 1; i < 5; i = ", ("i",)),
        ("FOR VAR i = 1; i < 5; i = i + ", ("1", "2")),
        ("FOR VAR i = 1; i < 5; i = i + 1 ", ("DO",)),
        ("FOR VAR i = 1; i < 5; i = i + 1 DO ", ("END FOR", "FW")),
        ("FOR VAR i = 1; i < 5; i = i + 1 DO\nFW i ", ("END FOR", "FW")),
        ("FOR VAR i = 1; i < 5; i = i + 1 DO\nFW i\nEND ", ("FOR",)),
        ("FOR VAR i = 1; i < 5; i = i + 1 DO\nFW i\nEND FOR ", ("FW",)),
        ("FW 3 ", ("FW", "TR")),
        ("REPEAT 4 TIMES ", ("END REPEAT", "FW")),
        ("RIGHT ", ("TURN",)),
        ("HELP ", ("FW", "TR")),
    ],
)
def test_the_list_has_the_likelier_of_words_numbers_and_signs_first(
    text: str, first: tuple[str, ...]
) -> None:
    """By the forms in the manual."""
    listed = completion(text, len(text), "en").listed

    assert listed[: len(first)] == first
    assert len({*listed}) == len(listed)


def test_a_list_for_letters_has_the_words_alone_and_after_an_unknown_name_both_of_its_signs() -> None:
    assert completion("FW 1\nRE", 7, "en").listed == words("FW 1\nRE") != ()
    assert completion("walk ", 5, "en").listed[:2] == ("=", "[")


@pytest.mark.parametrize(
    ("text", "language", "first"),
    [
        ("PARA CRIAR i = 1; i < 5; i = i + 1 FAÇA\nPF i\nFIM PARA ", "pt", "PF"),
        ("PARA CREAR i = 1; i < 5; i = i + 1 HACER\nAV i\nFIN PARA ", "es", "AV"),
        ("PF 3 ", "pt", "PF"),
        ("AV 3 ", "es", "AV"),
        ("GD ", "pt", "90"),
        ("GI ", "es", "90"),
        ("FALAR DISTÂNCIA ", "pt", "F"),
        ("HABLAR DISTANCIA ", "es", "F"),
        ("PARA CRIAR i = 1 ", "pt", ";"),
        ("PARA CREAR i = 1 ", "es", ";"),
        ("REPITA 4 VEZES ", "pt", "FIM REPITA"),
        ("REPITA 4 VEZES PF 1 ", "pt", "FIM REPITA"),
    ],
)
def test_in_each_language_the_list_begins_with_what_a_learner_writes_there(
    text: str, language: str, first: str
) -> None:
    assert completion(text, len(text), language).listed[0] == first


@pytest.mark.parametrize(
    "text", ["END FOR ", "FW 3 ", "VAR a ", "VAR a = 1 ", 'SPEAK "a" ', "SPEAK DISTANCE "]
)
def test_a_semicolon_between_commands_is_listed_last(text: str) -> None:
    listed = completion(text, len(text), "en").listed

    assert listed.index(";") == len(listed) - 1


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("VAR a = 1\na ", "["),
        ("PROCEDURE P: n DO\nEND PROCEDURE\nP ", "="),
        ("VAR a\n", "="),
        ("FW 1 ", "="),
        ("END ", ";"),
        ("VAR ", ";"),
        ("REPEAT ", ";"),
        ("RIGHT ", ";"),
    ],
)
def test_no_sign_is_listed_that_can_not_follow(text: str, wrong: str) -> None:
    assert wrong not in completion(text, len(text), "en").listed


def test_only_names_of_the_head_of_a_procedure_are_its_parameters() -> None:
    text = "PROCEDURE P: side, size DO\nP [side, sink]\nFW si"

    assert set(words(text)) == {"side", "size"}


@pytest.mark.parametrize(
    ("text", "first"),
    [
        ("FW 1\nnonsense\n", "FW"),
        ("REPEAT 4 TIMES\nnonsense\n", "END REPEAT"),
        ("nonsense\n  ", "FW"),
    ],
)
def test_after_a_line_that_is_no_command_a_new_line_begins(text: str, first: str) -> None:
    assert words(text)[0] == first


def test_no_more_than_fifty_words_are_offered() -> None:
    many = "".join(f"VAR a{number}\n" for number in range(60))

    assert words(f"{many}SPEAK a") == tuple(f"a{number}" for number in range(59, 9, -1))


@pytest.mark.parametrize(("characters", "found"), [(50_000, ("REPEAT",)), (50_001, ())])
def test_up_to_50_000_characters_are_read(characters: int, found: tuple[str, ...]) -> None:
    assert words("--".ljust(characters - len("\nREP")) + "\nREP") == found


def test_a_long_program_gets_no_suggestions_and_no_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tested, "LONGEST_CHECKED", 16)
    assert words("REPEAT 4 TIMES F")
    assert entered("  REPEAT 4 TIMES|") == ("  ", "    ", "  END REPEAT", False)

    monkeypatch.setattr(tested, "LONGEST_CHECKED", 15)
    assert words("REPEAT 4 TIMES F") == ()
    assert completion("REPEAT 4 TIMES F", 16, "en").typed == "F"
    assert entered("  REPEAT 4 TIMES|") == ("  ", "  ", "", False)


def test_an_open_block_is_ended_first_and_a_finished_one_last() -> None:
    assert words("REPEAT 4 TIMES\n")[:2] == ("END REPEAT", "FW")
    finished = words("REPEAT 4 TIMES\n|\nEND REPEAT")

    assert (finished[0], finished[-1]) == ("FW", "END REPEAT")


def test_in_portuguese_para_continues_as_a_movement() -> None:
    """It is FOR, too, which CRIAR follows."""
    assert words("PARA ", "pt") == ("FRENTE", "TRÁS", "CRIAR")


def test_only_possible_arguments_are_offered_after_a_keyword() -> None:
    assert set(words("BELT ")) == {"ON", "OFF"}
    assert "FW" not in words("SPEAK DISTANCE ")


def test_colours_that_the_robot_can_t_see_are_not_offered() -> None:
    assert words("COLOR ", colours=("red", "green")) == ("RED", "GREEN")
    assert words("DISTANCE F", colours=("red",)) == ("FR", "FL")


@pytest.mark.parametrize("text", ['SPEAK "re', "-- re", "FW 1 -- re"])
def test_nothing_is_offered_inside_texts_and_comments(text: str) -> None:
    assert words(text) == ()


def test_the_word_at_the_cursor_is_not_offered() -> None:
    assert "FW" not in words("FW")


@given(st.text(alphabet='FW rep"\n-[]:=é1', max_size=60), st.integers(0, 60))
def test_completion_accepts_any_text(text: str, at: int) -> None:
    found = completion(text, min(at, len(text)), "en")

    assert all(isinstance(each, str) and each for each in found.words)


# --- the next line


def entered(text: str, language: str = "en") -> tuple[str, str, str, bool]:
    """After the line with the bar."""
    lines = text.split("\n")
    row = next(at for at, line in enumerate(lines) if line.endswith("|"))
    lines[row] = lines[row][:-1]
    found = next_line(lines, row, language)
    return found.before, found.indent, found.end, found.doubled


@pytest.mark.parametrize(
    ("text", "language", "expected"),
    [
        ("FW 1|", "en", ("", "", "", False)),
        ("    FW 1|", "en", ("    ", "    ", "", False)),
        ("REPEAT 4 TIMES|", "en", ("", "  ", "END REPEAT", False)),
        ("REPEAT 4|", "en", ("", "", "", False)),
        ("IF DISTANCE F < 5 THEN|", "en", ("", "  ", "END IF", False)),
        ("repita 4 vezes|", "en", ("", "  ", "FIM REPITA", False)),
        ("REPITA 4 VEZES|", "pt", ("", "  ", "FIM REPITA", False)),
        ("REPEAT 4 TIMES|\nEND REPEAT", "en", ("", "  ", "", False)),
        ("REPEAT 4 TIMES FW 1 END REPEAT|", "en", ("", "", "", False)),
        ("REPEAT 4 TIMES\n  REPEAT 2 TIMES|\nEND REPEAT", "en", ("  ", "    ", "  END REPEAT", False)),
        ("REPEAT 4 TIMES|\nSPEAK 1", "en", ("", "  ", "", False)),
        ("REPEAT 4 TIMES\n  FW 1\n  END REPEAT|", "en", ("", "", "", False)),
        ("REPEAT 4 TIMES\n  FW 1\n  END REPEAT|\nEND REPEAT", "en", ("", "", "", True)),
        (
            "REPEAT 4 TIMES\n  REPEAT 2 TIMES\n    END REPEAT|\n  END REPEAT\nEND REPEAT",
            "en",
            ("  ", "  ", "", True),
        ),
        (
            "REPEAT 4 TIMES\n  REPEAT 2 TIMES\n  END REPEAT|\nEND REPEAT",
            "en",
            ("  ", "  ", "", False),
        ),
        ("IF 1 == 1 THEN\n  FW 1\n  ELSE|\nEND IF", "en", ("", "  ", "", False)),
        ("REPEAT 4 TIMES\n  |\nEND REPEAT", "en", ("", "  ", "", False)),
        ("REPEAT 4 TIMES\n  END REPEAT|\nFW 1\nEND REPEAT", "en", ("", "", "", False)),
        ("REPEAT 4 TIMES\n  END REPEAT|\nEND  Repeat", "en", ("", "", "", True)),
        ("FW 1\nREPEAT 2 TIMES|", "en", ("", "  ", "END REPEAT", False)),
        ("REPEAT 4 TIMES\n  FW 1|", "en", ("  ", "  ", "", False)),
        ("REPEAT 4 TIMES|\n\nSPEAK 1", "en", ("", "  ", "", False)),
        ("REPEAT 4 TIMES|\n\n", "en", ("", "  ", "END REPEAT", False)),
        ("IF 1 == 1 THEN\n  REPEAT 4 TIMES|\nEND IF", "en", ("  ", "    ", "  END REPEAT", False)),
        ("IF 1 == 1 THEN\n  REPEAT 4 TIMES|\n\nELSE\nEND IF", "en", ("  ", "    ", "  END REPEAT", False)),
        ("IF 1 == 1 THEN\n  REPEAT 4 TIMES|\n  END REPEAT\nEND IF", "en", ("  ", "    ", "", False)),
        ("REPEAT 4 TIMES|\nEND REPEAT\nREPEAT 2 TIMES", "en", ("", "  ", "", False)),
        ("PARA CRIAR i = 1; i < 5; i = i + 1 FAÇA|", "pt", ("", "  ", "FIM PARA", False)),
        ("IF 1 == 1 THEN\n  FW 1|\nEND IF", "en", ("  ", "  ", "", False)),
        ("IF 1 == 1 THEN\n  REPEAT 4 TIMES|\n  END REPEAT", "en", ("  ", "    ", "", False)),
    ],
)
def test_after_enter_the_next_line_is_indented_and_a_block_has_its_end(text, language, expected) -> None:
    assert entered(text, language) == expected
