"""The real robot waits and senses: sonars, the head, and sensors that are not fitted."""

from __future__ import annotations

from math import inf
from pathlib import Path
from types import SimpleNamespace

import pytest

from devices.camera import ColouredThing
from devices.ports.robot import Bearing, RobotProblem
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.senses import (
    BoardSensors,
    Clearance,
    centimetres,
    coloured_sightings,
    head_angle,
    scan_angles,
    sightings,
    to_steps,
)
from devices.wire.link_state import LinkState
from devices.wire.telemetry import RangeSample, Telemetry
from donnie_tui.robot.connection import make_camera
from donnie_tui.settings.settings import Settings
from tests.unit.devices.pictures import BLUE, GREEN, RED, drawn, save
from tests.unit.devices.robots import Real, Sonars, wall_ahead


def test_waiting_takes_the_robots_time_and_can_be_cut_short() -> None:
    real = Real()

    assert real.robot.wait(2.5) is True
    assert real.robot.time() == pytest.approx(2.5)
    real.pace.stops_at = 3.0
    assert real.robot.wait(10) is False


@pytest.mark.parametrize(
    ("seconds", "waited"), [(0.0, 0.0), (-1.0, 0.0), (0.03, 0.03), (0.05, 0.05), (0.12, 0.12)]
)
def test_a_wait_takes_exactly_the_time_that_it_says(seconds: float, waited: float) -> None:
    real = Real()
    before = real.robot.time()

    assert real.robot.wait(seconds) is True
    assert real.robot.time() - before == pytest.approx(waited, abs=0.002)


def test_a_halt_ends_a_wait() -> None:
    real = Real()
    real.pace.due = [(1.0, real.robot.halt)]

    assert real.robot.wait(5.0) is False
    assert real.robot.time() == pytest.approx(1.0, abs=0.1)


@pytest.mark.parametrize(
    ("bearing", "sonar"),
    [
        (Bearing.FRONT_RIGHT, 0),
        (Bearing.FRONT, 1),
        (Bearing.FRONT_LEFT, 2),
        (Bearing.BACK_LEFT, 3),
        (Bearing.BACK, 4),
        (Bearing.BACK_RIGHT, 5),
    ],
)
def test_each_bearing_has_the_sonar_of_the_documented_order(bearing: Bearing, sonar: int) -> None:
    sonars = Sonars(far=100.0)
    sonars.far[sonar] = lambda place: 32.0
    real = Real(sonars)
    real.robot.wait(0.5)

    assert real.robot.distance(bearing) == 6


def test_the_configuration_orders_the_sonars() -> None:
    sonars = Sonars(far=100.0)
    sonars.far[3] = lambda place: 32.0
    order = list(RobotConfig().sonars)
    order[3], order[5] = order[5], order[3]
    real = Real(sonars, RobotConfig(sonars=tuple(order)))
    real.robot.wait(0.5)

    assert real.robot.distance(Bearing.BACK_RIGHT) == 6


@pytest.mark.parametrize("far", [None, 201.0, 255.0, 256.0])
def test_ranges_a_far_missing_or_unknown_echo_is_the_maximum_distance(
    far: float | None,
) -> None:
    real = Real(Sonars(far))

    assert real.robot.distance(Bearing.FRONT) == 60


def test_right_after_the_start_a_distance_waits_for_the_first_measurement() -> None:
    assert Real(wall_ahead(7)).robot.distance(Bearing.FRONT) == 7


@pytest.mark.parametrize(("stops_at", "seconds"), [(inf, 0.4), (0.0, 0.0)])
def test_a_sonar_that_measures_nothing_is_waited_for_two_refreshes_or_until_a_stop(
    stops_at: float, seconds: float
) -> None:
    real = Real(Sonars(far=256.0))
    before = real.robot.time()
    real.pace.stops_at = stops_at

    assert real.robot.distance(Bearing.FRONT) == 60
    assert real.robot.time() - before == pytest.approx(seconds)


def test_a_sensor_that_is_not_fitted_is_reported_as_missing() -> None:
    real = Real(config=RobotConfig(sonars=(None, Bearing.FRONT, None, None, None, None)))

    with pytest.raises(RobotProblem) as caught:
        real.robot.distance(Bearing.BACK)
    assert (caught.value.code, caught.value.values) == ("no-sensor", {"bearing": "back"})


