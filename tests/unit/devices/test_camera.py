"""The coloured things in pictures, their directions, and what can be wrong with a camera."""

from __future__ import annotations

import os
import struct
import sys
import zlib
from math import atan, degrees, radians, tan
from pathlib import Path

import cv2
import numpy as np
import pytest
from PIL import Image

from devices.camera import (
    ORIGINAL_RANGES,
    Blob,
    CameraSweep,
    ColourCamera,
    blobs_in,
    do_overlap,
    measured_range,
    read_picture,
    things_in,
)
from devices.ports.robot import RobotProblem
from devices.serial_ports import allow_only
from devices.serial_robot.senses import coloured_sightings
from donnie_tui.process.confinement import OutsideError
from donnie_tui.robot.connection import make_camera
from donnie_tui.settings.settings import Settings
from tests.unit.devices.pictures import BLUE, GREEN, RED, drawn, save


def camera(path: object, view: float | None = None) -> ColourCamera:
    made = make_camera(Settings(camera=str(path), camera_view=view))
    assert made is not None
    return made


def swept(made: ColourCamera) -> CameraSweep:
    """One turn of the head."""
    sweep = CameraSweep(made)
    for direction in sweep.directions:
        sweep.look(direction)
    return sweep


def seen(made: ColourCamera) -> list[tuple[str, int]]:
    sweep = swept(made)
    assert sweep.problem is None
    return [(each.colour, round(each.degrees)) for each in sweep.things()]


def fault(path: object) -> tuple[str, dict[str, str | int]]:
    problem = swept(camera(path)).problem
    assert problem is not None
    return problem.code, problem.values


def colours(picture: np.ndarray) -> list[str]:
    return [each.colour for each in blobs_in(picture, ORIGINAL_RANGES)]


# --- blobs


@pytest.mark.parametrize(
    ("pixel", "colour"),
    [
        ((255, 0, 0), "red"),
        ((150, 10, 20), "red"),
        ((200, 20, 90), "red"),
        ((0, 255, 0), "green"),
        ((0, 128, 0), "green"),
        ((20, 150, 70), "green"),
        ((0, 0, 255), "blue"),
        ((40, 90, 160), "blue"),
    ],
)
def test_a_thing_of_each_colour_is_found(pixel: tuple[int, int, int], colour: str) -> None:
    assert colours(drawn((200, 100, 300, 200, pixel))) == [colour]


@pytest.mark.parametrize(
    "pixel", [(255, 255, 255), (0, 0, 0), (128, 128, 128), (210, 200, 198), (230, 220, 0), (240, 140, 0)]
)
def test_white_black_grey_and_other_colours_are_not_found(pixel: tuple[int, int, int]) -> None:
    assert colours(drawn((200, 100, 300, 200, pixel))) == []


@pytest.mark.parametrize(
    ("hue", "saturation", "value", "found"),
    [
        *((121, 255, 255, ["red"]), (11, 255, 255, ["red"]), (12, 255, 255, [])),
        *((0, 32, 255, ["red"]), (0, 31, 255, []), (0, 255, 87, ["red"]), (0, 255, 86, [])),
        *((56, 255, 255, ["green"]), (55, 255, 255, []), (89, 255, 255, ["green"])),
        *((99, 255, 255, ["green", "blue"]), (100, 255, 255, ["blue"]), (90, 99, 200, ["blue"])),
        *((70, 169, 255, ["green"]), (70, 168, 255, []), (60, 255, 17, ["green"]), (60, 255, 16, [])),
        *((89, 99, 200, []), (120, 255, 255, ["blue"]), (120, 32, 255, ["blue"]), (120, 31, 255, [])),
        *((120, 255, 48, ["blue"]), (120, 255, 47, [])),
    ],
)
def test_the_limits_of_the_colours_are_those_of_the_original(
    hue: int, saturation: int, value: int, found: list[str]
) -> None:
    pixel = cv2.cvtColor(np.array([[[hue, saturation, value]]], np.uint8), cv2.COLOR_HSV2RGB)[0, 0]

    assert colours(drawn((200, 100, 300, 200, tuple(int(each) for each in pixel)))) == found


def test_every_area_of_a_colour_counts() -> None:
    picture = drawn((10, 10, 60, 60, RED), (100, 10, 160, 60, RED), (300, 300, 400, 400, BLUE))

    assert colours(picture) == ["red", "red", "blue"]


def test_specks_and_small_areas_are_noise() -> None:
    """The original ignores what has less than 500 pixels of 640 x 480, and single pixels."""
    specks = [(x, y, x + 1, y + 1, RED) for x in range(0, 640, 9) for y in range(0, 480, 9)]

    assert colours(drawn(*specks, (100, 100, 120, 120, BLUE))) == []
    assert colours(drawn((100, 100, 130, 130, BLUE))) == ["blue"]


