"""How fast the simulator is: one command of one robot, a program's, pushing, and 1 to 1000 robots.

One command is measured against one ray through the same world by pymunk's ``segment_query_first``,
interleaved; medians, with the quarters as the spread. Of many robots steps a second are printed, and how time
and memory grow; of wandering robots, each with a program, the processor time of a simulated second, against
what Stage 4.3 took with its wander controller, 10 Hz and 9 rays, on a machine on which a ray took 4 us.
The targets of pushing, of sonars and of loading are times on that machine, so they are compared in rays, too.
Processor time, so that what else the machine does matters little. Garbage is collected as in a session.
"""

from __future__ import annotations

import argparse
import random
import statistics
import subprocess
import sys
import threading
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import pymunk

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from devices.ports.robot import Bearing, Motion, Pose, RobotProblem
from donnie_tui.process import load_undisturbed, loaded
from language.compiler import compile_program
from language.control import ExecutionControl
from language.parser import parse
from language.runtime import Actions, Memory
from sim.robot import SimulatedRobot
from sim.scene import Scene
from sim.world import World
from sim.worldfile import load_text

ROUNDS = 31
COMMANDS = 400
COUNTS = (1, 10, 100, 1000)
PUSHED_STEPS = 20
COMPANY, THINGS_EACH = 5, 5
"""Robots that push at the same time, and the things before each."""
STAGE_RAYS = {1: 32.5, 10: 150.0, 100: 7000.0, 1000: 70_000.0}
"""What a simulated second costs in Stage by the number of robots, in rays of the public method.

The last figure is no measurement, but the least that follows from that of a hundred. What robots share costs
at most what one robot costs, a two-hundredth of a hundred, and in a larger world that is as crowded no robot
has less to do. A prototype was 1.1 times as fast as Stage with a hundred robots and 2.75 times with a
thousand: if its robots cost no less among more, Stage takes at least 2.5 times as much as this.
"""
WANTED_RAY = 4e-6
"""Seconds of a ray on the machine for which the targets are times."""
WANTED_PUSH, WANTED_SONARS, WANTED_LOADING = 4e-3, 80e-6, 0.8
"""Seconds there: a step that pushes twenty things, eight sonars, ten thousand models."""
WANDERED = {1: 2000, 10: 300, 100: 40, 1000: 5}
"""Simulated seconds, by the number of robots."""
STACK = 256 * 1024
"""Bytes of stack of each of a thousand programs' threads."""

ROBOT = (
    """
define sonar sensor ( range [ 0.02 3.0 ] fov 15 )
define tester position ( size [ 0.128 0.128 0.12 ] ranger(
"""
    + "".join(f"  sonar( pose [ 0 0 0 {45 * i} ] )\n" for i in range(8))
    + ") )\ndefine box model ( size [ 0.4 0.4 0.4 ] )\n"
)


class Freely:
    """A pace that never waits."""

    def sleep(self, seconds: float) -> bool:  # noqa: ARG002 -- the port gives it
        return True


class Listening:
    """A watcher that gets everything and does nothing."""

    def progressed(self, motion: Motion, pose: Pose) -> None: ...

    def passing(self, pose: Pose) -> None: ...

    def sense_failed(self, problem: RobotProblem) -> None: ...


