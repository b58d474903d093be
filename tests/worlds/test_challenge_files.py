"""What the file of a challenge says: goals by their keys, limits, defaults, and the line of each mistake."""

from pathlib import Path

import pytest

from worlds import challenges
from worlds.challenges import (
    Avoided,
    BadChallenge,
    Challenge,
    ChallengeHint,
    ChallengeQuestion,
    ChallengeText,
    Goal,
    Limit,
    Never,
    Rules,
    Variant,
    line_of,
    sides_of,
)
from worlds.words import Difficulty

HEAD = 'format = 1\nworld = "first_room"\n[en]\ntitle = "T"\ntask = "Do."\n'
GOAL = '[[goal]]\nat = "ball"\n'


def read(folder: Path, text: str, name: str = "it.toml") -> Challenge:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return challenges.read(file)


def mistakes(folder: Path, text: str) -> list[tuple[str, int, str]]:
    with pytest.raises(BadChallenge) as bad:
        read(folder, text)
    assert bad.value.file == folder / "it.toml"
    return [(each.code, each.line, each.what) for each in bad.value.mistakes]


# --- goals

PLACE = (1.0, 2.0)
CORNERS = ((5.0, -1.0), (-3.0, 4.0))


@pytest.mark.parametrize(
    ("goal", "kind"),
    [
        (Goal(), ""),
        (Goal(at="ball"), "at"),
        (Goal(at=PLACE), "at"),
        (Goal(facing=0.0), "facing"),
        (Goal(visited=("ball",)), "visited"),
        (Goal(near="ball"), "near"),
        (Goal(area=CORNERS), "area"),
        (Goal(thing="ball"), ""),
        (Goal(thing="ball", at=PLACE), "thing"),
        (Goal(thing="ball", area=CORNERS), "thing"),
        (Goal(thing="ball", near="box"), ""),
        (Goal(said=0), "said"),
        (Goal(said=""), "said"),
        (Goal(counted="n"), "counted"),
        (Goal(holds="ball"), "holds"),
        (Goal(robots=("bob",)), "robots"),
        (Goal(robots=("bob",), at="ball"), "robots"),
        (Goal(robots=("bob",), area=CORNERS), ""),
        (Goal(at="ball", facing=0.0), ""),
        (Goal(at="ball", area=CORNERS), ""),
    ],
)
def test_a_goal_is_what_its_keys_say_together(goal: Goal, kind: str) -> None:
    assert goal.kind == kind


@pytest.mark.parametrize(
    ("goal", "targets", "areas", "is_sensed"),
    [
        (Goal(at=PLACE), (PLACE,), ((PLACE, PLACE),), True),
        (Goal(at="ball"), ("ball",), (), False),
        (Goal(visited=(PLACE, "ball")), (PLACE, "ball"), ((PLACE, PLACE),), False),
        (Goal(near=PLACE), (PLACE,), ((PLACE, PLACE),), True),
        (Goal(area=CORNERS), (), (CORNERS,), True),
        (Goal(thing="ball", area=CORNERS), ("ball",), (CORNERS,), False),
        (Goal(thing="ball", at=PLACE), (PLACE, "ball"), ((PLACE, PLACE),), False),
        (Goal(holds="ball"), ("ball",), (), False),
        (Goal(robots=("bob",)), (), (), False),
        (Goal(facing=90.0), (), (), True),
        (Goal(said="x"), (), (), True),
        (Goal(counted="n"), (), (), True),
    ],
)
def test_a_goal_names_things_places_and_areas_and_may_be_known_to_a_real_robot(
    goal: Goal, targets: tuple[object, ...], areas: tuple[object, ...], is_sensed: bool
) -> None:
    assert (goal.targets, goal.areas, goal.is_sensed) == (targets, areas, is_sensed)


def test_an_area_has_its_sides_in_whatever_order_its_corners_are() -> None:
    assert sides_of(CORNERS) == sides_of(CORNERS[::-1]) == (-3, -1, 5, 4)


