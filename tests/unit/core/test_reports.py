"""Reports as files: a page with headings and tables for screen readers, and a spreadsheet."""

import csv
import io
from html.parser import HTMLParser
from itertools import combinations
from xml.etree import ElementTree

import pytest
from PIL import ImageFont

from devices.ports.robot import Pose, StoppedBy
from donnie_tui.core.events import (
    Event,
    HowStarted,
    Moved,
    Outcome,
    Read,
    Reset,
    RunEnded,
    RunStarted,
    Stamped,
    Turned,
    Waited,
)
from donnie_tui.core.reports import (
    PLOT_LETTER,
    Plot,
    PlotText,
    Section,
    Series,
    Subject,
    as_csv,
    as_html,
    asked,
    beginnings,
    in_sentences,
    measured,
    measured_in_words,
    plot_as_svg,
    plotted,
    refusal,
    report,
    suffixes_of,
)
from donnie_tui.core.timeline import Trail
from donnie_tui.i18n.words import Words
from sim.picture import Picture, Thing

TABLE = Section("The <map>", ["Two & two."], [("name", "x"), ("a, b", -3)])


class Tags(HTMLParser):
    def __init__(self, page: str) -> None:
        super().__init__()
        self.opened: list[str] = []
        self.texts: list[str] = []
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.opened.append(tag)

    def handle_data(self, data: str) -> None:
        self.texts += [data] if data.strip() else []


def test_a_page_has_its_language_headings_and_column_headings() -> None:
    page = as_html("Donnie", "pt", [TABLE])
    tags = Tags(page)

    assert page.startswith('<!DOCTYPE html>\n<html lang="pt">')
    assert [each for each in tags.opened if each in ("h1", "h2", "th", "td", "p")] == [
        *("h1", "h2", "p", "th", "th", "td", "td")
    ]
    assert tags.texts[1:] == ["Donnie", "The <map>", "Two & two.", "name", "x", "a, b", "-3"]


def test_a_page_shows_text_that_could_be_more_than_text() -> None:
    evil = "</td><script>alert(1)</script>\x1b]0;x\x07\u202eabc\x9b2J"
    page = as_html(evil, "en", [Section(evil, [evil], [(evil,), (evil,)])])

    assert "script" not in Tags(page).opened
    assert not set("\x1b\x07\u202e\x9b") & set(page)
    assert len([each for each in Tags(page).texts if "<script>alert(1)</script>" in each]) == 6


def test_a_page_has_one_section_after_the_other_and_a_table_only_for_rows() -> None:
    tags = Tags(
        as_html("t", "en", [Section("a", ["one", "two"], drawing="<svg>d</svg>"), Section("b"), TABLE])
    )

    assert tags.texts == ["t", "t", "a", "one", "two", "d", "b", *Tags(as_html("", "en", [TABLE])).texts]
    assert tags.opened.count("table") == 1


def test_the_rows_of_a_table_are_one_after_the_other() -> None:
    table = Section("a", [], [("n",), (1,), (2,), (3,)])

    assert Tags(as_html("t", "en", [table])).texts == ["t", "t", "a", "n", "1", "2", "3"]


def test_a_table_is_valid_csv() -> None:
    assert list(csv.reader(as_csv([TABLE]).splitlines())) == [["name", "x"], ["a, b", "-3"]]


@pytest.mark.parametrize("evil", ['=HYPERLINK("x")', "+1+1", "-1+1", "@SUM(1)", " =1", "\t=1"])
def test_no_cell_of_a_table_is_a_formula(evil: str) -> None:
    table = as_csv([Section("a", [], [("x", "y", "z"), (evil, "-3", -3)]), Section("b", [evil])])
    rows = list(csv.reader(io.StringIO(table)))

    assert rows[1] == [f"'{evil}", "-3", "-3"]
    assert rows[3] == [f"'{evil}"]


def test_a_table_has_no_control_character() -> None:
    assert as_csv([Section("a", ["b\x1b[2J\x9b1m"])]) == "a\nb [2J 1m\n"


def test_lines_are_a_table_of_one_column() -> None:
    assert as_csv([Section("Help", ["FW: walks", "TR: turns"])]) == "Help\nFW: walks\nTR: turns\n"


# --- measured over the time


def walked(t: float, steps: int, seq: int = 1) -> Stamped:
    return Stamped(seq, t, Moved(f"FW {steps}", steps, steps, None, Pose(0, 0, 0), forward=True))


