"""Blocks of finished and unfinished texts."""

import pytest

from language.outline import OutlineItem, block_depth, open_block, outline


@pytest.mark.parametrize(
    ("source", "depth"),
    [
        ("", 0),
        ("FW 1", 0),
        ("REPEAT 2 TIMES", 1),
        ("repita 2", 1),
        ("REPEAT 2 TIMES FW 1 END REPEAT", 0),
        ("IF 1 == 1 THEN\nREPEAT 2 TIMES\n", 2),
        ("IF 1 == 1 THEN\nREPEAT 2 TIMES\nEND IF", 0),
        ("REPEAT 2 TIMES END", 1),
        ("REPEAT 2 TIMES END\n\nREPEAT", 0),
        ("REPEAT 2 TIMES END FOR", 1),
        ("END IF END IF", 0),
        ("REPEAT 2 TIMES END REPEAT END REPEAT", 0),
        ("REPEAT 2 TIMES END REPEAT END REPEAT REPEAT 2 TIMES", 1),
        ("IF 1 < 2 THEN REPEAT 2 TIMES END IF END REPEAT END IF", 0),
        ('SPEAK "IF', 0),
        ('SPEAK "\nIF"', 0),
        ("-- IF", 0),
        ("HELP IF", 0),
        ("$ IF ?", 1),
        ("PARA FRENTE 2", 0),
        ("PARA f = 0; f < 2; f = f + 1 FAÇA", 1),
    ],
)
def test_the_depth_is_the_number_of_open_blocks(source: str, depth: int) -> None:
    assert block_depth(source) == depth


def test_the_outline_has_every_block_with_its_lines() -> None:
    source = "PROCEDURE Vá: n FAÇA\nIF n > 0 THEN\nVá [n - 1]\nEND IF\nFIM APRENDER\n\nREPEAT 2 TIMES\nFW 1"

    assert outline(source) == (
        OutlineItem("PROCEDURE", "Vá", 1, 5, 0, True),
        OutlineItem("IF", "", 2, 4, 1, True),
        OutlineItem("REPEAT", "", 7, 8, 0, False),
    )


def test_an_end_closes_the_open_blocks_inside() -> None:
    assert outline("IF 1 == 1 THEN\nWHILE 1 < 2 DO\nEND IF", first_line=10) == (
        OutlineItem("IF", "", 10, 12, 0, True),
        OutlineItem("WHILE", "", 11, 12, 1, False),
    )


@pytest.mark.parametrize("source", ["PROCEDURE", "PROCEDURE\nFW 3", "PROCEDURE: a", "REPEAT n TIMES"])
def test_a_block_without_a_name_has_none(source: str) -> None:
    assert outline(source)[0].name == ""


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("", None),
        ("REPEAT 2 TIMES END REPEAT", None),
        ("\nREPEAT 2 TIMES", OutlineItem("REPEAT", "", 8, 8, 0, False)),
        ("IF 1 < 2 THEN\nWHILE 1 < 2 DO\nFW 1", OutlineItem("WHILE", "", 8, 9, 1, False)),
        ("IF 1 < 2 THEN\nWHILE 1 < 2 DO END WHILE\nFW 1", OutlineItem("IF", "", 7, 9, 0, False)),
        ("IF 1 < 2 THEN END IF\nPROCEDURE Go DO\n", OutlineItem("PROCEDURE", "Go", 8, 8, 0, False)),
    ],
)
def test_the_open_block_is_the_innermost_one_without_its_end(source: str, found: OutlineItem | None) -> None:
    assert open_block(source, first_line=7) == found


def test_an_else_in_two_words_opens_no_block() -> None:
    """So one END IF after it is enough."""
    assert block_depth("si 3 > 2 entonces\nhablar 1\nsi no") == 1
    assert block_depth("si 3 > 2 entonces\nhablar 1\nsi no\nhablar 2\nfin si") == 0
    assert block_depth("si 3 > 2 entonces hablar 1 si no hablar 2 fin si") == 0
    assert block_depth("si no > 2 entonces") == 1


@pytest.mark.parametrize(
    ("source", "depth"),
    [
        ("si 3 > 2 entonces\nsi", 2),  # nothing follows: a second block begins
        ("si 3 > 2 entonces\nsi x\n", 2),  # a name that is not NO
        ("si 3 > 2 entonces\nsi no > 2", 2),  # a condition of a variable that is called NO
        ("si 3 > 2 entonces\nsi 5\n", 2),
        ("si 3 > 2 entonces\nmientras no\n", 2),
        ("si 3 > 2 entonces\nsi no\n\nsi no\n", 1),
        ("si 3 > 2 entonces\nsi no hablar 1", 1),
        ("si 3 > 2 entonces\nsi no x\n", 2),
        ("si no\n", 1),  # outside of a block
        ("repetir 2 veces\nsi no\n", 2),
        ("si 3 > 2 entonces\nsi no repetir 2 veces", 2),  # the loop
        ("si 3 > 2 entonces\nsi no var a = 1", 1),
    ],
)
def test_only_if_and_no_alone_are_an_else_in_two_words(source: str, depth: int) -> None:
    assert block_depth(source) == depth