def test_the_places_of_goals_have_the_numbers_of_these() -> None:
    goals = (Goal(at="ball"), Goal(visited=(PLACE, (3.0, 3.0))), Goal(area=CORNERS))

    assert Rules(1, "w", goals).goal_places == ((2, 1, 2, 1, 2), (2, 3, 3, 3, 3), (3, -3, -1, 5, 4))


def test_a_real_robot_does_not_know_what_it_must_not_touch_or_approach() -> None:
    never = Never(True, ("table",), ("cat", "dog"), 3.0)
    rules = Rules(1, "w", (Goal(at=PLACE), Goal(at="ball")), never=never)

    avoided = (Avoided("touch", "table", 3), Avoided("near", "cat", 3), Avoided("near", "dog", 3))
    assert never.avoided == avoided
    assert rules.unsensed == (rules.goal[1], *avoided)
    assert Never(True).avoided == ()


@pytest.mark.parametrize(
    ("ask", "of", "is_complete"),
    [
        *(("count", "ball", True), ("count", ("ball",), True), ("direction", ("a", "b"), False)),
        *(("order", "ball", False), ("order", ("ball",), False), ("order", ("a", "b"), True)),
        *(("order", tuple("abcdefghi"), True), ("order", tuple("abcdefghij"), False), ("count", (), False)),
    ],
)
def test_a_question_is_about_one_thing_or_about_the_order_of_two_to_nine(
    ask: challenges.Ask, of: str | tuple[str, ...], is_complete: bool
) -> None:
    assert ChallengeQuestion(ask, of).is_complete is is_complete


# --- what is read


def test_a_file_has_the_defaults_of_the_guide(tmp_path: Path) -> None:
    found = read(tmp_path, HEAD + GOAL + "[[question]]\nask = 'count'\nof = 'ball'\n")

    assert found.rules == Rules(
        format=1,
        world="first_room",
        goal=(Goal("ball", None, None, None, None, None, None, None, None, None, "", 0, 1.0, False, False),),
        difficulty=Difficulty.UNSTATED,
        after=(),
        words=(),
        required=(),
        never=Never(False, (), (), 2.0),
        limit=Limit(None, None, None, None),
        variant=(Variant(None, {}, 0),),
        question=(ChallengeQuestion("count", "ball", "start", None),),
    )
    assert found.texts == {"en": ChallengeText("T", "Do.", ())}
    assert (found.name, found.path, found.lines[1]) == ("it", tmp_path / "it.toml", 'world = "first_room"')


def test_everything_that_a_file_says_is_read(tmp_path: Path) -> None:
    (tmp_path / "my.world").write_text("")
    text = """\
format = 1
world = "my.world"
difficulty = "hard"
after = ["first_walk", "it"]
words = ["FW"]
required = ["REPEAT"]
[en]
title = "T"
task = "Do.\\nStop."
[[en.hint]]
text = "One."
[[en.hint]]
text = "Two."
[pt]
title = "P"
task = "Faz."
[[goal]]
at = [1, 2.5]
within = 0
robot = "bob"
[[goal]]
visited = ["a", [0, 0]]
any_order = true
[[goal]]
area = [[0, 1], [2, 3]]
stay = true
[[goal]]
counted = "n"
value = -7
[never]
bump = true
touch = ["a"]
near = ["b"]
within = 4
[limit]
commands = 0
seconds = 1.5
steps = 3
turns = 4
[[variant]]
start = [1, 2, "west"]
seed = 9
[[variant]]
things = { a = [3, 4] }
[[question]]
ask = "direction"
of = "a"
from = [1, 1]
tolerance = 20
"""
    found = read(tmp_path, text)

    assert found.rules == Rules(
        1,
        "my.world",
        (
            Goal(at=(1.0, 2.5), within=0, robot="bob"),
            Goal(visited=("a", (0, 0)), any_order=True),
            Goal(area=((0, 1), (2, 3)), stay=True),
            Goal(counted="n", value=-7),
        ),
        Difficulty.HARD,
        ("first_walk", "it"),
        ("FW",),
        ("REPEAT",),
        Never(True, ("a",), ("b",), 4),
        Limit(0, 1.5, 3, 4),
        (Variant((1, 2, "west"), {}, 9), Variant(None, {"a": (3, 4)}, 0)),
        (ChallengeQuestion("direction", "a", (1, 1), 20),),
    )
    assert [each.text for each in found.text("en").hint] == ["One.", "Two."]
    assert found.text("en").sentences == ("Do.", "Stop.")
    assert (found.text("pt").title, found.text("es").title) == ("P", "T")
    assert found.world == str(tmp_path / "my.world")
    assert found.solution() == tmp_path / "it.solution.gd"
    assert found.solution("bob") == tmp_path / "it.bob.solution.gd"
    assert [name for name, _ in found.rules.parts] == [
        *("never", "goal[0]", "goal[1]", "goal[2]", "goal[3]", "variant[0]", "variant[1]", "question[0]"),
    ]


