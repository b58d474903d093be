"""``donnie replay`` prints a recorded run again, both ways, in words and on the map."""

from __future__ import annotations

import json
import re
import signal
from collections.abc import Sequence
from math import hypot
from pathlib import Path
from xml.etree import ElementTree

import pytest

from donnie_tui.cli.streams import Output
from tests.sessions.command import QUIET, donnie, start
from tests.sessions.here import PROGRAM, Here
from tests.timeouts import TIMEOUT

pytestmark = pytest.mark.slow


def test_a_replay_prints_what_the_run_printed(here: Here) -> None:
    printed = here.record()

    assert here.replay() == printed


def test_each_step_back_names_the_place_that_it_leads_to(here: Here) -> None:
    here.record("FW 2\nTR 90\nFW 3")

    assert here.replay("--backwards") == [
        "Back: end of the program. Position 3, 2.",
        "Before FW 3: position 0, 2.",
        "Before TR 90: facing north.",
        "Before FW 2: position 0, 0.",
        "Back: start of a.gd.",
    ]


def test_a_mistake_is_repeated_in_the_language_of_its_run(here: Here) -> None:
    here.record("FWD 2", code=1)
    said = here.replay()

    assert said[0].startswith("Error, line 1")
    assert here.replay("--lang", "pt") == said


def test_a_replay_may_begin_in_the_middle(here: Here) -> None:
    here.record("SPEAK 1\nSPEAK 2\nSPEAK 3")

    assert here.replay("--from", "3") == ["2", "3"]
    assert here.replay("--from", "3", "--backwards") == ["Back: 2.", "Back: 1.", "Back: start of a.gd."]


def test_typed_words_step_through_a_recording_both_ways(here: Here) -> None:
    here.record("FW 2\nTR 90")

    typed = "\nNEXT\nPRÓXIMO\nback\nDÓNDE\nMAP\nnonsense\nGO\nNEXT\nQUIT\n"
    said = here.replay("--step", typed=typed)

    assert said[1:6] == [
        "Start of a.gd.",
        "I walked 2 steps forward.",
        "I turned 90 degrees to the right.",
        "Before TR 90: facing north.",
        "Event 5 of 18.",
    ]
    assert said[6] == "Position 0, 2. Facing north."
    assert any("^" in line for line in said[7:])
    assert said[-4:] == [
        "I do not know that word. HELP lists them.",
        "I turned 90 degrees to the right.",
        "This is the end.",
        "This is the end.",
    ]


def test_a_typed_number_goes_to_that_event_and_words_to_the_ends(here: Here) -> None:
    here.record("FW 2\nTR 90")

    said = here.replay("--step", typed="18\n0\n19\nEND\nSTART\n٣\n1" + "0" * 30 + "\nBACK\nBACK\n")

    assert said == [
        "18 events. Enter steps forward, BACK steps back.",
        *("Event 18 of 18.", "Position 0, 2. Facing east."),
        "Event 0 of 18.",
        *("Event 18 of 18.", "Position 0, 2. Facing east."),
        *("Event 18 of 18.", "Position 0, 2. Facing east."),
        "Event 0 of 18.",
        "I do not know that word. HELP lists them.",
        *("Event 18 of 18.", "Position 0, 2. Facing east."),
        "Back: end of the program. Position 0, 2.",
        "Before TR 90: facing north.",
    ]


def test_help_lists_the_words_of_a_step_by_step_replay(here: Here) -> None:
    here.record("FW 1")

    said = here.replay("--step", "--lang", "pt", typed="AJUDA\nSAIR\nFIM\n")

    assert [each.partition(":")[0] for each in said[1:]] == [
        *("PRÓXIMO", "VOLTAR", "SEGUIR", "MAIS RÁPIDO", "MAIS DEVAGAR", "ONDE", "MAPA"),
        *("COMEÇO", "FIM", "AJUDA", "SAIR"),
    ]