def test_asking_for_the_known_distances_takes_no_time_and_sends_nothing() -> None:
    """A sonar that has not measured yet, or isn't fitted, is missing."""
    sonars = Sonars(far=32.0)
    sonars.far[4] = lambda place: 0.0
    real = Real(sonars, RobotConfig(sonars=(None, Bearing.FRONT, None, None, Bearing.BACK, None)))
    real.robot.wait(0.5)
    before, real.link.written = real.robot.time(), []

    assert real.robot.known_distances() == {Bearing.FRONT: 6}
    assert (real.robot.time(), real.link.written) == (before, [])


def test_after_a_lost_link_no_distance_is_known() -> None:
    real = Real(wall_ahead(7))
    real.robot.wait(0.5)
    assert real.robot.known_distances()[Bearing.FRONT] == 7

    real.link.is_plugged = False
    real.link.advance(0.1)

    assert real.robot.known_distances() == {}


def test_a_scan_reports_what_the_sonar_on_the_head_meets_without_a_colour() -> None:
    sonars = Sonars()
    real = Real(sonars)
    sonars.far[6] = lambda place: {60: 50.0, 75: 52.0, 150: 30.0}.get(real.board.head)

    seen = real.robot.scan()

    assert [(each.degrees, each.steps, each.colour, each.name) for each in seen] == [
        (-22.5, 10.0, "", ""),
        (60.0, 6.0, "", ""),
    ]
    real.link.advance(0.5)
    assert real.board.head == 90


def test_a_robot_that_is_closed_gives_its_camera_back() -> None:
    closed: list[bool] = []
    real = Real()
    real.robot.camera = SimpleNamespace(  # type: ignore[assignment]
        close=lambda: closed.append(real.link.state is LinkState.CLOSED)
    )
    real.robot.close()
    assert closed == [True]
    Real().robot.close()


def test_a_robot_without_a_camera_distinguishes_no_colours() -> None:
    assert Real().robot.colours == frozenset()


def with_camera(path: Path, sonars: Sonars) -> Real:
    real = Real(sonars)
    real.robot.camera = make_camera(Settings(camera=str(path)))
    return real


def test_a_scan_reports_the_coloured_things_of_the_camera_as_far_as_the_sonar_measures(
    tmp_path: Path,
) -> None:
    """The original looks from 90 degrees left to 90 right; what only the sonar meets has no colour."""
    save(
        tmp_path, {"-60.png": drawn((290, 200, 350, 260, GREEN)), "+30.png": drawn((290, 200, 350, 260, RED))}
    )
    sonars = Sonars()
    real = with_camera(tmp_path, sonars)
    sonars.far[6] = lambda place: {30: 50.0, 90: 20.0}.get(real.board.head)

    seen = real.robot.scan()

    assert real.robot.colours == {"red", "green", "blue"}
    assert [(round(each.degrees), each.steps, each.colour) for each in seen] == [
        (-60, 10.0, "green"),
        (30, 60, "red"),
    ]
    assert real.watcher.failed == []
    real.link.advance(0.5)
    assert real.board.head == 90


def test_the_nearest_echo_across_a_wide_thing_is_its_distance(tmp_path: Path) -> None:
    save(tmp_path, {"0.png": drawn((100, 200, 540, 260, BLUE))})
    sonars = Sonars()
    real = with_camera(tmp_path, sonars)
    sonars.far[6] = lambda place: {75: 60.0, 90: 80.0, 105: 45.0, 135: 10.0}.get(real.board.head)

    assert [each.steps for each in real.robot.scan()] == [9.0]


def test_a_camera_that_fails_is_reported_and_the_sonar_still_scans(tmp_path: Path) -> None:
    (tmp_path / "-30.png").write_bytes(b"no picture")
    sonars = Sonars()
    real = with_camera(tmp_path, sonars)
    sonars.far[6] = lambda place: {150: 30.0}.get(real.board.head)

    assert [(each.degrees, each.steps, each.colour) for each in real.robot.scan()] == [(60.0, 6.0, "")]
    assert real.watcher.failed == ["no-picture"]


def test_a_scan_without_a_head_reports_the_missing_camera() -> None:
    with pytest.raises(RobotProblem) as caught:
        Real(config=RobotConfig(head_sonar=None)).robot.scan()
    assert caught.value.code == "no-camera"


def test_a_stop_ends_a_scan() -> None:
    real = Real(stops_at=1.0)
    real.robot.scan()

    assert real.robot.time() < 1.5