@pytest.mark.parametrize(
    ("form", "most", "least"),
    [
        ("[[goal]]\nat = [0, {}]\n", 1_000_000, -1_000_000),
        ("[[goal]]\nsaid = {}\n", 1_000_000, -1_000_000),
        ("[[goal]]\ncounted = 'n'\nvalue = {}\n", 1_000_000, -1_000_000),
        ("[[goal]]\nat = 'ball'\nwithin = {}\n", 1_000_000, 0),
        ("[[goal]]\nfacing = {}\n", 1_000_000, -1_000_000),
        (GOAL + "[limit]\ncommands = {}\n", 1_000_000, 0),
        (GOAL + "[limit]\nseconds = {}\n", 1_000_000, 0),
        (GOAL + "[[variant]]\nseed = {}\n", 1_000_000, -1_000_000),
        (GOAL + "[[variant]]\nstart = [{}, 0, 0]\n", 1_000_000, -1_000_000),
    ],
)
def test_numbers_go_to_a_million(form: str, most: int, least: int, tmp_path: Path) -> None:
    for within in (most, least):
        read(tmp_path, HEAD + form.format(within))
    for beyond in (most + 1, least - 1):
        ((code, _, _),) = mistakes(tmp_path, HEAD + form.format(beyond))
        assert code == "challenge-value"


@pytest.mark.parametrize(
    "part", ["[[goal]]\nat = 'ball'\n", "[[variant]]\n", "[[question]]\nask = 'count'\nof = 'ball'\n"]
)
def test_a_challenge_has_fifty_goals_starts_or_questions_at_most(part: str, tmp_path: Path) -> None:
    more = "" if "goal" in part else GOAL

    read(tmp_path, HEAD + more + part * 50)
    ((code, _, what),) = mistakes(tmp_path, HEAD + more + part * 51)
    assert (code, what) == ("challenge-value", part[2 : part.index("]")])


def test_a_file_has_a_hundred_thousand_bytes_at_most(tmp_path: Path) -> None:
    text = HEAD + GOAL

    read(tmp_path, text + "#" * (100_000 - len(text)))
    assert mistakes(tmp_path, text + "#" * (100_001 - len(text))) == [("challenge-too-large", 0, "100 000")]


def test_a_file_with_a_mark_of_its_encoding_and_lines_of_windows_is_read(tmp_path: Path) -> None:
    (tmp_path / "it.toml").write_bytes(b"\xef\xbb\xbf" + (HEAD + GOAL).replace("\n", "\r\n").encode())

    assert challenges.read(tmp_path / "it.toml").lines == (*(HEAD + GOAL).split("\n"),)


def test_a_file_that_is_no_text_or_not_there_is_one_mistake(tmp_path: Path) -> None:
    (tmp_path / "it.toml").write_bytes(b"\xff\xfe")
    for name, code in (("it.toml", "challenge-not-toml"), ("other.toml", "challenge-unreadable")):
        with pytest.raises(BadChallenge) as bad:
            challenges.read(tmp_path / name)
        assert [(each.code, each.line) for each in bad.value.mistakes] == [(code, 0)]