def test_a_step_by_step_replay_begins_where_the_options_say(here: Here) -> None:
    here.record("SPEAK 1\nSPEAK 2\nSPEAK 3")

    assert here.replay("--step", "--from", "3", typed="\n")[1:] == ["2"]
    assert here.replay("--from", "1") == ["1", "2", "3"]
    backwards = here.replay("--step", "--backwards", typed="BACK\nBACK\n\n\n\n")
    assert backwards[1:] == [
        "Back: end of the program. Position 0, 0.",
        "Back: 3.",
        "3",
        "End of the program.",
        "This is the end.",
    ]
    last = len((here.folder / "a.rec").read_bytes().splitlines()) - 1  # after the header
    assert here.replay("--from", str(last)) == []
    for number in (0, last + 1):
        there_is_none = f"There is no event {number}. The last one is {last}."
        assert here.replay("--from", str(number), code=2, err=[there_is_none]) == []


def test_the_map_is_drawn_as_it_goes(here: Here) -> None:
    here.record("FW 2\nTR 90", "--world", "living_room")

    said = here.replay("--map")

    assert sum("^" in line for line in said) == 1
    assert sum(">" in line for line in said) == 1


def rows_of_things(lines: Sequence[str]) -> list[tuple[int, int]]:
    """How far the cone is north of the robot on each map, in rows and columns."""
    maps, found = "\n".join(lines), []
    for rows in (each.splitlines() for each in maps.split("I walked ")[1:]):
        robot = next((y, row.index("^")) for y, row in enumerate(rows) if "^" in row)
        cones = [(robot[0] - y, row.index("c") - robot[1]) for y, row in enumerate(rows) if "c" in row]
        found.append(min(each for each in cones if each[0] > 0))
    return found


def test_the_map_shows_pushed_things_where_the_step_left_them_in_every_run(here: Here) -> None:
    typed = "FW 20\n\nRESET\nFW 20\n\nRESET\nFW 20\n\n"
    world = ("--world", "object_field")
    donnie(here.folder, "--linear", *QUIET, *world, "--speed", "max", "--record", "a.rec", typed=typed)

    said = here.replay("--map")

    before_it = [each[0] for each in rows_of_things(said)]
    assert len(before_it) == 3
    assert set(before_it) <= {2, 3}
    assert len(set(before_it)) == 1
    assert here.replay("--check")[0].endswith("events are the same.")


def record_two(here: Here) -> None:
    (here.folder / "a.gd").write_text("FW 20")
    (here.folder / "b.gd").write_text("WAIT 30 TR 90 FW 2 WAIT 1 FW 1")
    here.donnie("run", "alice=a.gd", "bob=b.gd", "--world", "two_robots", "--record", "a.rec")


def test_the_map_is_that_of_the_robot_that_moved_with_the_others_where_they_are(here: Here) -> None:
    record_two(here)

    said = here.replay("--map", "--speed", "max")

    titles = [line for line in said if line.startswith("Map of ")]
    assert titles == ["Map of alice.", *["Map of bob."] * 3]
    last = said[len(said) - said[::-1].index("Map of bob.") :]
    assert sum("<ooA" in row for row in last) == 1, "bob with its trail"
    (alice,) = (y for y, row in enumerate(last) if "^" in row)
    (bob,) = (y for y, row in enumerate(last) if "<" in row)
    assert alice - bob == 10
    assert not any("r" in row.lower() for row in last if "b" not in row), "neither stands at its start"


def test_the_map_of_a_step_is_that_of_its_robot(here: Here) -> None:
    record_two(here)

    said = here.replay("--step", typed="END\nMAP\nSTART\nMAP\n")

    assert "Map of bob." in said
    assert said[-1] == "There is no map here."