def at(t: float, event: Event) -> Stamped:
    return Stamped(1, t, event)


RUN = [
    at(0, RunStarted("p", "w", "donnie", 0, "0")),
    at(0, Read("distance", "front", 34)),
    walked(10, 10, 4),
    at(10, Read("distance", "front", 24)),
    at(12, Turned("TR 90", 90, 90, None, Pose(0, 0, 90), right=True)),
    at(12, Read("distance", "front", 8)),  # another wall: 16 nearer, though it walked nowhere
    walked(24, 6, 7),
    at(24, Read("distance", "front", 2)),
    at(24, RunEnded(Outcome.COMPLETED, Pose(0, 0, 0), {"a": 3}, 24.0)),
]


def subject() -> Subject:
    picture = Picture(0, 0, 1, 1, 1, (".",), (), False)
    return Subject((), Pose(0, 0, 0), picture, Trail(), (), (), RUN, {4: (("a", 1),), 7: (("a", 2),)})


def written(name: str) -> str:
    return report("distances", name, subject(), Words()).decode()


def test_distances_speed_and_variables_over_the_time_are_three_sentences() -> None:
    """The speed: 10 steps in 10 seconds, 6 in 12."""
    assert measured_in_words(measured(RUN, Words()), Words()) == (
        "Distance ahead falls from 34 to 2 in 16 steps, one jump at 10.",
        "The robot moves for 22 of 24 seconds, at most 1 step a second.",
        "Variables at the end: a = 3.",
    )
    assert measured_in_words((), Words()) == ("Nothing was measured yet.",)


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("pt", "Distância à frente cai de 34 para 2 em 16 passos, um salto em 10."),
        ("es", "Distancia al frente baja de 34 a 2 en 16 pasos, un salto en 10."),
    ],
)
def test_the_sentences_are_in_the_learners_language(language: str, sentence: str) -> None:
    words = Words(language)

    assert measured_in_words(measured(RUN, words), words)[0] == sentence


def test_two_jumps_are_counted_and_the_first_has_its_step() -> None:
    again = [*RUN[:-1], at(24, Read("distance", "front", 9)), RUN[-1]]

    (sentence, *_) = measured_in_words(measured(again, Words()), Words())
    assert sentence == "Distance ahead falls from 34 to 9 in 16 steps, 2 jumps, the first at 10."


@pytest.mark.parametrize(
    ("second", "sentence"),
    [
        (34, "Distance ahead begins and ends at 34 in 10 steps, one jump at 10."),
        (48, "Distance ahead rises from 34 to 48 in 10 steps, one jump at 10."),
        (47, "Distance ahead rises from 34 to 47 in 10 steps."),  # 10 steps and 3 more
        (21, "Distance ahead falls from 34 to 21 in 10 steps."),
        (20, "Distance ahead falls from 34 to 20 in 10 steps, one jump at 10."),
    ],
)
def test_a_jump_is_a_change_of_more_than_three_steps_above_what_was_walked(
    second: int, sentence: str
) -> None:
    if second == 34:
        read = [RUN[1], walked(10, 10, 4), at(10, Read("distance", "front", 99)), at(11, RUN[1].event)]
        sentence = sentence.replace("one jump at 10", "2 jumps, the first at 10")
    else:
        read = [RUN[1], walked(10, 10, 4), at(10, Read("distance", "front", second))]
    (said, *_) = measured_in_words(measured([RUN[0], *read], Words()), Words())

    assert said == sentence


def test_the_distance_that_was_read_most_is_said_by_its_name() -> None:
    readings = [at(0, Read("distance", where, 5)) for where in ("front", "eye", "eye")]
    readings.append(at(1, Read("colour", "red", 1)))

    assert measured_in_words(measured(readings, Words()), Words()) == (
        "Distance eye begins and ends at 5 in 0 steps.",
    )
    assert measured_in_words(measured(readings, Words("en", "brief")), Words("en", "brief")) == (
        "Distance eye: 5 at both ends.",
    )


def test_a_fresh_run_or_a_reset_begins_the_measuring_anew() -> None:
    how = HowStarted("", 1, True, False, False, Pose(0, 0, 0))
    fresh = at(30, RunStarted("p", "w", "donnie", 0, "0", how))
    last = at(40, Read("distance", "front", 7))

    assert [each.points for each in measured([*RUN, fresh, last], Words())] == [((40, 7.0),)]
    assert [each.points for each in measured([*RUN, at(0, Reset(Pose(0, 0, 0))), last], Words())] == [
        ((40, 7.0),)
    ]