def test_neighbours_equally_far_are_one_thing() -> None:
    met = [(-15, None), (0, 40.0), (15, 44.0), (30, 60.0), (45, float("inf")), (60, 61.0)]

    assert [(each.degrees, each.steps) for each in sightings(met)] == [(7.5, 8.0), (30, 12.0), (60, 12.2)]
    assert list(scan_angles(45)) == [-90, -45, 0, 45, 90]


# --- what is measured


def sample(measured: int, at: float = 0.0, moved: int = 0) -> RangeSample:
    """The sonar in front has measured this; both wheels had come so far."""
    return RangeSample(at, moved, moved, (0, measured, 0, 0, 0, 0, 0))


def measured(*samples: RangeSample, moved: int = 0) -> Telemetry:
    return Telemetry(right=moved, left=moved, ranges=samples)


@pytest.mark.parametrize(
    ("value", "found"),
    [(0, None), (1, 1.0), (140, 140.0), (141, inf), (142, 142.0), (200, 200.0), (201, inf), (255, inf)],
)
def test_a_reading_is_unknown_far_or_some_centimetres(value: int, found: float | None) -> None:
    assert centimetres(sample(value), 1, 2.0) == found
    assert BoardSensors(RobotConfig()).newest(measured(sample(9), sample(value)), 1) == found
    assert BoardSensors(RobotConfig()).newest(measured(), 1) is None


@pytest.mark.parametrize(
    ("value", "steps"), [(None, 60), (inf, 60), (0.0, 0), (4.4, 0), (4.6, 1), (9.4, 1), (200.0, 40)]
)
def test_whole_steps_of_five_centimetres_are_near(value: float | None, steps: int) -> None:
    assert to_steps(value) == steps


@pytest.mark.parametrize(
    ("readings", "clearance"),
    [
        ((50, 50), Clearance.FREE),
        ((3, 50), Clearance.FREE),
        ((0, 141), Clearance.FREE),
        ((4, 4), Clearance.FREE),  # a centimetre is rounded off: it may be 5
        ((3, 3), Clearance.BLOCKED),
        ((0, 3), Clearance.BLOCKED),
        ((3, 0), Clearance.BLOCKED),
        ((50, 3), Clearance.DOUBTFUL),
        ((50, 0), Clearance.DOUBTFUL),
        ((0, 0), Clearance.FREE),
        ((3,), Clearance.DOUBTFUL),
        ((), Clearance.DOUBTFUL),
    ],
)
def test_an_obstacle_is_one_if_two_refreshes_show_it(readings: tuple[int, ...], clearance: Clearance) -> None:
    """One step of 5 cm is needed."""
    samples = [sample(each, at) for each, at in zip(readings, (1.0, 1.4), strict=False)]

    assert BoardSensors(RobotConfig()).ahead(measured(*samples), 1, 1.0, 1) is clearance
    assert BoardSensors(RobotConfig()).ahead(measured(*samples), None, 1.0, 1) is Clearance.FREE


@pytest.mark.parametrize(("later", "clearance"), [(1.36, Clearance.BLOCKED), (1.34, Clearance.DOUBTFUL)])
def test_two_refreshes_take_four_tenths_of_a_second(later: float, clearance: Clearance) -> None:
    seen = measured(sample(3, 1.0), sample(3, later))

    assert BoardSensors(RobotConfig()).ahead(seen, 1, 1.0, 1) is clearance
    assert BoardSensors(RobotConfig()).is_close(seen, Bearing.FRONT, 0.05) is (clearance is Clearance.BLOCKED)


@pytest.mark.parametrize(
    ("sense", "moved", "needed", "clearance"),
    [
        (1, 341, 8.0, Clearance.FREE),  # measured 45 cm a step ago: 40 now, and one is rounded off
        (1, 341, 8.3, Clearance.BLOCKED),
        (-1, -341, 8.3, Clearance.BLOCKED),
        (-1, 341, 9.0, Clearance.FREE),  # it came from there
        (-1, 341, 10.3, Clearance.BLOCKED),
    ],
)
def test_a_measurement_counts_from_where_the_robot_was(
    sense: int, moved: int, needed: float, clearance: Clearance
) -> None:
    seen = measured(sample(45, 1.0, 100), sample(45, 1.4, 100), moved=100 + moved)

    assert BoardSensors(RobotConfig()).ahead(seen, 1, needed, sense) is clearance