def test_faster_and_slower_go_to_the_next_speed_from_any(here: Here) -> None:
    """Like the words of the same name in a session."""
    here.record("FW 1")

    slower = here.replay("--step", "--speed", "3", typed="SLOWER\nSLOWER\nSLOWER\n")
    faster = here.replay("--step", "--speed", "30", typed="FASTER\nFASTER\nFASTER\n")

    assert slower[1:] == ["Speed 2.", "Speed 1.", "Speed 1."]
    assert faster[1:] == ["Speed 50.", "Speed max.", "Speed max."]


def test_a_name_in_a_recording_makes_no_line_of_its_own(here: Here) -> None:
    """A recording is not trusted: a name with a line end could imitate any sentence."""
    record_two(here)
    recorded = (here.folder / "a.rec").read_text(encoding="utf-8")
    (here.folder / "a.rec").write_text(recorded.replace('"alice"', '"al\\nice"'), encoding="utf-8")

    said = here.replay("--step", typed="END\nWHERE\n")

    assert [line for line in said if "Position" in line and "ice" in line][-1].startswith("al ice: Position")


def test_a_replay_at_a_speed_keeps_the_order_and_stops_at_a_signal(here: Here) -> None:
    here.record('SPEAK "begun" WAIT 1000')
    running = start(here.folder, "replay", "a.rec", *QUIET, "--speed", "1")
    assert running.stdout is not None
    assert running.stdout.readline() == b"begun\n"

    running.send_signal(signal.SIGINT)

    running.communicate(timeout=TIMEOUT)
    assert running.returncode == 130


def test_a_replay_writes_the_events_of_the_run(here: Here) -> None:
    (here.folder / "a.gd").write_text(PROGRAM, encoding="utf-8")
    run = here.donnie("run", "a.gd", "--record", "a.rec", "--events", "-")

    assert here.replay("--events", "-") == run.out
    said = here.replay("--events", "b.jsonl")
    assert "olá" in said
    assert (here.folder / "b.jsonl").read_text(encoding="utf-8").splitlines() == run.out


def test_a_replay_never_overwrites_its_recording(here: Here) -> None:
    here.record("SPEAK 1")

    here.replay(
        "--events",
        "a.rec",
        code=2,
        err=["--events would overwrite a.rec, which is read here. Give another name."],
    )


def test_a_recording_of_a_newer_format_is_replayed_as_far_as_it_is_known(here: Here) -> None:
    here.record("SPEAK 1")
    first = (here.folder / "a.rec").read_bytes().splitlines(keepends=True)[0]
    here.spoil({1: first.replace(b'"donnie_recording":1', b'"donnie_recording":2')})
    newer = "This recording is of a newer Donnie: there is no map, and some of it may be missing."

    assert here.replay(err=[newer]) == ["1"]


