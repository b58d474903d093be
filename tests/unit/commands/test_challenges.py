"""CHALLENGE, TASK, GOALS, HINT, NEXT CHALLENGE, RESULTS: what is to be done, and the verdict after a run."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from donnie_tui.bootstrap import progress
from donnie_tui.commands.interaction import EnterWorld
from donnie_tui.core.events import Chimed, CueSounded, RunEnded, Stamped
from donnie_tui.core.program_files import Attempted
from donnie_tui.core.runner import RunRequest
from donnie_tui.i18n.words import Words
from donnie_tui.world.loading import choose_world
from tests.conftest import ROOT
from tests.unit.commands.scripted import Script
from worlds import challenges

OpenScript = Callable[..., Script]

ASKING = (ROOT / "tests" / "asking.toml").read_text() + '[[question]]\nask = "count"\nof = "ball"\n'


def test_the_verdict_follows_each_run_and_counts_from_the_start(open_script: OpenScript) -> None:
    script = open_script(world="challenge:first_walk")

    assert script.answers_to("FW 4")[1:] == ["0 of 1 goal. You stopped 1 step south of 0, 5."]
    assert script.answers_to("FW 1")[1:] == ["Solved, in 2 commands.", "NEXT CHALLENGE is: To the ball."]
    script.type("RESET")
    assert script.answers_to("FW 5")[1:2] == ["Solved, in 1 command."]


def test_a_program_must_solve_the_challenge_from_every_start(open_script: OpenScript) -> None:
    script = open_script(world="challenge:to_the_cone")

    said = script.answers_to("SPEAK DISTANCE F", "FW 8")
    assert "From start 2: " in said[-2]
    assert "You touched the green cone." in said[-2]
    script.type("RESET")
    assert "Solved, in 1 command." in script.answers_to("FW DISTANCE F - 1")


def test_lines_are_tried_from_the_other_starts_one_after_the_other(open_script: OpenScript) -> None:
    """From the second start Bob is at 19: 4 steps are between them when Alice looks, less two bodies of 3."""
    script = open_script(world="challenge:meet")

    script.answers_to("FW 5")
    script.type("ROBOT bob")
    script.answers_to("FW 10")
    script.type("ROBOT alice")
    assert "Solved, in 3 commands." in script.answers_to("FW DISTANCE F - 1")


@pytest.mark.parametrize(
    ("world", "lines", "verdict"),
    [
        ("to_the_ball", ["SPEAK 1", "TR 90"], "0 of 1 goal. SPEAK comes in challenge 4. "),
        ("there_and_back", ["FW 4", "FW 4", "BW 8"], "3 of 3 goals. It took 3 commands. The most is 2."),
        ("to_the_ball", ["FW 40", "TR 90"], "0 of 1 goal. The ball is still"),
    ],
)
def test_what_no_further_line_repairs_is_followed_by_the_word_that_begins_anew_once(
    open_script: OpenScript, world: str, lines: list[str], verdict: str
) -> None:
    script = open_script(world=f"challenge:{world}")
    for _ in range(2):
        said = script.answers_to(*lines)

        assert [each for each in said if each.startswith(verdict)]
        assert said.count("RESET begins again.") == 1
        assert script.answers_to("FW 1").count("RESET begins again.") == 0
        script.type("RESET")


def test_all_mistakes_of_a_file_are_said_a_sentence_each(open_script: OpenScript, tmp_path: Path) -> None:
    file = tmp_path / "it.toml"
    text = Path(challenges.LADDERS, "first_walk.toml").read_text(encoding="utf-8")
    file.write_text(text.replace("\nat = ", "\natt = ") + '[nver]\n[[goal]]\nat = "bal"\n', encoding="utf-8")
    lines = file.read_text(encoding="utf-8").splitlines()
    at, never, ball = (lines.index(each) + 1 for each in ("att = [0, 5]", "[nver]", 'at = "bal"'))

    assert open_script().answers_to(f"CHALLENGE {file}") == [
        f"Line {at}: it.toml has the key att. Did you mean at?",
        f"Line {never}: it.toml has the key nver. Did you mean never?",
        f"Line {ball}: it.toml names bal, and its world has no such thing. Did you mean ball?",
    ]


def test_a_start_that_moves_nothing_is_the_world_as_it_is(open_script: OpenScript, tmp_path: Path) -> None:
    file = tmp_path / "it.toml"
    file.write_text(
        'format = 1\nworld = "object_field"\n[en]\ntitle = "T"\ntask = "Do."\n'
        '[[goal]]\nat = "green cone"\nwithin = 1.5\n'
        '[[variant]]\nstart = [0, 1, 0]\nthings = { "green cone" = [0, 7] }\n[[variant]]\n'
    )
    script = open_script(world=f"challenge:{file}")

    assert "Solved, in 1 command." in script.answers_to("FW DISTANCE F - 1")
    script.type("RESET")
    assert (
        "From start 2: The green cone is still 6 steps away, to the north." in script.answers_to("FW 3")[-1]
    )


def test_a_line_with_a_mistake_of_form_is_no_try(open_script: OpenScript) -> None:
    script = open_script(world="challenge:first_walk")

    assert not any("goal" in line for line in script.answers_to("FWW 5"))
    assert script.answers_to("RESULTS") == ["You have not tried a challenge yet."]
    assert "Solved, in 1 command." in script.answers_to("FW 5")


def test_goals_say_what_is_met_and_what_is_missing_at_any_time(open_script: OpenScript) -> None:
    script = open_script(world="challenge:there_and_back")

    assert script.answers_to("GOALS") == [
        "Goal 1: You did not get to 0, 8.",
        "Goal 2: met.",
        "Goal 3: met.",
    ]
    script.answers_to("FW 8", "TR 90")
    assert script.answers_to("GOALS") == [
        "Goal 1: met.",
        "Goal 2: You stopped 8 steps north of 0, 0.",
        "Goal 3: You must turn 90 degrees more to the left.",
    ]


def test_hints_are_given_one_at_a_time(open_script: OpenScript) -> None:
    script = open_script(world="challenge:to_the_ball")

    assert script.answers_to("HINT", "HINT", "HINT") == [
        "Turn right by 90 degrees first.",
        "The ball is 8 steps away. Walk less than that.",
        "There are no more hints.",
    ]


def test_the_task_is_said_again_also_that_of_a_world(open_script: OpenScript) -> None:
    challenge, world = open_script(world="challenge:first_walk"), open_script(world="living_room")

    assert challenge.answers_to("TASK") == ["Challenge: The first walk.", "Walk 5 steps to the north."]
    assert world.answers_to("TASK")[0].startswith("Task: ")
    assert world.answers_to("GOALS", "HINT") == ["No challenge here. Type CHALLENGE."] * 2


def test_a_world_without_words_has_no_task(open_script: OpenScript, tmp_path: Path) -> None:
    file = tmp_path / "mine.world"
    file.write_text('include "donnie.inc"\ndonnie( pose [ 0 0 0 90 ] )\n')

    assert open_script(world=str(file)).answers_to("TASK") == ["No challenge here. Type CHALLENGE."]


def test_the_list_says_which_are_solved_and_results_count_tries(open_script: OpenScript) -> None:
    script = open_script(world="challenge:first_walk")
    script.answers_to("HINT", "FW 4", "FW 1")

    assert script.answers_to("CHALLENGE")[:2] == ["1. The first walk: solved", "2. To the ball"]
    assert script.answers_to("RESULTS") == [
        "1 of 1 solved.",
        "The first walk: solved, 2 tries, 1 hint, 0 bumps.",
        "5 steps in 5 seconds. The shortest way takes 5.",
    ]


def test_what_should_be_solved_before_is_said_on_arrival_until_it_is_solved(
    open_script: OpenScript, tmp_path: Path
) -> None:
    file = tmp_path / "it.toml"
    file.write_text(ASKING.replace("[en]", 'after = ["first_walk", "other", "bad"]\n[en]', 1))
    file.with_name("other.toml").write_text(ASKING.replace('"Three steps"', '"Before"'))
    file.with_name("bad.toml").write_text("?")

    def said_first() -> list[str]:
        return list(open_script(world=f"challenge:{file}").donnie.notices.about_world)

    arrival = ["Challenge: Three steps. World: First room.", "Walk 3 steps to the north."]
    assert said_first() == [*arrival, "Best solved after: The first walk, Before, bad."]
    open_script(world="challenge:first_walk").answers_to("FW 5")
    assert said_first() == [*arrival, "Best solved after: Before, bad."]


def test_results_say_the_time_where_there_is_no_way_to_compare(open_script: OpenScript) -> None:
    script = open_script(world="challenge:first_walk")
    script.answers_to("FW 4")

    # 4 steps at a step a second.
    assert script.answers_to("RESULTS")[1:] == [
        "The first walk: not yet, 1 try, 0 hints, 0 bumps.",
        "4 seconds.",
    ]


def test_results_count_a_hint_that_was_asked_for_after_the_last_try(open_script: OpenScript) -> None:
    script = open_script(world="challenge:first_walk")
    script.answers_to("FW 4", "HINT")

    assert script.answers_to("RESULTS")[1] == "The first walk: not yet, 1 try, 1 hint, 0 bumps."


def test_results_count_a_try_that_is_not_written_yet(open_script: OpenScript) -> None:
    """As while its questions are still to be asked."""
    script = open_script(world="challenge:first_walk")
    script.answers_to("FW 4")
    attempt = script.ctx.attempt
    assert attempt is not None
    attempt.tried = Attempted("now", "first_walk", True, 1, 1, 1, 5, 0, 0, seconds=7, shortest=5)

    assert script.answers_to("RESULTS") == [
        "1 of 1 solved.",
        "The first walk: solved, 2 tries, 0 hints, 0 bumps.",
        "5 steps in 7 seconds. The shortest way takes 5.",
    ]


def tried(
    name: str, solved: bool, steps: int, bumps: int, hints: int, seconds: int, shortest: int, *answered: int
) -> Attempted:
    return Attempted("now", name, solved, 1, 1, 2, steps, bumps, hints, seconds, shortest, *answered)


def test_results_of_each_challenge_are_those_of_its_tries_wherever_the_learner_is(
    open_script: OpenScript,
) -> None:
    """The fewest steps that solved it, else the last try; the most hints, all bumps, the best answers."""
    script = open_script()
    for each in (
        *(tried("first_walk", True, 9, 1, 2, 12, 6, 3, 2), tried("first_walk", True, 6, 0, 1, 7, 6, 3, 1)),
        *(tried("first_walk", True, 8, 0, 0, 8, 6), tried("first_walk", False, 3, 4, 0, 99, 6)),
        *(tried("to_the_ball", False, 3, 0, 0, 8, 0), tried("to_the_ball", False, 9, 0, 0, 1, 0)),
        *(tried("maze", False, 3, 0, 0, 8, 9), tried("maze", False, 0, 0, 0, 0, 9)),
        tried("of_a_file", True, 1, 2, 0, 1, 1),
    ):
        progress().add(each)

    assert script.answers_to("RESULTS") == [
        "2 of 4 solved.",
        "The first walk: solved, 4 tries, 2 hints, 5 bumps.",
        "6 steps in 7 seconds. The shortest way takes 6.",
        "You answered 2 of 3 questions right.",
        "To the ball: not yet, 2 tries, 0 hints, 0 bumps.",
        "1 second.",
        "The maze: not yet, 2 tries, 0 hints, 0 bumps.",
        "of_a_file: solved, 1 try, 0 hints, 2 bumps.",
        "1 step in 1 second. The shortest way takes 1.",
    ]


def test_hints_of_this_session_count_for_its_challenge_only(open_script: OpenScript) -> None:
    script = open_script(world="challenge:to_the_ball")
    progress().add(tried("first_walk", False, 3, 0, 0, 0, 0))
    progress().add(tried("to_the_ball", False, 3, 0, 1, 0, 0))
    script.answers_to("HINT", "HINT")

    assert script.answers_to("RESULTS") == [
        "0 of 2 solved.",
        "The first walk: not yet, 1 try, 0 hints, 0 bumps.",
        "To the ball: not yet, 1 try, 2 hints, 0 bumps.",
    ]


def test_the_challenge_that_is_chosen_from_the_list_is_entered(open_script: OpenScript) -> None:
    script = open_script(answers=["maze"], world="challenge:to_the_ball")
    progress().add(tried("first_walk", True, 5, 0, 0, 0, 0))

    with pytest.raises(EnterWorld) as entered:
        script.type("CHALLENGE")

    assert entered.value.name == "challenge:maze"
    assert script.interaction.asked[0] == "Which challenge?"
    first, second, third, *others = script.interaction.offered
    assert [each.text for each in (first, second, third)] == [
        *("1. The first walk: solved", "2. To the ball", "3. There and back"),
    ]
    assert [each.value for each in (first, second)] == ["first_walk", "to_the_ball"]
    assert [each.is_current for each in (first, second, third)] == [False, True, False]
    assert len(others) + 3 == len(challenges.names())
    assert second.detail is not None
    assert [*second.detail(40, 5)][:2] == [
        "Challenge: To the ball.",
        "Walk to the yellow ball in the east.",
    ]


@pytest.mark.parametrize(
    ("world", "solved", "following"),
    [
        ("open_floor", (), "first_walk"),
        ("open_floor", ("first_walk",), "to_the_ball"),
        ("challenge:first_walk", ("to_the_ball",), "to_the_ball"),
        (f"challenge:{challenges.names()[-1]}", (), ""),
        ("open_floor", challenges.names(), ""),
    ],
)
def test_the_next_challenge_is_the_one_after_this_or_the_first_unsolved(
    open_script: OpenScript, world: str, solved: tuple[str, ...], following: str
) -> None:
    script = open_script(world=world)
    for each in solved:
        progress().add(tried(each, True, 5, 0, 0, 0, 0))

    if following:
        with pytest.raises(EnterWorld) as entered:
            script.type("NEXT CHALLENGE")
        assert entered.value.name == f"challenge:{following}"
    else:
        assert script.answers_to("NEXT CHALLENGE") == ["That was the last challenge."]


def test_a_broken_line_of_the_results_is_left_out(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script(world="challenge:first_walk")
    script.answers_to("FW 5")
    (kept,) = tmp_path.rglob("challenges.txt")
    kept.write_text("nonsense\n" + kept.read_text())

    assert script.answers_to("RESULTS")[0] == "1 of 1 solved."


@pytest.mark.parametrize(
    ("typed", "world"),
    [("CHALLENGE 2", "challenge:2"), ("NEXT CHALLENGE", "challenge:to_the_ball"), ("RETO 3", "challenge:3")],
)
def test_a_challenge_is_entered_by_its_number_and_the_next_one_by_its_word(
    open_script: OpenScript, typed: str, world: str
) -> None:
    script = open_script(world="challenge:first_walk")

    with pytest.raises(EnterWorld) as entered:
        script.type(typed)
    assert entered.value.name == world


@pytest.mark.parametrize("typed", ["CHALLENGE the maze", "DESAFIO o labirinto", "RETO El laberinto"])
def test_a_challenge_is_entered_by_its_title(open_script: OpenScript, typed: str) -> None:
    script = open_script()

    with pytest.raises(EnterWorld) as entered:
        script.type(typed)
    challenge = choose_world(entered.value.name, Words("en")).challenge
    assert challenge is not None
    assert challenge.name == "maze"


def test_a_challenge_that_is_not_there_changes_nothing(open_script: OpenScript) -> None:
    script = open_script()

    assert script.answers_to("CHALLENGE first_wakl") == [
        "There is no challenge first_wakl. Did you mean first_walk?"
    ]


def test_a_goal_that_is_met_and_a_solved_challenge_have_cues(open_script: OpenScript) -> None:
    script, cues = open_script(world="challenge:say_what_you_see"), list[str]()
    script.donnie.team.stream.subscribe(
        lambda each: cues.append(each.event.name) if isinstance(each.event, CueSounded | Chimed) else None
    )

    script.answers_to("FW 4", "SPEAK 4")

    assert [each for each in cues if each in ("goal", "solved")] == ["goal", "goal", "solved"]


def test_a_challenge_whose_end_is_unknown_is_not_entered(open_script: OpenScript, tmp_path: Path) -> None:
    """Without goals the end of the solution is the goal."""
    file = tmp_path / "it.toml"
    file.write_text('format = 1\nworld = "first_room"\n[en]\ntitle = "T"\ntask = "Do."\n')
    file.with_name("it.solution.gd").write_bytes(b"\xff\xfe\x00")
    script = open_script()

    assert script.answers_to(f"CHALLENGE {file}") == [
        f"{file.with_name('it.solution.gd')} is no text in UTF-8."
    ]


def test_questions_are_asked_and_counted_with_the_run_before(open_script: OpenScript, tmp_path: Path) -> None:
    file = tmp_path / "it.toml"
    file.write_text(ASKING)
    file.with_name("it.solution.gd").write_text("FW 3")
    script = open_script(answers=["yellow", "7"], world=f"challenge:{file}")

    script.answers_to("TR 90", "TL 90", "FW 3")
    assert script.answers_to("QUESTIONS") == [
        "Right.",
        "No. There is 1.",
        "You answered 1 of 2 questions right.",
    ]
    assert script.interaction.asked[-2:] == [
        "Which color is the ball?",
        "How many of these are there: ball?",
    ]
    assert script.answers_to("RESULTS") == [
        "1 of 1 solved.",
        "it: solved, 3 tries, 0 hints, 0 bumps.",
        "3 steps in 7 seconds. The shortest way takes 3.",
        "You answered 1 of 2 questions right.",
    ]


@pytest.mark.parametrize(
    ("answers", "later"),
    [
        (["yellow", "7"], []),
        (["yellow", None, "yellow", "1"], ["Which color is the ball?", "How many of these are there: ball?"]),
    ],
    ids=["answered", "left"],
)
def test_questions_follow_a_program_that_solves_nothing_once(
    open_script: OpenScript, tmp_path: Path, answers: list[str | None], later: list[str]
) -> None:
    """After a line alone they would be in the way; those that were left come back with the solution."""
    file, asked = tmp_path / "it.toml", ["Which color is the ball?", "How many of these are there: ball?"]
    file.write_text(ASKING)
    script = open_script(answers=answers, world=f"challenge:{file}")

    def ask_if_due() -> None:
        if script.ctx.attempt is not None and script.ctx.attempt.has_questions:
            script.answers_to("QUESTIONS")

    for lines, expected in (
        (["FW 1"], []),
        (["TR 90\nTL 90"], asked),
        (["TR 90\nTL 90"], asked),
        (["TR 360"], asked),
        (["FW 1"], asked + later),
    ):
        script.answers_to(*lines)
        ask_if_due()
        assert script.interaction.asked == expected
    assert script.answers_to("RESULTS")[0] == "1 of 1 solved."
    right = 2 if later else 1
    assert script.answers_to("RESULTS")[-1] == f"You answered {right} of 2 questions right."


@pytest.mark.parametrize("word", ["RUN", "TOGETHER"])
@pytest.mark.parametrize("is_attended", [True, False])
def test_a_front_end_that_waits_for_a_program_asks_the_questions_after_it(
    open_script: OpenScript, tmp_path: Path, word: str, is_attended: bool
) -> None:
    file = tmp_path / "it.toml"
    file.write_text(ASKING)
    script = open_script("FW 3", answers=["yellow", "1"], world=f"challenge:{file}")
    script.interaction.until_over = script.rest
    script.interaction.is_attended = is_attended

    script.type(word)

    asked = ["Which color is the ball?", "How many of these are there: ball?"]
    assert script.interaction.asked == (asked if is_attended else [])


def test_while_its_questions_are_asked_none_are_due(open_script: OpenScript, tmp_path: Path) -> None:
    """A screen asks them after each program that ended; of two that ran together, only after the first."""
    file = tmp_path / "it.toml"
    file.write_text(ASKING)
    script, due = open_script(world=f"challenge:{file}"), list[bool]()
    attempt = script.ctx.attempt
    assert attempt is not None

    async def ask(*_: object) -> str:
        due.append(attempt.has_questions)
        return "1"

    script.interaction.ask = ask  # type: ignore[method-assign]
    script.answers_to("FW 3")
    assert attempt.has_questions
    script.answers_to("QUESTIONS")

    assert due == [False, False]


def test_a_command_is_no_answer_but_leaves_the_questions(open_script: OpenScript, tmp_path: Path) -> None:
    file = tmp_path / "it.toml"
    file.write_text(ASKING)
    script = open_script(answers=["yellow", "STOP", "1"], world=f"challenge:{file}")

    script.answers_to("FW 3")
    assert script.answers_to("QUESTIONS") == ["Right.", "You answered 1 of 2 questions right."]
    assert script.interaction.asked[-1] == "> STOP"


def test_questions_that_are_left_keep_the_try(open_script: OpenScript, tmp_path: Path) -> None:
    file = tmp_path / "it.toml"
    file.write_text(ASKING)
    script = open_script(world=f"challenge:{file}")

    script.answers_to("FW 3", "QUESTIONS")
    assert script.answers_to("RESULTS")[-1] == "You answered 0 of 2 questions right."
    script.answers_to("FW 1", "BW 1")
    script.close()
    (kept,) = tmp_path.rglob("challenges.txt")
    assert [line.split("\t")[2] for line in kept.read_text().splitlines()] == ["True", "True", "True"]


def test_a_progress_file_of_an_earlier_version_is_read(open_script: OpenScript, tmp_path: Path) -> None:
    script = open_script(world="challenge:first_walk")
    script.answers_to("FW 5")
    (kept,) = tmp_path.rglob("challenges.txt")
    kept.write_text("2026-01-01\tfirst_walk\tTrue\t1\t1\t2\t5\t0\t1\n")

    assert script.answers_to("RESULTS") == [
        "1 of 1 solved.",
        "The first walk: solved, 1 try, 1 hint, 0 bumps.",
    ]


def test_a_goal_has_its_cue_at_once_and_only_once(open_script: OpenScript, tmp_path: Path) -> None:
    file = tmp_path / "it.toml"
    file.write_text(
        ASKING.replace("at = [0, 3]", "visited = [[0, 3]]\n[[goal]]\nfacing = 0\n[[goal]]\nsaid = 1")
    )
    script, happened = open_script(world=f"challenge:{file}"), list[str]()

    def note(stamped: Stamped) -> None:
        if isinstance(stamped.event, Chimed | RunEnded):
            happened.append(type(stamped.event).__name__)

    script.donnie.team.stream.subscribe(note)
    script.answers_to("FW 3", "FW 3", "BW 4")

    assert happened == ["Chimed", *["RunEnded"] * 3]


def test_a_forbidden_word_is_the_rule_of_a_later_lesson(open_script: OpenScript, tmp_path: Path) -> None:
    file = tmp_path / "it.toml"
    file.write_text(ASKING.replace("[en]", 'words = ["FW"]\n[en]', 1))
    script = open_script(world=f"challenge:{file}")
    first = next(
        number
        for number, name in enumerate(challenges.names(), start=1)
        if "REPEAT" in challenges.find(name).solution().read_text()
    )

    assert script.answers_to("REPEAT 3 TIMES\nFW 1\nEND REPEAT")[-2:] == [
        f"1 of 1 goal. REPEAT comes in challenge {first}.",
        "RESET begins again.",
    ]


UNSENSED = """\
format = 1
world = "first_room"
[en]
title = "T"
task = "Do."
[[goal]]
at = "yellow ball"
[[goal]]
said = "here"
[[goal]]
holds = "ball"
[never]
touch = ["ball"]
near = ["chair"]
within = 3
"""


@pytest.mark.parametrize(
    ("answers", "verdict"),
    [
        (["yes", "yes", "no", "no"], "Solved, in 2 commands."),
        (["yes", "no", "no", "no"], "2 of 3 goals. You answered no to goal 3."),
        (["yes", "yes", "yes", "no"], "3 of 3 goals. You touched the ball."),
        (
            ["yes", "yes", "no", "yes"],
            "3 of 3 goals. You came nearer than 3 steps to the chair.",
        ),
        (
            ["no"],
            "1 of 3 goals. You answered no to goal 1. I can't sense goal 3. I can't sense this: ball.",
        ),
    ],
)
def test_a_real_robot_asks_about_the_goals_that_it_can_not_sense(
    open_script: OpenScript,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    answers: list[str],
    verdict: str,
) -> None:
    file = tmp_path / "it.toml"
    file.write_text(UNSENSED)
    script = open_script(answers=answers, world=f"challenge:{file}")
    monkeypatch.setattr(type(script.donnie.connection), "is_real", property(lambda _: True))

    script.answers_to("FW 1")
    assert script.answers_to('SPEAK "here"')[-1] == "I can't sense all."
    assert script.answers_to("GOALS") == [
        "Goal 1: I ask you later.",
        "Goal 2: met.",
        "Goal 3: I ask you later.",
    ]
    assert script.answers_to("QUESTIONS") == [verdict]
    asked = [
        "Is the robot there: ball?",
        "Does the robot hold this: ball?",
        "Did the robot touch this: ball?",
    ]
    asked += ["Was it nearer than 3 steps: chair?"]
    assert script.interaction.asked[-4:][: len(answers) + 1] == asked[: len(answers) + 1]
    assert script.answers_to("RESULTS")[0] == f"{int('Solved' in verdict)} of 1 solved."
    known = {"yes": "met.", "no": "You answered no to goal 1."}[answers[0]]
    assert script.answers_to("GOALS")[0] == f"Goal 1: {known}"
    assert script.answers_to("TR 90", "GOALS")[-3] == "Goal 1: I ask you later."


def test_after_a_program_in_the_background_a_real_robot_names_the_word_that_asks(
    open_script: OpenScript, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No question comes by itself then: the learner may be typing."""
    file = tmp_path / "it.toml"
    file.write_text(UNSENSED)
    script = open_script(world=f"challenge:{file}")
    monkeypatch.setattr(type(script.donnie.connection), "is_real", property(lambda _: True))

    script.answers_to("FW 1")
    script.ctx.runs.start(RunRequest("FW 1"), is_background=True)
    script.rest()
    assert script.printed[-1] == "I can't sense all. Type QUESTIONS."


