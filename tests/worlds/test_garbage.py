"""Each of ten thousand damaged world files loads or raises a mistake with a place.

Time and memory stay bounded."""

import random
import re
import subprocess
import sys
from pathlib import Path

import pytest

import worlds
from donnie_tui.i18n.mistakes import world_mistake
from donnie_tui.i18n.words import Words
from sim.worldfile import WorldError, load_configuration, load_text
from tests.conftest import ROOT
from tests.effort import examples
from tests.sessions.command import environment

MUTATIONS = examples(10_000)
PIECES = (
    *("", "(", ")", "[", "]", '"', "#", "\0", "é", "\n", "0", "1e9", "-", "\\", "'", "$", "include", "model"),
    *("define a a ( )", "define b model ( b ( ) )", 'include "garbage.world"', 'include "map.inc"', "point["),
    *(
        "point[9999]",
        "samples 9999999999",
        "fov 1e300",
        "[[[[[[[[",
        "((((((((",
        "size [ 0 0 0 ]",
        "unit_length",
    ),
    *("pose [ 1 2 3 4 5 ]", 'color "purpel"', "blength", "bcount 1e6", "range [ 5 1 ]", "points 3"),
    *("velocity_bounds [ 1 ]", 'drive "boat"', "ignore_zloc 0", "boundary 1", "gripper ( )", "position ( )"),
)
EQUIPPED = [
    """
    define sonar sensor ( range [ 0 5 ] fov 15 samples 3 noise [ 0.1 0.1 1 ] pose [ 0.1 0 0 90 ] )
    position ( name "a" drive "diff" velocity_bounds [ 0 1 0 0 0 0 -90 90 ] odom_error [ 0.1 0.1 0.1 ]
      ranger ( sonar ( ) sonar ( ) ) blobfinder ( colors_count 1 colors [ "red" ] image [ 80 60 ] pan 3 )
      fiducial ( range_max 3 fiducial_key 1 ) bumper ( bcount 1 bpose[0] [ 0.1 0 0 0 ] blength[0] 0.1 ) )
    """,
    """
    unit_length "cm" unit_angle "radians" ignore_zloc 0
    position ( gripper ( paddle_size [ 0.6 0.1 0.4 ] paddle_state [ "open" "up" ] autosnatch 1 )
      camera ( fov [ 70 40 ] pantilt [ 1 2 ] range [ 0 8 ] ) sensor ( ) size [ 40 40 ] origin [ 1 0 0 ] )
    model ( gripper_return 1 pushable 1 mass 2 boundary 1 color_rgba [ 1 0 0 1 ] )
    """,
]
CONFIGURATION = """
driver ( name "stage" provides [ "simulation:0" ] plugin "stageplugin" worldfile "w.world" )
driver ( name "stage" provides [ "position2d:0" "6666:ranger:0" ] model "donnie" )
driver ( name "donnie" provides [ "position2d:1" ] port "/dev/ttyUSB0" )
"""


def sources() -> list[str]:
    """The short worlds of the manual, which are read fast, and sometimes a world of Donnie."""
    texts = [Path(worlds.path(name)).read_text(encoding="utf-8") for name in worlds.names()]
    short = [text for text in texts if len(text) < 800 and not re.search("donnie|bitmap", text)]
    assert len(short) > 3
    donnie = (Path(worlds.SCENES) / "donnie.inc").read_text(encoding="utf-8")
    return [*short * 3, *EQUIPPED * 5, donnie + '\ndonnie( name "donnie" pose [ 0 0 0 90 ] )\n']


def damaged(text: str, chance: random.Random) -> str:
    """The text with one to three typical damages."""
    for _ in range(chance.choice((1, 1, 2, 3))):
        at = chance.randrange(len(text) + 1)
        length = chance.choice((0, 1, 3, 20, 200))
        match chance.randrange(4):
            case 0:
                text = text[:at]
            case 1:
                text = text[:at] + text[at + length :]
            case 2:
                text = text[:at] + chance.choice(PIECES) + text[at + length :]
            case _:
                other = chance.randrange(len(text) + 1)
                text = text[:at] + text[other : other + length] + text[at:]
    return text