def test_a_recording_becomes_a_picture_that_is_replaced_only_by_another(tmp_path: Path) -> None:
    (tmp_path / "p.gd").write_text("FW 6\nTR 90\nFW 4\n")
    quiet = ("--speech", "off", "--sound", "off")
    donnie(tmp_path, "run", "p.gd", "--record", "p.rec", "--speed", "max", *quiet)

    for _ in range(2):
        done = donnie(
            *(tmp_path, "replay", "p.rec", "--svg", "p.svg", "--png", "p.png", "--gif", "p.gif"),
            *("--swell", "s.svg", *quiet),
        )
        assert (done.returncode, done.stderr) == (0, b"")
    assert b"I wrote p.svg." in done.stdout
    assert b"East: 4 steps, to 4, 6." in done.stdout
    assert (tmp_path / "p.svg").read_text().count("<animate") == 2
    raised = (tmp_path / "s.svg").read_text()
    assert raised.count("stroke-dasharray") == 2  # the path and its place in the key
    assert 'width="210mm"' in raised
    assert (tmp_path / "p.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "p.gif").read_bytes().startswith(b"GIF89a")
    (tmp_path / "photo.png").write_bytes(b"\x89PNG\r\n\x1a\nsomething else")
    refused = donnie(tmp_path, "replay", "p.rec", "--png", "photo.png", *quiet)
    assert refused.returncode == 2
    assert b"would overwrite photo.png" in refused.stderr
    assert donnie(tmp_path, "replay", "p.rec", "--png", "q.png", "--step", *quiet).returncode == 2
    (tmp_path / "film.gif").write_bytes(b"GIF89a of a cat")
    assert donnie(tmp_path, "replay", "p.rec", "--gif", "film.gif", *quiet).returncode == 2


def test_pictures_of_a_run_have_the_title_of_the_author_and_the_goals_of_a_challenge(tmp_path: Path) -> None:
    (tmp_path / "p.gd").write_text("FW 6\n")
    quiet = ("--speech", "off", "--sound", "off", "--lang", "pt")
    donnie(tmp_path, "run", "p.gd", "--world", "race_track", "--record", "p.rec", "--speed", "max", *quiet)
    given = ("--svg", "p.svg", "--swell", "s.svg", "--challenge", "one_lap")

    done = donnie(tmp_path, "replay", "p.rec", *given, *quiet)

    assert (done.returncode, done.stderr) == (0, b"")
    assert "<title>Mapa de Pista de corrida</title>" in (tmp_path / "p.svg").read_text()
    assert "<title>Mapa de Pista de corrida</title>" in (tmp_path / "s.svg").read_text()
    assert (tmp_path / "p.svg").read_text().count('class="goal"') == 5


def test_the_map_of_a_replay_has_the_initials_of_colours(tmp_path: Path) -> None:
    (tmp_path / "p.gd").write_text("FW 1\n")
    quiet = ("--speech", "off", "--sound", "off", "--speed", "max")
    donnie(tmp_path, "run", "p.gd", "--world", "colour_garden", "--record", "p.rec", *quiet)

    shown = donnie(tmp_path, "replay", "p.rec", "--map", *quiet).stdout.decode()

    assert "fOf" in shown
    assert "fYf" in shown
    assert "sSs" not in shown  # there is one stone


REPORTS = (
    *("distances d.csv", "distances d.svg", "distances d.png", "distances d.txt", "distances d.html"),
    *("run r.svg", "run r.png", "run r.gif", "run r.html", "run r.csv", "trail t.csv", "map m.html"),
    *("list l.csv", "help h.csv", "manual m.txt", "paper p.svg"),
)


def test_a_replay_reports_what_the_session_reported(here: Here) -> None:
    """A conversation of three runs, each with its own clock; a file of each kind from both is the same."""
    typed = ["FW 2", "SPEAK DISTANCE F", "RUN", "TR 90", "FW 3", "RUN", "SPEAK DISTANCE F", "RUN"]
    typed += [f"REPORT {each}" for each in REPORTS] + ["REPORT distances", "REPORT run"]
    options = ("--linear", "--world", "living_room", "--record", "a.rec", "--speed", "max", *QUIET)
    out = donnie(here.folder, *options, typed="\n".join(typed)).stdout.decode().splitlines()
    names = [each.split()[1] for each in REPORTS]
    written = [(here.folder / name).read_bytes() for name in names]
    assert out[-7:-1] == [
        "Distance ahead rises from 22 to 32 in 3 steps, one jump at 3.",
        "The robot moves for 5 of 7 seconds, at most 1 step a second.",
        "The path starts at 0, 0.",
        "North: 2 steps, to 0, 2.",
        "East: 3 steps, to 3, 2.",
        "5 steps in all.",
    ]

    for each in REPORTS:
        what, name = each.split()
        assert here.replay("--report", f"{what} 2{name}")[0] == f"I wrote 2{name}."
    again = [(here.folder / f"2{name}").read_bytes() for name in names]

    assert [name for name, one, other in zip(names, written, again, strict=True) if one != other] == []
    assert here.replay("--report", "distances") == out[-7:-5]
    assert here.replay("--report", "RUN") == out[-5:-1]


def test_a_table_of_distances_and_speed_is_written_with_its_sentences(here: Here) -> None:
    here.record("FW 2\nSPEAK DISTANCE F\nFW 1", "--world", "living_room")

    for _ in range(2):  # an earlier table of Donnie's is replaced
        assert here.replay("--csv", "d.csv", "--lang", "pt") == [
            "Gravei d.csv.",
            "Distância à frente começa e termina em 22 em 0 passos.",
            "O robô anda durante 3 de 3 segundos, no máximo 1 passo por segundo.",
        ]
    assert (here.folder / "d.csv").read_text().splitlines() == [
        "segundos,distância F,velocidade",
        *("0,,1", "2,22,1", "3,,1"),
    ]


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        (
            ("--report", "tea"),
            "I can't report tea. I can report help, list, manual, map, trail, run, distances, paper.",
        ),
        (("--report", "map"), "A report of map needs a file: map.html."),
        (("--report", ""), "The option --report needs a value. The option --help says more."),
        (
            ("--report", "map m.png"),
            "A report of map can't end in .png. It can in .html, .htm, .csv, .txt.",
        ),
        (("--report", "run mine.csv"), "--report would overwrite mine.csv, which is another kind of file."),
        (("--csv", "mine.csv"), "--csv would overwrite mine.csv, which is another kind of file."),
        (("--csv", "a.rec"), "--csv would overwrite a.rec, which is read here."),
        (("--csv", "d.csv", "--step"), "--csv and --step do not go together."),
        (("--svg", "-", "--csv", "-"), "--svg and --csv can't both write -. Give two names."),
        (
            ("--csv", "d.csv", "--report", "run d.csv"),
            "--csv and --report can't both write d.csv. Give two names.",
        ),
    ],
)
def test_a_report_that_can_not_be_written_is_refused(
    here: Here, given: tuple[str, ...], sentence: str
) -> None:
    here.record("FW 1")
    (here.folder / "mine.csv").write_text("name,mark\nAna,9\n")
    done = here.donnie("replay", "a.rec", *given)

    assert (done.returncode, done.out) == (2, [])
    assert done.err[-1].startswith(sentence)
    assert (here.folder / "mine.csv").read_text() == "name,mark\nAna,9\n"