def test_a_hole_in_a_thing_is_no_thing() -> None:
    assert colours(drawn((100, 100, 300, 300, RED), (150, 150, 250, 250, (0, 0, 0)))) == ["red"]


@pytest.mark.parametrize("width", [160, 1920])
def test_the_size_of_the_picture_does_not_matter(width: int) -> None:
    height = width * 3 // 4
    thing = (width // 4, height // 4, width // 2, height // 2, GREEN)

    (found,) = blobs_in(drawn(thing, width=width, height=height), ORIGINAL_RANGES)

    assert (found.left, found.right) == (pytest.approx(0.25, abs=0.02), pytest.approx(0.5, abs=0.02))


@pytest.mark.parametrize("factor", [1, 2, 3])
def test_an_area_is_erased_by_two_pixels_and_widened_by_three(factor: int) -> None:
    """As in the original: one pixel is lost at the left and top, then one is won on all sides.

    A larger picture is made as small as one of the original's before.
    """
    thing = (160 * factor, 120 * factor, 320 * factor, 240 * factor, GREEN)
    (found,) = blobs_in(drawn(thing, width=640 * factor, height=480 * factor), ORIGINAL_RANGES)

    assert (found.left * 640, found.right * 640) == (160, 321)
    assert (found.top * 480, found.bottom * 480) == (120, 241)


@pytest.mark.parametrize(("width", "is_found"), [(25, True), (24, False)])
def test_an_area_counts_from_five_hundred_pixels_on(width: int, is_found: bool) -> None:
    """``min_blob_size`` of the original's settings, in pictures of its size."""
    thing = drawn((160, 120, 160 + width, 140, GREEN), width=640, height=480)

    assert bool(blobs_in(thing, ORIGINAL_RANGES)) is is_found


@pytest.mark.parametrize(("size", "things"), [((1, 1), 0), ((5000, 1), 0), ((1, 5000), 0), ((2, 3), 1)])
def test_a_picture_of_any_size_can_be_searched_and_measured(size: tuple[int, int], things: int) -> None:
    """Height and width. What is one pixel high or wide, as a border, has no area."""
    picture = np.full((*size, 3), RED, np.uint8)

    assert len(blobs_in(picture, ORIGINAL_RANGES)) == things
    assert measured_range(picture) is not None


def test_a_picture_of_a_phone_is_turned_as_the_phone_was_held(tmp_path: Path) -> None:
    """Orientation 6: the top of the picture is its right border."""
    exif = Image.Exif()
    exif[0x0112] = 6
    Image.fromarray(drawn((20, 200, 120, 300, RED))).save(tmp_path / "a.jpg", exif=exif)

    (thing,) = swept(camera(tmp_path)).things()

    assert abs(thing.degrees) < 3


def test_other_ranges_find_other_colours() -> None:
    picture = drawn((200, 100, 300, 200, (230, 220, 0)))

    assert [each.colour for each in blobs_in(picture, {"yellow": (25, 35, 100, 255, 100, 255)})] == ["yellow"]


# --- directions


@pytest.mark.parametrize("view", [40, 60, 100])
@pytest.mark.parametrize("middle", [80, 320, 500])
def test_the_direction_follows_from_the_place_in_the_picture(
    view: float, middle: int, tmp_path: Path
) -> None:
    """As in a camera without lens errors: the tangent grows evenly from the middle."""
    folder = save(tmp_path / "p", {"+30.png": drawn((middle - 15, 200, middle + 15, 260, RED))})
    aside = degrees(atan((middle - 320) / 320 * tan(radians(view / 2))))

    (thing,) = swept(camera(folder, view)).things()

    assert thing.degrees == pytest.approx(30 + aside, abs=0.7)


def test_a_thing_in_neighbouring_pictures_is_one_thing(tmp_path: Path) -> None:
    """At 15 degrees: 128 pixels and more from the middle of both, with 60 degrees in 640 pixels."""
    off = round(320 * tan(radians(15)) / tan(radians(30)))
    left, right = 320 + off, 320 - off
    folder = save(
        tmp_path / "p",
        {
            "0.png": drawn((left - 25, 200, left + 25, 260, RED)),
            "+30.png": drawn((right - 25, 200, right + 25, 260, RED)),
        },
    )

    assert seen(camera(folder)) == [("red", 15)]


@pytest.mark.parametrize(
    ("looks", "low", "high"),
    [
        ([(0.0, Blob("red", 0.875, 1.0)), (32.0, Blob("red", 0.25, 0.5))], 16, 32),
        ([(0.0, Blob("red", 0.5, 0.75)), (32.0, Blob("red", 0.0, 0.125))], 0, 16),
        ([(0.0, Blob("red", 0.75, 1.0)), (32.0, Blob("red", 0.0, 0.75))], 0, 48),
    ],
)
def test_a_thing_that_a_border_cuts_is_placed_by_the_picture_that_has_it_whole(
    looks: list[tuple[float, Blob]], low: float, high: float
) -> None:
    """By all where none has it whole. Pictures of 64 degrees: a sixteenth of one is four."""
    (thing,) = things_in([(direction, (blob,)) for direction, blob in looks], 64, is_even=True)

    assert (thing.low, thing.high) == (low, high)


@pytest.mark.parametrize(("right", "degrees"), [(0.5625, [93]), (0.625, [])])
def test_a_thing_counts_as_far_aside_as_the_head_may_look(right: float, degrees: list[float]) -> None:
    """90 degrees, and three by which it may miss them. The middles are 3 and 6 degrees beyond."""
    on_the_right, on_the_left = Blob("red", 0.5, right), Blob("red", 1 - right, 0.5)

    assert [each.degrees for each in things_in([(90, (on_the_right,))], 96, is_even=True)] == degrees
    assert [-each.degrees for each in things_in([(-90, (on_the_left,))], 96, is_even=True)] == degrees


def test_a_blob_of_a_finder_without_rows_is_as_high_as_its_picture() -> None:
    assert (Blob("red", 0.25, 0.5).top, Blob("red", 0.25, 0.5).bottom) == (0, 1)


def test_a_thing_wider_than_a_picture_is_one_thing_in_the_middle_of_all() -> None:
    pictures = [(each, (Blob("red", 0.0, 1.0, 0.3, 0.6),)) for each in (-30, 0, 30)]

    (thing,) = things_in(pictures, 60)

    assert (thing.degrees, thing.low, thing.high) == pytest.approx((0, -60, 60))


def test_what_a_finder_of_equal_columns_sees_across_a_border_is_one_thing_as_near_as_its_nearest() -> None:
    """A sixth of a picture of 60 degrees is 10 degrees, also at its border."""
    ahead = (Blob("red", 5 / 6, 1.0, metres=1.0),)
    aside = (Blob("red", 0.0, 1 / 6, metres=0.9), Blob("blue", 1 / 3, 1 / 2, metres=2.0))

    red, blue = things_in([(0.0, ahead), (60.0, aside)], 60, is_even=True)

    assert (red.colour, red.low, red.high, red.metres) == ("red", *map(pytest.approx, (20, 40)), 0.9)
    assert (blue.colour, blue.degrees, blue.metres) == ("blue", pytest.approx(55), 2.0)
    assert [each.steps for each in coloured_sightings((red, blue), ())] == pytest.approx([18, 40])


def test_two_things_in_one_direction_are_two_where_a_picture_shows_both() -> None:
    above, below = Blob("red", 0.4, 0.6, 0.1, 0.3), Blob("red", 0.4, 0.6, 0.6, 0.8)

    assert len(things_in([(0, (above, below))], 60)) == 2


def test_things_of_two_colours_in_one_direction_are_two() -> None:
    red, blue = (Blob(each, 0.4, 0.6, 0.3, 0.6) for each in ("red", "blue"))

    assert {each.colour for each in things_in([(0, (red,)), (0, (blue,))], 60)} == {"red", "blue"}


def test_what_is_farther_than_90_degrees_aside_is_not_in_view(tmp_path: Path) -> None:
    folder = save(tmp_path / "p", {"-90.png": drawn((20, 200, 60, 260, RED), (500, 200, 540, 260, BLUE))})

    assert [colour for colour, _ in seen(camera(folder))] == ["blue"]


# --- pictures in place of a camera


def test_a_picture_is_what_is_straight_ahead(tmp_path: Path) -> None:
    folder = save(tmp_path / "p", {"a.png": drawn((290, 200, 350, 260, GREEN))})

    assert seen(camera(folder / "a.png")) == [("green", 0)]


@pytest.mark.parametrize("suffix", ["png", "jpg", "jpeg", "ppm", "bmp", "gif"])
def test_pictures_of_the_usual_kinds_are_read(suffix: str, tmp_path: Path) -> None:
    Image.fromarray(drawn((290, 200, 350, 260, GREEN))).save(tmp_path / f"a.{suffix}")

    assert seen(camera(tmp_path)) == [("green", 0)]


@pytest.mark.parametrize(("factor", "smaller"), [(1, 1), (2, 2), (3, 2)])
def test_a_large_jpeg_is_decoded_about_as_large_as_a_picture_of_the_original(
    factor: int, smaller: int, tmp_path: Path
) -> None:
    """A JPEG can be decoded at a half of its size, at a quarter or at an eighth."""
    path = tmp_path / "a.jpg"
    Image.new("RGB", (640 * factor, 480 * factor)).save(path)

    assert read_picture(str(path), Bytes(path.read_bytes())).shape == (
        480 * factor // smaller, 640 * factor // smaller, 3
    )  # fmt: skip


class Bytes:
    """A file for ``read_picture``: its content, or the reason why it can't be read."""

    def __init__(self, content: bytes | Exception) -> None:
        self._content = content
        self.most = 0

    def names_in(self, folder: str) -> list[str]:
        raise NotADirectoryError

    def read(self, path: str, most: int) -> bytes:
        self.most = most
        if isinstance(self._content, Exception):
            raise self._content
        return self._content[:most]


def test_the_pictures_of_a_folder_follow_each_other_and_begin_again(tmp_path: Path) -> None:
    folder = save(
        tmp_path / "p",
        {
            "2.png": drawn((290, 200, 350, 260, GREEN)),
            "10.jpg": drawn((290, 200, 350, 260, BLUE)),
            "1.bmp": drawn((290, 200, 350, 260, RED)),
            "B.png": drawn((290, 200, 350, 260, GREEN)),
            "a.png": drawn((290, 200, 350, 260, RED)),
        },
    )
    (folder / "notes.txt").write_text("no picture")
    made = camera(folder)

    found = [seen(made)[0][0] for _ in range(6)]

    assert found == ["red", "green", "blue", "red", "green", "red"]


def test_a_folder_with_too_many_pictures_is_refused_before_one_is_read(tmp_path: Path) -> None:
    for number in range(1000):
        (tmp_path / f"{number}.png").touch()
    problem = swept(camera(tmp_path)).problem
    assert problem is not None
    assert problem.code == "no-picture"

    (tmp_path / "one_more.png").touch()
    problem = swept(camera(tmp_path)).problem
    assert problem is not None
    assert (problem.code, problem.values["limit"]) == ("too-many-pictures", 1000)


def test_a_name_that_is_a_number_with_a_sign_is_a_direction(tmp_path: Path) -> None:
    ahead = drawn((290, 200, 350, 260, RED))
    folder = save(tmp_path / "p", {"-90.png": ahead, "0.png": ahead, "+45.png": ahead})

    assert seen(camera(folder)) == [("red", -90), ("red", 0), ("red", 45)]
    for name in (".+30.png", "notes.txt"):
        (folder / name).write_bytes((folder / "0.png").read_bytes())
    assert seen(camera(folder)) == [("red", -90), ("red", 0), ("red", 45)]


# --- faults


def test_an_empty_folder_is_a_fault(tmp_path: Path) -> None:
    assert fault(tmp_path) == ("no-pictures", {"path": str(tmp_path)})


def test_a_missing_picture_is_a_fault(tmp_path: Path) -> None:
    assert fault(tmp_path / "a.png") == ("picture-missing", {"path": str(tmp_path / "a.png")})


@pytest.mark.parametrize(
    ("problem", "code", "values"),
    [
        (ValueError("embedded null byte"), "picture-unreadable", {"reason": "embedded null byte"}),
        (PermissionError(13, "Permission denied"), "picture-unreadable", {"reason": "Permission denied"}),
        (OutsideError("a.png"), "picture-outside", {"reason": "Permission denied"}),
        (FileNotFoundError(2, "No such file"), "picture-missing", {}),
    ],
)
def test_why_a_picture_can_not_be_read_is_said(problem: Exception, code: str, values: dict[str, str]) -> None:
    with pytest.raises(RobotProblem) as raised:
        read_picture("a.png", Bytes(problem))

    assert (raised.value.code, raised.value.values) == (code, {"path": "a.png", **values})


def test_a_name_that_no_file_can_have_is_a_fault() -> None:
    assert fault("a\0b") == ("picture-unreadable", {"path": "a\0b", "reason": "embedded null byte"})


@pytest.mark.parametrize("data", [b"", b"FW 3\n", b"\x89PNG\r\n\x1a\n" + bytes(40), b"\xff\xd8\xff\xe0"])
def test_what_is_no_picture_is_a_fault(data: bytes, tmp_path: Path) -> None:
    (tmp_path / "a.png").write_bytes(data)

    assert fault(tmp_path) == ("no-picture", {"path": str(tmp_path / "a.png")})


def test_a_pipe_and_a_folder_are_no_pictures_and_nothing_waits(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "a.png")
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder" / "b.png").mkdir()

    assert fault(tmp_path / "a.png")[0] == "no-picture"
    assert fault(tmp_path / "folder")[0] == "no-picture"


def test_a_jpeg_of_too_many_layers_is_a_fault(tmp_path: Path) -> None:
    save(tmp_path, {"a.jpg": drawn()})
    with (tmp_path / "a.jpg").open("ab") as file:
        file.write(b"\xff\xda" * (101 - (tmp_path / "a.jpg").read_bytes().count(b"\xff\xda")))

    assert fault(tmp_path)[0] == "picture-too-large"


def test_a_damaged_picture_is_a_fault(tmp_path: Path) -> None:
    save(tmp_path, {"a.png": drawn((290, 200, 350, 260, RED))})
    (tmp_path / "a.png").write_bytes((tmp_path / "a.png").read_bytes()[:300])

    assert fault(tmp_path)[0] == "no-picture"


def png_head(width: int, height: int) -> bytes:
    """A PNG without its pixels."""
    parts = (b"IHDR" + struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0), b"IDAT", b"IEND")
    chunks = (struct.pack(">I", len(part) - 4) + part + struct.pack(">I", zlib.crc32(part)) for part in parts)
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks)


