"""The real robot waits and senses: sonars, the head, and sensors that are not fitted."""

from __future__ import annotations

from pathlib import Path

import pytest

from devices.ports.robot import Bearing, RobotProblem
from devices.serial_robot.config import RobotConfig
from devices.serial_robot.senses import scan_angles, sightings
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