@pytest.mark.parametrize(
    ("given", "file"),
    [
        (("--svg", "{}"), "run.svg"),
        (("--png", "{}"), "run.png"),
        (("--gif", "{}"), "run.gif"),
        (("--swell", "{}"), "sheet.svg"),
        (("--csv", "{}"), "d.csv"),
        (("--report", "run {}"), "run.txt"),
        (("--report", "paper {}"), "paper.svg"),
    ],
)
def test_a_file_called_minus_is_standard_output_with_the_same_bytes_and_nothing_else(
    here: Here, given: tuple[str, str], file: str
) -> None:
    here.record("FW 2\nSPEAK DISTANCE F\nFW 1", "--world", "living_room")
    here.replay(given[0], given[1].format(file))
    (here.folder / "-").write_text("mine")  # a file of that name is nothing to Donnie

    done = donnie(here.folder, "replay", "a.rec", given[0], given[1].format("-"))

    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout == (here.folder / file).read_bytes()
    assert (here.folder / "-").read_text() == "mine"


def test_another_file_is_named_elsewhere_while_one_is_standard_output(here: Here) -> None:
    here.record("FW 2")

    done = here.donnie("replay", "a.rec", "--csv", "-", "--png", "a.png")

    assert (done.returncode, done.err) == (0, ["I wrote a.png."])
    assert done.out == ["seconds,speed", "0,1", "2,1"]


def test_a_terminal_gets_no_bytes_of_a_picture(here: Here, monkeypatch: pytest.MonkeyPatch) -> None:
    here.record("FW 2")
    monkeypatch.setattr(Output, "is_terminal", True)

    done = here.donnie("replay", "a.rec", "--png", "-")

    assert (done.returncode, done.out) == (2, [])
    assert done.err == ["A terminal can't show a picture. Give a file: --png run.png."]
    assert here.donnie("replay", "a.rec", "--svg", "-").out[0].startswith("<svg ")


