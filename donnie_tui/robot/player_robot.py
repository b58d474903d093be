"""A robot at a Player server, driven as the original's client drives it: by velocities, and to headings."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from math import ceil, cos, degrees, hypot, inf, radians, sin
from time import monotonic
from typing import TypeAlias

from devices.belt import LETTERS, MOTOR_PLACES
from devices.camera import Blob, things_in
from devices.player.codec import Values
from devices.ports.robot import STEP, Bearing, Grip, GripResult, Pose, RobotProblem, Sighting, StoppedBy
from devices.serial_robot.movement import Ending, LinkedRobot, Progress, met_something
from devices.serial_robot.senses import coloured_sightings, scan_angles, sightings, to_steps
from donnie_tui.robot.server_link import POLL, RobotPart, ServerLink, WheelState
from sim.colours import FAMILIES, colour_of
from sim.geometry import Spot, normal, pose_of
from sim.sensors import Device, Mounted

Advance: TypeAlias = Callable[[WheelState], StoppedBy | bool]
"""Takes a datum; True once it is over, or why it can't go on."""

FASTEST, GAIN, SLOWEST = STEP, 4.0, 0.006
"""Metres a second: at most, as the original; near the end, for each metre that is left; at least."""
NEAR_WAY, NEAR_TURN, NEAR_HEAD = 0.001, 0.5, 0.7
"""Metres and degrees: a robot that is so near to its goal has reached it."""
LARGEST_TURN = 170.0
"""Degrees of a turn to a pose: what is more could go either way round."""
NEXT_STEP, WATCHED = 1.8, 0.75
"""Steps that must be free to begin one, and beyond the one that is walked."""
STUCK, GAP = 3.0, 1.0
"""Seconds without progress that end a movement; and between two data that show that the program was held,
and the robot stood."""
VIEW, REACH = 60.0, 5.0
"""Degrees and metres: no request asks for a blobfinder's view; this is that of the original's."""
NARROWEST, WIDEST = 20.0, 150.0
"""Degrees of a camera's view."""
CLOSED, BEAMS = 2, 0b1100
"""The state of a gripper, and the beams between its paddles."""
LONGEST_GRIP, LONGEST_LOOK = 5.0, 6.0
"""Seconds of the robot's that the paddles and the head may move."""
ON_BOARD = 0.5
"""Metres from a robot within which its head is; what is farther away is another robot."""