def main() -> None:
    """Measure and print."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--robots", type=int, help="measure so many robots only, in this process")
    options.add_argument("--wander", type=int, help="let so many robots wander only, in this process")
    options.add_argument("--programs", type=int, help="run so many programs together only, in this process")
    asked = options.parse_args()
    if asked.robots:
        _many(asked.robots)
    elif asked.wander:
        _wander(asked.wander)
    elif asked.programs:
        _programs(asked.programs)
    else:
        _commands()
        _pushing()
        _sonars()
        _loading()
        for option, counts in (("--robots", COUNTS), ("--programs", COUNTS), ("--wander", WANDERED)):
            for count in counts:
                subprocess.run([sys.executable, __file__, option, str(count)], check=True)


# --- one command


def _commands() -> None:
    scene = _floor(1, boxes=200)
    quiet = World(scene).robot(pace=Freely())
    watched = World(scene).robot(pace=Freely(), watcher=Listening())
    together = _program(World(scene).robot(pace=Freely()))
    ray = _ray(scene)
    print("one command, against one ray that hits (public method):")
    _compare("FW 5", ray, lambda: _to_and_fro(quiet))
    _compare("FW 5, published step by step", ray, lambda: _to_and_fro(watched))
    _compare("language and simulator, FW 5", ray, together)


def _to_and_fro(robot: SimulatedRobot) -> None:
    for _ in range(COMMANDS // 2):
        robot.forward(5)
        robot.backward(5)


def _program(robot: SimulatedRobot) -> Callable[[], None]:
    """The same as a program: it runs in the language, with nothing but the robot behind the commands."""
    text = f"FOR VAR k = 1; k <= {COMMANDS // 2}; k = k + 1 DO FW 5 BW 5 END FOR"
    parsed = parse(text)
    if parsed.program is None:
        raise SystemExit(f"the program is wrong: {parsed.diagnostics}")
    runnable, actions = compile_program(parsed.program, terminal=False, hooked=False), _Commands(robot)  # type: ignore[abstract]
    return lambda: runnable.run(actions, ExecutionControl(), Memory())


class _Commands(Actions):
    """Commands that go straight to the robot."""

    def __init__(self, robot: SimulatedRobot) -> None:
        self._robot = robot

    def forward(self, steps: int, command: str) -> None:  # noqa: ARG002 -- for the history
        self._robot.forward(steps)

    def backward(self, steps: int, command: str) -> None:  # noqa: ARG002 -- for the history
        self._robot.backward(steps)


def _ray(scene: Scene) -> Callable[[], None]:
    space, everything = pymunk.Space(), pymunk.ShapeFilter()
    for model in scene.models:
        if model.kind == "box":
            space.add(*(pymunk.Poly(space.static_body, points) for points in model.outlines()))
    start, end = (0.0, 0.0), _an_end_that_is_hit(space)

    def ask() -> None:
        for _ in range(COMMANDS):
            space.segment_query_first(start, end, 0.0, everything)

    return ask


def _seconds_of_a_ray(ask: Callable[[], None]) -> float:
    return statistics.median(_seconds(ask) for _ in range(ROUNDS)) / COMMANDS


def _an_end_that_is_hit(space: pymunk.Space) -> tuple[float, float]:
    ends = ((x, y) for x in (5.0, 4.0, 3.0, -3.0, -4.0, -5.0) for y in (5.0, 3.0, -3.0, -5.0))
    return next(end for end in ends if space.segment_query_first((0, 0), end, 0.0, pymunk.ShapeFilter()))


def _compare(what: str, base: Callable[[], None], work: Callable[[], None]) -> None:
    ratios, times, rays = [], [], []
    for _ in range(ROUNDS):
        rays.append(_seconds(base))
        times.append(_seconds(work))
        ratios.append(times[-1] / rays[-1])
    low, middle, high = statistics.quantiles(ratios, n=4)
    ray, command = (statistics.median(each) / COMMANDS * 1e6 for each in (rays, times))
    print(f"  {what}: {middle:.2f} ({low:.2f} to {high:.2f}); {command:.1f} us, a ray {ray:.1f} us")


def _seconds(work: Callable[[], None]) -> float:
    began = time.process_time()
    work()
    return time.process_time() - began


# --- pushing


def _pushing() -> None:
    """A row of things, each of which pushes the next one: looked at anew in every tick."""
    for count in (1, 5, 20):
        robot = World(load_text(_rows(1, count), Path("row.world"))).robot(pace=Freely())
        robot.forward(PUSHED_STEPS + 3 * count)  # until all move
        began = time.process_time()
        pushed = robot.forward(PUSHED_STEPS).pushed
        took = (time.process_time() - began) / PUSHED_STEPS
        wanted = f", {_compared(took, WANTED_PUSH)}" if len(pushed) == 20 else ""
        print(f"pushing {len(pushed)} things: {took * 1e3:.1f} ms a step{wanted}")
    _pushing_in_company()


def _pushing_in_company() -> None:
    """Robots with a program each, and a row of things before each: they push together, tick by tick."""
    world = World(load_text(_rows(COMPANY, THINGS_EACH), Path("rows.world")))
    robots = [world.robot(name, pace=Freely()) for name in _names(world.scene)]
    took = 0.0
    for steps in (3 * THINGS_EACH, PUSHED_STEPS):  # until all move, then measured
        world.expect(_names(world.scene))
        threads = [threading.Thread(target=_push, args=(robot, steps)) for robot in robots]
        began = time.process_time()
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        took = time.process_time() - began
    print(
        f"pushing in company, {COMPANY} robots with {THINGS_EACH} things each:"
        f" {took / PUSHED_STEPS / COMPANY * 1e3:.1f} ms a robot and step"
    )


def _push(robot: SimulatedRobot, steps: int) -> None:
    robot.join()
    try:
        robot.forward(steps)
    finally:
        robot.leave()


def _sonars() -> None:
    """Eight readings of one robot among 60 boxes."""
    robot = World(_floor(1, boxes=60)).robot(pace=Freely())
    robot.forward(1)
    bearings = (*Bearing, Bearing.FRONT, Bearing.BACK)

    def read() -> None:
        for _ in range(COMMANDS):
            for bearing in bearings:
                robot.distance(bearing)

    took = statistics.median(_seconds(read) for _ in range(ROUNDS)) / COMMANDS
    walked = []
    for place in range(ROUNDS * 20):  # from a new place each time
        if robot.forward(1).walked == 0 or place % 9 == 8:
            robot.turn(45)
        began = time.process_time()
        for bearing in bearings:
            robot.distance(bearing)
        walked.append(time.process_time() - began)
    there = statistics.mean(walked)
    print(
        f"{len(bearings)} sonars: {took * 1e6:.0f} us, {_compared(took, WANTED_SONARS)};"
        f" after each step of a walk {there * 1e6:.0f} us, {_compared(there, WANTED_SONARS)}"
    )


def _loading() -> None:
    """Ten thousand models: a hundred rows of a hundred, as a macro makes them."""
    boxes = "".join(f"box( pose [ {x / 2} 0 0 0 ] )\n" for x in range(99))
    rows = "".join(f"row( pose [ 0 {1 + y / 2} 0 0 ] )\n" for y in range(100))
    text = f"{ROBOT}define row model ( size [ .01 .01 .01 ] {boxes} )\n{rows}tester( pose [ -1 -1 0 0 ] )\n"
    began = time.process_time()
    scene = load_text(text, Path("rows.world"))
    loaded = time.process_time() - began
    World(scene).robot(pace=Freely()).forward(1)
    walked = time.process_time() - began
    print(
        f"{len(scene.models)} models: loaded in {loaded:.2f} s of processor time,"
        f" {_compared(loaded, WANTED_LOADING)}; {walked:.2f} s to the end of a step,"
        f" {_compared(walked, WANTED_LOADING)}"
    )


def _compared(seconds: float, wanted: float) -> str:
    """``wanted``: seconds on a machine with rays of ``WANTED_RAY``."""
    ray = _seconds_of_a_ray(_ray(_floor(1, boxes=60)))
    times = wanted / WANTED_RAY * ray / seconds
    return f"{seconds / ray:.0f} rays of {ray * 1e6:.1f} us, {times:.1f} times as fast as wanted"


def _rows(robots: int, things: int) -> str:
    """Robots half a metre apart, each before things of two steps with gaps of a step."""
    lines = [ROBOT]
    for number in range(robots):
        y = number / 2
        lines.append(f'tester( name "r{number}" pose [ 0 {y} 0 0 ] )')
        lines += (
            f"model( size [ 0.1 0.1 0.2 ] pose [ {0.3 + 0.15 * at:.2f} {y} 0 0 ] pushable 1 )"
            for at in range(things)
        )
    return "\n".join(lines)


# --- many robots


def _many(count: int) -> None:
    """Steps of the world: in each, every robot walks a step and all its 8 rangers are read."""
    tracemalloc.start()
    scene = _floor(count, boxes=count + 60)
    world = World(scene)
    robots = [world.robot(name, pace=Freely()) for name in _names(scene)]
    kilobytes = tracemalloc.get_traced_memory()[0] / 1024
    tracemalloc.stop()
    steps = max(2, 2000 // count)
    began = time.process_time()
    for i in range(steps):
        for robot in robots:
            _act(robot, i)
    took = time.process_time() - began
    print(
        f"{count} robots: {steps / took:.1f} steps of all a second,"
        f" {took / steps / count * 1e6:.0f} us a robot and step,"
        f" {kilobytes / count:.0f} kB of Python's memory a robot"
    )


def _programs(count: int) -> None:
    """The same robots, each with a program in a thread of its own, in the world's order."""
    scene = _floor(count, boxes=count + 60)
    world = World(scene)
    robots = [world.robot(name, pace=Freely()) for name in _names(scene)]
    threading.stack_size(STACK)
    threads = [threading.Thread(target=_run, args=(robot,)) for robot in robots]
    world.expect(_names(scene))
    began, began_cpu = time.perf_counter(), time.process_time()
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    took, cpu = time.perf_counter() - began, time.process_time() - began_cpu
    seconds = max(robot.time() for robot in robots)
    print(
        f"{count} programs: {seconds:.0f} s of robot time in {took:.2f} s, {cpu:.2f} s of processor time:"
        f" {cpu / seconds / count * 1e6:.0f} us a robot and second"
    )