def test_each_robot_is_reported(here: Here) -> None:
    record_two(here)

    here.replay("--report", "run run.csv")
    here.replay("--report", "run run.txt")
    here.replay("--report", "run run.html")
    here.replay("--csv", "d.csv")
    here.replay("--report", "distances d.svg")
    said = here.replay("--report", "run")

    rows = [line.split(",") for line in (here.folder / "run.csv").read_text().splitlines()]
    assert rows[0] == ["robot", "command", "done", "x", "y", "heading", "blocked"]
    assert {row[0] for row in rows[1:]} == {"alice", "bob"}
    starts = [line for line in said if "The path starts at" in line]
    assert [line.partition(":")[0] for line in starts] == ["alice", "bob"]
    text = (here.folder / "run.txt").read_text()
    assert [line for line in text.splitlines() if line.endswith(": The run")] == [
        "alice: The run",
        "bob: The run",
    ]
    page = (here.folder / "run.html").read_text()
    assert (page.count("<h2>"), page.count("<svg "), page.count("<table>")) == (2, 1, 2)
    table = (here.folder / "d.csv").read_text().splitlines()
    assert table[0].startswith("robot,seconds,speed")
    assert {row.partition(",")[0] for row in table[1:]} == {"alice", "bob"}
    assert {"alice: speed", "bob: speed"} <= {
        *re.findall(r">([^<>]*)</text>", (here.folder / "d.svg").read_text())
    }
    here.replay("--csv", "d.csv")  # an earlier table of Donnie's is replaced


ERRING = """
position ( size [ 0.1 0.1 0.1 ] pose [ 0 0 0 90 ] localization "odom" odom_error [ 0.3 0.3 0 0.3 ] )
model ( name "post" size [ 0.2 0.2 1 ] pose [ 1 -0.5 0 0 ] color "blue" )
"""


def test_where_odometry_has_errors_the_path_of_a_picture_is_the_believed_one(here: Here) -> None:
    (here.folder / "erring.world").write_text(ERRING)
    here.record("FW 20 TR 90 FW 20", "--world", "erring.world", "--seed", "3")
    here.replay("--svg", "run.svg")
    here.replay("--report", "trail t.csv")
    events = map(json.loads, (here.folder / "a.rec").read_text().splitlines()[1:])
    poses = [each for each in events if each["event"] == "moved"]
    believed = [(each["pose"]["x"], each["pose"]["y"]) for each in poses]
    true = [(each["true_pose"]["x"], each["true_pose"]["y"]) for each in poses]
    assert true == [(0, 20), (20, 20)]
    svg = ElementTree.fromstring((here.folder / "run.svg").read_text())
    space = "{http://www.w3.org/2000/svg}"
    line = svg.find(f"{space}polyline")
    assert line is not None
    drawn = [tuple(map(float, each.split(","))) for each in line.attrib["points"].split()]
    (post,) = svg.findall(f"{space}path")
    corners = [float(x) for x, _ in re.findall(r"(-?[\d.]+) (-?[\d.]+)", post.attrib["d"])]
    (x0, y0), scale = drawn[0], (max(corners) - min(corners)) / 4  # it is 20 cm wide
    in_steps = [((x - x0) / scale, (y0 - y) / scale) for x, y in drawn]

    def near(place: tuple[float, float]) -> float:
        return min(hypot(place[0] - x, place[1] - y) for x, y in in_steps)

    assert all(near(each) < 0.1 for each in believed)
    assert max(near(each) for each in true) > 0.5
    rows = (here.folder / "t.csv").read_text().splitlines()
    assert rows[-1].split(",")[2:4] == [str(int(each)) for each in believed[-1]]
    said = " ".join(here.replay("--report", "run"))
    assert f", to {int(believed[-1][0])}, {int(believed[-1][1])}." in said