@pytest.mark.hypothesis  # random, though seeded: the slow check tries more
@pytest.mark.slow
def test_a_damaged_world_loads_or_raises_a_mistake_with_a_place() -> None:
    chance, texts = random.Random(1), sources()
    loaded = 0

    for _ in range(MUTATIONS):
        text = damaged(chance.choice(texts), chance)
        try:
            scene = load_text(text, Path(worlds.MANUAL) / "garbage.world")
        except WorldError as mistake:
            lines = text.split("\n")
            assert mistake.line >= 1
            assert mistake.column >= 1
            if mistake.file == f"{worlds.MANUAL}/garbage.world":
                assert mistake.line <= len(lines)
                assert mistake.column <= len(lines[mistake.line - 1]) + 1
        else:
            loaded += 1
            assert all(model.root <= model.index for model in scene.models)

    assert 0 < loaded < MUTATIONS


def test_a_damaged_configuration_loads_or_raises_a_mistake_with_a_place(tmp_path: Path) -> None:
    (tmp_path / "w.world").write_text("position ( ranger ( ) )", encoding="utf-8")
    chance, loaded, file = random.Random(0), 0, tmp_path / "w.cfg"

    for _ in range(500):
        file.write_text(damaged(CONFIGURATION, chance), encoding="utf-8")
        try:
            it = load_configuration(file)
        except WorldError as mistake:
            assert mistake.line >= 1
            assert mistake.column >= 1
        else:
            loaded += 1
            assert it.scene is not None or it.physical_port is not None

    assert 0 < loaded < 500


def macro_bomb(levels: int) -> str:
    """Each macro holds the one before twice."""
    macros = ["define m0 model ( model ( ) )"]
    macros += [f"define m{i} model ( m{i - 1} ( ) m{i - 1} ( ) )" for i in range(1, levels)]
    return "\n".join([*macros, f"m{levels - 1} ( )"])


def wide_macro() -> str:
    """A body of many properties, replayed often."""
    body = " ".join(f"p{i} 1" for i in range(1000))
    return f"define m model ( {body} )\n" + "m ( )\n" * 5000


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (macro_bomb(40), "too-much"),
        (wide_macro(), "too-much"),
        ("model ( " * 1000, "nested-too-deep"),
        ("model ( pose " + "[ " * 1000, "nested-too-deep"),
        ("model ( block ( points 1e9 ) )", "too-few-points"),
        ("position ( ranger ( sensor ( samples 1e9 ) ) )", "out-of-range"),
        ("position ( ranger ( " + "sensor ( samples 10000 ) " * 250 + ") )", "too-much"),
        ("position ( bumper ( bcount 1e9 ) )", "out-of-range"),
        ("model ( size [ 1e12 1 1 ] )", "out-of-range"),
        ("model ( pose [ 1e6 0 0 0 ] )", "out-of-range"),
        ("model ( pose [ 1e400 0 0 0 ] )", "number-too-large"),
        ('model ( bitmap "/dev/zero" )', "bitmap-outside"),
        ('include "/dev/stdin"', "include-outside"),
        ("define a b ( ) define b a ( ) a ( )", "define-cycle"),
    ],
    ids=lambda value: value if len(value) < 30 else "",
)
def test_a_file_that_expands_without_limit_is_refused(text: str, code: str) -> None:
    with pytest.raises(WorldError) as mistake:
        load_text(text, Path("bomb.world"))

    assert mistake.value.code.value == code


LIMITS = {
    "words": ("a 1 " * 30_001, "The files of the world have more than 60 000 words."),
    "entities": (macro_bomb(40), "The world has more than 40 000 models, sensors and blocks."),
    "settings": (wide_macro(), "The models of the world have more than 1 000 000 properties."),
    "points": (
        "define b block ( points 2000 "
        + "".join(f"point[{i}] [ {i % 50} {i // 50} ] " for i in range(2000))
        + ")\n"
        "model ( " + "b ( ) " * 101 + ")",
        "The shapes of the world have more than 200 000 corners.",
    ),
    "samples": (
        "position ( ranger ( " + "sensor ( samples 10000 ) " * 250 + ") )",
        "The sensors of the world have more than 2 000 000 samples.",
    ),
}