@pytest.mark.parametrize(
    ("width", "height", "code"),
    [
        (5000, 5000, "no-picture"),
        (5001, 5000, "picture-too-large"),
        (10_000, 10_000, "picture-too-large"),  # Pillow warns
        (20_000, 20_000, "picture-too-large"),  # Pillow refuses
    ],
)
def test_a_picture_with_too_many_pixels_is_a_fault_before_it_is_decoded(
    width: int, height: int, code: str
) -> None:
    with pytest.raises(RobotProblem, match=f"^{code}$") as raised:
        read_picture("a.png", Bytes(png_head(width, height)))

    assert raised.value.values == {"path": "a.png"} | ({"limit": 25} if code == "picture-too-large" else {})


def test_a_file_with_too_many_bytes_is_a_fault_and_not_read_to_its_end() -> None:
    file = Bytes(bytes(20_000_002))
    with pytest.raises(RobotProblem, match=r"^picture-too-large$"):
        read_picture("a.png", file)

    assert file.most == 20_000_001


def test_a_camera_that_is_not_plugged_in_is_a_fault() -> None:
    assert fault("/dev/video-of-no-machine") == ("no-port", {"port": "/dev/video-of-no-machine"})
    with pytest.raises(RobotProblem, match=r"^no-port$"):  # also where only one direction is looked at
        camera("/dev/video-of-no-machine").look(0)