def test_the_lines_of_a_conversation_are_measured_one_after_the_other() -> None:
    """Each is a run of its own, with its own clock from 0."""
    how = HowStarted("", 1, False, True, False, Pose(0, 0, 0))
    line = RunStarted("typed", "w", "donnie", 0, "0", how)
    events = [
        *(at(0, line), walked(2, 2), at(2, Read("distance", "front", 22))),
        at(2, RunEnded(Outcome.COMPLETED, Pose(0, 2, 0), {"a": 1}, 2.0)),
        *(at(0, line), walked(3, 3), at(3, Read("distance", "front", 19))),
        at(5, RunEnded(Outcome.COMPLETED, Pose(0, 5, 0), {"a": 2}, 5.0)),
        *(at(0, line), at(0, RunEnded(Outcome.QUIT, Pose(0, 5, 0), {}, 0.0))),
    ]
    distance, speed, variable = measured(events, Words())

    assert (distance.points, distance.steps) == (((2, 22), (5, 19)), 3)
    assert speed.points == ((0, 1), (2, 1), (2, 1), (5, 1))
    assert variable.points == ((2, 1), (7, 2))


def test_the_speed_counts_while_the_robot_walks_and_not_while_it_waits() -> None:
    events = [at(0, RUN[0].event), walked(2, 5), at(6, Waited(4)), walked(10, 2), at(10, Waited(0))]
    (speed,) = measured(events, Words())

    assert speed.points == ((0, 2.5), (2, 2.5), (2, 0.0), (6, 0.0), (6, 0.5), (10, 0.5))
    assert measured_in_words((speed,), Words()) == (
        "The robot moves for 6 of 10 seconds, at most 2.5 steps a second.",
    )


def test_a_variable_is_known_during_each_movement() -> None:
    """During the turn between them nothing was looked at."""
    series = {each.name: each.points for each in measured(RUN, Words(), subject().variables)}

    assert series["a"] == ((0, 1), (10, 1), (12, 2), (24, 2), (24, 3))


def test_the_speed_counts_from_the_start_of_the_run() -> None:
    """7 steps in 3 seconds, after 5 seconds."""
    (speed,) = measured([at(5, RUN[0].event), walked(8, 7)], Words())

    assert speed.points == ((5, pytest.approx(7 / 3)), (8, pytest.approx(7 / 3)))
    assert measured_in_words((speed,), Words()) == (
        "The robot moves for 3 of 3 seconds, at most 2.3 steps a second.",
    )


def test_steps_and_jumps_count_from_the_first_reading() -> None:
    read = (
        walked(5, 5),
        at(5, Read("distance", "front", 9)),
        walked(7, 2),
        at(7, Read("distance", "front", 30)),
    )
    walk, turn = walked(9, 4), at(11, Turned("TR 9", 9, 9, None, Pose(0, 0, 9), right=True))
    events = [at(0, RUN[0].event), *read, walk, turn, at(11, Read("distance", "front", 26))]
    distance, speed = measured(events, Words())

    assert (distance.steps, distance.jumps) == (6, (2,))
    assert speed.points[-2:] == ((9, 0), (11, 0))


def test_a_clock_that_begins_anew_goes_on_where_the_last_run_ended() -> None:
    line = RunStarted("typed", "w", "donnie", 0, "0", HowStarted("", 1, False, True, False, Pose(0, 0, 0)))
    ended = at(5, RunEnded(Outcome.COMPLETED, Pose(0, 2, 0), {}, 5.0))
    (distance,) = measured([at(0, line), ended, at(1, line), at(3, Read("distance", "front", 9))], Words())

    assert distance.points == ((7, 9),)


def test_a_walk_takes_as_long_as_it_is_since_the_last_movement() -> None:
    """Whatever was read meanwhile: 10 steps in 10 seconds."""
    distance, speed = measured([RUN[0], at(5, Read("distance", "front", 9)), walked(10, 10)], Words())

    assert (distance.points, speed.points) == (((5, 9),), ((0, 1), (10, 1)))


