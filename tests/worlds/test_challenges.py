"""Challenges as files: what ships is proven, and every mistake has its line."""

import csv
import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path
from typing import cast, get_args

import pytest
from msgspec.structs import fields

from donnie_tui import bootstrap
from donnie_tui.cli import programs
from donnie_tui.cli.main import main
from donnie_tui.cli.options import understand
from donnie_tui.core.describe import task_in_words
from donnie_tui.core.questions import TOLERANCES
from donnie_tui.i18n.words import Words
from donnie_tui.settings.settings import Settings
from donnie_tui.world.loading import choose_challenge
from language.locales import languages, table
from tests.traced_memory import traced
from worlds import challenges, scenarios
from worlds.challenges import (
    BadChallenge,
    ChallengeQuestion,
    ChallengeText,
    Goal,
    Heading,
    Limit,
    Never,
    Rules,
    Variant,
    degrees_of,
)

HEADING = "Donnie. Challenge: The first walk.\n"
GOOD = """\
format = 1
world = "first_room"

[en]
title = "T"
task = "Do."

[[goal]]
at = "ball"
within = 2

[[goal]]
said = "here"
"""


def read(folder: Path, text: str) -> challenges.Challenge:
    file = folder / "it.toml"
    file.write_text(text, encoding="utf-8")
    return challenges.read(file)


def test_each_file_is_a_step_of_a_ladder() -> None:
    files = sorted(each.stem for each in Path(challenges.LADDERS).glob("*.toml"))

    assert sorted(challenges.names()) == files
    assert all(challenges.ladders()[name] for name in files)


@pytest.mark.parametrize("name", challenges.names())
def test_a_shipped_challenge_is_proven(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["challenge", "test", name, "--lang", "en"]) == 0

    assert "the empty program does not" in capsys.readouterr().out


@pytest.mark.parametrize("name", challenges.names())
def test_a_shipped_challenge_is_short_in_every_language(name: str) -> None:
    found = challenges.find(name)

    assert set(found.texts) == set(languages())
    assert len({len(each.hint) for each in found.texts.values()}) == 1
    for text in found.texts.values():
        assert text.hint
        limit = found.rules.limit
        limits = sum(getattr(limit, each) is not None for each in limit.__struct_fields__)
        limits += bool(found.rules.words)
        assert len(text.sentences) + limits <= 4  # with its title and its world they are five
        assert all(line.endswith(".") for line in text.sentences)
        lines = (text.title, *text.sentences, *(each.text for each in text.hint))
        assert all(len(line) <= 80 for line in lines)


@pytest.mark.parametrize("name", challenges.names())
def test_a_hint_names_words_of_its_language(name: str) -> None:
    for language, text in challenges.find(name).texts.items():
        listed = [
            *cast("dict[str, object]", table(language, "keywords")["keywords"]).values(),
            *table(language, "commands").values(),
        ]
        listed += table("en", "commands").values()
        spellings = [spelling for words in listed if isinstance(words, list) for spelling in words]
        known = {word for spelling in spellings for word in spelling.casefold().split()}
        named = {word for each in text.hint for word in re.findall(r"\b[^\W\d_]{2,}\b", each.text)}
        procedures = {word for each in text.hint for word in re.findall(r"\b(\w+)(?:: \w| \[)", each.text)}
        wrong = {each for each in named - procedures if each.isupper() and each.casefold() not in known}
        assert wrong == set()


def test_a_variant_moves_things(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, program = tmp_path / "it.toml", tmp_path / "p.gd"
    file.write_text(GOOD.split("[[goal]]\nsaid")[0] + '[[variant]]\nthings = { "yellow ball" = [0, 6] }\n')
    program.write_text("FW DISTANCE F - 1")

    assert main(["challenge", "check", str(file), str(program), "--lang", "en"]) == 0
    assert "Solved" in capsys.readouterr().out


def test_the_task_of_each_scenario_is_a_challenge() -> None:
    sections = Path("docs/scenarios.md").read_text(encoding="utf-8").split("\n## ")
    found = (re.match(r"(\w+), .*?as\s+the\s+challenge\s+`(\w+)`", each, re.DOTALL) for each in sections)
    named = [each.groups() for each in found if each]

    assert {world for world, _ in named} == set(scenarios())
    assert all(challenges.find(name).rules.world == world for world, name in named)


def test_from_the_third_on_a_shipped_challenge_has_two_starts() -> None:
    for name in challenges.names()[2:]:
        assert len(challenges.find(name).rules.variant) >= 2, name


def test_the_task_says_the_limits() -> None:
    said = task_in_words(challenges.find("there_and_back"), Words("pt"))

    assert said[-2:] == ("No máximo 2 comandos.", "No máximo 16 passos.")


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "Use only FW, BW, TR, TL, SPEAK, POS."),
        ("pt", "Use só PF, PT, GD, GE, FALAR, POS."),
        ("es", "Usa solo AV, RE, GD, GI, HABLAR, POS."),
    ],
)
def test_the_task_says_the_words_that_are_allowed(language: str, said: str) -> None:
    assert task_in_words(challenges.find("say_what_you_see"), Words(language))[-1] == said


