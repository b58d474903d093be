"""What is mounted on a model, read from its settings: wheels, sensors, grippers. Defaults are Stage's."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sim.scene import (
    Blobfinder,
    Bounds,
    Bumper,
    Camera,
    Drive,
    FiducialFinder,
    Gripper,
    Limits,
    Localization,
    NoteKind,
    OdometryError,
    RangeNoise,
    RangeSensor,
    Wheels,
)
from sim.worldfile.entities import Setting
from sim.worldfile.mistakes import Code
from sim.worldfile.values import ValueReader, mistake

MOST_BUMPERS = 1000
MOST_SAMPLES = 10_000
"""Of one sensor."""
MOST_SAMPLES_OF_ALL = 2_000_000
_SHORTEST_PADDLE, _LONGEST_PADDLE = 0.01, 0.99

Settings = Mapping[str, Setting]


def range_sensor(read: ValueReader, settings: Settings) -> RangeSensor:
    usual = RangeSensor()
    minimum, maximum = read.span(settings, "range", (usual.minimum, usual.maximum))
    fov = _fov(read.angle(settings, "fov", usual.fov))
    samples = read.whole(settings, "samples", 1, MOST_SAMPLES)
    size = read.size(settings, usual.size)
    noise = _noise(read, settings)
    return RangeSensor(read.place(settings, "pose"), minimum, maximum, fov, samples, noise, size)


def _noise(read: ValueReader, settings: Settings) -> RangeNoise:
    """Stage's three numbers, or one tuple of them: in parts of the distance, in metres, in degrees."""
    proportional, constant, angle = 0.0, 0.0, 0.0
    if (setting := settings.get("noise")) is not None:
        proportional, constant, angle = read.numbers(setting, 3, 3)
        constant, angle = constant * read.metres, angle * read.degrees
    return RangeNoise(
        constant=abs(read.length(settings, "range_noise_const", constant)),
        proportional=min(1.0, abs(read.number(settings, "range_noise", proportional))),
        angle=min(360.0, abs(read.angle(settings, "angle_noise", angle))),
    )


def blobfinder(read: ValueReader, settings: Settings) -> Blobfinder:
    maximum, fov = read.length(settings, "range", 12.0), _fov(read.angle(settings, "fov", 60.0))
    image = (80, 60)
    if (setting := settings.get("image")) is not None:
        across, down = (int(min(100_000, max(1, each))) for each in read.numbers(setting, 2, 2))
        image = (across, down)
    pan = read.angle(settings, "pan", 0.0) % 360.0
    return Blobfinder(max(0.0, maximum), fov, read.colours(settings), pan, image)


def fiducial_finder(read: ValueReader, settings: Settings) -> FiducialFinder:
    usual = FiducialFinder()
    minimum = max(0.0, read.length(settings, "range_min", usual.minimum))
    maximum = max(minimum, read.length(settings, "range_max", usual.maximum))
    maximum_id = max(0.0, read.length(settings, "range_max_id", usual.maximum_id))
    return FiducialFinder(minimum, maximum, maximum_id, _fov(read.angle(settings, "fov", usual.fov)))


def bumpers(read: ValueReader, settings: Settings) -> Iterable[Bumper]:
    """Without a ``bcount`` as many as there are poses."""
    given = sum(1 for name in settings if name.startswith("bpose["))
    common = max(0.0, read.length(settings, "blength", 0.1))
    for i in range(read.whole(settings, "bcount", given, MOST_BUMPERS, least=0)):
        length = max(0.0, read.length(settings, f"blength[{i}]", common))
        yield Bumper(read.place(settings, f"bpose[{i}]"), length)


def gripper(read: ValueReader, settings: Settings) -> Gripper:
    usual = Gripper()
    sizes = [usual.paddle_length, usual.paddle_width, usual.paddle_height]
    if (setting := settings.get("paddle_size")) is not None:
        sizes = [min(_LONGEST_PADDLE, max(_SHORTEST_PADDLE, each)) for each in read.numbers(setting, 3, 3)]
    closed, lifted = _paddle_state(read, settings)
    snatches = read.number(settings, "autosnatch", 0) != 0
    return Gripper(sizes[0], min(0.49, sizes[1]), sizes[2], closed, lifted, snatches)


def _paddle_state(read: ValueReader, settings: Settings) -> tuple[bool, bool]:
    setting = settings.get("paddle_state")
    if setting is None:
        return False, False
    states = read.words(setting, ("open", "closed", "up", "down"))
    return "closed" in states, "up" in states


def camera(read: ValueReader, settings: Settings) -> Camera:
    usual = Camera()
    minimum, maximum = read.span(settings, "range", (usual.minimum, usual.maximum))
    fov, pan, tilt = usual.fov, usual.pan, usual.tilt
    if (setting := settings.get("fov")) is not None:
        across, *up = read.numbers(setting, 1, 2)  # degrees, whatever the file's unit (manual, 3.2.1.1)
        fov = (_fov(across), _fov(up[0]) if up else usual.fov[1])
    if (setting := settings.get("pantilt")) is not None:
        pan, tilt = read.numbers(setting, 2, 2)
    return Camera(minimum, maximum, fov, pan % 360.0, tilt % 360.0)


def wheels(read: ValueReader, settings: Settings) -> Wheels:
    drive = read.one_of(settings, "drive", "diff", tuple(each.value for each in Drive))
    localization = read.one_of(settings, "localization", "gps", tuple(each.value for each in Localization))
    origin = read.place(settings, "localization_origin") if "localization_origin" in settings else None
    return Wheels(
        Drive(drive),
        Localization(localization),
        origin,
        _odometry_error(read, settings),
        _limits(read, settings, "velocity_bounds"),
        _limits(read, settings, "acceleration_bounds"),
        max(1e-3, read.length(settings, "wheelbase", 1.0)),
    )


def _odometry_error(read: ValueReader, settings: Settings) -> OdometryError:
    """``[x y z angle]``, or the manual's ``[x y angle]``. Parts, not lengths; Stage reads four."""
    if (setting := settings.get("odom_error")) is None:
        return OdometryError()
    numbers = read.numbers(setting, 3, 6)
    if len(numbers) > 4:
        read.note(NoteKind.REPAIRED, "first-four", setting, name="odom_error")
    x, y, *_, yaw = (min(2.0, abs(each)) for each in numbers[:4])
    return OdometryError(x, y, yaw)


def _limits(read: ValueReader, settings: Settings, name: str) -> Limits | None:
    """``[xmin xmax ymin ymax zmin zmax amin amax]``."""
    if (setting := settings.get(name)) is None:
        return None
    values = read.numbers(setting, 8, 8)
    x, y = _bounds(setting, values[0:2], read.metres), _bounds(setting, values[2:4], read.metres)
    return Limits(x, y, _bounds(setting, values[6:8], read.degrees))


def _bounds(setting: Setting, pair: tuple[float, ...], unit: float) -> Bounds:
    low, high = pair[0] * unit, pair[1] * unit
    if low > high:
        raise mistake(Code.WRONG_ORDER, setting, name=setting.property.name)
    if not -1e6 <= low <= high <= 1e6:
        raise mistake(Code.OUT_OF_RANGE, setting, name=setting.property.name)
    return low, high


def _fov(degrees: float) -> float:
    return min(360.0, max(0.0, degrees))