def test_a_camera_that_opencv_stumbles_over_is_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    class Broken(Device):
        def read(self) -> tuple[bool, np.ndarray | None]:
            raise cv2.error("no frame")

    monkeypatch.setattr(cv2, "VideoCapture", Broken)

    assert fault("/dev/null") == ("camera-failed", {"camera": "/dev/null"})


def test_a_device_that_is_no_camera_is_a_fault() -> None:
    assert fault("/dev/null") == ("camera-failed", {"camera": "/dev/null"})


def test_opencv_prints_nothing_and_gives_a_camera_three_seconds_unless_the_settings_differ(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(os, "environ", {"OPENCV_LOG_LEVEL": "ERROR"})
    camera("/dev/null").directions()

    assert os.environ == {"OPENCV_LOG_LEVEL": "ERROR", "OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT": "3"}
    monkeypatch.setattr(os, "environ", {})
    camera("/dev/null").directions()
    assert os.environ["OPENCV_LOG_LEVEL"] == "SILENT"


def test_without_the_extra_the_fault_says_what_to_install(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    save(tmp_path, {"a.png": drawn()})
    monkeypatch.setitem(sys.modules, "cv2", None)

    assert fault(tmp_path) == ("no-opencv", {})


class Device:
    """A camera of the computer: it makes pictures until it is unplugged."""

    opened = 0
    left = 1000
    frame = cv2.cvtColor(drawn((290, 200, 350, 260, BLUE)), cv2.COLOR_RGB2BGR)

    def __init__(self, name: object, interface: int) -> None:
        Device.opened += 1

    def set(self, what: int, value: float) -> bool:
        return True

    def read(self) -> tuple[bool, np.ndarray | None]:
        Device.left -= 1
        return (True, self.frame) if Device.left >= 0 else (False, None)

    def release(self) -> None:
        pass


def test_a_camera_of_the_computer_sees_and_may_be_unplugged_and_come_back(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(cv2, "VideoCapture", Device)
    monkeypatch.setattr(Device, "opened", 0)
    monkeypatch.setattr(Device, "left", 1000)
    made = camera("/dev/null")

    assert seen(made) == [("blue", each) for each in range(-90, 91, 30)]
    assert Device.opened == 1
    assert Device.left == 1000 - 7 * 5  # a camera keeps up to four pictures of before

    Device.left = 12
    problem = swept(made).problem
    assert problem is not None
    assert (problem.code, problem.values) == ("camera-failed", {"camera": "/dev/null"})
    assert Device.left == -1  # it isn't asked again: each answer of a camera that hangs takes seconds

    Device.left = 1000
    assert len(seen(made)) == 7
    assert Device.opened == 2


# --- measuring


@pytest.mark.parametrize("pixel", [RED, GREEN, BLUE, (230, 220, 0), (255, 20, 40)])
def test_a_measured_range_finds_the_thing_again_in_a_little_less_light(pixel: tuple[int, int, int]) -> None:
    random = np.random.default_rng(1)
    noise = random.normal(0, 6, (480, 640, 3))
    held = np.clip(drawn((150, 100, 500, 400, pixel)) + noise, 0, 255).astype(np.uint8)

    found = measured_range(held)

    assert found is not None
    darker = np.clip(0.9 * drawn((300, 200, 400, 300, pixel)) + noise, 0, 255).astype(np.uint8)
    assert len(blobs_in(darker, {"it": found})) == 1


def test_a_measured_red_goes_on_through_hue_0() -> None:
    picture = drawn((0, 0, 320, 480, (220, 20, 40)), (320, 0, 640, 480, (220, 40, 20)))

    found = measured_range(picture)

    assert found is not None
    assert found[0] > 160
    assert found[1] < 20


@pytest.mark.parametrize(
    "picture",
    [
        drawn(),
        drawn((300, 220, 340, 260, RED)),
        drawn((0, 0, 320, 480, RED), (320, 0, 640, 480, GREEN)),
        np.zeros((480, 640, 3), np.uint8),
    ],
    ids=["a wall", "too small", "two colours", "dark"],
)
def test_without_one_colour_in_the_middle_nothing_is_measured(picture: np.ndarray) -> None:
    assert measured_range(picture) is None


def test_ranges_that_share_a_hue_overlap() -> None:
    red, orange, blue = (170, 8, 0, 255, 0, 255), (5, 15, 0, 255, 0, 255), (100, 120, 0, 255, 0, 255)

    assert do_overlap(red, orange)
    assert not do_overlap(red, blue)


@pytest.mark.parametrize(
    ("one", "other", "is_shared"),
    [
        *(((10, 20), (20, 30), True), ((10, 19), (20, 30), False), ((30, 30), (30, 30), True)),
        *(((170, 5), (5, 9), True), ((170, 5), (6, 169), False), ((170, 5), (150, 170), True)),
        *(((170, 5), (0, 0), True), ((170, 5), (179, 179), True), ((30, 30), (31, 31), False)),
    ],
)
def test_the_hues_of_a_range_go_from_its_least_to_its_most_and_through_0(
    one: tuple[int, int], other: tuple[int, int], is_shared: bool
) -> None:
    first, second = ((*each, 0, 255, 0, 255) for each in (one, other))

    assert do_overlap(first, second) is is_shared
    assert do_overlap(second, first) is is_shared


@pytest.mark.parametrize(("view", "directions"), [(44.0, 15), (45.0, 30), (60.0, 30), (None, 30)])
def test_a_narrow_camera_looks_twice_as_often(view: float | None, directions: int) -> None:
    """Of a camera whose view was not set it is that of the original robot's, 60 degrees."""
    assert camera("/dev/null", view).view == (60 if view is None else view)
    assert camera("/dev/null", view).directions() == tuple(range(-90, 91, directions))


@pytest.mark.parametrize("missing", [os.R_OK, os.W_OK])
def test_a_camera_that_may_not_be_used_is_a_fault(missing: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "access", lambda _, wanted: not wanted & missing)

    assert fault("/dev/null") == ("no-permission", {"port": "/dev/null"})


def test_a_camera_that_was_not_named_may_not_be_used() -> None:
    made = camera("/dev/null")
    allow_only(["/dev/zero"])
    try:
        problem = swept(made).problem
    finally:
        allow_only(None)

    assert problem is not None
    assert (problem.code, problem.values) == ("port-not-named", {"port": "/dev/null"})


def test_a_camera_makes_pictures_as_large_as_the_originals_and_is_given_back(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    calls: list[tuple[object, ...]] = []

    class Watched(Device):
        def __init__(self, name: object, interface: int) -> None:
            calls.append((name, interface))

        def set(self, what: int, value: float) -> bool:
            calls.append((what, value))
            return True

        def release(self) -> None:
            calls.append(("release",))

    monkeypatch.setattr(cv2, "VideoCapture", Watched)
    monkeypatch.setattr(Device, "left", 1000)
    made = camera("/dev/null")
    made.look(0)
    made.look(0)
    made.close()
    made.close()

    assert calls == [
        ("/dev/null", cv2.CAP_V4L2),
        (cv2.CAP_PROP_FRAME_WIDTH, 640),
        (cv2.CAP_PROP_FRAME_HEIGHT, 480),
        ("release",),
    ]


def test_a_camera_is_opened_by_its_number(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[object] = []

    class Numbered(Device):
        def __init__(self, name: object, interface: int) -> None:
            asked.append(name)

    monkeypatch.setattr(cv2, "VideoCapture", Numbered)
    monkeypatch.setattr(os.path, "exists", lambda _: True)
    monkeypatch.setattr(os, "access", lambda *_: True)
    for name in ("7", "/dev/video12", "/dev/null"):
        camera(name).look(0)

    assert asked == [7, 12, "/dev/null"]


def test_a_look_raises_the_fault(tmp_path: Path) -> None:
    with pytest.raises(RobotProblem, match=r"^no-pictures$"):
        camera(tmp_path).directions()


# --- measuring and joining at their limits


def of_hsv(*columns: tuple[int, tuple[int, int, int]], height: int = 30) -> np.ndarray:
    """A picture with so many columns of each hue, saturation and value."""
    hsv = np.concatenate([np.full((height, width, 3), pixel, np.uint8) for width, pixel in columns], axis=1)
    return np.asarray(cv2.cvtColor(hsv, cv2.COLOR_HSV2RGB))


GREY, GRASS = (0, 0, 128), (60, 200, 150)


def test_only_the_middle_third_is_measured_and_widened_by_its_margins() -> None:
    middle = of_hsv((30, GREY), (30, GRASS), (30, GREY))
    border = of_hsv((90, (120, 200, 200)))
    picture = np.concatenate((border, middle, border))
    measured = measured_range(picture)

    assert measured == (54, 66, pytest.approx(160, abs=2), 255, 100, 255)
    assert measured_range(picture[30:60]) == measured
    for row, column in ((0, 30), (60, 30), (30, 0), (30, 60)):  # what is next to it doesn't count
        other = picture.copy()
        other[row : row + 30, column : column + 30] = (255, 0, 255)
        assert measured_range(other) == measured


@pytest.mark.parametrize(
    ("one", "other", "hues"),
    [(40, 80, (34, 86)), (39, 81, None), (175, 5, (169, 11)), (170, 178, (164, 4)), (20, 60, (14, 66))],
)
def test_one_colour_has_hues_of_at_most_forty(one: int, other: int, hues: tuple[int, int] | None) -> None:
    measured = measured_range(of_hsv((45, (one, 255, 200)), (45, (other, 255, 200))))

    assert (None if measured is None else measured[:2]) == hues


@pytest.mark.parametrize("hue", range(0, 180, 10))
def test_the_hues_of_a_colour_are_found_anywhere_in_their_circle(hue: int) -> None:
    measured = measured_range(of_hsv((45, (hue, 255, 200)), (45, ((hue + 20) % 180, 255, 200))))

    assert measured is not None
    assert measured[:2] == ((hue - 6) % 180, (hue + 26) % 180)


@pytest.mark.parametrize(("columns", "least", "most"), [(10, (54, 156, 95), 66), (11, (50, 119, 50), 70)])
def test_a_tenth_of_the_pixels_may_be_other_ones_at_each_end(
    columns: int, least: tuple[int, int, int], most: int
) -> None:
    """A tenth of a thousand pixels ends between two, of which the second counts nine times as much."""
    middle = ((columns, (56, 159, 100)), (100 - 2 * columns, GRASS), (columns, (64, 239, 200)))
    measured = measured_range(of_hsv((100, GREY), *middle, (100, GREY)))

    assert measured is not None
    assert (measured[0], measured[2], measured[4]) == pytest.approx(least, abs=2)
    assert measured[1] == most


@pytest.mark.parametrize(("columns", "is_measured"), [(59, False), (61, True)])
def test_at_least_six_of_ten_pixels_have_a_hue(columns: int, is_measured: bool) -> None:
    picture = of_hsv((100, GREY), (columns, GRASS), (200 - columns, GREY))

    assert (measured_range(picture) is not None) == is_measured


@pytest.mark.parametrize(
    ("saturation", "value", "least"),
    [(200, 200, (160, 150)), (60, 60, (40, 40)), (44, 200, (40, 150)), (200, 44, (160, 40))],
)
def test_a_pale_or_dark_colour_has_a_least_saturation_and_value(
    saturation: int, value: int, least: tuple[int, int]
) -> None:
    measured = measured_range(of_hsv((90, (60, saturation, value))))

    assert measured is not None
    assert (measured[2], measured[4]) == pytest.approx(least, abs=3)
    assert (measured[3], measured[5]) == (255, 255)


@pytest.mark.parametrize(
    ("pixel", "is_measured"),
    [((215, 255, 215), True), ((216, 255, 216), False), ((0, 40, 0), True), ((0, 39, 0), False)],
)
def test_what_is_paler_or_darker_than_forty_has_no_colour(
    pixel: tuple[int, int, int], is_measured: bool
) -> None:
    """The saturation of a pixel is 255 times the difference of its most and its least, by its most."""
    assert (measured_range(np.full((30, 90, 3), pixel, np.uint8)) is not None) is is_measured


def joined(*looks: tuple[float, tuple[Blob, ...]]) -> list[tuple[int, int]]:
    return [(round(each.low), round(each.high)) for each in things_in(looks, 60, is_even=True)]


@pytest.mark.parametrize(
    ("looks", "things"),
    [
        # of two glimpses the one that covers more of the thing is it
        (
            ((0, (Blob("red", 0.5, 0.9),)), (30, (Blob("red", 0.0, 0.3), Blob("red", 0.35, 0.5)))),
            [(0, 24), (21, 30)],
        ),
        # of two things the one that is covered more
        (
            ((0, (Blob("red", 0.5, 0.6), Blob("red", 0.65, 0.9))), (30, (Blob("red", 0.1, 0.4),))),
            [(0, 6), (6, 24)],
        ),
        # three degrees apart are two, less is one
        (((0, (Blob("red", 0.5, 0.6),)), (30, (Blob("red", 0.15, 0.3),))), [(0, 6), (9, 18)]),
        (((0, (Blob("red", 0.5, 0.6),)), (30, (Blob("red", 0.14, 0.3),))), [(0, 6)]),
        # one above the other are two
        (
            ((0, (Blob("red", 0.5, 0.6, 0.0, 0.5),)), (30, (Blob("red", 0.0, 0.1, 0.5, 1.0),))),
            [(0, 6), (0, 6)],
        ),
        (
            ((0, (Blob("red", 0.5, 0.6, 0.5, 1.0),)), (30, (Blob("red", 0.0, 0.1, 0.0, 0.5),))),
            [(0, 6), (0, 6)],
        ),
    ],
)
def test_neighbouring_glimpses_are_one_thing_where_they_overlap_most(
    looks: tuple[tuple[float, tuple[Blob, ...]], ...], things: list[tuple[int, int]]
) -> None:
    assert sorted(joined(*looks)) == sorted(things)


def test_hidden_files_are_no_pictures(tmp_path: Path) -> None:
    (tmp_path / ".hidden.png").write_bytes(b"")

    assert fault(tmp_path)[0] == "no-pictures"


@pytest.mark.parametrize(
    ("name", "direction"),
    [
        *(("-90.png", -90), ("+90.PNG", 90), ("-0.jpeg", 0), ("+5.gif", 5), ("-91.png", 0), ("+99.ppm", 0)),
        *(("45.png", 0), ("+45b.bmp", 0), ("+100.png", 0), ("a+45.png", 0), ("+.png", 0)),
    ],
)
def test_a_picture_whose_name_is_no_direction_is_what_is_straight_ahead(
    name: str, direction: int, tmp_path: Path
) -> None:
    (tmp_path / name).touch()

    assert camera(tmp_path).directions() == (direction,)


def test_in_a_direction_without_a_picture_nothing_can_be_seen(tmp_path: Path) -> None:
    made = camera(save(tmp_path / "p", {"-90.png": drawn()}))
    assert made.directions() == (-90,)

    with pytest.raises(RobotProblem, match=r"^no-pictures$"):
        made.look(0)


def test_a_picture_with_as_many_bytes_and_layers_as_allowed_is_read(tmp_path: Path) -> None:
    save(tmp_path, {"a.jpg": drawn((290, 200, 350, 260, GREEN))})
    data = (tmp_path / "a.jpg").read_bytes()
    data += b"\xff\xda" * (100 - data.count(b"\xff\xda"))
    (tmp_path / "a.jpg").write_bytes(data.ljust(20_000_000, b"\0"))

    assert seen(camera(tmp_path)) == [("green", 0)]


def test_a_picture_that_is_no_jpeg_has_no_layers(tmp_path: Path) -> None:
    save(tmp_path, {"a.png": drawn((290, 200, 350, 260, GREEN))})
    with (tmp_path / "a.png").open("ab") as file:
        file.write(b"\xff\xda" * 101)

    assert seen(camera(tmp_path)) == [("green", 0)]


def test_after_a_fault_a_sweep_looks_no_more_and_keeps_what_it_saw(tmp_path: Path) -> None:
    picture = drawn((290, 200, 350, 260, RED))
    folder = save(tmp_path / "p", {"-90.png": picture, "-0.png": picture, "+90.png": picture})
    sweep = CameraSweep(camera(folder))
    sweep.look(-90)
    sweep.look(-45)
    assert not sweep.is_blind
    (folder / "-0.png").unlink()
    sweep.look(0)
    sweep.look(90)

    assert sweep.is_blind
    assert sweep.problem is not None
    assert sweep.problem.code == "picture-missing"
    assert [round(each.degrees) for each in sweep.things()] == [-90]


def test_a_sweep_without_a_camera_is_blind_and_sees_nothing() -> None:
    sweep = CameraSweep(None)
    sweep.look(0)

    assert (sweep.is_blind, sweep.directions, sweep.things(), sweep.problem) == (True, (), (), None)
