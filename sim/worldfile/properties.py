"""The properties that a world file may set: which have an effect here, which are only read, their types."""

from __future__ import annotations

from difflib import get_close_matches


def _named(kind: str, names: str) -> dict[str, str]:
    return dict.fromkeys(names.split(), kind)


SIMULATED = {
    **_named("tuple", "pose origin size color_rgba range colors point z paddle_size paddle_state noise"),
    **_named("tuple", "odom_error velocity_bounds acceleration_bounds localization_origin bpose image"),
    **_named("number", "obstacle_return ranger_return blob_return fiducial_return gripper_return boundary"),
    **_named("number", "fov samples colors_count points fiducial_key pushable mass ignore_zloc pan"),
    **_named("number", "range_min range_max range_max_id range_noise range_noise_const angle_noise"),
    **_named("number", "wheelbase bcount blength autosnatch"),
    **_named("string", "name color bitmap unit_length unit_angle drive localization"),
}
"""What has an effect here, and its type."""

QUIET = {
    **_named("number", "gui_nose gui_grid gui_move gui_outline alwayson update_interval trail_length"),
    **_named("number", "trail_interval debug map_resolution stack_children rebuild"),
    **_named("string", "ctrl"),
}
"""What changes nothing that a learner could notice: read and kept, no remark."""

UNUSED = {
    **_named("tuple", "velocity resolution pantilt rotate center watts_size provides requires axis"),
    **_named("number", "scale interval interval_sim interval_real paused speedup quit_time"),
    **_named("number", "object_return friction threads show_data show_follow"),
    **_named("number", "show_clock show_clock_interval show_flags show_blocks show_bboxerr show_grid"),
    **_named("number", "show_trails show_occupancy pcam_on energy_capacity joules joules_capacity"),
    **_named("number", "watts watts_give watts_take kjoules max_speed max_position min_position"),
    **_named("number", "start_position enabled break_beam period dutycycle sticky_return"),
    **_named("number", "laser_return audio channel_count"),
    **_named("string", "type plugin worldfile model alarm say texture mesh"),
}
"""What Stage knows and this simulator does not use: read, kept, told in the load report."""

_TWO_TYPES = {
    "range": ("number", "tuple"),
    "fov": ("number", "tuple"),
    "resolution": ("number", "tuple"),
    "type": ("number", "string"),
    "paddle_state": ("string", "tuple"),
}
_KNOWN = SIMULATED | QUIET | UNUSED


def types_of(name: str) -> tuple[str, ...]:
    """The types that the property may have; empty where it is unknown."""
    if name in _TWO_TYPES:
        return _TWO_TYPES[name]
    return (_KNOWN[name],) if name in _KNOWN else ()


def nearest_property(name: str) -> str:
    """The known property that was probably meant, or an empty string."""
    return next(iter(get_close_matches(name, _KNOWN, 1, 0.75)), "") if len(name) < 40 else ""