def _run(robot: SimulatedRobot) -> None:
    robot.join()
    try:
        for i in range(5):
            _act(robot, i)
    finally:
        robot.leave()


def _wander(count: int) -> None:
    """Each program reads three sensors, walks a step, and turns where there is something ahead."""
    load_undisturbed()
    scene = _floor(count, boxes=60 + count)
    world, ask = World(scene), _ray(scene)
    robots = [world.robot(name, pace=Freely()) for name in _names(scene)]
    threading.stack_size(STACK)
    loaded()
    for until in (2.0, 2.0 + WANDERED[count]):
        world.expect(_names(scene))
        threads = [threading.Thread(target=_wandering, args=(robot, until)) for robot in robots]
        before, began = robots[0].time(), time.process_time()
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        took = time.process_time() - began
    second = took / (robots[0].time() - before)
    ray = _seconds_of_a_ray(ask)
    at_least, ratio = "at least " if count == max(STAGE_RAYS) else "", STAGE_RAYS[count] * ray / second
    print(
        f"{count} wandering: {second * 1e3:.3f} ms of processor time a simulated second, {second / ray:.0f}"
        f" rays of {ray * 1e6:.1f} us, {at_least}{ratio:.2f} times as fast as Stage"
    )


def _wandering(robot: SimulatedRobot, until: float) -> None:
    robot.join()
    try:
        while robot.time() < until:
            left, ahead, right = (robot.distance(each) for each in _LOOKS)
            if ahead >= _NEAR and robot.forward(1).walked:
                continue
            if robot.turn(45 if right > left else -45).turned == 0:
                robot.wait(1.0)
    finally:
        robot.leave()