# --- mistakes


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (HEAD.replace("en", "english") + GOAL,
         [("challenge-missing", 0, "en.title"), ("challenge-key", 3, "english")]),
        (HEAD.replace("[en]", "[e1]") + GOAL,
         [("challenge-missing", 0, "en.title"), ("challenge-key", 3, "e1")]),
        ("pt = 3\n" + HEAD + GOAL, [("challenge-key", 1, "pt")]),
        ("en = 3\nformat = 1\nworld = 'first_room'\n" + GOAL,
         [("challenge-missing", 0, "en.title"), ("challenge-key", 1, "en")]),
        (HEAD.replace('title = "T"\n', "") + GOAL, [("challenge-missing", 3, "en.title")]),
        (HEAD.replace("format = 1\n", "") + GOAL, [("challenge-missing", 0, "format")]),
        (HEAD.replace('world = "first_room"\n', "") + GOAL, [("challenge-missing", 0, "world")]),
        (HEAD.replace("format = 1", "format = 2") + GOAL, [("challenge-value", 1, "format")]),
        (HEAD.replace("world", "wrld") + GOAL, [("challenge-key", 2, "wrld")]),
        (HEAD.replace("first_room", "x.world") + GOAL, [("challenge-world", 2, "x.world")]),
        (HEAD.replace("first_room", "sub/x.world") + GOAL, [("challenge-outside", 2, "sub/x.world")]),
        (HEAD + "[[en.hint]]\n" + GOAL, [("challenge-missing", 6, "en.hint[0].text")]),
        (HEAD + GOAL + "[[question]]\nof = 'ball'\n", [("challenge-missing", 8, "question[0].ask")]),
        (HEAD + GOAL + "[[question]]\nask = 'count'\n", [("challenge-missing", 8, "question[0].of")]),
        (HEAD + GOAL + "[[question]]\nask = 'count'\nof = ['a', 'b']\n", [("challenge-value", 10, "of")]),
        (HEAD + GOAL + "[[question]]\nask = 'order'\nof = 'a'\n", [("challenge-value", 10, "of")]),
        (HEAD + GOAL + "[limit]\nsteps = 1.5\n", [("challenge-value", 9, "steps")]),
        (HEAD + GOAL + "[never]\nbump = 1\n", [("challenge-value", 9, "bump")]),
        (HEAD + GOAL + "[[variant]]\nstart = [0, 0, 'up']\n", [("challenge-choice", 9, "up")]),
        (HEAD + "[[goal]]\nfacing = 'up'\n", [("challenge-choice", 7, "up")]),
        (HEAD + GOAL + "[goals]\nx = 1\n", [("challenge-key", 8, "goals")]),
        (HEAD + "goal = 3\n", [("challenge-key", 6, "goal")]),
        ("goal = 3\n" + HEAD, [("challenge-value", 1, "goal")]),
        ("goal = [3]\n" + HEAD, [("challenge-value", 1, "goal")]),
        ("limit = 3\n" + HEAD + GOAL, [("challenge-value", 1, "limit")]),
        ("after = ['it', 'first_walk', 'nowhere']\n" + HEAD + GOAL, [("challenge-unknown", 1, "nowhere")]),
        ("after = [\n'it',\n'nowhere',\n\"none\"]\n" + HEAD + GOAL,
         [("challenge-unknown", 3, "nowhere"), ("challenge-unknown", 4, "none")]),
        (HEAD, [("challenge-solution", 0, "it.solution.gd")]),
        (HEAD + "[[goal]]\nthing = 'ball'\n", [("challenge-missing", 6, "goal.at")]),
        (HEAD + "[[goal]]\n", [("challenge-goal", 6, ", ".join(challenges.KINDS))]),
        (HEAD + "[[goal]]\nwithin = 'x'\n" + GOAL, [("challenge-value", 7, "within")]),
    ],
)  # fmt: skip
def test_each_mistake_has_its_line_and_what_is_wrong(
    text: str, found: list[tuple[str, int, str]], tmp_path: Path
) -> None:
    assert mistakes(tmp_path, text) == found


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        # a table's head takes the table with it, a value only itself
        (HEAD + "[[goal]]\nat = = 3\n", [7]),
        (HEAD + "[[goal\nat = 'ball'\nwithin = = 2\n" + GOAL, [6]),
        (HEAD + "[[goal]]\nat = = 3\nsaid = 'x'\n" + GOAL + "within = = 2\n", [7, 11]),
        # a bracket that stays open is reported where it opens
        (HEAD + "[[goal]]\nat = [0,\n5\nwithin = 1\n" + GOAL, [7]),
        (HEAD + "[[goal]]\nat = [0,\n5\n[limit]\nsteps = 1\n", [7]),
        (HEAD + "[[goal]]\nat = [0, 5\n\n\n" + GOAL, [7]),
        (HEAD + "[[goal]]\nat = [\n0,\n5 6 ]\nwithin = 1\n", [9]),
        ("format = [1\n" + HEAD[11:] + GOAL, [1]),
        ('"""\n', [1]),
    ],
)
def test_what_can_not_be_read_is_left_out_and_the_rest_is_read(
    text: str, lines: list[int], tmp_path: Path
) -> None:
    found = mistakes(tmp_path, text)

    assert [(code, line) for code, line, _ in found] == [("challenge-not-toml", each) for each in lines]