def test_only_readings_of_distances_are_measured_and_each_direction_alone() -> None:
    colour, place = at(0, Read("colour", "red", 1)), at(0, Read("position", "x", 2))
    ahead, named = at(1, Read("distance", "front", 3)), at(2, Read("distance", "eye", 4))

    assert [(each.name, each.points) for each in measured([colour, place, ahead, named], Words())] == [
        ("distance F", ((1, 3),)),
        ("distance eye", ((2, 4),)),
    ]


def test_each_variable_has_its_last_value_and_no_point_is_there_twice() -> None:
    ended = at(2, RunEnded(Outcome.COMPLETED, Pose(0, 0, 0), {"a": 3, "b": -1}, 2.0))
    series = measured([RUN[0], walked(2, 2, 4), ended], Words(), {4: (("a", 3),)})

    assert [each.points for each in series[1:]] == [((0, 3), (2, 3)), ((2, -1),)]
    assert measured_in_words(series[1:], Words()) == ("Variables at the end: a = 3, b = -1.",)


def test_the_same_is_a_table_for_spreadsheets() -> None:
    rows = list(csv.reader(written("d.csv").splitlines()))

    assert rows == [
        ["seconds", "distance F", "speed", "a"],
        ["0", "34", "1", "1"],
        ["10", "24", "0", "1"],
        ["12", "8", "0.5", "2"],
        ["24", "2", "0.5", "3"],
    ]


def test_the_plot_is_to_scale_and_says_the_sentences() -> None:
    svg = ElementTree.fromstring(written("d.svg"))
    space = "{http://www.w3.org/2000/svg}"
    distance, speed, _variable = (
        [tuple(map(float, each.split(","))) for each in (line.get("points") or "").split()]
        for line in svg.findall(f"{space}polyline")
    )

    assert "Distance ahead falls from 34 to 2" in (svg.findtext(f"{space}desc") or "")
    (x0, y0), (x1, y1), (x2, y2), (x3, y3) = distance
    assert (x1 - x0) / (x3 - x0) == pytest.approx(10 / 24, abs=0.01)
    assert (x2 - x0) / (x3 - x0) == pytest.approx(12 / 24, abs=0.01)
    assert (y1 - y0) / (y3 - y0) == pytest.approx(10 / 32, abs=0.01)
    assert (y2 - y0) / (y3 - y0) == pytest.approx(26 / 32, abs=0.01)
    assert len({y for _, y in speed}) == 3  # 1, 0 and a half
    assert [each.text for each in svg.findall(f"{space}text")][-4:] == ["0", "12", "24", "seconds"]


def test_a_page_has_the_plot_above_the_table() -> None:
    page = written("d.html")

    assert page.index("falls from 34") < page.index("<svg") < page.index("<table")


def test_a_text_has_the_sentences_alone() -> None:
    assert written("d.txt").splitlines() == [
        "Distances over time",
        "Distance ahead falls from 34 to 2 in 16 steps, one jump at 10.",
        "The robot moves for 22 of 24 seconds, at most 1 step a second.",
        "Variables at the end: a = 3.",
    ]


def test_a_plot_is_laid_out_to_scale() -> None:
    """720 wide, of which 96 and 40 are left and right; 130 for each thing, and three lines of 20 below."""
    rising = Series("up", ((0, 0), (10, 4)), "speed")
    once = Series("once", ((5, -2),), "variable")
    plot = plotted("t", [rising, once], "", "seconds")

    assert (plot.width, plot.height) == (720, 320)
    assert plot.axes == (((96, 34), (96, 130), (680, 130)), ((96, 164), (96, 260), (680, 260)))
    assert plot.curves == (((96, 130), (680, 34)), ((388, 260),))
    assert plot.dots == ((388, 260),)  # no line is drawn of one value
    assert [(each.x, each.y, each.text, each.anchor) for each in plot.texts] == [
        (96, 24, "up", "start"),
        (88, 135, "0", "end"),
        (88, 39, "4", "end"),
        (96, 154, "once", "start"),
        (88, 265, "-2", "end"),
        (88, 169, "-1", "end"),  # an axis has a length of 1 at least
        (96, 288, "0", "middle"),
        (388, 288, "5", "middle"),
        (680, 288, "10", "middle"),
        (388, 308, "seconds", "middle"),
    ]