def test_a_challenge_that_ships_leaves_measuring_for_later(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The ball is for those who count steps; the first solution that measures is that of to_the_cone."""
    program = tmp_path / "p.gd"
    program.write_text("TR 90\nFW DISTANCE F - 1")

    assert main(["challenge", "check", "to_the_ball", str(program), "--lang", "en"]) == 1
    later = challenges.names().index("to_the_cone") + 1
    assert capsys.readouterr().out == f"p.gd: 1 of 1 goal. DISTANCE comes in challenge {later}.\n"


@pytest.mark.parametrize("name", ["first_walk", "1"])
def test_a_challenge_alone_begins_a_session_with_it(name: str) -> None:
    invocation = understand(["challenge", name, "--lang", "pt", "--linear"], Words("en"))

    assert (invocation.command, invocation.arguments.linear) == ("", True)
    assert invocation.options == {"lang": "pt", "world": f"challenge:{name}"}


def test_the_list_has_a_heading_for_each_ladder(capsys: pytest.CaptureFixture[str]) -> None:
    main(["challenge", "--lang", "es"])

    lines = capsys.readouterr().out.splitlines()
    assert lines[:2] == ["Primeros pasos", "1. first_walk: El primer paseo, fácil."]
    number = challenges.names().index("square") + 1
    heading = lines.index("Repeticiones y procedimientos")
    assert lines[heading + 1] == f"{number}. square: Un cuadrado, fácil."


@pytest.mark.parametrize(
    ("old", "new", "code", "line"),
    [
        ("within", "wihtin", "challenge-key", 10),
        ("within = 2", 'within = "x"', "challenge-value", 10),
        ("said =", "sayd =", "challenge-key", 13),
        ('said = "here"', "within = 1", "challenge-goal", 12),
        ('task = "Do."\n', "", "challenge-missing", 4),
        ("format = 1", "format = 2", "challenge-value", 1),
        ('"first_room"', '"../x.world"', "challenge-outside", 2),
        ("title =", "titel =", "challenge-key", 5),
        ("[[goal]]\nsaid", "[[goal]\nsaid", "challenge-not-toml", 12),
        ("[en]", "[pt]", "challenge-missing", 0),
        ("within = 2", "area = [[0, 1]]", "challenge-value", 10),
        ("within = 2", "area = [[0, 1], [2, 3]]", "challenge-goal", 8),
        ("[en]", '[[variant]]\nstart = [0, 0, "nort"]\n[en]', "challenge-choice", 5),
        ("within = 2", "within = -1", "challenge-value", 10),
        ('"ball"', "[0, nan]", "challenge-value", 9),
        ('"ball"', "[0, 1e999]", "challenge-value", 9),
        ('said = "here"', "visited = []", "challenge-value", 13),
        ('said = "here"', "said = []", "challenge-value", 13),
        ('said = "here"', 'said = ["one", ""]', "challenge-value", 13),
        ('said = "here"', "robots = []", "challenge-value", 13),
        ("format = 1\n", "format = 1\nvariant = []\n", "challenge-value", 2),
        ("format = 1\n", "format = 1\nfoo = 3\n", "challenge-key", 2),
        ("[en]", "[[goal]]\nfacing = 0\n" * 49 + "[en]", "challenge-value", 4),
        ("[en]", "[limit]\ncommands = -1\n[en]", "challenge-value", 5),
        ("[en]", "[[variant]]\nstart = [0, 1e999, 0]\n[en]", "challenge-value", 5),
        ("[en]", '[[variant]]\nthings = { "ball" = [0, inf] }\n[en]', "challenge-value", 5),
    ],
)
def test_a_mistake_has_its_line(tmp_path: Path, old: str, new: str, code: str, line: int) -> None:
    with pytest.raises(BadChallenge) as bad:
        read(tmp_path, GOOD.replace(old, new))

    assert [(each.code, each.line) for each in bad.value.mistakes] == [(code, line)]


def test_a_file_beyond_the_limit_is_refused_with_the_true_cause(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "it.toml").write_text(GOOD + "#" * 100_000)

    assert main(["challenge", "test", str(tmp_path / "it.toml"), "--lang", "en"]) == 2
    assert capsys.readouterr().err == "it.toml is too large, at most 100 000 bytes.\n"


def test_a_huge_file_is_refused_before_it_takes_memory(tmp_path: Path) -> None:
    (tmp_path / "it.toml").touch()
    os.truncate(tmp_path / "it.toml", 50_000_000)
    with traced() as peak, pytest.raises(BadChallenge) as bad:
        challenges.read(tmp_path / "it.toml")

    assert [each.code for each in bad.value.mistakes] == ["challenge-too-large"]
    assert peak() < 5_000_000


def test_a_file_without_mistakes_is_read(tmp_path: Path) -> None:
    found = read(tmp_path, GOOD)

    assert [each.kind for each in found.rules.goal] == ["at", "said"]


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("within", "wihtin", "Line 10: it.toml has the key wihtin. Did you mean within?"),
        ('"ball"', "[0, 1e999]", "Line 9: it.toml has a value for at that does not fit."),
        ("[en]", 'required = ["REPAET"]\n[en]', "Line 4: it.toml has REPAET. Did you mean REPEAT?"),
        ("[en]", 'difficulty = "esay"\n[en]', "Line 4: it.toml has esay. Did you mean easy?"),
        ("[en]", 'difficulty = "x"\n[en]', "Line 4: it.toml has x. Possible are easy, medium, hard."),
        (
            "[en]",
            'after = ["frist_walk"]\n[en]',
            "Line 4: There is no challenge frist_walk. Did you mean first_walk?",
        ),
        (
            '"first_room"',
            '"frist_room"',
            "Line 2: it.toml asks for the world frist_room. Did you mean first_room?\n"
            "What I can't read is checked after you correct it.",
        ),
        (
            "[[goal]]\nsaid",
            '[[question]]\nask = "colou"\nof = "ball"\n[[goal]]\nsaid',
            "Line 13: it.toml has colou. Did you mean colour?",
        ),
        (
            "[[goal]]\nsaid",
            '[[variant]]\nthings = { "chiar" = [0, 6] }\n[[goal]]\nsaid',
            "Line 13: it.toml names chiar, and its world has no such thing. Did you mean chair?",
        ),
        ('"ball"', '"bal"', "Line 9: it.toml names bal, and its world has no such thing. Did you mean ball?"),
        (
            '"ball"',
            '"cupboard"',
            "Line 9: it.toml names cupboard, and its world has no such thing. "
            "Possible are ball, chair, sofa, table, west wall, east wall, north wall, south wall.",
        ),
    ],
)
def test_a_misspelt_name_is_reported_with_the_nearest_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], old: str, new: str, sentence: str
) -> None:
    file = tmp_path / "it.toml"
    file.write_text(GOOD.replace(old, new), encoding="utf-8")

    assert main(["challenge", "check", str(file), str(file), "--lang", "en"]) == 2
    assert capsys.readouterr().err.strip() == sentence


MANY = """\
format = 1
world = "first_room"
after = ["frist_walk"]
words = ["FW", "TRR"]
dificulty = "easy"

[en]
titel = "T"
task = "Do."
[[en.hint]]
txt = "Walk."

[[goal]]
at = "bal"
wihtin = 2

[[goal]]
at = [0, 5
within = 1

[nver]
bump = true

[[question]]
ask = "colou"
of = "chiar"
"""
OF_MANY = """\
Line 3: There is no challenge frist_walk. Did you mean first_walk?
Line 4: it.toml has TRR. Did you mean TR?
Line 5: it.toml has the key dificulty. Did you mean difficulty?
Line 8: it.toml has the key titel. Did you mean title?
Line 11: it.toml has the key txt. Did you mean text?
Line 14: it.toml names bal, and its world has no such thing. Did you mean ball?
Line 15: it.toml has the key wihtin. Did you mean within?
Line 18: it.toml is not written as a challenge is. The guide for challenges shows how.
Line 21: it.toml has the key nver. Did you mean never?
Line 25: it.toml has colou. Did you mean colour?
Line 26: it.toml names chiar, and its world has no such thing. Did you mean chair?
What I can't read is checked after you correct it.
"""


@pytest.mark.parametrize(
    "command",
    [
        "challenge check {file} {program}",
        "challenge test {file}",
        "challenge test {folder}",
        "run --challenge {file} {program}",
        "run {program} --world challenge:{file}",
    ],
)
def test_every_mistake_of_a_file_has_its_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], command: str
) -> None:
    file, program = tmp_path / "it.toml", tmp_path / "p.gd"
    file.write_text(MANY, encoding="utf-8")
    program.write_text("FW 5")

    arguments = command.format(file=file, program=program, folder=tmp_path).split()
    assert main([*arguments, "--lang", "en"]) == 2
    assert capsys.readouterr().err == OF_MANY


def test_a_world_with_a_mistake_is_reported_together_with_the_mistakes_of_the_challenge(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "it.world").write_text("bad (")
    file = tmp_path / "it.toml"
    file.write_text(GOOD.replace("first_room", "it.world").replace("within", "wihtin"), encoding="utf-8")

    assert main(["challenge", "test", str(file), "--lang", "en"]) == 2
    first, world, note = capsys.readouterr().err.splitlines()
    assert first == "Line 10: it.toml has the key wihtin. Did you mean within?"
    assert "it.world" in world
    assert note == "What I can't read is checked after you correct it."


def test_a_folder_with_several_challenges_says_their_names(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("p.gd").write_text("FW 5")
    Path("class").mkdir()
    for name in ("one", "two"):
        main(["challenge", "new", f"class/{name}"])
    capsys.readouterr()

    assert main(["challenge", "check", "class", "p.gd", "--lang", "en"]) == 2
    said = "class has several challenges: class/one/one.toml, class/two/two.toml. Name one of them.\n"
    assert capsys.readouterr().err == said
    assert main(["challenge", "test", "class", "--lang", "en"]) == 0
    assert [line.partition(":")[0] for line in capsys.readouterr().out.splitlines()] == ["one", "two"]


def test_of_very_many_mistakes_the_first_are_listed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "it.toml"
    file.write_text(GOOD + "".join(f"key{number} = 1\n" for number in range(50)))

    assert main(["challenge", "test", str(file), "--lang", "en"]) == 2
    lines = capsys.readouterr().err.splitlines()
    assert lines[0].startswith("Line 14: it.toml has the key key0")
    assert [*lines[20:]] == ["Only the first 20 mistakes are listed."]


@pytest.mark.parametrize(
    ("old", "new", "lines"),
    [
        ('title = "T"', 'title = "T', [5]),
        ("\nat =", "\nat", [9]),
        ("[en]", "[en", [4]),
        ('"ball"', '[\n0,\n"ball"\n]\nfacing = = 3', [9, 13]),
        ("[en]", 'variant = 3\nlimit = "x"\nafter = [3]\n[en]', [4, 5, 6]),
        ("[en]", '[pt]\ntitle = 3\ntask = "x"\n[es]\ntitle = "x"\ntask = 4\n[en]', [5, 9]),
        ("[en]", "[pt]\ntitle = 3\n[en]", [4, 5]),
        ('"ball"', "[0, nan]\nfacing = 1e999", [9, 10]),
        ("[[goal]]\nsaid", "[[goal]]\n[[goal]]\nrobot = 3\n[[goal]]\nsaid", [12, 14]),
    ],
)
def test_a_mistake_hides_no_other_and_makes_none(
    tmp_path: Path, old: str, new: str, lines: list[int]
) -> None:
    with pytest.raises(BadChallenge) as bad:
        read(tmp_path, GOOD.replace(old, new))

    assert sorted(each.line for each in bad.value.mistakes) == lines


PUPILS = {
    "ana.gd": (b"FW 5", "ana.gd: Solved, in 1 command."),
    "bia.gd": (b"FW 4", "bia.gd: 0 of 1 goal. You stopped 1 step south of 0, 5."),
    "caio.gd": (b"\xff\xfe\x00", "caio.gd is no text in UTF-8."),
    "endless.gd": (
        b"VAR A = 1\nWHILE A > 0 DO\nEND WHILE",
        "endless.gd: 0 of 1 goal. The program ends too late or never. You stopped 5 steps south of 0, 5.",
    ),
    "misspelt.gd": (
        b"FWW 3",
        "misspelt.gd: 0 of 1 goal. Mistake in line 1: I do not know FWW. You stopped 5 steps south of 0, 5.",
    ),
    "rui.gd": (b"FW 40", "rui.gd: 0 of 1 goal. You stopped 8 steps north of 0, 5. You bumped 1 time."),
}


def test_each_program_of_a_folder_has_its_line_and_nothing_stops_the_rest(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name, (text, _) in PUPILS.items():
        (tmp_path / name).write_bytes(text)

    assert main(["challenge", "check", "first_walk", str(tmp_path), "--lang", "en"]) == 2

    lines = capsys.readouterr().out.replace(f"{tmp_path}/", "").splitlines()
    assert lines == [*(line for _, line in PUPILS.values()), "6 programs. 1 solved."]


def test_a_challenge_is_found_by_its_file_without_the_ending(tmp_path: Path) -> None:
    program = tmp_path / "p.gd"
    program.write_text("FW 5")
    for name in ("one", "two"):
        (tmp_path / f"{name}.toml").write_text(Path(challenges.LADDERS, "first_walk.toml").read_text())

    assert main(["challenge", "check", str(tmp_path / "one"), str(program), "--lang", "en"]) == 0
    assert main(["challenge", "check", str(tmp_path / "three"), str(program), "--lang", "en"]) == 2


@pytest.mark.parametrize(("text", "code"), [("FW 5", 0), ("FW 4", 1)])
def test_a_run_with_a_challenge_is_judged(tmp_path: Path, text: str, code: int) -> None:
    program = tmp_path / "p.gd"
    program.write_text(text)

    assert main(["run", "--challenge", "first_walk", str(program), "--lang", "en"]) == code


def test_the_verdicts_are_a_table_and_a_text_for_each_pupil(tmp_path: Path) -> None:
    pupils = tmp_path / "turma A"
    pupils.mkdir()
    (pupils / "josé.gd").write_text("FW 5")
    (pupils / "rui.gd").write_text("FW 4")
    table, answers = tmp_path / "t.csv", tmp_path / "answers"
    options = ["--csv", str(table), "--feedback", str(answers), "--lang", "en"]

    assert main(["challenge", "check", "1", str(pupils), *options]) == 1

    with table.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(Path(each["file"]).name, each["solved"], each["steps"]) for each in rows] == [
        ("josé.gd", "True", "5"),
        ("rui.gd", "False", "4"),
    ]
    assert (answers / "josé.txt").read_text(encoding="utf-8") == f"{HEADING}Solved, in 1 command.\n"
    assert "1 step south" in (answers / "rui.txt").read_text(encoding="utf-8")


def test_a_program_that_can_not_be_judged_has_no_numbers_in_the_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("eva.gd").symlink_to("missing.gd")

    assert main(["challenge", "check", "1", "eva.gd", "--lang", "en", "--json"]) == 2
    (record,) = json.loads(capsys.readouterr().out)
    assert {**record, "verdict": ""} == {"file": "eva.gd", "solved": None, "verdict": ""}


def test_each_pupil_may_have_a_folder(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for pupil, text in {"ana": "FW 5", "joão": "FW 4"}.items():
        Path("class", pupil).mkdir(parents=True)
        Path("class", pupil, "first.gd").write_text(text)

    code = main(["challenge", "check", "1", "class", "--feedback", "answers", "--lang", "en"])

    assert (code, capsys.readouterr().out.splitlines()) == (
        1,
        [
            "ana/first.gd: Solved, in 1 command.",
            "joão/first.gd: 0 of 1 goal. You stopped 1 step south of 0, 5.",
            "2 programs. 1 solved.",
        ],
    )
    assert sorted(each.name for each in Path("answers").iterdir()) == ["ana-first.txt", "joão-first.txt"]


def test_work_that_is_not_there_is_named_and_not_judged(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for pupil in ("ana", "eva", ".git"):
        Path("class", pupil).mkdir(parents=True)
    Path("class", "ana", "first.gd").write_text("FW 5")
    Path("class", "eva", "notes.txt").write_text("FW 5")
    Path("class", "rui.gd").symlink_to("missing.gd")

    code = main(["challenge", "check", "1", "class", "--lang", "en"])

    assert (code, capsys.readouterr().out.splitlines()) == (
        2,
        [
            "ana/first.gd: Solved, in 1 command.",
            "There are no programs in class/eva. The name of a program ends in .gd.",
            "There is no file class/rui.gd.",
            "2 programs. 1 solved.",
        ],
    )


@pytest.mark.parametrize(
    "option", ["--events=e", "--record=r", "--sound=wav:w", "--world=maze", "--robot=sim"]
)
@pytest.mark.parametrize("command", ["run p.gd --challenge 1", "challenge check 1 p.gd"])
def test_an_option_without_effect_on_judging_is_refused(
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    command: str,
    option: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("p.gd").write_text("FW 5")

    assert main([*command.split(), option, "--lang", "en"]) == 2
    judging = "--challenge" if command.startswith("run") else "challenge check"
    said = f"{option.partition('=')[0]} and {judging} do not go together.\n"
    assert capsys.readouterr() == ("", said)


@pytest.mark.parametrize(("statements", "codes"), [(20_000, []), (20_001, ["goal-endless"])])
def test_a_program_of_more_statements_than_documented_counts_as_endless(
    statements: int, codes: list[str]
) -> None:
    words = Words("en")
    judge = bootstrap.Judge(choose_challenge("first_walk", words), words, Settings())

    judged = judge.programs("VAR x = 1\n" + "x = 1\n" * (statements - 2) + "FW 5")[-1]
    assert [each.code for each in judged.shortfalls[:1]] == codes


@pytest.mark.parametrize(("most", "solved"), [(68, True), (67, False)])
def test_a_program_that_only_senses_ends_after_so_many_readings(
    monkeypatch: pytest.MonkeyPatch, most: int, solved: bool
) -> None:
    """Six readings count as ten statements each, and there are eight statements."""
    monkeypatch.setattr(bootstrap, "MOST_WORK", most)
    words, settings = Words("en"), Settings()
    judge = bootstrap.Judge(choose_challenge("first_walk", words), words, settings)

    (judged,) = judge.programs("VAR n = 0\n" + "n = DISTANCE F\n" * 6 + "FW 5")
    assert judged.is_solved == solved
    assert [each.code for each in judged.shortfalls[:1]] == [*(["goal-endless"] if not solved else [])]


@pytest.mark.parametrize("line", ["n = COLOR red", "SCAN"])
@pytest.mark.parametrize(("most", "solved"), [(308, True), (307, False)])
def test_a_program_that_only_looks_ends_after_fewer_readings(
    monkeypatch: pytest.MonkeyPatch, line: str, most: int, solved: bool
) -> None:
    """Six looks count as fifty statements each, and there are eight statements."""
    monkeypatch.setattr(bootstrap, "MOST_WORK", most)
    words, settings = Words("en"), Settings()
    judge = bootstrap.Judge(choose_challenge("first_walk", words), words, settings)

    (judged,) = judge.programs("VAR n = 0\n" + f"{line}\n" * 6 + "FW 5")
    assert judged.is_solved == solved
    assert [each.code for each in judged.shortfalls[:1]] == [*(["goal-endless"] if not solved else [])]


@pytest.mark.parametrize(
    ("text", "round_"),
    [
        ("WHILE COLOR red < 9 DO\nTR 1\nEND WHILE", 360),
        ("WHILE 1 == 1 DO\nTR 120\nEND WHILE", 3),
        ("WHILE 1 == 1 DO\nTR 90\nSCAN\nEND WHILE", 8),
        ("WHILE 1 == 1 DO\nFW 100\nEND WHILE", 1),
    ],
)
def test_a_program_ends_as_endless_where_all_is_as_it_was_before(text: str, round_: int) -> None:
    """``round_``: the commands until it begins anew."""
    words, settings = Words("en"), Settings()
    judge = bootstrap.Judge(choose_challenge("first_walk", words), words, settings)

    (judged,) = judge.programs(text)

    assert judged.shortfalls[0].code == "goal-endless"
    assert round_ < judged.counts["commands"] <= round_ + 2


@pytest.mark.parametrize(("most", "is_seen"), [(4, False), (5, True)])
def test_so_many_situations_are_remembered(monkeypatch: pytest.MonkeyPatch, most: int, is_seen: bool) -> None:
    """The one after three turns is the second again, as the first is that before the loop.

    A program that continues ends by its work.
    """
    monkeypatch.setattr(bootstrap, "MOST_SITUATIONS", most)
    monkeypatch.setattr(bootstrap, "MOST_WORK", 60)
    words, settings = Words("en"), Settings()
    judge = bootstrap.Judge(choose_challenge("first_walk", words), words, settings)

    (judged,) = judge.programs("WHILE 1 == 1 DO\nTR 120\nEND WHILE")
    assert (judged.counts["commands"] < 6) is is_seen


@pytest.mark.parametrize(("seconds", "codes"), [(3590, []), (3601, ["goal-endless"])])
def test_a_program_that_takes_more_than_an_hour_counts_as_endless(seconds: int, codes: list[str]) -> None:
    words, settings = Words("en"), Settings()
    judge = bootstrap.Judge(choose_challenge("first_walk", words), words, settings)

    judged = judge.programs(f"WAIT {seconds}\nFW 5")[-1]
    assert [each.code for each in judged.shortfalls[:1]] == codes


@pytest.mark.parametrize(
    "text",
    [
        "REPEAT 300 TIMES\nTR 360\nEND REPEAT\nFW 5",
        "VAR n = 0\nWHILE n < 300 DO\nSCAN\nn = n + 1\nEND WHILE\nFW 5",
        "REPEAT 9 TIMES\nREPEAT 9 TIMES\nFW 1\nBW 1\nEND REPEAT\nEND REPEAT\nFW 5",
    ],
)
def test_a_program_that_does_the_same_often_and_ends_is_right(text: str) -> None:
    words, settings = Words("en"), Settings()
    judge = bootstrap.Judge(choose_challenge("first_walk", words), words, settings)

    assert judge.programs(text)[0].is_solved


def test_a_program_is_tried_from_no_further_start_after_one_that_fails() -> None:
    words, settings = Words("en"), Settings()
    judge = bootstrap.Judge(choose_challenge("to_the_cone", words), words, settings)

    verdicts = judge.programs("FW 1")

    assert [each.is_solved for each in verdicts] == [False]
    assert len(judge.programs("FW DISTANCE F - 1")) == len(judge.starts) == 3


def test_answers_and_tables_that_cannot_be_written_are_a_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    program = tmp_path / "p.gd"
    program.write_text("FW 5")
    for option, place in (("--feedback", program), ("--feedback", program / "x"), ("--csv", program / "x")):
        assert main(["challenge", "check", "1", str(program), option, str(place), "--lang", "en"]) == 2
        assert capsys.readouterr().err.startswith(
            f"I can't {'make' if option == '--feedback' else 'write'} {place}"
        )
    assert program.read_text() == "FW 5"


def test_a_link_in_a_circle_is_a_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("circle.gd").symlink_to("circle.gd")
    Path("right.gd").write_text("FW 5")
    check = ["challenge", "check", "1"]

    assert main([*check, "circle.gd", "--csv", "t.csv", "--feedback", "answers", "--lang", "en"]) == 2
    assert capsys.readouterr().out.startswith("I can't read circle.gd: ")
    assert main([*check, "right.gd", "--feedback", "circle.gd", "--lang", "es"]) == 2
    assert capsys.readouterr() == ("", "No puedo crear circle.gd: ya hay un archivo con ese nombre.\n")


def test_a_table_called_minus_is_standard_output_and_the_verdicts_are_elsewhere(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("right.gd").write_text("FW 5")
    check = ["challenge", "check", "1", "right.gd", "--lang", "en", "--csv"]
    main([*check, "t.csv"])
    said = capsys.readouterr().out

    assert main([*check, "-"]) == 0
    assert capsys.readouterr() == (Path("t.csv").read_text(), said)
    assert main([*check, "-", "--json"]) == 2
    assert capsys.readouterr() == ("", "--csv and --json do not go together.\n")
    assert [each.name for each in Path().iterdir() if each.name == "-"] == []


def test_long_names_of_pupils_are_shortened_for_their_answers(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for end in "ab":
        Path("class", "é" * 125 + end).mkdir(parents=True)
        Path("class", "é" * 125 + end, "é" * 126 + ".gd").write_text("FW 5")

    assert main(["challenge", "check", "1", "class", "--feedback", "answers", "--lang", "en"]) == 0
    assert capsys.readouterr().err == ""
    assert sorted(each.name for each in Path("answers").iterdir()) == [
        "é" * 100 + "-2.txt",
        "é" * 100 + ".txt",
    ]


def test_a_folder_for_answers_that_can_not_be_written_is_found_before_judging(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "right.gd").write_text("FW 5")

    check = ["challenge", "check", "1", str(tmp_path / "right.gd"), "--lang", "en"]
    assert main([*check, "--feedback", "/proc"]) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err.startswith("I can't write /proc: ")


def test_equal_programs_are_judged_once_and_have_a_line_each(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    judged, judge = list[object](), programs.Judge.programs
    monkeypatch.setattr(
        programs.Judge, "programs", lambda self, given: judged.append(given) or judge(self, given)
    )
    for name, text in {"ana": "FW 5", "bia": "FW 4", "caio": "FW 5", "davi": "FW 4"}.items():
        (tmp_path / f"{name}.gd").write_text(text)

    assert main(["challenge", "check", "1", str(tmp_path), "--lang", "en"]) == 1

    assert judged == [{"donnie": "FW 5"}, {"donnie": "FW 4"}]
    right, short = "Solved, in 1 command.", "0 of 1 goal. You stopped 1 step south of 0, 5."
    said = {"ana.gd": right, "bia.gd": short, "caio.gd": right, "davi.gd": short}
    lines = [f"{name}: {verdict}" for name, verdict in said.items()]
    assert capsys.readouterr().out.splitlines() == [*lines, "4 programs. 2 solved."]


def hand_in(folder: Path, count: int) -> Path:
    """Programs of different pupils that walk 1 to 8 steps; those of 5 solve the first challenge."""
    folder.mkdir()
    for number in range(count):
        (folder / f"{number:04}.gd").write_text(f"FW {number % 8 + 1}\nVAR pupil = {number}")
    return folder


@pytest.mark.parametrize("confined", [False, True])
def test_many_programs_are_judged_in_several_processes_with_the_same_table(
    tmp_path: Path, confined: bool
) -> None:
    count = programs.FEW * 2
    pupils = hand_in(tmp_path / "pupils", count)
    (pupils / "0003.gd").write_bytes(b"\0")
    limits = ["--confined", str(tmp_path)] if confined else []
    options = ["--csv", "t.csv", "--feedback", "answers", "--lang", "en", *limits]
    command = [sys.executable, "-m", "donnie_tui", "challenge", "check", "1", "pupils", *options]
    place = {"cwd": tmp_path, "env": {**os.environ, "PYTHONPATH": str(Path.cwd())}}

    printed, as_json = (
        subprocess.run([*command, *more], **place, capture_output=True, text=True, check=False).stdout  # type: ignore[call-overload]
        for more in ([], ["--json"])
    )

    solved = [number for number in range(count) if number % 8 == 4]
    lines = printed.splitlines()
    assert lines[3] == "pupils/0003.gd is no text in UTF-8."
    assert lines[4:6] == [
        "0004.gd: Solved, in 1 command.",
        "0005.gd: 0 of 1 goal. You stopped 1 step north of 0, 5.",
    ]
    assert lines[-1] == f"{count} programs. {len(solved)} solved."
    names = [f"pupils/{number:04}.gd" for number in range(count)]
    with (tmp_path / "t.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [each["file"] for each in rows] == [each["file"] for each in json.loads(as_json)] == names
    assert [at for at, each in enumerate(rows) if each["solved"] == "True"] == solved
    assert (tmp_path / "answers" / "0004.txt").read_text() == f"{HEADING}Solved, in 1 command.\n"


def test_ctrl_c_ends_all_processes_that_judge(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "donnie_tui", "challenge", "check", "1"]
    command += [str(hand_in(tmp_path / "pupils", 2000)), "--lang", "en"]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    assert process.stdout is not None
    first = process.stdout.readline()

    os.killpg(process.pid, signal.SIGINT)

    out, err = process.communicate()  # until no process has its output open
    assert (process.returncode, err) == (130, "")
    assert first == "0000.gd: 0 of 1 goal. You stopped 4 steps south of 0, 5.\n"
    assert "programs" not in out


def test_a_link_in_a_folder_of_pupils_reads_and_writes_no_other_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Neither a file nor a folder of the teacher, and an answer replaces a link, not what that names."""
    private, pupils, answers = (tmp_path / each for each in ("private", "pupils", "answers"))
    for folder in (private, pupils, answers):
        folder.mkdir()
    (private / "letter.gd").write_text("dear headmistress")
    (pupils / "ana.gd").write_text("FW 5")
    (pupils / "rui.gd").symlink_to(private / "letter.gd")
    (pupils / "tom").symlink_to(private)
    (answers / "ana.txt").symlink_to(private / "letter.gd")

    arguments = ["challenge", "check", "1", str(pupils), "--feedback", str(answers), "--lang", "en"]
    assert main(arguments) == 2

    assert capsys.readouterr().out.splitlines() == [
        f"{pupils}/tom/letter.gd is a link that leads out of the folder.",
        "ana.gd: Solved, in 1 command.",
        f"{pupils}/rui.gd is a link that leads out of the folder.",
        "3 programs. 1 solved.",
    ]
    assert (private / "letter.gd").read_text() == "dear headmistress"
    assert (answers / "ana.txt").read_text() == f"{HEADING}Solved, in 1 command.\n"


@pytest.mark.parametrize("name", ["it.world", "it.solution.gd", "it.bob.solution.gd"])
def test_a_challenge_uses_no_link_to_another_folder(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    (tmp_path / "elsewhere").write_text("secret")
    file = written(tmp_path, "it", WITHOUT_GOAL.replace("first_room", "it.world"), "FW 3")
    (tmp_path / "it.world").write_text(Path("worlds/scenes/first_room.world").read_text(encoding="utf-8"))
    (tmp_path / name).unlink(missing_ok=True)
    (tmp_path / name).symlink_to(tmp_path / "elsewhere")

    assert main(["challenge", "test", str(file), "--lang", "en"]) == 2
    said = f"it.toml asks for {name}. A challenge uses only files of its own folder.\n"
    assert capsys.readouterr().err.endswith(said)


WATCHED = """\
import json, os, sys
from pathlib import Path

touched = []

def note(event, arguments):
    if event == "open":
        path, _, flags = arguments
        touched.append(("write" if flags & (os.O_WRONLY | os.O_RDWR) else "read", os.fsdecode(path)
                        if isinstance(path, (str, bytes, os.PathLike)) else str(path)))
    elif event.partition(".")[0] in ("socket", "subprocess", "shutil", "tempfile") or event in (
        "os.exec", "os.posix_spawn", "os.system", "os.fork", "os.remove", "os.rename", "os.mkdir", "os.rmdir",
        "os.link", "os.symlink", "os.chmod", "os.kill", "os.putenv", "pty.spawn", "webbrowser.open",
    ):
        touched.append((event, str(arguments)))

from donnie_tui.cli.main import main
folder, out = sys.argv[1:]
main(["challenge", "check", "1", folder, "--lang", "en"])  # all is loaded
sys.addaudithook(note)
code = main(["challenge", "check", "1", folder, "--lang", "en"])
Path(out).write_text(json.dumps([code, touched[:-1] if touched[-1][1] == out else touched]))
"""
MEDDLING = {
    "belt": "BELT ON\nVIBRATE F\nBELT OFF",
    "commands": "SAVE x.gd\nOPEN /etc/passwd\nRECORD x\nLINEAR\nSET lang = pt\nCHALLENGE 2",
    "help": "HELP FW\nHELP",
    "history": "STATE\nHISTORY\nPOS",
    "include": "RUN /etc/passwd",
    "quit": "QUIT",
    "run": "RUN",
    "scan": "SCAN\nSPEAK DISTANCE F\nGRIP\nRELEASE",
    "sound": 'SOUND ON\nSPEAK "hello"\nSOUND OFF',
    "wait": "WAIT 100000000",
}


def test_the_program_of_a_pupil_touches_nothing_of_the_machine_but_its_own_file(tmp_path: Path) -> None:
    """No file but its own is read, none is written; no process, socket, device, sound or variable."""
    pupils, home, result = tmp_path / "pupils", tmp_path / "home", tmp_path / "result"
    pupils.mkdir()
    home.mkdir()
    for name, text in MEDDLING.items():
        (pupils / f"{name}.gd").write_text(text)
    own = {each: str(home) for each in ("HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_RUNTIME_DIR")}
    variables = {each: os.environ[each] for each in ("PATH",)} | own
    command = [sys.executable, "-c", WATCHED, str(pupils), str(result)]
    done = subprocess.run(command, env=variables, capture_output=True, text=True, check=True)

    code, touched = json.loads(result.read_text())
    touched = [
        each for each in touched if not each[1].endswith("settings.toml")
    ]  # the teacher's, for the command
    assert done.stdout.count("programs. 0 solved.") == 2
    assert code == 1
    ours = (str(Path(challenges.__file__).parent.parent), str(pupils), sys.prefix, sys.base_prefix)
    assert [each for each in touched if each[0] != "read" or not each[1].startswith(ours)] == []
    assert [*home.rglob("*")] == []


def test_the_table_never_replaces_a_program(tmp_path: Path) -> None:
    program = tmp_path / "ana.gd"
    program.write_text("FW 5")

    assert main(["challenge", "check", "1", str(program), "--csv", str(program)]) == 2
    assert program.read_text() == "FW 5"


def test_a_new_challenge_works_and_replaces_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "my one"

    assert main(["challenge", "new", str(folder)]) == 0
    assert main(["challenge", "test", str(folder / "my one.toml")]) == 0
    assert main(["challenge", "check", str(folder), str(folder)]) == 0
    assert main(["challenge", "new", str(folder)]) == 2


def test_all_challenges_of_a_folder_are_tested(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, solution in (("b", "FW 4"), ("c", "FW 5")):
        main(["challenge", "new", str(tmp_path / name)])
        for end, text in ((".toml", None), (".solution.gd", solution)):
            made = tmp_path / name / f"{name}{end}"
            (tmp_path / made.name).write_text(text or made.read_text())
    (tmp_path / "a.toml").write_text("format = 2")
    capsys.readouterr()

    assert main(["challenge", "test", str(tmp_path), "--lang", "en"]) == 2

    printed = capsys.readouterr()
    assert printed.err.splitlines() == [
        "a.toml lacks en.title.",
        "a.toml lacks world.",
        "Line 1: a.toml has a value for format that does not fit.",
    ]
    assert printed.out.splitlines()[0] == "b: the solution does not solve it."
    assert printed.out.splitlines()[-1].startswith("c: the solution solves it")


def test_a_solution_with_a_line_too_many_is_reported(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "it"
    main(["challenge", "new", str(folder)])
    (folder / "it.solution.gd").write_text("FW 5\nTR 90\n")

    assert main(["challenge", "test", str(folder / "it.toml"), "--lang", "en"]) == 1
    assert capsys.readouterr().out.splitlines()[-1] == "it: the solution does not need its line 2."


def test_words_of_a_later_lesson_and_missing_ones_are_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, program = tmp_path / "it.toml", tmp_path / "p.gd"
    own = 'format = 1\nwords = ["FW", "TR"]\nrequired = ["TR"]\nafter = ["first_walk"]\n'
    file.write_text(GOOD.replace("format = 1\n", own))
    program.write_text("REPITA 2 VEZES\nFW 1\nFIM REPITA")

    assert main(["challenge", "check", str(file), str(program), "--lang", "en"]) == 1
    said = capsys.readouterr().out
    later = challenges.names().index("square") + 1  # the first whose solution repeats
    assert f"0 of 2 goals. REPEAT comes in challenge {later}. Missing: the word TR." in said


def written(folder: Path, name: str, text: str, solution: str) -> Path:
    """A challenge with its solution."""
    (folder / f"{name}.solution.gd").write_text(solution)
    file = folder / f"{name}.toml"
    file.write_text(text, encoding="utf-8")
    return file


WITHOUT_GOAL = """\
format = 1
world = "first_room"
[en]
title = "T"
task = "Do."
[[variant]]
start = [0, 0, "north"]
[[variant]]
start = [0, 0, "east"]
"""


def test_without_goals_the_end_of_the_solution_is_the_goal_from_each_start(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = written(tmp_path, "it", WITHOUT_GOAL, 'FW 3\nSPEAK "done"')
    assert main(["challenge", "test", str(file), "--lang", "en"]) == 0
    (tmp_path / "p.gd").write_text('FW 1\nSPEAK "Done!"')
    capsys.readouterr()
    assert main(["challenge", "check", str(file), str(tmp_path / "p.gd"), "--lang", "en"]) == 1
    assert capsys.readouterr().out == "p.gd: 1 of 2 goals. You stopped 2 steps south of 0, 3.\n"


BOTH_COME = """\
format = 1
world = "two_robots"
[en]
title = "T"
task = "Do."
[[goal]]
robots = ["alice", "bob"]
within = 6
[[goal]]
said = "hello"
[never]
bump = true
[[variant]]
[[variant]]
things = { "bob" = [0, 26] }
"""
"""Their middles are 30 or 26 steps apart. After 10 and 12 steps their bodies, 3 wide, are 5 or 1 apart."""


def both_come(folder: Path, bob: str) -> Path:
    (folder / "it.bob.solution.gd").write_text(bob)
    return written(folder, "it", BOTH_COME, "FW 10")


def test_each_robot_has_a_solution_of_its_own(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["challenge", "test", str(both_come(tmp_path, 'FW 12\nSPEAK "hello"'))]) == 0
    assert main(["challenge", "test", str(both_come(tmp_path, "FW 12"))]) == 1
    capsys.readouterr()
    file = both_come(tmp_path, 'FW 12\nSPEAK "hello"\nTR 90')
    assert main(["challenge", "test", str(file), "--lang", "en"]) == 1
    assert capsys.readouterr().out == "it.bob: the solution does not need its line 3.\n"


def test_a_pupil_hands_in_a_program_for_each_robot(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = both_come(tmp_path, 'FW 12\nSPEAK "hello"')
    for pupil, alice, bob in (("ana", "FW 10", 'FW 12\nSPEAK "Hello!"'), ("rui", "FW 10", "FW 6")):
        (tmp_path / "class" / pupil).mkdir(parents=True)
        (tmp_path / "class" / pupil / "alice.gd").write_text(alice)
        (tmp_path / "class" / pupil / "Bob.gd").write_text(bob)
    (tmp_path / "class" / "tom.gd").write_text("FW 10")
    (tmp_path / "class" / "empty").mkdir()
    ana = tmp_path / "class" / "ana"
    empty = f"There are no programs in {tmp_path}/class/empty. The name of a program ends in .gd."
    said = {
        "ana": "Solved, in 3 commands.",
        "rui": "0 of 2 goals. alice and bob come no nearer than 11 steps. Missing: say hello.",
        "tom.gd": "0 of 2 goals. alice and bob come no nearer than 17 steps. Missing: say hello.",
    }
    answers = ["--feedback", str(tmp_path / "answers"), "--csv", str(tmp_path / "t.csv"), "--lang", "en"]

    assert main(["challenge", "check", str(file), str(tmp_path / "class"), *answers]) == 2
    ana_said, *others = (f"{name}: {verdict}" for name, verdict in said.items())
    assert capsys.readouterr().out.splitlines() == [ana_said, empty, *others, "3 programs. 1 solved."]
    assert (tmp_path / "answers" / "rui.txt").read_text().endswith(f".\n{said['rui']}\n")
    assert main(["challenge", "check", str(file), str(ana), "--lang", "en"]) == 0
    programs = [f"alice={ana}/alice.gd", f"bob={ana}/Bob.gd"]
    assert main(["run", "--challenge", str(file), *programs, "--lang", "en"]) == 0
    assert main(["challenge", "check", str(file), f"carl={ana}/alice.gd", "--lang", "en"]) == 2
    assert capsys.readouterr().out.splitlines()[1:] == ["alice.gd, Bob.gd: Solved, in 3 commands."]


def test_recorded_programs_of_several_robots_are_tried_from_each_start(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = both_come(tmp_path, 'FW 12\nSPEAK "hello"')
    recording = tmp_path / "r.jsonl"
    for bob, verdict in (
        ('FW 12\nSPEAK "hello"', "Solved, in 3 commands."),
        ('FW 15\nSPEAK "hello"', "2 of 2 goals. From start 2: You bumped"),
    ):
        (tmp_path / "a.gd").write_text("FW 10")
        (tmp_path / "b.gd").write_text(bob)
        recording.unlink(missing_ok=True)
        programs = [f"alice={tmp_path}/a.gd", f"bob={tmp_path}/b.gd"]
        main(["run", *programs, "--world", f"challenge:{file}", "--record", str(recording), "--lang", "en"])
        capsys.readouterr()
        main(["replay", str(recording), "--challenge", str(file), "--lang", "en"])
        assert capsys.readouterr().out.startswith(verdict)


def test_without_goals_and_solution_a_challenge_is_a_mistake(tmp_path: Path) -> None:
    with pytest.raises(BadChallenge) as bad:
        read(tmp_path, WITHOUT_GOAL)

    assert [(each.code, each.what) for each in bad.value.mistakes] == [
        ("challenge-solution", "it.solution.gd")
    ]


def test_the_world_of_a_challenge_is_a_file_next_to_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    own = Path("worlds/scenes/two_robots.world").read_text(encoding="utf-8")
    for name in ("donnie.inc", "things.inc", "bigbob.inc"):
        (tmp_path / name).write_text(Path("worlds/scenes", name).read_text(encoding="utf-8"))
    (tmp_path / "my hall é.world").write_text(own, encoding="utf-8")
    text = WITHOUT_GOAL.replace("first_room", "my hall é.world")
    file = written(tmp_path, "my hall é", text, "FW 3")

    assert main(["challenge", "test", str(file), "--lang", "en"]) == 0
    (tmp_path / "my hall é.world").unlink()
    capsys.readouterr()
    assert main(["challenge", "test", str(file), "--lang", "en"]) == 2
    assert "my hall é.world" in capsys.readouterr().err


def exit_code_of_test(folder: Path, solution: str, *changes: tuple[str, str]) -> int:
    text = WITHOUT_GOAL
    for old, new in changes:
        text = text.replace(old, new)
    return main(["challenge", "test", str(written(folder, "it", text, solution)), "--lang", "en"])


@pytest.mark.parametrize(
    ("solution", "old", "new", "said"),
    [
        ("FW 3 TR 90", "[en]", "[en]", "it: the solution does not need its line 1."),
        (
            "FW 3",
            'task = "Do."',
            f'task = "{"Do. " * 21}"',
            f"it: 83 characters are too long to hear, at most 80: {('Do. ' * 21).strip()}",
        ),
        (
            "FW 3",
            'task = "Do."',
            'task = "Do."\n[[en.hint]]\ntext = "FW"\n[pt]\ntitle = "T"\ntask = "Vai."',
            "it: pt has 0 hints, English has 1.",
        ),
        (
            "FW 3",
            'task = "Do."',
            'task = """\nA.\nB.\nC.\nD."""\n[limit]\nsteps = 3',
            "it: with its limits the task has 5 sentences in en, at most 4.",
        ),
        ("FWW 3", "[en]", "[en]", "it: the solution does not solve it."),
        ("TR 90", "[en]", "[en]", "it: the empty program solves it."),
        (
            "FW 3",
            'start = [0, 0, "east"]',
            'start = [0, 0, "east"]\nthings = { "ball" = [1, 0] }',
            "it: From start 2: Robot donnie and ball begin at the same place. Move one of them.",
        ),
        (
            "FW 3",
            '"north"',
            '"north"]\n[[variant]]\nstart = [-10, 0, 0',
            "it: From start 2: Robot donnie and chair begin at the same place. Move one of them.",
        ),
    ],
)
def test_what_is_wrong_with_a_challenge_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], solution: str, old: str, new: str, said: str
) -> None:
    assert exit_code_of_test(tmp_path, solution, (old, new)) == 1
    assert said in capsys.readouterr().out.splitlines()


BAD = {
    "big.gd": b"FW 1\n" * 2_000_000,
    "computes.gd": b"VAR x = 1\nWHILE 1 == 1 DO\nx = x + 1\nEND WHILE",
    "empty.gd": b"",
    "jos\u00e9 da silva (2).gd": b"FW 5",
    "no text.gd": bytes(range(256)),
    "waits.gd": b"WAIT 1000000000\nFW 5",
}


def test_no_program_of_a_folder_stops_the_rest(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name, content in BAD.items():
        (tmp_path / name).write_bytes(content)
    (tmp_path / "folder.gd").mkdir()

    assert main(["challenge", "check", "first_walk", str(tmp_path), "--lang", "en"]) == 2

    endless = "0 of 1 goal. The program ends too late or never. You stopped 5 steps south of 0, 5."
    assert capsys.readouterr().out.replace(f"{tmp_path}/", "").splitlines() == [
        "There are no programs in folder.gd. The name of a program ends in .gd.",
        "big.gd is too large, at most 8 megabytes.",
        f"computes.gd: {endless}",
        "empty.gd: 0 of 1 goal. You stopped 5 steps south of 0, 5.",
        "jos\u00e9 da silva (2).gd: Solved, in 1 command.",
        "no text.gd is no text in UTF-8.",
        f"waits.gd: {endless}",
        "6 programs. 1 solved.",
    ]


@pytest.mark.parametrize(
    ("world", "said"),
    [
        ("no_such_world", "no_such_world"),
        ("it.world", "it.world"),
    ],
)
def test_a_challenge_without_its_world_is_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], world: str, said: str
) -> None:
    assert exit_code_of_test(tmp_path, "FW 3", ("first_room", world)) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert said in line


SCATTERED = """\
format = 1
world = "wild_garden"
[en]
title = "T"
task = "Do."
[[goal]]
said = {}
[[variant]]
seed = {}
"""


@pytest.mark.parametrize("seed", [3, 8])
def test_the_seed_of_a_start_puts_the_things_of_the_world(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], seed: int
) -> None:
    """As the same seed puts them without a challenge: in a session, in a folder, and as it is run again."""
    program, file, kept = tmp_path / "p.gd", tmp_path / "it.toml", tmp_path / "kept.jsonl"
    program.write_text("SPEAK DISTANCE F")
    main(["run", str(program), "--world", "wild_garden", "--seed", str(seed), "--lang", "en"])
    said = capsys.readouterr().out.strip()
    assert (
        said != "19"
    )  # where nothing is scattered: the wall is 20.5 steps from the middle of a robot 3 wide
    file.write_text(SCATTERED.format(said, seed), encoding="utf-8")

    assert main(["challenge", "check", str(file), str(program)]) == 0
    assert main(["run", str(program), "--world", f"challenge:{file}", "--record", str(kept)]) == 0
    assert f"\n{said}\n" in f"\n{capsys.readouterr().out}"
    assert main(["replay", str(kept), "--check"]) == 0
    assert main(["replay", str(kept), "--challenge", str(file)]) == 0


def test_of_a_recorded_real_robot_only_what_it_senses_is_judged(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    program, kept = tmp_path / "p.gd", tmp_path / "kept.jsonl"
    program.write_text("FW DISTANCE F - 1")
    main(["run", str(program), "--world", "challenge:to_the_cone", "--record", str(kept)])
    kept.write_text(kept.read_text().replace('"robot":"sim"', '"robot":"serial:/dev/robot"', 1))
    capsys.readouterr()

    assert main(["replay", str(kept), "--challenge", "to_the_cone", "--lang", "en"]) == 1
    assert capsys.readouterr().out.startswith("0 of 1 goal. I can't sense goal 1.")


STEP_BY_STEP = {
    "en": (Path("docs/challenges.md"), ("TL 90", "FW"), "WHILE 1 == 1 DO\nEND WHILE"),
    "pt": (Path("docs/pt/desafios.md"), ("GE 90", "PF"), "ENQUANTO 1 == 1 FAÇA\nFIM ENQUANTO"),
    "es": (Path("docs/es/retos.md"), ("GI 90", "AV"), "MIENTRAS 1 == 1 HACER\nFIN MIENTRAS"),
}


@pytest.mark.parametrize("language", STEP_BY_STEP)
def test_a_teacher_has_the_table_of_five_pupils_by_the_document_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, language: str
) -> None:
    """Its challenge and its solution as they stand there, and the pupils that it describes."""
    document, (turn, walk), endless = STEP_BY_STEP[language]
    text = document.read_text(encoding="utf-8")
    toml, solution, table = (
        "".join(f"{line[3:]}\n" for line in block.splitlines())
        for block in re.findall(r"^   ```\w*\n(.*?)^   ```", text, re.DOTALL | re.MULTILINE)
    )
    files = re.findall(r"`(\w+/\w+(?:\.solution)?\.(?:toml|gd))`", text)
    monkeypatch.chdir(tmp_path)
    for name, content in zip(files[:2], (toml, solution), strict=True):
        Path(name).parent.mkdir(exist_ok=True)
        Path(name).write_text(content, encoding="utf-8")
    tested, checked = (
        re.search(rf"`donnie (challenge {what} [^`]*)`", text.replace("\n   ", " ")).group(1).split()  # type: ignore[union-attr]
        for what in ("test", rf"check {files[0]}")
    )
    pupils = Path(checked[-1])
    pupils.mkdir()
    for name, program in {
        "ana": f"{turn}\n{walk} 6",
        "bruno": f"{turn}\n{walk} 5",
        "carla": f"{turn}\n{walk} 60",
        "davi": endless,
        "eva": f"{turn}\nFWW 6",
    }.items():
        (pupils / f"{name}.gd").write_text(program, encoding="utf-8")

    assert main([*tested, "--lang", language]) == 0
    capsys.readouterr()
    assert main([*checked, "--lang", language, "--csv", "t.csv", "--feedback", "answers"]) == 1
    assert capsys.readouterr().out == table
    with Path("t.csv").open(encoding="utf-8", newline="") as file:
        assert [each["solved"] for each in csv.DictReader(file)] == ["True", *["False"] * 4]
    assert len(list(Path("answers").iterdir())) == 5


@pytest.mark.parametrize("language", STEP_BY_STEP)
def test_the_document_has_each_kind_of_goal_and_each_key_with_its_default(language: str) -> None:
    text = STEP_BY_STEP[language][0].read_text(encoding="utf-8")
    contents = text[text.rindex("\n## ") :]
    rows = re.findall(r"^(?:\||-) `(\w+)(?: =[^`]*)?`", contents, re.MULTILINE)
    assert [*dict.fromkeys(rows)] == [*challenges.KINDS, *get_args(challenges.Ask)]

    named = {*re.findall(r"(?:`|^)(\w+)(?: =|`)", text, re.MULTILINE)}
    named |= {*re.findall(r"\[(?:en\.)?([a-z]+)\]", text)}
    tables = [Rules, Goal, Never, Limit, Variant, ChallengeQuestion, ChallengeText]
    assert {each.encode_name for kind in tables for each in fields(kind)} <= named

    found = re.findall(r"(\d+) (?:if it is missing|se falta|si falta)", " ".join(contents.split()))
    wanted = [Goal().value, Goal().within, Never().within, TOLERANCES["direction"], TOLERANCES["distance"]]
    assert [int(each) for each in found] == wanted


@pytest.mark.slow
def test_a_thousand_programs_have_a_line_each(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for number in range(1000):
        (tmp_path / f"pupil {number:04}.gd").write_text("FW 5" if number % 2 else "FW 4")

    assert main(["challenge", "check", "first_walk", str(tmp_path), "--lang", "en"]) == 1

    lines = capsys.readouterr().out.splitlines()
    assert [line.partition(":")[0] for line in lines[:-1]] == [f"pupil {n:04}.gd" for n in range(1000)]
    assert lines[-1] == "1000 programs. 500 solved."


@pytest.mark.parametrize(
    ("document", "heading"),
    [
        ("docs/teaching.md", "## Ten lessons with challenges"),
        ("docs/pt/para-professores.md", "## Dez aulas com desafios"),
        ("docs/es/para-docentes.md", "## Diez clases con retos"),
    ],
)
def test_ten_lessons_use_every_challenge(document: str, heading: str) -> None:
    section = Path(document).read_text(encoding="utf-8").partition(heading)[2].partition("\n## ")[0]
    lessons = re.split(r"^(\d+)\. ", section, flags=re.MULTILINE)[1:]
    named = {int(number) for lesson in lessons[1::2] for number in re.findall(r"\b\d+\b", lesson)}

    assert lessons[::2] == [str(number) for number in range(1, 11)]
    assert set(range(1, len(challenges.names()) + 1)) <= named


MOVED = """\
format = 1
world = "object_field"
[en]
title = "T"
task = "Do."
[[goal]]
at = "green cone"
within = 1.5
[[variant]]
start = [2, 1, "north"]
things = { "green cone" = [2, 7] }
"""


def test_a_recording_of_a_start_that_is_not_the_world_s_own_is_run_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, program, kept = tmp_path / "it.toml", tmp_path / "p.gd", tmp_path / "kept.jsonl"
    file.write_text(MOVED, encoding="utf-8")
    program.write_text("FW DISTANCE F - 1")

    main(["run", str(program), "--world", f"challenge:{file}", "--record", str(kept), "--lang", "en"])
    # The cone is 3 steps wide, as the robot: 6 steps between their middles leave 3.
    assert capsys.readouterr().out.splitlines()[-1] == "I walked 2 steps forward."
    assert main(["replay", str(kept), "--check"]) == 0
    assert main(["replay", str(kept), "--challenge", str(file)]) == 0
    kept.write_text(kept.read_text().replace('"moves":[[', '"moves":[["x",'))
    assert main(["replay", str(kept), "--check"]) == 2


def test_the_records_of_a_folder_are_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "ana.gd").write_text("FW 5")
    (tmp_path / "rui.gd").write_bytes(b"\xff\xfe\x00")

    assert main(["challenge", "check", "1", str(tmp_path), "--json", "--lang", "en"]) == 2

    ana, rui = json.loads(capsys.readouterr().out)
    assert (ana["solved"], ana["goals"], ana["met"], ana["commands"], ana["steps"]) == (True, 1, 1, 1, 5)
    assert (rui["solved"], rui["verdict"]) == (
        None,
        f"{tmp_path}/rui.gd is no text in UTF-8.",
    )


def test_a_file_name_is_no_formula_of_the_table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    names = ["=HYPERLINK(1).gd", "@b.gd", "a\x1b[2J.gd"]
    for name in names:
        Path(name).write_text("FW 5")
    Path(names[1]).write_bytes(b"\xff\xfe\x00")

    made = ["--csv", "t.csv", "--feedback", "texts"]
    assert main(["challenge", "check", "1", *names, *made, "--lang", "en"]) == 2

    with Path("t.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [each["file"] for each in rows] == ["'=HYPERLINK(1).gd", "'@b.gd", "a [2J.gd"]
    assert [each["verdict"] for each in rows[:2]] == [
        "Solved, in 1 command.",
        "'@b.gd is no text in UTF-8.",
    ]
    assert sorted(each.name for each in Path("texts").iterdir()) == [
        "=HYPERLINK(1).txt",
        "@b.txt",
        "a [2J.txt",
    ]


@pytest.mark.parametrize(("name", "degrees"), [("north", 0), ("east", 90), ("south", 180), ("west", 270)])
def test_a_heading_may_be_the_name_of_a_point_of_the_compass(name: Heading, degrees: float) -> None:
    assert degrees_of(name) == degrees
    assert degrees_of(45.0) == 45.0