class PlayerRobot(LinkedRobot[ServerLink]):
    """One robot of a server. Only the program's thread may call its methods, except ``halt``, ``pose``,
    ``time``, ``speed`` and ``known_distances``."""

    may_drive_on = has_run_away = False
    """False, as the server stops a robot when its last client leaves."""

    start = Pose(0.0, 0.0, 0.0)
    """Where its wheels count from, if they begin at 0 0 0. Set after construction, as the next two."""
    chosen_view: float | None = None
    """Degrees that its camera's picture covers; None: what the server says."""
    leave: tuple[Callable[[], object], ...] = ()
    """Called when the robot is closed."""
    _origin = Spot(0.0, 0.0, 0.0)
    """The place of the robot's own 0 0 0 in the world."""
    _began = _owed_way = _owed_turn = 0.0
    """Its server's time at 0; metres ahead and degrees to the right by which the last movement was too
    short."""

    @property
    def view(self) -> float:
        """Degrees of its camera's picture, known only if it has a fiducial finder."""
        given = degrees((self._link.shape(RobotPart.MARKS, 2) or (0.0,))[-1])
        return self.chosen_view or (given if NARROWEST <= given <= WIDEST else VIEW)

    @property
    def colours(self) -> frozenset[str]:
        return frozenset(FAMILIES) if RobotPart.CAMERA in self._link.shapes else frozenset()

    def connect(self) -> None:
        """Connect, within some seconds. Raises ``RobotProblem``."""
        self._link.connect()
        first = self._link.wheels()
        if first.x == first.y == first.yaw == 0.0:
            self._origin = Spot(self.start.x * STEP, self.start.y * STEP, 90.0 - self.start.heading)
        self.reset()

    def close(self) -> None:
        for leave in self.leave:
            leave()
        self._link.close()

    def reset(self) -> None:
        """Sets the time to 0. The robot stays at its place."""
        self._began = self._link.wheels().time
        self._owed_way = self._owed_turn = 0.0
        self._is_link_lost = False

    @property
    def mounted(self) -> tuple[Mounted, ...]:
        """The devices that the server names."""
        found = []
        for part in (RobotPart.SONARS, RobotPart.HEAD_SONAR):
            config = self._link.shape(part, 5)
            width, reach = (degrees(config[1] - config[0]), config[4]) if config else (0.0, 0.0)
            found += [Mounted(Device.RANGER, 0.0 - normal(each), width, reach) for each in self._yaws(part)]
        if RobotPart.CAMERA in self._link.shapes:
            found.append(Mounted(Device.EYES, 0.0, self.view, REACH))
        bars = (degrees(each[5]) for each in self._bars())
        return (*found, *(Mounted(Device.BUMPER, 0.0 - normal(each)) for each in bars))

    # --- moving

    def _walk(self, report: Progress, steps: int, sense: int) -> Ending:
        side = Bearing.FRONT if sense > 0 else Bearing.BACK
        first, permit = self._link.wheels(), self._link.permit
        east, north = cos(radians(first.yaw)) * sense, sin(radians(first.yaw)) * sense
        extra, self._owed_way = self._owed_way * sense, 0.0
        length, begun, gone = steps * STEP + extra, 0, 0.0
        before, last_left, gain = first, 0.0, GAIN
        reason: StoppedBy | None = None

        def advance(now: WheelState) -> StoppedBy | bool:
            nonlocal length, begun, gone, reason, before, last_left, gain
            creeps = hypot(now.x - before.x, now.y - before.y) < NEAR_WAY + SLOWEST * (now.time - before.time)
            before = now
            gone = (now.x - first.x) * east + (now.y - first.y) * north - extra
            report.reached(gone / STEP, self.pose())
            if self._touches(in_front=sense > 0) or (now.is_stalled and now.time > first.time):
                return StoppedBy.COLLISION
            free = min(self._near(side), default=inf)
            if begun < steps and reason is None and gone >= begun * STEP - FASTEST * POLL:
                if free + gone - begun * STEP < NEXT_STEP * STEP:
                    length, reason = begun * STEP + extra, StoppedBy.OBSTACLE
                else:
                    begun += 1
            left = length - extra - gone
            if reason is None and free < begun * STEP - gone + WATCHED * STEP:
                return StoppedBy.OBSTACLE
            if (creeps and abs(left) < NEAR_WAY) or (reason and left < NEAR_WAY):
                return reason or True
            if left * last_left < 0.0:  # too far: data or speeds come late
                gain /= 2
            last_left = left
            speed = min(FASTEST, max(SLOWEST, gain * abs(left)))
            self._link.drive(permit, speed * sense * (1 if left > 0 else -1))
            return False

        end = self._move(advance, permit)
        left = length - extra - gone
        self._owed_way = left * sense if end in (None, StoppedBy.OBSTACLE) and abs(left) < STEP / 2 else 0.0
        done = report.finished(gone / STEP, end, self.pose())
        return Ending(done, end, met_something(end, 0.0 if sense > 0 else 180.0))

    def _turn(self, report: Progress, asked: int, sense: int) -> Ending:
        permit, pressed = self._link.permit, self._pressed()
        first = self._link.wheels()
        last, done, left = first.yaw, 0.0, asked + self._owed_turn * sense
        self._owed_turn = 0.0

        def advance(now: WheelState) -> StoppedBy | bool:
            nonlocal last, done, left
            gone = -normal(now.yaw - last) * sense
            before, last, done, left = left, now.yaw, done + gone, left - gone
            report.reached(done, self.pose())
            if (now.is_stalled and now.time > first.time) or self._pressed() > pressed:
                return StoppedBy.COLLISION
            if abs(left) < NEAR_TURN and abs(left) >= abs(before) - 0.01:  # it comes no nearer
                return True
            self._link.turn_to(permit, now, now.yaw - sense * min(left, LARGEST_TURN))
            return False

        end = self._move(advance, permit)
        self._owed_turn = left * sense if end is None else 0.0
        return Ending(report.finished(done, end, self.pose()), end, met_something(end, sense * 90.0))

    def _move(self, advance: Advance, permit: int) -> StoppedBy | None:
        """Calls ``advance`` with each datum until it ends the movement, then stops the robot."""
        try:
            return self._follow(advance, permit)
        finally:
            self._link.drive(permit, 0.0)

    def _follow(self, advance: Advance, permit: int, *, is_waiting: bool = False) -> StoppedBy | None:
        """Call ``advance`` with each datum, the last one first. ``is_waiting``: it may stand as long as it
        likes."""
        epoch, at, last, moved_at = self._link.epoch, -1.0, None, inf
        while True:
            if not self._pace.sleep(0.0) or permit != self._link.permit:
                return StoppedBy.USER
            now = self._link.wait_for_data(at)
            if epoch != self._link.epoch or not self._link.is_there:
                self._is_link_lost = True
                return StoppedBy.LINK
            if now is None:
                continue
            place = (now.x, now.y, now.yaw)
            if place != last or now.time - at > GAP:
                moved_at = now.time
            at, last = now.time, place
            self._report_passing(self.pose(), monotonic())
            end = advance(now)
            if end is not False:
                return None if end is True else end
            if now.time - moved_at > STUCK and not is_waiting:
                return StoppedBy.STALL

    def _is_linked(self) -> bool:
        return self._link.is_there

    # --- waiting and sensing

    def wait(self, seconds: float) -> bool:
        """Wait. Raises ``RobotProblem`` ``link-lost`` without a server, or if it is lost meanwhile."""
        self._require_link()
        ends = self._link.wheels().time + max(0.0, seconds)
        return self._wait(lambda now: now.time >= ends - 1e-9)

    def _wait(self, is_over: Callable[[WheelState], bool]) -> bool:
        """False if it was cut short. RobotProblem ``link-lost``."""
        end = self._follow(is_over, self._link.permit, is_waiting=True)
        if end is StoppedBy.LINK:
            self._require_link()
        return end is None

    def time(self) -> float:
        return self._link.wheels().time - self._began

    def pose(self) -> Pose:
        """The intended end of the last movement; the next movement corrects the difference."""
        now = self._link.wheels()
        here = Spot(now.x, now.y, now.yaw - self._owed_turn)
        ended = here.ahead(self._owed_way, here.yaw)
        return pose_of(self._origin.mounted(ended.x, ended.y, ended.yaw))

    def distance(self, bearing: Bearing) -> int:
        """RobotProblem ``no-sensor`` where no sensor looks there, ``link-lost`` without a server."""
        self._require_link()
        known = self.known_distances()
        if bearing not in known:
            raise RobotProblem("no-sensor", bearing=bearing.words)
        return known[bearing]

    def known_distances(self) -> Mapping[Bearing, int]:
        near = {bearing: self._near(bearing) for bearing in Bearing}
        return {bearing: to_steps(min(metres) * 100) for bearing, metres in near.items() if metres}

    def _near(self, side: Bearing) -> list[float]:
        """Metres, of each sensor or sample that looks there."""
        readings = self._readings(RobotPart.SONARS)
        return [metres for yaw, metres, width in readings if abs(normal(-yaw - side.value)) <= width]

    def _readings(self, part: RobotPart) -> Iterator[tuple[float, float, float]]:
        """The direction and metres of each sample of a ranger, and how far from a bearing it may be."""
        ranges, config = next(iter(self._link.values(part)), ()), self._link.shape(part, 5)
        yaws = self._yaws(part) or ORIGINAL_SONARS
        farthest, width = config[4] - 0.005 if config else inf, WIDE
        if len(yaws) == 1 < len(ranges) and config:
            width, first = NARROW, yaws[0] + degrees(config[0] + config[2] / 2)
            yaws = [first + degrees(i * config[2]) for i in range(len(ranges))]
        for yaw, metres in zip(yaws, ranges, strict=False):
            yield yaw, (metres if metres < farthest else inf), width

    def _yaws(self, part: RobotPart) -> list[float]:
        return [degrees(each[5]) for each in (self._link.shape(part) or ((), ()))[-2]]

    def _bars(self) -> Sequence[Values]:
        return next(iter(self._link.shape(RobotPart.BUMPERS)), ())

    def _pressed(self) -> frozenset[int]:
        bars = next(iter(self._link.values(RobotPart.BUMPERS)), b"")
        return frozenset(i for i, each in enumerate(bars) if each)

    def _touches(self, *, in_front: bool) -> bool:
        """Whether a bar on that side is pressed; where bars are unknown, the first two are in front."""
        sides = [each[0] >= 0.0 for each in self._bars()] or [True, True, False, False]
        return any(sides[each] is in_front for each in self._pressed() if each < len(sides))

    # --- looking round

    def scan(self) -> tuple[Sighting, ...]:
        """Turns the head, if it has one. RobotProblem ``no-eyes`` without a camera or a sonar on the head."""
        self._require_link()
        base, head = self._link.wheels(), self._link.values(RobotPart.HEAD) or (inf, inf)
        has_head = hypot(head[0] - base.x, head[1] - base.y) < ON_BOARD
        has_camera = RobotPart.CAMERA in self._link.shapes
        if not has_camera and not (has_head and RobotPart.HEAD_SONAR in self._link.shapes):
            raise RobotProblem("no-eyes")
        pictures = ceil(180.0 / self.view)
        turns = [(each - (pictures - 1) / 2) * self.view for each in range(pictures)]
        directions = turns if has_camera else [float(each) for each in scan_angles(15)]
        looks: list[tuple[float, tuple[Blob, ...]]] = []
        measured: list[tuple[int, float | None]] = []
        for direction in directions if has_head else [0.0]:
            if has_head and not self._look(direction):
                break
            if has_camera:
                looks.append((direction, tuple(self._blobs())))
            else:
                echo = min((metres for _, metres, _ in self._readings(RobotPart.HEAD_SONAR)), default=inf)
                measured.append((int(direction), echo * 100))
        if has_head:
            self._look(0.0)
        things = things_in(looks, self.view, is_even=True)
        return coloured_sightings(things, measured) if has_camera else sightings(measured)

    def _look(self, direction: float) -> bool:
        """Turn the head ``direction`` degrees to the right, and wait for what its devices find there."""
        base = self._link.wheels()
        goal, there = normal(base.yaw - direction), inf

        def is_over(now: WheelState) -> bool:
            nonlocal there
            head = self._link.values(RobotPart.HEAD)
            if there == inf and (not head or abs(normal(degrees(head[2]) - goal)) < NEAR_HEAD):
                there = now.time
            self._link.command(RobotPart.HEAD, 2, base.x, base.y, radians(goal), 0.0, 0.0, 0.0, 1)
            eye = RobotPart.CAMERA if self._link.values(RobotPart.CAMERA) else RobotPart.HEAD_SONAR
            return self._link.time_of(eye) > there or now.time > base.time + LONGEST_LOOK

        return self._wait(is_over)

    def _blobs(self) -> Iterator[Blob]:
        """Things that the camera sees, with distances from the head's sonar, which is not in the middle."""
        width, _, blobs = self._link.values(RobotPart.CAMERA) or (1, 1, ())
        sonar = self._link.shape(RobotPart.HEAD_SONAR)
        ahead = sonar[-2][0][0] if sonar and sonar[-2] else 0.0
        for _, rgb, _, _, _, left, right, _, _, metres in blobs:
            parts = ((rgb >> shift & 255) / 255 for shift in (16, 8, 0))
            family = colour_of("", *parts).family
            yield Blob(family, left / width, (right + 1) / width, metres=max(0.0, metres - ahead))

    # --- the gripper

    def grip(self) -> GripResult:
        """RobotProblem ``no-gripper`` without one, ``link-lost`` without a server."""
        if self._holds():
            return GripResult(Grip.HOLDS_ALREADY)
        self._move_paddles(1)  # if they have closed on nothing
        self._move_paddles(2)
        if self._holds():
            return GripResult(Grip.GRIPPED)
        self._move_paddles(1)
        return GripResult(Grip.NOTHING_THERE)

    def release(self) -> GripResult:
        """RobotProblem ``no-gripper`` without one, ``link-lost`` without a server."""
        held = self._holds()
        self._move_paddles(1)
        return GripResult(Grip.RELEASED if held else Grip.HOLDS_NOTHING)

    def _holds(self) -> bool:
        self._require_link()
        if RobotPart.GRIPPER not in self._link.shapes:
            raise RobotProblem("no-gripper")
        state, beams, _ = self._link.values(RobotPart.GRIPPER) or (0, 0, 0)
        return state == CLOSED and bool(beams & BEAMS)

    def _move_paddles(self, wanted: int) -> None:
        """Opens (1) or closes (2) the gripper, and waits until it has done so."""
        self._link.command(RobotPart.GRIPPER, wanted)
        ends = self._link.wheels().time + LONGEST_GRIP
        self._wait(lambda now: self._link.values(RobotPart.GRIPPER)[:1] == (wanted,) or now.time > ends)

    # --- what is shown and said there

    def say(self, text: str) -> None:
        self._link.command(RobotPart.SPEECH, 1, text)

    def show_belt(self, levels: tuple[int, ...]) -> None:
        """14 levels."""
        for place, level in zip(MOTOR_PLACES, levels, strict=False):
            for belt in (RobotPart.BELT, RobotPart.SECOND_BELT):
                self._link.command(belt, 1, place, LETTERS[level])


ORIGINAL_SONARS = [-45.0, 0.0, 45.0, 135.0, 180.0, -135.0]
"""The directions of sonars if the server doesn't report them."""
WIDE, NARROW = 22.5, 7.5
"""Degrees from a bearing: of one of several sensors, and of a sample of one."""