def test_a_plot_begins_at_the_first_time_and_at_zero_or_at_its_least_value() -> None:
    late = Series("late", ((2, 7), (3, 4), (6, 2.34)), "distance")
    below = Series("below", ((2, -3), (6, -2.26)), "speed")
    plot = plotted("t", [late, below], "", "seconds")

    # 584 from left to right, 96 from bottom to top
    assert plot.curves == (((96, 34), (242, 75.1), (680, 97.9)), ((96, 260), (680, 189)))
    assert plot.dots == ((96, 34), (242, 75.1), (680, 97.9))
    assert [each.text for each in plot.texts] == [
        *("late", "0", "7", "below", "-3", "-2", "2", "4", "6", "seconds")
    ]


def test_an_axis_has_room_for_nine_signs_and_a_plot_of_nothing_is_a_second_long() -> None:
    def on_axis(value: float) -> str:
        return plotted("t", [Series("a", ((0, 0), (1, value)), "speed")], "", "s").texts[2].text

    assert [on_axis(each) for each in (0.25, 123456789, 1234567890)] == ["1", "123456789", "1.23e+09"]
    # a float rounds, the digits of a number of 300 or more are cut
    assert [on_axis(10**digits - 1) for digits in (299, 300)] == ["1.00e+299", "9.99e+299"]
    assert [each.text for each in plotted("t", [], "", "s").texts] == ["0", "0.5", "1", "s"]
    assert plotted("t", [Series("a", ((3, 0),), "distance")], "", "s").curves == (((96, 130),),)


def test_a_plot_of_huge_values_and_late_times_is_drawn():
    huge = Series("f", ((0.0, -314 * 10**500), (1.0, 271 * 10**400)), "variable")

    assert [each.text for each in plotted("t", [huge], "", "s").texts[1:3]] == ["-3.14e+502", "2.71e+402"]
    assert plotted("t", [Series("a", ((1e17, 3),), "distance")], "", "s").dots == ((96.0, 34.0),)


def of_all(robot: str | None = None, *events: Stamped) -> Subject:
    """With a line, a thing, a move and all pictures."""
    crate = Thing("", "crate", "c", "red", 2, 3, 1, 1)
    trail = Trail()
    how = HowStarted("", 1, True, False, False, Pose(0, 0, 0))
    trail.on_event(at(0, RunStarted("p", "w", "donnie", 0, "0", how)))
    trail.on_event(at(1, Moved("FW 5", 5, 5, None, Pose(0, 5, 0), forward=True)))
    return Subject(
        ("FW 5",),
        Pose(0, 0, 0),
        Picture(-9, -9, 18, 18, 1, ("." * 18,) * 18, (crate,), has_walls=False),
        trail,
        ["FW n: walks"],
        [Section("Chapter 1", ["Once."]), Section("Chapter 2", ["Twice."])],
        events,
        run_picture=lambda suffix: f"<svg>picture{suffix}</svg>".encode(),
        plot_as_png=lambda plot: plot.about.encode(),
        paper=lambda: "<svg>papér</svg>",
        robot=robot,
    )


ALICE = of_all("alice", at(1, Read("distance", "front", 5)))
BOB = of_all("bob", at(0, Read("distance", "front", 7)), at(1, Read("distance", "back", 8)))


@pytest.mark.parametrize(
    ("what", "name", "content"),
    [
        ("paper", "w.svg", "<svg>papér</svg>"),
        ("run", "r.svg", "<svg>picture.svg</svg>"),
        ("run", "r.PNG", "<svg>picture.png</svg>"),
        ("run", "r.gif", "<svg>picture.gif</svg>"),
        ("distances", "d.png", "Distance ahead begins and ends at 5 in 0 steps."),
        ("manual", "m.txt", "Chapter 1\nOnce.\nChapter 2\nTwice.\n"),
        ("manual", "m.csv", "Chapter 1\nOnce.\nChapter 2\nTwice.\n"),
        ("help", "h.txt", "Words that you can type\nhow it is typed, what it does\nFW n, walks\n"),
        ("list", "l.txt", "The program\nline, level, text\n1, 0, FW 5\n"),
        ("list", "l.csv", "line,level,text\n1,0,FW 5\n"),
        ("map", "m.txt", "The map\nAn open floor without walls.\n1 thing.\n"),
        ("trail", "t.txt", "The trail\nFW 5: 5 steps, to 0, 5.\n"),
        ("run", "r.txt", "The run\nThe path starts at 0, 0.\nNorth: 5 steps, to 0, 5.\n5 steps in all.\n"),
    ],
)
def test_the_end_of_a_name_says_what_a_report_contains(what: str, name: str, content: str) -> None:
    subject = of_all(None, *ALICE.events)

    assert report(what, name, subject, Words()).decode() == content