_LOOKS = (Bearing.FRONT_LEFT, Bearing.FRONT, Bearing.FRONT_RIGHT)
_NEAR = 5
"""Steps."""


def _act(robot: SimulatedRobot, i: int) -> None:
    if robot.forward(1).walked == 0:
        robot.turn(45 + 45 * (i % 2))
    for bearing in Bearing:
        robot.distance(bearing)


# --- worlds


def _names(scene: Scene) -> list[str]:
    return list(scene.robot_names)


def _floor(robots: int, boxes: int) -> Scene:
    """Robots and boxes in the cells of a grid with a metre of room each, the robots in every other one."""
    chance = random.Random(1)
    side = int((robots + boxes) ** 0.5) + 1
    lines: list[str] = []
    for cell in range(robots + boxes):
        x, y = cell % side - side // 2, cell // side - side // 2
        if cell < 2 * min(robots, boxes) and cell % 2 == 0:
            lines.append(f'tester( name "r{len(lines)}" pose [ {x} {y} 0 {chance.randrange(360)} ] )')
        else:
            lines.append(f"box( pose [ {x + chance.uniform(-0.2, 0.2):.3f} {y} 0 {chance.randrange(90)} ] )")
    return load_text(ROBOT + "\n".join(lines), Path("floor.world"))


if __name__ == "__main__":
    main()