@pytest.mark.parametrize(
    ("text", "known"),
    [
        ("difficulty = 'esay'\n" + HEAD + GOAL, ("easy", "medium", "hard")),
        (HEAD + GOAL + "[[question]]\nask = 'x'\nof = 'a'\n",
         ("direction", "distance", "count", "colour", "order")),
        (HEAD + "[[goal]]\nfacing = 'x'\n", ("north", "east", "south", "west")),
        (HEAD + GOAL + "[limit]\nstep = 1\n", ("commands", "seconds", "steps", "turns")),
        (HEAD + GOAL + "[limit]\nsteps = 'x'\n", ()),
        (HEAD + GOAL + "[[question]]\nask = 'count'\nof = 'a'\norigin = 'b'\n",
         ("ask", "of", "from", "tolerance")),
    ],
)  # fmt: skip
def test_a_wrong_word_comes_with_those_that_may_be_meant(
    text: str, known: tuple[str, ...], tmp_path: Path
) -> None:
    with pytest.raises(BadChallenge) as bad:
        read(tmp_path, text)

    assert [each.known for each in bad.value.mistakes] == [known]


def test_what_is_wrong_in_a_file_is_empty_in_what_was_read_of_it(tmp_path: Path) -> None:
    question = "[[question]]\nask = 'x'\nof = 3\n"
    with pytest.raises(BadChallenge) as bad:
        read(tmp_path, f"format = 1\nworld = 3\n[en]\ntitle = 3\n[[en.hint]]\n{GOAL}{question}")

    found = bad.value.found
    assert found is not None
    assert found.rules == Rules(1, "", (Goal("ball"),), question=(ChallengeQuestion("count", ()),))
    assert found.texts == {"en": ChallengeText("", "", (ChallengeHint(""),))}


def test_a_challenge_may_have_a_configuration_as_its_world_and_its_solution_as_its_goal(
    tmp_path: Path,
) -> None:
    (tmp_path / "my.cfg").write_text("")
    (tmp_path / "it.solution.gd").write_text("FW 5")

    assert read(tmp_path, HEAD.replace("first_room", "my.cfg")).rules.goal == ()


def test_a_file_that_is_nested_too_deep_is_one_mistake(tmp_path: Path) -> None:
    found = mistakes(tmp_path, "a = " + "[" * 20_000 + "\n" + HEAD)

    assert [code for code, _, _ in found] == ["challenge-not-toml"]


def test_twenty_mistakes_are_listed(tmp_path: Path) -> None:
    for each in ("key{} = 1\n", "key{} = = 1\n"):
        found = mistakes(tmp_path, "".join(each.format(at) for at in range(30)) + HEAD + GOAL)
        assert [line for _, line, _ in found] == [*range(1, 21)]


LINES = [
    "format = 1",
    '"world" = "x"',
    "[en]",
    "title = 3",
    "[[ goal ]]",
    "at = [",
    "  'ball',",
    '  "box",',
    "]",
    "[[goal]]",
    "at = 'box'",
    "[[en.hint]]",
    "'text' = 1",
    "[[en.hint]]",
    'text = ""',
]