@pytest.mark.parametrize(
    ("what", "title"),
    [
        ("manual", "Donnie: the manual"),
        ("help", "Donnie: words that you can type"),
        ("list", "Donnie: the program"),
        ("map", "Donnie: the map"),
        ("trail", "Donnie: the trail"),
        ("run", "Donnie: the run"),
        ("distances", "Donnie: distances over time"),
    ],
)
def test_a_page_is_called_by_its_report(what: str, title: str) -> None:
    page = report(what, f"{what}.htm", of_all(), Words()).decode()

    assert Tags(page).texts[:2] == [title, title]
    assert "<svg>picture.svg</svg>" in page or what != "run"


@pytest.mark.parametrize("language", ["en", "pt", "es"])
@pytest.mark.parametrize("others", [(), (BOB,)])
def test_each_table_and_page_begins_as_reports_do(language: str, others: tuple[Subject, ...]) -> None:
    words = Words(language)
    known = tuple(each.encode() for each in beginnings(words))

    for what in ("help", "list", "map", "trail", "run", "distances"):
        for suffix in ("csv", "html"):
            assert report(what, f"r.{suffix}", ALICE, words, others).startswith(known)
    empty = of_all()
    assert report("distances", "r.csv", empty, words).startswith(known)
    assert report("manual", "r.html", empty, words).startswith(known)
    assert not b"<!DOCTYPE html>\n<html>".startswith(known)


@pytest.mark.parametrize(
    ("what", "rows"),
    [
        ("list", ["robot,line,level,text", "alice,1,0,FW 5", "bob,1,0,FW 5"]),
        (
            "trail",
            ["robot,command,done,x,y,heading,blocked", "alice,FW 5,5,0,5,0,no", "bob,FW 5,5,0,5,0,no"],
        ),
        ("distances", ["robot,seconds,distance F,distance B", "alice,1,5,", "bob,0,7,", "bob,1,,8"]),
        ("map", ["name,color,x,y,place", 'crate,red,2,3,"2 right, 3 ahead"']),
        ("help", ["how it is typed,what it does", "FW n,walks"]),
    ],
)
def test_a_table_of_several_robots_has_their_names_in_its_first_column(what: str, rows: list[str]) -> None:
    assert report(what, "r.csv", ALICE, Words(), (BOB,)).decode().splitlines() == rows


def test_a_report_of_several_robots_has_a_section_for_each_and_one_picture_of_the_run() -> None:
    text = report("trail", "t.txt", ALICE, Words(), (BOB,)).decode().splitlines()
    page = report("run", "r.html", ALICE, Words(), (BOB,)).decode()

    moved = "FW 5: 5 steps, to 0, 5."
    assert text == ["alice: The trail", moved, "bob: The trail", moved]
    assert page.count("<svg>picture.svg</svg>") == 1
    assert page.index("alice: The run") < page.index("<svg>") < page.index("bob: The run")


def test_a_plot_of_several_robots_has_the_name_of_each() -> None:
    page = report("distances", "d.svg", ALICE, Words(), (BOB,)).decode()
    said = report("distances", "d.png", ALICE, Words(), (BOB,)).decode()

    assert [text for text in Tags(page).texts if "distance " in text] == [
        *("alice: distance F", "bob: distance F", "bob: distance B")
    ]
    assert said == (
        "alice: Distance ahead begins and ends at 5 in 0 steps."
        " bob: Distance ahead begins and ends at 7 in 0 steps."
    )


def test_the_sentences_of_a_report_need_no_file() -> None:
    assert in_sentences("trail", ALICE, Words()) == ("FW 5: 5 steps, to 0, 5.",)
    assert in_sentences("distances", ALICE, Words()) == ("Distance ahead begins and ends at 5 in 0 steps.",)


ENGLISH = "help, list, manual, map, trail, run, distances, paper"
TABLES = {
    "help": [["how it is typed", "what it does"], ["FW n", "walks: n steps"]],
    "list": [["line", "level", "text"], ["1", "0", "REPEAT 2 TIMES"], ["2", "1", "FW 1"]],
    "map": [["name", "color", "x", "y", "place"], ["crate", "red", "-2", "5", "5 right, 2 ahead"]],
    "trail": [
        ["command", "done", "x", "y", "heading", "blocked"],
        ["FW 5", "2", "3", "-4", "90", "yes"],
        ["TR 90", "90", "3", "-4", "180", "no"],
    ],
}