def test_questions_that_were_left_are_asked_again_for_the_same_try(
    open_script: OpenScript, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "it.toml"
    file.write_text(UNSENSED.replace('said = "here"', "facing = 0"))
    script = open_script(answers=["yes", None, "yes", "no", "no"], world=f"challenge:{file}")
    monkeypatch.setattr(type(script.donnie.connection), "is_real", property(lambda _: True))

    script.answers_to("FW 1")
    assert script.answers_to("QUESTIONS") == [
        "2 of 3 goals. I can't sense goal 3. I can't sense this: ball. I can't sense this: chair."
    ]
    assert script.answers_to("QUESTIONS") == ["Solved, in 1 command."]
    assert script.answers_to("QUESTIONS") == ["There are no questions here."]
    assert script.answers_to("RESULTS")[:2] == ["1 of 1 solved.", "it: solved, 1 try, 0 hints, 0 bumps."]


def test_a_real_robot_is_judged_at_once_by_what_it_can_sense(
    open_script: OpenScript, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = open_script(world="challenge:first_walk")
    monkeypatch.setattr(type(script.donnie.connection), "is_real", property(lambda _: True))

    assert "0 of 1 goal. You stopped 1 step south of 0, 5." in script.answers_to("FW 4")
    assert "Solved, in 2 commands." in script.answers_to("FW 1")


def test_what_a_real_robot_solved_must_be_solved_from_the_other_starts_in_simulation(
    open_script: OpenScript, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "it.toml"
    file.write_text(ASKING.split("[[question]]")[0] + "[[variant]]\n[[variant]]\nstart = [0, 0, 90]\n")
    script = open_script(world=f"challenge:{file}")
    monkeypatch.setattr(type(script.donnie.connection), "is_real", property(lambda _: True))

    assert script.answers_to("FW 3")[-1].startswith("0 of 1 goal. From start 2: ")


def test_the_places_of_goals_are_digits_in_the_map_in_letters(open_script: OpenScript) -> None:
    script = open_script(world="challenge:there_and_back")

    assert script.answers_to("MAP 0 8") == ["0, 8: goal 1. 8 ahead."]
    assert script.answers_to("MAP 0 7") == ["0, 7: free. 7 ahead."]
    drawn = script.answers_to("MAP PICTURE")
    assert "Goal 1: 1" in drawn
    rows = [line for line in drawn if line.startswith("#")]
    robot = next(at for at, row in enumerate(rows) if "^" in row)
    assert rows[robot - 8][rows[robot].index("^")] == "1"


def test_the_end_of_a_solution_is_on_the_map_where_it_is_the_goal(open_script: OpenScript) -> None:
    """Its task is to go to 16, 16, and its file names no goal."""
    script = open_script(world="challenge:blue_things")

    assert script.answers_to("MAP 16 16") == ["16, 16: goal 1. 16 right, 16 ahead."]


def test_an_area_that_is_a_goal_is_drawn_where_the_floor_is_free(
    open_script: OpenScript, tmp_path: Path
) -> None:
    file = tmp_path / "it.toml"
    file.write_text(ASKING.replace("at = [0, 3]", "area = [[6, -1], [9, 2]]"))
    script = open_script(world=f"challenge:{file}")

    assert script.answers_to("MAP 6 2", "MAP 8 0", "MAP 5 0") == [
        "6, 2: goal 1. 6 right, 2 ahead.",
        "8, 0: ball. 8 right.",
        "5, 0: free. 5 right.",
    ]


@pytest.mark.parametrize("line", ["TASK", "GOALS", "RESULTS"])
def test_a_challenge_answers_while_a_program_runs(open_script: OpenScript, line: str) -> None:
    """A learner looks for what is still to be done while the robot walks."""
    script = open_script(world="challenge:to_the_ball", speed=1.0)
    at_rest = script.answers_to(line)
    script.run("WAIT 1000")
    script.type(line)
    script.donnie.session.stop()
    script.rest()

    assert at_rest
    assert [script.printed.count(each) for each in at_rest] == [2] * len(at_rest)


def test_a_hint_comes_while_a_program_runs(open_script: OpenScript) -> None:
    script = open_script(world="challenge:to_the_ball", speed=1.0)
    script.run("WAIT 1000")
    script.type("HINT")
    script.donnie.session.stop()
    script.rest()

    assert "Turn right by 90 degrees first." in script.printed


@pytest.mark.parametrize("line", ["CHALLENGE 2", "NEXT CHALLENGE"])
def test_no_other_challenge_begins_while_a_program_runs(open_script: OpenScript, line: str) -> None:
    script = open_script(world="challenge:to_the_ball", speed=1.0)
    script.run("WAIT 1000")
    script.type(line)
    script.donnie.session.stop()
    script.rest()

    assert Words()("screen-busy") in script.printed