@pytest.mark.parametrize(
    ("readings", "is_close"),
    [((4, 4), True), ((4, 5), False), ((5, 4), False), ((0, 4), False), ((4, 141), False)],
)
def test_something_is_close_if_all_measurements_are_below_the_limit(
    readings: tuple[int, int], is_close: bool
) -> None:
    seen = measured(sample(readings[0], 1.0), sample(readings[1], 1.4))

    assert BoardSensors(RobotConfig()).is_close(seen, Bearing.FRONT, 0.05) is is_close
    unfitted = BoardSensors(RobotConfig(sonars=(None,) * 6))
    assert unfitted.is_close(seen, Bearing.FRONT, 0.05) is False
    assert unfitted.known(seen) == {}


def test_a_bumper_touches_where_it_is_pressed() -> None:
    pressed = Telemetry(bumpers=(False, True, False, False, False, False))

    assert BoardSensors(RobotConfig()).touches(pressed, {0, 1, 2}) is True
    assert BoardSensors(RobotConfig()).touches(pressed, {3, 4, 5}) is False


# --- a scan


@pytest.mark.parametrize(
    ("direction", "angle", "mirrored"),
    [(0, 90, 90), (-90, 0, 180), (90, 180, 0), (30, 120, 60), (-91, 0, 180), (200, 180, 0)],
)
def test_the_head_turns_from_full_left_to_full_right(direction: int, angle: int, mirrored: int) -> None:
    assert head_angle(direction) == angle
    assert head_angle(direction, is_mirrored=True) == mirrored


def test_a_scan_looks_from_left_to_right_at_both_ends() -> None:
    assert [*scan_angles(45)] == [-90, -45, 0, 45, 90]


@pytest.mark.parametrize(
    ("measurements", "things"),
    [
        ([(-30, 50.0), (-15, 60.0), (0, 55.0)], [(-15.0, 10.0)]),
        ([(-30, 50.0), (-15, 60.1)], [(-30.0, 10.0), (-15.0, 12.02)]),
        ([(-30, 50.0), (-15, None), (0, 50.0)], [(-30.0, 10.0), (0.0, 10.0)]),
        ([(-30, 50.0), (-15, inf), (0, 50.0)], [(-30.0, 10.0), (0.0, 10.0)]),
        ([(-30, 70.0), (-15, 62.0), (0, 54.0)], [(-15.0, 10.8)]),
        ([(-30, None), (-15, inf)], []),
    ],
)
def test_neighbours_within_ten_centimetres_are_one_thing(
    measurements: list[tuple[int, float | None]], things: list[tuple[float, float]]
) -> None:
    found = [(each.degrees, each.steps) for each in sightings(measurements)]

    assert found == [pytest.approx(each) for each in things]


@pytest.mark.parametrize(
    ("thing", "steps"),
    [
        (ColouredThing("red", 0.0, -20.0, 20.0), 8.0),  # the nearest between its borders
        (ColouredThing("red", -15.0, -15.0, -15.0), 10.0),
        (ColouredThing("red", -7.0, -15.0, 0.0), 10.0),  # its borders count
        (ColouredThing("red", 7.0, 0.0, 15.0), 8.0),
        (ColouredThing("red", 0.0, -14.9, 14.9), 12.0),
        (ColouredThing("red", 4.0, 3.0, 5.0), 12.0),  # the nearest direction
        (ColouredThing("red", 11.0, 10.0, 12.0), 8.0),
        (ColouredThing("red", 30.0, 29.0, 31.0), 60.0),
        (ColouredThing("red", 45.0, 44.0, 46.0), 60.0),
        (ColouredThing("red", 0.0, -20.0, 20.0, 0.25), 5.0),  # as the camera measures
    ],
)
def test_a_coloured_thing_is_as_far_as_the_sonar_measures_there(thing: ColouredThing, steps: float) -> None:
    echoes = [(-15, 50.0), (0, 60.0), (15, 40.0), (30, None), (45, inf)]

    assert [each.steps for each in coloured_sightings([thing], echoes)] == [pytest.approx(steps)]


@pytest.mark.parametrize(("seen", "shown"), [(-92.0, -90.0), (92.0, 90.0), (-90.0, -90.0), (33.0, 33.0)])
def test_a_coloured_thing_is_at_most_a_quarter_of_a_turn_aside(seen: float, shown: float) -> None:
    (found,) = coloured_sightings([ColouredThing("blue", seen, seen, seen)], [])

    assert (found.degrees, found.steps, found.colour, found.name) == (shown, 60, "blue", "")