@pytest.mark.parametrize("what", TABLES)
def test_a_report_is_a_table_whose_columns_have_names(what: str) -> None:
    crate = Thing("", "crate", "c", "red", -2.2, 4.8, 1, 1)
    trail = Trail()
    for event in (
        Moved("FW 5", 5, 2, StoppedBy.OBSTACLE, Pose(3, -4, 90), forward=True),
        Turned("TR 90", 90, 90, None, Pose(3, -4, 180), right=True),
    ):
        trail.on_event(at(1, event))
    about = Subject(
        ("REPEAT 2 TIMES", "FW 1"),
        Pose(0, 0, 270),
        Picture(-9, -9, 18, 18, 1, ("." * 18,) * 18, (crate,), has_walls=False),
        trail,
        ["FW n: walks: n steps"],
        (),
    )

    assert list(csv.reader(report(what, f"{what}.csv", about, Words()).decode().splitlines())) == TABLES[what]


def test_a_report_of_the_moves_says_that_the_first_ones_are_forgotten() -> None:
    trail = Trail(most_moves=2)
    for degrees in (90, 180, 270):
        trail.on_event(at(1, Turned("TR 90", 90, 90, None, Pose(0, 0, degrees), right=True)))
    picture = Picture(-9, -9, 18, 18, 1, ("." * 18,) * 18, (), has_walls=False)
    about = Subject((), Pose(0, 0, 270), picture, trail, [], ())

    assert report("trail", "t.txt", about, Words()).decode().splitlines()[1:] == [
        "The last 2 of 3 moves.",
        "TR 90: now facing south.",
        "TR 90: now facing west.",
    ]


@pytest.mark.parametrize(
    ("typed", "found"),
    [
        ("", None),
        ("help", None),
        ("paper", None),
        ("distances", ("distances", "")),
        ("map map", ("map", "map.html")),
        ("MAPA mapa.txt", ("map", "mapa.txt")),
        ("run a b.csv", ("run", "a b.csv")),
        ("map -", ("map", "-")),
        ("paper world", ("paper", "world.svg")),
        ('paper "my world"', ("paper", "my world.svg")),
        ("my lesson.svg", None),
        ("manual.csv", ("manual", "manual.csv")),
        ("paper.html", ("run", "paper.html")),
        ("tea", None),
    ],
)
def test_a_report_is_asked_for_by_its_subject_and_its_file(typed: str, found: tuple[str, str] | None) -> None:
    assert asked(typed) == found


def test_how_the_name_of_a_file_may_end_depends_on_what_it_is_about() -> None:
    assert asked("run run") == ("run", "run.html")
    assert asked("run") == ("run", "")
    assert asked("map") is None
    assert asked("paper -") == ("paper", "-")
    assert ".svg" not in suffixes_of("map")
    assert {".svg", ".png", ".gif"} < {*suffixes_of("run")}
    assert {".svg", ".png"} < {*suffixes_of("distances")}


@pytest.mark.parametrize(
    ("typed", "what", "name"),
    [
        ("run.svg", "run", "run.svg"),
        ("lesson.PNG", "run", "lesson.PNG"),
        ("aula.gif", "run", "aula.gif"),
        ("monday.html", "run", "monday.html"),
        ('"my lesson.svg"', "run", "my lesson.svg"),
        ("pages/map.html", "map", "pages/map.html"),
        ("trilha.csv", "trail", "trilha.csv"),
        ("distancias.svg", "distances", "distancias.svg"),
        ("papel.svg", "paper", "papel.svg"),
        ("map.svg", "run", "map.svg"),
    ],
)
def test_a_file_alone_is_about_what_its_name_means_else_about_the_run(
    typed: str, what: str, name: str
) -> None:
    assert asked(typed) == (what, name)
    assert refusal(typed, Words()) == ""


