"""Loading a user's world reports its slips, for example a robot that stands in a thing."""

from pathlib import Path

import pytest

import worlds.words
from donnie_tui.bootstrap import assemble
from donnie_tui.cli.main import main
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import Settings
from donnie_tui.world.loading import choose_world, remarks
from tests.sessions import command

HEAD = 'include "donnie.inc"\ninclude "things.inc"\n'
ANA = 'donnie( name "Ana" pose [ 0 0 0 90 ] )\n'


def remarks_on(folder: Path, text: str, language: str = "en") -> tuple[str, ...]:
    file = folder / "my.world"
    file.write_text(HEAD + text, encoding="utf-8")
    words = Words(language)
    return tuple(
        each.replace(str(file), "my.world") for each in remarks(choose_world(str(file), words), words)
    )


@pytest.mark.parametrize(
    ("text", "thing"),
    [
        ('box( name "a" )', "box a"),
        ("box( )", "box"),
        ('model( name "crate" )', "crate"),
        ('ball( name "red ball" pose [ 0.1 0 0 0 ] )', "red ball"),
        ("wall( pose [ 0 0.05 0 0 ] size [ 2 0.05 0.24 ] )", "wall"),
        ('donnie( name "Bob" pose [ 0.05 0 0 0 ] )', "donnie Bob"),
    ],
)
def test_a_robot_that_starts_inside_a_thing_is_reported(tmp_path: Path, text: str, thing: str) -> None:
    said = f"Robot Ana and {thing} begin at the same place. Move one of them."
    assert remarks_on(tmp_path, ANA + text) == (said,)


@pytest.mark.parametrize(
    "text",
    [
        "box( pose [ 0.15 0 0 0 ] )",
        "model( size [ 2 2 1 ] boundary 1 )",
        "model( size [ 2 2 0.01 ] obstacle_return 0 )",
        'donnie( name "Bob" pose [ 0.2 0 0 0 ] )',
    ],
)
def test_a_thing_around_a_robot_or_next_to_it_is_not_reported(tmp_path: Path, text: str) -> None:
    assert remarks_on(tmp_path, ANA + text) == ()


@pytest.mark.parametrize("name", worlds.names())
def test_no_robot_of_a_shipped_world_starts_inside_a_thing(name: str) -> None:
    report = choose_world(worlds.path(name), Words()).scene.report

    assert "starts-inside" not in {note.code for note in report.notes}


def test_an_unknown_colour_is_reported_when_the_world_is_loaded(tmp_path: Path) -> None:
    box = "box( pose [ 1 0 0 0 ] {} )"

    assert remarks_on(tmp_path, ANA + box.format('color "amarelo"')) == (
        "1 slip in the world. donnie world my.world --report lists it.",
    )
    assert remarks_on(tmp_path, ANA + box.format('colour "red" color "golden"'), "pt") == (
        "2 avisos sobre o mundo. donnie world my.world --report diz quais são.",
    )
    assert remarks_on(tmp_path, ANA + box.format('color "random"')) == ()


def test_many_robots_inside_things_are_counted(tmp_path: Path) -> None:
    *said, last = remarks_on(tmp_path, "".join(ANA.replace("Ana", f"r{each}") for each in range(6)))

    assert len(said) == 3
    assert last == "12 slips in the world. donnie world my.world --report lists them."


def test_both_front_ends_and_a_run_report_it_at_the_start(tmp_path: Path) -> None:
    remarks_on(tmp_path, ANA + "box( )")
    donnie = assemble(
        Settings(world=str(tmp_path / "my.world"), speech="off", sound=False), terminal=True, is_linear=False
    )
    donnie.close()

    assert donnie.notices.all[0].startswith("Robot Ana and box begin at the same place.")
    ran = command.donnie(tmp_path, "run", "-", "--world", "my.world", *command.QUIET, typed="FW 1")
    assert ran.stderr.startswith(b"Robot Ana and box begin at the same place.")