@pytest.mark.parametrize("limit", LIMITS)
def test_a_world_beyond_a_limit_is_refused_with_the_true_cause(limit: str) -> None:
    text, sentence = LIMITS[limit]
    with pytest.raises(WorldError) as mistake:
        load_text(text, Path("large.world"))

    assert world_mistake(mistake.value, Words()).endswith(sentence)


PROCESSOR_SECONDS = 2
"""At most, with the start of Donnie; then the system ends the process. The processor's time hardly depends on
how busy the machine is. A refusal takes some .3 seconds of it, and took 34 before there were limits.
"""
LIMITED = f"""
import resource, runpy
resource.setrlimit(resource.RLIMIT_CPU, ({PROCESSOR_SECONDS}, {PROCESSOR_SECONDS}))
runpy.run_module("donnie_tui", run_name="__main__")
"""
OVER_LIMIT = {
    **{limit: text for limit, (text, _) in LIMITS.items()},
    "models in a file": "model ( )\n" * 90_000,
    "bytes": "a 1 " * 2_000_001,
    "depth": "model ( " * 100_000,
    "digits": "a " + "1" * 7_000_000 + "x",
    "macros of macros": macro_bomb(17),
}


@pytest.mark.slow
@pytest.mark.parametrize("limit", OVER_LIMIT)
def test_a_world_beyond_a_limit_is_refused_without_much_work(limit: str, tmp_path: Path) -> None:
    (tmp_path / "large.world").write_text(OVER_LIMIT[limit], encoding="utf-8")

    done = subprocess.run(
        [sys.executable, "-c", LIMITED, "world", "large.world"],
        cwd=tmp_path,
        env=environment(tmp_path, {"PYTHONPATH": str(ROOT)}),
        capture_output=True,
    )

    assert done.returncode == 2, done
    assert done.stderr.count(b"\n") == 1


def test_the_words_of_all_files_of_a_world_are_counted_together(tmp_path: Path) -> None:
    for number in range(3):
        (tmp_path / f"{number}.inc").write_text("a 1\n" * 10_000 + "b 1\n" * (number == 2), encoding="utf-8")

    with pytest.raises(WorldError) as mistake:
        load_text("".join(f'include "{number}.inc"\n' for number in range(3)), tmp_path / "top.world")

    assert mistake.value.details["what"] == "words"
    assert (mistake.value.file, mistake.value.line) == (str(tmp_path / "2.inc"), 9998)


def test_too_many_files_are_refused_with_the_true_cause(tmp_path: Path) -> None:
    (tmp_path / "one.inc").write_text("", encoding="utf-8")

    with pytest.raises(WorldError) as mistake:
        load_text('include "one.inc"\n' * 300, tmp_path / "top.world")

    assert world_mistake(mistake.value, Words()).endswith("Too many files, at most 200 in a world.")


def test_a_number_of_many_digits_that_is_none_is_refused_at_once() -> None:
    """Each of its digits could otherwise be the last one of its whole part."""
    with pytest.raises(WorldError) as mistake:
        load_text("a " + "1" * 1_000_000 + "x", Path("large.world"))

    assert mistake.value.code.value == "bad-number"


def test_a_folder_with_a_file_of_blank_lines_is_searched_at_once(tmp_path: Path) -> None:
    (tmp_path / "blank.inc").write_text("\n" * 200_000, encoding="utf-8")

    with pytest.raises(WorldError) as mistake:
        load_text("chair ( )", tmp_path / "top.world")

    assert mistake.value.code.value == "unknown-type"


def test_twenty_files_that_include_the_next_one_twice_are_refused(tmp_path: Path) -> None:
    """Without a limit they would be a million files."""
    for i in range(20):
        (tmp_path / f"{i}.inc").write_text(f'include "{i + 1}.inc"\n' * 2, encoding="utf-8")
    (tmp_path / "20.inc").write_text("model ( )", encoding="utf-8")

    with pytest.raises(WorldError) as mistake:
        load_text('include "0.inc"', tmp_path / "bomb.world")
    assert mistake.value.code.value == "include-too-deep"