@pytest.mark.parametrize(
    ("language", "typed", "sentence"),
    [
        ("en", "tea tea.html", f"I can't report tea. I can report {ENGLISH}."),
        ("en", "tea", f"I can't report tea. I can report {ENGLISH}."),
        (
            "pt",
            "chá",
            "Não posso relatar chá. Posso relatar"
            " ajuda, listar, manual, mapa, trilha, percurso, distâncias, papel.",
        ),
        (
            "es",
            "té",
            "No puedo informar té. Puedo informar"
            " ayuda, lista, manual, mapa, rastro, recorrido, distancias, papel.",
        ),
        ("en", "", f"I can't report . I can report {ENGLISH}."),
        ("es", "mapa", "Un informe de mapa pide un archivo: mapa.html."),
        ("en", "Paper", "A report of paper needs a file: paper.svg."),
        ("en", "paper x.html", "A report of paper can't end in .html. It can in .svg."),
        ("en", "mapa x.SVG", "A report of map can't end in .svg. It can in .html, .htm, .csv, .txt."),
        ("en", "run x.SVG", ""),
        ("en", "run -", ""),
        (
            "en",
            "run.bmp",
            "A report of run can't end in .bmp. It can in .html, .htm, .csv, .txt, .svg, .png, .gif.",
        ),
    ],
)
def test_a_wrong_word_gets_the_list_of_what_can_be_reported(language: str, typed: str, sentence: str) -> None:
    assert refusal(typed, Words(language)) == sentence


def test_a_plot_as_svg_has_its_lines_dots_and_words_in_their_places() -> None:
    axis, curve = ((0.0, 1.0), (0.0, 9.5), (9.0, 9.5)), ((1.0, 2.0), (3.5, 4.0))
    words = (PlotText(7.0, 8.5, "a < 3", "end"),)
    svg = plot_as_svg(Plot("t & u", "a: 1 to 3", 100.0, 50.0, (axis,), (curve,), ((5.0, 6.0),), words))
    whole = ElementTree.fromstring(svg)

    assert svg.endswith("</svg>\n")
    assert whole.attrib == {
        **{"role": "img", "width": "100", "height": "50", "viewBox": "0 0 100 50"},
        **{"font-family": "sans-serif", "font-size": "14"},
    }
    assert [(each.tag.partition("}")[2], each.text, each.attrib) for each in whole] == [
        ("title", "t & u", {}),
        ("desc", "a: 1 to 3", {}),
        ("rect", None, {"width": "100", "height": "50", "fill": "white"}),
        ("path", None, {"d": "M0 1L0 9.5L9 9.5", "fill": "none", "stroke": "black"}),
        (
            *("polyline", None),
            {"points": "1,2 3.5,4", "fill": "none", "stroke": "black", "stroke-width": "2"},
        ),
        ("circle", None, {"cx": "5", "cy": "6", "r": "3"}),
        ("text", "a < 3", {"x": "7", "y": "8.5", "text-anchor": "end"}),
    ]


def test_no_word_of_a_plot_touches_another_and_all_is_on_it() -> None:
    many = [Series(f"a_long_name_{each}", ((0, -2147483648), (9, each)), "variable") for each in range(4)]
    plot = plotted("t", [*measured(RUN, Words()), *many], "", "seconds")
    font, boxes = ImageFont.load_default(PLOT_LETTER), []
    for each in plot.texts:
        x0, y0, x1, y1 = font.getbbox(
            each.text, anchor={"start": "ls", "middle": "ms", "end": "rs"}[each.anchor]
        )
        boxes.append((each.x + x0, each.y + y0, each.x + x1, each.y + y1))

    assert all(x0 >= 0 and y0 >= 0 and x1 <= plot.width and y1 <= plot.height for x0, y0, x1, y1 in boxes)
    for one, other in combinations(boxes, 2):
        assert one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]


@pytest.mark.parametrize(("legs", "left_out"), [(200, 0), (201, 1), (300, 100)])
def test_of_a_long_path_two_hundred_legs_are_said(legs: int, left_out: int) -> None:
    """With the sentence of its start, and that of its length; a file has all."""
    trail = Trail()
    for leg in range(legs + 1):
        pose = Pose((leg + 1) // 2, leg // 2, 90)
        trail.on_event(at(leg, Moved("FW 1", 1, 1, None, pose, forward=True)))
    about = Subject((), Pose(0, 0, 0), Picture(0, 0, 1, 1, 1, (".",), (), False), trail, (), ())

    said = in_sentences("run", about, Words())
    assert len(said) == min(legs, 200) + 2 + bool(left_out)
    left = [each.partition(" leg")[0] for each in said if "leave out" in each]
    assert left == ([f"I leave out {left_out}"] if left_out else [])