@pytest.mark.parametrize(
    ("table", "key", "text", "line"),
    [
        *(
            ("", "format", "", 1),
            ("", "world", "", 2),
            ("", "en", "", 3),
            ("en", "", "", 3),
            ("en", "title", "", 4),
        ),
        *(
            ("goal[0]", "at", "", 6),
            ("goal[0]", "", "", 5),
            ("goal[0]", "near", "", 5),
            ("goal[1]", "at", "", 11),
        ),
        *(("goal[1]", "", "", 10), ("goal[2]", "at", "", 0), ("en.hint[0]", "text", "", 13)),
        *(
            ("en.hint[1]", "text", "", 15),
            ("", "goal", "", 5),
            ("", "nothing", "", 0),
            ("pt", "title", "", 0),
        ),
        *(("goal[0]", "at", "ball", 7), ("goal[0]", "at", "box", 8), ("goal[1]", "at", "box", 11)),
        *(("goal[0]", "at", "cat", 6), ("goal[0]", "at", "bal", 6)),
    ],
)
def test_a_key_is_found_at_its_line_else_its_table(table: str, key: str, text: str, line: int) -> None:
    assert line_of(LINES, table, key, text) == line


# --- which file it is


def test_a_challenge_is_found_by_its_number_name_file_or_folder(tmp_path: Path) -> None:
    read(tmp_path, HEAD + GOAL)
    (tmp_path / "two/deep").mkdir(parents=True)
    read(tmp_path, HEAD + GOAL, "two/b.toml")
    read(tmp_path, HEAD + GOAL, "two/a.toml")
    read(tmp_path, HEAD + GOAL, "two/deep/c.toml")

    first, second, *_ = challenges.names()
    assert challenges.find("1").name == challenges.find(first).name == first
    assert challenges.find("2").name == second
    assert [challenges.find(str(tmp_path / name)).path.name for name in ("it.toml", "it", "two/b")] == [
        *("it.toml", "it.toml", "b.toml"),
    ]
    assert challenges.find(str(tmp_path / "two/deep")).name == "c"
    assert [str(each.relative_to(tmp_path)) for each in challenges.files_in(str(tmp_path / "two"))] == [
        *("two/a.toml", "two/b.toml", "two/deep/c.toml"),
    ]
    assert challenges.files_in("") == challenges.files_in(str(tmp_path / "none")) == ()


@pytest.mark.parametrize(
    ("name", "code"), [("nothing", "unknown"), ("0", "unknown"), ("999", "unknown"), ("two", "several")]
)
def test_a_name_that_is_of_none_or_of_several_is_said(name: str, code: str, tmp_path: Path) -> None:
    (tmp_path / "two").mkdir()
    for each in ("a", "b"):
        read(tmp_path, HEAD + GOAL, f"two/{each}.toml")
    typed = str(tmp_path / name) if name == "two" else name
    with pytest.raises(BadChallenge) as bad:
        challenges.find(typed)

    (mistake,) = bad.value.mistakes
    several = tuple(str(tmp_path / f"two/{each}.toml") for each in "ab")
    assert (mistake.code, mistake.what, mistake.line) == (f"challenge-{code}", typed, 0)
    assert mistake.known == (several if code == "several" else challenges.names())


def test_after_each_challenge_comes_the_next_and_after_the_last_none() -> None:
    first, second, *_, last = challenges.names()

    assert [challenges.after(name) for name in (first, last, "mine")] == [second, None, None]


def test_the_title_of_another_challenge_is_that_of_its_file_or_its_name(tmp_path: Path) -> None:
    it = read(tmp_path, HEAD + GOAL)
    read(tmp_path, HEAD.replace('"T"', '"Other"') + GOAL, "other.toml")
    (tmp_path / "bad.toml").write_text("?")

    assert [it.title_of(name, "en") for name in ("other", "bad", "none")] == ["Other", "bad", "none"]
    assert it.title_of("first_walk", "es") == "El primer paseo"
