"""A scene whose things have moved from the places in its file."""

from __future__ import annotations

from pathlib import Path

import pytest

import worlds
from sim.geometry import Placement
from sim.scene import moved
from sim.worldfile import load_world


def test_an_attached_part_moves_along_and_the_rest_stays() -> None:
    scene = load_world(Path(worlds.path("two_robots")))
    alice = scene.robots[0]
    before = scene.models[alice].pose
    there = Placement(before.x + 1.0, before.y, before.z, before.yaw + 90.0)
    after = moved(scene, {alice: there})
    for model, now in zip(scene.models, after.models, strict=True):
        distance_before = (model.pose.x - before.x) ** 2 + (model.pose.y - before.y) ** 2
        distance_now = (now.pose.x - there.x) ** 2 + (now.pose.y - there.y) ** 2
        if model.root == alice:
            assert distance_now == pytest.approx(distance_before)
            assert now.pose.yaw == pytest.approx(model.pose.yaw + 90.0)
            assert now.pose.z == pytest.approx(model.pose.z)
        else:
            assert now == model


def test_a_scene_without_moves_is_the_same_object() -> None:
    scene = load_world(Path(worlds.path("living_room")))
    assert moved(scene, {}) is scene