WORDS = """difficulty = "easy"
[en]
title = "The gym"
description = "A box is in the east.\\nIt is red."
task = "Walk to it."
[es]
title = "El gimnasio"
description = "Hay una caja al este."
task = "Ve hasta ella."
"""


@pytest.mark.parametrize(("language", "title"), [("en", "The gym"), ("es", "El gimnasio"), ("pt", "The gym")])
def test_a_file_next_to_a_user_world_gives_its_words(tmp_path: Path, language: str, title: str) -> None:
    (tmp_path / "my.toml").write_text(WORDS, encoding="utf-8")

    assert remarks_on(tmp_path, ANA) == ()
    about = choose_world(str(tmp_path / "my.world"), Words()).about(language)

    assert about is not None
    assert (about.title, about.difficulty) == (title, worlds.words.Difficulty.EASY)
    said = command.donnie(tmp_path, "world", "my.world", "--lang", language).stdout.decode()
    assert about.task in said
    assert said.startswith(f"my.world: {title}.\n")
    assert all(sentence in said.splitlines() for sentence in about.sentences)


@pytest.mark.parametrize(
    ("words", "remark"),
    [
        (WORDS.replace('task = "Walk', "task = 3 # "), "In my.toml en.task is missing or wrong"),
        (WORDS.replace("title =", "titel ="), "In my.toml en.title is missing or wrong"),
        (WORDS.replace("easy", "simple"), "In my.toml difficulty takes easy, medium or hard"),
        ("", "In my.toml en is missing or wrong"),
        ('en = "The gym"', "In my.toml en.title is missing or wrong"),
        (WORDS.replace('gym"', "gym"), "I can't read line 3 of my.toml"),
        ('a = "\0"', "I can't read line 1 of my.toml"),
        ("a = " + "[" * 50_000, "I can't read my.toml"),
        ("\udcff", "I can't read my.toml"),
        (WORDS + "#" * 100_000, "my.toml has more than 100 000 bytes"),
        (WORDS + "\n" + "a." * 40_000 + "a = 1", f"I can't read line {WORDS.count(chr(10)) + 2} of my.toml"),
    ],
    ids=range(11),
)
def test_unreadable_words_are_reported_and_the_world_loads(tmp_path: Path, words: str, remark: str) -> None:
    (tmp_path / "my.toml").write_bytes(words.encode(errors="surrogateescape"))

    assert remarks_on(tmp_path, ANA) == (f"{remark}, so the world has no description.",)
    assert choose_world(str(tmp_path / "my.world"), Words()).about("en") is None


def test_words_in_one_language_without_a_difficulty_are_enough(tmp_path: Path) -> None:
    (tmp_path / "my.toml").write_text(
        '[pt]\ntitle = "A sala"\ndescription = "Há uma caixa."\ntask = "Ache."\n'
    )

    assert remarks_on(tmp_path, ANA) == ()
    said = command.donnie(tmp_path, "world", "my.world", "--lang", "pt").stdout.decode().splitlines()
    assert said[:2] == ["my.world: A sala.", "Há uma caixa."]


def test_a_copy_of_a_shipped_world_keeps_its_words(tmp_path: Path) -> None:
    for suffix in (".world", ".toml"):
        file = Path(worlds.path("living_room")).with_suffix(suffix)
        (tmp_path / f"room{suffix}").write_bytes(file.read_bytes())

    copied = choose_world(str(tmp_path / "room.world"), Words())

    assert copied.about("pt") == worlds.words.about("living_room", "pt")
    assert remarks(copied, Words()) == ()


def test_the_report_says_that_pushed_things_never_turn(capsys: pytest.CaptureFixture[str]) -> None:
    assert [main(["world", name, "--report"]) for name in ("storehouse", "living_room")] == [0, 0]

    lines = capsys.readouterr().out.splitlines()
    assert [line for line in lines if "pushed" in line] == [
        "2 things can be pushed: always straight on, without turning."
    ]
